"""The compiled search over a problem's choices, for problems made by hand; rooms go through `core`.

Comes in: a Problem. Goes out: an Outcome. `twin.solve` is the same search in Python over DAQP.
"""

from __future__ import annotations

import numpy as np

from solver.placement.core import outcome_of
from solver.placement.kernel import layout
from solver.placement.kernel.layout import Engine, Room, Work
from solver.placement.kernel.search import search
from solver.placement.kernel.space import Sizes, new_engine
from solver.placement.outcome import Outcome
from solver.placement.problem import Problem
from solver.placement.terms import Anchor

LIMIT = 4000
"""QPs after which the search gives up proving (placement.md)."""


def solve(problem: Problem, *, limit: int = LIMIT, ceiling: float = float("inf")) -> Outcome:
    """Finds the cheapest positions at which every choice holds.

    Args:
        problem: bounds, terms, rows and choices; every variable needs a term.
        limit: QPs after which to stop; the outcome is then not proven.
        ceiling: only placements cheaper than this count.

    Raises:
        ValueError: a variable has two anchors.
    """
    engine = laid_out(problem)
    search(engine, limit, ceiling, False)
    return outcome_of(engine)


def laid_out(problem: Problem) -> Engine:
    """Returns a work space with the problem in it, ready for the kernel's `search`."""
    count = max(len(problem.low[0]), len(problem.low[1]), 1)
    pulls = sum(not isinstance(term, Anchor) for term in problem.terms)
    sizes = Sizes(1, count, len(problem.choices) + 1, len(problem.rows) + 1, pulls + 1, 0, 0, 1, 1)
    engine = new_engine(_nowhere(), sizes)
    work = engine.work
    work.counts[:] = 0
    for axis in (0, 1):
        n = len(problem.low[axis])
        work.sizes[axis] = n
        work.low[axis, :n], work.high[axis, :n] = problem.low[axis], problem.high[axis]
        work.anchor_weight[axis], work.anchor_at[axis] = 0.0, 0.0
    _write_terms(problem, work)
    work.counts[layout.N_ROWS] = len(problem.rows)
    if problem.rows:
        work.rows[: len(problem.rows)] = problem.rows
    work.counts[layout.N_CHOICES] = len(problem.choices)
    for c, choice in enumerate(problem.choices):
        work.choice_size[c] = len(choice.options)
        if choice.options:
            work.options[4 * c : 4 * c + len(choice.options)] = choice.options
    return engine


def _write_terms(problem: Problem, work: Work) -> None:
    """Writes anchors and pulls."""
    for term in problem.terms:
        if isinstance(term, Anchor):
            if work.anchor_weight[term.axis, term.i] > 0:
                raise ValueError(f"variable {term.i} of axis {term.axis} has two anchors")
            work.anchor_at[term.axis, term.i], work.anchor_weight[term.axis, term.i] = term.wish, term.weight
        else:
            k = work.counts[layout.N_PULLS]
            work.pulls[k] = term.axis, term.i, term.j
            work.pull_costs[k] = term.offset, term.weight
            work.counts[layout.N_PULLS] += 1


def _nowhere() -> Room:
    rows, none = np.zeros((0, 5), dtype=np.int64), np.zeros(0)
    return Room(np.zeros(8, dtype=np.int64), rows, rows, rows, none, rows, none, rows, np.zeros((0, 3)), rows, np.zeros((0, 5)))


__all__ = ["LIMIT", "Outcome", "laid_out", "solve"]
