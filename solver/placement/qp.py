"""The final continuous solve of a whole house by OSQP, as one block-diagonal problem with the choices made.

Comes in: rooms' problems and what the search found. Goes out: positions, how exactly they are the optimum, and what holds each piece.
OSQP begins at the search's optimum and at the multipliers that belong to it, so that it confirms rather than solves. Variables without
room to move are left out, and what is known of them goes into the constants.
OSQP: Stellato et al., Mathematical Programming Computation 2020.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import product

import numpy as np
import osqp
from scipy import sparse

from solver.pieces import Residuals
from solver.placement.layout import Floats
from solver.placement.problem import ORIGIN, Confirmed, DifferenceRow, Force, Positions, Problem, Solution

SETTINGS = {
    "verbose": False,
    "eps_abs": 1e-9,
    "eps_rel": 1e-9,
    "max_iter": 20_000,
    "check_termination": 1,  # from the search's optimum a few iterations do
    "adaptive_rho": 1,  # by iterations: time-based rho is not deterministic
    "adaptive_rho_interval": 25,
    "polishing": False,  # prints to stdout whatever `verbose` says; 1e-9 needs none
}
"""OSQP 1.x settings."""
NEAR = 0.05
"""Choices' rows with more slack than this at the search's optimum, m, are left out: they cannot bind at the same optimum, and
whatever the solver returns is snapped and checked against all of them."""
ACTIVE = 1e-6
"""A row with less slack, m, holds what it is about."""
LEAST_DECADE = -6
"""Residuals below 10 to this power are said to be that: the last digits, which a machine may change, decide no byte."""
REFUTED = 1e-5
"""A proven optimum that is this far, m, from OSQP's is none."""
_SOLVED = 1

Difference = tuple[list[tuple[int, int]], float]
"""p_j - p_i: the columns of those that may move, each with its sign, and what the others are, m."""


class OptimumRefuted(Exception):
    """OSQP finds another optimum than the one that was called proven: a fault of ours.

    Args:
        problem: the room's.
        solution: what was called its optimum.
    """

    def __init__(self, problem: Problem, solution: Solution) -> None:
        super().__init__(f"OSQP finds a cheaper placement than the proven one of {problem}: {solution}")
        self.problem, self.solution = problem, solution


