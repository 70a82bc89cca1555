"""Buildings as IFC4, read and validated by ifcopenshell."""

from __future__ import annotations

from collections import Counter
from functools import cache
from typing import Any

import ifcopenshell.geom
import ifcopenshell.util.element
import ifcopenshell.validate
import numpy as np
import pytest

from solver.exports import ExportSettings, written_as
from tests.exports import homes
from tests.exports.readers import ifc


@cache
def written(name: str) -> dict[str, bytes]:
    return written_as(homes.described(name), ExportSettings("ifc"))


@cache
def building(name: str) -> Any:
    return ifc.building(written(name))


@pytest.mark.parametrize("name", ["own", "hostile", "storeys"])
def test_the_schema_finds_nothing(name: str) -> None:
    told = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(building(name), told)
    assert told.statements == []


def test_walls_have_openings_and_doors_and_windows_fill_them() -> None:
    file, model = building("own"), homes.described("own")
    count = Counter(product.is_a() for product in file.by_type("IfcProduct"))
    assert count["IfcWall"] == len(model.panels)
    assert count["IfcSpace"] == len(model.rooms)
    assert count["IfcDoor"] == sum(one.kind in ("door", "garage_door") for one in model.openings)
    assert count["IfcWindow"] == sum(one.kind == "window" for one in model.openings)
    filled = {one.RelatingOpeningElement.Name: one.RelatedBuildingElement for one in file.by_type("IfcRelFillsElement")}
    cut = {hole.opening for panel in model.panels for hole in panel.holes}
    assert set(filled) == {one.id for one in model.openings if one.id in cut and one.kind != "passage"}
    assert all(name == door.Name for name, door in filled.items())
    assert len(file.by_type("IfcRelVoidsElement")) == sum(len(panel.holes) for panel in model.panels)


def boxes(file: Any, kinds: list[str]) -> dict[str, tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]]:
    """The corners of products in the house, by name, as a geometry kernel makes them, z up."""
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    found = {}
    iterator = ifcopenshell.geom.iterator(settings, file, 1, include=[one for kind in kinds for one in file.by_type(kind)])
    assert iterator.initialize()
    while True:
        shape = iterator.get()
        points = np.array(shape.geometry.verts).reshape(-1, 3)
        found[shape.product.Name] = points.min(axis=0), points.max(axis=0)
        if not iterator.next():
            return found


def test_furniture_has_the_shape_that_is_described() -> None:
    model, seen = homes.described("own"), boxes(building("own"), ["IfcFurniture", "IfcBuildingElementProxy"])
    straight = [body for body in model.bodies if body.turn % 90 == 0]
    assert len(seen) == len(model.bodies) and len(straight) > 8
    for body in straight:
        low, high = seen[body.id]
        wide, deep = (body.width, body.depth) if body.turn % 180 == 0 else (body.depth, body.width)
        assert (low[0] + high[0]) / 2 == pytest.approx(body.x, abs=0.03)
        assert (low[1] + high[1]) / 2 == pytest.approx(-body.z, abs=0.03)
        assert low[2] >= body.y - 1e-3 and high[2] <= body.y + body.height + 1e-3
        assert (high - low)[0] <= wide + 1e-3 and (high - low)[1] <= deep + 1e-3
    low, high = seen["living/f_arm"]
    assert [*low, *high] == pytest.approx([1.15, -3.1, 0.0, 1.75, -2.8, 0.2], abs=1e-3)


def test_floors_are_10_cm_thick() -> None:
    ((low, high),) = boxes(building("own"), ["IfcSlab"]).values()
    assert (low[2], high[2]) == pytest.approx((-0.1, 0.0))


def test_doors_stand_in_their_walls() -> None:
    model, seen = homes.described("own"), boxes(building("own"), ["IfcDoor", "IfcWindow"])
    for one in (one for one in model.openings if one.kind != "passage"):
        low, high = seen[one.id]
        along, line, sign = (0, -one.line, 1) if one.axis == "x" else (1, one.line, -1)
        ends = sorted((sign * one.start, sign * one.end))
        assert [low[along], high[along]] == pytest.approx(ends, abs=0.02)
        assert (low[1 - along] + high[1 - along]) / 2 == pytest.approx(line, abs=0.06)
        assert high[2] <= one.head + 1e-3


def test_doors_swing_as_the_scene_says() -> None:
    """IFC: left-hinged is seen along the placement's y axis, which is the way it swings; its x axis runs along the wall."""
    file, model = building("own"), homes.described("own")
    placed = {door.Name: door for door in file.by_type("IfcDoor")}
    for one in (one for one in model.openings if one.kind == "door"):
        frame = ifcopenshell.util.placement.get_local_placement(placed[one.id].ObjectPlacement)
        way = (0.0, -float(one.towards)) if one.axis == "x" else (float(one.towards), 0.0)
        assert [frame[0][1], frame[1][1]] == pytest.approx(way, abs=1e-6)
        at_origin = frame[0][3] if one.axis == "x" else -frame[1][3]
        hinge = one.start if one.hinge == "start" else one.end
        left = placed[one.id].OperationType == "SINGLE_SWING_LEFT"
        assert left == (abs(at_origin - hinge) < 1e-6)


def test_spaces_have_names_and_areas() -> None:
    spaces = {one.Name: one for one in building("own").by_type("IfcSpace")}
    assert spaces["living"].LongName == "Living room"
    sizes = ifcopenshell.util.element.get_psets(spaces["living"], qtos_only=True)["Qto_SpaceBaseQuantities"]
    assert sizes["GrossFloorArea"] == pytest.approx(25.0)
    assert sizes["NetFloorArea"] == pytest.approx(23.91)
    assert spaces["garden"].PredefinedType == "EXTERNAL"


def test_identities_are_unique_and_the_file_is_the_same_tomorrow() -> None:
    identities = [one.GlobalId for one in building("family").by_type("IfcRoot")]
    assert len(identities) == len(set(identities)) > 400
    again = written_as(homes.described("own"), ExportSettings("ifc"))
    assert again == written("own")
    assert b"'1980-01-01T00:00:00'" in again["house.ifc"]
