"""Doors and windows as blocks, as CAD programmes insert them: turned, mirrored, within each other."""

from __future__ import annotations

from io import StringIO
from typing import Any

import ezdxf.filemanagement as files
import pytest

from solver.errors import FieldError
from solver.imported import PlanImport
from tests.imports.plans import opening, read, rooms_of


def drawing() -> Any:
    """Two rooms of 4 x 3 m side by side, in metres, with texts; blocks of a door of 0.9 m hung at the origin, and of a window."""
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 6
    door, window = made.blocks.new("DOOR_90"), made.blocks.new("Fenster 120")
    door.add_arc((0, 0), 0.9, 0, 90)
    door.add_line((0, 0), (0, 0.9))
    door.add_line((-0.05, -0.05), (-0.05, 0.05))
    window.add_lwpolyline([(0, -0.05), (1.2, -0.05), (1.2, 0.05), (0, 0.05)], close=True)
    for x, name in ((0, "Kitchen"), (4, "Bedroom")):
        made.modelspace().add_lwpolyline([(x, 0), (x + 4, 0), (x + 4, 3), (x, 3)], close=True, dxfattribs={"layer": "ROOMS"})
        made.modelspace().add_text(name, height=0.2).set_placement((x + 1, 2))
    return made


def imported(made: Any) -> PlanImport:
    text = StringIO()
    made.write(text)
    return read(text.getvalue().encode(), "plan.dxf")


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_block_of_a_door_is_one_door(mirrored: bool) -> None:
    made = drawing()
    turned = {"rotation": 90, "xscale": -1 if mirrored else 1}
    made.modelspace().add_blockref("DOOR_90", (4, 1), dxfattribs=turned)
    made.modelspace().add_blockref("Fenster 120", (1, 0))
    kitchen, bedroom = rooms_of(imported(made)).values()
    door = opening(kitchen, "door_0")
    assert (door.wall, door.width, door.connects_to) == ("east", 0.9, bedroom.id)
    middle = 0.55 if mirrored else 1.45
    assert door.position == pytest.approx(3 - middle)
    assert door.hinge == ("start" if mirrored else "end")
    assert opening(kitchen, "window_0").wall == "south" and opening(kitchen, "window_0").width == 1.2
    assert len(kitchen.openings) == 2


def test_a_block_within_a_block_is_opened_by_its_name_or_layer() -> None:
    made = drawing()
    made.blocks.new("unit").add_blockref("DOOR_90", (1, 0))
    made.modelspace().add_blockref("unit", (0, 0), dxfattribs={"layer": "A-DOOR"})
    made.modelspace().add_blockref("unit", (4, 0), dxfattribs={"layer": "A-OTHER"})
    answer = imported(made)
    kitchen, bedroom = rooms_of(answer).values()
    assert [(one.kind, one.wall, one.width) for one in kitchen.openings] == [("door", "south", 0.9)]
    assert bedroom.openings == ()
    assert {"place": "layer 'A-OTHER'", "reason": "1 of INSERT, which is not read"} in answer.unread


def test_blocks_that_multiply_are_refused() -> None:
    made = drawing()
    for depth in range(6):
        block = made.blocks.new(f"door {depth}")
        for at in range(10):
            block.add_blockref(f"door {depth - 1}" if depth else "DOOR_90", (at, 0))
    made.modelspace().add_blockref("door 5", (0, 0))
    with pytest.raises(FieldError, match="more than 50,000 entities"):
        imported(made)
