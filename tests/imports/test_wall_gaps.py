"""Gaps in walls: doors that are drawn as leaves without an arc, as parts of outlines, or not at all."""

from __future__ import annotations

from math import dist, pi, tan
from typing import Any

import ezdxf.filemanagement as files
import pytest

from solver.answers import PlanImport
from solver.imports.drawn import DrawnOpening, Spot
from solver.imports.shape_openings import DrawnSwing, doors_of_swings
from solver.imports.wall_gaps import WallGap, fitted, gaps_of
from solver.scene import Opening
from tests.imports.plans import imported, read

OUTER = ((0, 0, 9000, 6000), (300, 300, 8700, 5700))
"""The faces of the outer walls. Inside a hallway 1.5 m wide lies between two rooms; a wall of 0.1 m on either side of it."""
NAMES = {"Küche": (1500, 3000), "Flur": (4500, 3000), "Bad": (7000, 3000)}
DOORS = {"Küche": (3700, 2000, 2885), "Bad": (5300, 3000, 3760)}
"""Where the west faces of the hallway's walls are, and from where to where each door goes."""


def drawing(names: dict[str, tuple[int, int]] | None = None) -> Any:
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    for x0, y0, x1, y1 in OUTER:
        space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": "Mauerwerk"})
    for x, low, high in DOORS.values():
        for y0, y1 in ((300, low), (high, 5700)):
            space.add_lwpolyline([(x, y0), (x + 100, y0), (x + 100, y1), (x, y1)], close=True, dxfattribs={"layer": "Mauerwerk"})
    for words, spot in (NAMES if names is None else names).items():
        space.add_text(words, height=150).set_placement(spot)
    return made


def doors(answer: PlanImport) -> list[Opening]:
    return [one for room in answer.scene.rooms if room.type != "hallway" for one in room.openings]


def test_gaps_in_which_nothing_is_drawn_are_passages_between_rooms_of_two_names() -> None:
    answer = imported(drawing())
    assert [(one.kind, one.width) for one in doors(answer)] == [("passage", 0.885), ("passage", 0.76)]
    assert [one["reason"] for one in answer.unread] == ["gaps in which nothing is drawn are taken as passages: 2"]


@pytest.mark.parametrize("names", [{}, {"Wohnen": (4500, 3000)}, {"Flur": (1500, 3000), "Hallway": (4500, 4000)}])
def test_gaps_part_no_room_of_one_name_or_of_none(names: dict[str, tuple[int, int]]) -> None:
    (room,) = imported(drawing(names)).scene.rooms
    assert room.outline is not None
    assert not room.openings


def test_a_wall_that_ends_before_another_across_a_hallway_parts_it_not() -> None:
    """The hallway has one name, and a wall of the bathroom's side ends 1.4 m before the kitchen's."""
    made = drawing()
    made.modelspace().add_lwpolyline(
        [(5300, 3000), (5300, 2950), (5200, 2950), (5200, 3000)], close=True, dxfattribs={"layer": "Mauerwerk"}
    )
    assert len(imported(made).scene.rooms) == 3


def leaf(made: Any, how: str) -> None:
    """Draws each door's leaf, that hangs at its gap's south end and opens into the room, on a layer of doors."""
    space, told = made.modelspace(), {"layer": "Türen"}
    for name, (x, low, high) in DOORS.items():
        wide, (way, face) = high - low, (-1, x) if name == "Küche" else (1, x + 100)
        tip = {"open": (face + way * wide, low), "half": (face + way * wide * 2**-0.5, low + wide * 2**-0.5)}.get(how, (0, 0))
        bulge = way * tan(pi / 8)
        if how in ("open", "half"):
            space.add_line((face, low), tip, dxfattribs=told)
        elif how == "board":
            corners = [(face, low), (face + way * wide, low), (face + way * wide, low + 40), (face, low + 40)]
            space.add_lwpolyline(corners, close=True, dxfattribs=told)
        elif how == "outline":
            ends = [(face, low, 0), (face + way * wide, low, bulge), (face, high, 0)]
            space.add_lwpolyline(ends, format="xyb", close=True, dxfattribs=told)
        else:
            space.add_ellipse((face, low), (wide, 0), 0.98, *((0, pi / 2) if way > 0 else (pi / 2, pi)), dxfattribs=told)


@pytest.mark.parametrize("how", ["open", "half", "board", "outline", "ellipse"])
def test_a_leaf_without_an_arc_of_its_own_hangs_in_its_gap(how: str) -> None:
    made = drawing()
    leaf(made, how)
    found = doors(imported(made))
    assert [(one.kind, one.width) for one in found] == [("door", 0.885), ("door", 0.76)]
    assert [(one.hinge, one.swing) for one in found] == [("end", "in")] * 2


