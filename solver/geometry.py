"""Rectangles and directions on the millimetre lattice; no furniture words.

Comes in and goes out: integers (mm) and `Rect`.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from typing import Final, NamedTuple, TypeVar

Number = TypeVar("Number", int, float)
Corner = TypeVar("Corner")

OPPOSITE: Final = {"north": "south", "south": "north", "east": "west", "west": "east"}
ALONG_X: Final = ("north", "south")
"""Walls that run along x; the others run along z."""
INWARDS: Final = {"north": 1, "west": 1, "south": -1, "east": -1}
"""Which way along its other axis a wall's room lies."""
_WALLS_FACED: Final = ("south", "east", "north", "west")
EDGES: Final = {"north": 1, "south": 3, "east": 2, "west": 0}
"""Which number of a rectangle says where its edge at a wall lies, in the order of the scene's WALLS."""
_QUARTERS: Final = {"front": 0, "right": 1, "back": 2, "left": 3}
ROTATION_AT_WALL: Final = {"north": 0, "west": 90, "south": 180, "east": 270}
"""The rotation of a body whose back is to that wall: it faces away from it."""
WALL_BEHIND: Final = {rotation: wall for wall, rotation in ROTATION_AT_WALL.items()}
LEAST_FLOOR_MM2: Final = 250_000
"""Free centres that a room must have for who walks (docs/scene.md); the core's is in solver/core/plain/least_floor.hpp."""
FACING: Final = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
"""Unit vector (x, z) of the front, by rotation."""


def to_mm(metres: float) -> int:
    """Rounds metres to the nearest integer millimetre."""
    return round(metres * 1000)


def to_m(millimetres: int) -> float:
    """Converts millimetres to metres with the shortest decimal."""
    return millimetres / 1000


def square_metres(area: float) -> str:
    """Writes an area, m2, to a tenth; half a tenth is more, whatever a sum of parts made of its last digits."""
    return f"{area + 1e-7:.1f} m²"


def half_m(double_mm: int) -> float:
    """Converts a sum of two millimetre edges to the metres of their middle (at most 4 decimals)."""
    return double_mm / 2000


def turned(width: int, depth: int, rotation: int) -> tuple[int, int]:
    """Returns the extents along x and z of a width x depth footprint at a right-angled rotation."""
    return (depth, width) if rotation % 180 == 90 else (width, depth)


def rotate(across: Number, along: Number, rotation: int) -> tuple[Number, Number]:
    """Turns a vector from a body's frame (across = its +x side, along = its front) to the room's (x, z)."""
    dx, dz = FACING[rotation % 360]
    return dz * across + dx * along, dz * along - dx * across


def turned_by(x: float, z: float, turn: float) -> tuple[float, float]:
    """Returns a vector from the frame of something that is turned, degrees about +y, in the frame around that."""
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return x * cosine + z * sine, z * cosine - x * sine


def turned_back(x: float, z: float, turn: float) -> tuple[float, float]:
    """Returns a vector in the frame of something that is turned, degrees about +y, from the frame around that."""
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return x * cosine - z * sine, x * sine + z * cosine


def extents(width: float, depth: float, rotation: float) -> tuple[float, float]:
    """Returns the extents along x and z of a footprint's bounding rectangle at any rotation; exact at right angles."""
    if rotation % 90 == 0:
        return (depth, width) if rotation % 180 else (width, depth)
    angle = math.radians(rotation % 180)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    return width * c + depth * s, width * s + depth * c


def doubled_area(corners: Sequence[tuple[float, float]]) -> float:
    """Returns twice the area within corners (x, z), in squares of their unit: positive where they go clockwise seen from above."""
    return sum(x * next_z - z * next_x for (x, z), (next_x, next_z) in edges_round(corners))


def encloses(corners: Sequence[tuple[float, float]], x: float, z: float) -> bool:
    """Tells whether a point lies within an outline."""
    inside = False
    for (x0, z0), (x1, z1) in edges_round(corners):
        if (z0 > z) != (z1 > z) and x < x0 + (z - z0) / (z1 - z0) * (x1 - x0):
            inside = not inside
    return inside


