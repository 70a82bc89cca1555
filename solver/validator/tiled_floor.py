"""Free floor of any size: floors less obstacles, cut at every edge that matters, in components one can walk about in.

Comes in: floors and obstacles. Goes out: a `TiledFloor`. May import: nothing of ours. A grid's cells grow with the square of its
obstacles, so the floor is cut into tiles of few each: a house is one tile, a town or a heap of thousands of boxes many.
Components are numbered across the tiles' borders.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.validator.lattice import PER_METRE, ExactBox

MOST: Final = 400
"""How many boxes a tile holds before it is halved: houses of 30 rooms stay one tile. Our choice."""
SMALLEST: Final = PER_METRE // 20
"""Tiles are not halved below 5 cm, however many boxes meet there. Our choice."""

Boxes = NDArray[np.int64]
"""Boxes as rows (x0, z0, x1, z1)."""
Window = tuple[slice, slice]


def boxes_of(boxes: list[ExactBox]) -> Boxes:
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

    def cells(self, box: ExactBox) -> Window:
        """Returns the cells that a box meets."""
        return _between(self._x_cuts, box.x0, box.x1), _between(self._z_cuts, box.z0, box.z1)

    def area(self, chosen: NDArray[np.bool_], window: Window) -> int:
        """Sums the exact area of the chosen cells of a window, in square lattice steps."""
        wide = np.diff(self.xs)[window[0]].tolist()
        deep = chosen @ np.diff(self.zs)[window[1]]
        return sum(int(x) * int(z) for x, z in zip(wide, deep.tolist(), strict=True))


def _between(cuts: list[int], low: int, high: int) -> slice:
    return slice(max(bisect_right(cuts, low) - 1, 0), bisect_left(cuts, high))


@dataclass(frozen=True)
class Tile:
    """A part of the floor: its cells, and for each the number of the component it belongs to (0: taken)."""

    grid: Grid
    components: NDArray[np.int64]


Border = tuple[int, int, int]
"""From, to, and the component of free cells along a tile's border."""


class TiledFloor:
    """Floors less obstacles, in components one can walk about in; components are numbered from 1."""

    def __init__(self, floors: list[ExactBox], obstacles: list[ExactBox]) -> None:
        grids = [Grid(*parts) for parts in _cut(boxes_of(floors), boxes_of(obstacles))]
        tiles, count = [], 0
        for grid in grids:
            components = label(grid.free)
            components[components > 0] += count
            count = max(count, int(components.max(initial=0)))
            tiles.append(Tile(grid, components))
        numbers = np.array(joined(count, _neighbours(tiles)), dtype=np.int64) if len(tiles) > 1 else np.arange(count + 1)
        self.count = int(numbers.max(initial=0))
        self.tiles = tuple(Tile(tile.grid, numbers[tile.components]) for tile in tiles)
        self._bounds = boxes_of([ExactBox(int(t.grid.xs[0]), int(t.grid.zs[0]), int(t.grid.xs[-1]), int(t.grid.zs[-1])) for t in tiles])

    def windows(self, box: ExactBox) -> Iterator[tuple[Tile, Window]]:
        """Returns the cells that a box meets, tile by tile."""
        low, high = self._bounds[:, :2], self._bounds[:, 2:]
        meets = (low < np.array(box[2:])).all(axis=1) & (high > np.array(box[:2])).all(axis=1)
        for index in np.flatnonzero(meets).tolist():
            tile = self.tiles[index]
            yield tile, tile.grid.cells(box)

    def components(self, box: ExactBox) -> set[int]:
        """Returns the numbers of the components in a box."""
        found: set[int] = set()
        for tile, window in self.windows(box):
            found.update(tile.components[window].ravel().tolist())
        return found - {0}

    def area(self, box: ExactBox, wanted: NDArray[np.bool_]) -> int:
        """Returns the exact area of the wanted components in a box whose sides are edges of a floor."""
        return sum(tile.grid.area(wanted[tile.components[window]], window) for tile, window in self.windows(box))

    def largest(self) -> int:
        """Returns the component of the largest area; 0 where no floor is free."""
        sums = np.zeros(self.count + 1)
        for tile in self.tiles:
            areas = np.outer(np.diff(tile.grid.xs).astype(float), np.diff(tile.grid.zs).astype(float))
            sums += np.bincount(tile.components.ravel(), weights=areas.ravel(), minlength=self.count + 1)
        sums[0] = 0.0
        return int(np.argmax(sums))


