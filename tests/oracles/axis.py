"""The quadratic programme of one axis with the choices made: a convex QP over difference rows, in DAQP.

Comes in: a `Problem`, read as data. Fixed variables are eliminated. DAQP is a dual active-set method (Arnstrom et al., IEEE TAC
2022): 4 us a solve at these sizes, exact to 1e-9 m.
"""

from __future__ import annotations

from collections.abc import Sequence

import daqp
import numpy as np
from numpy.typing import NDArray

from solver.placement.problem import ORIGIN
from solver.placement.problem import DifferenceRow as Row
from tests.oracles.problem import Problem

Floats = NDArray[np.float64]

ROW_TOLERANCE = 1e-7
"""A row violated by less, m, counts as held; a chain of 100 rows still stays far below the lattice's millimetre."""
_SPARE_ROWS = 192
_NO_LIMIT = 1e30


class AxisProgram:
    """One axis of a problem, ready to be solved with more rows.

    Args:
        problem: the room's problem; its bounds and rows are read once.
        axis: 0 for x, 1 for z.
    """

    def __init__(self, problem: Problem, axis: int) -> None:
        self.axis = axis
        low, high = problem.low[axis], problem.high[axis]
        self.feasible = all(a <= b for a, b in zip(low, high, strict=True))
        self.values = np.array(low, dtype=np.float64) / 1000
        self.free = [i for i, (a, b) in enumerate(zip(low, high, strict=True)) if a < b]
        self.place = {variable: column for column, variable in enumerate(self.free)}
        self.low = np.array([low[i] for i in self.free], dtype=np.float64) / 1000
        self.high = np.array([high[i] for i in self.free], dtype=np.float64) / 1000
        self._objective(problem)
        self._buffers()
        self.base = 0
        self.written: list[Row] = []
        for row in problem.rows:
            if row.axis == axis:
                self.feasible &= self._write(row, self.base)
                self.base += 1

    def _objective(self, problem: Problem) -> None:
        n = len(self.values)
        H, f, constant = np.zeros((n, n)), np.zeros(n), 0.0
        for axis, i, j, offset, weight in problem.terms:
            if axis == self.axis:
                a = np.zeros(n)
                a[j] += 1
                if i != ORIGIN:
                    a[i] -= 1
                H += 2 * weight * np.outer(a, a)
                f -= 2 * weight * offset * a
                constant += weight * offset**2
        fixed = self.values.copy()
        fixed[self.free] = 0.0
        rest = H @ fixed
        self.constant = float(constant + f @ fixed + 0.5 * fixed @ rest)
        self.H = np.ascontiguousarray(H[np.ix_(self.free, self.free)]) if self.free else np.zeros((0, 0))
        self.f = np.ascontiguousarray((f + rest)[self.free])

    def _buffers(self) -> None:
        n = len(self.free)
        self.rows = np.zeros((_SPARE_ROWS, n))
        self.upper = np.full(n + _SPARE_ROWS, _NO_LIMIT)
        self.lower = np.full(n + _SPARE_ROWS, -_NO_LIMIT)
        self.sense = np.zeros(n + _SPARE_ROWS, dtype=np.int32)
        self.upper[:n], self.lower[:n] = self.high, self.low

    def _write(self, row: Row, at: int) -> bool:
        """Writes a row into the buffers; returns False where it has no free variable and does not hold."""
        if at >= len(self.rows):
            self._grow()
        coefficients = self.rows[at]
        coefficients[:] = 0.0
        rest = row.s / 1000
        empty = True
        for variable, sign in ((row.j, 1.0), (row.i, -1.0)) if row.i != row.j else ():
            if variable == ORIGIN:
                continue
            column = self.place.get(variable)
            if column is None:
                rest -= sign * self.values[variable]
            else:
                coefficients[column] = sign
                empty = False
        self.lower[len(self.free) + at] = -_NO_LIMIT if empty else rest
        return not empty or rest <= ROW_TOLERANCE

    def _grow(self) -> None:
        n, more = len(self.free), len(self.rows)
        self.rows = np.vstack([self.rows, np.zeros((more, n))])
        self.upper = np.concatenate([self.upper, np.full(more, _NO_LIMIT)])
        self.lower = np.concatenate([self.lower, np.full(more, -_NO_LIMIT)])
        self.sense = np.zeros(len(self.upper), dtype=np.int32)

    def stack(self, extra: Sequence[Row]) -> tuple[Floats, Floats, int] | None:
        """Returns (A, lower, count) of the base rows and the extra ones, or None where one can never hold.

        A has shape (count, free variables); lower has shape (free variables + count,), bounds first. Both are views.
        """
        if not self.feasible:
            return None
        same = 0
        for old, new in zip(self.written, extra, strict=False):
            if old is not new:
                break
            same += 1
        del self.written[same:]
        for row in extra[same:]:
            if not self._write(row, self.base + len(self.written)):
                return None
            self.written.append(row)
        at = self.base + len(extra)
        return self.rows[:at], self.lower[: len(self.free) + at], at

    def solve(self, extra: Sequence[Row]) -> tuple[float, Floats] | None:
        """Solves with extra rows of this axis.

        Returns:
            (cost, positions in m of all variables), or None when infeasible.
        """
        stacked = self.stack(extra)
        if stacked is None:
            return None
        if not self.free:
            return self.constant, self.values
        A, lower, count = stacked
        size = len(self.free) + count
        x, value, status, _ = daqp.solve(self.H, self.f, A, self.upper[:size], lower, self.sense[:size])
        if status != 1:
            return None
        return self.constant + float(value), self.spread(x)

    def spread(self, x: Floats) -> Floats:
        """Returns positions of all variables, m, from those of the free ones."""
        positions = self.values.copy()
        positions[self.free] = x
        return positions
