"""Distances and stretches over cells, against all cells one by one."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from solver.exports.floor_grid import largest_stretch, squared_distances
from solver.imports.steps_inside import connected
from tests.every import every

Spot = tuple[int, int]


def stretches(cells: set[Spot]) -> list[set[Spot]]:
    """Returns the sets of cells that hang together by their edges, that of the first cell first."""
    found: list[set[Spot]] = []
    for cell in sorted(cells):
        if any(cell in one for one in found):
            continue
        held, ahead = set[Spot](), [cell]
        while ahead:
            row, column = ahead.pop()
            if (row, column) in cells and (row, column) not in held:
                held.add((row, column))
                ahead += [(row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)]
        found.append(held)
    return found


def spots(cells: npt.NDArray[np.bool_]) -> set[Spot]:
    return {(row, column) for row, column in np.argwhere(cells).tolist()}


@every("seed", range(40))
def test_the_largest_stretch_is_the_first_of_the_largest(seed: int) -> None:
    stream = np.random.default_rng(seed)
    cells = stream.random((stream.integers(1, 14), stream.integers(1, 14))) < stream.choice([0.0, 0.3, 0.55, 0.7, 1.0])
    parts = stretches(spots(cells))
    assert [{(row, column) for row, column in part.tolist()} for part in connected(cells)] == parts
    assert spots(largest_stretch(cells)) == max(parts, key=len, default=set())


@every("seed", range(40))
def test_distances_are_exact(seed: int) -> None:
    stream = np.random.default_rng(seed)
    cells = stream.random((stream.integers(1, 30), stream.integers(1, 30))) < stream.choice([0.01, 0.1, 0.5])
    cells[stream.integers(cells.shape[0]), stream.integers(cells.shape[1])] = True
    taken = np.argwhere(cells)
    each = np.argwhere(np.ones_like(cells))
    nearest = ((each[:, None] - taken[None]) ** 2).sum(axis=2).min(axis=1)
    assert np.array_equal(squared_distances(cells).ravel(), nearest)


def test_nothing_is_near_where_nothing_is() -> None:
    assert squared_distances(np.zeros((3, 4), dtype=np.bool_)).min() >= 3**2 + 4**2
