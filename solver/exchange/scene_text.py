"""Scenes -> their text, at once, without the document between, which costs more than the text.

The fields' types say how values are written, as in writer.py.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from itertools import accumulate, chain, count, pairwise
from json.encoder import encode_basestring as quoted
from operator import call
from struct import Struct, pack, unpack_from
from typing import Any, Final, NamedTuple

from solver.body_rows import BodyRows, DecorationRows, FurnitureRows, Look, furniture_ids, rows_in
from solver.exchange import json_text
from solver.exchange.text import FORMATS, dump_plain
from solver.exchange.writer import shape_of, write, write_degrees, write_number, write_numbers, write_scene, write_text
from solver.fields import EXTRA
from solver.plain import Wrong, plain
from solver.records import LATER, MadeOnce
from solver.scene import Decoration, Flooring, Furniture, Opening, Scene, Sides, WallFinish

MOST_TEXTS: Final = 4096
"""Texts whose JSON is kept."""
_TOLD: Final = "\0"
"""Stands for what rows tell until the core has written it: no JSON holds it."""
_GAPS: Final = {
    "id": 0, "on": 1, "parent": 1, "under": 2, "wall": 3, "mounted_on_wall": 3, "x": 4, "y": 5, "z": 6, "rotation": 7, "color": 8,
}  # fmt: skip
"""The keys of bodies that rows tell of each, as the core numbers them (solver/core/text/bodies.hpp)."""
_NO_GAP: Final = "9"
_HEADER: Final = Struct("<4i")
_LOOK: Final = Struct("<3q")
_PIECE: Final = Struct("<2q")
_BODIES: Final = Struct("<2iq")
_BEFORE: Final = -1
"""Instead of a number of carriers: the bodies before."""


def dump_scene(scene: Scene, format: str) -> bytes:
    """Returns a scene's document as text of a format.

    Raises:
        SceneError: the scene holds something that no format can say, such as a number that is not finite.
    """
    try:
        parts = [part.encode() for part in f"{_record(scene)}\n".split(_TOLD)]
        return FORMATS[format].of_json(b"".join(chain.from_iterable(zip(parts, [*_texts_told(scene), b""], strict=True))))
    except (Wrong, TypeError, ValueError):  # the document's writer says where
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
    return text % tuple(map(call, writers, values(record)))


def _any(value: Any) -> str:
    known = _BY_CLASS.get(value.__class__)
    if known is not None:
        return known(value)
    if hasattr(value.__class__, "__dataclass_fields__"):
        return _record(value)
    return _items(value) if isinstance(value, list | tuple) else json_text.dump(plain(value)).rstrip()


def _items(values: Iterable[Any], write: Callable[[Any], str] = _any) -> str:
    return f"[{','.join(map(write, values))}]"


def _texts_told(scene: Scene) -> Iterable[bytes]:
    """Returns the lists of bodies that are told as rows, in the order in which the scene holds them."""
    rooms = () if scene.extra else [room for room in scene.rooms if not room.extra]
    found = [rows_in(room, sort) for room in rooms for sort in (FurnitureRows, DecorationRows)]
    told = [rows for rows in found if rows is not None]
    if not told:
        return ()
    from solver.core import ask  # noqa: PLC0415 - whoever has rows has loaded it

    looks, texts = defaultdict[Look, int](count().__next__), defaultdict[str | None, int](count().__next__)  # numbers, as they come
    worn = [*map(looks.__getitem__, chain.from_iterable([one.looks for one in told]))]
    worn += map(texts.__getitem__, chain.from_iterable([one.colours for one in told]))
    rows = [_as_asked(one, before, texts) for before, one in zip([None, *told[:-1]], told, strict=True)]
    contents = [*map(_ENCODED.__getitem__, texts)]
    head = _HEADER.pack(len(looks), len(contents), len(rows), len(worn) // 2), pack(f"<{len(contents)}q", *map(len, contents))
    alike, each = map(_LOOKS.__getitem__, looks), pack(f"<{len(worn)}q", *worn)
    answer = ask("bodies_text", b"".join([*head, _padded(b"".join(contents)), *alike, each, *rows]))
    ends = accumulate(unpack_from(f"<{len(rows)}q", answer), initial=8 * len(rows))
    return [answer[start:end] for start, end in pairwise(ends)]


def _as_asked(told: BodyRows, before: BodyRows | None, texts: dict[str | None, int]) -> bytes:
    """Returns bodies as the core reads them, `before` are those that it reads before them; texts are numbered as they come."""
    carried_by_those = before is not None and rows_in(told.room, FurnitureRows) is before
    carriers = () if carried_by_those or isinstance(told, FurnitureRows) else furniture_ids(told.room)
    counts = _BODIES.pack(len(told), _BEFORE if carried_by_those else len(carriers), texts[told.room.id])
    return b"".join([counts, told.content, pack(f"<{len(carriers)}q", *map(texts.__getitem__, carriers))])


def _look_text(look: Look) -> bytes:
    """Returns what is written of all bodies that look alike, with gaps for what is not alike, as the core reads it."""
    width, depth, height = look.size
    size: dict[str, Any] = {"width": width, "depth": depth, "height": height, "kind": look.kind}
    is_furniture = look.key[0] == "furniture"
    body: Any = Furniture("", look.name, look.category, **size) if is_furniture else Decoration("", look.name, **size)
    text, writers, values = _layout(body.__class__)
    filled = zip(shape_of(body.__class__).names, writers, values(body), strict=True)
    marked = [f"{_TOLD}{_GAPS[name]}{_TOLD}" if name in _GAPS else writer(value) for name, writer, value in filled]
    parts = (text % tuple(marked)).split(_TOLD)
    pieces = [(part.encode(), int(gap)) for part, gap in zip(parts[::2], [*parts[1::2], _NO_GAP], strict=True)]
    whole, name = b"".join([part for part, _ in pieces]), quoted(look.name)[1:-1].encode()
    rows = [_PIECE.pack(len(part), gap) for part, gap in pieces]
    return b"".join([_LOOK.pack(len(rows), len(whole), len(name)), *rows, _padded(whole), _padded(name)])


def _padded(content: bytes) -> bytes:
    """Returns bytes that end at a multiple of 8."""
    return content + bytes(-len(content) % 8)


def _number(value: Any) -> str:
    if value.__class__ is float:
        return repr(value + 0.0) if value - value == 0.0 else repr(plain(value))
    return "null" if value is None else repr(write_number(value))


def _numbers(value: Any) -> str:
    return _items(value, _numbers) if isinstance(value, list | tuple) else _NUMBERS[value]


def _degrees(value: Any) -> str:
    return "null" if value is None else repr(write_degrees(value))


def _whole(value: Any) -> str:
    return "null" if value is None else repr(int(value))


class _Shared(dict[int, tuple[Any, str]]):
    """Records that rooms share as JSON, by identity."""

    def text(self, record: Any) -> str:
        """Returns what is written of one; not kept with keys of its sender's, which may be many and change."""
        if getattr(record, EXTRA, None):
            return _record(record)
        kept = self.get(id(record))
        if kept is None or kept[0] is not record:
            if len(self) >= MOST_TEXTS:
                self.clear()
            kept = self[id(record)] = record, _record(record)
        return kept[1]


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
_ENCODED: Final = MadeOnce[str | None, bytes](lambda text: _TEXTS[text].encode(), MOST_TEXTS)
_NUMBERS: Final = MadeOnce[Any, str](_number, MOST_TEXTS)
"""Numbers as JSON. Zero is zero, whatever its sign, and has a point."""
_LOOKS: Final = MadeOnce(_look_text, MOST_TEXTS)
_SHARED: Final = _Shared().text
_BY_CLASS: Final[dict[type[Any], Callable[[Any], str]]] = {
    type(None): lambda _: "null", bool: {False: "false", True: "true"}.__getitem__, int: repr, float: _number, tuple: _items,
    Furniture: _record, Opening: _record, Sides: _SHARED, Flooring: _SHARED, WallFinish: _SHARED,
    FurnitureRows: lambda _: _TOLD, DecorationRows: lambda _: _TOLD,
}  # fmt: skip
_WRITERS: Final[dict[Callable[[Any], Any], Callable[[Any], str]]] = {
    write_number: _NUMBERS.__getitem__, write_numbers: _numbers, write_degrees: _degrees, write_text: _TEXTS.__getitem__, int: _whole,
}  # fmt: skip
"""What writes as text what a function of the document's writer writes."""
