"""Scenes -> their text; as JSON at once, without the document between, which costs more than the text.

Comes in: a scene. Goes out: bytes. May import: the ground floor. The fields' types say how values are written, as in writer.py.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from json.encoder import encode_basestring as quoted
from typing import Any, Final, NamedTuple

from solver.body_rows import BODY_WALLS, DecorationRows, FurnitureRows, Look, furniture_ids
from solver.exchange import json_text
from solver.exchange.text import dump_plain
from solver.exchange.writer import shape_of, write, write_degrees, write_number, write_scene, write_text
from solver.fields import EXTRA, LATER
from solver.plain import Wrong, plain
from solver.scene import Furniture, Opening, Scene

MOST_TEXTS: Final = 4096
"""Texts whose JSON is kept."""
MOST_LENGTHS: Final = 1 << 14
"""Lengths whose JSON is kept: 8 m of half millimetres."""


def dump_scene(scene: Scene, format: str) -> bytes:
    """Returns a scene's document as text of a format.

    Raises:
        SceneError: the scene holds something that no format can say, such as a number that is not finite.
    """
    if format == "json":
        try:
            return f"{_record(scene)}\n".encode()
        except (Wrong, TypeError, ValueError):  # the document's writer says where
            pass
    return dump_plain(write_scene(scene), format)


class _Layout(NamedTuple):
    """How a class of records is written: its text with a gap for each value, what fills them, and what fetches the values."""

    text: str
    writers: Sequence[Callable[[Any], str]]
    values: Callable[[Any], tuple[Any, ...]]


@lru_cache
def _layout(of: type[Any]) -> _Layout:
    shape = shape_of(of)  # type: ignore[arg-type] # classes are hashable
    writers = {name: _WRITERS.get(writer, _any) for name, writer in shape.writers.items()}
    gaps = ["%s" if name in shape.omitted else f',"{name}":%s' for name in shape.names]
    filled = tuple(_unless_none(name, writer) if name in shape.omitted else writer for name, writer in writers.items())
    return _Layout("{" + "".join(gaps)[1:] + "}", filled, shape.values)


def _unless_none(name: str, writer: Callable[[Any], str]) -> Callable[[Any], str]:
    return lambda value: "" if value is None else f',"{name}":{writer(value)}'


def _record(record: Any) -> str:
    if getattr(record, EXTRA, None):
        return json_text.dump(write(record)).rstrip()
    text, writers, values = _layout(record.__class__)
    if LATER in record.__dict__:
        told, record = record.__dict__, object.__new__(record.__class__)
        record.__dict__.update(told | told[LATER])  # `_any` writes what makes the bodies
    return text % tuple([writer(value) for writer, value in zip(writers, values(record), strict=True)])


def _any(value: Any) -> str:
    known = _BY_CLASS.get(value.__class__)
    if known is not None:
        return known(value)
    if hasattr(value.__class__, "__dataclass_fields__"):
        return _record(value)
    return _items(value) if isinstance(value, tuple) else json_text.dump(plain(value)).rstrip()


def _items(values: Iterable[Any]) -> str:
    return f"[{','.join(map(_any, values))}]"


def _pieces(pieces: FurnitureRows) -> str:
    """Writes furniture that is told as rows."""
    before, half, parts, looks = _TEXTS[pieces.room.id][:-1], _HALF_MM, [], [_FRAGMENTS[look] for look in pieces.looks]
    ids = [f'{before}/{look.name}_{row[6]}"' for look, row in zip(looks, pieces.rows, strict=True)] + ["null"]
    for name, look, color, (_, on, under, wall, rotation, _, _, _, x0, z0, x1, z1, low, *_) in zip(
        ids, looks, pieces.colours, pieces.rows, strict=False
    ):
        parts.append(
            f'{{"id":{name},{look.named}"category":{look.category},"x":{half[x0 + x1]},"y":{half[2 * low]},"z":{half[z0 + z1]},'
            f'"rotation":{rotation},{look.size},"color":{_TEXTS[color]},"wall":{_WALLS[wall]},"under":{ids[under]},"on":{ids[on]},'
            f'"locked":false{look.kind}}}'
        )
    return f"[{','.join(parts)}]"


def _things(things: DecorationRows) -> str:
    """Writes decorations that are told as rows."""
    before, half, parts = _TEXTS[things.room.id][:-1], _HALF_MM, []
    ids, colours = [*map(quoted, furniture_ids(things.room))], map(_TEXTS.__getitem__, things.colours)
    for of, color, (_, parent, _, wall, rotation, _, number, _, x0, z0, x1, z1, low, *_) in zip(
        things.looks, colours, things.rows, strict=True
    ):
        look = _FRAGMENTS[of]
        ids.append(name := f'{before}/{look.name}_{number}"')
        parts.append(
            f'{{"id":{name},{look.named}"parent":{ids[parent] if parent >= 0 else "null"},"mounted_on_wall":{_WALLS[wall]},'
            f'"x":{half[x0 + x1]},"y":{half[2 * low]},"z":{half[z0 + z1]},"rotation":{rotation},{look.size},"color":{color}{look.kind}}}'
        )
    return f"[{','.join(parts)}]"


class _HalfMillimetres(dict[int, str]):
    """Metres as JSON, by their half millimetres; those that are met often are kept."""

    def __missing__(self, length: int) -> str:
        if len(self) >= MOST_LENGTHS:
            self.clear()
        text = self[length] = repr(length / 2000)
        return text


class _Fragment(NamedTuple):
    """What is written of all bodies that look alike: the name within an id, and the keys of name, size and kind; the category."""

    name: str
    named: str
    size: str
    kind: str
    category: str


class _Fragments(dict[Look, _Fragment]):
    """What is written of all bodies that look alike."""

    def __missing__(self, look: Look) -> _Fragment:
        if len(self) >= MOST_TEXTS:
            self.clear()
        width, depth, height = map(_number, look.size)
        name, kind = quoted(look.name), _unless_none("kind", _TEXTS.__getitem__)(look.kind)
        size = f'"width":{width},"depth":{depth},"height":{height}'
        found = self[look] = _Fragment(name[1:-1], f'"name":{name},', size, kind, _TEXTS[look.category])
        return found


def _number(value: Any) -> str:
    if value.__class__ is float:
        return repr(value + 0.0) if value - value == 0.0 else repr(plain(value))
    return "null" if value is None else repr(write_number(value))


def _degrees(value: Any) -> str:
    return "null" if value is None else repr(write_degrees(value))


def _whole(value: Any) -> str:
    return "null" if value is None else repr(int(value))


class _Texts(dict[Any, str]):
    """Texts as JSON; those that are met often are kept."""

    def __missing__(self, value: Any) -> str:
        if value is not None and value.__class__ is not str:
            return _any(value)
        if len(self) >= MOST_TEXTS:
            self.clear()
        text = self[value] = "null" if value is None else quoted(value)
        return text


_TEXTS: Final = _Texts()
_FRAGMENTS: Final = _Fragments()
_HALF_MM: Final = _HalfMillimetres()
_BY_CLASS: Final[dict[type[Any], Callable[[Any], str]]] = {
    type(None): lambda _: "null", bool: {False: "false", True: "true"}.__getitem__, int: repr, float: _number, tuple: _items,
    Furniture: _record, Opening: _record, FurnitureRows: _pieces, DecorationRows: _things,
}  # fmt: skip
_WRITERS: Final[dict[Callable[[Any], Any], Callable[[Any], str]]] = {
    write_number: _number, write_degrees: _degrees, write_text: _TEXTS.__getitem__, int: _whole,
}  # fmt: skip
"""What writes as text what a function of the document's writer writes."""
_WALLS: Final = [_TEXTS[wall] for wall in BODY_WALLS]
