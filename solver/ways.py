"""Does everything in a room stay within reach while somebody is there? Exact, on a grid cut at every edge.

Comes in: a room's free rectangle, its doorways, what stands in it and what has to be reached. Goes out: yes or no. May import:
the ground floor.

A square person's centre is free where the open square meets neither body nor wall. Lengths are quarter millimetres and the
person is half a millimetre narrower than said, so that gaps of exactly its width let it through and cells are open sets. A row
of cells is one integer, so that a flood goes through it with a few shifts.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from solver.geometry import Rect
from solver.wanted import Doorway, Space

PER_MM: Final = 4
"""Lattice steps in a millimetre."""
LEAST_FLOOR: Final = (1000 * PER_MM) ** 2 // 4
"""Free centres that a room needs: 0.25 m2 (contract, rule unreachable), in square lattice steps."""


HEADROOM: Final = 2.0
"""What hangs higher is walked under, m: the height of a door."""
EVERY_SIDE: Final = ("north", "south", "west", "east")


@dataclass(frozen=True)
class Goal:
    """Something to come to: a body's footprint, mm, and the walls its sides look to; any of them, or `all`."""

    rect: Rect
    sides: tuple[str, ...]
    need_all: bool = False


class Ways:
    """What a room must keep within reach of each other: its doors and the use sides of its furniture.

    Args:
        space: its clear rectangle, missing corners, doorways and the width of who walks.
        bodies: footprints of what stands in the way, mm.
        goals: use sides.
    """

    def __init__(self, space: Space, bodies: Iterable[Rect], goals: Iterable[Goal]) -> None:
        self.space, self.goals = space, tuple(goals)
        self.reach = space.robot_mm * PER_MM // 2 - 1
        missing = [zone.rect for zone in space.zones if zone.cause == "outline"]
        self.taken = [self._grown(rect) for rect in (*bodies, *missing)]
        self.domain = _scaled(space.clear).shrunk(self.reach)

    def open(self, more: Sequence[Rect] = (), also: Sequence[Goal] = ()) -> bool:
        """Tells whether one patch of free floor meets every door and every goal, and is 0.25 m2 of centres.

        Args:
            more: bodies besides those of the room, mm.
            also: goals besides its own.
        """
        if self.domain.width <= 0 or self.domain.depth <= 0:
            return False
        cells = _Cells(self.domain, [*self.taken, *(self._grown(rect) for rect in more)])
        return any(self._serves(cells, patch, also) for patch in cells.patches())

    def harmless(self, rect: Rect, more: Sequence[Rect] = ()) -> bool:
        """Tells whether the floor that a body takes is no more than another takes already: one of the room's, or of `more`."""
        grown, floor = self._grown(rect), self.domain
        cut = Rect(max(grown.x0, floor.x0), max(grown.z0, floor.z0), min(grown.x1, floor.x1), min(grown.z1, floor.z1))
        return cut.width <= 0 or cut.depth <= 0 or any(taken.contains(cut) for taken in (*self.taken, *map(self._grown, more)))

    def _serves(self, cells: _Cells, patch: Sequence[int], also: Sequence[Goal]) -> bool:
        """Tells whether a patch of floor is large enough and meets every door and every goal."""
        if not all(cells.touches(patch, self._entry(door)) for door in self.space.doorways):
            return False
        for goal in (*self.goals, *also):
            sides = (cells.touches(patch, self._contact(goal.rect, side)) for side in goal.sides)
            if not (all if goal.need_all else any)(sides):
                return False
        return cells.has_area(patch, LEAST_FLOOR)

    def _grown(self, rect: Rect) -> Rect:
        return _scaled(rect).shrunk(-self.reach)

    def _entry(self, door: Doorway) -> Rect:
        """Returns where the centre is when somebody has just come through a door."""
        a, b = (PER_MM * end for end in door.square.along(door.wall))
        low, high = a + self.reach, b - self.reach
        domain = self.domain
        return {
            "north": Rect(low, domain.z0, high, domain.z0 + 1),
            "south": Rect(low, domain.z1 - 1, high, domain.z1),
            "west": Rect(domain.x0, low, domain.x0 + 1, high),
            "east": Rect(domain.x1 - 1, low, domain.x1, high),
        }[door.wall]

    def _contact(self, rect: Rect, side: str) -> Rect:
        """Returns where the centre is while somebody touches that side of a body."""
        body, step = _scaled(rect), self.reach + 1
        return {
            "north": Rect(body.x0, body.z0 - step, body.x1, body.z0 - self.reach),
            "south": Rect(body.x0, body.z1 + self.reach, body.x1, body.z1 + step),
            "west": Rect(body.x0 - step, body.z0, body.x0 - self.reach, body.z1),
            "east": Rect(body.x1 + self.reach, body.z0, body.x1 + step, body.z1),
        }[side]


