"""Homes for Sweet Home 3D: `python -m tests.targets sh3d` has the programme's own library open them."""

from __future__ import annotations

import math

import pytest

from solver.exports import ExportSettings, written_as
from solver.exports.model import HouseModel
from tests.exports import homes
from tests.exports.readers import sh3d


def written(model: HouseModel) -> dict[str, bytes]:
    return written_as(model, ExportSettings("sh3d"))


def test_every_model_is_there_and_as_large_as_its_first_piece() -> None:
    home, archive = sh3d.opened(written(homes.described("own")))
    pieces = [*home.findall("pieceOfFurniture"), *home.findall("doorOrWindow")]
    first = {piece.attrib["model"]: piece for piece in reversed(pieces)}
    assert set(archive.namelist()) == {"Home.xml", *first, *(name.replace(".obj", ".mtl") for name in first)}
    for name, piece in first.items():
        points = [tuple(map(float, line.split()[1:])) for line in archive.read(name).decode().splitlines() if line.startswith("v ")]
        extents = [max(axis) - min(axis) for axis in zip(*points, strict=True)]
        assert extents == pytest.approx([float(piece.attrib[key]) for key in ("width", "height", "depth")], abs=0.02)


def test_sashes_turn_about_their_hinges() -> None:
    """A sash is in shares of its door's box from its north-west corner; angles run counter-clockwise on the plan, 0 is east."""
    model = homes.described("own")
    leaves = {leaf.id: leaf for leaf in model.leaves}
    home, _ = sh3d.opened(written(model))
    doors = {sh3d.properties(door)["id"]: door for door in home.findall("doorOrWindow")}
    assert set(doors) == {one.id for one in model.openings}
    sashes = {name: sash for name, door in doors.items() if (sash := door.find("sash")) is not None}
    assert set(sashes) == {leaf.id for leaf in model.leaves if leaf.motion == "swing"}
    for name, sash in sashes.items():
        door, leaf = doors[name], leaves[name]
        angle, width, depth = (float(door.attrib[key]) for key in ("angle", "width", "depth"))
        right, down = (float(sash.attrib["xAxis"]) - 0.5) * width, (float(sash.attrib["yAxis"]) - 0.5) * depth
        x = float(door.attrib["x"]) + right * math.cos(angle) - down * math.sin(angle)
        y = float(door.attrib["y"]) + right * math.sin(angle) + down * math.cos(angle)
        assert (x, y) == pytest.approx((leaf.hinge[0] * 100, leaf.hinge[2] * 100), abs=0.05)
        start, end = (math.degrees(float(sash.attrib[key]) - angle) for key in ("startAngle", "endAngle"))
        assert math.cos(math.radians(start - leaf.closed)) == pytest.approx(1, abs=1e-4)
        assert end - start == pytest.approx(leaf.swing, abs=0.01)


def test_walls_are_whole_and_rooms_are_named() -> None:
    model = homes.described("own")
    home, _ = sh3d.opened(written(model))
    assert len(home.findall("wall")) == len(model.panels)
    assert [room.attrib["name"] for room in home.findall("room")] == ["Living room", "Bedroom", "Office", "Garage", "Backyard"]
    assert [len(room.findall("point")) for room in home.findall("room")] == [len(room.corners) for room in model.rooms]
