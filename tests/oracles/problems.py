"""Problems made by hand, and the compiled search over their choices; rooms go through the solver's `core`.

`twin.solve` is the same search in Python over DAQP.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count as count_from

import numpy as np
from numpy.typing import NDArray

from solver.core import taken
from solver.geometry import Rect
from solver.placement import layout
from solver.placement.layout import Engine, Work
from solver.placement.made_rooms import answer_at
from solver.placement.problem import ORIGIN, Choice, DifferenceRow, ProblemBox
from tests.oracles.problem import Problem, Term, solution_of

LIMIT = 4000
"""QPs after which the search gives up proving."""
SPACE, PIECE = 10, 9
"""Numbers of a request's space, and of a piece in it."""


@dataclass(frozen=True)
class Outcome:
    """What a search says: the cheapest placement, or that there is none (cost infinite); `proven` unless it ended at its limit."""

    cost: float
    positions: tuple[NDArray[np.float64], NDArray[np.float64]] | None
    rows: tuple[DifferenceRow, ...]
    proven: bool
    solves: int


def anchor(axis: int, variable: int, wish: float, weight: float) -> Term:
    """Returns the wish of a variable to be at a place, m."""
    return Term(axis, ORIGIN, variable, wish, weight)


def new_variable(problem: Problem, axis: int, low: int, high: int) -> int:
    """Adds a variable with bounds, mm, and returns its index along that axis."""
    problem.low[axis].append(low)
    problem.high[axis].append(high)
    return len(problem.low[axis]) - 1


def choose(problem: Problem, first: str, second: str, rows: Sequence[DifferenceRow]) -> None:
    """Adds a choice, unless the bounds already settle it; options that the bounds rule out are dropped."""
    options: list[DifferenceRow] = []
    for row in rows:
        i_low, i_high = _range_of(problem, row.axis, row.i)
        j_low, j_high = _range_of(problem, row.axis, row.j)
        least, most = (0, 0) if row.i == row.j else (j_low - i_high, j_high - i_low)
        if least >= row.s:
            return
        if most >= row.s:
            options.append(row)
    problem.choices.append(Choice(first, second, tuple(options)))


def _range_of(problem: Problem, axis: int, i: int) -> tuple[int, int]:
    return (0, 0) if i == ORIGIN else (problem.low[axis][i], problem.high[axis][i])


def apart(a: ProblemBox, b: ProblemBox) -> tuple[DifferenceRow, ...]:
    """Returns the four rows that separate two boxes: a left of, right of, north of, south of b."""
    rows = []
    for axis in (0, 1):
        for first, second in ((a, b), (b, a)):
            s = first.extent[axis] + first.offset[axis] - second.offset[axis]
            rows.append(DifferenceRow(axis, first.var[axis], second.var[axis], s))
    return tuple(rows)


def clear_of(a: ProblemBox, rect: Rect) -> tuple[DifferenceRow, ...]:
    """Returns the four rows that keep a box out of a fixed rectangle."""
    rows = []
    for axis, (low, high) in ((0, (rect.x0, rect.x1)), (1, (rect.z0, rect.z1))):
        rows.append(DifferenceRow(axis, a.var[axis], ORIGIN, a.extent[axis] + a.offset[axis] - low))
        rows.append(DifferenceRow(axis, ORIGIN, a.var[axis], high - a.offset[axis]))
    return tuple(rows)


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
    search(engine, limit, ceiling)
    found, result = solution_of(engine), engine.nodes.result
    if found is None:
        return Outcome(float("inf"), None, (), bool(result[layout.EXHAUSTED]), int(result[layout.SOLVES]))
    return Outcome(found.cost, found.positions, found.rows, found.proven, found.solves)


def search(engine: Engine, limit: int, ceiling: float = float("inf")) -> None:
    """Finds the cheapest placement of the problem in `work`, nobody walking; the outcome is left in `nodes`."""
    engine.instance.call("search", engine.desk, limit, ceiling, False)


def on_lattice(problem: Problem, outcome: Outcome) -> list[list[int]]:
    """Returns an outcome's positions as the core puts them on whole millimetres.

    Raises:
        AssertionError: the core says that there are none.
    """
    assert outcome.positions is not None
    engine = laid_out(problem)
    search(engine, LIMIT)
    assert float(engine.nodes.best_cost[0]) == outcome.cost
    engine.call.decisions[:] = layout.ABSENT  # its pieces are not to be told of
    answer_at(engine.instance, int(engine.instance.call("tell_room", engine.desk, False)), "hand-made")
    return [own[:n].tolist() for own, n in zip(engine.grid.positions, engine.work.sizes, strict=True)]


def _room_as_large_as(problem: Problem) -> bytes:
    """Returns a room that asks for as much space as a problem needs: of pieces that have no way to stand."""
    pulls = sum(term.i != ORIGIN for term in problem.terms)
    pairs = next(count for count in count_from(1) if count * (count - 1) // 2 >= len(problem.choices))
    pieces = max(len(problem.low[0]), len(problem.low[1]), len(problem.rows), pulls, pairs)
    counts = [0, 0, pieces, 0, 0, 0]
    return np.array(counts, dtype=np.int64).tobytes() + bytes(8 * (SPACE + pieces * (PIECE + 1)))


def laid_out(problem: Problem) -> Engine:
    """Returns a work space with the problem in it, ready for the kernel's `search`."""
    instance = taken(roomy=True)
    engine = Engine(instance, int(instance.call("new_desk", instance.write(_room_as_large_as(problem)))))
    engine.call.decisions[:] = layout.ABSENT
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
    """Writes wished places and distances."""
    for term in problem.terms:
        if term.i == ORIGIN:
            if work.anchor_weight[term.axis, term.j] > 0:
                raise ValueError(f"variable {term.j} of axis {term.axis} has two anchors")
            work.anchor_at[term.axis, term.j], work.anchor_weight[term.axis, term.j] = term.offset, term.weight
        else:
            k = work.counts[layout.N_PULLS]
            work.pulls[k] = term.axis, term.i, term.j
            work.pull_costs[k] = term.offset, term.weight
            work.counts[layout.N_PULLS] += 1
