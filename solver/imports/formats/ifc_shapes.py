"""The shapes of IFC that plans need: extruded profiles and flat faces, as their corners in the building.

Comes in: an element of ifcopenshell. Goes out: a `IfcOutline` in the file's unit.
Placements are 4 x 4 matrices. May import: nothing of ours.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
DEEPEST: Final = 8
"""How deep mapped and clipped shapes are followed."""
SHAPES: Final = ("Body", "FootPrint", "Axis", None)
"""Which representation is looked at, in order."""


class IfcOutline(NamedTuple):
    """A shape: the corners (x, y) of its outline seen from above, and all its points (x, y, z)."""

    footprint: list[tuple[float, float]]
    points: Matrix

    def middle_line(self, frame: Matrix) -> tuple[tuple[float, float], tuple[float, float], float]:
        """Returns a wall's middle line, from end to end, and its thickness: the shorter side of its footprint in its own frame."""
        along, across = frame[:2, 0] / np.linalg.norm(frame[:2, 0]), frame[:2, 1] / np.linalg.norm(frame[:2, 1])
        lengths, widths = self.points[:, :2] @ along, self.points[:, :2] @ across
        if np.ptp(lengths) < np.ptp(widths):
            along, across, lengths, widths = across, along, widths, lengths
        middle = (widths.min() + widths.max()) / 2 * across
        start, end = lengths.min() * along + middle, lengths.max() * along + middle
        return (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), float(np.ptp(widths))

    def along_wall(self, wall: Matrix) -> tuple[tuple[float, float], tuple[float, float], float, float]:
        """Returns a hole's ends on the middle of its depth along its wall, its lower edge and its height."""
        along, across = wall[:2, 0] / np.linalg.norm(wall[:2, 0]), wall[:2, 1] / np.linalg.norm(wall[:2, 1])
        lengths, depths = self.points[:, :2] @ along, self.points[:, :2] @ across
        middle = (depths.min() + depths.max()) / 2 * across
        start, end = lengths.min() * along + middle, lengths.max() * along + middle
        low, high = self.points[:, 2].min(), self.points[:, 2].max()
        return (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), float(low), float(high - low)


def world_of(element: Any) -> Matrix:
    """Returns where an element is in the building."""
    placement = element.ObjectPlacement
    if placement is None:
        return np.eye(4)
    found: Matrix = np.asarray(import_module("ifcopenshell.util.placement").get_local_placement(placement), dtype=np.float64)
    return found


def solid_of(element: Any) -> IfcOutline | None:
    """Returns an element's shape; None where it is none that is understood."""
    shapes = element.Representation.Representations if element.Representation else ()
    ordered = sorted(
        shapes, key=lambda shape: SHAPES.index(shape.RepresentationIdentifier if shape.RepresentationIdentifier in SHAPES else None)
    )
    for shape in ordered:
        for item in shape.Items:
            for outline, points in _outlines(item, world_of(element), 0):
                return IfcOutline([(float(x), float(y)) for x, y, _ in outline], points)
    return None


def _outlines(item: Any, frame: Matrix, depth: int) -> Iterator[tuple[Matrix, Matrix]]:
    """Yields an item's outline at its foot and all its points."""
    if depth > DEEPEST:
        return
    if item.is_a("IfcMappedItem"):
        inner = frame @ np.asarray(import_module("ifcopenshell.util.placement").get_mappeditem_transformation(item))
        for mapped in item.MappingSource.MappedRepresentation.Items:
            yield from _outlines(mapped, inner, depth + 1)
    elif item.is_a("IfcBooleanResult"):
        yield from _outlines(item.FirstOperand, frame, depth + 1)
    elif item.is_a("IfcExtrudedAreaSolid"):
        yield from _extruded(item, frame)
    elif item.is_a("IfcManifoldSolidBrep"):
        yield from _faced([_loop(face.Bounds[0].Bound) for face in item.Outer.CfsFaces], frame)
    elif item.is_a("IfcPolygonalFaceSet"):
        corners = np.asarray(item.Coordinates.CoordList, dtype=np.float64)
        yield from _faced([corners[[at - 1 for at in face.CoordIndex]] for face in item.Faces], frame)
    elif item.is_a("IfcGeometricSet"):
        for element in item.Elements:
            curve = _curve(element) if element.is_a("IfcBoundedCurve") else None
            if curve is not None and len(curve) > 2:
                flat = _moved(curve, frame)
                yield flat, flat


def _extruded(item: Any, frame: Matrix) -> Iterator[tuple[Matrix, Matrix]]:
    profile = _profile(item.SweptArea)
    if profile is None:
        return
    if item.Position is not None:
        frame = frame @ np.asarray(import_module("ifcopenshell.util.placement").get_axis2placement(item.Position))
    way = np.asarray(item.ExtrudedDirection.DirectionRatios, dtype=np.float64)
    way = way / np.linalg.norm(way) * item.Depth
    foot, head = _moved(profile, frame), _moved(profile + way, frame)
    yield foot, np.vstack([foot, head])


def _faced(faces: Sequence[Matrix], frame: Matrix) -> Iterator[tuple[Matrix, Matrix]]:
    """Yields the lowest flat face of a shape made of faces."""
    moved = [_moved(face, frame) for face in faces if len(face) > 2]
    if moved:
        points = np.vstack(moved)
        tall = float(np.ptp(points[:, 2])) or 1.0
        flat = [face for face in moved if np.ptp(face[:, 2]) < 1e-3 * tall]
        if flat:
            yield min(flat, key=lambda face: (round(float(face[0, 2]) / tall, 3), -len(face))), points


def _loop(loop: Any) -> Matrix:
    return np.asarray([point.Coordinates for point in getattr(loop, "Polygon", ())], dtype=np.float64).reshape(-1, 3)


def _moved(points: Matrix, frame: Matrix) -> Matrix:
    found: Matrix = points @ frame[:3, :3].T + frame[:3, 3]
    return found


def _profile(area: Any) -> Matrix | None:
    """Returns the corners of a profile in its plane, z 0."""
    if area.is_a("IfcRectangleProfileDef"):
        x, y = area.XDim / 2, area.YDim / 2
        corners = np.asarray([(-x, -y, 0.0), (x, -y, 0.0), (x, y, 0.0), (-x, y, 0.0)])
        if area.Position is None:
            return corners
        (cx, cy), way = area.Position.Location.Coordinates[:2], (1.0, 0.0)
        if area.Position.RefDirection is not None:
            way = area.Position.RefDirection.DirectionRatios[:2]
        length = (way[0] ** 2 + way[1] ** 2) ** 0.5
        c, s = way[0] / length, way[1] / length
        placed: Matrix = corners @ np.asarray([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)]) + np.asarray([cx, cy, 0.0])
        return placed
    return _curve(area.OuterCurve) if area.is_a("IfcArbitraryClosedProfileDef") else None


def _curve(curve: Any) -> Matrix | None:
    """Returns a curve's points, z 0 where they have none, the last left out where it is the first again."""
    if curve.is_a("IfcPolyline"):
        points = [point.Coordinates for point in curve.Points]
    elif curve.is_a("IfcIndexedPolyCurve"):
        points = list(curve.Points.CoordList)
    else:
        return None
    found = np.asarray([(*point, 0.0)[:3] if len(point) < 3 else point for point in points], dtype=np.float64)
    return found[:-1] if len(found) > 3 and np.allclose(found[0], found[-1]) else found
