"""Documents of plain values -> `Scene` and `Request`, checked field by field.

Comes in: what a JSON or YAML text says. Goes out: objects, or an error that names the field and what is allowed.
May import: the ground floor. Not here: text (text.py), rules between bodies (validate).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, replace
from typing import Any, cast

from solver.errors import FieldError, RequestError, SceneError
from solver.exchange.fields import (
    EXTRA,
    ID,
    Counted,
    Field,
    Flag,
    Free,
    Indexed,
    Number,
    Record,
    Several,
    Shape,
    Text,
    aliases,
    camel,
    keeps_extra,
    table,
)
from solver.exchange.identity import identified, indexed
from solver.exchange.outlines import check_outline
from solver.exchange.plain import Wrong, is_text, plain
from solver.scene import Pose, Request, Room, Scene


def read_scene(document: object) -> Scene:
    """Reads a scene document (compose-scene/1), forgivingly.

    Only a room's width and depth and a piece's name, x, z, width, depth and height are required; ids that are absent are
    made up, the same ones each time; unknown keys are kept.

    Raises:
        SceneError: a field is wrong; names it as a path, with what is allowed.
    """
    return cast(Scene, _named(SceneError, "scene", lambda: identified(_record(Scene, indexed(document)))))


def read_request(document: object) -> Request:
    """Reads a request. Keys may be snake_case or camelCase; unknown ones are refused.

    A plain request's `min_room_size` that is not given is at most the house's shorter side.

    Raises:
        RequestError: a field is wrong; names it, with what is allowed.
    """
    return cast(Request, _named(RequestError, "request", lambda: _request(document)))


def read_poses(document: object) -> tuple[Pose, ...]:
    """Reads `previous` of /fix: a list of poses, each with its body's id.

    Raises:
        SceneError: a field is wrong; names it, with what is allowed.
    """

    def read() -> tuple[Pose, ...]:
        poses = _at("previous", _several, Several(Record(Pose)), document)
        for index, pose in enumerate(poses):
            if not pose.id:
                raise Wrong("is missing", "the id of a body").inside(ID).inside(index).inside("previous")
        return cast(tuple[Pose, ...], poses)

    return cast(tuple[Pose, ...], _named(SceneError, "previous", read))


def _request(document: object) -> Request:
    spelled = _spelled(Request, _mapping(document))
    request = cast(Request, _record(Request, spelled))
    shorter = min(request.extents)
    if request.planned or request.min_room_size <= shorter:
        return request
    if "min_room_size" not in spelled:
        return replace(request, min_room_size=shorter)
    raise Wrong(
        f"is {request.min_room_size:g} m, larger than the house ({request.extents[0]:g} x {request.extents[1]:g} m)",
        f"1.5 to {shorter:g} here",
    ).inside("min_room_size")


def _named(error: type[FieldError], root: str, read: Callable[[], object]) -> object:
    """Reads, and turns what was wrong into an error of the tree that names the place."""
    try:
        return read()
    except Wrong as wrong:
        raise error(wrong.path() or root, wrong.problem, wrong.allowed) from None


def _spelled(of: type[Any], document: Mapping[str, Any]) -> dict[str, Any]:
    """Spells the document's keys in snake_case; refuses a key given in both spellings."""
    known = aliases(of)
    spelled: dict[str, Any] = {}
    for key, value in document.items():
        name = known.get(key, key)
        if name in spelled:
            raise Wrong(f"is given twice, as {name} and as {camel(name)}", "one of the two spellings").inside(name)
        spelled[name] = value
    return spelled


def _mapping(value: object) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise Wrong(f"is {_called(value)}", "a mapping of keys to values")
    for key in value:
        if not is_text(key):
            raise Wrong(f"has the key {key!r}", "keys that are texts")
    return value


def _called(value: object) -> str:
    """Names a wrong value's type in the words of JSON."""
    names = {type(None): "null", bool: "a yes or no", int: "a number", float: "a number", str: "a text", list: "a list", tuple: "a list"}
    return names.get(type(value), "a mapping" if isinstance(value, Mapping) else f"a {type(value).__name__}")


def _record(of: type[Any], value: object) -> Any:
    document = _mapping(value)
    rows = table(of)
    found = {row.name: _key(row, document) for row in rows if row.name in document or row.required or row.name == ID}
    unknown = [key for key in document if key not in found]
    if keeps_extra(of):
        found[EXTRA] = {key: _at(key, plain, document[key]) for key in unknown}
    elif unknown:
        raise Wrong("is not known", ", ".join(row.name for row in rows)).inside(unknown[0])
    record = of(**found)
    if of is Room:
        check_outline(record)
    return record


