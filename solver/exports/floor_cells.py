"""Distances and stretches over the cells of a grid."""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from solver.demanded import demand

STEP_WORK: Final = 0.002
"""What a cell counts that is compared with another; measured."""


def squared_distances(taken: npt.NDArray[np.bool_]) -> npt.NDArray[np.int32]:
    """Returns each cell's squared distance from its nearest taken cell, centre to centre, in cells; large where there is none."""
    rows, columns = taken.shape
    far, row = rows + columns, np.arange(rows, dtype=np.int32)[:, None]
    above = np.maximum.accumulate(np.where(taken, row, -far), axis=0)
    below = np.minimum.accumulate(np.where(taken, row, far + rows)[::-1], axis=0)[::-1]
    columnwise: npt.NDArray[np.int32] = np.minimum(np.minimum(row - above, below - row), far).astype(np.int32)
    vertical = columnwise * columnwise
    found = vertical.copy()
    step = 1
    while step < columns and step * step < int(found.max()):
        demand(STEP_WORK * found.size)
        np.minimum(found[:, step:], vertical[:, :-step] + step * step, out=found[:, step:])
        np.minimum(found[:, :-step], vertical[:, step:] + step * step, out=found[:, :-step])
        step += 1
    return found


def largest_stretch(taken: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Returns the largest set of cells that hang together by their edges; of equal ones the first from the top."""
    rows, columns = taken.shape
    padded = np.zeros((rows, columns + 2), dtype=np.int8)
    padded[:, 1:-1] = taken
    turns = np.flatnonzero(np.diff(padded, axis=1)).reshape(-1, 2).tolist()
    runs = [(start // (columns + 1), start % (columns + 1), end % (columns + 1)) for start, end in turns]
    owner = list(range(len(runs)))

    def root(run: int) -> int:
        while owner[run] != run:
            owner[run] = run = owner[owner[run]]
        return run

    above = 0
    for number, (row, start, end) in enumerate(runs):
        while runs[above][0] < row - 1 or (runs[above][0] == row - 1 and runs[above][2] <= start):
            above += 1
        other = above
        while runs[other][0] == row - 1 and runs[other][1] < end:
            one, two = sorted((root(other), root(number)))
            owner[two] = one
            other += 1
    sizes = [0] * len(runs)
    for number, (_, start, end) in enumerate(runs):
        sizes[root(number)] += end - start
    found = np.zeros_like(taken)
    if runs:
        largest = sizes.index(max(sizes))
        for number, (row, start, end) in enumerate(runs):
            if root(number) == largest:
                found[row, start:end] = True
    return found
