"""The search against oracles that share no code with it: HiGHS for verdicts, enumeration in cvxpy for the optimum; and its twin."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.optimize import Bounds, LinearConstraint, milp

from solver.geometry import Rect
from solver.pieces import Space
from solver.placement import Budget
from solver.placement.core import Core
from solver.placement.encode import encode
from solver.placement.problem import DifferenceRow, ProblemBox
from solver.streams import Stream
from tests.every import every
from tests.oracles import sums, twin
from tests.oracles.problem import Problem, problem_of
from tests.oracles.problems import Outcome, anchor, apart, choose, new_variable, on_lattice, solve
from tests.placement.rooms import random_size, random_space, random_wanted
from tests.sweeps import seeds

TWINS = 160
BLOCKS = 8
BIG_MM = 50_000


def random_problem(seed: int, count: int) -> tuple[Space, Problem]:
    """Takes every piece's first way beside those before it, whatever it collides with; use sides have their squares."""
    stream = Stream(seed, "search")
    space = random_space(stream)
    core = Core(encode(space, random_wanted(space, stream, count)))
    decisions = core.first_decisions()
    assert decisions is not None
    core.evaluate(decisions, 1, Budget(), False)
    return space, problem_of(core)


def oracle_feasible(problem: Problem) -> bool:
    """A big-M mixed-integer programme: one binary an option, at least one option a choice."""
    n_x, n_z = len(problem.low[0]), len(problem.low[1])
    binaries = sum(len(choice.options) for choice in problem.choices)
    total = n_x + n_z + binaries
    if any(a > b for axis in (0, 1) for a, b in zip(problem.low[axis], problem.high[axis], strict=True)):
        return False
    rows, lower = [], []

    def add(row: DifferenceRow, binary: int | None) -> None:
        coefficients = np.zeros(total)
        shift = n_x if row.axis else 0
        for variable, sign in ((row.j, 1), (row.i, -1)):
            if variable >= 0:
                coefficients[shift + variable] += sign
        if binary is not None:
            coefficients[n_x + n_z + binary] = -BIG_MM
        rows.append(coefficients)
        lower.append(row.s - (BIG_MM if binary is not None else 0))

    for row in problem.rows:
        add(row, None)
    binary = 0
    for choice in problem.choices:
        pick = np.zeros(total)
        for row in choice.options:
            add(row, binary)
            pick[n_x + n_z + binary] = 1
            binary += 1
        rows.append(pick)
        lower.append(1)
    bounds = Bounds([*problem.low[0], *problem.low[1], *[0] * binaries], [*problem.high[0], *problem.high[1], *[1] * binaries])
    integrality = np.array([0] * (n_x + n_z) + [1] * binaries)
    constraints = LinearConstraint(np.array(rows), np.array(lower), np.inf) if rows else ()
    result = milp(np.zeros(total), integrality=integrality, bounds=bounds, constraints=constraints)
    assert result.status in (0, 2)
    return bool(result.status == 0)


@cache
def twins_problem(seed: int) -> tuple[Problem, Outcome]:
    """A random problem, and what the twin makes of it: the dearest part of these tests, made once."""
    _, problem = random_problem(1000 + seed, 3 + seed % 7)
    return problem, twin.solve(problem, limit=20_000)


@every("seed", range(60))
def test_the_verdict_is_the_oracles(seed: int) -> None:
    _, problem = random_problem(seed, 3 + seed % 5)
    outcome = solve(problem, limit=20_000)
    assert outcome.proven
    assert (outcome.positions is not None) == oracle_feasible(problem)


def test_the_rooms_above_are_of_both_kinds() -> None:
    verdicts = {solve(random_problem(seed, 3 + seed % 5)[1]).positions is None for seed in range(60)}
    assert verdicts == {True, False}


@pytest.mark.parametrize("block", range(BLOCKS))
def test_the_kernel_and_its_twin_agree(block: int) -> None:
    for seed in range(block, TWINS, BLOCKS):
        problem, theirs = twins_problem(seed)
        ours = solve(problem, limit=20_000)
        assert (ours.proven, theirs.proven) == (True, True), seed
        assert (ours.positions is None) == (theirs.positions is None), seed
        if ours.positions is None or theirs.positions is None:
            continue
        assert ours.cost == pytest.approx(theirs.cost, rel=1e-7, abs=1e-7), seed
        assert sums.cost(problem, [axis.tolist() for axis in ours.positions]) == pytest.approx(ours.cost, rel=1e-7, abs=1e-7), seed
        assert sums.worst(problem, [axis.tolist() for axis in ours.positions]) < 1e-6, seed


def test_the_twins_rooms_are_of_both_kinds_and_some_are_hard() -> None:
    outcomes = [twins_problem(seed)[1] for seed in range(TWINS)]
    possible = [outcome for outcome in outcomes if outcome.positions is not None]
    assert TWINS // 4 < len(possible) < TWINS
    assert sum(outcome.solves > 50 for outcome in possible) > 10


def test_a_ceiling_below_the_optimum_leaves_nothing_and_says_so() -> None:
    found = 0
    for seed in range(20):
        _, problem = random_problem(seed, 4)
        best = solve(problem)
        if best.positions is None or best.cost < 1e-3:
            continue
        found += 1
        below, above = solve(problem, ceiling=best.cost - 1e-4), solve(problem, ceiling=best.cost + 1e-4)
        assert (below.positions, below.proven) == (None, True)
        assert above.cost == pytest.approx(best.cost, abs=1e-9)
    assert found > 8


