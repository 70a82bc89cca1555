"""The kernel's active-set method on difference rows against exact feasibility, cvxpy and DAQP; the last two are other methods."""

from __future__ import annotations

import numpy as np
import pytest

from solver.placement.problem import ORIGIN, DifferenceRow
from solver.streams import Stream
from tests.every import every
from tests.oracles import sums
from tests.oracles.axis import AxisProgram
from tests.oracles.problem import Problem, Term
from tests.oracles.problems import anchor, new_variable, solve

PROGRAMMES = 400
CLOSE = 1e-7


def random_programme(seed: int) -> Problem:
    """One axis: 1-9 variables, some fixed, with anchors, some pulls, and up to 16 rows, many of which follow from others."""
    stream = Stream(seed, "dual")
    problem = Problem()
    count = 1 + stream.below(9)
    for v in range(count):
        low = stream.below(3000)
        new_variable(problem, 0, low, low if stream.chance(0.15) else low + stream.below(4000))
        problem.terms.append(anchor(0, v, 6 * stream.unit() - 1, (0.02, 0.5, 1.0, 20.0)[stream.below(4)]))
    if count == 1:
        return problem
    for _ in range(stream.below(4)):
        i, j = pair(stream, count)
        problem.terms.append(Term(0, i, j, 2 * stream.unit() - 1, 0.02 + 3 * stream.unit()))
    for _ in range(stream.below(9)):
        i, j = pair(stream, count)
        problem.rows.append(DifferenceRow(0, i, j, stream.below(1200) - 300))
    add_dependent(problem, stream)
    return problem


def pair(stream: Stream, count: int) -> tuple[int, int]:
    """Two different variables."""
    i = stream.below(count)
    return i, (i + 1 + stream.below(count - 1)) % count


def add_dependent(problem: Problem, stream: Stream) -> None:
    """Adds rows that repeat, chain, reverse or bound others: normals that depend on each other, ties that are equalities."""
    for row in list(problem.rows):
        kind = stream.below(6)
        if kind == 0:
            problem.rows.append(row)
        elif kind == 1:
            problem.rows.append(DifferenceRow(0, row.j, row.i, -row.s))
        elif kind == 2:
            problem.rows.append(DifferenceRow(0, row.j, row.i, -row.s - stream.below(400)))
        elif kind == 3:
            problem.rows.append(DifferenceRow(0, ORIGIN, row.j, problem.low[0][row.i] + row.s))
        elif kind == 4:
            problem.rows.append(DifferenceRow(0, row.i, ORIGIN, row.s - problem.high[0][row.j]))
        for other in problem.rows[:3]:
            if other.i == row.j and other.j != row.i and stream.chance(0.5):
                problem.rows.append(DifferenceRow(0, row.i, other.j, row.s + other.s))


def possible(problem: Problem) -> bool:
    """Shortest paths in integers (Bellman-Ford): rows and bounds can be held unless they close a positive cycle."""
    origin = len(problem.low[0])
    edges = [(row.i if row.i >= 0 else origin, row.j if row.j >= 0 else origin, row.s) for row in problem.rows]
    for v, (low, high) in enumerate(zip(problem.low[0], problem.high[0], strict=True)):
        edges += [(origin, v, low), (v, origin, -high)]
    least = [0] * (origin + 1)
    for _ in range(origin + 2):
        changed = False
        for i, j, s in edges:
            if least[i] + s > least[j]:
                least[j], changed = least[i] + s, True
        if not changed:
            return True
    return False


def by_cvxpy(problem: Problem) -> float:
    import cvxpy as cp

    p = cp.Variable(len(problem.low[0]))
    cost = 0
    for term in problem.terms:
        off = p[term.j] - (p[term.i] if term.i >= 0 else 0) - term.offset
        cost += term.weight * cp.square(off)
    rules = [np.array(problem.low[0]) / 1000 <= p, p <= np.array(problem.high[0]) / 1000]
    for row in problem.rows:
        rules.append((p[row.j] if row.j >= 0 else 0) - (p[row.i] if row.i >= 0 else 0) >= row.s / 1000)
    return float(cp.Problem(cp.Minimize(cost), rules).solve(solver=cp.CLARABEL))


