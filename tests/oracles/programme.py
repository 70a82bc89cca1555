"""A mixed-integer programme in HiGHS, through scipy, written row by row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.optimize import Bounds, LinearConstraint, milp

_LIMIT, _INFEASIBLE = 1, 2
Terms = Sequence[tuple[int, float]]
"""A linear expression: (variable, coefficient)."""
Floats = NDArray[np.float64]


@dataclass
class Programme:
    """A mixed-integer programme under construction: minimise cost'x, rows >= lower, bounds, integrality."""

    low: list[float] = field(default_factory=list)
    high: list[float] = field(default_factory=list)
    whole: list[int] = field(default_factory=list)
    cost: list[float] = field(default_factory=list)
    entries: list[tuple[int, int, float]] = field(default_factory=list)
    lower: list[float] = field(default_factory=list)

    def variable(self, low: float, high: float, whole: bool = False, cost: float = 0.0) -> int:
        """Adds a variable and returns its index."""
        self.low.append(low)
        self.high.append(high)
        self.whole.append(int(whole))
        self.cost.append(cost)
        return len(self.low) - 1

    def binary(self, cost: float = 0.0) -> int:
        """Adds a variable that is 0 or 1."""
        return self.variable(0, 1, whole=True, cost=cost)

    def at_least(self, entries: Terms, lower: float) -> None:
        """Adds a row: the sum of coefficient times variable is at least `lower`."""
        row = len(self.lower)
        self.entries += [(row, variable, coefficient) for variable, coefficient in entries]
        self.lower.append(lower)

    def least(self, entries: Terms) -> float:
        """Returns the least value the bounds allow an expression."""
        return sum(c * (self.low[i] if c > 0 else self.high[i]) for i, c in entries)

    def solve(self, seconds: float) -> tuple[bool | None, Floats]:
        """Returns whether it can be met, None where the time ran out first, and the solution."""
        if not self.low:
            return all(lower <= 0 for lower in self.lower), np.zeros(0)
        if any(a > b for a, b in zip(self.low, self.high, strict=True)):
            return False, np.zeros(0)
        rows, columns, values = zip(*self.entries, strict=True) if self.entries else ((), (), ())
        shape = (len(self.lower), len(self.low))
        matrix = sparse.csr_matrix((np.array(values, dtype=float), (np.array(rows, dtype=int), np.array(columns, dtype=int))), shape)
        rules = LinearConstraint(matrix, np.array(self.lower), np.inf) if self.lower else ()
        result = milp(
            np.array(self.cost), integrality=np.array(self.whole), bounds=Bounds(np.array(self.low), np.array(self.high)),
            constraints=rules, options={"time_limit": seconds, "mip_rel_gap": 1e9},
        )  # fmt: skip
        if result.x is not None:
            return True, result.x
        if result.status not in (_LIMIT, _INFEASIBLE):
            raise RuntimeError(f"HiGHS: {result.message}")
        return (False if result.status == _INFEASIBLE else None), np.zeros(0)
