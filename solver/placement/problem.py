"""What a room's placement problem is about, as plain data: boxes, rows and choices, and what holds the boxes back.

Along each axis apart: minimise a sum of squares, subject to bounds and to rows; and of every choice at least one option must hold.
Variables are min corners, in whole millimetres. docs/maths.md says it at more length.
"""

from dataclasses import dataclass
from typing import Final, NamedTuple

ORIGIN: Final = -1
"""Stands for the constant 0 in place of a variable, so that a wished place is a difference, and a bound a row, as well."""


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
