"""The main entrance of a home that says none: a door that leads outside, of the room that one would come in by.

Comes in: a Scene whose rooms have their types. Goes out: the Scene with a main entrance, and which it is.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from catalogs import Catalogs
from solver.guessed import ChosenEntrance
from solver.guessing.doors_between import doors_between
from solver.scene import EXTERIOR, Opening, Room, Scene

NOT_COME_IN_BY: Final = 100
"""The place, in the order of entrances, of a room type that is none."""


def with_entrance(scene: Scene, catalogs: Catalogs) -> tuple[Scene, ChosenEntrance | None]:
    """Returns a scene with a main entrance, where it has none and a door leads outside; and which door was chosen.

    Args:
        scene: with its rooms' types.
        catalogs: by which rooms one comes in.
    """
    if any(opening.main_entrance for room in scene.rooms for opening in room.openings):
        return scene, None
    inner = {opening.id for _, _, opening in doors_between(scene.rooms)}
    outside = [
        (_rank(room, opening, catalogs), k, j)
        for k, room in enumerate(scene.rooms)
        for j, opening in enumerate(room.openings)
        if opening.kind == "door" and not room.outdoor and opening.id not in inner and opening.connects_to in (None, EXTERIOR)
    ]
    if not outside:
        return scene, None
    _, k, j = min(outside)
    room = scene.rooms[k]
    chosen = replace(room.openings[j], main_entrance=True, connects_to=EXTERIOR)
    entered = replace(room, openings=(*room.openings[:j], chosen, *room.openings[j + 1 :]))
    others = "the only door that leads outside" if len(outside) == 1 else f"of {len(outside)} doors that lead outside"
    words = f"{chosen.id} of {room.id} ({room.type}) was taken as the main entrance: {others}"
    return replace(scene, rooms=(*scene.rooms[:k], entered, *scene.rooms[k + 1 :])), ChosenEntrance(chosen.id, room.id, words)


def _rank(room: Room, opening: Opening, catalogs: Catalogs) -> tuple[int, bool, int, float]:
    """Returns how far from a main entrance a door is: its storey, what it says of itself, its room's type, its width."""
    kind = catalogs.rooms.get(room.type)
    place = kind.plan.entrance if kind else None
    return abs(room.level), opening.connects_to is None, NOT_COME_IN_BY if place is None else place, -opening.width
