"""Where a piece can reach under another one: nowhere does a part of the one stand in a part of the other.

A place is that of the piece's centre, mm, from the other's centre in the other's frame. Round parts count as the boxes around
them. Kinds without a shape have no parts: nothing is known of what is free under them.
"""

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from catalogs.shapes import Solid
from solver.body_parts import BodyPart, sized, unit_parts
from solver.geometry import Rect, rotate

TINY: Final = 1e-6
"""What sums of shares may be off by, mm."""
CLEAR_MM: Final = 5
"""How far apart, seen from above, two parts are kept."""


class PartBox(NamedTuple):
    """The box around a part: its rectangle from the middle of the piece's footprint, from `low` to `high` above its underside, mm."""

    rect: Rect
    low: int
    high: int


def boxes_of(solids: Sequence[Solid], size: tuple[float, float, float]) -> tuple[PartBox, ...]:
    """Returns the boxes around the parts of a piece of some width, depth and height, m; rounded outwards.

    What is hollow counts as whole: nothing reaches under a piece into its drawers.
    """
    return tuple(_box(part) for part in sized(unit_parts(_wholes(solids)), *size)) if solids else ()


def _wholes(solids: Sequence[Solid]) -> list[Solid]:
    """Returns solids, those that are boards of one hollow part as the box around them."""
    found: dict[int | str, list[Solid]] = {}
    for number, solid in enumerate(solids):
        found.setdefault(f"alone {number}" if solid.board is None else solid.board, []).append(solid)
    return [several[0] if len(several) == 1 else _around(several) for several in found.values()]


def _around(solids: Sequence[Solid]) -> Solid:
    ends = {axis: [getattr(solid, axis) for solid in solids] for axis in "xyz"}
    spans = {axis: (min(low for low, _ in several), max(high for _, high in several)) for axis, several in ends.items()}
    return solids[0].model_copy(update=spans)


def _box(part: BodyPart) -> PartBox:
    (low_x, low_y, low_z), (high_x, high_y, high_z) = (
        [1000 * (at + side * length) for at, length in zip(part.at, part.size, strict=True)] for side in (-0.5, 0.5)
    )
    rect = Rect(math.floor(low_x + TINY), math.floor(low_z + TINY), math.ceil(high_x - TINY), math.ceil(high_z - TINY))
    return PartBox(rect, round(low_y), round(high_y))


@lru_cache(maxsize=1024)
def taken(parent: tuple[PartBox, ...], own: tuple[PartBox, ...], turn: int) -> tuple[Rect, ...]:
    """Returns the open rectangles in which the centre must not be: there a part of a piece, so turned, stands in one of its parent."""
    found: set[Rect] = set()
    for mine in own:
        x0, z0, x1, z1 = _turned(mine.rect, turn)
        for it in parent:
            if mine.low < it.high and it.low < mine.high:
                found.add(Rect(it.rect.x0 - x1, it.rect.z0 - z1, it.rect.x1 - x0, it.rect.z1 - z0).shrunk(-CLEAR_MM))
    return tuple(sorted(rect for rect in found if not any(other != rect and other.contains(rect) for other in found)))


def _turned(rect: Rect, turn: int) -> Rect:
    (x0, z0), (x1, z1) = rotate(rect.x0, rect.z0, turn), rotate(rect.x1, rect.z1, turn)
    return Rect(min(x0, x1), min(z0, z1), max(x0, x1), max(z0, z1))


def free(places: Rect, blocked: Iterable[Rect]) -> list[Rect]:
    """Returns the largest of the rectangles that places leave without open rectangles that are taken; a line or a point may be one."""
    left = [places]
    for hole in blocked:
        cut = [part for rect in left for part in _without(rect, hole)]
        left = [rect for k, rect in enumerate(cut) if not any(_covers(other, rect, j < k) for j, other in enumerate(cut) if j != k)]
    return sorted(left, key=lambda rect: (-rect.width * rect.depth, -rect.width - rect.depth, rect))


def _covers(other: Rect, rect: Rect, goes_first: bool) -> bool:
    return other.contains(rect) and (goes_first or other != rect)


def _without(rect: Rect, hole: Rect) -> list[Rect]:
    x0, z0, x1, z1 = rect
    if hole.x0 >= x1 or hole.x1 <= x0 or hole.z0 >= z1 or hole.z1 <= z0:
        return [rect]
    sides = [Rect(x0, z0, hole.x0, z1), Rect(hole.x1, z0, x1, z1), Rect(x0, z0, x1, hole.z0), Rect(x0, hole.z1, x1, z1)]
    return [side for side in sides if side.x0 <= side.x1 and side.z0 <= side.z1]
