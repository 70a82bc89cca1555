"""The search against oracles that share no code with it: HiGHS for verdicts, enumeration in cvxpy for the optimum."""

from __future__ import annotations

import itertools

import cvxpy as cp
import numpy as np
import pytest
from scipy.optimize import Bounds, LinearConstraint, milp

from solver.geometry import Rect
from solver.placement.assemble import Assembly, Impossible
from solver.placement.problem import Problem
from solver.placement.search import solve
from solver.placement.snap import snap
from solver.placement.states import options
from solver.streams import Stream
from tests.placement.rooms import random_size, random_space, random_wanted


def random_problem(seed: int, count: int) -> Assembly | None:
    """Takes every piece's cheapest option, whatever it collides with."""
    stream = Stream(seed, "search")
    space = random_space(stream)
    assembly = Assembly(space)
    for piece in random_wanted(space, stream, count):
        try:
            ways = options(assembly, piece)
            assembly = assembly.with_piece(ways[0][1]) if ways else assembly
        except Impossible:
            continue
    return assembly


def oracle_feasible(problem: Problem) -> bool:
    """A big-M mixed-integer programme: one binary an option, at least one option a choice."""
    n_x, n_z = len(problem.low[0]), len(problem.low[1])
    binaries = sum(len(choice.options) for choice in problem.choices)
    total = n_x + n_z + binaries
    if any(a > b for axis in (0, 1) for a, b in zip(problem.low[axis], problem.high[axis], strict=True)):
        return False
    rows, lower = [], []

    def add(row: object, binary: int | None) -> None:
        axis, i, j, s = row  # type: ignore[misc]
        coefficients = np.zeros(total)
        shift = n_x if axis else 0
        for variable, sign in ((j, 1), (i, -1)):
            if variable >= 0:
                coefficients[shift + variable] += sign
        big = 50_000
        if binary is not None:
            coefficients[n_x + n_z + binary] = -big
        rows.append(coefficients)
        lower.append(s - (big if binary is not None else 0))

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


@pytest.mark.parametrize("seed", range(60))
def test_the_verdict_is_the_oracles(seed: int) -> None:
    assembly = random_problem(seed, 3 + seed % 5)
    outcome = solve(assembly.problem, limit=20_000)
    assert outcome.proven
    assert (outcome.positions is not None) == oracle_feasible(assembly.problem)


def test_the_rooms_above_are_of_both_kinds() -> None:
    verdicts = {solve(random_problem(seed, 3 + seed % 5).problem).positions is None for seed in range(60)}
    assert verdicts == {True, False}


def best_by_enumeration(problem: Problem) -> float:
    """Solves every combination of options with cvxpy."""
    p = [cp.Variable(len(problem.low[axis])) for axis in (0, 1)]
    cost = 0
    for term in problem.terms:
        own = p[term.axis]
        if hasattr(term, "wish"):
            cost += term.weight * cp.square(own[term.i] - term.wish)
        else:
            cost += term.weight * cp.square(own[term.j] - own[term.i] - term.offset)
    rules = []
    for axis in (0, 1):
        rules += [np.array(problem.low[axis]) / 1000 <= p[axis], p[axis] <= np.array(problem.high[axis]) / 1000]

    def rule(row: object) -> object:
        axis, i, j, s = row  # type: ignore[misc]
        return (p[axis][j] if j >= 0 else 0) - (p[axis][i] if i >= 0 else 0) >= s / 1000

    best = float("inf")
    for combination in itertools.product(*(choice.options for choice in problem.choices)):
        programme = cp.Problem(cp.Minimize(cost), [*rules, *(rule(row) for row in (*problem.rows, *combination))])
        best = min(best, programme.solve(solver=cp.CLARABEL))
    return best


@pytest.mark.parametrize("seed", range(12))
def test_the_optimum_is_the_best_of_all_combinations(seed: int) -> None:
    stream = Stream(seed, "enumeration")
    problem = Problem()
    boxes = []
    for _ in range(3):
        size = random_size(stream)
        boxes.append((problem.variable(0, 0, 3500 - size[0]), problem.variable(1, 0, 2500 - size[1]), size))
    from solver.placement.constraints import Part, apart
    from solver.placement.terms import Anchor

    parts = [Part(str(k), False, (x, z), (0, 0), size[:2], 0, 1) for k, (x, z, size) in enumerate(boxes)]
    for part in parts:
        for axis in (0, 1):
            problem.terms.append(Anchor(axis, part.var[axis], 0.5 + stream.unit(), 0.5 + stream.unit()))
    for a, b in itertools.combinations(parts, 2):
        problem.choose(a.label, b.label, apart(a, b))
    outcome = solve(problem)
    assert outcome.proven
    expected = best_by_enumeration(problem)
    assert outcome.cost == pytest.approx(expected, abs=1e-5) or outcome.cost == expected == float("inf")


@pytest.mark.parametrize("seed", range(40))
def test_the_snap_is_exact_in_integers_and_moves_nothing_far(seed: int) -> None:
    assembly = random_problem(100 + seed, 4 + seed % 6)
    outcome = solve(assembly.problem)
    if outcome.positions is None:
        return
    p = snap(assembly.problem, outcome.rows, outcome.positions)
    clear = assembly.space.clear
    rects: list[tuple[str, bool, Rect]] = []
    for part in assembly.problem.parts:
        r = part.rect(p)
        assert clear.x0 <= r.x0 and r.x1 <= clear.x1 and clear.z0 <= r.z0 and r.z1 <= clear.z1
        for label, stand, other in rects:
            if label != part.label and not (stand and part.stand):
                gone = r.x1 <= other.x0 or other.x1 <= r.x0 or r.z1 <= other.z0 or other.z1 <= r.z0
                assert gone, (label, part.label)
        rects.append((part.label, part.stand, r))
    drift = max(abs(p[a][i] - 1000 * x) for a in (0, 1) for i, x in enumerate(outcome.positions[a]))
    assert drift < len(rects) + 1
