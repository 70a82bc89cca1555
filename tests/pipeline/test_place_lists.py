"""Lists without relations are placed as a person would: all of it, in ways one can walk, seats at tables, nothing heaped."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from catalogs.schema import RelationSpec
from solver import place
from solver.errors import RequestError
from solver.pipeline.place_task import PlaceSetting, finished, task_of
from solver.pipeline.rounds import quick_placement
from solver.requested import Answered, PieceRequest
from solver.scene import Furniture, Room
from tests.pipeline.place_lists import TASKS, drawn
from tests.sweeps import seeds
from tests.told_forms import has_form

ANSWERS: dict[str, Answered] = {}
WAY = 0.9


def answer(name: str) -> Answered:
    if name not in ANSWERS:
        ANSWERS[name] = place(*TASKS[name])
    return ANSWERS[name]


def pieces(name: str, word: str = "") -> list[Furniture]:
    return [piece for piece in answer(name).best.scene.rooms[0].furniture if word in piece.id]


def gap(a: Furniture, b: Furniture) -> float:
    """The free distance between two footprints, m."""
    (aw, ad), (bw, bd) = ((p.width, p.depth) if p.rotation % 180 == 0 else (p.depth, p.width) for p in (a, b))
    return max(abs(a.x - b.x) - (aw + bw) / 2, abs(a.z - b.z) - (ad + bd) / 2)


@pytest.mark.parametrize("name", TASKS)
def test_all_of_it_stands_and_can_be_walked_to(name: str) -> None:
    found = answer(name)
    assert found.best.unplaced == ()
    assert [issue for issue in found.best.issues if issue.severity == "error"] == []
    assert len(pieces(name)) == sum(wish.count for wish in TASKS[name][1])
    assert found.best.relations == ()


@pytest.mark.parametrize("seed", seeds(range(300), 41))
def test_drawn_lists_stand_whole(seed: int) -> None:
    room, wanted = drawn(seed)
    found = place(room, wanted).best
    assert found.unplaced == ()
    assert [issue for issue in found.issues if issue.severity == "error"] == []


@pytest.mark.parametrize(
    ("name", "seats", "tables"), [("restaurant", 14, 4), ("canteen", 15, 5), ("bistro", 12, 4), ("bar", 10, 4), ("meeting room", 8, 1)]
)
def test_seats_are_dealt_evenly_over_the_tables(name: str, seats: int, tables: int) -> None:
    chairs = [piece for piece in pieces(name) if "chair" in piece.id or "stool" in piece.id]
    boards = [piece for piece in pieces(name, "table") if piece not in chairs]
    nearest = Counter(min(boards, key=lambda board: gap(chair, board)).id for chair in chairs)
    assert (len(chairs), len(nearest)) == (seats, tables)
    assert max(nearest.values()) - min(nearest.values()) <= 1
    assert all(min(gap(chair, board) for board in boards) <= 0.3 for chair in chairs)


@pytest.mark.parametrize("of", [("table",), ("table_1", "table_2")])
@pytest.mark.parametrize(("word", "host", "count"), [("around", "dining_table", 8), ("beside", "single_bed", 4), ("under", "desk", 2)])
def test_places_at_any_of_several_pieces_are_dealt_evenly(of: tuple[str, ...], word: str, host: str, count: int) -> None:
    """Each piece is there for as many, by whatever names they are called."""
    own = "small_nightstand" if word == "beside" else "dining_chair"
    hosts = [PieceRequest("table", host, count=2)] if len(of) == 1 else [PieceRequest(name, host) for name in of]
    asked = PieceRequest("own", own, count=count, relations=(RelationSpec(type=word, of=of),))
    found = place(Room("den", width=6.0, depth=6.0), [*hosts, asked]).best
    assert all(one.held for one in found.relations)
    stood = found.scene.rooms[0].furniture
    boards = [piece for piece in stood if "table" in piece.id]
    nearest = Counter(min(boards, key=lambda board: gap(piece, board)).id for piece in stood if "own" in piece.id)
    assert [*nearest.values()] == [count // 2] * 2


@pytest.mark.parametrize(
    ("name", "word"), [("gallery", "s"), ("restaurant", "dining_table"), ("canteen", "table"), ("shop", "clothes_rail")]
)
def test_large_free_pieces_keep_ways_between_them(name: str, word: str) -> None:
    free = [piece for piece in pieces(name, word) if piece.wall is None and min(piece.width, piece.depth) >= 0.6]
    assert all(gap(a, b) >= WAY for k, a in enumerate(free) for b in free[:k])


def test_every_desk_has_its_chair() -> None:
    for name in ("shared office", "open office", "class room", "two children"):
        desks = {piece.id for piece in pieces(name, "desk")}
        under = [piece.under for piece in pieces(name, "chair")]
        assert sorted(label for label in under if label) == sorted(desks)


def test_what_nobody_knows_stands_as_its_size_says() -> None:
    """What is tall has its back at a wall."""
    for name, word in (("large waiting room", "vending"), ("open office", "water"), ("meeting room", "whiteboard")):
        room = TASKS[name][0]
        for piece in pieces(name, word):
            back = {0: piece.z, 90: piece.x, 180: room.depth - piece.z, 270: room.width - piece.x}[int(piece.rotation)]
            assert back == pytest.approx(piece.depth / 2 + 0.03, abs=0.05)


def test_what_a_list_does_say_counts_alone() -> None:
    """A chair that asks for a corner is in one, not at the table."""
    room, wanted = TASKS["dining room"]
    asked = tuple(replace(wish, count=1, relations=(RelationSpec(type="in_corner"),)) if "chair" in wish.id else wish for wish in wanted)
    found = place(room, asked).best
    assert [one.held for one in found.relations] == [True]
    assert found.unplaced == ()


@pytest.mark.parametrize(
    ("pieces", "more", "words"),
    [
        ([], {"alternatives": "x"}, r"alternatives: is 'x' \(allowed: a whole number from 1 to 16\)"),
        ([], {"alternatives": 2.5}, r"alternatives: is 2.5 \(allowed: a whole number"),
        ([], {"robot_width": "x"}, r"robot_width: is 'x' \(allowed: a number of metres\)"),
        ([], {"height": "x"}, r"height: is 'x' \(allowed: a number of metres\)"),
        ([{"id": 3}], {}, r"pieces\[0\].id: is 3 \(allowed: a text\)"),
        ([{"id": "bed", "width": "x"}], {}, r"pieces\[0\].width: is 'x'"),
        ([{"id": "bed", "count": "x"}], {}, r"pieces\[0\].count: is 'x' \(allowed: a whole number"),
        ([{"id": "bed", "relations": "x"}], {}, r"pieces\[0\].relations: is 'x' \(allowed: a list\)"),
        ([{"id": "bed", "relations": RelationSpec(type="in_corner")}], {}, r"pieces\[0\].relations: is .*\(allowed: a list\)"),
    ],
)
def test_values_of_a_wrong_type_are_refused_by_their_field(pieces: list[dict[str, Any]], more: dict[str, Any], words: str) -> None:
    with pytest.raises(RequestError, match=f"^{words}"):
        place(Room("den", width=4, depth=3), [PieceRequest(**piece) for piece in pieces], **more)


def test_of_a_name_that_is_no_kind_the_nearest_kind_is_told() -> None:
    with pytest.raises(RequestError) as caught:
        place(Room("den", width=4.0, depth=3.0), [PieceRequest("books", "Bookshelve")])
    assert caught.value.allowed == "a number from 0.001 to 100, m; or a kind as its name, such as 'bookshelf'"
    assert has_form(caught.value.allowed)


_TABLE = PieceRequest("table", "dining_table", 1.8, 0.9, 0.75)
_AT_WALL = replace(_TABLE, relations=(RelationSpec(type="against_wall"),))
_ISLAND = PieceRequest("table", "kitchen_island", 2.0, 0.9, 0.9)


def _around(piece: str, count: int, *sides: str, width: float = 0.45, align: str | None = None) -> PieceRequest:
    around = RelationSpec(type="around", of=("table",), sides=sides, align=align)
    return PieceRequest(piece, "dining_chair", width, 0.5, 0.9, count=count, relations=(around,))


@pytest.mark.parametrize(
    ("table", "chairs", "front", "back", "ends"),
    [
        (_TABLE, [_around("a", 2)], [0], [0], []),
        (_TABLE, [_around("a", 4)], [-0.45, 0.45], [-0.45, 0.45], []),
        (_TABLE, [_around("a", 8)], [-0.6, 0, 0.6], [-0.6, 0, 0.6], [0, 0]),
        (_TABLE, [_around("a", 10)], [-0.675, -0.225, 0.225, 0.675], [-0.675, -0.225, 0.225, 0.675], [0, 0]),
        (_TABLE, [_around("a", 3, "front"), _around("b", 1, "back")], [-0.6, 0, 0.6], [0], []),
        (_TABLE, [_around("a", 2, "left", "right"), _around("b", 4, "front", "back")], [-0.45, 0.45], [-0.45, 0.45], [0, 0]),
        (_TABLE, [_around("a", 2), _around("bench", 1, "front", width=1.2)], [0], [-0.45, 0.45], []),
        (_TABLE, [_around("a", 4, align="centre")], [0], [0], [0, 0]),
        (_AT_WALL, [_around("a", 4)], [-0.6, 0, 0.6], [], [0]),
        (_ISLAND, [_around("a", 3, "back", width=0.4)], [], [-0.41, -0.01, 0.39], []),
    ],
)
def test_chairs_asked_for_around_a_table_share_its_sides(
    table: PieceRequest, chairs: list[PieceRequest], front: list[float], back: list[float], ends: list[float]
) -> None:
    """Each has as much of a side as the others, as near; the ends have what the long sides have no place for; who cooks has room."""
    made = place(Room("den", width=5.0, depth=5.0), [table, *chairs]).best
    found: dict[int, list[float]] = {0: [], 90: [], 180: [], 270: []}
    assert all(one.held for one in made.relations)
    stood, *seats = made.scene.rooms[0].furniture
    off: list[float] = []
    assert stood.id == "table"
    for seat in seats:
        turn = round(seat.rotation - stood.rotation) % 360
        across, along = seat.x - stood.x, seat.z - stood.z
        for _ in range(round(stood.rotation / 90) % 4):
            across, along = -along, across
        length, away = (across, along) if turn % 180 == 0 else (along, across)
        found[turn].append(length)
        off.append(abs(away) - ((stood.depth if turn % 180 == 0 else stood.width) + seat.depth) / 2)
    assert 0.018 <= min(off) <= max(off) <= min(0.052, min(off) + 0.002)
    assert sorted(found[180]) == pytest.approx(front, abs=0.02)
    assert sorted(found[0]) == pytest.approx(back, abs=0.02)
    assert found[90] + found[270] == pytest.approx(ends, abs=0.02)


def test_of_copies_that_are_missing_the_last_ones_are_not_there() -> None:
    asked, room = [PieceRequest("floor_lamp"), PieceRequest("stool", count=3)], Room("den", width=4.0, depth=4.0)
    task = task_of(room, asked, load_catalogs(), PlaceSetting(0.1, 0.6, "osqp", None))
    whole = quick_placement(task, task.pieces).arrangement
    stood = tuple(one for one in whole.placed if one.label == "stool_2")
    found = finished(task, replace(whole, placed=stood, left_out=tuple((name, "none") for name in ("stool_3", "stool_1", "floor_lamp"))))
    assert [piece.id for piece in found.scene.rooms[0].furniture] == ["stool_1"]
    assert [one.id for one in found.unplaced] == ["floor_lamp", "stool_2", "stool_3"]
