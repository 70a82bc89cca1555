"""Drawings whose layers tell nothing: walls are what encloses rooms, doors what swings in their gaps, windows what is drawn across them."""

from __future__ import annotations

import math
from itertools import chain, pairwise
from typing import Any

import ezdxf.filemanagement as files
import numpy as np
import pytest
from ezdxf.math import Matrix44

from solver.answers import PlanImport
from solver.errors import FieldError
from solver.imports import nameless_shapes
from solver.imports.shape_openings import DrawnShape, DrawnSwing, without_leaves
from solver.imports.walls_alone import Between, WallOutlines, rooms_between
from tests.imports.plans import imported

NAMES = {"Kitchen": (2000, 2500), "Bedroom": (6500, 2500)}
FACES = (
    [(0, 0), (1000, 0), (1000, 300), (300, 300), (300, 4700), (1500, 4700), (1500, 5000), (0, 5000)],
    [(2200, 0), (9000, 0), (9000, 5000), (2400, 5000), (2400, 4700), (4400, 4700), (4400, 3400), (4500, 3400), (4500, 4700), (8700, 4700),
     (8700, 300), (4500, 300), (4500, 2500), (4400, 2500), (4400, 300), (2200, 300)],
)  # fmt: skip
"""Walls of 0.3 m around two rooms, one of 0.1 m between: a window of 1.2 m in the north, gaps of 0.9 m in that wall and in the south."""
WINDOW = ((1000, 2200), (0, 150, 300))
LEAVES = (((4400, 2500), (5300, 2500), (4400, 3400)), ((1500, 4700), (1500, 3800), (2400, 4700)))
"""A hinge, where the open leaf ends, where the shut one does."""


STUB = [(3300, 300), (3300, 1300), (3000, 1300), (3000, 300)]
"""A wall that juts out into the kitchen and ends there: what its end is drawn as runs beside no other line."""


def in_block(made: Any, layer: str | None) -> Any:
    """A new block without a telling name that is inserted once, on a layer; without one the drawing itself."""
    if layer is None:
        return made.modelspace()
    block = made.blocks.new(f"A$C{len(made.blocks)}")
    made.modelspace().add_blockref(block.name, (0, 0), dxfattribs={"layer": layer})
    return block


def drawing(layers: dict[str, str], *, closed: bool = False, turn: float = 0.0, names: bool = True, stub: bool = False) -> Any:
    """The plan with its walls as outlines or as single lines, doors as leaves and arcs, a window as three lines, on some layers.

    Where `layers` has one of blocks, doors and windows are in such.
    """
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def at(x: float, y: float) -> tuple[float, float]:
        return c * x - s * y, s * x + c * y

    for spots in (FACES[0], [*FACES[1][:-1], *(STUB if stub else []), FACES[1][-1]]):
        if closed:
            space.add_lwpolyline([at(*spot) for spot in spots], close=True, dxfattribs={"layer": layers["wall"]})
        else:
            for a, b in zip(spots, [*spots[1:], spots[0]], strict=True):
                space.add_line(at(*a), at(*b), dxfattribs={"layer": layers["wall"]})
    holder = in_block(made, layers.get("block"))
    for y in WINDOW[1]:
        holder.add_line(at(WINDOW[0][0], y), at(WINDOW[0][1], y), dxfattribs={"layer": layers["window"]})
    for hinge, tip, shut in LEAVES:
        holder = in_block(made, layers.get("block"))
        holder.add_line(at(*hinge), at(*tip), dxfattribs={"layer": layers["door"]})
        first, last = sorted(math.degrees(math.atan2(one[1] - hinge[1], one[0] - hinge[0])) for one in (tip, shut))
        holder.add_arc(at(*hinge), 900, first + turn, last + turn, dxfattribs={"layer": layers["door"]})
    for words, spot in NAMES.items() if names else ():
        space.add_text(words, height=150, dxfattribs={"layer": layers["text"], "insert": at(*spot)})
    return made


ONE = dict.fromkeys(("wall", "window", "door", "text", "other"), "0")
NUMBERS = {"wall": "1", "window": "2", "door": "3", "text": "4", "other": "5"}


