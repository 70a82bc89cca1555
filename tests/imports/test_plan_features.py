"""GeoJSON of a home becomes the scene it draws, and everything that is not as drawn is told."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from solver.errors import FieldError
from solver.exchange import dump_plain, write_scene
from tests.imports.plans import box, collection, floor_area, line, opening, piece, polygon, read, rooms_of

HOME = Path(__file__).parents[2] / "docs" / "plan.geojson"
TWO = (box("Kitchen", 0, 0, 4, 3), box("Living room", 4, 0, 9, 3))


def test_a_feature_alone_is_read() -> None:
    made = read({"type": "Feature", "unit": "m", **TWO[0]}).scene
    assert [(room.type, room.width, room.depth) for room in made.rooms] == [("kitchen", 4.0, 3.0)]


def test_the_home_of_the_documents() -> None:
    answer = read(HOME.read_bytes())
    rooms = rooms_of(answer)
    assert (answer.format, answer.changes, answer.guesses, answer.unread) == ("geojson", (), (), ())
    assert [room.type for room in rooms.values()] == [
        "living_room", "kitchen", "kids_bedroom", "bedroom_master", "hallway", "bathroom", "office", "laundry",
    ]  # fmt: skip
    assert (answer.scene.size and (answer.scene.size.width, answer.scene.size.depth)) == (11.6, 9.2)
    assert rooms["bedroom_master_3"].outline == ((0.0, 0.0), (4.2, 0.0), (4.2, 3.4), (1.8, 3.4), (1.8, 4.8), (0.0, 4.8))
    doors = {one.id: one for room in rooms.values() for one in room.openings}
    assert len(doors) == 15 and [one.id for one in doors.values() if one.main_entrance] == ["door_0"]
    listed = [one.id for room in rooms.values() for one in room.openings]
    joined = {name for name in listed if listed.count(name) == 2}
    assert joined == {one.id for one in doors.values() if one.kind != "window" and not one.main_entrance}
    assert [issue for issue in answer.issues if issue.severity == "error"] == []


def test_a_door_to_a_balcony_that_is_wider_than_a_leaf_is_one_leaf_and_glass() -> None:
    wide = line("door", (1, 3), (3.95, 3))
    room, balcony = read(collection(box("Living room", 0, 0, 5, 3), box("Balcony", 0, 3, 5, 4.5), wide, unit="m")).scene.rooms
    for one in (room, balcony):
        parts = {part.kind: part for part in one.openings}
        assert {kind: (part.width, part.sill, part.height) for kind, part in parts.items()} == {
            "door": (0.95, 0.0, 2.1), "window": (2.0, 0.0, 2.1),
        }  # fmt: skip
        assert abs(parts["door"].position - parts["window"].position) == pytest.approx((0.95 + 2.0) / 2)
    narrow, indoors, hung = (
        line("door", (1, 3), (2.4, 3)),
        line("door", (1, 0), (3.95, 0)),
        {**wide, "properties": {**wide["properties"], "hinge": "start"}},
    )
    for door in (narrow, indoors, hung):
        answer = read(collection(box("Living room", 0, 0, 5, 3), box("Balcony", 0, 3, 5, 4.5), door, unit="m"))
        assert [part.kind for part in answer.scene.rooms[0].openings] == ["door"]


@pytest.mark.parametrize("key", ["kind", "type"])
def test_walls_and_openings_may_be_polygons(key: str) -> None:
    def called(said: str, x0: float, y0: float, x1: float, y1: float, **more: Any) -> dict[str, Any]:
        return box("", x0, y0, x1, y1, **{key: said, "level": 2, **more})

    rooms = [box("", 0, 0, 4, 3, room_name="Kitchen", level=2), box("", 4.1, 0, 9, 3, label="Bedroom", level=2)]
    around = [called("wall", -0.3, -0.3, 9.3, 0), called("wall", -0.3, 3, 9.3, 3.3), called("wall", -0.3, 0, 0, 3)]
    inner = [called("wall", 4, 0, 4.1, 1), called("wall", 4, 1.9, 4.1, 3), called("wall", 9, 0, 9.3, 3)]
    doors = [called("door", 4, 1, 4.1, 1.9, sill=0, id="d"), called("window", 1, -0.3, 2.2, 0), called("door", 6, 3, 6.9, 3.3)]
    above = [called("wall", 0, 0.05, 9, 0.15, level=3), box("Office", 0, 0, 9, 9, level=3)]
    answer = read(collection(*rooms, *around, *inner, *doors, *above, unit="m"))
    kitchen, bedroom = answer.scene.rooms
    assert (kitchen.type, bedroom.type) == ("kitchen", "bedroom")
    assert answer.scene.wall_thickness == 0.1
    assert kitchen.wall_thickness == (0.3, None, 0.3, 0.3)
    assert (kitchen.width, kitchen.depth) == (4.1, 3.1)
    assert {one.id for one in kitchen.openings} & {one.id for one in bedroom.openings} == {"d"}
    assert [(one.kind, one.width) for room in answer.scene.rooms for one in room.openings if one.id != "d"] == [
        ("window", 1.2), ("door", 0.9),
    ]  # fmt: skip
    assert [one["place"] for one in answer.unread] == ["level 3"]


def test_a_property_with_a_slip_of_the_pen_is_said_to_be_left_out() -> None:
    door = line("door", (1, 0), (1.9, 0))
    slipped = {**door, "properties": {**door["properties"], "hieght": 2, "stroke-width": 1}}
    answer = read(collection(box("Office", 0, 0, 4, 3), slipped, unit="m"))
    assert answer.unread == ({"place": "features[1].properties", "reason": "no property is called 'hieght'; height?"},)


def test_ids_names_and_levels_are_taken_as_maps_write_them() -> None:
    """Numbers for ids, in the properties or beside them; names by language; storeys in quotes, the lower one the one that is taken."""
    kitchen = {**box("", 0, 0, 4, 3, level="-1"), "id": 7}
    kitchen["properties"]["name"] = {"en": "Kitchen", "de": "Küche"}
    cellar = box("Living room", 4, 0, 9, 3, level="-1", id=0)
    upper = {**box("Office", 0, 0, 4, 3, level="0"), "id": True}
    upper["properties"]["id"] = "own"
    answer = read(collection(kitchen, cellar, upper, unit="m"))
    assert [(room.type, room.level) for room in answer.scene.rooms] == [("kitchen", -1), ("living_room", -1)]
    assert [one["place"] for one in answer.unread] == ["level 0"]
    door = {**line("door", (1, 0), (1.9, 0)), "id": 12}
    assert opening(read(collection(*TWO, door, unit="m")).scene.rooms[0], "12").kind == "door"
    assert read(collection(upper, unit="m")).scene.rooms[0].type == "office"


def test_y_points_up_unless_it_is_said_to_point_down() -> None:
    door = line("door", (1, 0), (1.9, 0))
    up, down = (opening(read(collection(*TWO, door, y=way)).scene.rooms[0], "door_0") for way in ("up", "down"))
    assert (up.wall, down.wall, up.position, down.position) == ("south", "north", 1.45, 1.45)


def test_a_door_is_listed_by_both_rooms_under_one_id() -> None:
    answer = read(collection(*TWO, line("door", (4, 1), (4, 1.9)), line("door", (1, 0), (1.9, 0), main_entrance=True)))
    kitchen, living = answer.scene.rooms
    here, there = opening(kitchen, "door_0"), opening(living, "door_0")
    assert (here.wall, here.connects_to, there.wall, there.connects_to) == ("east", "living_room_1", "west", "kitchen_0")
    assert here.position == there.position == 1.55
    assert answer.scene.adjacency == ((0, 1),)
    assert [room.exterior_walls and room.exterior_walls.east for room in answer.scene.rooms] == [False, True]


def test_a_main_entrance_is_chosen_and_told() -> None:
    answer = read(collection(*TWO, line("door", (1, 0), (1.9, 0)), line("door", (5, 0), (5.9, 0))))
    assert opening(answer.scene.rooms[1], "door_1").main_entrance and not opening(answer.scene.rooms[0], "door_0").main_entrance
    assert [(guess["of"], guess["what"]) for guess in answer.guesses if guess["what"] == "main_entrance"] == [("door_1", "main_entrance")]


@pytest.mark.parametrize(("unit", "metres"), [("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("in", 0.0254), ("ft", 0.3048)])
def test_the_unit_is_told_by_the_doors(unit: str, metres: float) -> None:
    def grown(value: Any) -> Any:
        if isinstance(value, list):
            return [grown(one) for one in value]
        return value / metres if isinstance(value, float | int) else value

    plan = collection(*TWO, line("door", (4, 1), (4, 1.9)))
    plan["features"] = [
        {**one, "geometry": {**one["geometry"], "coordinates": grown(one["geometry"]["coordinates"])}} for one in plan["features"]
    ]
    del plan["unit"]
    answer = read(plan)
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.0, 3.0), (5.0, 3.0)]
    assert [guess["taken"] for guess in answer.guesses if guess["what"] == "unit"] == [unit]


def test_a_unit_that_nobody_tells_is_asked_for() -> None:
    plan = collection(*TWO, line("door", (4, 1), (4, 1.2)))
    del plan["unit"]
    with pytest.raises(FieldError, match="cannot be told") as caught:
        read(plan)
    assert caught.value.field == "unit"
    assert read(plan, unit="4").scene.rooms[0].width == 16.0


def test_crooked_walls_are_straightened_together_and_told() -> None:
    plan = collection(polygon("Kitchen", (0, 0.008), (4.004, 0), (4.012, 3), (0, 3.01)), box("Living room", 4, 0, 9, 3))
    answer = read(plan)
    kitchen, living = answer.scene.rooms
    assert kitchen.outline is None and living.outline is None
    assert kitchen.x + kitchen.width == living.x and kitchen.depth == living.depth
    told = {change["of"]: float(str(change["amount"])) for change in answer.changes if change["step"] == "straighten"}
    assert 0.004 <= told["kitchen_0"] <= 0.02


@pytest.mark.parametrize("degrees", [7.0, -30.0, 44.0])
def test_a_plan_at_an_angle_is_turned(degrees: float) -> None:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    plan = collection(*TWO, line("door", (4, 1), (4, 1.9)), piece("Table", 2, 1.5, width=1.2, depth=0.7, height=0.75))
    for one in plan["features"]:
        shape = one["geometry"]
        deep = {"Polygon": shape["coordinates"][0], "LineString": shape["coordinates"], "Point": [shape["coordinates"]]}[shape["type"]]
        turned = [[x * c - y * s + 500, x * s + y * c - 900] for x, y in deep]
        shape["coordinates"] = {"Polygon": [turned], "LineString": turned, "Point": turned[0]}[shape["type"]]
    answer = read(plan)
    sizes = [sorted((room.width, room.depth)) for room in answer.scene.rooms]
    assert [[round(size, 2) for size in sorted_sizes] for sorted_sizes in sizes] == [[3.0, 4.0], [3.0, 5.0]]
    assert [len(room.openings) for room in answer.scene.rooms] == [1, 1]
    assert "turned by" in next(str(change["message"]) for change in answer.changes if change["of"] == "plan")


def test_a_slanted_room_is_taken_as_the_steps_inside_it() -> None:
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 4.0), (0.0, 4.0)]
    answer = read(collection(polygon("Office", *corners, drawn="lines"), y="down"))
    (room,) = answer.scene.rooms
    assert room.outline is not None
    assert all(x <= 4.0 and z <= 4.0 and x + 2 * z <= 10.0 + 1e-9 for x, z in room.outline)
    assert 0 < floor_area(corners) - floor_area(room.outline) < 0.1 * math.hypot(2, 1)
    assert any("steps" in str(change["message"]) and change["of"] == room.id for change in answer.changes)


def test_the_front_of_a_bay_keeps_its_window_and_its_floor() -> None:
    """The steps before its slanted walls are no window's reveal."""
    bay = polygon("Living room", (0, 0), (6, 0), (6, 4), (4.4, 4), (3.8, 4.6), (2.2, 4.6), (1.6, 4), (0, 4))
    (room,) = read(collection(bay, line("window", (2.3, 4.6), (3.7, 4.6)), unit="m")).scene.rooms
    assert (room.depth, [one.width for one in room.openings]) == (4.6, [1.4])


