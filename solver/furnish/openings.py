"""A room's openings as the relations see them."""

from __future__ import annotations

from solver.furnish.ask import Opened
from solver.furnish.zones import line_of
from solver.geometry import to_mm
from solver.scene import Room


def openings_of(room: Room) -> tuple[Opened, ...]:
    """Returns the openings whose wall the room tells, as the relations see them."""
    found: list[Opened] = []
    for opening in room.openings:
        line = line_of(room, opening)
        if line is not None:
            wall, across, start, _ = line
            centre, half = start + to_mm(opening.position), to_mm(opening.width) // 2
            found.append(Opened(opening.kind, wall, (centre - half, centre + half), across))
    return tuple(found)
