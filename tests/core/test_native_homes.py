"""Homes found by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from solver.core import ask
from solver.floorplan.programme.home_search import GIVEN, home_rows, rows_within
from tests.core.native import Native
from tests.floorplan.searches import HomeQuestion, home_question
from tests.sweeps import seeds


def rows_of(question: HomeQuestion) -> bytes:
    """What the core is asked."""
    if question.outline == GIVEN:
        return rows_within(question.planned, question.tilings, question.seed.seed, question.walls)
    return home_rows(question.planned, lambda _: question.frame, question.seed, question.walls, question.outline)


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    asked = [rows_of(home_question(number)) for number in seeds(range(1200), 11)]
    assert native.answers("search_home", ([rows] for rows in asked)) == b"".join(ask("find_home", rows) for rows in asked)
