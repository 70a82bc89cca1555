"""What IFC files are put together from: placements, solids in their colours, property sets, and identities that never change.

Its frame: x east, y north, z up, m; turns keep their value. A part's (x, y, z) is (x, -z, y) here.
"""

import hashlib
import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, Final

from solver.body_parts import BodyPart
from solver.exports.model import Paint
from solver.exports.paints import srgb
from solver.exports.solid_meshes import surface_of
from solver.exports.step_file import Entity, StepFile, value_of

LABEL: Final = 255
"""How many letters an IfcLabel has at most, such as a name."""
_ROUND: Final = 6
"""Decimals of a metre that are written."""


class IfcPieces:
    """Makes the entities of one empty file of IFC4; `house`, part of every identity, tells it from others."""

    def __init__(self, file: StepFile, house: str) -> None:
        import ifcopenshell.guid  # noqa: PLC0415 (an extra)

        self.new, self._house, self._compress = file.new, house, ifcopenshell.guid.compress
        self._styles: dict[Paint, Entity] = {}
        self._points: dict[tuple[float, ...], Entity] = {}
        self._directions: dict[tuple[float, ...], Entity] = {}
        self.body = self._contexts()

    def _contexts(self) -> Entity:
        world = self.new("IfcAxis2Placement3D", Location=self.point(0.0, 0.0, 0.0))
        self.model = self.new(
            "IfcGeometricRepresentationContext",
            ContextType="Model",
            CoordinateSpaceDimension=3,
            Precision=1e-5,
            WorldCoordinateSystem=world,
        )
        return self.new(
            "IfcGeometricRepresentationSubContext",
            ContextIdentifier="Body",
            ContextType="Model",
            ParentContext=self.model,
            TargetView="MODEL_VIEW",
        )

    def rooted(self, kind: str, role: str, identity: str, **fields: Any) -> Entity:
        """Returns a new entity with an identity, the same for the same house, role and id."""
        said = f"{self._house}\n{role}\n{identity}".encode("utf-8", "replace")
        return self.new(kind, GlobalId=self._compress(hashlib.md5(said, usedforsecurity=False).hexdigest()), **fields)

    def point(self, *at: float) -> Entity:
        """Returns a point, m."""
        key = tuple(round(value, _ROUND) + 0.0 for value in at)
        if key not in self._points:
            self._points[key] = self.new("IfcCartesianPoint", Coordinates=key)
        return self._points[key]

    def direction(self, *towards: float) -> Entity:
        """Returns a direction."""
        key = tuple(round(value, 9) + 0.0 for value in towards)
        if key not in self._directions:
            self._directions[key] = self.new("IfcDirection", DirectionRatios=key)
        return self._directions[key]

    def axes(self, at: Sequence[float], turn: float = 0.0) -> Entity:
        """Returns a frame at a point, turned about z, degrees."""
        angle = math.radians(turn)
        along = self.direction(math.cos(angle), math.sin(angle), 0.0) if turn else None
        up = self.direction(0.0, 0.0, 1.0) if turn else None
        return self.new("IfcAxis2Placement3D", Location=self.point(*at), Axis=up, RefDirection=along)

    def placed(self, within: Entity | None, at: Sequence[float], turn: float = 0.0) -> Entity:
        """Returns the placement of a product within another's."""
        return self.new("IfcLocalPlacement", PlacementRelTo=within, RelativePlacement=self.axes(at, turn))

    def prism(self, corners: Sequence[tuple[float, float]], low: float, height: float) -> Entity:
        """Returns the solid over a polygon of the plan, m."""
        points = [self.point(*corner) for corner in (*corners, corners[0])]
        curve = self.new("IfcPolyline", Points=points)
        profile = self.new("IfcArbitraryClosedProfileDef", ProfileType="AREA", OuterCurve=curve)
        return self._extruded(profile, (0.0, 0.0, low), height)

    def block(self, size: tuple[float, float, float], at: tuple[float, float, float]) -> Entity:
        """Returns a box by its extents along x, y, z and the middle of its underside, m."""
        position = self.new("IfcAxis2Placement2D", Location=self.point(0.0, 0.0))
        profile = self.new(
            "IfcRectangleProfileDef", ProfileType="AREA", Position=position, XDim=round(size[0], _ROUND), YDim=round(size[1], _ROUND)
        )
        return self._extruded(profile, at, size[2])

    def _extruded(self, profile: Entity, at: Sequence[float], height: float) -> Entity:
        up = self.direction(0.0, 0.0, 1.0)
        return self.new(
            "IfcExtrudedAreaSolid", SweptArea=profile, Position=self.axes(at), ExtrudedDirection=up, Depth=round(height, _ROUND)
        )

    def solid(self, part: BodyPart) -> Entity:
        """Returns a part: boxes and upright cylinders as extrusions, what is round otherwise as triangles."""
        (width, height, depth), (x, y, z) = part.size, part.at
        foot = (x, -z, y - height / 2)
        if part.form in ("box", "rounded"):
            return self.block((width, depth, height), foot)
        if part.form == "cylinder" and part.axis == "y" and part.taper == 1:
            return self._extruded(self._round_profile(width / 2, depth / 2), foot, height)
        points, triangles = _triangles(part)
        listed = self.new("IfcCartesianPointList3D", CoordList=points)
        return self.new("IfcTriangulatedFaceSet", Coordinates=listed, Closed=True, CoordIndex=triangles)

    def _round_profile(self, a: float, b: float) -> Entity:
        position = self.new("IfcAxis2Placement2D", Location=self.point(0.0, 0.0))
        if abs(a - b) < 1e-6:
            return self.new("IfcCircleProfileDef", ProfileType="AREA", Position=position, Radius=round(a, _ROUND))
        return self.new(
            "IfcEllipseProfileDef", ProfileType="AREA", Position=position, SemiAxis1=round(a, _ROUND), SemiAxis2=round(b, _ROUND)
        )

    def painted(self, item: Entity, paint: Paint) -> Entity:
        """Returns a solid after giving it a colour."""
        if paint not in self._styles:
            red, green, blue = (round(share, 4) for share in srgb(paint.color))
            color = self.new("IfcColourRgb", Red=red, Green=green, Blue=blue)
            shown = self.new(
                "IfcSurfaceStyleRendering", SurfaceColour=color, Transparency=round(1 - paint.opacity, 4), ReflectanceMethod="NOTDEFINED"
            )
            self._styles[paint] = self.new("IfcSurfaceStyle", Side="BOTH", Styles=[shown])
        self.new("IfcStyledItem", Item=item, Styles=[self._styles[paint]])
        return item

    def shape(self, items: Sequence[Entity]) -> Entity:
        """Returns what a product looks like: extrusions, triangles or both."""
        return self.new("IfcProductDefinitionShape", Representations=[self.representation(items)])

    def representation(self, items: Sequence[Entity]) -> Entity:
        """Returns a body's representation, named by what it is made of."""
        kinds = {item.kind for item in items}
        name = {"IfcExtrudedAreaSolid": "SweptSolid", "IfcTriangulatedFaceSet": "Tessellation", "IfcMappedItem": "MappedRepresentation"}
        word = name[kinds.pop()] if len(kinds) == 1 else "SurfaceOrSolidModel"
        return self.new(
            "IfcShapeRepresentation", ContextOfItems=self.body, RepresentationIdentifier="Body", RepresentationType=word, Items=list(items)
        )

    def says(self, product: Entity, role: str, identity: str, title: str, values: Mapping[str, object]) -> None:
        """Gives a product a property set; floats as (measure, value), None left out."""
        properties = [
            self.new("IfcPropertySingleValue", Name=name, NominalValue=self._value(value))
            for name, value in values.items()
            if value is not None
        ]
        made = self.rooted("IfcPropertySet", f"{role} set {title}", identity, Name=title, HasProperties=properties)
        self.rooted(
            "IfcRelDefinesByProperties", f"{role} said {title}", identity, RelatedObjects=[product], RelatingPropertyDefinition=made
        )

    @staticmethod
    def _value(value: object) -> Entity:
        if isinstance(value, tuple):
            return value_of(*value)
        if isinstance(value, bool):
            return value_of("IfcBoolean", value)
        words = str(value)
        return value_of("IfcLabel" if len(words) <= LABEL else "IfcText", printable(words, len(words)))


@lru_cache(maxsize=1 << 11)
def _triangles(part: BodyPart) -> tuple[list[tuple[float, float, float]], list[tuple[int, ...]]]:
    """Returns the points of a part, each once, and its triangles by their numbers from 1, those that are lines left out."""
    surface = surface_of(part)
    points = [(round(a, 5) + 0.0, round(-c, 5) + 0.0, round(b, 5) + 0.0) for a, b, c in surface.points.tolist()]
    numbers = {point: number for number, point in enumerate(dict.fromkeys(points), 1)}
    triangles = [tuple(numbers[points[corner]] for corner in row) for row in surface.triangles.tolist()]
    return list(numbers), [triangle for triangle in triangles if len(set(triangle)) == 3]


def printable(words: str, most: int = LABEL) -> str:
    """Returns words that an IFC file holds and gives back: no half of a pair of surrogates, and `most` letters of names."""
    return words.encode("utf-8", "replace").decode()[:most]
