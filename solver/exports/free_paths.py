"""Shortest ways of a square over a free floor, exact: its centre goes straight from corner to corner of what is in its way.

The centre may be wherever the square lies within the union of the floor's rectangles: nowhere strictly inside what is left of the plane,
grown by half the square. A shortest way bends at corners of that alone (Lozano-Pérez and Wesley, 1979). All is calculated in quarter
micrometres, in integers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from heapq import heappop, heappush
from typing import Final

import numpy as np
import numpy.typing as npt

PER_METRE: Final = 4_000_000
"""Steps of the lattice in a metre: quarter micrometres, as the validator's."""
LatticeSpot = tuple[int, int]
"""A point: x and z, in steps."""
Boxes = npt.NDArray[np.int64]
"""Rows of x0, z0, x1, z1, in steps."""


class FreePaths:
    """The ways of a square, its side in m, over a floor: rectangles (x0, z0, x1, z1), m, that it may cover; they may overlap."""

    def __init__(self, floor: Iterable[Sequence[float]], side: float) -> None:
        inside = np.array([[steps(one) for one in box] for box in floor], dtype=np.int64).reshape(-1, 4)
        self._half = max(steps(side) // 2 - 1, 0)
        self.taken = _rest(inside) + np.array([-1, -1, 1, 1]) * self._half if len(inside) else inside
        self._corners = _corners(self.taken)
        self._seen: dict[LatticeSpot, list[tuple[float, LatticeSpot]]] = {}

    def is_free(self, spot: LatticeSpot) -> bool:
        """Tells whether the square's centre may be at a point."""
        return len(self.taken) > 0 and not _inside(self.taken, np.array([spot], dtype=np.int64))[0]

    def nearest(self, middle: LatticeSpot, end: LatticeSpot) -> LatticeSpot | None:
        """Returns the free point of a segment along an axis, and of its mirror image about its first point, nearest to that point."""
        other = (2 * middle[0] - end[0], 2 * middle[1] - end[1])
        axis = 0 if middle[0] != end[0] else 1
        edges = [int(edge) for edge in {*self.taken[:, axis].tolist(), *self.taken[:, axis + 2].tolist()}] if len(self.taken) else []
        low, high = min(end[axis], other[axis]), max(end[axis], other[axis])
        tried = sorted({middle[axis], *(edge for edge in edges if low <= edge <= high)}, key=lambda at: (abs(at - middle[axis]), at))
        spots = [(at, middle[1]) if axis == 0 else (middle[0], at) for at in tried]
        return next((spot for spot in spots if self.is_free(spot)), None)

    def path(self, start: LatticeSpot, goal: LatticeSpot) -> list[LatticeSpot] | None:
        """Returns the corners of a shortest way from a free point to another, both included; None where there is none."""
        if not (self.is_free(start) and self.is_free(goal)):
            return None
        ahead: list[tuple[float, float, LatticeSpot, LatticeSpot | None]] = [(math.dist(start, goal), 0.0, start, None)]
        came: dict[LatticeSpot, LatticeSpot | None] = {}
        while ahead:
            _, gone, at, before = heappop(ahead)
            if at in came:
                continue
            came[at] = before
            if at == goal:
                return _back(came, goal)
            ways = [*self._ways(at), *self._straight(at, goal)]
            for length, there in ways:
                if there not in came:
                    heappush(ahead, (gone + length + math.dist(there, goal), gone + length, there, at))
        return None

    def _ways(self, at: LatticeSpot) -> list[tuple[float, LatticeSpot]]:
        if at not in self._seen:
            clear = _clear(at, self._corners, self.taken)
            self._seen[at] = [(math.dist(at, (x, z)), (x, z)) for x, z in self._corners[clear].tolist()]
        return self._seen[at]

    def _straight(self, at: LatticeSpot, goal: LatticeSpot) -> list[tuple[float, LatticeSpot]]:
        return [(math.dist(at, goal), goal)] if _clear(at, np.array([goal], dtype=np.int64), self.taken)[0] else []


def steps(metres: float) -> int:
    """Returns a length in steps, rounded."""
    return round(metres * PER_METRE)


def _back(came: dict[LatticeSpot, LatticeSpot | None], goal: LatticeSpot) -> list[LatticeSpot]:
    found, at = [], goal
    while True:
        found.append(at)
        before = came[at]
        if before is None:
            return found[::-1]
        at = before


def _rest(inside: Boxes) -> Boxes:
    """Returns rectangles that cover what boxes leave of the rectangle around them, and a rim around that."""
    rim = 4 * PER_METRE
    xs, zs = (np.unique([*inside[:, k], *inside[:, k + 2], inside[:, k].min() - rim, inside[:, k + 2].max() + rim]) for k in (0, 1))
    free = np.zeros((len(zs) - 1, len(xs) - 1), dtype=np.bool_)
    for x0, z0, x1, z1 in inside.tolist():
        free[np.searchsorted(zs, z0) : np.searchsorted(zs, z1), np.searchsorted(xs, x0) : np.searchsorted(xs, x1)] = True
    found: list[tuple[int, int, int, int]] = []
    growing: dict[tuple[int, int], int] = {}
    for row, line in enumerate([*~free, np.zeros(len(xs) - 1, dtype=np.bool_)]):
        turns = np.flatnonzero(np.diff(np.concatenate(([False], line, [False])).astype(np.int8)))
        runs = {(int(a), int(b)) for a, b in turns.reshape(-1, 2)}
        for a, b in sorted(growing.keys() - runs):
            found.append((int(xs[a]), int(zs[growing.pop((a, b))]), int(xs[b]), int(zs[row])))
        for run in runs - growing.keys():
            growing[run] = row
    return np.array(found, dtype=np.int64).reshape(-1, 4)


def _inside(boxes: Boxes, spots: npt.NDArray[np.int64]) -> npt.NDArray[np.bool_]:
    """Tells of each point whether it lies strictly inside a box."""
    x, z = spots[:, 0, None], spots[:, 1, None]
    return _any((boxes[:, 0] < x) & (x < boxes[:, 2]) & (boxes[:, 1] < z) & (z < boxes[:, 3]))


def _corners(boxes: Boxes) -> npt.NDArray[np.int64]:
    """Returns the free points about which exactly one quarter of the plane is taken: where a shortest way may bend."""
    spots = np.unique(np.concatenate([boxes[:, [a, b]] for a in (0, 2) for b in (1, 3)]), axis=0)
    spots = spots[~_inside(boxes, spots)]
    quarters = [_quarter(boxes, spots, east, south) for east in (False, True) for south in (False, True)]
    found: npt.NDArray[np.int64] = spots[np.sum(quarters, axis=0) == 1]
    return found


def _quarter(boxes: Boxes, spots: npt.NDArray[np.int64], east: bool, south: bool) -> npt.NDArray[np.bool_]:
    """Tells of each point whether the quarter of the plane right beside it is taken."""
    x, z = spots[:, 0, None], spots[:, 1, None]
    along = (boxes[:, 0] <= x) & (x < boxes[:, 2]) if east else (boxes[:, 0] < x) & (x <= boxes[:, 2])
    across = (boxes[:, 1] <= z) & (z < boxes[:, 3]) if south else (boxes[:, 1] < z) & (z <= boxes[:, 3])
    return _any(along & across)


def _clear(start: LatticeSpot, ends: npt.NDArray[np.int64], boxes: Boxes) -> npt.NDArray[np.bool_]:
    """Tells of each end whether the segment to it meets no box's inside: a line along an axis or along itself parts them."""
    x, z = ends[:, 0, None], ends[:, 1, None]
    apart = (np.maximum(x, start[0]) <= boxes[:, 0]) | (np.minimum(x, start[0]) >= boxes[:, 2])
    apart |= (np.maximum(z, start[1]) <= boxes[:, 1]) | (np.minimum(z, start[1]) >= boxes[:, 3])
    dx, dz = x - start[0], z - start[1]
    sides = [dx * (boxes[:, k] - start[1]) - dz * (boxes[:, j] - start[0]) for j in (0, 2) for k in (1, 3)]
    apart |= np.minimum.reduce(sides) >= 0
    apart |= np.maximum.reduce(sides) <= 0
    return ~_any(~apart)


def _any(table: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Tells of each row whether it holds a yes."""
    return np.asarray(np.any(table, axis=1), dtype=np.bool_)
