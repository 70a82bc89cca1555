"""`Scene` and `Request` -> documents of plain values, in the contract's key order.

Comes in: objects. Goes out: what `text.dump_text` writes and `reader` reads back to equal objects.
May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

from solver.errors import FieldError, RequestError, SceneError
from solver.exchange.fields import (
    EXTRA,
    WHOLE,
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
    keeps_extra,
    table,
)
from solver.exchange.plain import Wrong, plain
from solver.scene import Request, Scene


def write_scene(scene: Scene) -> dict[str, Any]:
    """Returns a scene's document: every key, in the contract's order, then the unknown ones that were kept.

    Raises:
        SceneError: the scene holds something that JSON cannot say, such as a number that is not finite.
    """
    return _named(SceneError, scene)


def write_request(request: Request) -> dict[str, Any]:
    """Returns a request's document, in snake_case; what `Scene.request` echoes.

    Raises:
        RequestError: the request holds something that JSON cannot say.
    """
    return _named(RequestError, request)


def _named(error: type[FieldError], record: Scene | Request) -> dict[str, Any]:
    try:
        return _record(record)
    except Wrong as wrong:
        raise error(wrong.path(), wrong.problem, wrong.allowed) from None


def _record(record: Any) -> dict[str, Any]:
    of = type(record)
    document: dict[str, Any] = {}
    for row in table(of):
        value = getattr(record, row.name)
        if value is not None or not row.omit_none:
            document[row.name] = _value(row, value)
    if keeps_extra(of):
        document.update(cast(dict[str, Any], plain(getattr(record, EXTRA))))
    return document


def _value(row: Field, value: Any) -> Any:
    if value is None:
        return None
    try:
        written = _WRITERS[type(row.shape)](row.shape, value)
    except Wrong as wrong:
        raise wrong.inside(row.name) from None
    return int(written) if row.name in WHOLE and written == int(written) else written


def _number(shape: Number, value: Any) -> Any:
    return int(value) if shape.whole else plain(float(value))


def _indexed(_: Indexed, value: Any) -> dict[str, str]:
    return {str(index): str(name) for index, name in sorted(value.items())}


def _counted(_: Counted, value: Any) -> Any:
    return plain(value) if isinstance(value, str) else {str(word): int(count) for word, count in sorted(value.items())}


def _several(shape: Several, value: Any) -> list[Any]:
    write = _WRITERS[type(shape.item)]
    written = []
    for index, item in enumerate(value):
        try:
            written.append(write(shape.item, item))
        except Wrong as wrong:
            raise wrong.inside(index) from None
    return written


def _plain(_: Shape, value: Any) -> Any:
    return plain(value)


_WRITERS: dict[type[Any], Callable[[Any, Any], Any]] = {
    Text: _plain,
    Number: _number,
    Flag: lambda _, value: bool(value),
    Free: _plain,
    Indexed: _indexed,
    Counted: _counted,
    Several: _several,
    Record: lambda _, value: _record(value),
}
