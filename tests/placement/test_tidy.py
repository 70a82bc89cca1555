"""Tidying closes or opens slivers between two pieces, says what it cost, and moves nothing where that would cost too much."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver.geometry import Rect
from solver.pieces import Arrangement, Attach, Candidate, Doorway, Piece, Space, Stand, Zone
from solver.placement import opened, place
from solver.streams import Stream
from tests.oracles import sums
from tests.oracles.problem import Problem, problem_of
from tests.placement.rooms import random_space, random_wanted

ROOM = Space("r", Rect(50, 50, 4050, 3050), (), (Doorway("d", "south", Rect(1600, 2150, 2500, 3050), "hallway"),))
SIZE = (800, 400, 900)
WEIGHT = 2.0


def at_north(label: str, x: int, weight: float = WEIGHT) -> Piece:
    """Returns a piece whose west edge is wished at x, mm, with its back to the north wall."""
    way = Candidate("box", SIZE, 0, wall="north", anchor_mm=(x + SIZE[0] // 2, 280), weights=(weight, weight))
    return Piece(label, True, (way,), stands=(Stand("front"),))


def both(*pieces: Piece, room: Space = ROOM) -> tuple[Arrangement, Arrangement]:
    """Returns a room as it is placed, and the same tidied."""
    return place([(room, pieces)])[0], place([(room, pieces)], tidy=True)[0]


def edges(arrangement: Arrangement) -> list[tuple[int, int]]:
    """Returns where pieces begin and end along x, mm."""
    return [(placed.footprint.x0, placed.footprint.x1) for placed in arrangement.placed]


def test_a_sliver_between_two_pieces_is_closed_at_its_cost() -> None:
    before, after = both(at_north("a", 1000), at_north("b", 1900))
    assert edges(before) == [(1000, 1800), (1900, 2700)]
    (_, end), (start, _) = edges(after)
    assert 0 <= start - end <= 40
    assert after.cost - before.cost == pytest.approx(WEIGHT * 0.07**2, abs=1e-6)
    assert [placed.footprint.z0 for placed in after.placed] == [80, 80]


def test_a_sliver_to_a_wall_is_closed() -> None:
    _, after = both(at_north("a", 150))
    assert 50 <= edges(after)[0][0] <= 90


def test_what_touches_slides_along() -> None:
    _, after = both(at_north("a", 130), at_north("b", 930))
    assert edges(after) == [(80, 880), (880, 1680)]


def test_what_is_attached_slides_along() -> None:
    beside = Candidate("small", (400, 400, 500), 0, attach=Attach("b", "box", (620, 620), (0, 0)))
    _, after = both(at_north("a", 1000, 20.0), at_north("b", 1900), Piece("c", True, (beside,)))
    assert edges(after) == [(1000, 1800), (1830, 2630), (2650, 3050)]


def test_a_sliver_that_cannot_be_closed_is_opened_for_a_hand() -> None:
    room = replace(ROOM, zones=(Zone(Rect(1820, 50, 1880, 1000), 0, "pipe"),))
    before, after = both(at_north("a", 1000), at_north("b", 1900), room=room)
    (_, end), (start, _) = edges(before)
    assert 50 <= start - end < 150
    (_, end), (start, _) = edges(after)
    assert start - end >= 300


def test_what_is_wished_together_touches_however_little_parts_it() -> None:
    deep = Candidate("deep", (800, 700, 900), 0, wall="north", anchor_mm=(2200, 430), weights=(WEIGHT, WEIGHT))
    room = replace(ROOM, zones=(Zone(Rect(1700, 500, 1820, 600), 0, "pipe"),))
    before, after = both(at_north("a", 1000), Piece("b", True, (deep,)), room=room)
    assert edges(before) == [(1000, 1800), (1820, 2620)]
    assert edges(after) == [(1020, 1820), (1820, 2620)]
    before, after = both(at_north("a", 980), Piece("b", True, (deep,)), room=room)
    assert edges(before) == edges(after) == [(980, 1780), (1820, 2620)]


def test_nothing_moves_where_that_costs_too_much() -> None:
    within = [Rect(x - 10, 50, x + 810, 3050) for x in (1000, 1900)]
    pieces = [at_north("a", 1000), at_north("b", 1900)]
    fixed = [
        Piece(piece.label, True, (Candidate("box", SIZE, 0, wall="north", anchor_mm=piece.candidates[0].anchor_mm, within=rect),))
        for piece, rect in zip(pieces, within, strict=True)
    ]
    before, after = both(*fixed)
    assert before == after
    dear = both(at_north("a", 1000, 80.0), at_north("b", 1940, 80.0))
    assert dear[0] == dear[1]


def test_tidying_costs_what_the_terms_of_the_bodies_say() -> None:
    slid = 0
    for seed in range(60):
        stream = Stream(seed, "tidy")
        space = random_space(stream)
        asked = random_wanted(space, stream, 3 + seed % 7)
        both_ways, costs = [opened(space, asked, tidy=tidy) for tidy in (False, True)], []
        problem, added = problem_of(both_ways[0].core), both_ways[1].solved.answer.made.added
        moved = {(axis, box.var[axis]) for box in problem.boxes if not box.stand for axis in (0, 1)}
        for made in both_ways:
            metres = [[at / 1000 for at in own] for own in made.engine.grid.positions.tolist()]
            costs.append(sums.cost(Problem(terms=[term for term in problem.terms if (term.axis, term.j) in moved]), metres))
            assert made.solved.walkable != bool(made.solved.arrangement.notes)
        assert added == pytest.approx(costs[1] - costs[0], abs=1e-8)
        assert added <= 0.8
        slid += costs[1] != costs[0]
    assert slid > 5


def test_wide_gaps_and_contacts_stay() -> None:
    before, after = both(at_north("a", 1000), at_north("b", 2150), at_north("c", 2990))
    assert before == after