def seen(answer: PlanImport) -> list[tuple[str, list[tuple[str, float]]]]:
    return sorted((room.type, sorted((one.kind, one.width) for one in room.openings)) for room in answer.scene.rooms)


WANTED = [("bedroom", [("door", 0.9)]), ("kitchen", [("door", 0.9), ("door", 0.9), ("window", 1.2)])]


@pytest.mark.parametrize("names", [False, True])
def test_the_end_of_a_wall_keeps_a_room_out_of_it(names: bool) -> None:
    answer = imported(drawing(ONE, names=names, stub=True))
    assert sorted(len(room.openings) for room in answer.scene.rooms) == [1, 3]
    assert answer.scene.wall_thickness == 0.1
    kitchen = min(answer.scene.rooms, key=lambda room: room.x)
    assert (round(kitchen.width, 2), round(kitchen.depth, 2), len(kitchen.outline or ())) == (4.2, 4.5, 8)


@pytest.mark.parametrize("layers", [ONE, NUMBERS])
@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("turn", [0, 17])
def test_a_plan_is_read_by_its_form(layers: dict[str, str], closed: bool, turn: int) -> None:
    answer = imported(drawing(layers, closed=closed, turn=turn))
    assert seen(answer) == WANTED
    assert sorted((room.width, room.depth) for room in answer.scene.rooms) == [(4.2, 4.5), (4.3, 4.5)]
    assert f"layer '{layers['wall']}'" in [one["place"] for one in answer.unread if str(one["reason"]).startswith("it is taken as walls")]


def test_the_same_lines_are_looked_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Between all shapes of a layer, and between those that run beside another: of walls alone these are the same."""
    looked: list[frozenset[Any]] = []

    def between(walls: WallOutlines, *rest: Any) -> Between:
        looked.append(frozenset(walls.lines))
        return rooms_between(walls, *rest)

    monkeypatch.setattr(nameless_shapes, "rooms_between", between)
    assert seen(imported(drawing(NUMBERS))) == WANTED
    assert 0 < len(looked) == len(set(looked))


@pytest.mark.parametrize("layers", [ONE, NUMBERS])
def test_open_leaves_without_arcs_hang_at_the_corners_of_gaps(layers: dict[str, str]) -> None:
    made = drawing(layers)
    for arc in made.modelspace().query("ARC"):
        made.modelspace().delete_entity(arc)
    for a, b in (((4400, 2500), (4400, 1000)), ((3000, 2500), (3900, 2500))):
        made.modelspace().add_line(a, b, dxfattribs={"layer": layers["other"]})
    answer = imported(made)
    assert seen(answer) == WANTED
    kitchen = min(answer.scene.rooms, key=lambda room: room.x)
    inner, front = sorted((one for one in kitchen.openings if one.kind == "door"), key=lambda one: one.connects_to == "EXTERIOR")
    assert ((inner.wall, inner.hinge, inner.swing), (front.wall, front.hinge, front.swing)) == (
        ("east", "end", "out"), ("north", "start", "in"),
    )  # fmt: skip


TILES = [((4500, y), (5400, y)) for y in range(2200, 3700, 300)]
CUPBOARD = [((4500, 1900), (5400, 1900)), ((5400, 1900), (5400, 2500)), ((5400, 2500), (4500, 2500))]
LEAF = [((4500, 2500), (5400, 2500))]


@pytest.mark.parametrize(("lines", "door", "kind"), [
    (LEAF, "3", "door"), (TILES, "3", "passage"), (CUPBOARD, "3", "passage"), (LEAF, "DOORS", "passage"),
])  # fmt: skip
def test_what_hangs_at_a_gap_is_a_leaf_if_it_is_alone_and_nothing_is_called_a_door(
    lines: list[tuple[tuple[int, int], tuple[int, int]]], door: str, kind: str
) -> None:
    made = drawing(NUMBERS | {"door": door})
    inner = (one for one in made.modelspace().query(f"LINE[layer=='{door}']") if one.dxf.start.x == LEAVES[0][0][0])
    for one in (*made.modelspace().query("ARC"), *inner):
        made.modelspace().delete_entity(one)
    for line in lines:
        made.modelspace().add_line(*line, dxfattribs={"layer": "5"})
    (bedroom,) = [room for room in imported(made).scene.rooms if room.type == "bedroom"]
    assert [one.kind for one in bedroom.openings] == [kind]


@pytest.mark.parametrize("closed", [False, True])
def test_lengths_axes_a_frame_and_furniture_on_the_same_layer_are_no_walls(closed: bool) -> None:
    made = drawing(ONE, closed=closed)
    space = made.modelspace()
    lengths = [((300, 1800), (4400, 1800)), ((0, -900), (9000, -900)), ((0, -1000), (0, -800)), ((9000, -1000), (9000, -800))]
    axes, worktop = [((4450, -3000), (4450, 8000)), ((-3000, 4850), (12000, 4850))], [((300, 900), (4400, 900))]
    for a, b in (*lengths, *axes, *worktop):
        space.add_line(a, b, dxfattribs={"layer": "0"})
    frame = ((-3000, -3000, 12000, 8000), (-3200, -3200, 12200, 8200))
    for x0, y0, x1, y1 in (*frame, (1200, 1900, 3000, 2900), (330, 3000, 930, 4500)):
        space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": "0"})
    for middle, width, first in (((7000, 1000), 400, 0), ((300, 4700), 1200, 270)):
        space.add_arc(middle, width, first, first + 90, dxfattribs={"layer": "0"})
    answer = imported(made)
    assert seen(answer) == WANTED
    assert sorted((room.width, room.depth) for room in answer.scene.rooms) == [(4.2, 4.5), (4.3, 4.5)]
    assert "quarter circles that hang in no gap in a wall are no doors: 2" in [one["reason"] for one in answer.unread]


def test_single_lines_are_walls_and_furniture_between_them_is_none() -> None:
    """Both on one layer: three rooms; then one, whose walls are a polyline in part, around two tables that nothing names."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    outer = [(0, 0), (9000, 0), (9000, 5000), (0, 5000), (0, 0)]
    for a, b in (*pairwise(outer), ((4000, 0), (4000, 5000)), ((4000, 3000), (9000, 3000))):
        space.add_line(a, b)
    assert sorted((room.width, room.depth) for room in imported(made).scene.rooms) == [(4, 5), (5, 2), (5, 3)]
    space.delete_all_entities()
    space.add_lwpolyline([*outer[:2], (9000, 3000), (6000, 3000), (9000, 3000), outer[2]])
    tables = (pairwise([(x, 800), (x + 1200, 800), (x + 1200, 1700), (x, 1700), (x, 800)]) for x in (1000, 3000))
    for a, b in chain(pairwise(outer[2:]), *tables):
        space.add_line(a, b)
    assert (9, 5) in [(room.width, room.depth) for room in imported(made).scene.rooms]