@pytest.mark.parametrize("block", range(4))
def test_feasible_exactly_where_the_rows_close_no_positive_cycle(block: int) -> None:
    verdicts = []
    for seed in range(block, PROGRAMMES, 4):
        problem = random_programme(seed)
        outcome = solve(problem)
        assert (outcome.positions is not None, outcome.proven) == (possible(problem), True), seed
        verdicts.append(possible(problem))
    assert min(verdicts.count(True), verdicts.count(False)) > 15


@pytest.mark.parametrize("block", range(4))
def test_the_optimum_is_daqps(block: int) -> None:
    for seed in range(block, PROGRAMMES, 4):
        problem = random_programme(seed)
        if not possible(problem):
            continue
        outcome, theirs = solve(problem), AxisProgram(problem, 0).solve(())
        assert outcome.positions is not None and theirs is not None, seed
        assert outcome.cost == pytest.approx(theirs[0], rel=CLOSE, abs=CLOSE), seed
        assert outcome.positions[0] == pytest.approx(theirs[1], abs=1e-6), seed
        p = [axis.tolist() for axis in outcome.positions]
        assert sums.worst(problem, p) < CLOSE, seed
        assert sums.cost(problem, p) == pytest.approx(outcome.cost, rel=CLOSE, abs=CLOSE), seed


@every("seed", range(60))
def test_the_optimum_is_cvxpys(seed: int) -> None:
    problem = random_programme(seed)
    outcome = solve(problem)
    if possible(problem):
        assert outcome.cost == pytest.approx(by_cvxpy(problem), rel=1e-5, abs=1e-5)
    else:
        assert outcome.cost == float("inf")


def test_a_tie_of_two_rows_is_an_equality() -> None:
    """p0 wants 1, p1 wants 2, weights 1 and 3, and p1 - p0 = 0.4: the weighted mean of 1 and 1.6 is 1.45."""
    problem = Problem()
    for wish, weight in ((1.0, 1.0), (2.0, 3.0)):
        problem.terms.append(anchor(0, new_variable(problem, 0, 0, 5000), wish, weight))
    problem.rows += [DifferenceRow(0, 0, 1, 400), DifferenceRow(0, 1, 0, -400)]
    outcome = solve(problem)
    assert outcome.positions is not None
    assert outcome.positions[0] == pytest.approx([1.45, 1.85], abs=1e-9)
    assert outcome.cost == pytest.approx(0.45**2 + 3 * 0.15**2, abs=1e-12)


@pytest.mark.parametrize(("room", "found"), [(3000, True), (2999, False)])
def test_a_row_of_boxes_fits_exactly_or_not_at_all(room: int, found: bool) -> None:
    """Six boxes of 500 mm, all of which want to stand at 1 m."""
    problem = Problem()
    for _ in range(6):
        problem.terms.append(anchor(0, new_variable(problem, 0, 0, room - 500), 1.0, 1.0))
    problem.rows += [DifferenceRow(0, k, k + 1, 500) for k in range(5)]
    outcome = solve(problem)
    assert (outcome.positions is not None) is found
    if outcome.positions is not None:
        assert outcome.positions[0] == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0, 2.5], abs=1e-9)


def test_variables_without_room_to_move_are_fixed() -> None:
    problem = Problem()
    a, b = new_variable(problem, 0, 700, 700), new_variable(problem, 0, 0, 2000)
    problem.terms += [anchor(0, a, 0.0, 1.0), anchor(0, b, 0.0, 1.0), Term(0, a, b, 0.1, 1.0)]
    problem.rows.append(DifferenceRow(0, a, b, 300))
    outcome = solve(problem)
    assert outcome.positions is not None
    assert outcome.positions[0] == pytest.approx([0.7, 1.0], abs=1e-9)
    assert outcome.cost == pytest.approx(0.49 + 1.0 + 0.04, abs=1e-9)
