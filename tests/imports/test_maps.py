"""GeoJSON of the indoors as maps have it: IMDF's features, OpenStreetMap's tags, doors that are points."""

from __future__ import annotations

import pytest

from solver.answers import PlanImport
from tests.imports.plans import Feature, box, collection, line, piece, read


def imdf(called: str, feature: Feature, **said: object) -> Feature:
    return {**feature, "feature_type": called, "properties": {"name": None, **feature["properties"], **said}}


def by_name(answer: PlanImport) -> dict[str, list[tuple[str, float, float | None]]]:
    return {room.type: [(one.kind, one.width, one.position) for one in room.openings] for room in answer.scene.rooms}


def test_units_and_openings_of_imdf_are_a_home_and_what_lies_around_them_is_named() -> None:
    kitchen = imdf("unit", box("", 0, 0, 4, 3), category="kitchen", level_id="up")
    other = imdf("unit", box("", 4, 0, 9, 3), category="room", level_id="up", name={"en": "Living Room"})
    door = imdf("opening", {**line("", (4, 1), (4, 1.9)), "properties": {}}, category="pedestrian", level_id="up")
    below = imdf("unit", box("", 0, 0, 4, 3), category="storage", level_id="down")
    levels = [{**imdf("level", box("", 0, 0, 9, 3), ordinal=number), "id": key} for key, number in (("up", 1), ("down", 0))]
    around = imdf("footprint", box("", -1, -1, 10, 4), category="aerial")
    answer = read(collection(kitchen, other, door, below, *levels, around, wall_thickness=0.1), level=1)
    assert by_name(answer) == {"kitchen": [("door", 0.9, 1.55)], "living_room": [("door", 0.9, 1.55)]}
    assert [{room.level for room in answer.scene.rooms}, {level.index for level in answer.scene.levels}] == [{1}, {1}]
    places = [one["place"] for one in answer.unread if "of maps units and openings are read" in one["reason"]]
    assert places == ["features[4]", "features[5]", "features[6]"]


@pytest.mark.parametrize(("width", "wide"), [({}, 0.9), ({"width": "0.8"}, 0.8), ({"width": 1.2}, 1.2), ({"width": "1.1 m"}, 1.1)])
def test_rooms_and_doors_of_openstreetmap_are_a_home(width: dict[str, object], wide: float) -> None:
    """A door is a point of a wall, 20 cm off it here; the way to it and the storey as a whole are none of these."""
    tags = {"indoor": "room", "level": "0;1"}
    hall = box("", 0, 3, 9, 5, indoor="corridor", level="0")
    door = {**piece("", 2, 3.2), "properties": {"door": "hinged", "level": "0", **width}}
    way = {**line("", (2, 3), (2, 4)), "properties": {"highway": "corridor", "level": "0"}}
    storey = box("", 0, 0, 9, 5, indoor="level", level="0")
    answer = read(
        collection(
            box("Küche", 0, 0, 4, 3, **tags), box("", 4, 0, 9, 3, room="bedroom", **tags), hall, door, way, storey, wall_thickness=0.1
        )
    )
    found = by_name(answer)
    assert list(found) == ["kitchen", "bedroom", "hallway"]
    assert (found["kitchen"], found["bedroom"]) == ([("door", wide, 2.0)], [])
    assert [one["place"] for one in answer.unread] == ["features[4]", "features[5]"]


def test_windows_of_openstreetmap_are_points_too_and_what_has_none_says_no() -> None:
    window = {**piece("", 2, 0.1), "properties": {"window": "yes", "level": "0", "width": "1.4"}}
    none = {**piece("", 3, 0.1), "properties": {"window": "no", "name": "Table", "width": 0.6, "depth": 0.6, "height": 0.7}}
    answer = read(collection(box("Küche", 0, 0, 4, 3), window, none, wall_thickness=0.1))
    assert by_name(answer) == {"kitchen": [("window", 1.4, 2.0)]}
    assert [one.name for one in answer.scene.rooms[0].furniture] == ["Table"]


def test_what_maps_draw_around_rooms_is_none_of_them() -> None:
    """A building's outline, and walls as lines: these were a room over all others, and doors."""
    house = {**box("", 0, 0, 8, 3), "properties": {"building": "house", "building:levels": "2"}}
    wall = {**line("", (0, 0), (8, 0)), "properties": {"indoor": "wall", "level": "0"}}
    rooms = [box(name, x, 0, x + 4, 3, indoor="room", building="A") for name, x in (("Kitchen", 0), ("Bedroom", 4))]
    answer = read(collection(*rooms, house, wall, wall_thickness=0.1))
    assert by_name(answer) == {"kitchen": [], "bedroom": []}
    assert [one["place"] for one in answer.unread] == ["features[2]", "features[3]"]


@pytest.mark.parametrize(("entrance", "is_main"), [("main", True), ("yes", False), ("no", None)])
def test_an_entrance_of_openstreetmap_is_a_door_to_come_in_by(entrance: str, is_main: bool | None) -> None:
    points = [{**piece("", x, 0), "properties": {"entrance": said}} for x, said in ((2, entrance), (6, "home"))]
    answer = read(collection(box("Kitchen", 0, 0, 8, 3), *points[: 1 if is_main else 2], wall_thickness=0.1))
    doors = [one.main_entrance for one in answer.scene.rooms[0].openings]
    assert doors == [one for one in (is_main, True if not is_main else None) if one is not None]


@pytest.mark.parametrize(("key", "number"), [("floor", 1), ("storey", "1"), ("VERTICAL_ORDER", 1), ("level", "1;2")])
def test_storeys_are_numbered_under_several_words(key: str, number: object) -> None:
    document = collection(box("Kitchen", 0, 0, 4, 3, **{key: 0}), box("Bedroom", 0, 0, 4, 3, **{key: number}, LEVEL_ID="H.L2"))
    assert list(by_name(read(document))) == ["kitchen"]
    assert list(by_name(read(document, level=1))) == ["bedroom"]


def test_openings_of_imdf_tell_the_garage_door_and_the_main_entrance() -> None:
    ends = {"automobile": ((1, 0), (3.4, 0)), "pedestrian": ((4, 1), (4, 1.9)), "pedestrian.principal": ((0, 1), (0, 1.9))}
    drawn = [imdf("opening", {**line("", *two), "properties": {}}, category=key) for key, two in ends.items()]
    units = [imdf("unit", box(name, x, 0, x + 4, 3), category="room") for name, x in (("Garage", 0), ("Hall", 4))]
    answer = read(collection(*units, *drawn, wall_thickness=0.1))
    found = {(one.kind, one.main_entrance) for room in answer.scene.rooms for one in room.openings}
    assert found == {("garage_door", False), ("door", False), ("door", True)}


def test_a_door_that_is_a_point_needs_a_unit() -> None:
    document = collection(box("Kitchen", 0, 0, 4, 3), {**piece("", 2, 0), "properties": {"door": "yes"}})
    del document["unit"]
    answer = read(document)
    assert answer.scene.rooms[0].openings == ()
    assert {"place": "features[1]", "reason": "a door that is a point: `unit`, or a line along its wall"} in answer.unread
