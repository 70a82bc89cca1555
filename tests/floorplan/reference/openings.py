"""All openings of a house, in the order in which they are placed; and where else one of them could stand."""

from __future__ import annotations

from collections.abc import Sequence

from solver.floorplan import openings
from solver.floorplan.openings import OpenedHouse
from solver.floorplan.tiling import Joint
from tests.floorplan.reference.doors import (
    CROWDED,
    STEP_MM,
    Cut,
    Doorways,
    move_to_corners,
    place_doors,
    place_entrance,
    place_garage_doors,
    places,
)
from tests.floorplan.reference.kept_walls import keep_walls
from tests.floorplan.reference.windows import make_room_for_windows, place_windows


def open_walls(house: OpenedHouse, tree: Sequence[tuple[Joint, int]], entrance: tuple[int, str]) -> tuple[tuple[Cut, ...], tuple[str, ...]]:
    """Returns the openings, and a note for each garage without a door."""
    doorways = Doorways(house.layout, house.types, house.rooms, profile=house.profile)
    place_entrance(doorways, *entrance)
    place_doors(doorways, tree)
    move_to_corners(doorways, tree, entrance[0])
    notes = place_garage_doors(doorways)
    place_windows(doorways)
    keep_walls(doorways, tuple(joint for joint, _ in tree))
    place_windows(doorways)
    make_room_for_windows(doorways)
    return tuple(doorways.cuts), notes


def door_places(house: OpenedHouse, shared: Sequence[Joint], cuts: Sequence[openings.Cut], moved: openings.Cut) -> tuple[int, ...]:
    """Returns where else an opening could stand, what differs most first."""
    doorways = Doorways(house.layout, house.types, house.rooms, [_cut(cut) for cut in cuts], house.profile)
    if moved.other is None:
        stretch = next(one for one in house.layout.openable[moved.room][moved.wall] if one[0] <= moved.centre <= one[1])
    else:
        stretch = next((joint.low, joint.high) for joint in shared if (joint.a, joint.b) == tuple(sorted(moved.sides)))
    centres = list(places(moved.width, stretch, doorways))
    if not centres:
        return ()
    low, high = min(centres), max(centres)
    quarter = (high - low) // 4 // STEP_MM * STEP_MM
    order = dict.fromkeys((low, high, low + quarter, high - quarter, *centres))
    return tuple(at for at in order if at != moved.centre and doorways.score(_cut(moved).at(at)) < CROWDED)


def _cut(cut: openings.Cut) -> Cut:
    return Cut(cut.id, cut.kind, cut.room, cut.wall, cut.other, cut.centre, cut.width, cut.leaf, cut.main)
