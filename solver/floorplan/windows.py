"""Windows in the outside walls.

Comes in: the doors placed so far. Goes out: windows as `Cut`s beside them. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from catalogs.schema import RoomType
from solver.floorplan.doors import COLLISION, Cut, Doorways
from solver.floorplan.layout import exterior_sides


@dataclass(frozen=True)
class Pane:
    """A size of window: width, height and sill, mm."""

    width: int
    height: int
    sill: int


PANE: Final = Pane(1200, 1400, 900)
"""The window of a living space (the predecessor's 6.3)."""
SMALL_PANE: Final = Pane(600, 600, 1400)
"""The window of a bathroom or laundry: a basin and a washer stand below it. Our choice."""
EDGE_MM: Final = 300
"""Least wall between a window and a room's corner. Our choice."""
TWO_MM: Final = 4200
"""Wall from which it has two windows. Our choice."""
SHIFT_MM: Final = 100
"""Step in which a window gives way to a door."""


def pane_of(kind: RoomType) -> Pane:
    """Returns the size of a room type's windows."""
    return SMALL_PANE if kind.plan.wet and not kind.plan.habitable else PANE


def place_windows(doorways: Doorways) -> None:
    """Gives every outside wall of a room with windows one, or two where it is long; none overlaps a door."""
    number = 0
    for room, rect in enumerate(doorways.layout.rooms):
        kind = doorways.plan_of(room)
        if kind.outdoor or not kind.plan.windows:
            continue
        for wall in exterior_sides(rect, doorways.layout.outline):
            for window in _windows(doorways, room, wall):
                number += 1
                doorways.add(replace(window, id=f"window_{number}"))


def _windows(doorways: Doorways, room: int, wall: str) -> list[Cut]:
    """Finds places for a wall's windows, each in its own equal part of the wall."""
    low, high = doorways.layout.rooms[room].along(wall)
    width = pane_of(doorways.plan_of(room)).width
    parts = 2 if high - low >= TWO_MM and width == PANE.width else 1
    found = []
    for k in range(parts):
        part = low + (high - low) * k // parts, low + (high - low) * (k + 1) // parts
        inner = max(part[0], low + EDGE_MM), min(part[1], high - EDGE_MM)
        window = _fitted(doorways, Cut("window", "window", room, wall, None, sum(part) // 2, width), inner)
        if window is not None:
            found.append(window)
    return found


def _fitted(doorways: Doorways, window: Cut, part: tuple[int, int]) -> Cut | None:
    """Shifts a window away from the middle of its part until it is clear of doors."""
    reach = (part[1] - part[0] - window.width) // 2
    for shift in range(0, reach + 1, SHIFT_MM):
        for centre in (window.centre + shift, window.centre - shift):
            moved = replace(window, centre=centre)
            if part[0] <= moved.ends[0] and moved.ends[1] <= part[1] and doorways.score(moved) < COLLISION:
                return moved
    return None
