"""People and pets that are in the way -> the nearest free places; those who sit -> where their seats went.

Comes in: a furnished room, its people, who of them is covered. Goes out: the people. May import: the ground floor.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass, replace

from solver.free_places import Solid, nearest_place, solid_of
from solver.geometry import Rect, half_m
from solver.repair.bodies import BODY_MM, Body
from solver.repair.written import carried_pose
from solver.scene import Dynamic, Furniture, Room
from solver.wanted import Space


@dataclass(frozen=True)
class Crowd:
    """The people of a room in their order, and the ids of those for whom there is no free place."""

    people: tuple[Dynamic, ...]
    stuck: tuple[str, ...] = ()


def placed_people(people: Sequence[Dynamic], room: Room, space: Space, covered: Container[str]) -> Crowd:
    """Moves those who are covered to the nearest free place, one after the other; the others stay. Who sat stands up.

    Args:
        people: of one room.
        room: furnished.
        space: its clear rectangle, and what its doors and its outline keep free.
        covered: ids of those who are to move.
    """
    solids = [Solid(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
    solids += [solid_of(body) for body in _obstacles(room)]
    solids += [solid_of(person) for person in people if person.id not in covered]
    placed: list[Dynamic] = []
    stuck: list[str] = []
    for person in people:
        found = _moved(_risen(person), space.clear, solids) if person.id in covered else person
        if found is None:
            stuck.append(person.id)
        elif found is not person:
            solids.append(solid_of(found))
        placed.append(found or person)
    return Crowd(tuple(placed), tuple(stuck))


def followed(people: Iterable[Dynamic], before: Iterable[Furniture], after: Iterable[Furniture]) -> tuple[Dynamic, ...]:
    """Takes those who sit along with their seats; who has lost the seat stands up.

    Args:
        people: of a scene.
        before: the furniture they sit on.
        after: the same furniture where it stands now; some may be gone.
    """
    sent, now = {piece.id: piece for piece in before}, {piece.id: piece for piece in after}
    return tuple(_after(person, sent.get(person.on or ""), now.get(person.on or "")) for person in people)


def _after(person: Dynamic, before: Furniture | None, after: Furniture | None) -> Dynamic:
    if before is None or after is before:
        return person
    if after is None:
        return _risen(person)
    if (before.x, before.z, before.rotation) == (after.x, after.z, after.rotation):
        return person
    x, z, rotation, _ = carried_pose(person, before, after)
    return replace(person, x=x, z=z, rotation=rotation)


def _risen(person: Dynamic) -> Dynamic:
    """Returns somebody on the floor: a person who sat is as tall as persons are."""
    if person.on is None:
        return person
    standing = Dynamic("") if person.kind == "person" else person
    return replace(person, y=0.0, width=standing.width, depth=standing.depth, height=standing.height, on=None)


def _obstacles(room: Room) -> list[Body]:
    loose = [thing for thing in room.decorations if thing.parent is None and thing.mounted_on_wall is None]
    bodies: list[Body] = [*room.furniture, *loose]
    return [body for body in bodies if body.height * 1000 > BODY_MM]


def _moved(person: Dynamic, clear: Rect, solids: Sequence[Solid]) -> Dynamic | None:
    """Returns a person at the nearest free place, turned as before, or None where there is none."""
    own = solid_of(person)
    found = nearest_place(own.rect, clear, [solid.rect for solid in solids if not solid.beside(own)])
    if found is None:
        return None
    return replace(person, x=half_m(found.x0 + found.x1), z=half_m(found.z0 + found.z1))
