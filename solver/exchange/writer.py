"""Objects -> documents of plain values, in the key order of docs/scene.md."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import lru_cache
from numbers import Real
from operator import attrgetter, is_
from types import UnionType
from typing import Any, Final, NamedTuple, TypeVar, Union, get_args, get_origin, get_type_hints

from solver.errors import FieldError, RequestError, SceneError
from solver.fields import EXTRA, OMITTED
from solver.plain import Wrong, path, plain
from solver.records import changed
from solver.request import Request
from solver.scene import Scene

Value = TypeVar("Value")
DEGREES: Final = "rotation"
"""The key of a number that is written whole where it is whole."""
_TURN: Final = 360


def write_scene(scene: Scene) -> dict[str, Any]:
    """Returns a scene's document: every key, in the order of docs/scene.md, then the unknown ones that were kept.

    Raises:
        SceneError: the scene holds something that JSON cannot say, such as a number that is not finite.
    """
    return write(scene, SceneError)


def write_request(request: Request) -> dict[str, Any]:
    """Returns a request's document, in snake_case; what `Scene.request` echoes.

    Raises:
        RequestError: the request holds something that JSON cannot say.
    """
    document = write(request, RequestError)
    for name in ("force_types", "program"):
        if isinstance(getattr(request, name), Mapping):
            document[name] = {str(key): value for key, value in sorted(getattr(request, name).items())}
    return document


def write(record: object, error: type[FieldError] = FieldError) -> dict[str, Any]:
    """Returns the document of a dataclass.

    Raises:
        FieldError: it holds something that JSON cannot say; names the place.
    """
    try:
        return _record(record)
    except Wrong as wrong:
        raise error(path(wrong.way), wrong.problem, wrong.allowed) from None


def as_read(record: Value) -> Value:
    """Returns a record as a reader makes it, if one took it: tuples of its lists, and numbers of the kinds that its types say."""
    names, usually, writers, *_ = shape_of(record.__class__)  # type: ignore[arg-type] # classes are hashable
    told, made = record.__dict__, {}
    for name, usual in zip(names, usually, strict=True):
        value = told.get(name)
        if value is not None and value.__class__ is not usual and (differing := _as_read(value, writers[name])) is not value:
            made[name] = differing
    return changed(record, **made) if made else record


def _as_read(value: Any, writer: Callable[[Any], Any]) -> Any:
    if hasattr(value.__class__, "__dataclass_fields__"):
        return as_read(value)
    if isinstance(value, list | tuple):
        made = tuple([_as_read(one, writer) for one in value])
        return value if value.__class__ is tuple and all(map(is_, made, value)) else made
    kinds = _KINDS.get(writer)
    return kinds[0](value) if kinds and value.__class__ not in kinds and isinstance(value, Real) else value


class Shape(NamedTuple):
    """What a class of records writes.

    Its keys, and the class of most of their values; how others are written; which are left out where they are None; and what fetches
    all values at once.
    """

    names: tuple[str, ...]
    usual: tuple[type[Any] | None, ...]
    writers: Mapping[str, Callable[[Any], Any]]
    omitted: frozenset[str]
    values: Callable[[Any], tuple[Any, ...]]


@lru_cache
def shape_of(of: type[Any]) -> Shape:
    """Returns what a class of records writes."""
    hints = get_type_hints(of)
    keys = [part for part in fields(of) if part.name != EXTRA]
    writers = {key.name: _writer(key.name, hints[key.name]) for key in keys}
    usual = tuple(float if writer is write_number else str if writer is write_text else None for writer in writers.values())
    values = attrgetter(*writers) if len(keys) > 1 else lambda one: (getattr(one, keys[0].name),)
    return Shape(tuple(writers), usual, writers, frozenset(key.name for key in keys if OMITTED in key.metadata), values)


def _writer(name: str, hint: Any) -> Callable[[Any], Any]:
    """Returns what writes a value: numbers as their type says, whatever Python's number it is."""
    kinds = get_args(hint) if get_origin(hint) in (Union, UnionType) else (hint,)
    if float in kinds:
        return write_degrees if name == DEGREES else write_number
    if str in kinds:
        return write_text
    if int in kinds and bool not in kinds:
        return int
    return write_numbers if float in _entries(hint) else _any


def _entries(hint: Any) -> set[Any]:
    """Returns the types of what stands in lists of a type, however deep."""
    return set().union(*map(_entries, get_args(hint))) if get_origin(hint) in (tuple, Union, UnionType) else {hint}


def _record(record: Any) -> dict[str, Any]:
    names, usually, writers, omitted, values = shape_of(record.__class__)
    document: dict[str, Any] = {}
    name = ""
    try:
        for name, usual, value in zip(names, usually, values(record), strict=True):
            if value.__class__ is usual:
                if usual is float:
                    document[name] = value + 0.0 if value - value == 0.0 else plain(value)
                else:
                    document[name] = value if value.isascii() else plain(value)
            elif value is not None:
                document[name] = writers[name](value)
            elif name not in omitted:
                document[name] = None
    except Wrong as wrong:
        raise wrong.inside(name) from None
    extra = getattr(record, EXTRA, None)
    if extra:
        document.update(plain(extra))
    return document


def write_text(value: Any) -> Any:
    """Writes what should be a text."""
    return _any(value)


def write_number(value: Any) -> float:
    """Writes a number with a point."""
    number = float(value) + 0.0
    return number if number - number == 0.0 else plain(number)


def write_degrees(value: Any) -> float:
    """Writes a number without a point where it is whole."""
    if value.__class__ is int and -_TURN < value < _TURN:
        return int(value)
    number = write_number(value)
    return int(number) if number.is_integer() else number


def write_numbers(value: Any) -> Any:
    """Writes lists of numbers, each with a point or null."""
    if isinstance(value, list | tuple):
        return _items(value, write_numbers)
    return None if value is None else write_number(value)


def _any(value: Any) -> Any:
    if hasattr(value.__class__, "__dataclass_fields__"):
        return _record(value)
    return _items(value) if isinstance(value, list | tuple) else plain(value)


def _items(values: Iterable[Any], write: Callable[[Any], Any] = _any) -> list[Any]:
    written: list[Any] = []
    try:
        for value in values:
            written.append(write(value))
    except Wrong as wrong:
        raise wrong.inside(len(written)) from None
    return written


_KINDS: Final[Mapping[Any, tuple[Callable[[Any], Any], ...]]] = {
    int: (int,), write_number: (float,), write_numbers: (float,), write_degrees: (float, int),
}  # fmt: skip
"""The kinds of numbers that are such as a reader makes, or as good, by what writes them."""