def test_a_leaf_that_lies_before_another_gap_hangs_in_its_own() -> None:
    """It is 0.2 m before a wall across the way, in which there is a gap as wide right there."""
    gaps = [WallGap((0, 100), (0, 1000), 100, in_line=True), WallGap((200, 0), (1100, 0), 100, in_line=True)]
    (door,), _, left = fitted([DrawnOpening("door", (200, 50), (200, 950), "here")], gaps, 0.001)
    assert ((door.start, door.end, door.hinge), left) == (((200, 0), (1100, 0), "start"), gaps[:1])


def test_two_leaves_that_meet_are_shut_where_they_meet_whatever_is_beside_them() -> None:
    """They open against the walls beside them, which are nearer than the walls beside the middle of the door."""
    made = drawing()
    space = made.modelspace()
    for middle, ends in ((3900, (0, 90)), (5200, (90, 180))):
        space.add_arc((middle, 300), 650, *ends, dxfattribs={"layer": "Türen"})
    found = [one for room in imported(made).scene.rooms for one in room.openings if one.main_entrance]
    assert [(one.wall, one.width) for one in found] == [("south", 1.3)]


@pytest.mark.parametrize(("hinge", "shut", "widths"), [
    ((1750, 0), (850, 0), [1750]),  # as leaves drawn 5 cm over one another
    ((1890, 0), (990, 0), [900, 900]),  # 9 cm apart
    ((900, 900), (900, 0), [900, 900]),  # hung around the corner
])  # fmt: skip
def test_two_leaves_that_meet_are_one_door_where_they_hang_opposite(hinge: Spot, shut: Spot, widths: list[int]) -> None:
    first = DrawnSwing((0, 0), ((900, 0), (0, 900)), "here")
    other = DrawnSwing(hinge, (shut, (hinge[0] + hinge[1], 900 - hinge[1])), "there")
    walls = [[(-500, 0), (0, 0)], [(2500, 0), (900, 0), (900, 2000)]]
    assert [dist(one.start, one.end) for one in doors_of_swings([first, other], walls)] == widths


LAYERS = ("MUR", "Duvar", "Zdi", "Väggar", "Vegger", "墙", "外壁", "Стены", "Parede")


@pytest.mark.parametrize("layer", LAYERS)
def test_walls_are_told_in_many_languages(layer: str) -> None:
    made = drawing()
    for one in made.modelspace().query("LWPOLYLINE"):
        one.dxf.layer = layer
    assert len(imported(made).scene.rooms) == 3


def test_a_wide_door_of_a_garage_is_a_garage_door_and_a_number_may_begin_a_name() -> None:
    made = drawing({"2 car garage": (1500, 3000), "12.40 m²": (1500, 2600), "Flur": (4500, 3000), "Bad": (7000, 3000)})
    made.modelspace().add_line((150, 1000), (150, 3400), dxfattribs={"layer": "Doors"})
    leaf(made, "open")
    (garage,) = [room for room in imported(made).scene.rooms if room.type == "garage"]
    assert garage.name == "2 car garage"
    assert sorted((one.kind, one.width) for one in garage.openings) == [("door", 0.885), ("garage_door", 2.4)]


PANELS = [(((0, 500), (385, 885)), True), (((0, 442), (442, 885)), True), (((0, 250), (700, 885)), False)]


@pytest.mark.parametrize(("parts", "wide"), PANELS)
def test_leaves_that_slide_past_one_another_are_one_door(parts: tuple[tuple[int, int], ...], wide: bool) -> None:
    """Side by side they are as wide as their gap; two that leave half of it open are none of it."""
    made = drawing()
    x, low, _ = DOORS["Küche"]
    for at, (start, end) in enumerate(parts):
        x0, x1 = x + 20 + 35 * at, x + 45 + 35 * at
        corners = [(x0, low + start), (x1, low + start), (x1, low + end), (x0, low + end)]
        made.modelspace().add_lwpolyline(corners, close=True, dxfattribs={"layer": "Türen"})
    assert [one.width for one in doors(imported(made)) if one.kind == "door"] == [0.885] * wide


