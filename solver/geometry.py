"""Rectangles and directions on the millimetre lattice; no furniture words.

Comes in and goes out: integers (mm) and `Rect`. May import: nothing of ours.
"""

from __future__ import annotations

from typing import Final, NamedTuple

OPPOSITE: Final = {"north": "south", "south": "north", "east": "west", "west": "east"}
_WALLS_FACED: Final = ("south", "east", "north", "west")
_QUARTERS: Final = {"front": 0, "right": 1, "back": 2, "left": 3}
ROTATION_AT_WALL: Final = {"north": 0, "west": 90, "south": 180, "east": 270}
"""The rotation of a body whose back is to that wall: it faces away from it."""
WALL_BEHIND: Final = {rotation: wall for wall, rotation in ROTATION_AT_WALL.items()}
FACING: Final = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
"""Unit vector (x, z) of the front, by rotation."""


def to_mm(metres: float) -> int:
    """Rounds metres to the nearest integer millimetre."""
    return round(metres * 1000)


def to_m(millimetres: int) -> float:
    """Converts millimetres to metres with the shortest decimal."""
    return millimetres / 1000


def half_m(double_mm: int) -> float:
    """Converts a sum of two millimetre edges to the metres of their middle (at most 4 decimals)."""
    return double_mm / 2000


def turned(width: int, depth: int, rotation: int) -> tuple[int, int]:
    """Returns the extents along x and z of a width x depth footprint at a right-angled rotation."""
    return (depth, width) if rotation % 180 == 90 else (width, depth)


def rotate(across: int, along: int, rotation: int) -> tuple[int, int]:
    """Turns a vector from a body's frame (across = its +x side, along = its front) to the room's (x, z)."""
    dx, dz = FACING[rotation % 360]
    return dz * across + dx * along, dz * along - dx * across


def wall_faced(side: str, rotation: float) -> str:
    """Returns the wall that a side of a body looks to, at the right angle nearest to its rotation."""
    return _WALLS_FACED[(round(rotation / 90) + _QUARTERS[side]) % 4]


class Rect(NamedTuple):
    """An axis-aligned rectangle [x0, x1] x [z0, z1], mm."""

    x0: int
    z0: int
    x1: int
    z1: int

    @property
    def width(self) -> int:
        """Extent along x, mm."""
        return self.x1 - self.x0

    @property
    def depth(self) -> int:
        """Extent along z, mm."""
        return self.z1 - self.z0

    @property
    def area_m2(self) -> float:
        """Area, m2."""
        return self.width * self.depth / 1e6

    def shrunk(self, by: int) -> Rect:
        """Moves every edge inwards by that many mm."""
        return Rect(self.x0 + by, self.z0 + by, self.x1 - by, self.z1 - by)

    def overlaps(self, other: Rect) -> bool:
        """Tells whether the interiors meet (touching edges do not count)."""
        return self.x0 < other.x1 and other.x0 < self.x1 and self.z0 < other.z1 and other.z0 < self.z1

    def contains(self, other: Rect) -> bool:
        """Tells whether the other lies inside, edges included."""
        return self.x0 <= other.x0 and self.z0 <= other.z0 and other.x1 <= self.x1 and other.z1 <= self.z1

    def along(self, wall: str) -> tuple[int, int]:
        """Returns the interval a wall spans: along x for north and south, along z for east and west."""
        return (self.x0, self.x1) if wall in ("north", "south") else (self.z0, self.z1)


def strip(rect: Rect, wall: str, interval: tuple[int, int], depth: int) -> Rect:
    """Returns the rectangle that lies along a wall of `rect`, inside it, over an interval of that wall, `depth` deep."""
    a, b = interval
    return {
        "north": Rect(a, rect.z0, b, rect.z0 + depth),
        "south": Rect(a, rect.z1 - depth, b, rect.z1),
        "west": Rect(rect.x0, a, rect.x0 + depth, b),
        "east": Rect(rect.x1 - depth, a, rect.x1, b),
    }[wall]
