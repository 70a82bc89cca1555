"""Doors and windows as blocks, as CAD programmes insert them: turned, mirrored, within each other."""

from __future__ import annotations

from typing import Any

import ezdxf.filemanagement as files
import pytest
from ezdxf.math import Matrix44

from solver.errors import FieldError
from tests.imports.plans import imported, opening, read, rooms_of, text_of


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


def test_a_block_within_a_block_is_opened_but_on_layers_that_hold_other_things() -> None:
    made = drawing()
    made.blocks.new("unit").add_blockref("DOOR_90", (1, 0))
    made.blocks.new("tree").add_circle((0, 0), 1)
    made.modelspace().add_blockref("unit", (0, 0), dxfattribs={"layer": "A-OTHER"})
    made.modelspace().add_blockref("unit", (4, 0), dxfattribs={"layer": "I-FURN"})
    made.modelspace().add_blockref("tree", (4, 0), dxfattribs={"layer": "A-OTHER"})
    answer = imported(made)
    kitchen, bedroom = rooms_of(answer).values()
    assert [(one.kind, one.wall, one.width) for one in kitchen.openings] == [("door", "south", 0.9)]
    assert bedroom.openings == ()
    for layer in ("A-OTHER", "I-FURN"):
        assert {"place": f"layer '{layer}'", "reason": "1 of INSERT, which is not read"} in answer.unread


@pytest.mark.parametrize("scale", [1, 0.5])
def test_a_whole_house_that_is_one_block_is_read_as_if_it_were_none(scale: float) -> None:
    made = drawing()
    made.modelspace().add_blockref("DOOR_90", (4, 1), dxfattribs={"rotation": 90})
    made.modelspace().add_blockref("Fenster 120", (1, 0))
    whole = made.blocks.new("xref-plan")
    for entity in list(made.modelspace()):
        made.modelspace().move_to_layout(entity, whole)
    outer = made.blocks.new("sheet")
    outer.add_blockref("xref-plan", (3, 7))
    assert len(made.modelspace()) == 0
    made.modelspace().add_blockref("sheet", (100, 50), dxfattribs={"xscale": 1 / scale, "yscale": 1 / scale, "rotation": 90})
    answer = imported(made, unit="m" if scale == 1 else "0.5")
    kitchen, bedroom = rooms_of(answer).values()
    assert (kitchen.type, kitchen.width, kitchen.depth, bedroom.type) == ("kitchen", 3.0, 4.0, "bedroom")
    door = opening(kitchen, "door_0")
    assert (door.width, door.connects_to) == (0.9, bedroom.id)
    assert {one.kind for one in kitchen.openings} == {"door", "window"}


def test_blocks_that_multiply_are_refused() -> None:
    made = drawing()
    for depth in range(6):
        block = made.blocks.new(f"door {depth}")
        for at in range(10):
            block.add_blockref(f"door {depth - 1}" if depth else "DOOR_90", (at, 0))
    made.modelspace().add_blockref("door 5", (0, 0))
    with pytest.raises(FieldError, match="more than 50,000 entities"):
        imported(made)


def test_what_is_never_looked_at_does_not_keep_a_plan_from_being_read() -> None:
    made = drawing()
    made.blocks.new("chair").add_circle((0, 0), 0.77125)
    for layer, block, x in (("I-FURN", "chair", 2), ("0", "DOOR_90", 1)):
        made.modelspace().add_blockref(block, (x, 0), dxfattribs={"layer": layer})
    whole = text_of(made)
    spoilt = whole.replace("\n0.77125\n", "\nno number\n").replace("LAYOUT\n  5\n", "LAYOUT\n  no code\n")
    assert spoilt.count("no number") == 1 and spoilt.count("no code") == 2
    answer = read(spoilt.encode(), "plan.dxf")
    assert answer.scene == read(whole.encode(), "plan.dxf").scene
    assert [one.kind for room in answer.scene.rooms for one in room.openings] == ["door"]
    with pytest.raises(FieldError, match="cannot be read"):
        read(spoilt.replace("I-FURN", "A-DOOR").encode(), "plan.dxf")


