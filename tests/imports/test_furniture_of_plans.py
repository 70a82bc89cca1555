"""Furniture as people draw it: chairs at an angle and pushed in, cabinets on the wall, a tap above the sill; all of it stays."""

from __future__ import annotations

import json

import pytest

from solver import fix
from solver.answers import PlanImport
from solver.exchange import dump_scene, read_scene
from solver.scene import Furniture, Room, Scene
from tests.imports.plans import Feature, box, collection, line, piece, read

DOOR = line("door", (0.2, 0), (1.1, 0))


def imported(*features: Feature, width: float = 5.0, depth: float = 4.6) -> PlanImport:
    return read(collection(box("Kitchen", 0, 0, width, depth), DOOR, *features, wall_thickness=0.1, y="down"), furniture=True)


def chair(x: float, y: float, turn: float) -> Feature:
    return piece("Chair", x, y, rotation=turn, width=0.4, depth=0.42, height=0.9)


def names(answer: PlanImport) -> list[str]:
    return sorted(one.name for one in answer.scene.rooms[0].furniture)


def errors(answer: PlanImport) -> list[str]:
    return [issue.message for issue in answer.issues if issue.severity == "error"]


def test_six_chairs_at_an_oval_table_stay() -> None:
    """Those at its corners are drawn at 45 degrees: squared up they take no more floor than a chair."""
    table = piece("Oval table", 2.5, 2.4, width=1.1, depth=1.5, height=0.74)
    corners = [chair(2.1, 3.0, 135), chair(2.1, 1.9, 45), chair(2.86, 1.85, 319.6), chair(2.91, 2.98, 223.9)]
    answer = imported(table, *corners, chair(2.0, 2.43, 90), chair(2.99, 2.42, 270))
    assert names(answer) == ["Chair"] * 6 + ["Oval table"]
    assert errors(answer) == []


@pytest.mark.parametrize("off", [0.0, 0.0002, 0.0005, 0.0007])
@pytest.mark.parametrize("turn", [0, 90, 180, 270])
def test_a_repaired_chair_at_a_table_does_not_drift(off: float, turn: int) -> None:
    """It is drawn too far under its table, at any fraction of a millimetre; a second repair changes nothing."""
    x, z = {0: (0.0, -0.2), 90: (-0.2, 0.0), 180: (0.0, 0.2), 270: (0.2, 0.0)}[turn]
    table = Furniture("table", "dining_table", x=2.0, z=2.0, rotation=0, width=0.8, depth=0.8, height=0.74)
    seat = Furniture(
        "seat", "dining_chair", x=2.0 + x + off, z=2.0 + z + off, rotation=turn, width=0.4, depth=0.42, height=0.9, under="table"
    )
    (room,) = fix(Scene(rooms=(Room("r", width=4.0, depth=4.0, furniture=(table, seat)),))).scene.rooms
    again = fix(Scene(rooms=(room,)))
    assert again.scene.rooms[0].furniture == room.furniture
    assert [one.id for one in room.furniture] == ["table", "seat"]
    assert not [issue for issue in again.issues if issue.severity == "error"]


def test_cabinets_and_boards_on_the_wall_hang_there() -> None:
    cabinet = piece("Kitchen upper cabinet", 2.0, 0.25, width=0.6, depth=0.36, height=0.7, elevation=1.5)
    board = piece("Bedside table", 3.5, 0.26, width=0.44, depth=0.41, height=0.02, elevation=1.71)
    answer = imported(cabinet, board, piece("Kitchen cabinet", 2.0, 0.37, width=0.6, depth=0.6, height=0.85))
    (room,) = answer.scene.rooms
    assert {(one.name, one.mounted_on_wall) for one in room.decorations} == {("Kitchen upper cabinet", "north"), ("Bedside table", "north")}
    assert names(answer) == ["Kitchen cabinet"]
    assert errors(answer) == []


def test_lamps_at_the_ceiling_are_left_out() -> None:
    answer = imported(piece("Pendant lamp", 2.0, 2.0, width=0.4, depth=0.4, height=0.4, elevation=1.9))
    assert not answer.scene.rooms[0].decorations
    assert any("no furniture" in str(one["reason"]) for one in answer.unread)