def _at(step: str | int, read: Callable[..., Any], *given: Any) -> Any:
    """Reads a part of a document; what is wrong in it is named from there."""
    try:
        return read(*given)
    except Wrong as wrong:
        raise wrong.inside(step) from None


def _key(row: Field, document: Mapping[str, Any]) -> Any:
    value = document.get(row.name)
    if value is not None:
        return _at(row.name, _READERS[type(row.shape)], row.shape, value)
    if row.name == ID:
        return ""
    if row.required:
        raise Wrong("is missing" if row.name not in document else "is null", _allowed(row.shape)).inside(row.name)
    if row.nullable:
        return None
    return _default(row)


def _default(row: Field) -> Any:
    """Null where a value is due means: as if it were not there."""
    return {} if row.default is MISSING else row.default


def _text(shape: Text, value: object) -> str:
    if not is_text(value) or (shape.choices and value not in shape.choices):
        raise Wrong(f"is {value!r:.60}" if isinstance(value, str) else f"is {_called(value)}", _allowed(shape))
    return cast(str, value)


def _number(shape: Number, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Wrong(f"is {_called(value)}", _allowed(shape))
    within = shape.least <= value <= shape.most and not (shape.positive and value == 0)
    if not within or (shape.whole and value != int(value)):
        raise Wrong(f"is {value!r:.60}", _allowed(shape))
    return int(value) if shape.whole else float(value) + 0.0


def _flag(shape: Flag, value: object) -> bool:
    if not isinstance(value, bool):
        raise Wrong(f"is {_called(value)}", _allowed(shape))
    return value


def _free(_: Free, value: object) -> dict[str, Any]:
    return cast(dict[str, Any], plain(_mapping(value)))


def _indexed(shape: Indexed, value: object) -> dict[int, str]:
    if not isinstance(value, Mapping):
        raise Wrong(f"is {_called(value)}", _allowed(shape))
    found: dict[int, str] = {}
    for key, name in value.items():
        index = _index(key)
        if index in found:
            raise Wrong("is given twice", "each index once").inside(index)
        found[index] = _at(index, _text, Text(), name)
    return found


def _counted(shape: Counted, value: object) -> str | dict[str, int]:
    if isinstance(value, str) and is_text(value):
        return value
    if not isinstance(value, Mapping):
        raise Wrong(f"is {_called(value)}", _allowed(shape))
    count = Number(True, shape.least, shape.most)
    return {key: int(_at(key, _number, count, number)) for key, number in _mapping(value).items()}


def _index(key: object) -> int:
    if isinstance(key, int) and not isinstance(key, bool) and key >= 0:
        return key
    if isinstance(key, str) and key.isascii() and key.isdigit() and len(key) <= 9:
        return int(key)
    raise Wrong("is not an index", "0, 1, 2, ...").inside(str(key)[:60])


def _several(shape: Several, value: object) -> tuple[Any, ...]:
    if not isinstance(value, (list, tuple)):
        raise Wrong(f"is {_called(value)}", _allowed(shape))
    if len(value) < shape.at_least or shape.length not in (None, len(value)):
        raise Wrong(f"has {len(value)} entries", _allowed(shape))
    read = _READERS[type(shape.item)]
    return tuple(_items(read, shape.item, value))


def _items(read: Callable[..., Any], shape: Shape, values: Iterable[object]) -> Iterable[Any]:
    for index, value in enumerate(values):
        yield _at(index, read, shape, value)


def _nested(shape: Record, value: object) -> Any:
    return _record(shape.of, value)


_READERS: dict[type[Any], Callable[..., Any]] = {
    Text: _text,
    Number: _number,
    Flag: _flag,
    Free: _free,
    Indexed: _indexed,
    Counted: _counted,
    Several: _several,
    Record: _nested,
}


def _allowed(shape: Shape) -> str:
    """Says what a key may hold."""
    match shape:
        case Text():
            return ", ".join(shape.choices) or "a text"
        case Number():
            kind = "a whole number" if shape.whole else "a number"
            return f"{kind} above 0, up to {shape.most:.16g}" if shape.positive else f"{kind} from {shape.least:.16g} to {shape.most:.16g}"
        case Flag():
            return "true, false"
        case Several():
            many = f"{shape.length} entries" if shape.length else f"at least {shape.at_least} entries" if shape.at_least else "a list"
            return many if shape.length is None and not shape.at_least else f"a list of {many}"
        case Indexed():
            return "a mapping from a room's index to a room type"
        case Counted():
            return "a preset's name, or a mapping from words to whole numbers"
        case _:
            return "a mapping of keys to values"
