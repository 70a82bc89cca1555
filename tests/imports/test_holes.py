"""Rooms with holes are cut open to a wall: what is around stays floor, and doors into what is within are kept."""

from __future__ import annotations

import pytest

from solver.imports.drawn import DrawnRoom, PlanNotes
from solver.imports.holes import cut_open
from solver.imports.rectilinear import tidied
from tests.imports.plans import box, collection, floor_area, line, polygon, read, rooms_of

CORE = [(3.0, 2.0), (3.0, 4.0), (5.0, 4.0), (5.0, 2.0)]
CUT = 0.1


def around(*holes: list[tuple[float, float]]) -> dict[str, object]:
    made = polygon("Hallway", (0, 0), (8, 0), (8, 6), (0, 6))
    made["geometry"]["coordinates"] += [[*map(list, hole), list(hole[0])] for hole in holes]
    return made


@pytest.mark.parametrize("core", [CORE, CORE[::-1]])
@pytest.mark.parametrize("south", [True, False])
def test_a_room_around_another_is_cut_open_where_no_door_is(core: list[tuple[float, float]], south: bool) -> None:
    y = 2 if south else 4
    answer = read(collection(around(core), box("Bath", 3, 2, 5, 4), line("door", (3.6, y), (4.4, y)), line("door", (1, 0), (1.9, 0))))
    hall, bath = rooms_of(answer).values()
    assert hall.outline is not None
    assert floor_area(hall.outline) == pytest.approx(48 - 4 - 2 * CUT)
    assert [(one.connects_to, one.width) for one in bath.openings] == [(hall.id, 0.8)]
    assert {one.connects_to for one in hall.openings} == {"EXTERIOR", bath.id}
    assert [(one["of"], one["amount"]) for one in answer.changes if one["step"] == "read"] == [("features[0]", 2.0)]
    assert not [issue for issue in answer.issues if issue.severity == "error"]


def test_each_of_several_holes_is_cut_open_and_columns_and_round_ones_are_told() -> None:
    round_one = [(6.0, 5.0), (6.5, 5.6), (7.0, 5.0), (6.5, 4.4)]
    square, column = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)], [(1.0, 4.0), (1.3, 4.0), (1.3, 4.3), (1.0, 4.3)]
    answer = read(collection(around(CORE, square, column, round_one)))
    (room,) = answer.scene.rooms
    assert room.outline is not None
    cuts = sum(float(str(one["amount"])) for one in answer.changes if one["step"] == "read")
    assert floor_area(room.outline) == pytest.approx(48 - 4 - 1 - CUT * cuts)
    assert [one["reason"] for one in answer.unread] == [
        "a hole in a room that is smaller than 0.5 m2, or has no straight side: it is floor"
    ] * 2


def test_a_room_that_is_cut_open_says_nothing_of_outer_walls_by_its_sides() -> None:
    """They are numbered otherwise; one whose hole stays floor keeps what it says."""
    ring = ((0.0, 0.0), (8000.0, 0.0), (8000.0, 6000.0), (0.0, 6000.0))
    for side, kept in ((2000.0, ()), (300.0, (300.0, None))):
        hole = ((3000.0, 2000.0), (3000.0, 2000.0 + side), (3000.0 + side, 2000.0 + side), (3000.0 + side, 2000.0))
        room = cut_open(DrawnRoom(ring, "Hall", "rooms[0]", holes=(hole,), outer=(300.0, None)), (), PlanNotes())
        assert (len(room.points) > 4, room.outer) == (not kept, kept)


def test_no_cut_goes_through_another_hole() -> None:
    """The nearer hole is not cut open to the west, where the entrance is; from the other the shortest way there leads through it."""
    near, far = [(0.3, 1.5), (1.1, 1.5), (1.1, 4.5), (0.3, 4.5)], [(1.3, 2.5), (2.3, 2.5), (2.3, 4.5), (1.3, 4.5)]
    answer = read(collection(around(near, far), line("door", (0, 2.6), (0, 3.3))))
    (room,) = answer.scene.rooms
    assert room.outline is not None
    cuts = [float(str(one["amount"])) for one in answer.changes if one["step"] == "read"]
    assert cuts == pytest.approx([1.5, 0.2])
    assert floor_area(room.outline) == pytest.approx(48 - 2.4 - 2 - CUT * sum(cuts))


@pytest.mark.parametrize("first", range(9))
def test_a_stub_of_wall_without_thickness_is_no_part_of_an_outline(first: int) -> None:
    """It goes out from a corner and back to it: the corner is there twice and stays once."""
    corners = [(0, 0), (9, 0), (9, 9), (6, 9), (6, 5), (8, 5), (8, 5), (6, 5), (0, 5)]
    assert tidied([*corners[first:], *corners[:first]]) == [(0, 0), (9, 0), (9, 9), (6, 9), (6, 5), (0, 5)]


def test_a_hallway_around_a_core_between_walls_is_cut_open_and_named_by_its_own_text() -> None:
    """Walls of 0.2 m: around 10 x 8 m, and around a bath of 2 x 2 m in their middle, whose door leads into the hallway."""
    walls = "M0 0 H1000 V800 H0 Z M20 20 V780 H980 V20 Z M380 280 H620 V520 H380 Z M400 300 V500 H600 V300 Z"
    names = "<text x='500' y='400'>Bath</text><text x='200' y='100'>Hallway</text>"
    doors = "<rect class='door' x='450' y='280' width='90' height='20'/><rect class='door' x='100' y='0' width='90' height='20'/>"
    content = f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='cm'><path id='walls' d='{walls}'/>{names}{doors}</svg>"
    answer = read(content.encode(), "plan.svg")
    found = {room.type: room for room in answer.scene.rooms}
    assert found.keys() == {"bathroom", "hallway"}
    assert found["hallway"].outline is not None
    assert len([one for one in answer.changes if one["step"] == "read"]) == 1
    assert floor_area(found["hallway"].outline) == pytest.approx(9.8 * 7.8 - 2.2**2, abs=0.3)
    assert {one.connects_to for one in found["hallway"].openings} == {"EXTERIOR", found["bathroom"].id}
    assert not [issue for issue in answer.issues if issue.severity == "error"]
    assert not answer.unread
