"""Floor less obstacles, cut at every edge that matters.

Comes in: boxes. Goes out: cells that are free or taken as a whole. May import: nothing of ours.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right

import numpy as np
from numpy.typing import NDArray

from solver.validate.lattice import Box

Boxes = NDArray[np.int64]
"""Boxes as rows (x0, z0, x1, z1)."""
Window = tuple[slice, slice]


def boxes_of(boxes: list[Box]) -> Boxes:
    """Returns boxes as rows."""
    return np.array(boxes, dtype=np.int64).reshape(-1, 4)


class Grid:
    """The cells between all edges of some floors and obstacles; `free[i, j]` is floor that no obstacle meets."""

    def __init__(self, floors: Boxes, obstacles: Boxes) -> None:
        boxes = np.concatenate([floors, obstacles])
        self.xs: NDArray[np.int64] = np.unique(boxes[:, ::2])
        self.zs: NDArray[np.int64] = np.unique(boxes[:, 1::2])
        self._x_cuts, self._z_cuts = self.xs.tolist(), self.zs.tolist()
        self.free: NDArray[np.bool_] = np.zeros((max(len(self.xs) - 1, 0), max(len(self.zs) - 1, 0)), dtype=bool)
        cells = np.empty_like(boxes)
        cells[:, ::2] = np.searchsorted(self.xs, boxes[:, ::2])
        cells[:, 1::2] = np.searchsorted(self.zs, boxes[:, 1::2])
        for index, (x0, z0, x1, z1) in enumerate(cells.tolist()):
            self.free[x0:x1, z0:z1] = index < len(floors)

    def cells(self, box: Box) -> Window:
        """Returns the cells that a box meets."""
        return _between(self._x_cuts, box.x0, box.x1), _between(self._z_cuts, box.z0, box.z1)

    def area(self, chosen: NDArray[np.bool_], window: Window) -> int:
        """Sums the exact area of the chosen cells of a window, in square lattice steps."""
        wide = np.diff(self.xs)[window[0]].tolist()
        deep = chosen @ np.diff(self.zs)[window[1]]
        return sum(int(x) * int(z) for x, z in zip(wide, deep.tolist(), strict=True))


def _between(cuts: list[int], low: int, high: int) -> slice:
    return slice(max(bisect_right(cuts, low) - 1, 0), bisect_left(cuts, high))
