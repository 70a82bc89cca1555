"""The core's search for homes: bit for bit what the reference finds; and what it does with nonsense."""

from __future__ import annotations

import struct
from random import Random
from typing import Any

import pytest

from solver.core import CoreFailed, ask
from solver.floorplan.programme.home_search import GIVEN, FoundHome, HomeVerdict, find_home, find_home_within
from tests.core.test_native_homes import rows_of
from tests.floorplan.reference.asked import between
from tests.floorplan.reference.given_search import GivenSearch
from tests.floorplan.reference.search import HomeSearch
from tests.floorplan.searches import HomeQuestion, home_question
from tests.sweeps import seeds


def bits(verdict: HomeVerdict) -> Any:
    return struct.pack("<d", verdict.cost), tuple(verdict)[1:]


def told(home: FoundHome | None) -> Any:
    """What the core found."""
    if home is None:
        return None
    return home.kind, list(home.boxes), list(home.hallways), (home.width, home.depth), bits(home.verdict)


def by_core(question: HomeQuestion) -> Any:
    if question.outline == GIVEN:
        return told(find_home_within(question.planned, question.tilings, question.seed.seed, question.walls))
    return told(find_home(question.planned, lambda _: question.frame, question.seed, question.walls, question.outline))


def by_reference(question: HomeQuestion) -> Any:
    (seed, turn), planned = question.seed, question.planned
    with between(question.walls):
        if question.outline == GIVEN:
            home = GivenSearch(planned, question.tilings, seed, turn).run()
        else:
            home = HomeSearch(planned, lambda _: question.frame, seed, turn, question.outline).run()
    if home is None:
        return None
    return home.kind, home.sheet.boxes, home.sheet.hallways, (home.sheet.width, home.sheet.depth), bits(home.verdict)


@pytest.mark.parametrize("block", range(4))
def test_homes_are_found_as_by_the_reference(block: int) -> None:
    found, outlines, numbers = 0, set(), seeds(range(block, 1200, 4), 23)
    for number in numbers:
        question = home_question(number)
        core = by_core(question)
        assert core == by_reference(question), number
        found += core is not None
        outlines.add(question.outline)
    assert 2 * found > len(numbers)
    assert len(outlines) >= 4


def test_bytes_that_are_spoiled_end_in_an_answer_or_a_refusal() -> None:
    rng, refused = Random(1), 0
    for number in range(120):
        rows = bytearray(rows_of(home_question(number % 20)))
        for _ in range(rng.randint(1, 4)):
            rows[rng.randrange(len(rows))] = rng.randrange(256)
        try:
            ask("find_home", bytes(rows))
        except CoreFailed:
            refused += 1
    assert 0 < refused < 120


@pytest.mark.parametrize("size", [0, 3, 23, 24, 100])
def test_bytes_that_are_cut_off_are_refused(size: int) -> None:
    with pytest.raises(CoreFailed, match="the request is none"):
        ask("find_home", rows_of(home_question(0))[:size])
