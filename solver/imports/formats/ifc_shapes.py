"""The shapes of IFC that plans need: extruded profiles and flat faces, as their corners in the building.

Placements are 4 x 4 matrices.
"""

from collections.abc import Iterator, Sequence
from importlib import import_module
from itertools import product
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.errors import FieldError
from solver.geometry import doubled_area, edges_round
from solver.imports.drawn import Spot, Tally

Matrix = NDArray[np.float64]
DEEPEST: Final = 8
"""How deep mapped and clipped shapes are followed."""
MOST_PLACEMENTS: Final = 50_000
MOST_ITEMS: Final = 50_000
MOST_SHAPE_POINTS: Final = 200_000
"""Points, faces and their corners of all shapes: each as often as an element has it."""
SHAPES: Final = ("Body", "FootPrint", "Axis", None)
"""Which representation is looked at, in order."""


SHELLS: Final = {
    "IfcFacetedBrep": "Outer", "IfcFacetedBrepWithVoids": "Outer", "IfcFaceBasedSurfaceModel": "FbsmFaces",
    "IfcShellBasedSurfaceModel": "SbsmBoundary",
}  # fmt: skip
"""Shapes made of faces, and what each calls its shells."""


_Part = tuple[Matrix | None, Matrix, Sequence[Matrix]]


class IfcOutline(NamedTuple):
    """A shape: the corners (x, y) of its outline seen from above, all its points (x, y, z), and its faces, where it is made of some."""

    footprint: list[tuple[float, float]]
    points: Matrix
    faces: Sequence[Matrix] = ()

    def middle_line(self, frame: Matrix) -> tuple[tuple[float, float], tuple[float, float], float]:
        """Returns a wall's middle line, from end to end, and its thickness: the shorter side of its footprint in its own frame."""
        along, across = frame[:2, 0] / np.linalg.norm(frame[:2, 0]), frame[:2, 1] / np.linalg.norm(frame[:2, 1])
        lengths, widths = self.points[:, :2] @ along, self.points[:, :2] @ across
        if np.ptp(lengths) < np.ptp(widths):
            along, across, lengths, widths = across, along, widths, lengths
        middle = (widths.min() + widths.max()) / 2 * across
        start, end = lengths.min() * along + middle, lengths.max() * along + middle
        return (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), float(np.ptp(widths))

    def sliced(self, height: float) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
        """Yields the lines in which a level plane cuts the faces."""
        for face in self.faces:
            following = np.roll(face, -1, axis=0)
            cut = (face[:, 2] > height) != (following[:, 2] > height)
            start, end = face[cut], following[cut]
            spots = start + ((height - start[:, 2]) / (end[:, 2] - start[:, 2]))[:, None] * (end - start)
            ordered = [(float(x), float(y)) for x, y in spots[np.lexsort(spots.T)][:, :2]]
            yield from zip(ordered[::2], ordered[1::2], strict=True)

    def along_wall(self, wall: Matrix) -> tuple[tuple[float, float], tuple[float, float], float, float]:
        """Returns a hole's ends on the middle of its depth along its wall, whose way is said, its lower edge and its height."""
        along = wall / np.linalg.norm(wall)
        across = np.asarray((-along[1], along[0]))
        lengths, depths = self.points[:, :2] @ along, self.points[:, :2] @ across
        middle = (depths.min() + depths.max()) / 2 * across
        start, end = lengths.min() * along + middle, lengths.max() * along + middle
        low, high = self.points[:, 2].min(), self.points[:, 2].max()
        return (float(start[0]), float(start[1])), (float(end[0]), float(end[1])), float(low), float(high - low)


class IfcBox(NamedTuple):
    """The box around a shape, along its element's own axes: its middle's place in the building at its underside, its sizes."""

    foot: Matrix
    sizes: tuple[float, float, float]


