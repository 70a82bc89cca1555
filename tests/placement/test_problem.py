"""Each constraint by itself, on a hand-made two-body world."""

from __future__ import annotations

import pytest

from solver.geometry import Rect
from solver.placement.problem import DifferenceRow, ProblemBox
from tests.oracles import sums
from tests.oracles.problem import Problem
from tests.oracles.problems import apart, choose, clear_of, new_variable

A = ProblemBox("a", False, (0, 0), (0, 0), (1000, 600), 0, 700)
B = ProblemBox("b", False, (1, 1), (20, 0), (400, 400), 0, 700)


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
    assert sums.slack(row, p) == 0
    a, b = sums.rect(A, p), sums.rect(B, p)
    assert not a.overlaps(b)
    assert a.x1 == b.x0 or b.x1 == a.x0 or a.z1 == b.z0 or b.z1 == a.z0


def test_a_box_is_clear_of_a_zone_on_each_of_four_sides() -> None:
    zone = Rect(1000, 1000, 2000, 2000)
    left, right, north, south = clear_of(A, zone)
    assert [sums.slack(row, ((0, 0), (400, 0))) for row in (left, north)] == [0, 0]
    assert sums.slack(right, ((2000, 0), (0, 0))) == 0
    assert sums.slack(south, ((0, 0), (2000, 0))) == 0


def test_bounds_settle_a_choice_or_drop_its_options() -> None:
    problem = Problem()
    a, b = new_variable(problem, 0, 0, 100), new_variable(problem, 0, 1200, 1300)
    choose(problem, "a", "b", [DifferenceRow(0, a, b, 1000)])
    assert problem.choices == []
    choose(problem, "a", "b", [DifferenceRow(0, a, b, 1250), DifferenceRow(0, b, a, 0)])
    assert [choice.options for choice in problem.choices] == [(DifferenceRow(0, a, b, 1250),)]
