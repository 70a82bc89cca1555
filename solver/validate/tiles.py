"""Free floor of any size: cut into tiles of few obstacles each, patches numbered across their borders.

Comes in: floors and obstacles. Goes out: a `FreeFloor`. May import: nothing of ours. A grid's cells grow with the square of its
obstacles; a house is one tile, a town or a heap of thousands of boxes many.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.validate.grid import Boxes, Grid, Window, boxes_of
from solver.validate.lattice import PER_METRE, Box
from solver.validate.patches import joined, label

MOST: Final = 400
"""How many boxes a tile holds before it is halved: houses of 30 rooms stay one tile. Our choice."""
SMALLEST: Final = PER_METRE // 20
"""Tiles are not halved below 5 cm, however many boxes meet there. Our choice."""


@dataclass(frozen=True)
class Tile:
    """A part of the floor: its cells, and for each the number of the patch it belongs to (0: taken)."""

    grid: Grid
    patches: NDArray[np.int64]


Border = tuple[int, int, int]
"""From, to, and the patch of free cells along a tile's border."""


class FreeFloor:
    """Floors less obstacles, in patches one can walk about in; patches are numbered from 1."""

    def __init__(self, floors: list[Box], obstacles: list[Box]) -> None:
        grids = [Grid(*parts) for parts in _cut(boxes_of(floors), boxes_of(obstacles))]
        tiles, count = [], 0
        for grid in grids:
            patches = label(grid.free)
            patches[patches > 0] += count
            count = max(count, int(patches.max(initial=0)))
            tiles.append(Tile(grid, patches))
        numbers = np.array(joined(count, _neighbours(tiles)), dtype=np.int64) if len(tiles) > 1 else np.arange(count + 1)
        self.count = int(numbers.max(initial=0))
        self.tiles = tuple(Tile(tile.grid, numbers[tile.patches]) for tile in tiles)
        self._bounds = boxes_of([Box(int(t.grid.xs[0]), int(t.grid.zs[0]), int(t.grid.xs[-1]), int(t.grid.zs[-1])) for t in tiles])

    def windows(self, box: Box) -> Iterator[tuple[Tile, Window]]:
        """Returns the cells that a box meets, tile by tile."""
        low, high = self._bounds[:, :2], self._bounds[:, 2:]
        meets = (low < np.array(box[2:])).all(axis=1) & (high > np.array(box[:2])).all(axis=1)
        for index in np.flatnonzero(meets).tolist():
            tile = self.tiles[index]
            yield tile, tile.grid.cells(box)

    def patches(self, box: Box) -> set[int]:
        """Returns the numbers of the patches in a box."""
        found: set[int] = set()
        for tile, window in self.windows(box):
            found.update(tile.patches[window].ravel().tolist())
        return found - {0}

    def area(self, box: Box, wanted: NDArray[np.bool_]) -> int:
        """Returns the exact area of the wanted patches in a box whose sides are edges of a floor."""
        return sum(tile.grid.area(wanted[tile.patches[window]], window) for tile, window in self.windows(box))

    def largest(self) -> int:
        """Returns the patch of the largest area; 0 where no floor is free."""
        sums = np.zeros(self.count + 1)
        for tile in self.tiles:
            areas = np.outer(np.diff(tile.grid.xs).astype(float), np.diff(tile.grid.zs).astype(float))
            sums += np.bincount(tile.patches.ravel(), weights=areas.ravel(), minlength=self.count + 1)
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
    """Yields the patches of different tiles that share a piece of border."""
    ending: dict[tuple[int, int], list[Border]] = defaultdict(list)
    beginning: dict[tuple[int, int], list[Border]] = defaultdict(list)
    for tile in tiles:
        for axis, cuts, along, patches in ((0, tile.grid.xs, tile.grid.zs, tile.patches), (1, tile.grid.zs, tile.grid.xs, tile.patches.T)):
            beginning[axis, int(cuts[0])] += _border(along, patches[0])
            ending[axis, int(cuts[-1])] += _border(along, patches[-1])
    for line, borders in ending.items():
        yield from _meeting(sorted(borders), sorted(beginning.get(line, [])))


def _border(along: NDArray[np.int64], patches: NDArray[np.int64]) -> Iterator[Border]:
    found = zip(along[:-1].tolist(), along[1:].tolist(), patches.tolist(), strict=True)
    return (entry for entry in found if entry[2])


def _meeting(one: list[Border], other: list[Border]) -> Iterator[tuple[int, int]]:
    """Yields the patches of pieces on both sides of a line that share more than a point."""
    here = there = 0
    while here < len(one) and there < len(other):
        start, end, patch = one[here]
        from_, to, beyond = other[there]
        if min(end, to) > max(start, from_):
            yield patch, beyond
        if end <= to:
            here += 1
        else:
            there += 1
