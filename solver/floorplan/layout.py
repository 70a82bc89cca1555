"""What every step of the floor plan speaks of: room rectangles, the walls they share, the sides that lie outside.

Comes in: rectangles of wall lines, mm. Goes out: `Layout`, `Joint`. May import: the ground floor.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from solver.geometry import Rect

HALLWAY_MM: Final = 1300
"""Width of a hallway between wall lines: 1.2 m clear between walls of 0.1 m (floorplan.md)."""
DOOR_WALL_MM: Final = 1100
"""Shortest shared wall that takes a door: a leaf of 0.9 m and a jamb of 0.1 m at each end (floorplan.md)."""


@dataclass(frozen=True, order=True)
class Joint:
    """A stretch of wall that two rooms share, at least DOOR_WALL_MM long.

    `a` < `b` are room indices, `wall` is the wall of `a`, `low` and `high` its ends along x (north, south) or z, mm.
    """

    a: int
    b: int
    wall: str
    low: int
    high: int

    @property
    def length(self) -> int:
        """Length of the shared wall, mm."""
        return self.high - self.low

    def other(self, room: int) -> int:
        """Returns the room on the other side."""
        return self.b if room == self.a else self.a


@dataclass(frozen=True)
class Layout:
    """Rectangles that tile the house: the first `hallways` of `rooms` are hallways.

    `behind` names, for a room off every hallway, the room it was planned to lie behind.
    """

    outline: Rect
    rooms: tuple[Rect, ...]
    hallways: int = 0
    behind: Mapping[int, int] = field(default_factory=dict)
    corridors: tuple[Mapping[str, Any], ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def spine(self) -> bool:
        """Tells whether the house has a hallway spine."""
        return self.hallways > 0


def exterior_sides(rect: Rect, outline: Rect) -> tuple[str, ...]:
    """Returns the walls of a room that lie on the house's outline, in the order of WALLS."""
    sides = []
    if rect.z0 == outline.z0:
        sides.append("north")
    if rect.z1 == outline.z1:
        sides.append("south")
    if rect.x1 == outline.x1:
        sides.append("east")
    if rect.x0 == outline.x0:
        sides.append("west")
    return tuple(sides)


def touching(rooms: tuple[Rect, ...]) -> list[tuple[int, int, str, int, int]]:
    """Returns every stretch of wall two rooms share as (a, b, wall of a, low, high), a < b, sorted."""
    found: list[tuple[int, int, str, int, int]] = []
    for horizontal in (True, False):
        starts: dict[int, list[int]] = defaultdict(list)
        for i, rect in enumerate(rooms):
            starts[rect.z0 if horizontal else rect.x0].append(i)
        for i, rect in enumerate(rooms):
            for j in starts.get(rect.z1 if horizontal else rect.x1, ()):
                span = _shared(rect, rooms[j], horizontal)
                if span[0] < span[1]:
                    found.append(_stretch(i, j, horizontal, span))
    return sorted(found)


def _shared(one: Rect, other: Rect, horizontal: bool) -> tuple[int, int]:
    if horizontal:
        return max(one.x0, other.x0), min(one.x1, other.x1)
    return max(one.z0, other.z0), min(one.z1, other.z1)


def _stretch(i: int, j: int, horizontal: bool, span: tuple[int, int]) -> tuple[int, int, str, int, int]:
    """Names the wall as room min(i, j) sees it, where i lies north or west of j."""
    wall = "south" if horizontal else "east"
    if i < j:
        return (i, j, wall, *span)
    return (j, i, "north" if horizontal else "west", *span)


def joints(rooms: tuple[Rect, ...]) -> tuple[Joint, ...]:
    """Returns the shared walls that are long enough for a door, sorted."""
    return tuple(Joint(*stretch) for stretch in touching(rooms) if stretch[4] - stretch[3] >= DOOR_WALL_MM)


def neighbours(count: int, shared: tuple[Joint, ...]) -> list[list[Joint]]:
    """Returns each room's joints, by room index."""
    by_room: list[list[Joint]] = [[] for _ in range(count)]
    for joint in shared:
        by_room[joint.a].append(joint)
        by_room[joint.b].append(joint)
    return by_room
