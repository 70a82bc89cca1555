"""IFC as programmes of all sorts write walls: all in their storey's frame, or all as one shape of faces, without any space."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import ifcopenshell
import pytest

from solver.answers import PlanImport
from tests.imports.plans import floor_area, read

Point = tuple[float, float]
OUTER = [(0, 0), (8000, 0), (8000, 5000), (0, 5000)]
WALLS: dict[str, list[Point]] = {
    "south": [(0, 0), (8000, 0), (8000, 300), (0, 300)], "north": [(0, 4700), (8000, 4700), (8000, 5000), (0, 5000)],
    "west": [(0, 300), (300, 300), (300, 4700), (0, 4700)], "east": [(7700, 300), (8000, 300), (8000, 4700), (7700, 4700)],
    "inner": [(4000, 300), (4100, 300), (4100, 4700), (4000, 4700)],
}  # fmt: skip
"""Footprints, mm: rooms of 3.7 x 4.4 and 3.6 x 4.4 m."""
HOLES: dict[str, tuple[list[Point], float, float, str]] = {
    "inner": ([(4000, 1000), (4100, 1000), (4100, 1900), (4000, 1900)], 0, 2100, "IfcDoor"),
    "west": ([(0, 2000), (300, 2000), (300, 2900), (0, 2900)], 0, 2100, "IfcDoor"),
    "east": ([(7700, 2000), (8000, 2000), (8000, 2250), (7700, 2250)], 900, 1200, "IfcWindow"),
}
"""Holes in walls, how high they begin and are, what fills them: the window is narrower than its wall is thick."""


class Building:
    """A file with one storey, 2 m above the ground."""

    def __init__(self) -> None:
        self.file: Any = ifcopenshell.file(schema="IFC4")
        self.create = self.file.create_entity
        self.frame = self.create("IfcLocalPlacement", None, self.axes())
        length = self.create("IfcSIUnit", None, "LENGTHUNIT", "MILLI", "METRE")
        context = self.create("IfcGeometricRepresentationContext", None, "Model", 3, 1e-5, self.axes(), None)
        self.context = context
        project = self.create(
            "IfcProject", self.id(), RepresentationContexts=[context], UnitsInContext=self.create("IfcUnitAssignment", [length])
        )
        placed = self.create("IfcLocalPlacement", None, self.axes((0, 0, 2000)))
        self.storey = self.create("IfcBuildingStorey", self.id(), Name="EG", ObjectPlacement=placed, Elevation=2000.0)
        self.create("IfcRelAggregates", self.id(), RelatingObject=project, RelatedObjects=[self.storey])

    def id(self) -> str:
        return str(ifcopenshell.guid.new())

    def point(self, *at: float) -> Any:
        return self.create("IfcCartesianPoint", tuple(map(float, at)))

    def axes(self, at: Sequence[float] = (0, 0, 0)) -> Any:
        return self.create("IfcAxis2Placement3D", self.point(*at))

    def add(self, kind: str, shape: Any, name: str) -> Any:
        body = self.create("IfcShapeRepresentation", self.context, "Body", "SweptSolid", [shape])
        made = self.create(
            kind, self.id(), Name=name, ObjectPlacement=self.storey.ObjectPlacement,
            Representation=self.create("IfcProductDefinitionShape", None, None, [body]),
        )  # fmt: skip
        if not made.is_a("IfcOpeningElement"):
            self.create("IfcRelContainedInSpatialStructure", self.id(), RelatedElements=[made], RelatingStructure=self.storey)
        return made

    def prism(self, points: Sequence[Point], low: float, height: float) -> Any:
        line = self.create("IfcPolyline", [self.point(*at) for at in (*points, points[0])])
        area = self.create("IfcArbitraryClosedProfileDef", "AREA", None, line)
        return self.create(
            "IfcExtrudedAreaSolid", area, self.axes((0, 0, low)), self.create("IfcDirection", (0.0, 0.0, 1.0)), float(height)
        )

    def faces(self, parts: Sequence[tuple[Sequence[Point], float, float]]) -> Any:
        """One shape of flat faces: boxes, each from a height to another."""
        found = []
        for points, low, high in parts:
            sides = [[(*a, low), (*b, low), (*b, high), (*a, high)] for a, b in pairwise((*points, points[0]))]
            for corners in ([(*at, low) for at in points], [(*at, high) for at in points], *sides):
                loop = self.create("IfcPolyLoop", [self.point(*at) for at in corners])
                found.append(self.create("IfcFace", [self.create("IfcFaceOuterBound", loop, True)]))
        return self.create("IfcFacetedBrep", self.create("IfcClosedShell", found))

    def triangles(self, points: Sequence[Point], cut: Sequence[tuple[int, int, int]], height: float) -> Any:
        """One shape of triangles: of its foot, of its head, two of each side; each says its own corners, as some programmes write them."""
        foot, head = [(*at, 0.0) for at in points], [(*at, height) for at in points]
        faces = [[foot[at] for at in reversed(three)] for three in cut] + [[head[at] for at in three] for three in cut]
        for a in range(len(points)):
            b = (a + 1) % len(points)
            faces += [[foot[a], foot[b], head[b]], [foot[a], head[b], head[a]]]
        corners = self.create("IfcCartesianPointList3D", [tuple(map(float, at)) for face in faces for at in face])
        index = [(at, at + 1, at + 2) for at in range(1, 3 * len(faces), 3)]
        return self.create("IfcTriangulatedFaceSet", corners, None, True, index)

    def read(self) -> PlanImport:
        return read(self.file.to_string().encode(), "plan.ifc")


def seen(answer: PlanImport) -> list[tuple[float, float, list[tuple[str, float]]]]:
    inner = answer.scene.wall_thickness
    return [
        (round(room.width - inner, 3), round(room.depth - inner, 3), sorted((one.kind, one.width) for one in room.openings))
        for room in sorted(answer.scene.rooms, key=lambda room: room.x)
    ]


WANTED = [(3.7, 4.4, [("door", 0.9), ("door", 0.9)]), (3.6, 4.4, [("door", 0.9), ("window", 0.25)])]


@pytest.mark.parametrize("shape", ["prism", "faces"])
def test_walls_in_their_storeys_frame_tell_which_way_their_holes_go(shape: str) -> None:
    building = Building()
    for name, points in WALLS.items():
        body = building.prism(points, 0, 2700) if shape == "prism" else building.faces([(points, 0, 2700)])
        wall = building.add("IfcWall", body, name)
        if name in HOLES:
            outline, low, height, kind = HOLES[name]
            hole = building.add("IfcOpeningElement", building.prism(outline, low, height), name)
            building.create("IfcRelVoidsElement", building.id(), RelatingBuildingElement=wall, RelatedOpeningElement=hole)
            filled = building.add(kind, building.prism(outline, low, height), name)
            building.create("IfcRelFillsElement", building.id(), RelatingOpeningElement=hole, RelatedBuildingElement=filled)
    assert seen(building.read()) == WANTED


def test_walls_that_are_one_shape_enclose_rooms_where_they_are_cut_a_metre_above_the_floor() -> None:
    """The window's hole is there above its sill, its lintel and the doors' are not."""
    building = Building()
    parts: list[tuple[list[Point], float, float]] = []
    for name, points in WALLS.items():
        if name not in HOLES:
            parts.append((points, 0, 2700))
            continue
        outline, low, height, kind = HOLES[name]
        parts += [(points[:2] + outline[1::-1], 0, 2700), (outline[3:1:-1] + points[2:], 0, 2700), (outline, low + height, 2700)]
        parts += [(outline, 0, low)] if low else []
        (x0, y0), (x1, _) = outline[0], outline[1]
        made = building.add(kind, building.prism(outline, low, height), name)
        made.ObjectPlacement = building.create(
            "IfcLocalPlacement", building.storey.ObjectPlacement,
            building.create("IfcAxis2Placement3D", building.point((x0 + x1) / 2, y0, low), building.create("IfcDirection", (0.0, 0.0, 1.0)),
                            building.create("IfcDirection", (0.0, 1.0, 0.0))),
        )  # fmt: skip
        made.OverallWidth, made.OverallHeight = outline[2][1] - y0, height
    building.add("IfcWall", building.faces(parts), "all")
    assert seen(building.read()) == WANTED


def test_a_space_whose_floor_is_many_triangles_is_the_room_that_they_make() -> None:
    building = Building()
    outline = [(0.0, 0.0), (5000.0, 0.0), (5000.0, 2500.0), (2500.0, 2500.0), (2500.0, 4000.0), (0.0, 4000.0)]
    cut = [(0, 1, 3), (1, 2, 3), (3, 4, 0), (4, 5, 0)]
    building.add("IfcSpace", building.triangles(outline, cut, 2500), "Wohnen")
    (room,) = building.read().scene.rooms
    assert (room.width, room.depth, floor_area(room.outline or ())) == (5.0, 4.0, 5.0 * 2.5 + 2.5 * 1.5)
