"""Each term and constraint by itself, on a hand-made two-body world."""

from __future__ import annotations

import pytest

from solver.geometry import Rect
from solver.placement.problem import DifferenceRow, Problem, ProblemBox, Term
from tests.oracles import sums
from tests.oracles.problems import anchor, apart, choose, clear_of, new_variable

A = ProblemBox("a", False, (0, 0), (0, 0), (1000, 600), 0, 700)
B = ProblemBox("b", False, (1, 1), (20, 0), (400, 400), 0, 700)


@pytest.mark.parametrize("term", [anchor(0, 1, 0.7, 3.0), Term(0, 0, 1, -0.4, 0.5)])
def test_a_term_costs_the_same_alone_and_added_up_anew(term: Term) -> None:
    problem = Problem(terms=[term])
    for p in ([0.0, 0.0], [1.5, -2.0], [0.3, 0.9]):
        assert sums.cost(problem, [p, []]) == pytest.approx(term.cost(p))


@pytest.mark.parametrize(
    ("option", "p"),
    [
        (0, ((0, 980), (0, 0))),  # a left of b: b's corner is 20 mm right of its variable
        (1, ((380 + 40, 0), (0, 0))),
        (2, ((0, 0), (0, 600))),
        (3, ((0, 0), (400, 0))),
    ],
)
def test_two_boxes_are_apart_exactly_when_they_touch(option: int, p: tuple[tuple[int, int], tuple[int, int]]) -> None:
    row = apart(A, B)[option]
    assert row.slack(p) == 0
    a, b = A.rect(p), B.rect(p)
    assert not a.overlaps(b)
    assert a.x1 == b.x0 or b.x1 == a.x0 or a.z1 == b.z0 or b.z1 == a.z0


def test_a_box_is_clear_of_a_zone_on_each_of_four_sides() -> None:
    zone = Rect(1000, 1000, 2000, 2000)
    left, right, north, south = clear_of(A, zone)
    assert [row.slack(((0, 0), (400, 0))) for row in (left, north)] == [0, 0]
    assert right.slack(((2000, 0), (0, 0))) == 0
    assert south.slack(((0, 0), (2000, 0))) == 0


def test_bounds_settle_a_choice_or_drop_its_options() -> None:
    problem = Problem()
    a, b = new_variable(problem, 0, 0, 100), new_variable(problem, 0, 1200, 1300)
    choose(problem, "a", "b", [DifferenceRow(0, a, b, 1000)])
    assert problem.choices == []
    choose(problem, "a", "b", [DifferenceRow(0, a, b, 1250), DifferenceRow(0, b, a, 0)])
    assert [choice.options for choice in problem.choices] == [(DifferenceRow(0, a, b, 1250),)]


def test_violations_name_what_is_broken() -> None:
    problem = Problem()
    a, b = new_variable(problem, 0, 0, 100), new_variable(problem, 0, 0, 2000)
    choose(problem, "a", "b", [DifferenceRow(0, a, b, 1000), DifferenceRow(0, b, a, 500)])
    assert problem.violations(([0, 1000], [])) == []
    assert problem.violations(([0, 999], [])) == ["a and b are not apart"]
    assert problem.violations(([101, 1500], []))[0].startswith("variable 0 of axis 0")
