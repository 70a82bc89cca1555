"""A mixed-integer programme for HiGHS, written by rows: expressions, binaries, rows that hold where binaries are 1."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import csr_matrix

BIG = 40.0
"""More than any difference of two positions, m."""


class Expr(dict[int, float]):
    """A linear expression: coefficient by variable; -1 holds the constant."""

    def __add__(self, other: Expr | float) -> Expr:
        total = Expr(self)
        for k, c in other.items() if isinstance(other, Expr) else [(-1, float(other))]:
            total[k] = total.get(k, 0.0) + c
        return total

    def __neg__(self) -> Expr:
        return Expr({k: -c for k, c in self.items()})

    def __sub__(self, other: Expr | float) -> Expr:
        return self + -other

    def times(self, c: float) -> Expr:
        return Expr({k: c * v for k, v in self.items()})


class Programme:
    """Variables and rows for milp."""

    def __init__(self) -> None:
        self.bounds: list[tuple[float, float, int]] = []
        self.rows: list[tuple[Expr, float]] = []

    def variable(self, low: float, high: float, whole: bool = False) -> Expr:
        self.bounds.append((low, high, int(whole)))
        return Expr({len(self.bounds) - 1: 1.0})

    def binary(self) -> Expr:
        return self.variable(0, 1, True)

    def at_least(self, expr: Expr, least: float, *unless: Expr) -> None:
        """Expr >= least where all the `unless` binaries are 1."""
        total = expr - least
        for one in unless:
            total = total + one.times(-BIG) + BIG
        self.rows.append((total, 0.0))

    def one_of(self, options: Sequence[Expr], when: Expr | None = None) -> None:
        """At least one of the options where `when` is 1."""
        total = Expr()
        for option in options:
            total = total + option
        self.rows.append((total - when if when is not None else total - 1.0, 0.0))

    def solve(self, objective: Expr, seconds: float) -> tuple[str, np.ndarray[Any, Any] | None]:
        rows, columns, values, least = [], [], [], []
        for k, (expr, bound) in enumerate(self.rows):
            least.append(bound - expr.get(-1, 0.0))
            for column, value in expr.items():
                if column >= 0 and value:
                    rows.append(k)
                    columns.append(column)
                    values.append(value)
        n = len(self.bounds)
        matrix = csr_matrix((values, (rows, columns)), shape=(len(self.rows), n))
        goal = np.zeros(n)
        for column, value in objective.items():
            if column >= 0:
                goal[column] = -value
        lows, highs, whole = (np.array(part, dtype=float) for part in zip(*self.bounds, strict=True))
        result = milp(
            goal, integrality=whole, bounds=Bounds(lows, highs), constraints=LinearConstraint(matrix, np.array(least) - 1e-7, np.inf),
            options={"time_limit": seconds, "mip_rel_gap": 0.0},
        )  # fmt: skip
        word = {0: "solved", 1: "limit", 2: "infeasible"}.get(result.status, "limit")
        return word, result.x
