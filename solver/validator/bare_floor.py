"""How much floor of a room is empty: the largest square, and strips before a side. In whole lattice steps, by what could be in the way."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.demanded import demand
from solver.validator.lattice import ExactBox

LINE_WORK: Final = 0.02
ONE_LINE: Final = 1500
"""What a box costs at each line that a square may begin at, and how many boxes' worth the line itself [see demanded.py]. Measured."""


def largest_square(bounds: ExactBox, taken: Sequence[ExactBox]) -> ExactBox | None:
    """Returns the largest empty square, the north-western of equal ones; None where no floor is empty.

    Pushed to the west and north as far as it goes, it lies at the bounds or at the edges of boxes.

    Raises:
        TooMuch: the call may not have so much work.
    """
    best: ExactBox | None = None
    most = 0
    norths = sorted({bounds.z0, *(box.z1 for box in taken if bounds.z0 <= box.z1 < bounds.z1)})
    demand(LINE_WORK * len(norths) * (len(taken) + ONE_LINE))
    ahead = np.array(sorted(taken), dtype=np.int64).reshape(-1, 4)
    for z in norths:
        ahead = ahead[ahead[:, 3] > z]
        while (x := _first_start(bounds, ahead, z, most + 1)) is not None:
            beside = ahead[ahead[:, 2] > x]
            free = np.maximum(beside[:, 0] - x, beside[:, 1] - z).min(initial=min(bounds.x1 - x, bounds.z1 - z))
            most = int(free)
            best = ExactBox(x, z, x + most, z + most)
    return best


def _first_start(bounds: ExactBox, ahead: NDArray[np.int64], z: int, side: int) -> int | None:
    """Returns the westernmost place within bounds where an empty square of a side, its north at z, begins.

    `ahead` are the boxes that end south of z, from west to east by where they begin.
    """
    beside = ahead[ahead[:, 1] < z + side]
    starts = np.maximum.accumulate(np.concatenate(([bounds.x0], beside[:, 2])))
    ends = np.minimum(np.concatenate((beside[:, 0], [bounds.x1])), bounds.x1)
    fits = np.flatnonzero(ends - starts >= side)
    return int(starts[fits[0]]) if fits.size and z + side <= bounds.z1 else None


def turned(box: ExactBox, side: str) -> ExactBox:
    """Returns a box in a frame in which what a side of the room's looks to is south."""
    if side == "south":
        return box
    if side == "north":
        return ExactBox(-box.x1, -box.z1, -box.x0, -box.z0)
    if side == "east":
        return ExactBox(-box.z1, box.x0, -box.z0, box.x1)
    return ExactBox(box.z0, -box.x1, box.z1, -box.x0)


def depth_before(bounds: ExactBox, taken: Sequence[ExactBox], line: int, span: tuple[int, int]) -> int:
    """Returns how deep the floor south of a line is empty over a whole span; nothing where the span leaves the bounds."""
    if span[0] < bounds.x0 or span[1] > bounds.x1:
        return 0
    ahead = [box.z0 - line for box in taken if box.x0 < span[1] and box.x1 > span[0] and box.z1 > line]
    return max(0, min([bounds.z1 - line, *ahead]))


def deepest_before(bounds: ExactBox, taken: Sequence[ExactBox], piece: ExactBox, wide: int) -> int:
    """Returns how deep an empty rectangle of a width south of a piece can be, its middle within the piece's extent."""
    low, high = piece.x0 - wide // 2, piece.x1 - wide // 2
    starts = {low, high, bounds.x0, bounds.x1 - wide, *(box.x1 for box in taken), *(box.x0 - wide for box in taken)}
    return max((depth_before(bounds, taken, piece.z1, (at, at + wide)) for at in starts if low <= at <= high), default=0)
