"""The OpenAPI document of declared calls as FastAPI makes it: it reads their types, for seconds, and is loaded when that is asked for."""

from collections.abc import Callable
from functools import cache
from inspect import Parameter, Signature
from typing import Annotated, Any, Final

from fastapi import FastAPI, Path, Query

from service.openapi import Declared, DescribedCalls
from solver.fields import Says
from solver.version import VERSION

DESCRIPTION: Final = "Lays out whole furnished homes and proves they work. JSON and YAML, in by Content-Type and out by Accept."


@cache
def described(calls: tuple[DescribedCalls, ...]) -> dict[str, Any]:
    """Returns what FastAPI describes, which is the same for every application of a process."""
    app = FastAPI(title="Compose", version=VERSION, description=DESCRIPTION)
    for declared in calls:
        for one in declared:
            app.add_api_route(one.path, _function_of(one), methods=[one.method], **one.described)
    return app.openapi()


def _function_of(declared: Declared) -> Callable[..., Any]:
    """Returns a function that FastAPI reads as one with the parameters that a call takes."""

    def call(**_: object) -> None: ...

    parameters = []
    for name, taken in declared.takes.items():
        of, default = taken if isinstance(taken, tuple) else (taken, Parameter.empty)
        parameters.append(Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=_told(of, f"{{{name}}}" in declared.path)))
    call.__signature__ = Signature(parameters)  # type: ignore[attr-defined]
    return call


def _told(of: Any, is_in_path: bool) -> Any:
    """Returns a type with what it says of itself where FastAPI looks for that."""
    says = next((part.words for part in getattr(of, "__metadata__", ()) if isinstance(part, Says)), None)
    if says is None:
        return of
    return Annotated[of, Path(description=says) if is_in_path else Query(description=says)]
