"""What bodies of a scene take up, and the free place nearest to a wished one, exactly.

The free places of a box are what is left of a rectangle after the obstacles, grown by the box; the nearest of them to a wish
has both coordinates among the wish's own and the edges of those, so that these are all that need to be tried.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import chain, repeat
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.body_rows import BODY, BODY_WALLS, BodyRow, DecorationRows, FurnitureRows, Look, rows_in
from solver.core import borrowed
from solver.geometry import Rect, extents, to_mm
from solver.scene import Decoration, Dynamic, Furniture, Room

FLAT_MM: Final = 20
"""Rugs and mats: what is no higher is no body, one stands on it (docs/scene.md, The rules)."""

ROUNDED_MM: Final = 1e-3
"""Scenes are read to the micrometre."""

RECT: Final = Struct("<4q")
_NEAREST: Final = Struct("<9q2i")
_new: Final = tuple.__new__
"""What a named tuple's own constructor calls, in half its time: a room has fifty bodies."""


class Block(NamedTuple):
    """What takes up space: a rectangle from `low` to `high`, mm, and the id of whose it is."""

    rect: Rect
    low: float
    high: float
    id: str = ""

    def between(self, low: float, high: float) -> bool:
        """Tells whether it takes up any of some heights."""
        return self.low < high and low < self.high


def footprint(body: Furniture | Decoration | Dynamic) -> Rect:
    """Returns the bounding rectangle of a body, mm, rounded outwards by less than a millimetre."""
    (width, depth), x, z = extents(body.width, body.depth, body.rotation), body.x, body.z
    return Rect(
        math.floor((x - width / 2) * 1000 + 1e-6), math.floor((z - depth / 2) * 1000 + 1e-6),
        math.ceil((x + width / 2) * 1000 - 1e-6), math.ceil((z + depth / 2) * 1000 - 1e-6),
    )  # fmt: skip


def rounded_mm(body: Furniture | Decoration) -> int:
    """Returns what an edge of a body's footprint is rounded by at most, mm: 0, or 1 where it stands between whole millimetres."""
    rect, (width, depth) = footprint(body), extents(body.width, body.depth, body.rotation)
    return int(rect.width - width * 1000 > ROUNDED_MM or rect.depth - depth * 1000 > ROUNDED_MM)


class PlacedBody(NamedTuple):
    """A body of a room as whoever measures floor reads it.

    Args:
        block: the space it takes up.
        key: what its kind is looked up by: sort, name, width, depth and height, m, the kind that the scene names.
        rotation: degrees.
        y: of its underside, m.
        under: the number of the furniture that it is tucked under; -1: none.
        rests: furniture that stands on a piece; a small thing that is not loose on the floor.
    """

    block: Block
    key: tuple[str, str, float, float, float, str | None]
    rotation: float
    y: float
    under: int
    rests: bool


def furniture_in(room: Room) -> list[PlacedBody]:
    """Returns a room's furniture."""
    if (rows := rows_in(room, FurnitureRows)) is not None:
        return [_as_told(*one) for one in zip(rows.ids, rows.looks, rows.rows, strict=True)]
    numbers = {piece.id: k for k, piece in enumerate(room.furniture)}
    keyed = ((one, ("furniture", one.name, one.width, one.depth, one.height, one.kind)) for one in room.furniture)
    return [PlacedBody(block_of(one), key, one.rotation, one.y, numbers.get(one.under or "", -1), one.on is not None) for one, key in keyed]


def furniture_as_told(room: Room) -> bytes:
    """Returns a room's furniture as rows: the core's; where it was told one by one such rows, of no kind, 0 for any that it rests on."""
    if (rows := rows_in(room, FurnitureRows)) is not None:
        return rows.content
    return b"".join([
        BODY.pack(0, one.rests - 1, one.under, -1, 0, 0, 0, 0, *one.block.rect, to_mm(one.y), *map(to_mm, one.key[2:5]))
        for one in furniture_in(room)
    ])  # fmt: skip


def is_told(room: Room) -> bool:
    """Tells whether all furniture and small things of a room are told as rows."""
    return rows_in(room, FurnitureRows) is not None and (rows_in(room, DecorationRows) is not None or not room.decorations)


def bodies_told(room: Room) -> tuple[bytes, bytes]:
    """Returns the rows of such a room's furniture and small things: the core's."""
    pieces, things = rows_in(room, FurnitureRows), rows_in(room, DecorationRows)
    return pieces.content if pieces else b"", things.content if things else b""