def _scaled(rect: Rect) -> Rect:
    return Rect(PER_MM * rect.x0, PER_MM * rect.z0, PER_MM * rect.x1, PER_MM * rect.z1)


class _Cells:
    """The cells between the edges of what is taken; row k spans zs[k] to zs[k + 1], bit j of it xs[j] to xs[j + 1]."""

    def __init__(self, floor: Rect, taken: Sequence[Rect]) -> None:
        inside = [rect for rect in taken if rect.overlaps(floor)]
        self.xs = sorted({floor.x0, floor.x1, *(v for r in inside for v in (r.x0, r.x1) if floor.x0 < v < floor.x1)})
        self.zs = sorted({floor.z0, floor.z1, *(v for r in inside for v in (r.z0, r.z1) if floor.z0 < v < floor.z1)})
        self.free = [(1 << (len(self.xs) - 1)) - 1] * (len(self.zs) - 1)
        for rect in inside:
            bits, rows = self._window(rect)
            for k in rows:
                self.free[k] &= ~bits

    def patches(self) -> Iterator[list[int]]:
        """Yields the cells of each patch of free floor, row by row."""
        left = list(self.free)
        for k in range(len(left)):
            while left[k]:
                patch = self._flooded(k, left[k] & -left[k])
                left = [row & ~reached for row, reached in zip(left, patch, strict=True)]
                yield patch

    def _window(self, rect: Rect) -> tuple[int, range]:
        """Returns the bits and the rows of the cells that a rectangle meets."""
        first, last = max(bisect_right(self.xs, rect.x0) - 1, 0), min(bisect_left(self.xs, rect.x1), len(self.xs) - 1)
        top, bottom = max(bisect_right(self.zs, rect.z0) - 1, 0), min(bisect_left(self.zs, rect.z1), len(self.zs) - 1)
        return ((1 << last) - (1 << first) if last > first else 0), range(top, bottom)

    def touches(self, patch: Sequence[int], target: Rect) -> bool:
        """Tells whether a cell of a patch meets a box."""
        inside = max(target.x0, self.xs[0]) < min(target.x1, self.xs[-1]) and max(target.z0, self.zs[0]) < min(target.z1, self.zs[-1])
        if not inside:
            return False
        bits, rows = self._window(target)
        return any(patch[k] & bits for k in rows)

    def _flooded(self, row: int, cell: int) -> list[int]:
        """Returns the free cells that hang together with one of them."""
        reached = [0] * len(self.free)
        reached[row] = _run(cell, self.free[row])
        while self._sweep(reached, self._down()) | self._sweep(reached, self._up()):
            pass
        return reached

    def _down(self) -> Iterator[tuple[int, int]]:
        return ((k - 1, k) for k in range(1, len(self.free)))

    def _up(self) -> Iterator[tuple[int, int]]:
        return ((k + 1, k) for k in range(len(self.free) - 2, -1, -1))

    def _sweep(self, reached: list[int], order: Iterator[tuple[int, int]]) -> bool:
        grew = False
        for source, row in order:
            new = reached[source] & self.free[row] & ~reached[row]
            if new:
                reached[row] |= _run(new, self.free[row])
                grew = True
        return grew

    def has_area(self, reached: Sequence[int], least: int) -> bool:
        """Tells whether the reached cells have that area at least."""
        for k, row in enumerate(reached):
            least -= (self.zs[k + 1] - self.zs[k]) * sum(self.xs[j + 1] - self.xs[j] for j in range(row.bit_length()) if row >> j & 1)
            if least <= 0:
                return True
        return False


def _run(seeds: int, free: int) -> int:
    """Returns the runs of free bits that hold a seed."""
    found = seeds
    while True:
        grown = (found | found << 1 | found >> 1) & free
        if grown == found:
            return found
        found = grown
