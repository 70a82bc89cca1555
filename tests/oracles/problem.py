"""A room's whole placement problem as plain data, and what a search found of it, as the core's arrays have them.

Along each axis apart: minimise the sum of the terms, subject to low <= p <= high and the rows; and of every choice at least one option must
hold. Variables are min corners; terms count in metres, everything else in whole millimetres.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from solver.placement import layout
from solver.placement.core import Core
from solver.placement.layout import Engine, Floats, Ints
from solver.placement.problem import ORIGIN, Choice, DifferenceRow, ProblemBox

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
    """

    cost: float
    positions: Positions
    taken: Ints
    proven: bool
    solves: int

    @property
    def rows(self) -> tuple[DifferenceRow, ...]:
        """The rows taken, for reading."""
        return tuple(DifferenceRow(*row) for row in self.taken.tolist())


def problem_of(core: Core) -> Problem:
    """Returns the assembled problem."""
    work = core.engine.work
    low, high = ([bounds[axis, : work.sizes[axis]].tolist() for axis in (0, 1)] for bounds in (work.low, work.high))
    rows = [DifferenceRow(*row) for row in work.rows[: work.counts[layout.N_ROWS]].tolist()]
    boxes = core.boxes()
    return Problem((low[0], low[1]), (high[0], high[1]), _terms(core), rows, boxes, core.choices(boxes))


def _terms(core: Core) -> list[Term]:
    work, count = core.engine.work, core.engine.work.counts[layout.N_PULLS]
    terms = []
    for axis in (0, 1):
        n = work.sizes[axis]
        anchors = zip(work.anchor_at[axis, :n].tolist(), work.anchor_weight[axis, :n].tolist(), strict=True)
        terms += [Term(axis, ORIGIN, v, at, weight) for v, (at, weight) in enumerate(anchors) if weight > 0]
    pulls = zip(work.pulls[:count].tolist(), work.pull_costs[:count].tolist(), strict=True)
    return [*terms, *(Term(*between, *costs) for between, costs in pulls)]


def solution_of(engine: Engine) -> Solution | None:
    """Returns what the last search of a work space found; None where it found nothing."""
    best, result = engine.nodes.best, engine.nodes.result
    if not result[layout.FOUND]:
        return None
    n_x, n_z = engine.work.sizes.tolist()
    positions = best[0, :n_x].copy(), best[1, :n_z].copy()
    rows = engine.call.taken[: engine.instance.call("find_taken", engine.desk)].copy()
    proven, solves = bool(result[layout.EXHAUSTED]), int(result[layout.SOLVES])
    return Solution(float(engine.nodes.best_cost[0]), positions, rows, proven, solves)


def found_in(engine: Engine) -> Solution:
    """Returns what the last search of a work space found, which found something."""
    found = solution_of(engine)
    assert found is not None
    return found