def test_a_round_wall_is_taken_as_steps_too() -> None:
    arc = [(2 + 2 * math.cos(math.radians(at)), 3 + 2 * math.sin(math.radians(at))) for at in range(0, 181, 5)]
    answer = read(collection(polygon("Living room", (0, 0), (4, 0), *arc), y="down"))
    (room,) = answer.scene.rooms
    assert room.outline is not None
    assert all(z <= 3.0 + 1e-9 or math.hypot(x - 2, z - 3) <= 2.01 for x, z in room.outline)
    assert floor_area(room.outline) > 12 + math.pi * 2 - 0.1 * math.pi * 2 * 1.3


def test_rooms_drawn_by_their_inner_faces_are_grown_to_wall_lines() -> None:
    rooms = (box("Kitchen", 0.2, 0.2, 4, 3), box("Living room", 4.16, 0.2, 9, 3), box("Office", 0.2, 3.16, 9, 6))
    doors = (line("door", (4.08, 1), (4.08, 1.9)), line("door", (1, 3.08), (1.9, 3.08)))
    answer = read(collection(*rooms, *doors, drawn="inner", y="down"))
    kitchen, living, office = answer.scene.rooms
    assert answer.scene.wall_thickness == 0.16
    assert (kitchen.x, kitchen.width, living.x, office.z, kitchen.depth) == (0.0, 3.96, 3.96, 2.96, 2.96)
    assert {one.connects_to for one in kitchen.openings} == {"living_room_1", "office_2"}
    assert any(change["step"] == "wall_lines" and change["of"] == "plan" for change in answer.changes)