@pytest.mark.parametrize(
    ("content", "why"), [(b"rubbish\n", 'Invalid group code "rubbish " at line 3'), (b"2\nENTITIES\n0\nLINE\n", "it is cut off")]
)
def test_what_is_no_drawing_is_refused_in_one_line_without_the_name_of_a_class(content: bytes, why: str) -> None:
    with pytest.raises(FieldError) as refused:
        read(b"0\nSECTION\n" + content, "plan.dxf")
    assert refused.value.problem == f"DXF that cannot be read: {why}"


@pytest.mark.parametrize("kind", ["CIRCLE", "INSERT", "IMAGE"])
def test_a_drawing_without_rooms_or_layers_is_told_what_is_left_out_of_it(kind: str) -> None:
    made = files.new()
    if kind == "CIRCLE":
        made.modelspace().add_circle((0, 0), 5)
        made.modelspace().add_spline([(0, 0), (1, 1), (2, 0)])
    elif kind == "IMAGE":
        made.modelspace().add_image(made.add_image_def("plan.png", (100, 100)), (0, 0), (10, 10))
    else:
        made.add_xref_def("plan.dwg", "OTHER")
        made.modelspace().add_blockref("OTHER", (0, 0))
    told = {"CIRCLE": "1 of CIRCLE, which is not read; 1 of SPLINE", "INSERT": "1 of INSERT", "IMAGE": "pictures and pages .*: 1"}[kind]
    with pytest.raises(FieldError, match=f"are none in this file; left out: {told}"):
        imported(made)


STAMPS = {
    "attributes": ("RAUMSTEMPEL", "Raumstempel"), "a block called room": ("ROOM", "0"), "a block that tells nothing": ("B7", "TEXTE"),
    "texts": ("Room Tag - 12", "A-AREA-IDEN"), "texts on a layer of labels": ("B7", "A-AREA-IDEN"),
}  # fmt: skip


@pytest.mark.parametrize("stamp", STAMPS)
def test_a_stamp_names_its_room_and_its_frame_is_none(stamp: str) -> None:
    block, layer = STAMPS[stamp]
    made: Any = files.new("R2010")
    made.header["$INSUNITS"] = 6
    space = made.modelspace()
    for x, name in ((0, "Küche"), (4, "Schlafen")):
        for start, end in (((x, 0), (x + 4, 0)), ((x + 4, 0), (x + 4, 3)), ((x + 4, 3), (x, 3)), ((x, 3), (x, 0))):
            space.add_line(start, end, dxfattribs={"layer": "Wände"})
        own = f"{block}.{name}" if "texts" in stamp else block
        if own not in made.blocks:
            made.blocks.new(own).add_lwpolyline([(0, 0), (1, 0), (1, 0.8), (0, 0.8)], close=True)
        insert = space.add_blockref(own, (x + 1, 1), dxfattribs={"layer": layer})
        if "texts" in stamp:
            made.blocks[own].add_text(name, height=0.2).set_placement((0.1, 0.5))
        else:
            for tag, words, y in (("NUMMER", "0.07", 1.1), ("NAME", name, 1.3), ("FLAECHE", "12,00 m2", 1.5)):
                insert.add_attrib(tag, words, (x + 1.1, y))
    answer = imported(made)
    assert [(room.type, room.width, room.depth) for room in answer.scene.rooms] == [("kitchen", 4, 3), ("bedroom", 4, 3)]


def test_texts_of_a_mirrored_drawing_stand_where_they_are_drawn() -> None:
    """A mirror turns what is flat upside down: its own frame is no longer the drawing's."""
    made = drawing()
    made.modelspace().add_blockref("DOOR_90", (4, 1), dxfattribs={"rotation": 90})
    for entity in made.modelspace():
        entity.transform(Matrix44.scale(-1, 1, 1))
    assert {entity.dxf.extrusion.z for entity in made.modelspace().query("TEXT")} == {-1}
    answer = imported(made)
    assert [(room.type, [one.kind for one in room.openings]) for room in answer.scene.rooms] == [
        ("kitchen", ["door"]),
        ("bedroom", ["door"]),
    ]
    assert answer.scene.rooms[0].x > answer.scene.rooms[1].x
