"""A room's problem written for reading, in cvxpy: choices made, one axis at a time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cvxpy
import numpy as np

from solver.placement.layout import Floats
from solver.placement.problem import ORIGIN
from tests.oracles.problem import Positions, Problem, Solution

cp: Any = cvxpy  # its annotations do not cover its own names


def _axis(problem: Problem, solution: Solution, axis: int) -> Floats:
    low = np.array(problem.low[axis]) / 1000
    high = np.array(problem.high[axis]) / 1000
    if not len(low):
        return np.zeros(0)
    p = cp.Variable(len(low))

    def difference(i: int, j: int) -> Any:
        return (0 if j == ORIGIN else p[j]) - (0 if i == ORIGIN else p[i])

    cost = [term.weight * cp.square(difference(term.i, term.j) - term.offset) for term in problem.terms if term.axis == axis]
    rows = [row for row in (*problem.rows, *solution.rows) if row.axis == axis and row.i != row.j]
    rules = [low <= p, p <= high, *(difference(row.i, row.j) >= row.s / 1000 for row in rows)]
    close = dict.fromkeys(("tol_gap_abs", "tol_gap_rel", "tol_feas"), 1e-12)
    cp.Problem(cp.Minimize(cp.sum(cost)), rules).solve(solver=cp.CLARABEL, **close)
    positions: Floats = np.asarray(p.value, dtype=np.float64)
    return positions


def solve_house(rooms: Sequence[tuple[Problem, Solution]]) -> list[Positions]:
    """Returns positions per room, axis and variable, m."""
    return [(_axis(problem, solution, 0), _axis(problem, solution, 1)) for problem, solution in rooms]