def test_a_sink_whose_tap_is_drawn_a_little_above_the_sill_stays_beneath_the_window() -> None:
    window = line("window", (2.0, 0), (3.2, 0), sill=1.05, height=1.2)
    answer = imported(window, piece("Sink", 2.6, 0.38, width=1.2, depth=0.64, height=1.055))
    (sink,) = answer.scene.rooms[0].furniture
    assert (sink.height, round(sink.x, 2), sink.z < 0.45) == (1.05, 2.6, True)
    assert [(one["of"], one["amount"]) for one in answer.changes if "sill" in str(one["message"])] == [(sink.id, 0.005)]
    assert errors(answer) == []


KITCHEN: dict[str, float] = {"depth": 0.6, "height": 0.85}
ROW = {"Stove": (0.6, 0.35), "Counter": (0.9, 1.1), "Sink": (0.8, 1.95)}
"""Widths along the south wall, and where their middles are drawn, m: 0.05 to 2.35 and no gap between."""


def row(into_wall: float, into_next: float, askew: float) -> PlanImport:
    """A kitchen's row that is drawn a little into the wall behind it and each into the next, the counter turned a little."""
    middle = 4.6 - 0.05 - 0.3 + into_wall
    pieces = [
        piece(name, at + into_next / 2, middle, **KITCHEN | {"width": width + into_next, "rotation": 180 + askew * (name == "Counter")})
        for name, (width, at) in ROW.items()
    ]
    return imported(*pieces)


@pytest.mark.parametrize("askew", [0.0, 0.06])
@pytest.mark.parametrize(("into_wall", "into_next"), [(0.0, 0.002), (0.003, 0.0), (0.004, 0.008)])
def test_what_is_drawn_a_hair_into_a_wall_or_a_neighbour_is_cut_and_stays(into_wall: float, into_next: float, askew: float) -> None:
    answer = row(into_wall, into_next, askew)
    (room,) = answer.scene.rooms
    assert errors(answer) == []
    for one in room.furniture:
        width, at = ROW[one.name]
        assert (one.x, one.z) == pytest.approx((at, 4.25), abs=0.011)
        assert width - into_next - 0.001 <= one.width <= width + into_next + 0.001
        assert one.rotation == 180
    told = {change["of"]: change["amount"] for change in answer.changes if "smaller" in str(change["message"])}
    cut = [one for one in room.furniture if one.depth < 0.5995 or one.width < ROW[one.name][0] + into_next - 0.0005]
    assert {one.id for one in cut} == set(told)
    assert all(0 < float(str(amount)) <= 0.01 for amount in told.values())
    assert any("turned by 0.06 degrees" in str(change["message"]) for change in answer.changes) == bool(askew)


def test_what_is_drawn_farther_in_is_not_cut() -> None:
    answer = row(0.0, 0.03, 0.0)
    assert all(one.width == pytest.approx(ROW[one.name][0] + 0.03) for one in answer.scene.rooms[0].furniture)
    assert not [change for change in answer.changes if "smaller" in str(change["message"])]


@pytest.mark.parametrize("sill", [0.2, 0.45, 0.9])
def test_a_bookcase_drawn_before_a_window_goes_to_a_wall_and_not_into_the_room(sill: float) -> None:
    window = line("window", (1.7, 4.6), (3.3, 4.6), sill=sill, height=1.4)
    answer = imported(window, piece("Bookcase", 2.5, 4.6 - 0.08 - 0.15, rotation=180, width=0.9, depth=0.3, height=2.0))
    (room,) = answer.scene.rooms
    (bookcase,) = room.furniture
    assert errors(answer) == []
    back = {"north": bookcase.z, "south": room.depth - bookcase.z, "west": bookcase.x, "east": room.width - bookcase.x}
    assert back[bookcase.wall or ""] < 0.3
    assert [change["of"] for change in answer.changes if str(change["message"]).startswith("moved")] == [bookcase.id]


def test_what_stands_free_names_no_wall() -> None:
    answer = imported(
        piece("Bookcase", 2.5, 2.3, width=0.9, depth=0.3, height=2.0),
        piece("Wardrobe", 4.6, 3.0, rotation=270, width=1.2, depth=0.6, height=2.0),
    )
    assert [one.wall for one in answer.scene.rooms[0].furniture] == [None, "east"]


