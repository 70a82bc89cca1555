"""Windows in the outside walls.

Comes in: the doors placed so far. Goes out: windows as `Cut`s beside them. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from catalogs.schema import RoomType
from solver.geometry import Rect
from tests.floorplan.reference.doors import Cut, Doorways, places


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
"""Most glass per floor with which a wall gets its second window. Our choice."""
DAYLIGHT: Final = 0.125
"""Least glass per floor of a living space, for which its windows are wider."""
WIDER_MM: Final = 600
WIDEST_MM: Final = 2400
SHIFT_MM: Final = 100
"""Step in which a window gives way to a door."""


def pane_of(kind: RoomType) -> Pane:
    """Returns the size of a room type's windows."""
    return SMALL_PANE if kind.plan.wet and not kind.plan.habitable else PANE


def place_windows(doorways: Doorways) -> None:
    """Gives every outside stretch of wall of a room that has no window yet one, or two where it is long; none overlaps a door."""
    number = sum(cut.kind == "window" for cut in doorways.cuts)
    for room, rect in enumerate(doorways.layout.rooms):
        kind = doorways.plan_of(room)
        if kind.outdoor or not kind.plan.windows or any(side.cut.kind == "window" for side in doorways.sides(room)):
            continue
        stretches = [(wall, stretch) for wall, exposed in doorways.layout.openable[room].items() for stretch in exposed]
        two = _with_two(rect, stretches) if kind.plan.habitable else []
        wished = _wished_width(rect, stretches, len(two)) if kind.plan.habitable else pane_of(kind).width
        for wall, stretch in stretches:
            parts = 2 if (wall, stretch) in two else 1
            for part in range(parts):
                for width in range(wished, min(wished, PANE.width) - 1, -WIDER_MM):
                    centre = _centre(doorways, (room, wall), stretch, (width, part, parts))
                    if centre is not None:
                        number += 1
                        doorways.add(Cut(f"window_{number}", "window", room, wall, None, centre, width))
                        break


def make_room_for_windows(doorways: Doorways) -> None:
    """Moves an outside door along its wall where a habitable room has no window for it, and places that; no door meets more than it did."""
    for room in range(len(doorways.layout.rooms)):
        kind = doorways.plan_of(room)
        doors = [side.cut for side in doorways.sides(room) if side.cut.other is None]
        if not kind.plan.habitable or not kind.plan.windows or kind.outdoor or any(cut.kind == "window" for cut in doors):
            continue
        for cut in doors:
            stretch = next(one for one in doorways.layout.openable[room][cut.wall] if one[0] <= cut.centre <= one[1])
            if any(_makes_room(doorways, cut, cut.at(centre)) for centre in places(cut.width, stretch, doorways)):
                break


def _makes_room(doorways: Doorways, cut: Cut, moved: Cut) -> bool:
    """Moves a door and places the room's windows; False, and nothing changed, where there is none."""
    if doorways.score(moved) > doorways.score(cut):
        return False
    before = len(doorways.cuts)
    doorways.replace(cut, moved)
    place_windows(doorways)
    if len(doorways.cuts) == before:
        doorways.replace(moved, cut)
        return False
    return True


Outside = tuple[str, tuple[int, int]]
"""A wall and a stretch of it that lies outside, mm in the house."""


def _with_two(rect: Rect, outside: Sequence[Outside]) -> list[Outside]:
    """Returns the stretches with two windows: long ones, the longest first, as far as the room's floor bears so much glass."""
    with_one = sum(high - low >= PANE.width + 2 * EDGE_MM for _, (low, high) in outside)
    spare = int(GLASS * rect.width * rect.depth / (PANE.width * PANE.height)) - with_one
    long = sorted((one for one in outside if one[1][1] - one[1][0] >= TWO_MM), key=lambda one: one[1][0] - one[1][1])
    return long[: max(spare, 0)]


def _wished_width(rect: Rect, outside: Sequence[Outside], doubled: int) -> int:
    """Returns the least width with which the windows of a living space have glass for an eighth of its floor, or the widest."""
    windows = doubled + sum(high - low >= PANE.width + 2 * EDGE_MM for _, (low, high) in outside)
    wanted = DAYLIGHT * rect.width * rect.depth
    return next((width for width in range(PANE.width, WIDEST_MM, WIDER_MM) if windows * width * PANE.height >= wanted), WIDEST_MM)


def _centre(doorways: Doorways, at: tuple[int, str], stretch: tuple[int, int], pane: tuple[int, int, int]) -> int | None:
    """Finds the place for a window of a width in one of the equal parts of a stretch of a room's wall."""
    (room, wall), (low, high), (width, part, parts) = at, stretch, pane
    start, end = low + (high - low) * part // parts, low + (high - low) * (part + 1) // parts
    inner = max(start, low + EDGE_MM) + width // 2, min(end, high - EDGE_MM) - width // 2
    free = (centre for centre in _tried((start + end) // 2, inner) if doorways.free(room, wall, centre - width // 2, centre + width // 2))
    return next(free, None)


def _tried(middle: int, inner: tuple[int, int]) -> Iterator[int]:
    """Yields places in the interval, ever farther from the middle."""
    for shift in range(0, max(inner[1] - middle, middle - inner[0]) + 1, SHIFT_MM):
        for centre in (middle + shift, middle - shift):
            if inner[0] <= centre <= inner[1]:
                yield centre
