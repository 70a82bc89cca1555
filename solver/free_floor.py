"""The free floor of a room: where somebody can be, and whether everything stays within reach while they are there.

Comes in: a room, its space, which sides of its furniture are used. Goes out: free places, yes or no. May import: the ground floor.

Within reach is exact, on a grid cut at every edge. A square person's centre is free where the open square meets neither body nor
wall. Lengths are quarter millimetres and the person is half a millimetre narrower than said, so that gaps of exactly its width let
it through and cells are open sets. A row of cells is one integer, so that a flood goes through it with a few shifts.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from solver.free_places import FLAT_MM, Block, block_of, footprint, nearest_place
from solver.geometry import OPPOSITE, Rect, strip, strip_at, wall_faced
from solver.pieces import Doorway, Space
from solver.scene import WALLS, Decoration, Furniture, Room

PER_MM: Final = 4
"""Lattice steps in a millimetre."""
LEAST_FLOOR: Final = (1000 * PER_MM) ** 2 // 4
"""Free centres that a room needs: 0.25 m2 (docs/scene.md, unreachable), in square lattice steps."""
HEADROOM_MM: Final = 2000
"""What hangs higher is walked under: the height of a door."""


@dataclass(frozen=True)
class Goal:
    """Something to come to: a body's footprint, mm, and the walls its sides look to; any of them, or `all`."""

    rect: Rect
    sides: tuple[str, ...]
    need_all: bool = False

    @classmethod
    def beside(cls, rect: Rect) -> Goal:
        """Returns somebody or something that may be come to from any side."""
        return cls(rect, WALLS)


class FreeFloor:
    """What a room's furniture leaves free, and what has to stay within reach over it: doors and use sides.

    Args:
        space: its clear rectangle, missing corners, doorways and the width of who walks.
        bodies: footprints of what stands in the way of walking, mm.
        goals: use sides.
        blocks: what nobody can be in.
    """

    def __init__(self, space: Space, bodies: Iterable[Rect], goals: Iterable[Goal], blocks: Iterable[Block] = ()) -> None:
        self.space, self.goals, self.blocks = space, list(goals), list(blocks)
        self._reach = space.robot_mm * PER_MM // 2 - 1
        missing = [zone.rect for zone in space.zones if zone.cause == "outline"]
        self._taken = [self._grown(rect) for rect in (*bodies, *missing)]
        self._domain = _scaled(space.clear).shrunk(self._reach)

    @classmethod
    def of_room(cls, room: Room, space: Space, uses: Mapping[str, tuple[Sequence[str], bool]]) -> FreeFloor:
        """Returns the floor of a furnished room without its people.

        Args:
            room: furnished, and decorated or not.
            space: its clear rectangle, and what its doors and its outline keep free.
            uses: by name of piece the sides it is used from, and whether all of them have to be within reach.
        """
        things: list[Furniture | Decoration] = [*room.furniture, *room.decorations]
        blocks = [(block_of(thing), thing) for thing in things if thing.height * 1000 > FLAT_MM]
        goals = [
            Goal(footprint(piece), tuple(wall_faced(side, piece.rotation) for side in sides), need_all)
            for piece in room.furniture
            for sides, need_all in [uses.get(piece.name, ((), False))]
            if sides
        ]
        kept_free = [Block(zone.rect, -math.inf, math.inf) for zone in space.zones if zone.above_mm < 0]
        in_the_way = [block.rect for block, thing in blocks if block.low < HEADROOM_MM and _stands(thing)]
        return cls(space, in_the_way, goals, [*kept_free, *(block for block, _ in blocks)])

    def add(self, block: Block, in_the_way: bool = True) -> None:
        """Notes that somebody or something is there; who sits is not in the way of those who walk."""
        self.blocks.append(block)
        if in_the_way:
            self._taken.append(self._grown(block.rect))

    def obstacles(self, own: Block) -> list[Rect]:
        """Returns what is taken at the heights of a body."""
        return [block.rect for block in self.blocks if block.between(own.low, own.high)]

    def nearest(self, own: Block, gap_mm: int = 0) -> Rect | None:
        """Returns the free place nearest to a body with a gap all around, the gap included, or None where there is none."""
        return nearest_place(own.rect.shrunk(-gap_mm), self.space.clear, self.obstacles(own))

    def is_free(self, own: Block, but: str) -> bool:
        """Tells whether a space is empty, the body of one id aside."""
        others = (block for block in self.blocks if block.id != but)
        return not any(own.rect.overlaps(block.rect) and block.between(own.low, own.high) for block in others)

    def connects(self, more: Sequence[Rect] = (), goals: Sequence[Goal] = ()) -> bool:
        """Tells whether one component of the floor meets every door and every goal, and is 0.25 m2 of centres.

        Args:
            more: footprints of bodies besides those of the room, mm.
            goals: besides its own.
        """
        if self._domain.width <= 0 or self._domain.depth <= 0:
            return False
        cells = _Cells(self._domain, [*self._taken, *(self._grown(rect) for rect in more)])
        return any(self._serves(cells, component, goals) for component in cells.components())

    def _serves(self, cells: _Cells, component: Sequence[int], more: Sequence[Goal]) -> bool:
        """Tells whether a component of the floor is large enough and meets every door and every goal."""
        if not all(cells.touches(component, self._entry(door)) for door in self.space.doorways):
            return False
        for goal in (*self.goals, *more):
            sides = (cells.touches(component, self._contact(goal.rect, side)) for side in goal.sides)
            if not (all if goal.need_all else any)(sides):
                return False
        return cells.has_area(component, LEAST_FLOOR)

    def _grown(self, rect: Rect) -> Rect:
        return _scaled(rect).shrunk(-self._reach)

    def _entry(self, door: Doorway) -> Rect:
        """Returns where the centre is when somebody has just come through a door."""
        a, b = (PER_MM * end for end in door.square.along(door.wall))
        return strip(self._domain, door.wall, (a + self._reach, b - self._reach), 1)

    def _contact(self, rect: Rect, side: str) -> Rect:
        """Returns where the centre is while somebody touches that side of a body."""
        body, far = _scaled(rect), _scaled(rect).shrunk(-self._reach).line(side)
        return strip_at(OPPOSITE[side], far, body.along(side), 1)


