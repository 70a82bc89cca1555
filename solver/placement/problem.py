"""A room's placement problem and its solution as plain data: variables, terms, rows and choices.

Along each axis apart: minimise the sum of the terms, subject to low <= p <= high and the rows; and of every choice at least one option must
hold. Variables are min corners; terms count in metres, everything else in whole millimetres. docs/maths.md says it at more length.
"""

from dataclasses import dataclass, field
from typing import Final, NamedTuple

import numpy as np

from solver.pieces import Residuals
from solver.placement.layout import Floats, Ints

ORIGIN: Final = -1
"""Stands for the constant 0 in place of a variable, so that a wished place is a difference, and a bound a row, as well."""

Positions = tuple[Floats, Floats]
"""By axis and variable, m."""


class Term(NamedTuple):
    """Costs weight * (p_j - p_i - offset)^2 along `axis` (0: x, 1: z).

    With i = ORIGIN a body wants to be at a place; else two bodies want to keep a distance. Offset in m, weight in m^-2, > 0.
    """

    axis: int
    i: int
    j: int
    offset: float
    weight: float


class DifferenceRow(NamedTuple):
    """Asks for p_j - p_i >= s, along `axis`, mm."""

    axis: int
    i: int
    j: int
    s: int


class ProblemBox(NamedTuple):
    """A box of the problem: a body, or a stand (a person's square before a use side).

    Its min corner along axis a is position[var[a]] + offset[a]; `extent` is its size along x and z; mm.
    """

    label: str
    stand: bool
    var: tuple[int, int]
    offset: tuple[int, int]
    extent: tuple[int, int]
    bottom: int
    top: int


class Choice(NamedTuple):
    """One of `options` must hold: `first` is left of, right of, north of or south of `second`.

    `stands` tells of each of the two whether it is not the body but the square of a person who uses it.
    """

    first: str
    second: str
    options: tuple[DifferenceRow, ...]
    stands: tuple[bool, bool] = (False, False)


@dataclass
class Problem:
    """Bounds are by axis and variable, mm; `boxes` say which variables are whose."""

    low: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    high: tuple[list[int], list[int]] = field(default_factory=lambda: ([], []))
    terms: list[Term] = field(default_factory=list)
    rows: list[DifferenceRow] = field(default_factory=list)
    boxes: list[ProblemBox] = field(default_factory=list)
    choices: list[Choice] = field(default_factory=list)


@dataclass(frozen=True)
class Solution:
    """The cheapest placement that one search of a problem found.

    Args:
        cost: the sum of the terms.
        positions: m, by axis and variable.
        taken: the option that each choice took, then the rows of widenings: axis, i, j, s in mm.
        proven: the tree was exhausted, so nothing is cheaper; where a placement was turned down as not walkable, within the
            widenings tried.
        solves: QPs.
        force_rows: the constraints that hold something: axis, and the numbers of the free variables that each keeps apart, or -1.
        multipliers: of these: what a metre more room would save, m^-1.
    """

    cost: float
    positions: Positions
    taken: Ints
    proven: bool
    solves: int
    force_rows: Ints = field(default_factory=lambda: np.zeros((0, 3), dtype=np.int64))
    multipliers: Floats = field(default_factory=lambda: np.zeros(0))

    @property
    def rows(self) -> tuple[DifferenceRow, ...]:
        """The rows taken, for reading."""
        return tuple(DifferenceRow(*row) for row in self.taken.tolist())


@dataclass(frozen=True)
class Force:
    """What keeps a variable from going where it is drawn: a difference row; a bound is one against ORIGIN.

    `per_m` is what a metre more room would save, m^-1; `choice` the number of the room's choice that took the row, None for what always
    holds.
    """

    row: DifferenceRow
    per_m: float
    choice: int | None = None
    bound: bool = False


@dataclass(frozen=True)
class Confirmed:
    """A room's final positions, m, by axis and variable, and how exactly they are the optimum; None where the solver does not say.

    `holding` has of every row that holds something axis, i, j, s, the number of its choice, or -1, whether it is a bound, and what a metre
    more room would save: a float in the bits of a whole number.
    """

    positions: Positions
    residuals: Residuals | None = None
    holding: Ints = field(default_factory=lambda: np.zeros((0, 7), dtype=np.int64))

    @property
    def forces(self) -> tuple[Force, ...]:
        """Every row that holds something, for reading."""
        found, per_m = [], self.holding[:, -1].copy().view(np.float64)
        for (*row, choice, bound, _), value in zip(self.holding.tolist(), per_m.tolist(), strict=True):
            found.append(Force(DifferenceRow(*row), value, None if choice < 0 else choice, bool(bound)))
        return tuple(found)
