"""How much floor of a room is empty: the largest square, and strips before a side. In whole lattice steps, by what could be in the way.

Comes in: a room's bounds and boxes. Goes out: lengths and places. May import: nothing but the lattice.
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.validator.lattice import ExactBox


def largest_square(bounds: ExactBox, taken: Sequence[ExactBox]) -> ExactBox | None:
    """Returns the largest empty square, the north-western of equal ones; None where no floor is empty.

    Pushed to the west and north as far as it goes, it lies at the bounds or at the edges of boxes.
    """
    best: ExactBox | None = None
    most = 0
    for z in sorted({bounds.z0, *(box.z1 for box in taken if bounds.z0 <= box.z1 < bounds.z1)}):
        for x in sorted({bounds.x0, *(box.x1 for box in taken if bounds.x0 <= box.x1 < bounds.x1)}):
            side = min(bounds.x1 - x, bounds.z1 - z)
            if side <= most:
                continue
            side = min([side, *(max(box.x0 - x, box.z0 - z) for box in taken if box.x1 > x and box.z1 > z)])
            if side > most:
                most, best = side, ExactBox(x, z, x + side, z + side)
    return best


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
