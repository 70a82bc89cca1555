"""The final continuous solve of a whole house by OSQP, as one block-diagonal problem with the choices made.

Comes in: rooms' problems and what the search found. Goes out: positions. Variables without room to move are left out, and what is
known of them goes into the constants. OSQP: Stellato et al., Mathematical Programming Computation 2020.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np
import osqp
from scipy import sparse

from solver.placement.kernel.layout import Floats
from solver.placement.problem import ORIGIN, Positions, Problem, Solution

SETTINGS = {
    "verbose": False,
    "eps_abs": 1e-9,
    "eps_rel": 1e-9,
    "max_iter": 20_000,
    "check_termination": 25,
    "adaptive_rho": 1,  # by iterations: time-based rho is not deterministic
    "adaptive_rho_interval": 25,
    "polishing": False,  # prints to stdout whatever `verbose` says; 1e-9 needs none
    "warm_starting": False,
}
"""OSQP 1.x settings."""
NEAR = 0.05
"""Choices' rows with more slack than this at the search's optimum, m, are left out: they cannot bind at the same optimum, and
whatever the solver returns is snapped and checked against all of them."""
_SOLVED = 1

Difference = tuple[list[tuple[int, int]], float]
"""p_j - p_i: the columns of those that may move, each with its sign, and what the others are, m."""


class _Programme:
    """minimise 1/2 x'Px + q'x subject to low <= Ax <= high, an entry after the other; bounds first in each axis of a room."""

    def __init__(self) -> None:
        self.columns = 0
        self.squares: dict[tuple[int, int], float] = {}
        self.linear: list[float] = []
        self.entries: list[tuple[int, int, int]] = []
        self.low: list[float] = []
        self.high: list[float] = []

    def add(self, problem: Problem, solution: Solution, axis: int) -> list[int | None]:
        """Adds an axis of a room; returns the columns of its variables, None for those that cannot move."""
        columns: list[int | None] = []
        for low, high in zip(problem.low[axis], problem.high[axis], strict=True):
            columns.append(self.columns if low < high else None)
            if low < high:
                self._row([(self.columns, 1)], low / 1000, high / 1000)
                self.linear.append(0.0)
                self.columns += 1
        for term in problem.terms:
            if term.axis == axis:
                self._square(_difference(problem, columns, axis, (term.i, term.j)), term.offset, term.weight)
        p: list[float] = (solution.positions[axis] * 1000).tolist()
        near = (row for row in solution.rows if row.axis == axis and row.slack((p, p)) <= NEAR * 1000)
        for row in (*(row for row in problem.rows if row.axis == axis), *near):
            signs, rest = _difference(problem, columns, axis, (row.i, row.j))
            if signs:
                self._row(signs, row.s / 1000 - rest, np.inf)
        return columns

    def _row(self, signs: Sequence[tuple[int, int]], low: float, high: float) -> None:
        self.entries += [(len(self.low), column, sign) for column, sign in signs]
        self.low.append(low)
        self.high.append(high)

    def _square(self, difference: Difference, offset: float, weight: float) -> None:
        """Adds weight * (difference - offset)^2."""
        signs, rest = difference
        for column, sign in signs:
            self.linear[column] += 2 * weight * sign * (rest - offset)
        for (one, s), (two, t) in product(signs, signs):
            if one <= two:  # OSQP wants the upper triangle
                self.squares[one, two] = self.squares.get((one, two), 0.0) + 2 * weight * s * t

    def solve(self) -> Floats | None:
        """Returns the columns' positions, m; None where OSQP does not report success."""
        above, across = zip(*self.squares, strict=True)
        P = sparse.csc_matrix((list(self.squares.values()), (above, across)), shape=(self.columns, self.columns))
        rows, columns, signs = zip(*self.entries, strict=True)
        A = sparse.csc_matrix((np.array(signs, dtype=float), (rows, columns)), shape=(len(self.low), self.columns))
        solver = osqp.OSQP(algebra="builtin")
        solver.setup(P, np.array(self.linear), A, np.array(self.low), np.array(self.high), **SETTINGS)
        result = solver.solve(raise_error=False)
        x: Floats = result.x
        return x if result.info.status_val == _SOLVED else None


def _difference(problem: Problem, columns: Sequence[int | None], axis: int, variables: tuple[int, int]) -> Difference:
    signs, rest = [], 0.0
    for variable, sign in zip(variables, (-1, 1), strict=True):
        if variable == ORIGIN or variables[0] == variables[1]:
            continue
        column = columns[variable]
        if column is None:
            rest += sign * problem.low[axis][variable] / 1000
        else:
            signs.append((column, sign))
    return signs, rest


def solve_house(rooms: Sequence[tuple[Problem, Solution]]) -> list[Positions]:
    """Solves all rooms at once.

    Returns:
        Positions per room, axis and variable, m. Where OSQP does not report success, the search's own positions, which
        are optimal already.
    """
    programme = _Programme()
    columns = [[programme.add(problem, solution, axis) for axis in (0, 1)] for problem, solution in rooms]
    x = programme.solve() if programme.columns else None
    if x is None:
        return [solution.positions for _, solution in rooms]
    found = []
    for (_, solution), both in zip(rooms, columns, strict=True):
        p = [axis.copy() for axis in solution.positions]
        for axis in (0, 1):
            for variable, column in enumerate(both[axis]):
                if column is not None:
                    p[axis][variable] = x[column]
        found.append((p[0], p[1]))
    return found
