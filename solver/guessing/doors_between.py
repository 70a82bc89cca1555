"""Doors of a plan that says little of them: which lead to a room whatever they say, and which is the main entrance."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from catalogs import Catalogs
from solver.answers import ChosenEntrance
from solver.geometry import encloses, walls_round
from solver.scene import EXTERIOR, Opening, Room, Scene

HouseSpot = tuple[float, float]
WAYS: Final = ("door", "passage")
BEHIND: Final = (0.05, 0.2, 0.35, 0.5)
"""How far behind a door's line floor is looked for, m: walls between rooms are no thicker than 0.6 m."""
_OUT: Final[dict[str, HouseSpot]] = {"north": (0, -1), "south": (0, 1), "west": (-1, 0), "east": (1, 0)}


def doors_between(rooms: Sequence[Room]) -> Iterator[tuple[int, int, Opening]]:
    """Yields doors and passages between two rooms, by the rooms' places in the list: as they say, by their id in both, or as they lie.

    What one room alone lists leads into the room indoors whose floor is right behind it, but the main entrance.
    """
    places = {room.id: k for k, room in enumerate(rooms)}
    by_id: dict[str, int] = {}
    ways = [(k, opening) for k, room in enumerate(rooms) for opening in room.openings if opening.kind in WAYS]
    alone: dict[str, tuple[int, Opening]] = {}
    for k, opening in ways:
        there = places.get(opening.connects_to or "", by_id.get(opening.id, k))
        if there != k:
            alone.pop(opening.id, None)
            yield k, there, opening
        elif opening.id not in by_id and not opening.main_entrance:
            alone[opening.id] = (k, opening)
        by_id.setdefault(opening.id, k)
    for k, opening in alone.values():
        behind = _behind(rooms, k, opening)
        if behind is not None:
            yield k, behind, opening


def joined_rooms(room: int, joints: Sequence[tuple[int, int, Opening]]) -> set[int]:
    """Returns the rooms to which one comes from a room through doors, by their places in the list."""
    found, ahead = {room}, [room]
    while ahead:
        here = ahead.pop()
        new = {b if a == here else a for a, b, _ in joints if here in (a, b)} - found
        found |= new
        ahead += sorted(new)
    return found


def _behind(rooms: Sequence[Room], place: int, opening: Opening) -> int | None:
    """Returns the room indoors whose floor is right behind an opening of one room; None where there is none, or it says no wall."""
    found = None if rooms[place].outdoor else _centre(rooms[place], opening)
    if found is None:
        return None
    (x, z), (dx, dz) = found
    inside = (x - dx * BEHIND[0], z - dz * BEHIND[0])
    level = [k for k, room in enumerate(rooms) if k != place and not room.outdoor and room.level == rooms[place].level]
    others = [k for k in level if not _holds(rooms[k], inside)]
    spots = ((x + dx * far, z + dz * far) for far in BEHIND)
    return next((k for spot in spots for k in others if _holds(rooms[k], spot)), None)


def _centre(room: Room, opening: Opening) -> tuple[HouseSpot, HouseSpot] | None:
    """Returns the middle of an opening in the house, and the way out of the room there."""
    at, edges = opening.position, list(walls_round(room.corners))
    if opening.edge is not None:
        here = [(low + at, line, _OUT[wall]) for wall, line, low, _ in edges[opening.edge : opening.edge + 1]]
    else:
        here = [(at, line, _OUT[wall]) for wall, line, low, high in edges if wall == opening.wall and low <= at <= high]
    if not here:
        return None
    along, line, (dx, dz) = max(here, key=lambda one: one[1] * sum(one[2]))
    x, z = (line, along) if dx else (along, line)
    return (room.x + x, room.z + z), (dx, dz)


def _holds(room: Room, spot: HouseSpot) -> bool:
    """Tells whether a spot of the house lies on a room's floor."""
    return encloses(room.corners, spot[0] - room.x, spot[1] - room.z)


NOT_COME_IN_BY: Final = 100
"""The place, in the order of entrances, of a room type that is none."""


def with_entrance(scene: Scene, catalogs: Catalogs) -> tuple[Scene, ChosenEntrance | None]:
    """Returns a scene with a main entrance, where it has none and a door leads outside; and which door was chosen.

    Rooms of the same storey that no door joins to its room are another dwelling, and get one, too, where they are several.
    """
    if any(opening.main_entrance for room in scene.rooms for opening in room.openings):
        return scene, None
    joints = list(doors_between(scene.rooms))
    inner = {opening.id for _, _, opening in joints}
    outside = sorted(
        (_rank(room, opening, catalogs), k, j)
        for k, room in enumerate(scene.rooms)
        for j, opening in enumerate(room.openings)
        if opening.kind == "door" and not room.outdoor and opening.id not in inner and opening.connects_to in (None, EXTERIOR)
    )
    if not outside:
        return scene, None
    entries, reached = [outside[0][1:]], joined_rooms(outside[0][1], joints)
    for _, k, j in outside[1:]:
        own = set() if k in reached else joined_rooms(k, joints)
        if len(own) > 1 and scene.rooms[k].level == scene.rooms[entries[0][0]].level:
            entries.append((k, j))
            reached |= own
    rooms = list(scene.rooms)
    for k, j in entries:
        chosen = replace(rooms[k].openings[j], main_entrance=True, connects_to=EXTERIOR)
        rooms[k] = replace(rooms[k], openings=(*rooms[k].openings[:j], chosen, *rooms[k].openings[j + 1 :]))
    (first, door), *more = ((rooms[k], rooms[k].openings[j]) for k, j in entries)
    others = "the only door that leads outside" if len(outside) == 1 else f"of {len(outside)} doors that lead outside"
    words = f"{door.id} of {first.id} ({first.type}) was taken as the main entrance: {others}"
    words += "".join(f"; and {one.id} of {room.id} ({room.type}), of rooms that no door joins to these" for room, one in more)
    return replace(scene, rooms=tuple(rooms)), ChosenEntrance(door.id, first.id, words)


def _rank(room: Room, opening: Opening, catalogs: Catalogs) -> tuple[int, bool, int, float]:
    """Returns how far from a main entrance a door is: its storey, what it says of itself, its room's type, its width."""
    kind = catalogs.rooms.get(room.type)
    place = kind.plan.entrance if kind else None
    return abs(room.level), opening.connects_to is None, NOT_COME_IN_BY if place is None else place, -opening.width