def test_pieces_that_say_one_id_are_told_apart() -> None:
    """A copied element has the id of the first; made-up ids are none that another piece says."""
    sofas = [piece("Sofa", 1.2, 0.5 + y, id="kitchen_0/chair_2", width=1.6, depth=0.8, height=0.8) for y in (0.0, 1.5)]
    vases = [piece("Vase", 4.0 + x, 4.0, id="vase", width=0.2, depth=0.2, height=0.3) for x in (0.0, 0.5)]
    answer = imported(*sofas, chair(4.0, 1.0, 0), chair(4.0, 2.0, 0), *vases)
    (room,) = answer.scene.rooms
    ids = [*(one.id for one in room.furniture), *(one.id for one in room.decorations)]
    assert len(set(ids)) == len(ids) == 6
    assert {"kitchen_0/chair_2", "vase"} < set(ids)
    told = [change for change in answer.changes if "has the id" in str(change["message"])]
    assert [change["of"] for change in told] == ["features[3]", "features[7]"]
    assert read_scene(json.loads(dump_scene(answer.scene, "json"))).rooms[0].furniture == room.furniture


@pytest.mark.parametrize("height", [1e9, 51.0, -1e9])
def test_what_is_far_above_or_below_the_floor_is_left_out_and_named(height: float) -> None:
    answer = imported(piece("Toilet", 2.0, 2.0, width=0.4, depth=0.66, height=0.8, elevation=height))
    assert not answer.scene.rooms[0].furniture and not answer.scene.rooms[0].decorations
    assert [one["reason"] for one in answer.unread] == ["'Toilet': it is more than 50 m from the floor"]


def test_a_piece_drawn_with_its_front_at_a_wall_is_turned_about() -> None:
    """A wardrobe and a sofa face the wall; another sofa stands free, a chair looks at the wall as chairs may."""
    size = {"width": 2.0, "depth": 0.9, "height": 0.8}
    plan = collection(
        box("Living room", 0, 0, 6, 5),
        piece("Wardrobe", 1.2, 0.35, width=1.6, depth=0.6, height=2.0, rotation=180, id="wardrobe"),
        piece("Sofa", 4.2, 0.55, **size, rotation=180, id="facing"),
        piece("Sofa", 3.2, 3.0, **size, rotation=180, id="free"),
        piece("Chair", 0.4, 4.0, width=0.45, depth=0.45, height=0.9, rotation=270, id="chair"),
        y="down",
    )
    answer = read(plan)
    turns = {one.id: one.rotation for one in answer.scene.rooms[0].furniture}
    assert turns == {"wardrobe": 0.0, "facing": 0.0, "free": 180.0, "chair": 270.0}
    told = [change["of"] for change in answer.changes if "drawn with its front at a wall" in str(change["message"])]
    assert told == ["facing", "wardrobe"]


@pytest.mark.parametrize("first", ["Cabinet", "Television"])
def test_a_screen_that_is_drawn_in_a_cabinet_stands_on_it(first: str) -> None:
    parts = [piece("TV unit", 2, 0.26, width=1.0, depth=0.52, height=0.93),
             piece("Television", 2.1, 0.25, width=0.8, depth=0.2, height=0.5, elevation=0.42)]  # fmt: skip
    walls = [box("Living room", 0, 0, 4, 4), line("door", (1, 4), (1.9, 4))]
    answer = read(collection(*walls, *(parts if first == "Cabinet" else parts[::-1]), y="down", drawn="inner"))
    screen, cabinet = sorted(answer.scene.rooms[0].furniture, key=lambda one: one.height)
    assert (screen.on, screen.y, cabinet.on) == (cabinet.id, 0.93, None)
    assert abs(screen.x - cabinet.x) == pytest.approx(0.1) and abs(screen.z - cabinet.z) < 0.05
    assert [one["amount"] for one in answer.changes if "drawn within it" in str(one["message"])] == [pytest.approx(0.51)]
    assert [issue.message for issue in answer.issues if issue.severity == "error"] == []
