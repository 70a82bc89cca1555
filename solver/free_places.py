"""What bodies of a scene take up, and the free place nearest to a wished one, exactly.

The free places of a box are what is left of a rectangle after the obstacles, grown by the box; the nearest of them to a wish
has both coordinates among the wish's own and the edges of those, so that these are all that need to be tried.
"""

import math
from collections.abc import Iterator, Sequence
from itertools import chain
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.body_rows import BODY, DecorationRows, FurnitureRows, rows_in
from solver.core import borrowed
from solver.geometry import Rect, extents, to_mm
from solver.scene import Decoration, Dynamic, Furniture, Room

FLAT_MM: Final = 20
"""Rugs and mats: what is no higher is no body, one stands on it (docs/scene.md, The rules)."""

ROUNDED_MM: Final = 1e-3
"""Scenes are read to the micrometre."""

RECT: Final = Struct("<4q")
_NEAREST: Final = Struct("<9q2i")


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


def furniture_as_told(room: Room) -> bytes:
    """Returns a room's furniture as rows: the core's; where it was told one by one such rows, of no kind, 0 for any that it rests on."""
    if (rows := rows_in(room, FurnitureRows)) is not None:
        return rows.content
    numbers = {piece.id: k for k, piece in enumerate(room.furniture)}
    return b"".join([_as_told(one, one.on is not None, numbers.get(one.under or "", -1)) for one in room.furniture])


def decorations_as_told(room: Room) -> bytes:
    """Returns a room's decorations as such rows."""
    if (rows := rows_in(room, DecorationRows)) is not None:
        return rows.content
    rests = (one.parent is not None or one.mounted_on_wall is not None or one.y != 0 for one in room.decorations)
    return b"".join([*map(_as_told, room.decorations, rests)])


def _as_told(body: Furniture | Decoration, rests: bool, under: int = -1) -> bytes:
    """Returns a body as a row; its heights are rounded outwards as its footprint is, but what is flat stays so."""
    low = math.floor(body.y * 1000 + 1e-6)
    height = math.ceil((body.y + body.height) * 1000 - 1e-6) - low
    if body.height * 1000 <= FLAT_MM:
        height = min(height, FLAT_MM)
    return BODY.pack(0, rests - 1, under, -1, 0, 0, 0, 0, *footprint(body), low, to_mm(body.width), to_mm(body.depth), height)


def decoration_blocks(room: Room) -> list[Block]:
    """Returns the spaces that a room's decorations take up, without their ids."""
    return [Block(Rect(*row[8:12]), row[12], row[12] + row[15]) for row in BODY.iter_unpack(decorations_as_told(room))]


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
