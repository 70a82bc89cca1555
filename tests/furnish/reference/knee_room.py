"""Where a piece can reach under another one: nowhere does a part of the one stand in a part of the other.

A place is that of the piece's centre, mm, from the other's centre in the other's frame.
"""

from __future__ import annotations

from collections.abc import Iterable

from solver.geometry import Rect, rotate
from solver.relations.subject import PartBox

CLEAR_MM = 5
"""How far apart, seen from above, two parts are kept."""


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
