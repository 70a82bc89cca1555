"""Who is entered through whom: planned before rooms have types, and the tree of doors once they have.

Not here: where in the wall a door stands (openings.py).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from typing import Final

from catalogs.schema import RoomType
from solver.floorplan.tiling import Joint, Layout, neighbours
from solver.geometry import Rect
from solver.scene import WALLS

THROUGH_PUBLIC: Final = 1.0
"""Cost of entering a room through a way through that is not a hallway (a hallway costs nothing)."""
THROUGH_OWNER: Final = 1.5
"""... through its owner, such as a bathroom through its bedroom."""
THROUGH_OTHER: Final = 30.0
"""... through any other room, such as an office: worse than any sane detour."""
THROUGH_PRIVATE: Final = 300.0
"""... through a bedroom or a bathroom."""
THROUGH_OUTDOOR: Final = 3000.0
"""... through a garden."""
HOP: Final = 0.01
"""What every door costs, so that of equal ways the one with fewer doors wins."""

OFF_STREET: Final = 2.5
"""A front door that is not on the street comes so many times later."""
AMONG_BEDROOMS: Final = 4.5
"""Where a hallway among bedrooms comes for the front door: after whatever is on the street. Our choice, as is OFF_STREET."""

AS_PLANNED: Final = 0.5
"""At most this to enter a room through the one it was planned behind: its bathroom belongs to the bedroom in front."""
SERVED: Final = {"kitchen", "dining_room"}
"""Rooms of a plain house with an opening from one into the other wherever they share a wall: one carries dishes."""


_PRIVATE: Final = frozenset(("bed", "single_bed", "toilet"))


@dataclass(frozen=True)
class AccessPlan:
    """Who is to be entered through whom, planned before types are known.

    `parent[i]` is the room that room i is entered from (None: it is a hallway, touches one, or is the first room);
    `through` are the rooms, not hallways, that others are entered from.
    """

    parent: tuple[int | None, ...]
    through: frozenset[int]


def plan_access(layout: Layout, shared: Sequence[Joint]) -> AccessPlan:
    """Plans which rooms are ways through: the layout's cells, or without hallways a connected dominating set."""
    if layout.spine:
        parents = tuple(layout.behind.get(i) for i in range(len(layout.rooms)))
        return AccessPlan(parents, frozenset(layout.behind.values()))
    return _dominating(layout, neighbours(len(layout.rooms), tuple(shared)))


def _dominating(layout: Layout, by_room: list[list[Joint]]) -> AccessPlan:
    """Tries every room on the street as the root of a greedy tree (Guha and Khuller 1998) and keeps the smallest."""
    rooms = layout.rooms
    if len(rooms) == 1:
        return AccessPlan((None,), frozenset())
    street = [i for i, exposed in enumerate(layout.exposed) if "south" in exposed]
    spared = min(range(len(rooms)), key=lambda i: (rooms[i].area_m2, i))
    roots = [i for i in street if i != spared][:8] or street[:1]
    grown = [_grow(root, spared, rooms, by_room) for root in roots]
    return min(grown, key=lambda plan: len(plan.through | {plan.parent.index(None)}))


def _grow(root: int, spared: int, rooms: Sequence[Rect], by_room: list[list[Joint]]) -> AccessPlan:
    parent: list[int | None] = [None] * len(rooms)
    seen = {root}

    def rank(room: int) -> tuple[bool, bool, int, float, int]:
        fresh = sum(joint.other(room) not in seen for joint in by_room[room])
        return fresh == 0, room == spared, -fresh, -rooms[room].area_m2, room

    edge = [rank(room) for room in _open(root, parent, seen, by_room)]
    heapify(edge)
    while edge and len(seen) < len(rooms):
        known = heappop(edge)
        now = rank(known[-1])  # never better than what is known: seen only grows
        if now != known:
            heappush(edge, now)
        elif now[0]:
            break
        else:
            for room in _open(now[-1], parent, seen, by_room):
                heappush(edge, rank(room))
    return AccessPlan(tuple(parent), frozenset(p for p in parent if p is not None))


def _open(room: int, parent: list[int | None], seen: set[int], by_room: list[list[Joint]]) -> list[int]:
    fresh = [j.other(room) for j in by_room[room] if j.other(room) not in seen]
    for i in fresh:
        parent[i] = room
        seen.add(i)
    return fresh


