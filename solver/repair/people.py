"""People and pets that are in the way -> the nearest free places, exactly.

Comes in: a furnished room, its people, who of them is covered. Goes out: the people. May import: the ground floor.

The free places of a box are what is left of a rectangle after the obstacles, grown by the box; the nearest of them to a wish
has both coordinates among the wish's own and the edges of those, so that these are all that need to be tried.
"""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from dataclasses import dataclass, replace

from solver.geometry import Rect
from solver.repair.bodies import BODY_MM, Body, footprint
from solver.scene import Dynamic, Room
from solver.wanted import Space


@dataclass(frozen=True)
class Crowd:
    """The people of a room in their order, and the ids of those for whom there is no free place."""

    people: tuple[Dynamic, ...]
    stuck: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Solid:
    """What a person cannot be in: a rectangle from `bottom` to `top`, mm."""

    rect: Rect
    bottom: float
    top: float


def placed_people(people: Sequence[Dynamic], room: Room, space: Space, covered: Container[str]) -> Crowd:
    """Moves those who are covered to the nearest free place, one after the other; the others stay.

    Args:
        people: of one room.
        room: furnished.
        space: its clear rectangle, and what its doors and its outline keep free.
        covered: ids of those who are to move.
    """
    solids = [_Solid(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
    solids += [_solid(body) for body in _obstacles(room)]
    solids += [_solid(person) for person in people if person.id not in covered]
    placed: list[Dynamic] = []
    stuck: list[str] = []
    for person in people:
        found = _moved(person, space.clear, solids) if person.id in covered else person
        if found is None:
            stuck.append(person.id)
        elif found is not person:
            solids.append(_solid(found))
        placed.append(found or person)
    return Crowd(tuple(placed), tuple(stuck))


def _obstacles(room: Room) -> list[Body]:
    loose = [thing for thing in room.decorations if thing.parent is None and thing.mounted_on_wall is None]
    bodies: list[Body] = [*room.furniture, *loose]
    return [body for body in bodies if body.height * 1000 > BODY_MM]


def _solid(body: Body | Dynamic) -> _Solid:
    return _Solid(footprint(body), body.y * 1000, (body.y + body.height) * 1000)


def _moved(person: Dynamic, clear: Rect, solids: Sequence[_Solid]) -> Dynamic | None:
    """Returns a person at the nearest free place, turned as before, or None where there is none."""
    own = _solid(person)
    blocks = [solid.rect for solid in solids if solid.bottom < own.top and own.bottom < solid.top]
    found = _nearest(own.rect, clear, blocks)
    if found is None:
        return None
    return replace(person, x=_centre(found[0], own.rect.width), z=_centre(found[1], own.rect.depth))


def _centre(low: int, extent: int) -> float:
    return (2 * low + extent) / 2000


def _nearest(own: Rect, clear: Rect, blocks: Sequence[Rect]) -> tuple[int, int] | None:
    """Returns the min corner of the free place nearest to a box, mm; ties go to the lesser step along x, then along z."""
    xs = _steps(own.x0, own.width, (clear.x0, clear.x1), [(rect.x0, rect.x1) for rect in blocks])
    zs = _steps(own.z0, own.depth, (clear.z0, clear.z1), [(rect.z0, rect.z1) for rect in blocks])
    best: tuple[int, tuple[int, int]] | None = None
    for x in xs:
        if best is not None and (x - own.x0) ** 2 >= best[0]:
            break
        for z in zs:
            distance = (x - own.x0) ** 2 + (z - own.z0) ** 2
            if best is not None and distance >= best[0]:
                break
            place = Rect(x, z, x + own.width, z + own.depth)
            if not any(place.overlaps(rect) for rect in blocks):
                best = distance, (x, z)
                break
    return best[1] if best else None


def _steps(at: int, extent: int, bounds: tuple[int, int], blocks: Sequence[tuple[int, int]]) -> list[int]:
    """Returns the min coordinates worth trying along an axis, nearest first."""
    low, high = bounds[0], bounds[1] - extent
    tried = {at, low, high, *(b for _, b in blocks), *(a - extent for a, _ in blocks)}
    return sorted((v for v in tried if low <= v <= high), key=lambda v: (abs(v - at), v))
