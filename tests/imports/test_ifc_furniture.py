"""Furniture of buildings in IFC: as large as its shapes are, wherever its own origin lies, called as its family is."""

from __future__ import annotations

from typing import Any

import ifcopenshell
import ifcopenshell.api.context
import ifcopenshell.api.root
import ifcopenshell.api.unit
import pytest

from solver.scene import Furniture
from tests.imports.plans import read

Corner = tuple[float, float, float]
SQUARE = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
"""The faces of a box whose corners are counted along z, y and x."""


def corners_of(low: Corner, high: Corner) -> list[Corner]:
    return [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]


def shell(file: Any, corners: list[Corner], kind: str) -> Any:
    """A box of faces in one of the ways in which programmes write them."""
    if kind == "IfcTriangulatedFaceSet":
        triangles = [(a + 1, b + 1, c + 1) for a, b, c, d in SQUARE] + [(a + 1, c + 1, d + 1) for a, _, c, d in SQUARE]
        return file.create_entity(kind, Coordinates=file.create_entity("IfcCartesianPointList3D", corners), CoordIndex=triangles)
    if kind == "IfcPolygonalFaceSet":
        faces = [file.create_entity("IfcIndexedPolygonalFace", [at + 1 for at in face]) for face in SQUARE]
        return file.create_entity(kind, Coordinates=file.create_entity("IfcCartesianPointList3D", corners), Faces=faces)
    points = [file.create_entity("IfcCartesianPoint", corner) for corner in corners]
    loops = [file.create_entity("IfcPolyLoop", [points[at] for at in face]) for face in SQUARE]
    faces = [file.create_entity("IfcFace", [file.create_entity("IfcFaceOuterBound", loop, Orientation=True)]) for loop in loops]
    match kind:
        case "IfcFacetedBrep":
            return file.create_entity(kind, file.create_entity("IfcClosedShell", faces))
        case "IfcShellBasedSurfaceModel":
            return file.create_entity(kind, [file.create_entity("IfcOpenShell", faces)])
        case _:
            return file.create_entity(
                kind, [file.create_entity("IfcConnectedFaceSet", faces[:3]), file.create_entity("IfcConnectedFaceSet", faces[3:])]
            )


class Building:
    """A room of 5 x 4 m and what stands in it."""

    def __init__(self) -> None:
        self.file: Any = ifcopenshell.file(schema="IFC4")
        ifcopenshell.api.root.create_entity(self.file, "IfcProject")
        ifcopenshell.api.unit.assign_unit(self.file, length={"is_metric": True, "raw": "METERS"})
        self.body = ifcopenshell.api.context.add_context(self.file, context_type="Model")
        profile = self.file.create_entity("IfcRectangleProfileDef", "AREA", None, None, 5.0, 4.0)
        up = self.file.create_entity("IfcDirection", (0.0, 0.0, 1.0))
        self.add("IfcSpace", "1", [self.file.create_entity("IfcExtrudedAreaSolid", profile, None, up, 2.5)], LongName="Living room")

    def add(self, kind: str, name: str, items: list[Any], at: Corner = (0.0, 0.0, 0.0), way: Corner = (1.0, 0.0, 0.0), **more: Any) -> None:
        shape = self.file.create_entity("IfcShapeRepresentation", self.body, "Body", "Brep", items)
        element = ifcopenshell.api.root.create_entity(self.file, kind, name=name)
        element.Representation = self.file.create_entity("IfcProductDefinitionShape", None, None, [shape])
        point, up = self.file.create_entity("IfcCartesianPoint", at), self.file.create_entity("IfcDirection", (0.0, 0.0, 1.0))
        axes = self.file.create_entity("IfcAxis2Placement3D", point, up, self.file.create_entity("IfcDirection", way))
        element.ObjectPlacement = self.file.create_entity("IfcLocalPlacement", None, axes)
        for key, value in more.items():
            setattr(element, key, value)

    def mapped(self, items: list[Any]) -> Any:
        """The same shape as often as it is wanted."""
        shape = self.file.create_entity("IfcShapeRepresentation", self.body, "Body", "Brep", items)
        origin = self.file.create_entity("IfcAxis2Placement3D", self.file.create_entity("IfcCartesianPoint", (0.0, 0.0, 0.0)))
        source = self.file.create_entity("IfcRepresentationMap", origin, shape)
        return lambda: self.file.create_entity(
            "IfcMappedItem", source, self.file.create_entity("IfcCartesianTransformationOperator3D", LocalOrigin=origin.Location)
        )

    def pieces(self) -> list[Furniture]:
        answer = read(str(self.file.to_string()).encode(), "house.ifc")
        (room,) = answer.scene.rooms
        return sorted(room.furniture, key=lambda one: one.id)