def _stands(thing: Furniture | Decoration) -> bool:
    """Tells whether a thing stands in the way of walking: furniture, and what of the decorations stands loose on the floor."""
    return isinstance(thing, Furniture) or (thing.parent is None and thing.mounted_on_wall is None and thing.y == 0)


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

    def components(self) -> Iterator[list[int]]:
        """Yields the cells of each component of the free floor, row by row."""
        left = list(self.free)
        for k in range(len(left)):
            while left[k]:
                component = self._flooded(k, left[k] & -left[k])
                left = [row & ~reached for row, reached in zip(left, component, strict=True)]
                yield component

    def _window(self, rect: Rect) -> tuple[int, range]:
        """Returns the bits and the rows of the cells that a rectangle meets."""
        first, last = max(bisect_right(self.xs, rect.x0) - 1, 0), min(bisect_left(self.xs, rect.x1), len(self.xs) - 1)
        top, bottom = max(bisect_right(self.zs, rect.z0) - 1, 0), min(bisect_left(self.zs, rect.z1), len(self.zs) - 1)
        return ((1 << last) - (1 << first) if last > first else 0), range(top, bottom)

    def touches(self, component: Sequence[int], target: Rect) -> bool:
        """Tells whether a cell of a component meets a box."""
        inside = max(target.x0, self.xs[0]) < min(target.x1, self.xs[-1]) and max(target.z0, self.zs[0]) < min(target.z1, self.zs[-1])
        if not inside:
            return False
        bits, rows = self._window(target)
        return any(component[k] & bits for k in rows)

    def _flooded(self, row: int, cell: int) -> list[int]:
        """Returns the free cells that hang together with one of them."""
        reached, rows = [0] * len(self.free), range(len(self.free))
        reached[row] = _run(cell, self.free[row])
        while self._sweep(reached, rows[1:], -1) | self._sweep(reached, rows[-2::-1], 1):
            pass
        return reached

    def _sweep(self, reached: list[int], rows: Iterable[int], back: int) -> bool:
        """Takes every row's cells that lie beside reached ones of the row before it, `back` rows back; tells whether there were any."""
        grew = False
        for row in rows:
            new = reached[row + back] & self.free[row] & ~reached[row]
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
