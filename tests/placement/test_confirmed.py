"""What OSQP says of a room's optimum: positions, residuals and forces, held against the conditions of Karush, Kuhn and Tucker.

The conditions are worked out here from the problem's own rows and terms, in a way that shares no code with the solve.
"""

from __future__ import annotations

from collections import defaultdict

import pytest

from catalogs import load_catalogs
from solver import Request, generate
from solver.pipeline.generate import wanted_in
from solver.placement import OpenRoom, opened
from solver.placement.layout import EXHAUSTED, Engine
from solver.placement.problem import ORIGIN, Choice, DifferenceRow, ProblemBox
from solver.placement.qp import OptimumRefuted
from tests.oracles import sums
from tests.oracles.confirmed import Confirmed, confirmed
from tests.oracles.problem import Problem, Term, found_in, problem_of
from tests.oracles.problems import LIMIT, laid_out, search

NEARLY = 1e-5
EXACT = -5
"""Residuals are 10 to this power at most."""


def rooms(seed: int, program: str | None) -> list[OpenRoom]:
    """All rooms of a home, with what the search found."""
    scene, known = generate(Request(seed=seed, program=program)).scene, load_catalogs()
    return [opened(*wanted_in(scene, room, known)) for room in scene.rooms]


def unbalanced(problem: Problem, answer: Confirmed) -> float:
    """By how much any variable that may move is still drawn once all forces on it are added up, m^-1."""
    drawn: dict[tuple[int, int], float] = defaultdict(float)
    for term in problem.terms:
        p = answer.positions[term.axis]
        before = 0.0 if term.i == ORIGIN else p[term.i]
        pull = 2 * term.weight * (p[term.j] - before - term.offset)
        drawn[term.axis, term.j] += pull
        drawn[term.axis, term.i] -= pull
    for force in answer.forces:
        drawn[force.row.axis, force.row.j] -= force.per_m
        drawn[force.row.axis, force.row.i] += force.per_m
    free = {(axis, v) for axis in (0, 1) for v, (a, b) in enumerate(zip(problem.low[axis], problem.high[axis], strict=True)) if a < b}
    return max((abs(value) for key, value in drawn.items() if key in free), default=0.0)


@pytest.mark.parametrize(("seed", "program"), [(5, "family"), (6, "studio"), (7, None)])
def test_the_optimum_balances_and_every_force_has_its_touch(seed: int, program: str | None) -> None:
    found, forces = rooms(seed, program), 0
    for room in found:
        problem, solution = problem_of(room.core), found_in(room.engine)
        answer = confirmed(room.engine, problem)
        mm = [[float(x) * 1000 for x in axis] for axis in answer.positions]
        assert max(answer.residuals) <= EXACT
        assert unbalanced(problem, answer) < NEARLY
        assert all(sums.slack(row, mm) > -0.01 for row in (*problem.rows, *solution.rows))
        for force in answer.forces:
            assert force.per_m > 0
            assert abs(sums.slack(force.row, mm)) < 0.01
            if force.choice is not None and force.choice < len(problem.choices):
                assert force.row in problem.choices[force.choice].options
        forces += len(answer.forces)
    assert forces > 10


def held_room(most: int = 3000, keeps: int = 1500) -> tuple[Problem, Engine]:
    """A body wished at 1 m, weight 3, that something keeps at 1.5 m or beyond, and what is found of it; along z nothing holds it."""
    row = DifferenceRow(0, ORIGIN, 0, keeps)
    box = ProblemBox("box", False, (0, 0), (0, 0), (500, 500), 0, 500)
    terms = [Term(0, ORIGIN, 0, 1.0, 3.0), Term(1, ORIGIN, 0, 1.0, 3.0)]
    problem = Problem(([0], [0]), ([most], [3000]), terms, [], [box], [Choice("box", "door", (row,))])
    engine = laid_out(problem)
    search(engine, LIMIT)
    return problem, engine


def test_a_force_is_what_a_metre_more_room_would_save() -> None:
    problem, engine = held_room()
    answer = confirmed(engine, problem)
    (force,) = answer.forces
    assert (force.row, force.choice, force.bound) == (DifferenceRow(0, ORIGIN, 0, 1500), 0, False)
    assert force.per_m == pytest.approx(2 * 3.0 * 0.5, abs=1e-6)
    assert [list(axis) for axis in answer.positions] == [[pytest.approx(1.5)], [pytest.approx(1.0)]]


def test_what_was_wrongly_called_proven_is_never_served() -> None:
    problem, engine = held_room()
    engine.nodes.best[:, 0] = 2.5, 0.3
    with pytest.raises(OptimumRefuted) as refuted:
        confirmed(engine, problem)
    assert len(refuted.value.problem) == 8 * int.from_bytes(refuted.value.problem[:8], "little")
    engine.nodes.result[EXHAUSTED] = 0
    answer = confirmed(engine, problem)
    # The row has a metre of slack at that start, so it is left out: what OSQP finds is the wish.
    assert [list(axis) for axis in answer.positions] == [[pytest.approx(1.0)], [pytest.approx(1.0)]]


def test_the_search_says_what_its_placement_costs() -> None:
    """Also where a constraint's slack is gone with the step that drops another one: it must stay active."""
    for seed, program in ((0, "family"), (3, None), (5, None)):
        for room in rooms(seed, program):
            problem, solution = problem_of(room.core), found_in(room.engine)
            assert sums.cost(problem, [axis.tolist() for axis in solution.positions]) == pytest.approx(solution.cost, abs=1e-9)


def test_a_bound_holds_too() -> None:
    problem, engine = held_room(most=800, keeps=0)
    (force,) = confirmed(engine, problem).forces
    assert (force.bound, force.choice, force.row) == (True, None, DifferenceRow(0, 0, ORIGIN, -800))
    assert force.per_m == pytest.approx(2 * 3.0 * 0.2, abs=1e-6)