def test_a_search_that_ends_at_its_limit_does_not_claim_a_proof() -> None:
    cut = 0
    for seed in range(40):
        _, problem = random_problem(seed, 7)
        whole, short = solve(problem, limit=20_000), solve(problem, limit=8)
        if whole.solves <= 8 + 16:
            continue
        cut += 1
        assert not short.proven
        assert short.cost >= whole.cost - 1e-9
    assert cut > 5


FAR = 10.0
"""More than anything in these rooms is apart, m."""


def best_by_enumeration(problem: Problem) -> float:
    """Solves every combination of options with cvxpy: of those that are not in it, what they demand is set back by `FAR`."""
    import cvxpy as cp

    p = [cp.Variable(len(problem.low[axis])) for axis in (0, 1)]
    cost = 0
    for term in problem.terms:
        own = p[term.axis]
        cost += term.weight * cp.square(own[term.j] - (own[term.i] if term.i >= 0 else 0) - term.offset)
    rules = []
    for axis in (0, 1):
        rules += [np.array(problem.low[axis]) / 1000 <= p[axis], p[axis] <= np.array(problem.high[axis]) / 1000]

    def rule(row: DifferenceRow, back: Any = 0) -> object:
        own = p[row.axis]
        return (own[row.j] if row.j >= 0 else 0) - (own[row.i] if row.i >= 0 else 0) >= row.s / 1000 - back

    back = [cp.Parameter(len(choice.options)) for choice in problem.choices]
    rules += [rule(row) for row in problem.rows]
    rules += [rule(row, back[k][n]) for k, choice in enumerate(problem.choices) for n, row in enumerate(choice.options)]
    programme, best = cp.Problem(cp.Minimize(cost), rules), float("inf")
    for combination in itertools.product(*(range(len(choice.options)) for choice in problem.choices)):
        for one, chosen in zip(back, combination, strict=True):
            one.value = np.where(np.arange(one.size) == chosen, 0.0, FAR)
        best = min(best, programme.solve(solver=cp.CLARABEL))
    return best


def three_boxes(seed: int) -> Problem:
    """Returns three boxes in a room, to be apart, each with a wished place."""
    stream = Stream(seed, "enumeration")
    problem = Problem()
    boxes = []
    for _ in range(3):
        size = random_size(stream)
        boxes.append((new_variable(problem, 0, 0, 3500 - size[0]), new_variable(problem, 1, 0, 2500 - size[1]), size))
    parts = [ProblemBox(str(k), False, (x, z), (0, 0), size[:2], 0, 1) for k, (x, z, size) in enumerate(boxes)]
    for part in parts:
        for axis in (0, 1):
            problem.terms.append(anchor(axis, part.var[axis], 0.5 + stream.unit(), 0.5 + stream.unit()))
    for a, b in itertools.combinations(parts, 2):
        choose(problem, a.label, b.label, apart(a, b))
    return problem


@pytest.mark.parametrize("seed", seeds(range(12), 5))
def test_the_optimum_is_the_best_of_all_combinations(seed: int) -> None:
    problem = three_boxes(seed)
    outcome = solve(problem)
    assert outcome.proven
    expected = best_by_enumeration(problem)
    assert outcome.cost == pytest.approx(expected, abs=1e-5) or outcome.cost == expected == float("inf")


def test_a_choice_without_options_has_no_solution() -> None:
    problem = three_boxes(0)
    choose(problem, "0", "1", ())
    outcome = solve(problem)
    assert (outcome.positions, outcome.proven, outcome.solves) == (None, True, 0)


def test_a_second_anchor_is_refused() -> None:
    problem = three_boxes(0)
    problem.terms.append(anchor(0, 0, 1.0, 1.0))
    with pytest.raises(ValueError, match="two anchors"):
        solve(problem)


@every("seed", range(40))
def test_the_snap_is_exact_in_integers_and_moves_nothing_far(seed: int) -> None:
    space, problem = random_problem(100 + seed, 4 + seed % 6)
    outcome = solve(problem)
    if outcome.positions is None:
        assert outcome.cost == float("inf")
        return
    p = on_lattice(problem, outcome)
    rects = assert_apart(space, problem, p)
    drift = max(abs(p[a][i] - 1000 * x) for a in (0, 1) for i, x in enumerate(outcome.positions[a]))
    assert drift < rects + 1


def assert_apart(space: Space, problem: Problem, p: Sequence[Sequence[int]]) -> int:
    """Asks in integers that all is in the room and bodies share no space with each other and no stand of another; counts parts."""
    clear, rects = space.clear, list[tuple[ProblemBox, Rect]]()
    for part in problem.boxes:
        r = sums.rect(part, p)
        assert clear.x0 <= r.x0 and r.x1 <= clear.x1 and clear.z0 <= r.z0 and r.z1 <= clear.z1
        for before, other in rects:
            same = before.label == part.label or (before.stand and part.stand)
            over = part.bottom >= before.top or before.bottom >= part.top
            gone = r.x1 <= other.x0 or other.x1 <= r.x0 or r.z1 <= other.z0 or other.z1 <= r.z0
            assert same or over or gone, (part.label, before.label)
        rects.append((part, r))
    return len(rects)


def test_enough_rooms_are_snapped() -> None:
    solved = [solve(random_problem(100 + seed, 4 + seed % 6)[1]).positions is not None for seed in range(40)]
    assert sum(solved) >= 10