KINDS = ("IfcFacetedBrep", "IfcFaceBasedSurfaceModel", "IfcShellBasedSurfaceModel", "IfcPolygonalFaceSet", "IfcTriangulatedFaceSet")


@pytest.mark.parametrize("kind", KINDS)
def test_a_piece_is_as_large_as_its_shapes_and_stands_where_they_do(kind: str) -> None:
    building = Building()
    seat, back = corners_of((0.2, 0.3, 0.0), (2.2, 1.0, 0.4)), corners_of((0.2, 1.0, 0.0), (2.2, 1.2, 0.8))
    building.add("IfcFurniture", "M_Sofa:2000mm:2000mm:167283", [shell(building.file, one, kind) for one in (seat, back)], (0.0, 0.7, 0.0))
    (sofa,) = building.pieces()
    assert (sofa.name, sofa.width, sofa.depth, sofa.height) == ("Sofa", 2.0, 0.9, 0.8)
    assert (sofa.x, sofa.z, sofa.rotation) == (pytest.approx(3.7, abs=0.06), pytest.approx(0.55, abs=0.06), 0.0)


def test_a_family_says_first_what_it_is_and_then_which() -> None:
    building = Building()
    sizes = {"M_Base Cabinet-Double Door & 2 Drawer:1000mm:1000mm:159262": 0.9, "M_Table-Coffee:0610 x 0610mm:167655": 0.4}
    for at, (name, high) in enumerate(sizes.items()):
        building.add(
            "IfcFurniture", name, [shell(building.file, corners_of((0, 0, 0), (1, 0.6, high)), "IfcFacetedBrep")], (at * 1.5 - 1.5, 1, 0)
        )
    table = [shell(building.file, corners_of((0, 0, 0), (1.8, 0.9, 0.75)), "IfcFacetedBrep")]
    building.add("IfcFurniture", "Table_Dining_w-Chairs_Rectangular:1830mm:167656", table, (-1, -1, 0))
    answer = read(str(building.file.to_string()).encode(), "house.ifc")
    names = ["Double Door & 2 Drawer Base Cabinet", "Coffee Table", "Table_Dining with Chairs_Rectangular"]
    assert [one.name for one in answer.scene.rooms[0].furniture] == names
    assert [*answer.understood_as.values()] == ["medium_counter", "coffee_table", "dining_table"]


def test_pieces_of_one_shape_are_each_turned_their_own_way() -> None:
    building = Building()
    again = building.mapped([shell(building.file, corners_of((0.0, 0.0, 0.0), (1.2, 0.6, 0.7)), "IfcFacetedBrep")])
    building.add("IfcFurnishingElement", "desk a", [again()], (-2.3, 1.2, 0.0), ObjectType="Desk")
    building.add("IfcFurnishingElement", "desk b", [again()], (2.35, -1.3, 0.0), (0.0, 1.0, 0.0), ObjectType="Desk")
    first, second = building.pieces()
    for desk in (first, second):
        assert (desk.name, desk.width, desk.depth, desk.height) == ("Desk", 1.2, 0.6, 0.7)
    assert (first.rotation, second.rotation) == (0.0, 90.0)
    assert (second.x, second.z) == (pytest.approx(4.55, abs=0.06), pytest.approx(2.7, abs=0.06))


def test_a_piece_of_more_points_than_any_plan_has_is_told_to_have_no_size() -> None:
    building = Building()
    points = building.file.create_entity("IfcCartesianPointList3D", [(at / 1e6, 0.0, 0.0) for at in range(200_001)])
    building.add("IfcFurniture", "Apparatus", [building.file.create_entity("IfcTriangulatedFaceSet", points, None, None, [(1, 2, 3)])])
    answer = read(str(building.file.to_string()).encode(), "house.ifc")
    assert not answer.scene.rooms[0].furniture
    assert [one["reason"] for one in answer.unread] == ["'Apparatus': the file gives no size"]
