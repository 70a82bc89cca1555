"""DXF as programmes of all sorts write it: binary, old code pages, other ends of lines, curves, units that are not so."""

from __future__ import annotations

from io import BytesIO
from math import pi
from typing import Any

import ezdxf.filemanagement as files
import pytest

from solver.answers import PlanImport
from solver.errors import FieldError
from tests.imports.plans import imported, opening, read, rooms_of, text_of


def drawing(version: str = "R2010", unit: int = 6, scale: float = 1.0) -> Any:
    """Two rooms on a layer "Räume", one a line that ends where it begins, with marked-up texts and a door between."""
    made: Any = files.new(version)
    made.header["$INSUNITS"] = unit
    space = made.modelspace()
    for x, name, ends in ((0.0, "%%uKüche", True), (4.0, "Schlafzimmer", False)):
        spots = [(x * scale, 0.0), ((x + 4) * scale, 0.0), ((x + 4) * scale, 3 * scale), (x * scale, 3 * scale)]
        outline = [*spots, spots[0]] if ends else spots
        space.add_polyline2d(outline, close=not ends, dxfattribs={"layer": "Räume"})
        space.add_text(name, height=0.2 * scale).set_placement(((x + 1) * scale, 2 * scale))
    space.add_line((4 * scale, scale), (4 * scale, 1.9 * scale), dxfattribs={"layer": "Türen"})
    return made


def binary(made: Any) -> bytes:
    stream = BytesIO()
    made.write(stream, fmt="bin")
    return stream.getvalue()


def with_surfaces() -> Any:
    """The two rooms with a roof and a ground, which are POLYLINEs too, on the rooms' own layer."""
    made = drawing()
    space = made.modelspace()
    ground, roof = space.add_polymesh((2, 2), dxfattribs={"layer": "Räume"}), space.add_polyface(dxfattribs={"layer": "Räume"})
    for row in range(2):
        for column in range(2):
            ground.set_mesh_vertex((row, column), (9.0 * row, 9.0 * column, 0.0))
    roof.append_face([(0, 0, 3), (8, 0, 3), (8, 3, 3)])
    return made


FILES = {
    "with surfaces": lambda: text_of(with_surfaces()).encode(),
    "utf-8": lambda: text_of(drawing()).encode(),
    "binary": lambda: binary(drawing()),
    "binary of R12": lambda: binary(drawing("R12", scale=1000.0)),
    "R12 in its code page": lambda: text_of(drawing("R12", scale=1000.0)).encode("cp1252"),
    "R2000 in its code page": lambda: text_of(drawing("R2000")).encode("cp1252"),
    "with a byte order mark": lambda: text_of(drawing()).encode("utf-8-sig"),
    "lines that end in CR": lambda: text_of(drawing()).replace("\n", "\r").encode(),
    "lines that end in CR LF": lambda: text_of(drawing()).replace("\n", "\r\n").encode(),
    "decimetres": lambda: text_of(drawing(unit=14, scale=10.0)).encode(),
    "yards": lambda: text_of(drawing(unit=10, scale=1 / 0.9144)).encode(),
    "millimetres that are called inches": lambda: text_of(drawing(unit=1, scale=1000.0)).encode(),
    "metres that are called millimetres": lambda: text_of(drawing(unit=4)).encode(),
}


@pytest.mark.parametrize("name", FILES)
def test_the_same_rooms_come_from_files_of_every_habit(name: str) -> None:
    kitchen, bedroom = rooms_of(read(FILES[name](), "plan.dxf")).values()
    assert [(one.type, one.name, one.width, one.depth) for one in (kitchen, bedroom)] == [
        ("kitchen", "Küche", 4.0, 3.0),
        ("bedroom", "Schlafzimmer", 4.0, 3.0),
    ]
    door = opening(kitchen, "door_0")
    assert (door.width, door.connects_to) == (0.9, bedroom.id)


def told_units(answer: PlanImport) -> list[str]:
    return [str(guess["message"]) for guess in answer.guesses if guess["what"] == "unit"]


def test_a_unit_in_which_no_door_is_so_wide_is_told() -> None:
    (said,) = told_units(read(FILES["millimetres that are called inches"](), "plan.dxf"))
    assert "0.0254 m" in said and "22.9 m" in said and "0.90 m in mm" in said
    assert told_units(read(FILES["utf-8"](), "plan.dxf")) == []


@pytest.mark.parametrize("wide", [0.2, 3.0, 5.0])
def test_a_wide_or_narrow_door_does_not_change_the_unit_that_the_file_says(wide: float) -> None:
    made = drawing()
    made.modelspace().query("LINE").first.dxf.end = (4, 1 + wide)
    answer = imported(made)
    assert told_units(answer) == []
    assert {room.width for room in answer.scene.rooms} == {4.0}


def test_curves_of_rooms_are_taken_by_chords() -> None:
    """A bay by a bulge, a round room, a room of a spline: their areas are nearly those of the curves, in steps inside them."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 6
    space = made.modelspace()
    space.add_lwpolyline([(0, 0, 0, 0, 0), (4, 0, 0, 0, 1), (4, 4, 0, 0, 0), (0, 4, 0, 0, 0)], close=True, dxfattribs={"layer": "room bay"})
    space.add_circle((12, 2), 2, dxfattribs={"layer": "room round"})
    space.add_ellipse((20, 2), (3, 0), 0.5, dxfattribs={"layer": "room oval"})
    space.add_line((1, 0), (1.9, 0), dxfattribs={"layer": "door"})
    areas = [room.floor_m2 for room in imported(made).scene.rooms]
    for area, exact in zip(areas, (16 + 2 * pi, 4 * pi, 4.5 * pi), strict=True):
        assert 0.88 * exact <= area <= exact


def test_lines_of_a_text_that_are_no_name_are_no_part_of_it() -> None:
    made = drawing()
    made.modelspace().query("TEXT").first.destroy()
    made.modelspace().add_mtext("{\\fArial|b1;Wohn-}\\PKüche\\P12.0 m2").set_location((1, 2))
    assert "Wohn- Küche" in [room.name for room in imported(made).scene.rooms]


def test_a_binary_file_of_too_many_parts_is_refused() -> None:
    content = b"AutoCAD Binary DXF\r\n\x1a\x00" + b"\x00\x00LINE\x00" * 151_000
    with pytest.raises(FieldError, match="more than 150,000"):
        read(content, "plan.dxf")