def test_an_opening_without_a_wall_is_left_out_with_its_place() -> None:
    answer = read(collection(*TWO, line("door", (4, 1), (4, 1.9)), line("window", (2, 1.2), (3, 1.2))))
    assert [left["place"] for left in answer.unread] == ["features[3]"]
    assert "1.20 m away" in answer.unread[0]["reason"]


def test_an_opening_that_leaves_its_wall_is_moved_into_it_and_told() -> None:
    answer = read(collection(*TWO, line("door", (-0.1, 0), (0.8, 0))))
    assert opening(answer.scene.rooms[0], "door_0").position == 0.45
    assert [(change["of"], change["amount"]) for change in answer.changes] == [("features[2]", 0.1)]


def test_furniture_comes_along_repaired_or_is_left_out() -> None:
    bed = piece("Lit double", 0.5, 1.5, width=1.6, depth=2.0, height=0.5, rotation=90)
    room = box("Bedroom", 0, 0, 4, 3.5)
    answer = read(collection(room, bed, line("door", (3, 0), (3.9, 0))))
    (stands,) = answer.scene.rooms[0].furniture
    assert (stands.name, answer.understood_as[stands.id]) == ("Lit double", "bed")
    assert [issue.rule for issue in answer.issues if issue.severity == "error"] == []
    assert [change["step"] for change in answer.changes] == ["furniture"]
    assert "as it is drawn, bedroom_0/lit_double_1 leaves the clear floor" in str(answer.changes[0]["message"])
    assert "turned" not in str(answer.changes[0]["message"])
    assert read(collection(room, bed), furniture=False).scene.rooms[0].furniture == ()