@pytest.mark.parametrize("turn", [0, 17])
def test_walls_that_are_areas_and_doors_that_are_polylines_are_read_by_their_form(turn: int) -> None:
    """Both on a layer that says nothing; a table of round corners is no door."""
    made = drawing(ONE, closed=True)
    space = made.modelspace()
    for wall in list(space.query("LWPOLYLINE")):
        space.add_hatch().paths.add_polyline_path(wall.get_points("xy"), is_closed=True)
        space.delete_entity(wall)
    for part in [*space.query("ARC"), *(line for line in space.query("LINE") if line.dxf.start.vec2 in [leaf[0] for leaf in LEAVES])]:
        space.delete_entity(part)
    for (x, y), tip, shut in LEAVES:
        turns = math.copysign(math.tan(math.pi / 8), (tip[0] - x) * (shut[1] - y) - (tip[1] - y) * (shut[0] - x))
        space.add_lwpolyline([(x, y, 0), (*tip, turns), (*shut, 0)], format="xyb")
    corners = ((1500, 1000), (2400, 1000), (2600, 1200), (2600, 1500), (2400, 1700), (1500, 1700))
    space.add_lwpolyline([(*spot, 0.414 * (at in (1, 3))) for at, spot in enumerate(corners)], format="xyb", close=True)
    for one in space:
        one.transform(Matrix44.z_rotate(math.radians(turn)))
    assert seen(imported(made)) == WANTED