def edges_round(corners: Sequence[Corner]) -> Iterator[tuple[Corner, Corner]]:
    """Returns the edges between corners, each as its two ends, the last of which leads back to the first corner."""
    return zip(corners, (*corners[1:], *corners[:1]), strict=True)


def walls_round(corners: Sequence[tuple[Number, Number]]) -> Iterator[tuple[str, Number, Number, Number]]:
    """Yields each edge between corners, whichever way these go round: the wall that it is, its line across itself, from where to where."""
    clockwise = doubled_area(corners) >= 0
    for (x0, z0), (x1, z1) in edges_round(corners):
        if abs(x1 - x0) >= abs(z1 - z0):
            yield "north" if (x1 > x0) == clockwise else "south", z0, min(x0, x1), max(x0, x1)
        else:
            yield "east" if (z1 > z0) == clockwise else "west", x0, min(z0, z1), max(z0, z1)


def walls_beside(wall: str) -> tuple[str, str]:
    """Returns the two walls that meet a wall: at its west or north end, then at its other end."""
    return ("west", "east") if wall in ALONG_X else ("north", "south")


def wall_turned(wall: str, turn: int) -> str:
    """Returns the wall that a wall becomes when the room is turned by right angles."""
    return WALL_BEHIND[(ROTATION_AT_WALL[wall] + turn) % 360]


def wall_faced(side: str, rotation: float) -> str:
    """Returns the wall that a side of a body looks to, at the right angle nearest to its rotation."""
    return _WALLS_FACED[(round(rotation / 90) + _QUARTERS[side]) % 4]


def outwards(side: str, rotation: int) -> tuple[int, int]:
    """Returns the unit vector (x, z) that a side of a body looks along, at a right-angled rotation."""
    return FACING[(rotation + 90 * _QUARTERS[side]) % 360]


class Rect(NamedTuple):
    """An axis-aligned rectangle [x0, x1] x [z0, z1], mm."""

    x0: int
    z0: int
    x1: int
    z1: int

    @classmethod
    def around(cls, centre: tuple[int, int], extent: tuple[int, int]) -> Rect:
        """Returns the rectangle of some extents along x and z around a centre; an odd extent's half is rounded down."""
        x0, z0 = centre[0] - extent[0] // 2, centre[1] - extent[1] // 2
        return cls(x0, z0, x0 + extent[0], z0 + extent[1])

    @property
    def centre(self) -> tuple[int, int]:
        """Its middle (x, z), mm, rounded down."""
        return (self.x0 + self.x1) // 2, (self.z0 + self.z1) // 2

    @property
    def width(self) -> int:
        """Extent along x, mm."""
        return self.x1 - self.x0

    @property
    def depth(self) -> int:
        """Extent along z, mm."""
        return self.z1 - self.z0

    def span(self, axis: int) -> tuple[int, int]:
        """Returns the interval it covers along an axis: 0 for x, 1 for z."""
        return self[axis], self[axis + 2]

    @property
    def area_m2(self) -> float:
        """Area, m2."""
        return self.width * self.depth / 1e6

    def shrunk(self, by: int) -> Rect:
        """Moves every edge inwards by that many mm."""
        return Rect(self.x0 + by, self.z0 + by, self.x1 - by, self.z1 - by)

    def moved(self, dx: int, dz: int) -> Rect:
        """Shifts the rectangle."""
        return Rect(self.x0 + dx, self.z0 + dz, self.x1 + dx, self.z1 + dz)

    def common(self, other: Rect) -> Rect:
        """Returns what both cover; its extents are negative where they lie apart."""
        return Rect(max(self.x0, other.x0), max(self.z0, other.z0), min(self.x1, other.x1), min(self.z1, other.z1))

    def overlaps(self, other: Rect) -> bool:
        """Tells whether the interiors meet (touching edges do not count)."""
        return self.x0 < other.x1 and other.x0 < self.x1 and self.z0 < other.z1 and other.z0 < self.z1

    def contains(self, other: Rect) -> bool:
        """Tells whether the other lies inside, edges included."""
        return self.x0 <= other.x0 and self.z0 <= other.z0 and other.x1 <= self.x1 and other.z1 <= self.z1

    def along(self, wall: str) -> tuple[int, int]:
        """Returns the interval a wall spans: along x for north and south, along z for east and west."""
        return (self.x0, self.x1) if wall in ALONG_X else (self.z0, self.z1)

    def line(self, wall: str) -> int:
        """Returns where the edge at a wall lies: its z for north and south, its x for east and west."""
        return self[EDGES[wall]]

    def wall_distance(self, wall: str, room: Rect) -> int:
        """Returns how far the edge at a wall is from that wall of a room's rectangle; negative beyond it."""
        return (self.line(wall) - room.line(wall)) * INWARDS[wall]

    def distance_to(self, other: Rect) -> float:
        """Returns the free distance to another rectangle; 0 where they touch or overlap."""
        return math.hypot(max(self.x0 - other.x1, other.x0 - self.x1, 0), max(self.z0 - other.z1, other.z0 - self.z1, 0))