@pytest.mark.parametrize("thick", [410, 590])
def test_walls_thicker_than_most_go_on_beside_their_doors(thick: int) -> None:
    """A wall between two rooms with a door in it, each face of which goes on for 1.5 m on either side."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    west, east, south = thick + 3000, 2 * thick + 3000, thick + 3900
    for x0, y0, x1, y1 in (
        (0, 0, east + 3000 + thick, thick), (0, south, east + 3000 + thick, south + thick), (0, thick, thick, south),
        (east + 3000, thick, east + 3000 + thick, south), (west, thick, east, thick + 1500), (west, south - 1500, east, south),
    ):  # fmt: skip
        made.modelspace().add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": "Walls"})
    made.modelspace().add_line((west, thick + 1500), (west, south - 1500), dxfattribs={"layer": "Doors"})
    assert [[(one.kind, one.width) for one in room.openings] for room in imported(made).scene.rooms] == [[("door", 0.9)], [("door", 0.9)]]


def test_gaps_between_rooms_that_are_drawn_are_passages_too() -> None:
    """By a millimetre narrower, so that its middle is on a whole one. Where no piece of their wall is drawn, it is none of those drawn."""
    made = drawing({})
    for name, x0, x1 in (("Küche", 300, 3700), ("Flur", 3800, 5300), ("Bad", 5400, 8700)):
        made.modelspace().add_lwpolyline([(x0, 300), (x1, 300), (x1, 5700), (x0, 5700)], close=True, dxfattribs={"layer": "Räume"})
        made.modelspace().add_text(name, height=150).set_placement((x0 + 500, 3000))
    assert [(one.kind, one.width) for one in doors(imported(made))] == [("passage", 0.884), ("passage", 0.76)]
    for one in list(made.modelspace().query("LWPOLYLINE[layer!='Räume']"))[2:]:
        made.modelspace().delete_entity(one)
    assert doors(imported(made)) == []


def test_a_small_window_through_a_thick_wall_is_one_window() -> None:
    """Its outer lines lie nearly as far from one another as it is wide."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    for spots in ([(0, 0), (2000, 0), (2000, 365), (365, 365), (365, 3000), (4365, 3000), (4365, 365), (2600, 365), (2600, 0), (4730, 0),
                   (4730, 3365), (0, 3365)],):  # fmt: skip
        space.add_lwpolyline(spots, close=True, dxfattribs={"layer": "Wand"})
    for y in (0, 182, 365):
        space.add_line((2000, y), (2600, y), dxfattribs={"layer": "Fenster"})
    space.add_line((0, 1500), (0, 2400), dxfattribs={"layer": "Türen"})
    (room,) = imported(made).scene.rooms
    assert sorted((one.kind, one.width) for one in room.openings) == [("door", 0.9), ("window", 0.6)]


@pytest.mark.parametrize("turn", [0, 37])
@pytest.mark.parametrize("order", [(-200, 0, 200), (200, -200, 0), (0, 200, -200)])
def test_lines_of_a_window_through_a_thick_wall_without_a_gap_are_one_window(order: tuple[int, ...], turn: int) -> None:
    """The wall is 0.4 m thick, the window 0.6 wide, its sill sticks out by 5 cm at both ends."""
    lines = "".join(f"<path d='M1000 {at}h600'/>" for at in order) + "<path d='M950 240h700'/>"
    walls = "<path d='M-200 -3200H4200V200H-200z'/><path d='M0 -3000H4000V-200H0z'/>"
    door = "<g id='Doors'><path d='M2500 -3100h900'/></g>"
    drawing = f"<g transform='rotate({turn})'><g id='Walls'>{walls}</g><g id='Windows'>{lines}</g>{door}</g>"
    (room,) = read(f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='mm'>{drawing}</svg>".encode()).scene.rooms
    assert sorted((one.kind, one.width) for one in room.openings) == [("door", 0.9), ("window", 0.6)]


@pytest.mark.parametrize(("east", "count"), [(0, 1), (400, 0)])
def test_a_gap_in_a_wall_of_one_line_is_one_whatever_ends_before_that_line(east: int, count: int) -> None:
    """What runs beside it, no farther than walls are thick, is the other face of a wall that has none there."""
    line, across = [[(0, 0), (500, 0)], [(1400, 0), (5000, 0)]], [[(0, -3000), (0, 3000)]]
    gaps = gaps_of([*line, *across, [(-4000, 300), (east, 300)]], 0.001)
    assert [gap.width for gap in gaps if gap.is_whole] == [900] * count


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("shaft", "gaps"), [((0, 600), [900]), ((1400, 2000), [])])
def test_a_shaft_makes_two_faces_of_a_wall_of_one_line_only_where_a_gap_is(mirrored: bool, shaft: tuple[int, int], gaps: list[int]) -> None:
    """The pieces on both sides of the gap tell alike."""
    low, high = shaft
    sides = [[(low, 0), (low, 600)], [(high, 600), (low, 600)], [(high, 0), (high, 600)]]
    line, across = [[(0, 0), (2000, 0)], [(2900, 0), (6000, 0)]], [[(x, -3000), (x, 3000)] for x in (0, 6000)]
    walls = [[(6000 - x if mirrored else x, z) for x, z in points] for points in [*line, *across, *sides]]
    found = [gap for gap in gaps_of(walls, 0.001) if gap.is_whole and gap.start[1] == gap.end[1] == 0]
    assert [gap.width for gap in found] == gaps