def decorations_in(room: Room) -> list[PlacedBody]:
    """Returns a room's decorations."""
    if (rows := rows_in(room, DecorationRows)) is not None:
        return [_as_told(*one) for one in zip(rows.ids, rows.looks, rows.rows, strict=True)]
    keyed = ((one, ("decoration", one.name, one.width, one.depth, one.height, one.kind)) for one in room.decorations)
    rests = (one.parent is not None or one.mounted_on_wall is not None or one.y != 0 for one in room.decorations)
    return [PlacedBody(block_of(one), key, one.rotation, one.y, -1, rest) for (one, key), rest in zip(keyed, rests, strict=True)]


def decoration_blocks(room: Room) -> list[Block]:
    """Returns the spaces that a room's decorations take up; those told as rows without their ids."""
    if (rows := rows_in(room, DecorationRows)) is not None:
        return [*map(_block_told, repeat(""), rows.looks, rows.rows)]
    return [*map(block_of, room.decorations)]


def _as_told(name: str, look: Look, row: BodyRow) -> PlacedBody:
    _, on, under, wall, rotation, _, _, _, _, _, _, _, low, _, _, _ = row
    rests = on >= 0 or ((BODY_WALLS[wall] is not None or low != 0) and look.key[0] == "decoration")
    return _new(PlacedBody, (_block_told(name, look, row), look.key, rotation, low / 1000, under, rests))


def _block_told(name: str, look: Look, row: BodyRow) -> Block:
    y = row[12] / 1000
    return _new(Block, (_new(Rect, row[8:12]), y * 1000, (y + look.size[2]) * 1000, name))


def block_of(body: Furniture | Decoration | Dynamic) -> Block:
    """Returns the space a body takes up."""
    return Block(footprint(body), body.y * 1000, (body.y + body.height) * 1000, body.id)


def nearest_place(own: Rect, area: Rect, blocks: Sequence[Rect] | bytes, reach: int | None = None) -> Rect | None:
    """Returns the free place nearest to a wished box, within an area and `reach` mm from the wish; None where there is none.

    `blocks` are what it must not overlap, `rect_rows` of it where these are asked about again. Ties go to the lesser step along x, then
    west, then along z, then north.
    """
    rows = blocks if isinstance(blocks, bytes) else rect_rows(blocks)
    request = _NEAREST.pack(*own, *area, -1 if reach is None else reach, len(rows) // RECT.size, 0) + rows
    with borrowed() as core:
        at = core.write(request)
        found = core.call("nearest_place", at, len(request))
        return Rect(*RECT.unpack(core.read(at, RECT.size))) if found else None


def rect_rows(rects: Sequence[Rect]) -> bytes:
    """Returns rectangles as the core reads them."""
    return pack(f"<{4 * len(rects)}q", *chain.from_iterable(rects))


def free_places(own: Rect, clear: Rect, blocks: Sequence[Rect], apart: int) -> Iterator[Rect]:
    """Yields free places of a box, nearest first: those that `nearest_place` tries, and those `apart` mm from obstacles and walls."""
    inner = clear.shrunk(apart)
    edges = [*blocks, *(rect.shrunk(-apart) for rect in blocks), Rect(inner.x1, inner.z1, inner.x0, inner.z0)]
    xs = _steps(own.x0, (clear.x0, clear.x1 - own.width), [(rect.x0 - own.width, rect.x1) for rect in edges])
    zs = _steps(own.z0, (clear.z0, clear.z1 - own.depth), [(rect.z0 - own.depth, rect.z1) for rect in edges])
    for x, z in sorted(((x, z) for x in xs for z in zs), key=lambda at: (at[0] - own.x0) ** 2 + (at[1] - own.z0) ** 2):
        place = own.moved(x - own.x0, z - own.z0)
        if not any(place.overlaps(rect) for rect in blocks):
            yield place


def _steps(wish: int, bounds: tuple[int, int], taken: Sequence[tuple[int, int]]) -> list[int]:
    """Returns the coordinates within bounds worth trying along an axis, nearest first: the wish, and the ends of what is taken."""
    tried = {wish, *bounds, *(end for ends in taken for end in ends)}
    return sorted((v for v in tried if bounds[0] <= v <= bounds[1]), key=lambda v: (abs(v - wish), v))