def test_a_decoration_that_is_moved_is_told_like_furniture() -> None:
    plant = piece("Plant", 3.4, 0.4, width=0.2, depth=0.2, height=0.3)
    bed = piece("Lit double", 2.0, 2.4, width=1.6, depth=2.0, height=0.5)
    answer = read(collection(box("Bedroom", 0, 0, 4, 3.5), bed, plant, line("door", (3, 0), (3.9, 0))))
    (stands,) = answer.scene.rooms[0].decorations
    assert [issue.rule for issue in answer.issues if issue.severity == "error"] == []
    assert [str(change["message"]).split(":")[1] for change in answer.changes if change["of"] == stands.id] == [
        f" as it is drawn, {stands.id} stands 20 cm in the way of the door door_0 in bedroom_0"
    ]


def test_of_several_levels_the_lowest_is_taken_and_the_others_are_named() -> None:
    plan = collection(box("Kitchen", 0, 0, 4, 3, level=1), box("Bedroom", 0, 0, 5, 3, level=2))
    assert [room.type for room in read(plan).scene.rooms] == ["kitchen"]
    assert [left["place"] for left in read(plan).unread] == ["level 2"]
    assert [room.type for room in read(plan, level=2).scene.rooms] == ["bedroom"]
    with pytest.raises(FieldError, match="has no rooms"):
        read(plan, level=0)


def test_the_same_file_makes_the_same_bytes() -> None:
    first, second = (dump_plain(write_scene(read(HOME.read_bytes()).scene), "json") for _ in range(2))
    assert first == second


def test_one_bad_room_does_not_cost_the_home() -> None:
    bow_tie = polygon("Bedroom", (0, 3), (4, 6), (4, 3), (0, 6))
    sliver = box("Office", 20, 0, 20.1, 3)
    answer = read(collection(*TWO, bow_tie, sliver))
    assert [room.type for room in answer.scene.rooms] == ["kitchen", "living_room", "bedroom"]
    assert [left["place"] for left in answer.unread] == ["features[3]"]


def test_a_document_may_be_given_instead_of_a_file() -> None:
    document = json.loads(HOME.read_text())
    assert write_scene(read(document).scene) == write_scene(read(HOME.read_bytes()).scene)
