"""Which cells of a grid hang together.

Comes in: a grid of free and taken cells. Goes out: each free cell's patch. May import: nothing of ours.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray


def label(free: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Numbers the patches of free cells that share sides.

    Runs of free cells along a row are found at once; runs of neighbouring rows that lie side by side are then joined.

    Args:
        free: which cells are free, shape (rows, columns).

    Returns:
        The same shape: 0 where a cell is taken, else its patch's number, from 1 in the order of their first cells.
    """
    starts = free.copy()
    starts[:, 1:] &= ~free[:, :-1]
    runs = np.where(free, np.cumsum(starts).reshape(free.shape), 0)
    above, below = runs[:-1], runs[1:]
    meet = (above > 0) & (below > 0)
    meet[:, 1:] &= (above[:, 1:] != above[:, :-1]) | (below[:, 1:] != below[:, :-1])
    patches = joined(int(starts.sum()), zip(above[meet].tolist(), below[meet].tolist(), strict=True))
    return np.array(patches, dtype=np.int64)[runs]


def joined(count: int, pairs: Iterable[tuple[int, int]]) -> list[int]:
    """Returns each run's patch, for runs 1 to count; runs of a pair are of one patch. Entry 0 is 0."""
    first = list(range(count + 1))
    for pair in pairs:
        one, other = sorted(_first(first, run) for run in pair)
        first[other] = one
    patches = [0]
    found = 0
    for run in range(1, count + 1):
        if first[run] == run:
            found += 1
            patches.append(found)
        else:
            patches.append(patches[first[run]])
    return patches


def _first(first: list[int], run: int) -> int:
    while first[run] != run:
        first[run] = first[first[run]]
        run = first[run]
    return run
