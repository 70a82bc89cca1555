"""Documents of plain values -> objects, checked field by field against the types that declare them; refused in words.

Not here: text (text.py), rules between bodies (validate).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from itertools import islice
from numbers import Number
from typing import Annotated, Any, Final, TypeVar

from pydantic import TypeAdapter, ValidationError
from pydantic_core import core_schema

from catalogs.misfits import called, reader_of, schema_of, told
from solver.errors import MOST_TOLD, FieldError, RequestError, SceneError
from solver.exchange.identity import check_outlines, identified, indexed
from solver.exchange.told_keys import tell_keys
from solver.fields import Record, Says, located
from solver.foreign_plans import FOREIGN_DOCUMENTS
from solver.plain import Wrong, path
from solver.request import Request
from solver.scene import FORMAT, Room, Scene

Read = TypeVar("Read")
A_SCENE: Final = "a scene; `compose import` and POST /import make one of a plan"
DIALECT: Final = "https://json-schema.org/draft/2020-12/schema"


class _Completed:
    """Scenes as they come: rooms are numbered and everything gets an id where it has none; outlines are checked."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Callable[[Any], Any]) -> Any:
        read = core_schema.no_info_before_validator_function(_indexed, handler(source))
        return core_schema.no_info_after_validator_function(_complete, read)


class _Alone:
    """A room of its own as it comes: read as the one room of a scene."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Callable[[Any], Any]) -> Any:
        def completed(room: Room) -> Room:
            return _complete(Scene(rooms=(room,)), len(("rooms", 0))).rooms[0]

        return core_schema.no_info_after_validator_function(completed, handler(source))


SentScene = Annotated[Scene, _Completed(), Says("a scene, as GET /schema describes it")]
SentRoom = Annotated[Room, _Alone(), Says("a room of a scene, as GET /schema describes it")]


def read(of: type[Read], document: object, root: str = "body", error: type[FieldError] = FieldError) -> Read:
    """Reads a document as a type that `solver.fields` describes.

    Args:
        of: the type.
        document: plain values.
        root: what the document is called where it is wrong as a whole.
        error: the error to raise.

    Raises:
        FieldError: fields are wrong; names them as paths, with what is allowed.
    """
    reader: TypeAdapter[Read] = reader_of(of)  # type: ignore[arg-type]
    try:
        made = reader.validate_python(document)
    except ValidationError as wrong:
        (field, problem, allowed), *more = refusals(wrong, schema_of(of), document)  # type: ignore[arg-type]
        raise error(field or root, problem, allowed, tuple(more)) from None
    return made


def read_scene(document: object) -> Scene:
    """Reads a scene document (compose-scene/1), forgivingly.

    Only a room's width and depth and a piece's name, x, z, width, depth and height are required; ids that are absent are
    made up, the same ones each time; unknown keys are kept.

    Raises:
        SceneError: a field is wrong; names it as a path, with what is allowed.
    """
    return read(SentScene, document, "scene", SceneError)


def read_request(document: object, root: str = "request") -> Request:
    """Reads a request. Keys may be snake_case or camelCase; unknown ones are refused.

    A plain request's `min_room_size` that is not given is at most the house's shorter side. `root` is what the document is called where it
    is wrong as a whole.

    Raises:
        RequestError: a field is wrong; names it, with what is allowed.
    """
    request = read(Request, document, root, RequestError)
    shorter = min(request.extents)
    if request.planned or request.min_room_size <= shorter:
        return request
    given = isinstance(document, Mapping) and not {"min_room_size", "minRoomSize"}.isdisjoint(document)
    if not given:
        return replace(request, min_room_size=shorter)
    house = "{:g} x {:g} m".format(*request.extents)
    raise RequestError("min_room_size", f"is {request.min_room_size:g} m, larger than the house ({house})", f"1.5 to {shorter:g} here")


def checked_request(request: Request) -> Request:
    """Returns a request that was made in Python as it would have been read, numbers of the kinds that its types say.

    Raises:
        RequestError: a field is wrong; names it, with what is allowed.
    """
    if not isinstance(request, Request):
        raise RequestError("request", f"is {called(request)}", "a Request")
    return read(Request, {part.name: _as_python(getattr(request, part.name)) for part in fields(request)}, "request", RequestError)


def scene_schema() -> dict[str, Any]:
    """Returns the JSON Schema (2020-12) of a scene document: what `read_scene` asks for, unknown keys welcome."""
    schema = reader_of(Scene).json_schema()
    tell_keys({"Scene": schema, **schema["$defs"]}, Record)
    return {"$schema": DIALECT, **schema, "title": FORMAT}


def _as_python(value: Any) -> Any:
    """Returns an array library's number as Python's own."""
    return value.item() if isinstance(value, Number) and hasattr(value, "item") else value


def _indexed(document: object) -> object:
    """Numbers the rooms of a scene's document; what is a plan of another program is told to be one, as no key of a scene is required."""
    if format := next((name for name, is_it in FOREIGN_DOCUMENTS.items() if is_it(document)), None):
        raise located(f"is a floor plan of the format {format}", A_SCENE)
    return indexed(document)


def _complete(scene: Scene, depth: int = 0) -> Scene:
    """Completes a scene; what is wrong is named from that deep inside it."""
    try:
        check_outlines(scene)
        return identified(scene)
    except Wrong as wrong:
        raise located(wrong.problem, wrong.allowed, wrong.way[depth:]) from None


MOST_FOUND: Final = 100
"""Faults that those are chosen from: a field may have several."""


def refusals(error: ValidationError, schema: Mapping[str, Any], document: object) -> list[tuple[str, str, str]]:
    """Returns the field, what is wrong with it, and what is allowed by the schema, of the first MOST_TOLD fields that are wrong."""
    told: dict[str, tuple[str, str, str]] = {}
    for one in islice(error.errors(include_url=False), MOST_FOUND):
        entry = _refusal(one, schema, document)
        told.setdefault(entry[0], entry)
    around = {field for field in told if any(other.startswith((f"{field}[", f"{field}.")) for other in told)}
    return [entry for field, entry in told.items() if field not in around][:MOST_TOLD]


def _refusal(first: Mapping[str, Any], schema: Mapping[str, Any], document: object) -> tuple[str, str, str]:
    found = told(first, schema)
    is_null = first["type"] == "missing" and _is_null(document, found.at)
    return path(found.at), "is null" if is_null else found.problem, found.allowed


def _is_null(document: object, way: Sequence[str | int]) -> bool:
    for step in way[:-1]:
        document = _inside(document, step)
    return isinstance(document, Mapping) and way[-1] in document


def _inside(document: object, step: str | int) -> object:
    if isinstance(document, Mapping):
        return document.get(step)
    return document[step] if isinstance(document, list | tuple) and isinstance(step, int) and step < len(document) else None
