"""What an answer is worth, added up anew: the worst that positions break, and what they cost.

Comes in: a `Problem`, read as data, and positions in metres. Written from the docstrings of problem.py.
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.geometry import Rect
from solver.placement.problem import DifferenceRow, ProblemBox
from tests.oracles.problem import Problem

Positions = Sequence[Sequence[float]]


def worst(problem: Problem, p: Positions) -> float:
    """Returns by how much the positions p[axis][variable], m, break a bound, row or choice at most; 0 if nothing."""
    broken = [0.0]
    for axis in (0, 1):
        for low, high, x in zip(problem.low[axis], problem.high[axis], p[axis], strict=True):
            broken += [low / 1000 - x, x - high / 1000]

    def short(row: tuple[int, int, int, int]) -> float:
        axis, i, j, s = row
        return s / 1000 - (p[axis][j] if j >= 0 else 0.0) + (p[axis][i] if i >= 0 else 0.0)

    broken += [short(row) for row in problem.rows]
    broken += [min((short(row) for row in choice.options), default=float("inf")) for choice in problem.choices]
    return max(broken)


def slack(row: DifferenceRow, p: Positions) -> float:
    """Returns how far a row is satisfied (< 0: violated) at positions p[axis][variable], mm."""
    own = p[row.axis]
    return (own[row.j] if row.j >= 0 else 0) - (own[row.i] if row.i >= 0 else 0) - row.s


def rect(box: ProblemBox, p: Sequence[Sequence[int]]) -> Rect:
    """Returns a box's footprint at integer positions p[axis][variable], mm."""
    x, z = (p[axis][box.var[axis]] + box.offset[axis] for axis in (0, 1))
    return Rect(x, z, x + box.extent[0], z + box.extent[1])


def cost(problem: Problem, p: Positions) -> float:
    """Returns the sum of the terms at positions p[axis][variable], m."""
    total = 0.0
    for term in problem.terms:
        own = p[term.axis]
        off = own[term.j] - (own[term.i] if term.i >= 0 else 0.0) - term.offset
        total += term.weight * off * off
    return float(total)