class IfcShapes:
    """Places and shapes of one file's elements, counted while they are read: many elements may share what is large."""

    def __init__(self, tally: Tally) -> None:
        self._tally = tally
        self._placed: dict[int, Matrix] = {}
        self._boxes: dict[int, Matrix] = {}
        self._maps: dict[int, Matrix] = {}

    def world_of(self, element: Any) -> Matrix:
        """Returns where an element is in the building.

        Raises:
            FieldError: placements stand upon one another in a ring, or are more than in any plan.
        """
        ahead, placement = [], element.ObjectPlacement
        while placement is not None and placement.id() not in self._placed:
            self._tally.add("placements", 1, MOST_PLACEMENTS)
            ahead.append(placement)
            placement = placement.PlacementRelTo
        found: Matrix = np.eye(4) if placement is None else self._placed[placement.id()]
        for one in reversed(ahead):
            found = found @ _axes(one.RelativePlacement)
            self._placed[one.id()] = found
        return found

    def solid_of(self, element: Any) -> IfcOutline | None:
        """Returns an element's shape; None where it is none that is understood.

        Raises:
            FieldError: there are more items or points in shapes than in any plan.
        """
        shapes = element.Representation.Representations if element.Representation else ()
        self._tally.add("items of shapes", len(shapes), MOST_ITEMS)
        ordered = sorted(
            shapes, key=lambda shape: SHAPES.index(shape.RepresentationIdentifier if shape.RepresentationIdentifier in SHAPES else None)
        )
        for shape in ordered:
            for outline, points, faces in self._all(shape.Items, self.world_of(element), 0):
                if outline is not None:
                    return IfcOutline([(float(x), float(y)) for x, y, _ in outline], points, faces)
        return None

    def box_of(self, element: Any) -> IfcBox | None:
        """Returns the box around an element's body; None where nothing of it is understood.

        Raises:
            FieldError: there are more items or points in shapes than in any plan.
        """
        shapes = element.Representation.Representations if element.Representation else ()
        bodies = [item for shape in shapes if shape.RepresentationIdentifier == "Body" for item in shape.Items]
        corners = [self._corners(item) for item in bodies]
        points = np.vstack([np.empty((0, 3)), *corners])
        if not len(points):
            return None
        low, high = points.min(axis=0), points.max(axis=0)
        foot = _moved(np.asarray([((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2])]), self.world_of(element))[0]
        width, depth, height = (high - low).tolist()
        return IfcBox(foot, (width, depth, height))

    def _corners(self, item: Any) -> Matrix:
        """Returns points around which the box is the same as around an item; of one that many elements share they are read once."""
        if item.is_a("IfcMappedItem"):
            source = item.MappingSource
            if source.id() not in self._boxes:
                self._boxes[source.id()] = _box_around(
                    [points for _, points, _ in self._all(source.MappedRepresentation.Items, np.eye(4), 1)]
                )
            return _moved(self._boxes[source.id()], self._mapped(item))
        return _box_around([points for _, points, _ in self._all((item,), np.eye(4), 0)])

    def _all(self, items: Sequence[Any], frame: Matrix, depth: int) -> Iterator[_Part]:
        self._tally.add("items of shapes", len(items), MOST_ITEMS)
        for item in items:
            yield from self._outlines(item, frame, depth)

    def _outlines(self, item: Any, frame: Matrix, depth: int) -> Iterator[_Part]:
        """Yields an item's outline at its foot, None where it has no flat one, all its points, and the faces that it is made of."""
        if depth > DEEPEST:
            return
        if item.is_a("IfcMappedItem"):
            inner = frame @ self._mapped(item)
            yield from self._all(item.MappingSource.MappedRepresentation.Items, inner, depth + 1)
        elif item.is_a("IfcBooleanResult"):
            yield from self._outlines(item.FirstOperand, frame, depth + 1)
        elif item.is_a("IfcExtrudedAreaSolid"):
            yield from self._extruded(item, frame)
        elif item.is_a() in SHELLS:
            shells = getattr(item, SHELLS[item.is_a()])
            shells = shells if isinstance(shells, tuple) else (shells,)
            faces = [face for shell in shells for face in self._counted(shell.CfsFaces)]
            yield from _faced([self._loop(face.Bounds[0].Bound) for face in faces], frame)
        elif item.is_a("IfcTriangulatedFaceSet"):
            yield from self._indexed(item, self._counted(item.CoordIndex), frame)
        elif item.is_a("IfcPolygonalFaceSet"):
            yield from self._indexed(item, [self._counted(face.CoordIndex) for face in self._counted(item.Faces)], frame)
        elif item.is_a("IfcGeometricSet"):
            for element in self._counted(item.Elements):
                curve = self._curve(element) if element.is_a("IfcBoundedCurve") else None
                if curve is not None and len(curve) > 2:
                    flat = _moved(curve, frame)
                    yield flat, flat, ()

    def _indexed(self, item: Any, faces: Sequence[Sequence[int]], frame: Matrix) -> Iterator[_Part]:
        corners = np.asarray(self._counted(item.Coordinates.CoordList), dtype=np.float64)
        return _faced([corners[[at - 1 for at in face]] for face in faces], frame)

    def _mapped(self, item: Any) -> Matrix:
        """Returns how a mapped item lies in what it is an item of; of one that is named often it is read once."""
        if item.id() not in self._maps:
            self._maps[item.id()] = np.asarray(_util().get_mappeditem_transformation(item))
        return self._maps[item.id()]

    def _counted(self, parts: Sequence[Any]) -> Sequence[Any]:
        self._tally.add("points of shapes", len(parts), MOST_SHAPE_POINTS)
        return parts

    def _extruded(self, item: Any, frame: Matrix) -> Iterator[_Part]:
        profile = self._profile(item.SweptArea)
        if profile is None:
            return
        if item.Position is not None:
            frame = frame @ _axes(item.Position)
        way = np.asarray(item.ExtrudedDirection.DirectionRatios, dtype=np.float64)
        way = way / _length(way, item.ExtrudedDirection) * item.Depth
        foot, head = _moved(profile, frame), _moved(profile + way, frame)
        yield foot, np.vstack([foot, head]), ()

    def _loop(self, loop: Any) -> Matrix:
        points = self._counted(getattr(loop, "Polygon", ()))
        return np.asarray([point.Coordinates for point in points], dtype=np.float64).reshape(-1, 3)

    def _profile(self, area: Any) -> Matrix | None:
        """Returns the corners of a profile in its plane, z 0."""
        if area.is_a("IfcRectangleProfileDef"):
            return _rectangle(area)
        return self._curve(area.OuterCurve) if area.is_a("IfcArbitraryClosedProfileDef") else None

    def _curve(self, curve: Any) -> Matrix | None:
        """Returns a curve's points, z 0 where they have none, the last left out where it is the first again."""
        if curve.is_a("IfcPolyline"):
            points = [point.Coordinates for point in self._counted(curve.Points)]
        elif curve.is_a("IfcIndexedPolyCurve"):
            points = list(self._counted(curve.Points.CoordList))
        else:
            return None
        found = np.asarray([(*point, 0.0)[:3] if len(point) < 3 else point for point in points], dtype=np.float64)
        return found[:-1] if len(found) > 3 and np.allclose(found[0], found[-1]) else found