class _Block:
    """One axis of a room: minimise 1/2 x'Px + q'x subject to low <= Ax <= high; the bounds come first.

    Args:
        problem: the room's.
        solution: what the search found.
        axis: 0 or 1.
    """

    def __init__(self, problem: Problem, solution: Solution, axis: int) -> None:
        self.axis, self._fixed = axis, [low / 1000 for low in problem.low[axis]]
        self._column: list[int | None] = []
        self.rows: list[DifferenceRow] = []
        self._choices: list[int | None] = []
        self.entries: list[tuple[int, int, int]] = []
        self.low: list[float] = []
        self.high: list[float] = []
        free = 0
        for low, high in zip(problem.low[axis], problem.high[axis], strict=True):
            self._column.append(free if low < high else None)
            free += low < high
        self.linear, self.squares = np.zeros(free), np.zeros((free, free))
        for variable, column in enumerate(self._column):
            if column is not None:
                low, high = problem.low[axis][variable], problem.high[axis][variable]
                self._add(DifferenceRow(axis, ORIGIN, variable, low), None, [(column, 1)], (low / 1000, high / 1000))
        self._bounds = len(self.rows)
        for term in problem.terms:
            if term.axis == axis:
                self._square(self._difference(term.i, term.j), term.offset, term.weight)
        p: list[float] = (solution.positions[axis] * 1000).tolist()
        always = ((None, row) for row in problem.rows)
        near = ((k, row) for k, row in enumerate(solution.rows) if row.axis == axis and row.slack((p, p)) <= NEAR * 1000)
        for choice, row in (*always, *near):
            signs, rest = self._difference(row.i, row.j) if row.axis == axis else ([], 0.0)
            if signs:
                self._add(row, choice, signs, (row.s / 1000 - rest, np.inf))
        moving = [k for k, column in enumerate(self._column) if column is not None]
        self.found = solution.multipliers
        self.start: Floats = solution.positions[axis][moving]
        self.matrix = np.zeros((len(self.rows), free))
        for at, column, sign in self.entries:
            self.matrix[at, column] = sign

    def _add(self, row: DifferenceRow, choice: int | None, signs: Sequence[tuple[int, int]], between: tuple[float, float]) -> None:
        self.entries += [(len(self.rows), column, sign) for column, sign in signs]
        self.rows.append(row)
        self._choices.append(choice)
        self.low.append(between[0])
        self.high.append(between[1])

    def _difference(self, i: int, j: int) -> Difference:
        signs, rest = [], 0.0
        for variable, sign in ((i, -1), (j, 1)):
            if variable == ORIGIN or i == j:
                continue
            column = self._column[variable]
            if column is None:
                rest += sign * self._fixed[variable]
            else:
                signs.append((column, sign))
        return signs, rest

    def _square(self, difference: Difference, offset: float, weight: float) -> None:
        """Adds weight * (difference - offset)^2."""
        signs, rest = difference
        for column, sign in signs:
            self.linear[column] += 2 * weight * sign * (rest - offset)
        for (one, s), (two, t) in product(signs, signs):
            self.squares[one, two] += 2 * weight * s * t

    def multipliers(self, found: Iterable[tuple[int, int, int, float]]) -> Floats:
        """Returns the rows' multipliers at the search's optimum: each goes to the first row between the same columns that binds there."""
        at = self.matrix @ self.start
        below, above = at - self.low <= ACTIVE, self.high - at <= ACTIVE
        rows: dict[tuple[int, int], int] = {}
        for k, (binds, ends) in enumerate(zip(below.tolist(), self._ends(), strict=True)):
            if binds:
                rows.setdefault(ends, k)
        values: Floats = np.zeros(len(self.rows))
        for axis, i, j, value in found:
            if axis == self.axis and (i, j) in rows:
                values[rows[i, j]] -= value
            elif axis == self.axis and j == ORIGIN and above[i]:
                values[i] += value
        return values

    def _ends(self) -> list[tuple[int, int]]:
        """Returns the columns that each row keeps apart, ORIGIN for none; the rows of bounds are numbered as their columns."""
        ends = [[ORIGIN, ORIGIN] for _ in self.rows]
        for row, column, sign in self.entries:
            ends[row][0 if sign < 0 else 1] = column
        return [(i, j) for i, j in ends]

    def residuals(self, x: Floats, y: Floats) -> tuple[float, float, float]:
        """Returns by how much positions break a row, m, are drawn at all, and differ from the dual's value."""
        at, squared = self.matrix @ x, self.squares @ x
        low, high = np.array(self.low), np.array(self.high)
        broken = np.maximum(np.maximum(low - at, at - high), 0.0)
        support = np.where(y > 0, np.where(np.isinf(high), 0.0, high), low) * y
        gap = x @ squared + self.linear @ x + support.sum()
        drawn = squared + self.linear + self.matrix.T @ y
        return float(broken.max(initial=0.0)), float(np.abs(drawn).max(initial=0.0)), abs(float(gap))

    def forces(self, y: Floats) -> Iterator[Force]:
        """Yields what holds, by more than the solver's tolerance."""
        for k, (row, value) in enumerate(zip(self.rows, y.tolist(), strict=True)):
            if value < -ACTIVE:
                yield Force(row, -value, self._choices[k], k < self._bounds)
            elif value > ACTIVE:
                yield Force(DifferenceRow(row.axis, row.j, ORIGIN, -round(self.high[k] * 1000)), value, bound=True)

    def placed(self, x: Floats, positions: Floats) -> Floats:
        """Returns all of the axis's positions with the columns' own."""
        moved = positions.copy()
        for variable, column in enumerate(self._column):
            if column is not None:
                moved[variable] = x[column]
        return moved