def passing_cost(through: str, entered: str, rooms: Mapping[str, RoomType]) -> float:
    """Returns what it costs to enter a room of one type through a room of another."""
    kind = rooms[through]
    if through == "hallway" or (entered == "hallway" and kind.plan.way_through):
        return 0.0
    if kind.outdoor:
        return THROUGH_OUTDOOR
    if kind.plan.way_through:
        return THROUGH_PUBLIC
    if through in rooms[entered].plan.behind:
        return THROUGH_OWNER
    return THROUGH_PRIVATE if is_private(through, rooms) else THROUGH_OTHER


def is_private(name: str, rooms: Mapping[str, RoomType]) -> bool:
    """Tells whether a type is a bedroom or a bathroom: one sleeps, bathes or uses the toilet there."""
    return not all(map(_PRIVATE.isdisjoint, rooms[name].requires))


@dataclass(frozen=True)
class RoomAccess:
    """Rooms with types: what the door tree is grown over."""

    types: tuple[str, ...]
    shared: tuple[Joint, ...]
    access_plan: AccessPlan
    rooms: Mapping[str, RoomType]

    def cost(self, through: int, entered: int) -> float:
        """Returns what it costs to enter one room through another; as planned is best."""
        cost = HOP + passing_cost(self.types[through], self.types[entered], self.rooms)
        planned = self.access_plan.parent[entered] == through and cost < THROUGH_OTHER
        return min(cost, AS_PLANNED) if planned else cost


def door_tree(entrance: int, typed: RoomAccess) -> tuple[tuple[Joint, int], ...]:
    """Finds the cheapest way from the room with the main entrance to every other (Dijkstra 1959 over passing_cost).

    Returns for each of those the joint of its door and its own index. Of equal ways the longest wall wins.
    """
    by_room = neighbours(len(typed.types), typed.shared)
    best: dict[int, tuple[float, int]] = {entrance: (0.0, 0)}
    door: dict[int, Joint] = {}
    queue = [(0.0, 0, entrance)]
    done: set[int] = set()
    while queue:
        cost, _, room = heappop(queue)
        if room in done:
            continue
        done.add(room)
        for joint in by_room[room]:
            other = joint.other(room)
            offer = (cost + typed.cost(room, other), -joint.length)
            if other not in done and (other not in best or offer < best[other]):
                best[other], door[other] = offer, joint
                heappush(queue, (*offer, other))
    return tuple((door[i], i) for i in sorted(door))


def served(typed: RoomAccess, tree: Sequence[tuple[Joint, int]]) -> tuple[tuple[Joint, int], ...]:
    """Returns the longest wall that a kitchen shares with a dining room, where the tree has no door between them."""
    between = [one for one in typed.shared if {typed.types[one.a], typed.types[one.b]} == SERVED]
    if not between or any(joint in between for joint, _ in tree):
        return ()
    joint = max(between, key=lambda one: (one.length, one))
    return ((joint, joint.a),)


def entrance_of(layout: Layout, types: Sequence[str], rooms: Mapping[str, RoomType], by_hallway: bool = True) -> tuple[int, str]:
    """Chooses the room and the wall of the main entrance.

    A room that the front door may open into, by its place among those (`entrance`), which counts OFF_STREET times where the
    wall is not the south one: a hallway's end comes after a living room on the street and before a kitchen there. Then the
    widest wall. Else that of any other indoor room, of anything. Not `by_hallway`: a hallway only where nothing on the
    street may be come in by, so that one does not come in among the bedrooms.
    """
    lengths = {
        (i, wall): max(high - low for low, high in stretches)
        for i, exposed in enumerate(layout.openable)
        for wall, stretches in exposed.items()
    }
    least = layout.walls.door_wall
    wide = [place for place, length in lengths.items() if length >= least] or list(lengths)

    def rank(place: tuple[int, str]) -> tuple[tuple[int, float], bool, int, int, int]:
        i, wall = place
        south = wall == "south"
        return (_tier(types[i], south, by_hallway, rooms), not south, -lengths[place], i, WALLS.index(wall))

    return min(wide, key=rank)


def _tier(name: str, south: bool, by_hallway: bool, rooms: Mapping[str, RoomType]) -> tuple[int, float]:
    place = rooms[name].plan.entrance
    if place is None:
        return 1 + (rooms[name].outdoor or is_private(name, rooms)), 0.0
    if name == "hallway" and not by_hallway:
        return 0, AMONG_BEDROOMS
    return 0, place * (1.0 if south else OFF_STREET)
