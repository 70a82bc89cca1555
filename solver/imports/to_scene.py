"""Rooms and openings in whole mm -> rooms of a scene."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from catalogs import Catalogs
from catalogs.synonyms import room_names_of
from solver.free_names import FreeNames
from solver.geometry import to_m
from solver.imports.drawn import DrawnRoom, PlanNotes
from solver.imports.joining import HEIGHTS, SILLS, Joined
from solver.imports.rectilinear import FloorCorners, PlanEdge, edges_of_corners
from solver.imports.wall_depths import FacingEdges
from solver.plain import quoted
from solver.scene import EXTERIOR, Flooring, Opening, Room, Sides

DOORWAY: Final = 900
"""Rooms that share so much of a wall, mm, could have a door."""
UNTYPED: Final = "room"
PLAIN_ID: Final = re.compile(r"[\w./-]+")
"""An id that reads well; others are given anew."""


@dataclass(frozen=True)
class NamedRoom:
    """A room of the plan: as drawn, its id, type and floor, its corners, mm; how thick its outer walls are, m, where not the scene's."""

    drawn: DrawnRoom
    id: str
    type: str
    corners: FloorCorners
    wall_thickness: tuple[float | None, ...] | None = None
    flooring: Flooring | None = None


def named_rooms(rooms: Sequence[tuple[DrawnRoom, str, FloorCorners]]) -> list[NamedRoom]:
    """Gives rooms their ids: the file's own, else the type and the room's number."""
    names, found = FreeNames(), []
    for number, (drawn, kind, corners) in enumerate(rooms):
        name = names.take(drawn.id if PLAIN_ID.fullmatch(drawn.id) else f"{kind}_{number}")
        found.append(NamedRoom(drawn, name, kind, corners))
    return found


def type_of_drawn(drawn: DrawnRoom, catalogs: Catalogs) -> str:
    """Returns the room type that a room's type or label names, else `room`."""
    names = room_names_of(catalogs)
    for said in (drawn.type, drawn.label):
        meaning = None if said in catalogs.rooms else names.meaning(said)
        if said in catalogs.rooms or (meaning is not None and meaning.key in catalogs.rooms):
            return said if meaning is None else meaning.key
    return UNTYPED


def tell_type(room: NamedRoom, notes: PlanNotes) -> None:
    """Notes what a room's type was told from, where the file does not say it in our words."""
    said = next((word for word in (room.drawn.type, room.drawn.label) if word), "")
    if room.type == UNTYPED:
        words = f"it is called {quoted(said)}, which names no room type" if said else "the file does not say what it is"
        notes.guess(room.id, "type", UNTYPED, words)
    elif room.drawn.type != room.type and "_".join(said.lower().split()) != room.type:
        notes.guess(room.id, "type", room.type, f"it is called {quoted(said)}")


def outdoor_told(room: NamedRoom, catalogs: Catalogs, notes: PlanNotes) -> NamedRoom:
    """Returns a room that lies outdoors where its type does and the file does not say: a balcony, a garden."""
    kind = catalogs.rooms.get(room.type)
    if room.drawn.outdoor is not None or kind is None or not kind.outdoor:
        return room
    notes.guess(room.id, "outdoor", "true", f"the file does not say; a {room.type} lies outdoors")
    return replace(room, drawn=replace(room.drawn, outdoor=True))


def with_floor(room: NamedRoom, catalogs: Catalogs) -> NamedRoom:
    """Returns a room with the floor whose colour the file names: of the material of its type."""
    kind = catalogs.rooms.get(room.type)
    if room.drawn.floor is None or kind is None:
        return room
    return replace(room, flooring=Flooring(kind.flooring, room.drawn.floor))