def confirmed(rooms: Sequence[tuple[Problem, Solution]]) -> list[Confirmed]:
    """Solves all rooms at once.

    Raises:
        OptimumRefuted: OSQP finds another optimum than one that was proven.

    Returns:
        What OSQP says of each room. Where it does not report success, the search's own positions, which are optimal already, with
        no residuals.
    """
    blocks = [(_Block(problem, solution, 0), _Block(problem, solution, 1)) for problem, solution in rooms]
    solved = _solved([block for both in blocks for block in both])
    if solved is None:
        return [Confirmed(solution.positions, None) for _, solution in rooms]
    found = []
    for k, ((_, solution), both) in enumerate(zip(rooms, blocks, strict=True)):
        answers = solved[2 * k : 2 * k + 2]
        x, z = (block.placed(own, p) for block, (own, _), p in zip(both, answers, solution.positions, strict=True))
        if solution.proven and max(_moved(p, q) for p, q in zip((x, z), solution.positions, strict=True)) > REFUTED:
            raise OptimumRefuted(rooms[k][0], solution)
        worst = [max(pair) for pair in zip(*(block.residuals(*own) for block, own in zip(both, answers, strict=True)), strict=True)]
        forces = tuple(force for block, (_, y) in zip(both, answers, strict=True) for force in block.forces(y))
        found.append(Confirmed((x, z), Residuals(*map(_decade, worst)), forces))
    return found


def solve_house(rooms: Sequence[tuple[Problem, Solution]]) -> list[Positions]:
    """Returns the confirmed positions per room, axis and variable, m."""
    return [room.positions for room in confirmed(rooms)]


def _solved(blocks: Sequence[_Block]) -> list[tuple[Floats, Floats]] | None:
    """Returns each block's positions and multipliers; None where OSQP does not report success."""
    columns = np.cumsum([0, *(len(block.start) for block in blocks)])
    rows = np.cumsum([0, *(len(block.rows) for block in blocks)])
    if not columns[-1]:
        return [(block.start, np.zeros(0)) for block in blocks]
    places = [np.nonzero(np.triu(block.squares)) for block in blocks]  # OSQP wants the upper triangle
    values = np.concatenate([block.squares[place] for block, place in zip(blocks, places, strict=True)])
    one, two = (np.concatenate([place[k] + at for place, at in zip(places, columns, strict=False)]) for k in (0, 1))
    P = sparse.csc_matrix((values, (one, two)), shape=(columns[-1], columns[-1]))
    shifts = (np.array([row, column, 0]) for row, column in zip(rows, columns, strict=True))
    entries = np.concatenate([np.array(block.entries).reshape(-1, 3) + shift for block, shift in zip(blocks, shifts, strict=False)])
    A = sparse.csc_matrix((entries[:, 2].astype(float), (entries[:, 0], entries[:, 1])), shape=(rows[-1], columns[-1]))
    low, high = (np.concatenate([getattr(block, end) for block in blocks]) for end in ("low", "high"))
    solver = osqp.OSQP(algebra="builtin")
    solver.setup(P, np.concatenate([block.linear for block in blocks]), A, low, high, **SETTINGS)
    solver.warm_start(
        np.concatenate([block.start for block in blocks]), np.concatenate([block.multipliers(block.found) for block in blocks])
    )
    result = solver.solve(raise_error=False)
    if result.info.status_val != _SOLVED:
        return None
    return [
        (result.x[columns[k] : columns[k + 1]], result.y[rows[k] : rows[k + 1]]) for k in range(len(blocks))
    ]  # fmt: skip


def _moved(p: Floats, q: Floats) -> float:
    return float(np.abs(p - q).max(initial=0.0))


def _decade(value: float) -> int:
    """Returns the least power of ten that a value does not exceed, so that the last digits of a machine decide nothing."""
    return max(LEAST_DECADE, math.ceil(math.log10(value))) if value > 0 else LEAST_DECADE