@pytest.mark.parametrize("layers", [ONE, NUMBERS])
def test_blocks_are_opened_while_they_fit_where_no_name_tells_anything(layers: dict[str, str]) -> None:
    made = drawing({**layers, "block": layers["other"]})
    tree = in_block(made, layers["other"])
    for at in range(60):
        tree.add_line((20_000, at), (21_000, at), dxfattribs={"layer": layers["other"]})
    made.modelspace()[-1].grid((30, 30))
    sofa = in_block(made, layers["other"])
    sofa.add_lwpolyline([(6000, 1000), (8000, 1000), (8000, 1900), (6000, 1900)], close=True)
    chair = in_block(made, layers["other"])
    corners = [(0, 0), (400, 0), (400, 50), (400, 400), (350, 400), (50, 400), (0, 400), (0, 50)]
    chair.add_lwpolyline([(5000 + x, 4000 + y, 0.41 * (at % 2)) for at, (x, y) in enumerate(corners)], format="xyb", close=True)
    for at in range(90):
        made.modelspace().add_blockref(chair.name, (at, 0), dxfattribs={"layer": layers["other"]})
    assert seen(imported(made)) == WANTED


def test_what_is_said_on_a_layer_called_as_rooms_are_keeps_no_block_shut() -> None:
    assert seen(imported(drawing({**NUMBERS, "text": "ROOM-NAMES", "block": "0"}))) == WANTED


