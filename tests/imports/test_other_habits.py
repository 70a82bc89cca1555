"""GeoJSON and SVG as other programmes write them: several geometries in one, none, degrees; texts of lines, symbols, escaped names."""

from __future__ import annotations

import math

import pytest

from solver.errors import FieldError
from solver.scene import Room
from tests.imports.plans import Feature, box, collection, line, opening, piece, read, rooms_of

HOME = (box("Kitchen", 0, 0, 4, 3), box("Bedroom", 4, 0, 8, 3), line("door", (4, 1), (4, 1.9)), line("door", (1, 0), (1.9, 0)))


def gathered(*features: Feature) -> list[Feature]:
    """The same as geographic information systems write it: each geometry in one of several."""
    return [
        {**one, "geometry": {"type": f"Multi{one['geometry']['type']}", "coordinates": [one["geometry"]["coordinates"]]}}
        for one in features
    ]


def sizes_of(room: Room) -> list[float]:
    return [room.width, room.depth, *(size for one in room.openings for size in (one.position, one.width))]


def test_geometries_of_one_are_that_one() -> None:
    things = (*HOME, piece("Bed", 6, 1.5, width=1.4, depth=2.0, height=0.5, id="bed"))
    plain, many = (read(collection(*features, wall_thickness=0.1), furniture="keep") for features in (things, gathered(*things)))
    assert many.scene == plain.scene


def test_each_of_several_is_one_of_its_own() -> None:
    both = {"properties": {"name": "Bedroom", "id": "b"}, "geometry": {"type": "MultiPolygon", "coordinates": []}}
    both["geometry"]["coordinates"] = [one["geometry"]["coordinates"] for one in HOME[:2]]  # type: ignore[index]
    rooms = rooms_of(read(collection(both, *HOME[2:])))
    assert list(rooms) == ["b", "b_1"]
    assert [room.type for room in rooms.values()] == ["bedroom", "bedroom"]


def test_what_has_no_geometry_is_named() -> None:
    answer = read(collection(*HOME, {"properties": {"name": "Lost"}, "geometry": None}))
    assert {"place": "features[4]", "reason": "it has no geometry"} in answer.unread
    assert len(answer.scene.rooms) == 2


@pytest.mark.parametrize(("east", "north"), [(13.4, 52.5), (-70.6, -33.4), (0.0, 0.0), (151.2, 68.9)])
def test_degrees_are_told_and_taken_to_metres(east: float, north: float) -> None:
    """Degrees are those of the ellipsoid that satellites know."""
    slope, bulge = math.radians(north), 1 - 0.00669438 * math.sin(math.radians(north)) ** 2
    wide, long = 6_378_137 * math.cos(slope) / bulge**0.5, 6_378_137 * (1 - 0.00669438) / bulge**1.5

    def at(x: float, y: float) -> tuple[float, float]:
        return east + math.degrees(x / wide), north + math.degrees(y / long)

    def moved(given: object) -> object:
        pair = isinstance(given, list) and isinstance(given[0], (int, float))
        return list(at(*given)) if pair and isinstance(given, list) else [moved(one) for one in given]  # type: ignore[attr-defined]

    document = collection(*HOME, wall_thickness=0.1)
    plain = read(document)
    del document["unit"]
    for feature in document["features"]:
        feature["geometry"]["coordinates"] = moved(feature["geometry"]["coordinates"])
    answer = read(document)
    for found, wanted in zip(answer.scene.rooms, plain.scene.rooms, strict=True):
        assert found.type == wanted.type
        assert sizes_of(found) == pytest.approx(sizes_of(wanted), abs=0.002)
        assert [(one.kind, one.wall) for one in found.openings] == [(one.kind, one.wall) for one in wanted.openings]
    assert any("degrees of longitude" in str(guess["message"]) for guess in answer.guesses if guess["what"] == "unit")


def test_a_home_that_says_a_unit_is_not_in_degrees() -> None:
    with pytest.raises(FieldError, match="wide in all"):
        read(collection(box("Kitchen", 0, 0, 0.004, 0.003)))


def svg(inside: str) -> bytes:
    head = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" data-unit="cm" viewBox="0 0 800 300">'
    return f"{head}{inside}</svg>".encode()


ROOM = "<rect class='room' width='400' height='300'/>"
DOOR = "<line class='door' x1='100' x2='190' y1='0' y2='0'/>"
TEXTS = {
    "lines": ("<text x='100' y='100'><tspan x='100' y='100'>Living</tspan><tspan x='100' y='120'>room</tspan></text>", "Living room"),
    "a line of numbers": ("<text x='100' y='100'>Bad<tspan x='100' dy='12'>12 m²</tspan></text>", "Bad"),
    "what the floor is of": (
        "<text x='9' y='9'>Master<tspan dy='12'>Bedroom</tspan><tspan dy='12'>12 m²</tspan><tspan dy='12'>Oak</tspan></text>",
        "Master Bedroom",
    ),
    "an area first": ("<text x='100' y='100'>Fläche 12 m²<tspan x='100' dy='12'>Küche</tspan></text>", "Küche"),
    "numbers first": ("<text x='100' y='100'>12.5<tspan x='100' dy='12'>Kitchen</tspan></text>", "Kitchen"),
    "a word in bold": ("<text x='100' y='100'>Kit<tspan font-weight='bold'>chen</tspan></text>", "Kitchen"),
    "white space": ("<text x='100' y='100'>\n  Dining\n  room\n</text>", "Dining room"),
}


@pytest.mark.parametrize("name", TEXTS)
def test_lines_of_a_text_are_words_of_a_name(name: str) -> None:
    text, called = TEXTS[name]
    (room,) = read(svg(ROOM + DOOR + text), "plan.svg").scene.rooms
    assert room.name == called


def test_a_symbol_tells_what_it_is_where_its_use_does_not() -> None:
    symbols = "<defs><symbol id='door'><line x2='90'/></symbol><g id='window'><line x2='120'/></g></defs>"
    used = "<use xlink:href='#door' x='100'/><use xlink:href='#window' x='200' y='300'/><use class='window' href='#door' x='20' y='300'/>"
    (room,) = read(svg(f"{symbols}{ROOM}{used}"), "plan.svg").scene.rooms
    found = sorted((one.kind, one.wall, one.width) for one in room.openings)
    assert found == [("door", "north", 0.9), ("window", "south", 0.9), ("window", "south", 1.2)]
    assert opening(room, "door_0").position == 1.45


def test_escaped_names_are_names() -> None:
    layers = "<g id='Rooms_x20_1'><rect id='Living_x20_Room' width='400' height='300'/></g>" + DOOR
    (room,) = read(svg(layers), "plan.svg").scene.rooms
    assert (room.type, room.name) == ("living_room", "Living Room")


@pytest.mark.parametrize("wide", [1.345, 1.344])
@pytest.mark.parametrize("west", [0.0, 0.0005])
def test_an_opening_as_wide_as_its_wall_lies_in_it_whatever_the_width(wide: float, west: float) -> None:
    rooms = [box("Kitchen", west, 0, west + wide, 3), box("Living room", west, 3, west + wide, 6)]
    answer = read(collection(*rooms, line("passage", (west, 3), (west + wide, 3)), line("door", (west, 6), (west + wide, 6))))
    assert [issue.message for issue in answer.issues if issue.rule == "opening_wrong"] == []
    assert {one.width for room in answer.scene.rooms for one in room.openings} == {wide}
