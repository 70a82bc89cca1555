"""What openings keep free: the squares of doors and passages, and the strips before windows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

from solver.validator.lattice import ExactBox, exact
from solver.validator.world import DOOR_KINDS, Hole, PlacedRoom, World

DOOR_DEPTH: Final = exact(0.9)
"""A door's square is as deep as the door is wide, at most this."""
WINDOW_DEPTH: Final = exact(0.5)
WINDOW_MARGIN: Final = exact(0.1)
"""What tall pieces leave free before a window, and beside it."""


class Square(NamedTuple):
    """Floor that a door needs, and the heights it needs there."""

    hole: Hole
    box: ExactBox


def squares(world: World, place: PlacedRoom) -> Iterator[Square]:
    """Returns the door squares in a room: of its own doors, and of those that only the other room lists."""
    for hole in place.holes:
        if hole.opening.kind in DOOR_KINDS:
            yield Square(hole, hole.edge.strip(hole.edge.start, hole.edge.end, _square_depth(hole)))
    own = {opening.id for opening in place.room.openings}
    for other, hole in world.leading_to.get(place.room.id, ()):
        if other is not place and hole.opening.id not in own and hole.opening.kind in DOOR_KINDS:
            box = hole.edge.strip(hole.edge.start, hole.edge.end, 0, outwards=_square_depth(hole))
            yield Square(hole, box.moved(other.x - place.x, other.z - place.z))


def _square_depth(hole: Hole) -> int:
    return min(hole.edge.end - hole.edge.start, DOOR_DEPTH)


def window_zone(hole: Hole) -> ExactBox:
    """Returns the strip before a window where nothing taller than its sill stands."""
    return hole.edge.strip(hole.edge.start - WINDOW_MARGIN, hole.edge.end + WINDOW_MARGIN, WINDOW_DEPTH)
