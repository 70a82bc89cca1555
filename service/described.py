"""Calls that FastAPI describes and does not make: it reads their functions, for seconds, when the OpenAPI document is asked for.

Comes in: functions that declare what a call takes and answers, and what answers it. Goes out: routes, and a router for the document.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any, NamedTuple, TypeVar

from fastapi.routing import APIRouter
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

Declared = TypeVar("Declared", bound=Callable[..., Any])
Answering = Callable[[Request], Awaitable[Response]]


class _Declaration(NamedTuple):
    method: str
    path: str
    function: Callable[..., Any]
    described: dict[str, Any]

    @property
    def name(self) -> str:
        name: str = self.described.get("name", self.function.__name__)
        return name


class DescribedCalls:
    """Calls of one kind, declared by functions without a body.

    Args:
        answering: returns what answers the call of a name.
        prefix: of their paths.
        described: what the document says of all of them, as `APIRouter` takes it.
    """

    def __init__(self, answering: Callable[[str], Answering], prefix: str = "", **described: Any) -> None:
        self._answering, self._prefix, self._described = answering, prefix, described
        self._declared: list[_Declaration] = []

    def post(self, path: str, **described: Any) -> Callable[[Declared], Declared]:
        """Declares a call; what describes it is as `APIRouter.post` takes it, and so for the other methods."""
        return self._declare("POST", path, described)

    def get(self, path: str, **described: Any) -> Callable[[Declared], Declared]:
        """Declares a call."""
        return self._declare("GET", path, described)

    def put(self, path: str, **described: Any) -> Callable[[Declared], Declared]:
        """Declares a call."""
        return self._declare("PUT", path, described)

    def patch(self, path: str, **described: Any) -> Callable[[Declared], Declared]:
        """Declares a call."""
        return self._declare("PATCH", path, described)

    def delete(self, path: str, **described: Any) -> Callable[[Declared], Declared]:
        """Declares a call."""
        return self._declare("DELETE", path, described)

    def _declare(self, method: str, path: str, described: dict[str, Any]) -> Callable[[Declared], Declared]:
        def declare(function: Declared) -> Declared:
            self._declared.append(_Declaration(method, path, function, described))
            return function

        return declare

    def routes(self) -> list[Route]:
        """Returns what answers the calls."""
        made = [Route(self._prefix + one.path, self._answering(one.name), name=one.name) for one in self._declared]
        for route, one in zip(made, self._declared, strict=True):
            route.methods = {one.method}  # HEAD is the guard's
        return made

    def described(self) -> APIRouter:
        """Returns what FastAPI describes."""
        router = APIRouter(prefix=self._prefix, **self._described)
        for one in self._declared:
            router.add_api_route(one.path, one.function, methods=[one.method], **one.described)
        return router
