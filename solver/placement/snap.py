"""Projection onto integer millimetres: every hard row becomes exactly true in integer arithmetic.

Comes in: a problem, rows, positions in metres. Goes out: positions in millimetres.
Difference constraints with integer data have an integer solution whenever they have a real one. The latest positions U
come from a backward sweep; then every position is rounded, clamped to U and pushed forward along the rows. Nothing moves
by more than about the rounding.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from solver.placement.problem import ORIGIN, DifferenceRow, Positions, Problem

TIE_MM = 0.49
"""Rounding adds this before flooring: wishes lie on half millimetres, so the switch is kept away from them and from a
continuous solver's last digits."""


def latest(low: Sequence[int], high: Sequence[int], rows: Sequence[DifferenceRow]) -> list[int] | None:
    """Returns the greatest integer positions within the bounds that hold every row, or None if there are none."""
    u = list(high)
    for _ in range(len(u) + 1):
        changed = False
        for _, i, j, s in rows:
            latest_i = (0 if j == ORIGIN else u[j]) - s
            if i == ORIGIN:
                if latest_i < 0:
                    return None
            elif u[i] > latest_i:
                u[i] = latest_i
                changed = True
        if any(top < bottom for top, bottom in zip(u, low, strict=True)):
            return None
        if not changed:
            return u
    return None


def _push(p: list[int], rows: Sequence[DifferenceRow]) -> None:
    """Moves positions up until every row holds; ends because a solution above them exists."""
    changed = True
    while changed:
        changed = False
        for _, i, j, s in rows:
            if j == ORIGIN:
                continue
            least = (0 if i == ORIGIN else p[i]) + s
            if p[j] < least:
                p[j] = least
                changed = True


def snap(problem: Problem, rows: Sequence[DifferenceRow], positions: Positions) -> tuple[list[int], list[int]]:
    """Returns integer positions, mm, near `positions` (m) at which the problem's rows and `rows` hold exactly.

    Raises:
        ValueError: the rows have no solution at all, which a search result never shows.
    """
    snapped: list[list[int]] = []
    for axis in (0, 1):
        own = [row for row in (*problem.rows, *rows) if row.axis == axis]
        upper = latest(problem.low[axis], problem.high[axis], own)
        if upper is None:
            raise ValueError(f"axis {axis}: the rows leave no integer position")
        p = [
            min(max(math.floor(float(x) * 1000 + TIE_MM), low), high)
            for x, low, high in zip(positions[axis], problem.low[axis], upper, strict=True)
        ]
        _push(p, own)
        snapped.append(p)
    return snapped[0], snapped[1]