@pytest.mark.parametrize("thick", [240, 300, 400])
def test_faces_of_walls_that_end_at_a_door_without_jambs_are_no_axes(thick: int) -> None:
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space, inner = made.modelspace(), (thick, thick, 9000 - thick, 5000 - thick)
    for x0, y0, x1, y1 in ((0, 0, 9000, 5000), inner):
        for a, b in (((x0, y0), (1500, y0)), ((2400, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
            space.add_line(a, b)
    for a, b in (
        ((thick, 2 * thick), (1500, 2 * thick)),
        ((2400, 2 * thick), (9000 - thick, 2 * thick)),
        ((1500, thick), (1500, thick + 900)),
    ):
        space.add_line(a, b)
    for x in (3000, 6000):
        space.add_line((x, thick), (x, 5000 - thick))
    space.add_arc((1500, thick), 900, 0, 90)
    space.add_text("Kitchen", height=150, dxfattribs={"insert": (4000, 2500)})
    assert seen(imported(made)) == [("kitchen", [("door", 0.9)])]


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize(("east", "south"), [(4450, 4850), (4500, 4700)])
def test_doors_and_windows_lie_in_walls_whose_lines_run_on_through_them(closed: bool, east: int, south: int) -> None:
    """A leaf, shut, lies in no room and beside one, or along a face; a corner shower does along two, and lines end at a worktop's end.

    A window lies between the faces of an outer wall; an axis, a line in an inner wall or outside is none.
    """
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    for x0, y0, x1, y1 in ((0, 0, 9000, 5000), (300, 300, 4400, 4700), (4500, 300, 8700, 4700)):
        corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        if closed:
            space.add_lwpolyline(corners, close=True)
        for a, b in zip(corners, [*corners[1:], corners[0]], strict=True) if not closed else ():
            space.add_line(a, b)
    for hinge, tip, first in (
        ((east, 2500), (east + 900, 2500), 0), ((1500, south), (1500, south - 900), 270), ((8700, 300), None, 90), ((300, 1200), None, 0)
    ):  # fmt: skip
        space.add_arc(hinge, 900, first, first + 90)
        if tip:
            space.add_line(hinge, tip)
    space.add_line((1200, 300), (1200, 1200))
    if closed:
        space.add_lwpolyline([(1300, 120), (2500, 120), (2500, 180), (1300, 180)], close=True)
    else:
        space.add_line((1300, 120), (2500, 120))
        space.add_line((1300, 180), (2500, 180))
    for a, b in (((-200, 150), (9200, 150)), ((4450, 3600), (4450, 4300)), ((5000, -200), (6000, -200))):
        space.add_line(a, b)
    for words, spot in NAMES.items():
        space.add_text(words, height=150, dxfattribs={"insert": spot})
    doors = [("door", 0.9), ("door", 0.9)]
    assert seen(imported(made)) == [("bedroom", doors[:1]), ("kitchen", [*doors, ("window", 1.2)])]


def test_gaps_that_are_as_wide_as_doors_in_a_unit_that_has_a_name_tell_that() -> None:
    made = drawing(ONE)
    made.header["$INSUNITS"] = 0
    for one in list(made.modelspace()):
        if one.dxftype() == "ARC":
            made.modelspace().delete_entity(one)
        else:
            one.transform(Matrix44.scale(0.08))
    answer = imported(made)
    assert sorted(room.width for room in answer.scene.rooms) == [3.36, 3.44]
    assert "the median gap in walls is 0.72 m in cm" in str([one["message"] for one in answer.guesses])


def test_what_lies_in_walls_whose_layer_is_called_so_is_no_window_on_another_layer() -> None:
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    for low, east, north in ((0, 5000, 4000), (300, 4700, 3700)):
        made.modelspace().add_lwpolyline([(low, low), (east, low), (east, north), (low, north)], close=True, dxfattribs={"layer": "WALLS"})
    made.modelspace().add_line((1300, 150), (2500, 150), dxfattribs={"layer": "Furniture"})
    assert [(room.width, room.openings) for room in imported(made).scene.rooms] == [(4.7, ())]


def test_lines_along_a_leaf_are_leaves_however_often_it_is_drawn_and_are_not_gone_over_for_each(monkeypatch: pytest.MonkeyPatch) -> None:
    counts, distances = [0], np.hypot

    def counted(a: Any, b: Any) -> Any:
        counts.append(np.size(a))
        return distances(a, b)

    monkeypatch.setattr(np, "hypot", counted)
    swing = DrawnSwing((0.0, 0.0), ((900.0, 0.0), (0.0, 900.0)), "arc")
    lines = [DrawnShape("0", ((0.0, 0.0), (900.0, 0.001 * at)), False, "line", None) for at in (0, 0, *range(1, 399))]
    face = DrawnShape("0", ((0.0, 0.0), (0.0, 900.0)), False, "line", None)
    beyond = [DrawnShape("0", ((x, 900.0), (x, 2000.0)), False, "line", None) for x in (0.0, 900.0)]
    for drawn in ([*lines, face, *beyond], [face, *beyond, *lines[:2]]):
        told = without_leaves(drawn, [swing])
        assert {one.sort for one, before in zip(told, drawn, strict=True) if before in lines} == {"door"}
        assert {one.sort for one, before in zip(told, drawn, strict=True) if before not in lines} == {None}
    assert sum(counts) < 10 * len(lines)


def test_without_names_of_rooms_most_rooms_tell() -> None:
    answer = imported(drawing(NUMBERS, names=False))
    assert [kinds for _, kinds in seen(answer)] == [kinds for _, kinds in WANTED]


def thick_walls(layer: str, hatched: bool) -> Any:
    """Walls of 0.7 m about two rooms of 4 m by 3 m with a door between them."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 4
    space = made.modelspace()
    for x0, y0, x1, y1 in (
        (0, 0, 10100, 700), (0, 3700, 10100, 4400), (0, 0, 700, 4400), (9400, 0, 10100, 4400),
        (4700, 0, 5400, 1500), (4700, 2400, 5400, 4400),
    ):  # fmt: skip
        corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        if hatched:
            space.add_hatch(dxfattribs={"layer": layer}).paths.add_polyline_path(corners, is_closed=True)
        else:
            space.add_lwpolyline(corners, close=True, dxfattribs={"layer": layer})
    return made


def test_the_insides_of_walls_that_are_areas_and_of_their_gaps_at_doors_are_no_rooms() -> None:
    made = thick_walls("0", hatched=True)
    made.modelspace().add_arc((5050, 1500), 900, 0, 90)
    answer = imported(made)
    assert [kinds for _, kinds in seen(answer)] == [[("door", 0.9)]] * 2
    assert [(room.width, room.depth) for room in answer.scene.rooms] == [(4.7, 3.7)] * 2


def test_walls_between_whose_faces_no_floor_is_left_are_refused() -> None:
    made = thick_walls("WALLS", hatched=False)
    made.modelspace().delete_entity(made.modelspace()[0])
    with pytest.raises(FieldError, match="enclose no floor between their walls"):
        imported(made)
