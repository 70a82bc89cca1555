"""Doors that lead to a room whatever they say: another room lists them, or its floor lies behind them."""

from collections.abc import Iterator, Sequence
from typing import Final

from solver.geometry import encloses, walls_round
from solver.scene import Opening, Room

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
