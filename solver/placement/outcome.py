"""What a search found."""

from __future__ import annotations

from dataclasses import dataclass

from solver.placement.constraints import Row
from solver.placement.terms import Floats


@dataclass(frozen=True)
class Outcome:
    """The best placement of one search, or none.

    `positions` (m, per axis and variable) and `rows` (the option each choice took, then the rows of widenings) are None and
    empty when nothing was found. `proven`: the tree was exhausted, so this is the optimum, or there is none. `turned_down`
    counts the placements that were not walkable: with any, "none" and "optimum" hold within the widenings tried.
    """

    cost: float
    positions: tuple[Floats, Floats] | None
    rows: tuple[Row, ...]
    proven: bool
    solves: int
    turned_down: int = 0
