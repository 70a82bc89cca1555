"""Where can a square person's centre come to in one room? Exact in integers, by parts of a grid.

The centre is free where the open square meets no solid and no wall: the plane less *open* rectangles, so that a gap of
exactly the person's size lets it through. Every axis is cut at all edges into points and the open intervals between them;
a product of two such pieces is wholly free or wholly taken, and two neighbours touch where one lies in the other's closure.
What can be come to from one another is one part.
Lengths are doubled millimetres, so that half a person is an integer.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence

import numpy as np
from scipy import ndimage

from solver.geometry import Rect
from solver.pieces import Doorway, Space

CROSS = ndimage.generate_binary_structure(2, 1)
"""Pieces hang together that have an edge in common."""


class Flood:
    """The free floor of a room.

    Args:
        space: its clear rectangle, its missing parts (zones with cause `outline`) and the person's size.
        solids: footprints of all that stands in the way, mm.
        marks: rectangles, mm, whose edges will be asked about.
    """

    def __init__(self, space: Space, solids: Sequence[Rect], marks: Sequence[Rect] = ()) -> None:
        self.half = space.robot_mm
        clear = space.clear
        self.domain = (2 * clear.x0 + self.half, 2 * clear.z0 + self.half, 2 * clear.x1 - self.half, 2 * clear.z1 - self.half)
        walls = [zone.rect for zone in space.zones if zone.cause == "outline"]
        taken = [self._grown(rect) for rect in (*solids, *walls)]
        edges = [*taken, *(self._grown(rect) for rect in marks), *((2 * r.x0, 2 * r.z0, 2 * r.x1, 2 * r.z1) for r in marks)]
        self.cuts = tuple(self._cut(axis, edges) for axis in (0, 1))
        free = np.ones([2 * len(cuts) - 1 for cuts in self.cuts], dtype=bool)
        for x0, z0, x1, z1 in map(self._inner, taken):
            free[x0:x1, z0:z1] = False
        self.parts, _ = ndimage.label(free, CROSS)
        """By piece along x and z: the number of its part, 0 where it is taken."""

    def _grown(self, rect: Rect) -> tuple[int, int, int, int]:
        return 2 * rect.x0 - self.half, 2 * rect.z0 - self.half, 2 * rect.x1 + self.half, 2 * rect.z1 + self.half

    def _cut(self, axis: int, rects: Iterable[tuple[int, int, int, int]]) -> list[int]:
        low, high = self.domain[axis], self.domain[axis + 2]
        return sorted({low, high, *(edge for rect in rects for edge in (rect[axis], rect[axis + 2]) if low < edge < high)})

    def _inner(self, rect: tuple[int, int, int, int]) -> tuple[int, int, int, int]:
        """Returns the pieces that lie in an open rectangle, first and past the last: even pieces are points."""
        (x0, x1), (z0, z1) = ((self._after(axis, rect[axis]), self._before(axis, rect[axis + 2])) for axis in (0, 1))
        return x0, z0, x1, z1

    def _after(self, axis: int, edge: int) -> int:
        """Returns the first piece right of an edge."""
        cuts = self.cuts[axis]
        return 0 if edge < cuts[0] else 2 * (bisect_right(cuts, edge) - 1) + 1

    def _before(self, axis: int, edge: int) -> int:
        """Returns one past the last piece left of an edge."""
        cuts = self.cuts[axis]
        return 2 * len(cuts) - 1 if edge > cuts[-1] else 2 * bisect_left(cuts, edge)

    def line(self, rect: tuple[int, int, int, int]) -> list[int]:
        """Returns the parts that a closed rectangle of doubled mm (x0, z0, x1, z1), or a segment, meets, from west to east."""
        if self.domain[0] > self.domain[2] or self.domain[1] > self.domain[3]:
            return []
        ranges = []
        for axis in (0, 1):
            cuts, low, high = self.cuts[axis], rect[axis], rect[axis + 2]
            if high < cuts[0] or low > cuts[-1]:
                return []
            first = 2 * bisect_left(cuts, low) - (0 if low in cuts or low < cuts[0] else 1)
            last = 2 * (bisect_right(cuts, high) - 1) + (0 if high in cuts or high > cuts[-1] else 1)
            ranges.append(slice(first, last + 1))
        return [part for part in dict.fromkeys(self.parts[tuple(ranges)].ravel().tolist()) if part]

    def area(self, part: int) -> float:
        """Returns the area of a part, m2: of its pieces that are open intervals along both axes."""
        sizes = np.outer(*(np.diff(cuts) for cuts in self.cuts))
        return float(sizes[self.parts[1::2, 1::2] == part].sum()) / 4e6


def entry(space: Space, door: Doorway) -> tuple[int, int, int, int]:
    """Returns where the centre is when the person has just come through a door, doubled mm."""
    clear, half = space.clear, space.robot_mm
    a, b = door.square.along(door.wall)
    low, high = clear.along(door.wall)
    a, b = 2 * max(a, low) + half, 2 * min(b, high) - half
    if door.wall in ("north", "south"):
        z = 2 * max(clear.z0, door.square.z0) + half if door.wall == "north" else 2 * min(clear.z1, door.square.z1) - half
        return a, z, b, z
    x = 2 * max(clear.x0, door.square.x0) + half if door.wall == "west" else 2 * min(clear.x1, door.square.x1) - half
    return x, a, x, b


def contact(body: Rect, wall: str, person: int) -> tuple[int, int, int, int]:
    """Returns where the centre is while the person touches the side of a body that looks at a wall, doubled mm."""
    x0, z0, x1, z1 = 2 * body.x0, 2 * body.z0, 2 * body.x1, 2 * body.z1
    return {
        "north": (x0, z0 - person, x1, z0 - person),
        "south": (x0, z1 + person, x1, z1 + person),
        "west": (x0 - person, z0, x0 - person, z1),
        "east": (x1 + person, z0, x1 + person, z1),
    }[wall]


FLOOR = "the room"
"""What `missed` says where the person can come to less than LEAST_M2 of free centres."""
LEAST_M2 = 0.25
TURNED = ("south", "east", "north", "west")


def side_towards(side: str, rotation: int) -> str:
    """Returns the wall that a side of a body looks at: at rotation 0 the front looks south, a quarter turn later east."""
    quarter = {"front": 0, "right": 1, "back": 2, "left": 3}[side]
    return TURNED[(quarter + rotation // 90) % 4]


def missed(space: Space, solids: Sequence[Rect], uses: Sequence[tuple[str, Rect, Sequence[str], bool]]) -> list[str]:
    """Lists what cannot be come to from the outside, else from the first door (without doors: from the part where least is missed).

    What meets a door that leads outside is one part.

    Args:
        space: the room.
        solids: what stands in the way.
        uses: label, footprint, the walls its use sides look at, and whether all of them are needed.

    Returns:
        Ids of doors and labels of uses, and FLOOR; empty where all are joined.
    """
    flood = Flood(space, solids, [rect for _, rect, _, _ in uses] + [door.square for door in space.doorways])
    goals: list[tuple[str, list[list[int]], bool]] = []
    outer = [flood.line(entry(space, door)) for door in space.doorways if door.walked == "in"]
    if outer:
        joined = {part for line in outer for part in line}
        flood.parts[np.isin(flood.parts, list(joined))] = min(joined, default=0)
        goals.append(("outside", [[min(joined)]] if joined else [[]], False))
    goals += [(door.id, [flood.line(entry(space, door))], True) for door in space.doorways if door.walked == "through"]
    for label, rect, walls, need_all in uses:
        goals.append((label, [flood.line(contact(rect, wall, space.robot_mm)) for wall in walls], need_all))
    if not goals:
        return []
    starts = goals[0][1] if any(door.walked != "not" for door in space.doorways) else [parts for _, sides, _ in goals for parts in sides]
    best: list[str] | None = None
    for part in dict.fromkeys(part for parts in starts for part in parts):
        short = [name for name, sides, need_all in goals if not _met(sides, need_all, part)]
        short += [FLOOR] if flood.area(part) < LEAST_M2 else []
        if best is None or len(short) < len(best):
            best = short
    return [name for name, _, _ in goals] if best is None else best


def _met(sides: Sequence[Sequence[int]], need_all: bool, part: int) -> bool:
    met = [part in side for side in sides]
    return all(met) if need_all else any(met)
