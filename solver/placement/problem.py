"""A room's placement problem as plain data: variables, terms, rows and choices.

Along each axis a separately: minimise the sum of the terms, subject to low <= p <= high and the rows; and of every
choice at least one option must hold. See placement in ARCHITECTURE.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from solver.placement.constraints import ORIGIN, Choice, Part, Row
from solver.placement.terms import Term


@dataclass
class Problem:
    """Bounds are integer mm per axis and variable; `parts` maps variables to boxes."""

    low: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    high: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    terms: list[Term] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)
    parts: list[Part] = field(default_factory=list)
    choices: list[Choice] = field(default_factory=list)

    def variable(self, axis: int, low: int, high: int) -> int:
        """Adds a variable with bounds, mm, and returns its index along that axis."""
        self.low[axis].append(low)
        self.high[axis].append(high)
        return len(self.low[axis]) - 1

    def tighten(self, axis: int, i: int, low: int, high: int) -> None:
        """Intersects a variable's bounds with [low, high], mm."""
        self.low[axis][i] = max(self.low[axis][i], low)
        self.high[axis][i] = min(self.high[axis][i], high)

    def copy(self) -> Problem:
        """Returns a problem that can grow without changing this one."""
        return Problem(
            (list(self.low[0]), list(self.low[1])),
            (list(self.high[0]), list(self.high[1])),
            list(self.terms),
            list(self.rows),
            list(self.parts),
            list(self.choices),
        )

    def range_of(self, axis: int, i: int) -> tuple[int, int]:
        """Returns the bounds of a variable, mm; ORIGIN's are 0."""
        return (0, 0) if i == ORIGIN else (self.low[axis][i], self.high[axis][i])

    def choose(self, first: str, second: str, rows: Sequence[Row]) -> None:
        """Adds a choice, unless the bounds already settle it; options that the bounds rule out are dropped."""
        options: list[Row] = []
        for row in rows:
            if row.i == row.j:
                least = most = 0
            else:
                i_low, i_high = self.range_of(row.axis, row.i)
                j_low, j_high = self.range_of(row.axis, row.j)
                least, most = j_low - i_high, j_high - i_low
            if least >= row.s:
                return
            if most >= row.s:
                options.append(row)
        self.choices.append(Choice(first, second, tuple(options)))

    def violations(self, p: Sequence[Sequence[int]]) -> list[str]:
        """Lists, in exact integers, what the positions p[axis][variable] break; empty if nothing."""
        broken = []
        for axis in (0, 1):
            for i, (low, high) in enumerate(zip(self.low[axis], self.high[axis], strict=True)):
                if not low <= p[axis][i] <= high:
                    broken.append(f"variable {i} of axis {axis}: {p[axis][i]} outside [{low}, {high}]")
        broken += [f"{row}" for row in self.rows if row.slack(p) < 0]
        for choice in self.choices:
            if all(row.slack(p) < 0 for row in choice.options):
                broken.append(f"{choice.first} and {choice.second} are not apart")
        return broken
