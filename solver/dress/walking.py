"""Whether a person still gets everywhere when one more body stands in a room: exactly, in quarter millimetres.

Comes in: a room's Space, its bodies and their use sides. Goes out: yes or no. May import: the ground floor.

The square's centre is free where it is half a side away from bodies and walls. Bodies grown by that cut the floor into cells that are
free or taken as a whole; a row of cells is one integer, so that a flood goes through it with a few shifts. Growing by a quarter
millimetre less lets a gap of exactly the square's side pass and nothing narrower.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from solver.geometry import Rect
from solver.wanted import Space

PER_MM: Final = 4
LEAST_FLOOR: Final = 250_000 * PER_MM * PER_MM
"""Free centres that a room needs, 0.25 m2 (contract: unreachable)."""


class Used(NamedTuple):
    """A body and the sides of the room that its use sides look to, one or all of which must be reached."""

    rect: Rect
    sides: tuple[str, ...]
    need_all: bool


class Walking:
    """A room's walk: `passes` tells whether all doors and use sides are still met by one connected floor."""

    def __init__(self, space: Space, bodies: Sequence[Rect], used: Sequence[Used]) -> None:
        self.reach = 2 * space.robot_mm - 1
        clear = space.clear
        self.floor = Rect(*(PER_MM * v for v in (clear.x0, clear.z0, clear.x1, clear.z1))).shrunk(self.reach)
        outline = [zone.rect for zone in space.zones if zone.cause == "outline"]
        self.blocks = [self._grown(rect) for rect in (*bodies, *outline)]
        self.doors = [door for doorway in space.doorways if (door := self._door(doorway.wall, doorway.square)) is not None]
        self.uses = [([self._contact(use.rect, side) for side in use.sides], use.need_all) for use in used]
        self.sound = self._walkable(self.blocks)

    def passes(self, rect: Rect) -> bool:
        """Tells whether one more body may stand there; where the room could not be walked before, none may."""
        if not self.sound:
            return False
        grown = self._grown(rect)
        return self._harmless(grown) or self._walkable([*self.blocks, grown])

    def add(self, rect: Rect) -> None:
        """Puts one more body into the room."""
        self.blocks.append(self._grown(rect))

    def _grown(self, rect: Rect) -> Rect:
        return Rect(*(PER_MM * v for v in (rect.x0, rect.z0, rect.x1, rect.z1))).shrunk(-self.reach)

    def _harmless(self, grown: Rect) -> bool:
        """Tells whether the floor that a body takes is no more than other bodies have taken already."""
        floor = self.floor
        cut = Rect(max(grown.x0, floor.x0), max(grown.z0, floor.z0), min(grown.x1, floor.x1), min(grown.z1, floor.z1))
        return cut.width <= 0 or cut.depth <= 0 or any(block.contains(cut) for block in self.blocks)

    def _door(self, wall: str, square: Rect) -> Rect | None:
        """Returns where the centre is when it has just come in through a door."""
        low, high = (PER_MM * v for v in square.along(wall))
        low, high, floor = low + self.reach, high - self.reach, self.floor
        return {
            "north": Rect(low, floor.z0, high, floor.z0 + 1), "south": Rect(low, floor.z1 - 1, high, floor.z1),
            "west": Rect(floor.x0, low, floor.x0 + 1, high), "east": Rect(floor.x1 - 1, low, floor.x1, high),
        }[wall] if low < high else None  # fmt: skip

    def _contact(self, rect: Rect, side: str) -> Rect:
        """Returns where the centre is while the square touches that side of a body."""
        x0, z0, x1, z1 = (PER_MM * v for v in (rect.x0, rect.z0, rect.x1, rect.z1))
        far = self.reach
        return {
            "north": Rect(x0, z0 - far - 1, x1, z0 - far), "south": Rect(x0, z1 + far, x1, z1 + far + 1),
            "west": Rect(x0 - far - 1, z0, x0 - far, z1), "east": Rect(x1 + far, z0, x1 + far + 1, z1),
        }[side]  # fmt: skip

    def _walkable(self, blocks: Sequence[Rect]) -> bool:
        if not self.doors or self.floor.width <= 0 or self.floor.depth <= 0:
            return False
        cells = _Cells(self.floor, blocks, [*self.doors, *(contact for contacts, _ in self.uses for contact in contacts)])
        reached = cells.flooded(self.doors[0])
        met = all(cells.touches(reached, door) for door in self.doors)
        return met and self._all_used(cells, reached) and cells.has_area(reached, LEAST_FLOOR)

    def _all_used(self, cells: _Cells, reached: Sequence[int]) -> bool:
        return all((all if need_all else any)(cells.touches(reached, contact) for contact in contacts) for contacts, need_all in self.uses)


class _Cells:
    """The cells between all edges that matter; row k spans zs[k] to zs[k + 1], bit j of it xs[j] to xs[j + 1]."""

    def __init__(self, floor: Rect, blocks: Sequence[Rect], targets: Sequence[Rect]) -> None:
        every = [rect for rect in (*blocks, *targets) if rect.overlaps(floor)]
        self.xs = sorted({floor.x0, floor.x1, *(v for r in every for v in (r.x0, r.x1) if floor.x0 < v < floor.x1)})
        self.zs = sorted({floor.z0, floor.z1, *(v for r in every for v in (r.z0, r.z1) if floor.z0 < v < floor.z1)})
        self.free = [(1 << (len(self.xs) - 1)) - 1] * (len(self.zs) - 1)
        for block in blocks:
            if block.overlaps(floor):
                bits, rows = self._window(block)
                for k in rows:
                    self.free[k] &= ~bits

    def _window(self, rect: Rect) -> tuple[int, range]:
        """Returns the bits and the rows of the cells that a rectangle meets."""
        first, last = max(bisect_right(self.xs, rect.x0) - 1, 0), min(bisect_left(self.xs, rect.x1), len(self.xs) - 1)
        top, bottom = max(bisect_right(self.zs, rect.z0) - 1, 0), min(bisect_left(self.zs, rect.z1), len(self.zs) - 1)
        return ((1 << last) - (1 << first) if last > first else 0), range(top, bottom)

    def touches(self, reached: Sequence[int], target: Rect) -> bool:
        """Tells whether a reached cell lies in a target."""
        bits, rows = self._window(target)
        inside = self.xs[0] < target.x1 and target.x0 < self.xs[-1] and self.zs[0] < target.z1 and target.z0 < self.zs[-1]
        return inside and any(reached[k] & bits for k in rows)

    def flooded(self, start: Rect) -> list[int]:
        """Returns the free cells that hang together with the free ones of a start."""
        bits, rows = self._window(start)
        first = next((k for k in rows if self.free[k] & bits), None)
        reached = [0] * len(self.free)
        if first is None:
            return reached
        reached[first] = _run(self.free[first] & bits & -(self.free[first] & bits), self.free[first])
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
