"""Walls, doors and holes of buildings in IFC belong to the storey on which they are, whichever holds the wall."""

from __future__ import annotations

from typing import Any

import ifcopenshell.api.root
import pytest

from solver.answers import PlanImport
from solver.errors import FieldError
from tests.imports.plans import read
from tests.imports.test_ifc_furniture import Building, Corner, corners_of, shell

FLOORS = (0.0, 3.0)
ROOMS = (((0.0, 0.0), (4.0, 4.0)), ((0.0, 4.1), (4.0, 8.1)))
"""Two rooms on each storey, 10 cm apart."""


class Storeys(Building):
    """Two storeys of two rooms, each with an outer wall; what is added says which storey holds it."""

    def __init__(self) -> None:
        super().__init__()
        for one in self.file.by_type("IfcSpace"):
            self.file.remove(one)
        self.storeys = [ifcopenshell.api.root.create_entity(self.file, "IfcBuildingStorey", name=f"{at}") for at in FLOORS]
        for storey, floor in zip(self.storeys, FLOORS, strict=True):
            storey.Elevation = floor
            storey.ObjectPlacement = self.file.create_entity("IfcLocalPlacement", None, self._axes((0.0, 0.0, floor)))
            for (west, south), (east, north) in ROOMS:
                space = self.box("IfcSpace", (west, south, floor), (east, north, floor + 2.5))
                self._relate("IfcRelAggregates", storey, [space])
        for at, floor in enumerate(FLOORS):
            self.box("IfcWall", (-0.1, 0.0, floor), (0.0, 8.1, floor + 2.5), at)

    def _axes(self, at: Corner) -> Any:
        return self.file.create_entity("IfcAxis2Placement3D", self.file.create_entity("IfcCartesianPoint", at))

    def box(self, kind: str, low: Corner, high: Corner, storey: int | None = None) -> Any:
        self.add(kind, kind, [shell(self.file, corners_of(low, high), "IfcFacetedBrep")])
        made = self.file.by_type(kind)[-1]
        if storey is not None:
            self._relate("IfcRelContainedInSpatialStructure", [made], self.storeys[storey])
        return made

    def hole(self, of: Any, low: Corner, high: Corner, filled_by: Any = None) -> None:
        hole = self.box("IfcOpeningElement", low, high)
        self._relate("IfcRelVoidsElement", of, hole)
        if filled_by is not None:
            self._relate("IfcRelFillsElement", hole, filled_by)

    def _relate(self, kind: str, one: Any, other: Any) -> None:
        self.file.create_entity(kind, str(len(list(self.file))).zfill(22), None, None, None, one, other)

    def read(self, level: int) -> PlanImport:
        return read(self.file.to_string().encode(), "storeys.ifc", level=level)


def openings(made: PlanImport) -> set[str]:
    return {one.kind for room in made.scene.rooms for one in room.openings}


def test_a_wall_that_the_storey_below_holds_divides_rooms_and_its_door_is_on_the_doors_storey() -> None:
    home = Storeys()
    wall = home.box("IfcWall", (0.0, 4.0, 2.6), (4.0, 4.1, 5.5), storey=0)
    door = home.box("IfcDoor", (1.0, 4.0, 3.0), (1.9, 4.1, 5.1), storey=1)
    home.hole(wall, (1.0, 4.0, 3.0), (1.9, 4.1, 5.1), door)
    above = home.read(1)
    assert openings(above) == {"door"} and not any("wall" in one["reason"] for one in above.unread)
    assert openings(home.read(0)) == {"passage"}, "what begins above people's heads divides no rooms"


def test_a_wall_through_two_storeys_divides_the_rooms_of_both() -> None:
    home = Storeys()
    wall = home.box("IfcWall", (0.0, 4.0, 0.0), (4.0, 4.1, 5.5), storey=0)
    home.hole(wall, (1.0, 4.0, 0.0), (1.9, 4.1, 2.1))
    assert openings(home.read(0)) == {"passage"}
    assert openings(home.read(1)) == set()


def test_a_hole_in_what_is_no_wall_is_no_opening() -> None:
    home = Storeys()
    home.box("IfcWall", (0.0, 4.0, 0.0), (4.0, 4.1, 2.5), storey=0)
    cabinet = home.box("IfcFurniture", (1.0, 3.4, 0.0), (1.9, 4.0, 2.1), storey=0)
    home.hole(cabinet, (1.1, 3.5, 0.0), (1.8, 4.0, 2.0))
    made = home.read(0)
    assert openings(made) == set()
    assert not any("hole" in one["reason"] for one in made.unread)
    assert {type(piece.y) for room in made.scene.rooms for piece in room.furniture} == {float}, "numpy's numbers are written otherwise"


def test_a_building_of_a_schema_that_is_not_read_is_told_its_name_and_which_are() -> None:
    content = str(ifcopenshell.file(schema="IFC4").to_string()).replace("IFC4", "IFC4X1")
    with pytest.raises(FieldError, match=r"IFC of the schema IFC4X1; read are IFC2X3, IFC4\b"):
        read(content.encode(), "house.ifc")