def scene_rooms(rooms: Sequence[NamedRoom], openings: Sequence[Joined], origin: tuple[int, int]) -> list[Room]:
    """Returns the rooms of the scene, with their openings."""
    listed: list[list[Opening]] = [[] for _ in rooms]
    counts: Counter[str] = Counter()
    taken = {one.drawn.id for one in openings if one.drawn.id}
    given: set[str] = set()
    for one in openings:
        name = one.drawn.id if one.drawn.id not in given else ""
        while not name or (name in taken and name != one.drawn.id):
            name = f"{one.drawn.kind}_{counts[one.drawn.kind]}"
            counts[one.drawn.kind] += 1
        given.add(name)
        for place, edge in enumerate(one.edges):
            listed[edge.room].append(_opening(one, name, place, rooms))
    edges = [edges_of_corners(number, room.corners) for number, room in enumerate(rooms)]
    facing = FacingEdges(edges)
    outer = [_outer_sides(own, facing) for own in edges]
    return [_room(number, room, listed[number], outer[number], origin) for number, room in enumerate(rooms)]


def _is_rectangle(corners: FloorCorners) -> bool:
    return len(corners) == 4


def _room(number: int, room: NamedRoom, openings: list[Opening], outer: Sides, origin: tuple[int, int]) -> Room:
    xs, zs = [x for x, _ in room.corners], [z for _, z in room.corners]
    x, z = min(xs), min(zs)
    outline = None if _is_rectangle(room.corners) else tuple((to_m(a - x), to_m(b - z)) for a, b in room.corners)
    name = room.drawn.label if room.drawn.label != room.type else None
    return Room(
        room.id, number, room.type, room.drawn.level, to_m(x - origin[0]), to_m(z - origin[1]), to_m(max(xs) - x), to_m(max(zs) - z),
        outline, bool(room.drawn.outdoor), room.flooring, wall_thickness=room.wall_thickness, exterior_walls=outer,
        openings=tuple(openings), name=name or None,
    )  # fmt: skip


def _opening(one: Joined, name: str, place: int, rooms: Sequence[NamedRoom]) -> Opening:
    """Returns an opening as the room at that place in it lists it."""
    edge, drawn = one.edges[place], one.drawn
    room = rooms[edge.room]
    is_rectangle = _is_rectangle(room.corners)
    side = ("north" if edge.out < 0 else "south") if edge.axis == "x" else ("west" if edge.out < 0 else "east")
    other = rooms[one.edges[1 - place].room].id if len(one.edges) == 2 else EXTERIOR
    swing = None if one.towards is None or drawn.kind != "door" else ("in" if one.towards == -edge.out else "out")
    return Opening(
        name,
        drawn.kind,
        side if is_rectangle else None,
        round(one.low + one.high - 2 * edge.low) / 2000,
        to_m(one.high - one.low),
        round(HEIGHTS[drawn.kind] if drawn.height is None else drawn.height, 3),
        round(SILLS[drawn.kind] if drawn.sill is None else drawn.sill, 3),
        other,
        one.hinge if drawn.kind == "door" else None,
        swing,
        bool(drawn.main_entrance) and other == EXTERIOR,
        place == 0 and drawn.kind != "passage",
        None if is_rectangle else edge.side,
    )


def _outer_sides(own: Sequence[PlanEdge], facing: FacingEdges) -> Sides:
    """Tells which sides of a room look outside: a part of an outermost edge there that no other room shares."""
    found = {}
    for side, axis, out in (("north", "x", -1), ("south", "x", 1), ("east", "z", 1), ("west", "z", -1)):
        edge = max((one for one in own if (one.axis, one.out) == (axis, out)), key=lambda one: one.at * out)
        found[side] = facing.shared(edge) < edge.length
    return Sides(**found)


def adjacency_of(rooms: Sequence[NamedRoom]) -> tuple[tuple[int, int], ...]:
    """Returns the pairs of rooms that share a wall long enough for a door."""
    shared: Counter[tuple[int, int]] = Counter()
    edges = [edges_of_corners(number, room.corners) for number, room in enumerate(rooms)]
    facing = FacingEdges(edges)
    for edge in (one for room in edges for one in room if one.out > 0):
        for other, common in facing.across(edge):
            shared[min(edge.room, other.room), max(edge.room, other.room)] += common
    return tuple(sorted(pair for pair, length in shared.items() if length >= DOORWAY))
