"""DXF that draws walls as areas or multiple lines, and rooms or walls as loose lines: each gives the home that outlines would."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ezdxf.filemanagement as files
import pytest

from solver.answers import PlanImport
from solver.errors import FieldError
from tests.imports.plans import imported

Box = tuple[float, float, float, float]
WALLS: tuple[Box, ...] = (
    (0, 0, 8200, 100), (0, 3000, 8200, 3100), (0, 100, 100, 3000), (8100, 100, 8200, 3000), (4050, 100, 4150, 1000),
    (4050, 1900, 4150, 3000),
)  # fmt: skip
"""Around two rooms of 3.95 x 2.9 m, with a gap for a door between; mm."""


def corners(box: Box) -> list[tuple[float, float]]:
    x0, y0, x1, y1 = box
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def plan() -> Any:
    made: Any = files.new()
    made.header["$INSUNITS"] = 4
    made.modelspace().add_line((4100, 1000), (4100, 1900), dxfattribs={"layer": "DOORS"})
    return made


def hatches(space: Any, layer: str = "WALLS") -> None:
    for wall in WALLS:
        space.add_hatch(dxfattribs={"layer": layer}).paths.add_polyline_path(corners(wall), is_closed=True)


def one_hatch_of_edges(space: Any) -> None:
    paths = space.add_hatch(dxfattribs={"layer": "WALLS"}).paths
    for wall in WALLS:
        spots, edges = corners(wall), paths.add_edge_path()
        for a, b in zip(spots, [*spots[1:], *spots[:1]], strict=True):
            edges.add_line(a, b)


def solids(space: Any) -> None:
    for wall in WALLS:
        a, b, c, d = corners(wall)
        space.add_solid([a, b, d, c], dxfattribs={"layer": "WALLS"})


def loose(space: Any, layer: str, *boxes: Box) -> None:
    for box in boxes:
        spots = corners(box)
        for a, b in zip(spots, [*spots[1:], *spots[:1]], strict=True):
            space.add_line(a, b, dxfattribs={"layer": layer})


def with_outlines(space: Any) -> None:
    hatches(space)
    loose(space, "WALLS", *WALLS)


DRAWN: dict[str, Callable[[Any], None]] = {
    "hatches": hatches,
    "hatches on a layer of hatches": lambda space: hatches(space, "A-WALL-HATCH"),
    "one hatch of edges": one_hatch_of_edges,
    "solids": solids,
    "hatches in their outlines": with_outlines,
    "loose lines of rooms": lambda space: loose(space, "ROOMS", (100, 100, 4050, 3000), (4150, 100, 8100, 3000)),
}


@pytest.mark.parametrize("name", DRAWN)
def test_two_rooms_and_their_door_are_read(name: str) -> None:
    made = plan()
    DRAWN[name](made.modelspace())
    answer = imported(made)
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.05, 3.0)] * 2
    assert answer.scene.wall_thickness == 0.1 and list(answer.unread) == []
    assert [len(room.openings) for room in answer.scene.rooms] == [1, 1]


def test_walls_of_multiple_lines_are_read() -> None:
    made = plan()
    style = {"layer": "WALLS", "scale_factor": 100, "justification": 1}
    made.modelspace().add_mline([(50, 50), (8150, 50), (8150, 3050), (50, 3050)], close=True, dxfattribs=style)
    made.modelspace().add_mline([(4100, 50), (4100, 3050)], dxfattribs=style)
    rooms = imported(made).scene.rooms
    assert len(rooms) == 2 and all(room.width == pytest.approx(4.05, abs=0.02) for room in rooms)


def test_rooms_whose_lines_are_shared_lie_along_them() -> None:
    made = plan()
    loose(made.modelspace(), "ROOMS", (100, 0, 8100, 3000))
    made.modelspace().add_line((4100, 0), (4100, 3000), dxfattribs={"layer": "ROOMS"})
    first, second = imported(made).scene.rooms
    assert (first.width, second.width, second.x) == (4.0, 4.0, 4.0)
    assert first.openings[0].connects_to == second.id


OPEN = [(0, 3100), (0, 3000), (4000, 3000), (4000, 2000), (6000, 2000), (6000, 5000), (0, 5000), (0, 4000)]
"""A hallway around a corner, open where a door is, 0.9 m; mm."""


def beside_a_closed_room(closing: str | None) -> PlanImport:
    made = plan()
    space = made.modelspace()
    space.add_lwpolyline(corners((100, 0, 4000, 2900)), close=True, dxfattribs={"layer": "ROOMS"})
    space.add_lwpolyline(OPEN, dxfattribs={"layer": "ROOMS"})
    space.add_text("Hallway", dxfattribs={"layer": "NAMES", "insert": (5000, 4000)})
    if closing:
        space.add_line(OPEN[-1], OPEN[0], dxfattribs={"layer": closing})
    return imported(made)


@pytest.mark.parametrize("closing", ["ROOMS", "DOORS"])
def test_an_open_outline_that_a_line_or_a_door_closes_is_a_room_beside_closed_ones(closing: str) -> None:
    answer = beside_a_closed_room(closing)
    assert [room.type for room in answer.scene.rooms] == ["room", "hallway"]
    hallway = answer.scene.rooms[1]
    assert (round(hallway.width), round(hallway.depth)) == (6, 3) and hallway.outline is not None
    assert not [one for one in answer.unread if "open outlines" in one["reason"]]


def test_an_outline_of_a_room_that_stays_open_is_told() -> None:
    answer = beside_a_closed_room(None)
    assert len(answer.scene.rooms) == 1
    assert [(one["place"], one["reason"]) for one in answer.unread] == [
        ("layer 'ROOMS'", "1 open outlines of rooms, which enclose none"),
        ("text 'Hallway'", "names a room, but stands in none: nothing encloses it"),
    ]


def test_an_outline_that_is_drawn_closed_and_once_more_as_lines_is_one_room() -> None:
    made = plan()
    made.modelspace().add_lwpolyline(corners((100, 0, 4000, 2900)), close=True, dxfattribs={"layer": "ROOMS"})
    loose(made.modelspace(), "ROOMS", (100, 0, 4000, 2900), (4100, 0, 8000, 2900))
    answer = imported(made)
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.0, 3.0)] * 2
    assert list(answer.unread) == []


def test_a_drawing_without_rooms_is_told_the_layers_with_most_on_them() -> None:
    made: Any = files.new()
    for count in range(1, 11):
        for _ in range(count):
            made.modelspace().add_line((0, 0), (count, 5), dxfattribs={"layer": f"L{count}"})
    with pytest.raises(FieldError) as refused:
        imported(made)
    named = ", ".join(f"'L{count}'" for count in range(10, 2, -1))
    assert f"are none in this file, whose layers are {named}, ..." in str(refused.value)


def test_loose_lines_of_walls_tell_how_thick_outer_walls_are_around_drawn_rooms() -> None:
    made = plan()
    inner = (200, 200, 4050, 3000), (4150, 200, 8000, 3000)
    for box in inner:
        made.modelspace().add_lwpolyline(corners(box), close=True, dxfattribs={"layer": "ROOMS"})
    loose(made.modelspace(), "WALLS", *inner, (0, 0, 8200, 3200))
    scene = imported(made).scene
    assert scene.wall_thickness == 0.1
    assert [room.wall_thickness for room in scene.rooms] == [(0.2, None, 0.2, 0.2), (0.2, 0.2, 0.2, None)]


def in_one_layer_of_openings(space: Any, by: float) -> None:
    """Walls as loose lines, the door as a leaf with its arc on a layer that holds all openings."""
    loose(space, "A-WALL", *((x0 * by, y0 * by, x1 * by, y1 * by) for x0, y0, x1, y1 in WALLS))
    leaf = {"layer": "A-OPENING"}
    space.add_line((4100 * by, 1000 * by), (5000 * by, 1000 * by), dxfattribs=leaf)
    space.add_arc((4100 * by, 1000 * by), 900 * by, 0, 90, dxfattribs=leaf)


def test_an_arc_among_openings_is_the_way_of_a_doors_leaf() -> None:
    made: Any = files.new()
    made.header["$INSUNITS"] = 4
    in_one_layer_of_openings(made.modelspace(), 1.0)
    first, second = imported(made).scene.rooms
    assert [(one.kind, one.width, one.connects_to, one.hinge) for one in first.openings] == [("door", 0.9, second.id, "end")]


def test_rooms_are_looked_for_in_the_unit_that_doors_tell_where_the_file_says_a_wrong_one() -> None:
    made: Any = files.new()
    made.header["$INSUNITS"] = 4
    in_one_layer_of_openings(made.modelspace(), 1 / 25.4)
    answer = imported(made)
    assert [(guess["what"], guess["taken"]) for guess in answer.guesses if guess["what"] == "unit"] == [("unit", "in")]
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.05, 3.0)] * 2
