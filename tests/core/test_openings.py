"""Openings as the core cuts them: bit for bit those of the reference; and what it does with nonsense."""

from __future__ import annotations

from random import Random

import pytest

from solver.core import CoreFailed, ask
from solver.floorplan.openings import door_places, open_walls
from tests.core.test_native_openings import rows_asked
from tests.floorplan.opened import opened_question
from tests.floorplan.reference import openings as reference
from tests.sweeps import seeds


@pytest.mark.parametrize("block", range(4))
def test_walls_are_opened_as_by_the_reference(block: int) -> None:
    """And doors could stand elsewhere where the reference would have them stand."""
    kinds, moved, numbers = set(), 0, seeds(range(block, 2400, 4), 61)
    for number in numbers:
        question = opened_question(number)
        cuts, notes = open_walls(*question[:3])
        expected = reference.open_walls(*question[:3])
        assert ([(cut.id, cut.kind, *cut[2:]) for cut in cuts], notes) == ([tuple(cut) for cut in expected[0]], expected[1]), number
        kinds |= {cut.kind for cut in cuts}
        for cut in [cut for cut in cuts if cut.kind in ("door", "passage")][:3]:
            places = door_places(question.house, question.shared, cuts, cut)
            assert places == reference.door_places(question.house, question.shared, cuts, cut), (number, cut.id)
            moved += bool(places)
    assert kinds >= {"door", "passage", "window"}
    assert moved > len(numbers)


def test_bytes_that_are_spoiled_end_in_an_answer_or_a_refusal() -> None:
    rng, refused = Random(2), 0
    for number in range(120):
        name, rows = rows_asked(number % 20)[number % 2]
        spoiled = bytearray(rows)
        for _ in range(rng.randint(1, 4)):
            spoiled[rng.randrange(len(spoiled))] = rng.randrange(256)
        try:
            ask(name, bytes(spoiled))
        except CoreFailed:
            refused += 1
    assert 0 < refused < 120


@pytest.mark.parametrize("size", [0, 3, 79, 80, 200])
def test_bytes_that_are_cut_off_are_refused(size: int) -> None:
    for name, rows in rows_asked(0):
        with pytest.raises(CoreFailed, match="the request is none"):
            ask(name, rows[:size])
