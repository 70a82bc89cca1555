"""People and pets that are in the way -> the nearest free places; those who sit -> where their seats went.

Comes in: a furnished room, its people, who of them is covered. Goes out: the people. May import: the ground floor.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Final

from solver.free_places import Solid, footprint, free_places, nearest_place, solid_of
from solver.geometry import Rect, half_m, wall_faced
from solver.repair.bodies import BODY_MM, Body
from solver.repair.wishes import Sides
from solver.repair.written import carried_pose
from solver.scene import Dynamic, Furniture, Room
from solver.wanted import Space
from solver.ways import EVERY_SIDE, HEADROOM, Goal, Ways

MOST_PLACES: Final = 200
"""Places that are tried for somebody who is to be in nobody's way."""
NEXT_MM: Final = 200
"""Of places that near each other one is tried, mm."""


@dataclass(frozen=True)
class Crowd:
    """The people of a room in their order, and the ids of those for whom there is no free place."""

    people: tuple[Dynamic, ...]
    stuck: tuple[str, ...] = ()


def placed_people(people: Sequence[Dynamic], room: Room, space: Space, covered: Container[str], uses: Mapping[str, Sides]) -> Crowd:
    """Moves those who are covered to the nearest free place, one after the other; the others stay. Who sat stands up.

    Args:
        people: of one room.
        room: furnished.
        space: its clear rectangle, and what its doors and its outline keep free.
        covered: ids of those who are to move.
        uses: use sides by name of piece: nobody is put where they keep others from them while there is another place. Without
            any, walking is of no interest.
    """
    solids = [Solid(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
    solids += [solid_of(body) for body in _obstacles(room)]
    solids += [solid_of(person) for person in people if person.id not in covered]
    ways = _ways(room, space, uses) if uses else None
    placed: list[Dynamic] = []
    stuck: list[str] = []
    for k, person in enumerate(people):
        others = [footprint(one) for one in (*placed, *people[k + 1 :]) if one.on is None and (one in placed or one.id not in covered)]
        found = _moved(_risen(person), _Room(space.clear, solids, ways, others)) if person.id in covered else person
        if found is None:
            stuck.append(person.id)
        elif found is not person:
            solids.append(solid_of(found))
        placed.append(found or person)
    return Crowd(tuple(placed), tuple(stuck))


def in_the_way(people: Sequence[Dynamic], room: Room, space: Space, uses: Mapping[str, Sides]) -> frozenset[str]:
    """Returns who would have to move for everything in a room to be within reach.

    One of those who stand, or if that is not enough all; nobody where they are not what is in the way.
    """
    ways = _ways(room, space, uses)
    standing = {person.id: footprint(person) for person in people if person.on is None}
    if not standing or ways.open(list(standing.values())) or not ways.open():
        return frozenset()
    for label in reversed(standing):
        if ways.open([rect for other, rect in standing.items() if other != label]):
            return frozenset({label})
    return frozenset(standing)


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


def _ways(room: Room, space: Space, uses: Mapping[str, Sides]) -> Ways:
    """Returns what has to stay within reach in a room without its people."""
    bodies = [footprint(body) for body in _obstacles(room) if body.y < HEADROOM]
    goals = [_goal(piece, *uses[piece.name]) for piece in room.furniture if piece.name in uses]
    return Ways(space, bodies, goals)


def _goal(piece: Furniture, sides: Sequence[str], need_all: bool) -> Goal:
    return Goal(footprint(piece), tuple(wall_faced(side, piece.rotation) for side in sides), need_all)


@dataclass(frozen=True)
class _Room:
    """Where somebody may be put: the clear rectangle, what is taken, what must stay within reach and who else stands there."""

    clear: Rect
    solids: Sequence[Solid]
    ways: Ways | None
    others: Sequence[Rect]


def _moved(person: Dynamic, room: _Room) -> Dynamic | None:
    """Returns a person at the nearest free place, turned as before, or None where there is none."""
    own = solid_of(person)
    blocks = [solid.rect for solid in room.solids if not solid.beside(own)]
    found = nearest_place(own.rect, room.clear, blocks)
    if found is None:
        return None
    found = _out_of_the_way(own.rect, room, blocks) or found
    return replace(person, x=half_m(found.x0 + found.x1), z=half_m(found.z0 + found.z1))


def _out_of_the_way(own: Rect, room: _Room, blocks: Sequence[Rect]) -> Rect | None:
    """Returns the nearest of the likely places that leaves everything within reach, or None where that is of no interest."""
    ways = room.ways
    if ways is None or not ways.open(room.others):
        return None
    places = islice(_spread(free_places(own, room.clear, blocks, ways.space.robot_mm)), MOST_PLACES)
    return next((place for place in places if ways.open([*room.others, place], [Goal(place, EVERY_SIDE)])), None)


def _spread(places: Iterable[Rect]) -> Iterator[Rect]:
    """Leaves out places next to one before: where that would not do, they hardly ever do."""
    kept: set[tuple[int, int]] = set()
    for place in places:
        cell = (place.x0 // NEXT_MM, place.z0 // NEXT_MM)
        if cell not in kept:
            kept.add(cell)
            yield place