def _cut(floors: Boxes, obstacles: Boxes) -> Iterator[tuple[Boxes, Boxes]]:
    """Halves the floors' bounds until each part meets few boxes; parts that one obstacle covers are left out."""
    if not len(floors):
        return
    waiting = [(np.concatenate([floors[:, :2].min(axis=0), floors[:, 2:].max(axis=0)]), floors, obstacles)]
    while waiting:
        region, floors, obstacles = waiting.pop()
        floors, obstacles = _clipped(floors, region), _clipped(obstacles, region)
        if not len(floors) or (obstacles == region).all(axis=1).any():
            continue
        sides = region[2:] - region[:2]
        if len(floors) + len(obstacles) <= MOST or sides.max() <= SMALLEST:
            yield floors, obstacles
            continue
        axis = int(np.argmax(sides))
        middle = int(region[axis] + sides[axis] // 2)
        first, second = region.copy(), region.copy()
        first[axis + 2] = second[axis] = middle
        waiting += [(second, floors, obstacles), (first, floors, obstacles)]


def _clipped(boxes: Boxes, region: NDArray[np.int64]) -> Boxes:
    """Returns the parts of boxes that lie in a region, each once."""
    low, high = np.maximum(boxes[:, :2], region[:2]), np.minimum(boxes[:, 2:], region[2:])
    kept = np.concatenate([low, high], axis=1)[(low < high).all(axis=1)]
    return np.unique(kept, axis=0) if len(kept) > MOST else kept


def _neighbours(tiles: list[Tile]) -> Iterator[tuple[int, int]]:
    """Yields the components of different tiles that share a piece of border."""
    ending: dict[tuple[int, int], list[Border]] = defaultdict(list)
    beginning: dict[tuple[int, int], list[Border]] = defaultdict(list)
    for tile in tiles:
        xs, zs = tile.grid.xs, tile.grid.zs
        for axis, cuts, along, components in ((0, xs, zs, tile.components), (1, zs, xs, tile.components.T)):
            beginning[axis, int(cuts[0])] += _border(along, components[0])
            ending[axis, int(cuts[-1])] += _border(along, components[-1])
    for line, borders in ending.items():
        yield from _meeting(sorted(borders), sorted(beginning.get(line, [])))


def _border(along: NDArray[np.int64], components: NDArray[np.int64]) -> Iterator[Border]:
    found = zip(along[:-1].tolist(), along[1:].tolist(), components.tolist(), strict=True)
    return (entry for entry in found if entry[2])


def _meeting(one: list[Border], other: list[Border]) -> Iterator[tuple[int, int]]:
    """Yields the components of pieces on both sides of a line that share more than a point."""
    here = there = 0
    while here < len(one) and there < len(other):
        start, end, component = one[here]
        from_, to, beyond = other[there]
        if min(end, to) > max(start, from_):
            yield component, beyond
        if end <= to:
            here += 1
        else:
            there += 1


def label(free: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Numbers the components of free cells that share sides.

    Runs of free cells along a row are found at once; runs of neighbouring rows that lie side by side are then joined.

    Args:
        free: which cells are free, shape (rows, columns).

    Returns:
        The same shape: 0 where a cell is taken, else its component's number, from 1 in the order of their first cells.
    """
    starts = free.copy()
    starts[:, 1:] &= ~free[:, :-1]
    runs = np.where(free, np.cumsum(starts).reshape(free.shape), 0)
    above, below = runs[:-1], runs[1:]
    meet = (above > 0) & (below > 0)
    meet[:, 1:] &= (above[:, 1:] != above[:, :-1]) | (below[:, 1:] != below[:, :-1])
    components = joined(int(starts.sum()), zip(above[meet].tolist(), below[meet].tolist(), strict=True))
    return np.array(components, dtype=np.int64)[runs]


def joined(count: int, pairs: Iterable[tuple[int, int]]) -> list[int]:
    """Returns each run's component, for runs 1 to count; runs of a pair are of one component. Entry 0 is 0."""
    first = list(range(count + 1))
    for pair in pairs:
        one, other = sorted(_first(first, run) for run in pair)
        first[other] = one
    components = [0]
    found = 0
    for run in range(1, count + 1):
        if first[run] == run:
            found += 1
            components.append(found)
        else:
            components.append(components[first[run]])
    return components


def _first(first: list[int], run: int) -> int:
    while first[run] != run:
        first[run] = first[first[run]]
        run = first[run]
    return run
