"""The main entrance of a home that says none: a door that leads outside, of the room that one would come in by."""

from dataclasses import replace
from typing import Final

from catalogs import Catalogs
from solver.answers import ChosenEntrance
from solver.guessing.doors_between import doors_between, joined_rooms
from solver.scene import EXTERIOR, Opening, Room, Scene

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
