"""The bench's rooms keep their ranges, its table marks what is missed, and its baseline finds what can be seen."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver.placement.problem import ProblemBox
from tests.bench.__main__ import gap, guess_lines, optimum_lines, verdict_lines
from tests.bench.baseline import guess
from tests.bench.measure import Found, Measured, against_optimum, found, measure
from tests.bench.rooms import HOUSE, house_problems, room_problem
from tests.oracles import sums
from tests.oracles.optimum import Optimum
from tests.oracles.problem import Problem
from tests.oracles.problems import solve
from tests.oracles.verdict import verdict, witness

SEEDS = range(120)


def bodies(problem: Problem) -> list[ProblemBox]:
    return [part for part in problem.boxes if not part.stand]


def cover(problem: Problem) -> float:
    """The bodies' footprints over the smallest floor that the bounds speak of."""
    sides = []
    for axis in (0, 1):
        low = min(problem.low[axis][b.var[axis]] + b.offset[axis] for b in bodies(problem))
        high = max(problem.high[axis][b.var[axis]] + b.offset[axis] + b.extent[axis] for b in bodies(problem))
        sides.append(high - low)
    return sum(b.extent[0] * b.extent[1] for b in bodies(problem)) / (sides[0] * sides[1])


def test_the_rooms_are_as_many_and_as_full_as_said() -> None:
    problems = [room_problem(seed) for seed in SEEDS]
    assert {len(bodies(problem)) for problem in problems} == set(range(3, 15))
    covers = sorted(cover(problem) for problem in problems)
    assert covers[0] > 0.09
    assert covers[-1] < 0.5
    assert covers[12] < 0.2
    assert covers[-12] > 0.4
    assert any(part.stand for problem in problems for part in problem.boxes)


def test_a_house_has_thirteen_possible_rooms_of_eighty_pieces() -> None:
    problems = house_problems(3, lambda problem: verdict(problem) is True)
    assert sorted(len(bodies(problem)) for problem in problems) == sorted(HOUSE)
    assert sum(HOUSE) == 80


def measured() -> list[Measured]:
    return [measure(seed) for seed in (0, 2, 7)]


def met(lines: list[tuple[str, str, str, bool | None]], what: str) -> bool | None:
    return next(line[3] for line in lines if line[0].startswith(what))


def test_the_table_marks_a_wrong_verdict_and_a_wrong_cost() -> None:
    rooms = measured()
    assert met(verdict_lines(rooms), "verdict") is True
    assert met(verdict_lines(rooms), "results") is True
    assert guess_lines(rooms)[0][1].endswith("%")
    wrong = [replace(rooms[0], verdict=not rooms[0].verdict), *rooms[1:]]
    assert met(verdict_lines(wrong), "verdict") is False
    unsound = [replace(rooms[0], ours=replace(rooms[0].ours, sound=False, proven=False)), *rooms[1:]]
    assert met(verdict_lines(unsound), "results") is False
    assert met(verdict_lines(unsound), "proven") is False


def test_the_table_marks_an_optimum_that_is_none() -> None:
    pair = against_optimum((0, 5.0))
    assert met(optimum_lines([pair]), "cost gap") is True
    ours, cpu, _ = pair
    assert met(optimum_lines([(ours, cpu, Optimum(ours.cost + 1e-4, True, 1.0))]), "cost gap") is False
    assert met(optimum_lines([(ours, cpu, Optimum(ours.cost - 1e-4, False, 1.0))]), "proven, yet") is False
    assert met(optimum_lines([(Found(False, float("inf"), True, True, 1), cpu, Optimum(1.0, True, 1.0))]), "cost gap") is False


@pytest.mark.parametrize(("a", "b", "expected"), [(2.0, 2.2, 0.1), (0.1, 0.2, 0.1), (float("inf"), float("inf"), 0.0)])
def test_the_gap_is_absolute_below_one_and_relative_above(a: float, b: float, expected: float) -> None:
    assert gap(a, b) == pytest.approx(expected)


def test_the_heuristics_find_rooms_but_not_all_and_never_beat_the_search() -> None:
    """Theirs is a first-order solver's answer, so its cost may lie below the optimum by its tolerance."""
    results = []
    for seed in range(40):
        problem = room_problem(seed)
        ours, theirs = found(problem), guess(problem)
        assert ours.found or not theirs.found
        assert theirs.cost >= ours.cost - 1e-3 or not ours.proven
        results.append((ours.found, theirs.found))
    assert results.count((True, True)) > 5
    assert results.count((True, False)) > 5


def test_hardly_a_room_takes_many_qps() -> None:
    """A QP takes about a microsecond: 99 of 100 rooms stay within a millisecond with half of it to spare."""
    outcomes = [solve(room_problem(seed)) for seed in range(400)]
    assert all(outcome.proven for outcome in outcomes)
    counts = sorted(outcome.solves for outcome in outcomes)
    assert counts[395] <= 700
    assert sum(counts) <= 60 * len(counts)


def test_a_shown_placement_adds_up() -> None:
    problem = room_problem(7)
    shown = witness(problem)
    assert shown is not None
    p = [[value / 1000 for value in axis] for axis in shown]
    assert sums.worst(problem, p) <= 1e-9
    assert sums.cost(problem, p) >= found(problem).cost - 1e-9
    p[0][0] += 50
    assert sums.worst(problem, p) > 40
