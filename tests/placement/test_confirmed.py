"""What OSQP says of a room's optimum: positions, residuals and forces, held against the conditions of Karush, Kuhn and Tucker.

The conditions are worked out here from the problem's own rows and terms, in a way that shares no code with the solve.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import pytest

from catalogs import load_catalogs
from solver import Request, generate
from solver.pipeline.generate import wanted_in
from solver.placement import OpenRoom, opened
from solver.placement.layout import Engine
from solver.placement.problem import ORIGIN, Choice, Confirmed, DifferenceRow, Problem, ProblemBox, Solution, Term
from solver.placement.qp import OptimumRefuted, confirmed
from tests.oracles import sums
from tests.oracles.problems import laid_out

NEARLY = 1e-5
EXACT = -5
"""Residuals are 10 to this power at most."""


@dataclass(frozen=True)
class HandMade:
    """A problem made by hand, with what a search would have found."""

    problem: Problem
    solution: Solution

    @cached_property
    def engine(self) -> Engine:
        """The problem in a work space."""
        return laid_out(self.problem)


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
    for room, answer in zip(found, confirmed(found), strict=True):
        problem, solution = room.problem, room.solution
        mm = [[float(x) * 1000 for x in axis] for axis in answer.positions]
        assert answer.residuals is not None and max(answer.residuals) <= EXACT
        assert unbalanced(problem, answer) < NEARLY
        assert all(sums.slack(row, mm) > -0.01 for row in (*problem.rows, *solution.rows))
        for force in answer.forces:
            assert force.per_m > 0
            assert abs(sums.slack(force.row, mm)) < 0.01
            if force.choice is not None and force.choice < len(problem.choices):
                assert force.row in problem.choices[force.choice].options
        forces += len(answer.forces)
    assert forces > 10


def held_room() -> tuple[Problem, Solution]:
    """A body wished at 1 m, weight 3, that something keeps at 1.5 m or beyond; along z nothing draws or holds it."""
    row = DifferenceRow(0, ORIGIN, 0, 1500)
    box = ProblemBox("box", False, (0, 0), (0, 0), (500, 500), 0, 500)
    terms = [Term(0, ORIGIN, 0, 1.0, 3.0), Term(1, ORIGIN, 0, 1.0, 3.0)]
    problem = Problem(([0], [0]), ([3000], [3000]), terms, [], [box], [Choice("box", "door", (row,))])
    return problem, Solution(0.75, (np.array([1.5]), np.array([1.0])), np.array([row]), True, 1)


def test_a_force_is_what_a_metre_more_room_would_save() -> None:
    (answer,) = confirmed([HandMade(*held_room())])
    (force,) = answer.forces
    assert (force.row, force.choice, force.bound) == (DifferenceRow(0, ORIGIN, 0, 1500), 0, False)
    assert force.per_m == pytest.approx(2 * 3.0 * 0.5, abs=1e-6)
    assert [list(axis) for axis in answer.positions] == [[pytest.approx(1.5)], [pytest.approx(1.0)]]


def test_what_was_wrongly_called_proven_is_never_served() -> None:
    problem, solution = held_room()
    elsewhere = replace(solution, cost=9.0, positions=(np.array([2.5]), np.array([0.3])))
    with pytest.raises(OptimumRefuted) as refuted:
        confirmed([HandMade(problem, elsewhere)])
    assert refuted.value.problem is problem
    (answer,) = confirmed([HandMade(problem, replace(elsewhere, proven=False))])
    # The row has a metre of slack at that start, so it is left out: what OSQP finds is the wish.
    assert [list(axis) for axis in answer.positions] == [[pytest.approx(1.0)], [pytest.approx(1.0)]]


def test_the_search_says_what_its_placement_costs() -> None:
    """Also where a constraint's slack is gone with the step that drops another one: it must stay active."""
    for seed, program in ((0, "family"), (3, None), (5, None)):
        for room in rooms(seed, program):
            problem, solution = room.problem, room.solution
            assert sums.cost(problem, [axis.tolist() for axis in solution.positions]) == pytest.approx(solution.cost, abs=1e-9)


def test_a_bound_holds_too() -> None:
    problem, _ = held_room()
    tight = Problem(([0], [0]), ([800], [3000]), problem.terms, [], problem.boxes, [])
    (answer,) = confirmed([HandMade(tight, Solution(0.12, (np.array([0.8]), np.array([1.0])), np.zeros((0, 4), dtype=np.int64), True, 1))])
    (force,) = answer.forces
    assert (force.bound, force.choice, force.row) == (True, None, DifferenceRow(0, 0, ORIGIN, -800))
    assert force.per_m == pytest.approx(2 * 3.0 * 0.2, abs=1e-6)
