"""The same problem written for reading, in cvxpy: choices made, one axis at a time.

Used by tests, documentation and `--engine reference`; never on the default request path.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cvxpy
import numpy as np

from solver.placement.constraints import ORIGIN
from solver.placement.qp import Decided
from solver.placement.terms import Anchor, Floats

cp: Any = cvxpy  # its annotations do not cover its own names


def _axis(room: Decided, axis: int) -> Floats:
    low = np.array(room.problem.low[axis]) / 1000
    high = np.array(room.problem.high[axis]) / 1000
    if not len(low):
        return np.zeros(0)
    p = cp.Variable(len(low))
    cost = []
    for term in room.problem.terms:
        if term.axis == axis:
            if isinstance(term, Anchor):
                cost.append(term.weight * cp.square(p[term.i] - term.wish))
            else:
                cost.append(term.weight * cp.square(p[term.j] - p[term.i] - term.offset))
    rules = [low <= p, p <= high]
    for row in (*room.problem.rows, *room.rows):
        if row.axis == axis and row.i != row.j:
            after = 0 if row.j == ORIGIN else p[row.j]
            before = 0 if row.i == ORIGIN else p[row.i]
            rules.append(after - before >= row.s / 1000)
    close = dict.fromkeys(("tol_gap_abs", "tol_gap_rel", "tol_feas"), 1e-12)
    cp.Problem(cp.Minimize(cp.sum(cost)), rules).solve(solver=cp.CLARABEL, **close)
    solution: Floats = np.asarray(p.value, dtype=np.float64)
    return solution


def solve_house(rooms: Sequence[Decided]) -> list[tuple[Floats, Floats]]:
    """Returns positions per room, axis and variable, m, as `qp.solve_house` does."""
    return [(_axis(room, 0), _axis(room, 1)) for room in rooms]
