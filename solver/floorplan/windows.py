"""Windows in the outside walls.

Comes in: the doors placed so far. Goes out: windows as `Cut`s beside them. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from catalogs.schema import RoomType
from solver.floorplan.doors import Cut, Doorways
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
        width = pane_of(kind).width
        for wall in exterior_sides(rect, doorways.layout.outline):
            for centre in _centres(doorways, room, wall, width):
                number += 1
                doorways.add(Cut(f"window_{number}", "window", room, wall, None, centre, width))


def _centres(doorways: Doorways, room: int, wall: str, width: int) -> list[int]:
    """Finds places for a wall's windows, each in its own equal part of the wall."""
    low, high = doorways.layout.rooms[room].along(wall)
    parts = 2 if high - low >= TWO_MM and width == PANE.width else 1
    found = []
    for k in range(parts):
        start, end = low + (high - low) * k // parts, low + (high - low) * (k + 1) // parts
        inner = max(start, low + EDGE_MM) + width // 2, min(end, high - EDGE_MM) - width // 2
        for centre in _tried((start + end) // 2, inner):
            if doorways.free(room, wall, centre - width // 2, centre + width // 2):
                found.append(centre)
                break
    return found


def _tried(middle: int, inner: tuple[int, int]) -> Iterator[int]:
    """Yields places in the interval, ever farther from the middle."""
    for shift in range(0, max(inner[1] - middle, middle - inner[0]) + 1, SHIFT_MM):
        for centre in (middle + shift, middle - shift):
            if inner[0] <= centre <= inner[1]:
                yield centre
