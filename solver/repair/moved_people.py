"""People and pets that are in the way -> the nearest free places."""

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Final

from solver.free_floor import FreeFloor, Goal
from solver.free_places import block_of, footprint, free_places
from solver.geometry import Rect, half_m
from solver.repair.bodies import standing
from solver.repair.room_problem import RoomProblem
from solver.scene import Dynamic

MOST_PLACES: Final = 200
"""Places that are tried for somebody who is to be in nobody's way."""
NEXT_MM: Final = 200
"""Of places that near each other one is tried, mm."""


@dataclass(frozen=True)
class Crowd:
    """The people of a room in their order, and the ids of those for whom there is no free place."""

    people: tuple[Dynamic, ...]
    stuck: tuple[str, ...] = ()


def people_out_of_the_way(problem: RoomProblem, people: Sequence[Dynamic], closed: bool) -> Crowd:
    """Moves those who break a rule, or keep others from something, to the nearest free place; the others stay. Who sat stands up.

    Without those for whom there is none all others have their places. They themselves go where nobody is, if there is such a place. Those
    who are locked stay. `closed`: something in the room is out of reach.
    """
    stuck = frozenset[str]()
    while (crowd := _without(stuck, problem, people, closed)).stuck:
        stuck |= set(crowd.stuck)
    if not stuck:
        return crowd
    floor, placed = _floor_of(problem), {person.id: person for person in crowd.people}
    for person in crowd.people:
        floor.add(block_of(person))
    for person in (standing(person) for person in people if person.id in stuck):
        placed[person.id] = _put_nearest(person, floor) or person
        floor.add(block_of(placed[person.id]))
    return Crowd(tuple(placed[person.id] for person in people), tuple(person.id for person in people if person.id in stuck))


def _without(gone: frozenset[str], problem: RoomProblem, people: Sequence[Dynamic], closed: bool) -> Crowd:
    """Returns where the others of a crowd go once some have left."""
    here = [person for person in people if person.id not in gone]
    floor, moving = _floor_of(problem), _covered(problem, here, gone)
    if closed and problem.settings.walk:
        moving |= _in_the_way([person for person in here if person.id not in moving], floor) - problem.settings.locked
    return _placed(floor, here, moving, problem.settings.walk) if moving else Crowd(tuple(here))


def _floor_of(problem: RoomProblem) -> FreeFloor:
    return FreeFloor.of_room(problem.room, problem.space, problem.settings.use_sides)


def _covered(problem: RoomProblem, people: Sequence[Dynamic], gone: frozenset[str]) -> set[str]:
    """Returns who has to move: who breaks a rule alone, and of two left in one place the later, unless that one is locked."""
    ids = [person.id for person in people]
    issues = [issue for issue in problem.errors if not gone & set(issue.ids)]
    broken = [[label for label in issue.ids if label in ids] for issue in issues]
    found: set[str] = set()
    for together in sorted(broken, key=len):
        free = [label for label in together if label not in problem.settings.locked]
        if free and not found & set(together):
            found.add(max(free, key=ids.index))
    return found


def _in_the_way(people: Sequence[Dynamic], floor: FreeFloor) -> frozenset[str]:
    """Returns who would have to move for everything in a room to be within reach.

    One of those who stand, or if that is not enough all; nobody where they are not what is in the way.
    """
    rects = {person.id: footprint(person) for person in people if person.on is None}
    if not rects or floor.connects(list(rects.values())) or not floor.connects():
        return frozenset()
    for label in reversed(rects):
        if floor.connects([rect for other, rect in rects.items() if other != label]):
            return frozenset({label})
    return frozenset(rects)


def _placed(floor: FreeFloor, people: Sequence[Dynamic], moving: Collection[str], walk: bool) -> Crowd:
    """Moves some of the people to the nearest free place, one after the other; nobody into another's way while there is a choice."""
    for person in people:
        if person.id not in moving:
            floor.add(block_of(person), in_the_way=person.on is None)
    placed: list[Dynamic] = []
    stuck: list[str] = []
    for person in people:
        found = _moved(standing(person), floor, walk) if person.id in moving else person
        if found is None:
            stuck.append(person.id)
        elif found is not person:
            floor.add(block_of(found))
        placed.append(found or person)
    return Crowd(tuple(placed), tuple(stuck))


def _moved(person: Dynamic, floor: FreeFloor, walk: bool) -> Dynamic | None:
    """Returns a person at the nearest free place where it is in nobody's way, or None where there is none.

    With `walk` it is the nearest of the likely places that leaves everything within reach, turned as before or else by a quarter.
    """
    if not walk or not floor.connects():
        return _put_nearest(person, floor)
    for turn in (0, 90):
        turned = replace(person, rotation=(person.rotation + turn) % 360)
        own = block_of(turned)
        taken = floor.obstacles(own)
        outermost = [rect for rect in taken if not any(other != rect and other.contains(rect) for other in taken)]
        for place in islice(_spread(free_places(own.rect, floor.space.clear, outermost, floor.space.robot_mm)), MOST_PLACES):
            if floor.connects([place], [Goal.beside(place)]):
                return _put(turned, place)
    return None


def _put_nearest(person: Dynamic, floor: FreeFloor) -> Dynamic | None:
    nearest = floor.nearest(block_of(person))
    return None if nearest is None else _put(person, nearest)


def _put(person: Dynamic, place: Rect) -> Dynamic:
    return replace(person, x=half_m(place.x0 + place.x1), z=half_m(place.z0 + place.z1))


def _spread(places: Iterable[Rect]) -> Iterator[Rect]:
    """Leaves out places next to one before: where that would not do, they hardly ever do."""
    kept: set[tuple[int, int]] = set()
    for place in places:
        cell = (place.x0 // NEXT_MM, place.z0 // NEXT_MM)
        if cell not in kept:
            kept.add(cell)
            yield place
