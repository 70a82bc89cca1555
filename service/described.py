"""Calls that FastAPI describes and does not make: it reads their types, for seconds, when the OpenAPI document is asked for."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping
from dataclasses import fields
from inspect import Parameter, Signature, cleandoc
from typing import Annotated, Any, Final, NamedTuple, get_type_hints

from fastapi import FastAPI, Query
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from solver.fields import Says

Responses = Mapping[int | str, dict[str, Any]]
Answering = Callable[[Request], Awaitable[Response]]
NEEDED: Final = Parameter.empty
"""In place of a default: what has none."""


class _Declared(NamedTuple):
    method: str
    path: str
    answering: Answering
    takes: Mapping[str, Any]
    described: dict[str, Any]


class DescribedCalls:
    """Calls of one kind: the prefix of their paths, and what the document says of all of them, as FastAPI takes it."""

    def __init__(self, prefix: str = "", *, responses: Responses) -> None:
        self._prefix, self._responses = prefix, responses
        self._declared: list[_Declared] = []

    def call(self, method: str, path: str, answers: Any = None, **described: Any) -> Callable[[Answering], Answering]:
        """Declares a call by what answers it: its name and its docstring are the call's.

        `answers` is the type of the answer's document, where it is one; `takes` are the types of what it takes, by name, those that need
        not be there with their default; all else is as `FastAPI.add_api_route` takes it.
        """
        takes = described.pop("takes", {})

        def declare(answering: Answering) -> Answering:
            said = {"name": answering.__name__, "description": cleandoc(answering.__doc__ or ""), "response_model": answers, **described}
            said["responses"] = {**self._responses, **described.get("responses", {})}
            self._declared.append(_Declared(method, path, answering, takes, said))
            return answering

        return declare

    def routes(self) -> list[Route]:
        """Returns what answers the calls."""
        made = [Route(self._prefix + one.path, one.answering, name=one.described["name"]) for one in self._declared]
        for route, one in zip(made, self._declared, strict=True):
            route.methods = {one.method}  # HEAD is the guard's
        return made

    def describe(self, app: FastAPI) -> None:
        """Has FastAPI describe the calls."""
        for one in self._declared:
            app.add_api_route(self._prefix + one.path, _function_of(one.takes), methods=[one.method], **one.described)


def query_types(record: type[Any]) -> dict[str, tuple[Any, Any]]:
    """Returns what a call takes that is asked in its query by the fields of a record; each has a default."""
    types = get_type_hints(record, include_extras=True)
    return {part.name: (_query_type(types[part.name]), part.default) for part in fields(record)}


def _query_type(of: Any) -> Any:
    says = next((part.words for part in of.__metadata__ if isinstance(part, Says)), None)
    return Annotated[of, Query(description=says)]


def _function_of(takes: Mapping[str, Any]) -> Callable[..., Any]:
    """Returns a function that FastAPI reads as one with these parameters."""

    def call(**_: object) -> None: ...

    pairs = {name: taken if isinstance(taken, tuple) else (taken, NEEDED) for name, taken in takes.items()}
    parameters = [Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=of) for name, (of, default) in pairs.items()]
    call.__signature__ = Signature(parameters)  # type: ignore[attr-defined]
    return call