def strip(rect: Rect, wall: str, interval: tuple[int, int], depth: int) -> Rect:
    """Returns the rectangle that lies along a wall of `rect`, inside it, over an interval of that wall, `depth` deep."""
    return strip_at(wall, rect.line(wall), interval, depth)


def strip_at(wall: str, line: int, interval: tuple[int, int], depth: int) -> Rect:
    """Returns the rectangle over an interval of a wall whose line is given, `depth` deep into its room."""
    inner = line + INWARDS[wall] * depth
    low, high = (line, inner) if line < inner else (inner, line)
    return Rect(interval[0], low, interval[1], high) if wall in ALONG_X else Rect(low, interval[0], high, interval[1])


def bounds_of_points(points: Sequence[tuple[float, float]]) -> tuple[float, float, float, float]:
    """Returns the least and the largest x and z of points: west, north, east, south."""
    xs, zs = zip(*points, strict=True)
    return min(xs), min(zs), max(xs), max(zs)


def gaps_between(whole: tuple[Number, Number], blocked: Iterable[tuple[Number, Number]]) -> list[tuple[Number, Number]]:
    """Returns what intervals leave free of a whole interval, from its low end up."""
    at, high = whole
    free: list[tuple[Number, Number]] = []
    for start, end in sorted(blocked):
        if start > at:
            free.append((at, min(start, high)))
        at = max(at, end)
    free.append((at, high))
    return [(start, end) for start, end in free if start < end]


FloorRectangle = tuple[float, float, float, float]
"""West, north, east, south: x0, z0, x1, z1 in the house, m."""


def rectangles_of(corners: Sequence[tuple[float, float]]) -> list[FloorRectangle]:
    """Returns rectangles that tile what an outline encloses, from north to south, each as deep as it can be."""
    return tiles_between((a[0], a[1], b[1]) for a, b in edges_round(corners) if a[0] == b[0])


def tiles_between(lines: Iterable[tuple[Number, Number, Number]]) -> list[tuple[Number, Number, Number, Number]]:
    """Returns rectangles (x0, z0, x1, z1) that tile what lies between lines along z, from the first to the second, the third to the fourth.

    They come from north to south, each as deep as it can be. A line is its x, and the z of its ends; two that lie on each other are none.
    """
    turning = defaultdict[Number, set[Number]](set)
    for x, start, end in lines:
        turning[start] ^= {x}
        turning[end] ^= {x}
    done: list[tuple[Number, Number, Number, Number]] = []
    growing, crossed = dict[tuple[Number, Number], Number](), set[Number]()
    for z in sorted(turning):
        crossed ^= turning[z]
        ordered = sorted(crossed)
        spans = set(zip(ordered[::2], ordered[1::2], strict=False))
        done += [(west, growing.pop((west, east)), east, z) for west, east in sorted(growing.keys() - spans)]
        growing |= dict.fromkeys(spans - growing.keys(), z)
    return done
