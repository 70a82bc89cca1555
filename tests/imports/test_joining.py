"""Which walls an opening comes to lie in: at the last millimetre that does and the first that does not, and what is told of it."""

from __future__ import annotations

import pytest

from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnWall, OpeningKind, PlanNotes
from solver.imports.joining import Joined, joined
from solver.imports.missing_walls import passages
from solver.imports.rectilinear import DrawnLine, PlanEdge, edges_of_corners
from solver.imports.straighten import StraightRoom, tell_of
from solver.imports.units import told_by_doors
from solver.imports.wall_faces import faces_between
from tests.imports.plans import box, collection, line, opening, read

HALF = 50


def rooms(width: int = 4000, gap: int = 4000) -> list[list[PlanEdge]]:
    """Two rooms, one to the south of the other, and how far their lines are apart."""
    south = 4000 + gap
    corners = [(0, 0), (width, 0), (width, 4000), (0, 4000)], [(0, south), (width, south), (width, 8000 + gap), (0, 8000 + gap)]
    return [edges_of_corners(number, one) for number, one in enumerate(corners)]


def placed(ends: tuple[float, float], line: float, kind: OpeningKind = "door", **more: int) -> tuple[Joined, list[str]] | str:
    """Returns an opening along the south wall of the first, in its walls, with what is told of it; or why it is left out."""
    (start, end), notes = [(at, line) for at in ends], PlanNotes()
    found = joined([DrawnOpening(kind, start, end, "here")], rooms(**more), ["", ""], HALF, notes)
    return (found[0], [one.message for one in notes.changes]) if found else notes.unread[0].reason


@pytest.mark.parametrize(("gap", "joins"), [(751, False), (750, True), (0, True), (-10, True), (-11, False)])
def test_a_door_joins_rooms_whose_lines_nearly_meet(gap: int, joins: bool) -> None:
    """A room with a stub of wall keeps its own lines, which may lie beyond those of its neighbour."""
    one = placed((1000, 1900), 4000 + min(gap / 2, 300), gap=gap)
    assert isinstance(one, tuple)
    assert [edge.room for edge in one[0].edges] == ([0, 1] if joins else [0])


@pytest.mark.parametrize(("kind", "least"), [("door", 500), ("passage", 400), ("window", 200), ("garage_door", 1500)])
def test_an_opening_that_is_left_with_too_little_is_none(kind: OpeningKind, least: int) -> None:
    assert isinstance(placed((-500, least + 500), 4000, width=least, kind=kind), tuple)
    assert (
        placed((-500, least + 500), 4000, width=least - 1, kind=kind)
        == f"a {kind.replace('_', ' ')} without a wall: its wall is {least / 1000 - 0.001:.2f} m long"
    )


def test_an_opening_is_no_narrower_than_10_cm() -> None:
    assert isinstance(placed((1000, 1100), 4000), tuple)
    assert placed((1000, 1099), 4000) == "a door 0.10 m wide: a part of one, such as its frame"


def test_an_opening_is_drawn_near_its_wall() -> None:
    assert isinstance(placed((1000, 1900), 4000 + 300 + HALF), tuple)
    assert placed((1000, 1900), 4000 + 301 + HALF) == "a door without a wall: the nearest is 0.35 m away"


@pytest.mark.parametrize(("low", "high", "told"), [
    (-10, 890, []), (-11, 889, ["a door is shifted by 11 mm along its wall, so that it lies in it"]),
    (-5, 1005, []), (-5, 1006, ["a door is 11 mm narrower than drawn, as its wall is no longer"]),
])  # fmt: skip
def test_what_is_shifted_or_shortened_by_more_than_a_centimetre_is_told(low: int, high: int, told: list[str]) -> None:
    one = placed((low, high), 4000, width=1000)
    assert isinstance(one, tuple)
    assert (0 <= one[0].low < one[0].high <= 1000, one[1]) == (True, told)


@pytest.mark.parametrize(("kind", "height", "sill"), [("door", 2.1, 0), ("garage_door", 2.2, 0), ("passage", 2.2, 0), ("window", 1.2, 0.9)])
def test_an_opening_of_which_no_height_is_said_is_as_high_as_usual(kind: OpeningKind, height: float, sill: float) -> None:
    answer = read(collection(box("kitchen", 0, 0, 4, 4), line(kind, (1, 4), (2.8, 4), id="it"), line("door", (1, 0), (2, 0))))
    it = opening(answer.scene.rooms[0], "it")
    assert (it.kind, it.height, it.sill) == (kind, height, sill)


@pytest.mark.parametrize(("gap", "is_passage"), [(600, True), (599, False)])
def test_a_gap_between_drawn_walls_is_a_passage_from_60_cm(gap: int, is_passage: bool) -> None:
    walls = DrawnWall((0, 4050), (950, 4050), 100), DrawnWall((1050 + gap, 4050), (4000, 4050), 100)
    made = passages(rooms(4000, 100), DrawnPlan((), walls=walls), [], (), PlanNotes())
    assert [(one.low, one.high) for one in made] == [(1000, 1000 + gap)] * is_passage


@pytest.mark.parametrize(("said", "width", "metres"), [
    (0.001, 100, 0.001), (0.001, 99.9, 0.01), (0.3048, 32.8, 0.3048), (0.3048, 32.9, 0.0254),
])  # fmt: skip
def test_a_unit_holds_in_which_doors_are_from_10_cm_to_10_m_wide(said: float, width: float, metres: float) -> None:
    """Else it is the one in which they are as wide as doors: here centimetres, and inches."""
    assert told_by_doors([DrawnOpening("door", (0, 0), (width, 0), "here")], said).metres == metres


def test_walls_that_moved_by_more_than_a_millimetre_are_told_of() -> None:
    for shift, count in ((1.0, 0), (1.1, 1)):
        tell_of("room", StraightRoom([], shift=shift), notes := PlanNotes())
        assert len(notes.changes) == count


@pytest.mark.parametrize(("width", "count"), [(650, 1), (649, 0)])
def test_what_walls_enclose_is_a_room_from_65_cm(width: int, count: int) -> None:
    sides = [DrawnLine("x", at, 0, width) for at in (0, 2000)] + [DrawnLine("z", at, 0, 2000) for at in (0, width)]
    assert len(faces_between(sides) or []) == count
