"""Does everything in a room stay within reach while somebody is there? Exact, on a grid cut at every edge.

Comes in: a room's free rectangle, its doorways, what stands in it and what has to be reached. Goes out: yes or no. May import:
the ground floor.

A square person's centre is free where the open square meets neither body nor wall. Lengths are quarter millimetres and the
person is half a millimetre narrower than said, so that gaps of exactly its width let it through and cells are open sets.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from solver.geometry import Rect
from solver.wanted import Doorway, Space

PER_MM: Final = 4
"""Lattice steps in a millimetre."""
LEAST_FLOOR: Final = (1000 * PER_MM) ** 2 // 4
"""Free centres that a room needs: 0.25 m2 (contract, rule unreachable), in square lattice steps."""


EVERY_SIDE: Final = ("north", "south", "west", "east")


@dataclass(frozen=True)
class Goal:
    """Something to come to: a body's footprint, mm, and the walls its sides look to; any of them, or `all`."""

    rect: Rect
    sides: tuple[str, ...]
    need_all: bool = False


@dataclass(frozen=True)
class _Grid:
    """Cells between cuts; each free cell's patch, 0 where taken."""

    xs: Sequence[int]
    zs: Sequence[int]
    patches: Sequence[Sequence[int]]

    def within(self, box: Rect) -> set[int]:
        """Returns the patches of the cells that a box meets."""
        if box.width <= 0 or box.depth <= 0:
            return set()
        columns = range(max(bisect_right(self.xs, box.x0) - 1, 0), min(bisect_left(self.xs, box.x1), len(self.xs) - 1))
        rows = range(max(bisect_right(self.zs, box.z0) - 1, 0), min(bisect_left(self.zs, box.z1), len(self.zs) - 1))
        return {self.patches[i][j] for i in columns for j in rows} - {0}

    def areas(self) -> dict[int, int]:
        """Returns the area of each patch, in square steps."""
        found: dict[int, int] = {}
        for i, column in enumerate(self.patches):
            wide = self.xs[i + 1] - self.xs[i]
            for j, patch in enumerate(column):
                if patch:
                    found[patch] = found.get(patch, 0) + wide * (self.zs[j + 1] - self.zs[j])
        return found


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
        grid = self._grid([*self.taken, *(self._grown(rect) for rect in more)])
        common = {patch for patch, area in grid.areas().items() if area >= LEAST_FLOOR}
        for door in self.space.doorways:
            common &= grid.within(self._entry(door))
        for goal in (*self.goals, *also):
            sides = [grid.within(self._contact(goal.rect, side)) for side in goal.sides]
            common = {patch for patch in common if (all if goal.need_all else any)(patch in side for side in sides)}
        return bool(common)

    def _grown(self, rect: Rect) -> Rect:
        return _scaled(rect).shrunk(-self.reach)

    def _grid(self, taken: Sequence[Rect]) -> _Grid:
        domain = self.domain
        xs = sorted({domain.x0, domain.x1, *(x for r in taken for x in (r.x0, r.x1) if domain.x0 < x < domain.x1)})
        zs = sorted({domain.z0, domain.z1, *(z for r in taken for z in (r.z0, r.z1) if domain.z0 < z < domain.z1)})
        free = [[True] * (len(zs) - 1) for _ in range(len(xs) - 1)]
        for rect in taken:
            rows = slice(bisect_left(zs, rect.z0), bisect_left(zs, rect.z1))
            none = [False] * len(range(*rows.indices(len(zs) - 1)))
            for i in range(bisect_left(xs, rect.x0), min(bisect_left(xs, rect.x1), len(xs) - 1)):
                free[i][rows] = none
        return _Grid(xs, zs, _labelled(free))

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


def _labelled(free: list[list[bool]]) -> list[list[int]]:
    """Numbers the patches of free cells that share sides, from 1; 0 where a cell is taken."""
    patches = [[0] * len(column) for column in free]
    count = 0
    for i, column in enumerate(free):
        for j, is_free in enumerate(column):
            if is_free and not patches[i][j]:
                count += 1
                _flood(free, patches, (i, j), count)
    return patches


def _flood(free: list[list[bool]], patches: list[list[int]], start: tuple[int, int], label: int) -> None:
    """Gives every free cell joined with the start the label."""
    wide, deep = len(free), len(free[0])
    patches[start[0]][start[1]] = label
    ahead = [start]
    while ahead:
        i, j = ahead.pop()
        for x, z in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if 0 <= x < wide and 0 <= z < deep and free[x][z] and not patches[x][z]:
                patches[x][z] = label
                ahead.append((x, z))