def _util() -> Any:
    return import_module("ifcopenshell.util.placement")


def _axes(placement: Any) -> Matrix:
    """Returns a placement's frame; refuses axes that have no length, or are one."""
    with np.errstate(invalid="ignore", divide="ignore"):
        found = np.asarray(_util().get_axis2placement(placement), dtype=np.float64)
    if not np.isfinite(found).all():
        raise FieldError(f"#{placement.id()}", "is a placement without a direction", "axes that have a length and are not one")
    return found


def _length(way: Matrix, said: Any) -> float:
    """Returns the length of a direction; refuses one that has none."""
    length = float(np.linalg.norm(way))
    if not 0 < length < np.inf:
        raise FieldError(f"#{said.id()}", "is a direction without a length", "numbers that are not all 0")
    return length


def _box_around(parts: Sequence[Matrix]) -> Matrix:
    """Returns the corners of the box around points; none where there are none."""
    points = np.vstack([np.empty((0, 3)), *parts])
    return np.asarray(list(product(*zip(points.min(axis=0), points.max(axis=0), strict=True)))) if len(points) else points


def _faced(faces: Sequence[Matrix], frame: Matrix) -> Iterator[_Part]:
    """Yields the outline of the lowest flat faces of a shape made of faces, None where none lies flat, all its points, and its faces."""
    moved = [_moved(face, frame) for face in faces if len(face) > 2]
    if moved:
        points = np.vstack(moved)
        tall = float(np.ptp(points[:, 2])) or 1.0
        flat = [face for face in moved if np.ptp(face[:, 2]) < 1e-3 * tall]
        heights = [round(float(face[0, 2]) / tall, 3) for face in flat]
        yield _around([face for face, height in zip(flat, heights, strict=True) if height == min(heights)]), points, moved


def _around(faces: Sequence[Matrix]) -> Matrix | None:
    """Returns the outline of flat faces that meet at sides, as the triangles of one floor do: the largest ring of all other sides."""
    spots = {(round(float(x), 3), round(float(y), 3)): (x, y, z) for face in faces for x, y, z in face.tolist()}
    sides: dict[tuple[Spot, Spot], None] = {}
    for face in faces:
        ring = [(round(float(x), 3), round(float(y), 3)) for x, y, _ in face]
        for a, b in edges_round(ring if doubled_area(ring) > 0 else ring[::-1]):
            if (b, a) in sides:
                del sides[b, a]
            else:
                sides[a, b] = None
    after = dict(iter(sides))
    rings = []
    while after:
        ring = [next(iter(after))]
        while (spot := after.pop(ring[-1], None)) is not None and spot != ring[0]:
            ring.append(spot)
        rings.append(ring)
    largest = max(rings, key=lambda ring: doubled_area(ring) if len(ring) > 2 else 0.0, default=None)
    return None if largest is None else np.asarray([spots[spot] for spot in largest])


def _moved(points: Matrix, frame: Matrix) -> Matrix:
    found: Matrix = points @ frame[:3, :3].T + frame[:3, 3]
    return found


def _rectangle(area: Any) -> Matrix:
    x, y = area.XDim / 2, area.YDim / 2
    corners = np.asarray([(-x, -y, 0.0), (x, -y, 0.0), (x, y, 0.0), (-x, y, 0.0)])
    if area.Position is None:
        return corners
    (cx, cy), way = area.Position.Location.Coordinates[:2], (1.0, 0.0)
    if area.Position.RefDirection is not None:
        way = area.Position.RefDirection.DirectionRatios[:2]
    length = _length(np.asarray(way), area.Position)
    c, s = way[0] / length, way[1] / length
    placed: Matrix = corners @ np.asarray([(c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)]) + np.asarray([cx, cy, 0.0])
    return placed
