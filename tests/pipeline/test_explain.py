"""explain(): what holds a piece is there and at it; of what was changed nothing is claimed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from compose_homes import Explained, Request, Scene, SceneError, explain, generate
from solver.explained import HOLDERS
from solver.pipeline.explain import AT_PLACE, BALANCED, CHANGED
from solver.scene import Furniture, Room

TOUCHING = 0.015
"""A piece at its wish is this close to it, m: the solve is rounded to millimetres, and slivers are tidied away since."""


@pytest.fixture(scope="module")
def home() -> Scene:
    return generate(Request(seed=9, program="family", decorate=True)).scene


@pytest.fixture(scope="module")
def answers(home: Scene) -> list[tuple[Room, Furniture, Explained]]:
    return [(room, piece, explain(home, piece.id)) for room in home.rooms[:7] for piece in room.furniture]


def test_every_piece_of_a_fresh_home_is_explained(home: Scene, answers: list[tuple[Room, Furniture, Explained]]) -> None:
    known = {piece.id for room in home.rooms for piece in room.furniture} | {o.id for room in home.rooms for o in room.openings}
    assert len(answers) > 30
    for room, piece, answer in answers:
        assert (answer.id, answer.room, answer.stands) == (piece.id, room.id, (piece.x, piece.z))
        assert CHANGED not in answer.notes
        assert not (answer.holds and {AT_PLACE, BALANCED} & set(answer.notes))
        assert {hold.by for hold in answer.holds} - {None} <= known - {piece.id}
        assert {hold.what for hold in answer.holds} <= set(HOLDERS)
        assert all(hold.message.endswith(f": {hold.cost_per_m:.2f} a metre") for hold in answer.holds)
        assert [hold.cost_per_m for hold in answer.holds] == sorted((hold.cost_per_m for hold in answer.holds), reverse=True)
    assert sum(len(answer.holds) for *_, answer in answers) > 20


def test_a_piece_at_its_wish_is_held_by_nothing(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    there = [answer for *_, answer in answers if AT_PLACE in answer.notes]
    assert len(there) > 3
    for answer in there:
        assert answer.wished is not None and not answer.holds
        assert answer.stands == pytest.approx(answer.wished, abs=TOUCHING)


def test_a_wall_that_holds_is_there(answers: list[tuple[Room, Furniture, Explained]]) -> None:
    walls = [(room, piece, hold) for room, piece, answer in answers for hold in answer.holds if hold.what == "wall"]
    assert walls
    for room, piece, hold in walls:
        wide, deep = (piece.width, piece.depth) if piece.rotation % 180 == 0 else (piece.depth, piece.width)
        gaps = {
            "west": piece.x - wide / 2, "east": room.width - piece.x - wide / 2,
            "north": piece.z - deep / 2, "south": room.depth - piece.z - deep / 2,
        }  # fmt: skip
        # It, or what it moves with: a group's members stand within a few metres of one another.
        assert gaps[hold.towards] < 3.0


def test_of_a_changed_room_nothing_is_claimed(home: Scene) -> None:
    room = home.rooms[1]
    moved = replace(room.furniture[0], x=room.furniture[0].x + 0.01)
    changed = replace(home, rooms=(home.rooms[0], replace(room, furniture=(moved, *room.furniture[1:])), *home.rooms[2:]))
    answer = explain(changed, moved.id)
    assert (answer.wished, answer.holds, answer.notes) == (None, (), (CHANGED,))
    untouched = home.rooms[2].furniture[0].id
    assert explain(changed, untouched) == explain(home, untouched)


def test_another_version_made_it(home: Scene) -> None:
    older = replace(home, generator={"version": "0.0.1", "catalog": (home.generator or {})["catalog"]})
    assert explain(older, home.rooms[1].furniture[0].id).notes == (CHANGED,)


def test_an_unknown_id_is_named(home: Scene) -> None:
    with pytest.raises(SceneError, match="no_such"):
        explain(home, "no_such")
