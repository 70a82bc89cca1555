"""Windows in the outside walls.

Comes in: the doors placed so far. Goes out: windows as `Cut`s beside them. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from catalogs.schema import RoomType
from solver.floorplan.doors import Cut, Doorways
from solver.floorplan.tiling import exterior_sides
from solver.geometry import Rect


@dataclass(frozen=True)
class Pane:
    """A size of window: width, height and sill, mm."""

    width: int
    height: int
    sill: int


PANE: Final = Pane(1200, 1400, 900)
"""The window of a living space."""
SMALL_PANE: Final = Pane(600, 600, 1400)
"""The window of a bathroom or laundry: a basin and a washer stand below it. Our choice."""
EDGE_MM: Final = 300
"""Least wall between a window and a room's corner. Our choice."""
TWO_MM: Final = 4200
"""Wall from which it may have two windows. Our choice."""
GLASS: Final = 0.25
"""Most glass per floor with which a wall gets its second window; daylight asks for an eighth. Our choice."""
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
        walls = list(exterior_sides(rect, doorways.layout.outline))
        two = _with_two(rect, walls) if kind.plan.habitable else []
        for wall in walls:
            for centre in _centres(doorways, room, wall, (width, 2 if wall in two else 1)):
                number += 1
                doorways.add(Cut(f"window_{number}", "window", room, wall, None, centre, width))


def _with_two(rect: Rect, walls: Sequence[str]) -> list[str]:
    """Returns the walls with two windows: long ones, the longest first, as far as the room's floor bears so much glass."""
    lengths = {wall: rect.along(wall)[1] - rect.along(wall)[0] for wall in walls}
    spare = int(GLASS * rect.width * rect.depth / (PANE.width * PANE.height)) - len(walls)
    long = sorted((wall for wall in walls if lengths[wall] >= TWO_MM), key=lambda wall: -lengths[wall])
    return long[: max(spare, 0)]


def _centres(doorways: Doorways, room: int, wall: str, panes: tuple[int, int]) -> list[int]:
    """Finds places for a wall's windows of a width and number, each in its own equal part of the wall."""
    low, high = doorways.layout.rooms[room].along(wall)
    width, parts = panes
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
