"""How thick each wall is: the walls that a file draws tell where a room's inner face is, and how deep the wall behind it."""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import numpy as np

from solver.geometry import edges_round, to_m
from solver.imports.drawn import DrawnRoom, DrawnWall, Spot
from solver.imports.joining import THICKEST_JOINED
from solver.imports.rectilinear import PlanEdge, weighted_median
from solver.imports.straighten import NEAR
from solver.imports.wall_faces import line_between

STRAIGHT: Final = 0.02
"""How much a wall may rise over its length to count as one along an axis."""
BESIDE: Final = 5
"""How far beyond its wall's faces an edge may be drawn, mm."""
ALIKE: Final = 10
"""Walls that differ by no more, mm, are as thick as one another."""
LEAST: Final = 100
"""A wall lies along an edge over at least so much, mm."""
THINNEST: Final = 40
THICKEST: Final = 1000
"""What is thinner or thicker, mm, is no wall."""


class WallBand(NamedTuple):
    """A wall along an axis: its middle line, its thickness, and how much of an edge it covers, mm."""

    at: float
    thickness: float
    covered: float


class WallDepths:
    """The walls that a file draws, with their thickness, mm; slanted ones are passed over.

    `faces` are lines along faces of walls: between two of them there is a wall where none of those lies.
    """

    def __init__(self, walls: Sequence[DrawnWall], faces: Sequence[tuple[Spot, Spot]] = ()) -> None:
        bands: dict[str, dict[tuple[float, float, float, float], None]] = defaultdict(dict)  # drawn twice it covers no more
        for wall in walls:
            run = abs(wall.end[0] - wall.start[0]), abs(wall.end[1] - wall.start[1])
            along = 0 if run[0] >= run[1] else 1
            if THINNEST <= wall.thickness <= THICKEST and run[along] > 0 and run[1 - along] <= STRAIGHT * run[along]:
                low, high = sorted((wall.start[along], wall.end[along]))
                bands["xz"[along]][low, high, (wall.start[1 - along] + wall.end[1 - along]) / 2, wall.thickness] = None
        self._bands = {key: np.array(list(found)).T for key, found in bands.items()}
        self._alike = {key: np.unique(np.rint(found[2:]), axis=1, return_inverse=True)[1].ravel() for key, found in self._bands.items()}
        """Which pieces lie in one line and are as thick."""
        lines = [line for a, b in faces if (line := line_between(a, b))]
        self._faces = {axis: np.array([(one.at, one.low, one.high) for one in lines if one.axis == axis]).reshape(-1, 3).T for axis in "xz"}

    def __bool__(self) -> bool:
        return bool(self._bands)

    def behind(self, edge: PlanEdge, at: float) -> WallBand | None:
        """Returns the wall that lies at a coordinate across an edge, its pieces over most of its length; None where there is none."""
        return self._drawn_behind(edge, at) or self._between_faces(edge, at)

    def _between_faces(self, edge: PlanEdge, at: float) -> WallBand | None:
        """Returns what lies between the two faces nearest to a coordinate across an edge that are drawn along most of it."""
        lines, low, high = self._faces[edge.axis]
        places, which = np.unique(lines, return_inverse=True)
        covered = np.bincount(which, np.maximum(np.minimum(high, edge.high) - np.maximum(low, edge.low), 0.0), len(places))
        behind = (places - at) * edge.out
        long = 2 * covered > edge.length
        inner, outer = np.flatnonzero(long & (behind <= BESIDE)), np.flatnonzero(long & (behind > BESIDE))
        if not len(inner) or not len(outer):
            return None
        first, last = inner[behind[inner].argmax()], outer[behind[outer].argmin()]
        thickness = float(abs(places[last] - places[first]))
        if not THINNEST <= thickness <= THICKEST_JOINED:
            return None
        return WallBand(float(places[first] + places[last]) / 2, thickness, float(min(covered[first], covered[last])))

    def _drawn_behind(self, edge: PlanEdge, at: float) -> WallBand | None:
        if edge.axis not in self._bands:
            return None
        low, high, line, thickness = self._bands[edge.axis]
        common = np.minimum(high, edge.high) - np.maximum(low, edge.low)
        common[np.abs(line - at) > thickness / 2 + BESIDE] = 0.0
        alike = self._alike[edge.axis]
        covered = np.bincount(alike, np.maximum(common, 0.0))
        most = int(covered.argmax())
        first = int((alike == most).argmax())
        if covered[most] < min(LEAST, edge.length / 2):
            return None
        return WallBand(float(line[first]), float(thickness[first]), float(covered[most]))

    def face(self, edge: PlanEdge) -> int | None:
        """Returns where the inner face is of the wall that an edge is drawn in; None where it is drawn in none."""
        band = self.behind(edge, edge.at)
        return None if band is None else round(band.at - edge.out * band.thickness / 2)


def faces_behind(edges: Sequence[Sequence[PlanEdge]], depths: WallDepths, usual: int) -> tuple[int, list[list[PlanEdge]] | None]:
    """Returns how thick walls are, mm, and where rooms that are drawn along their lines have their faces.

    None in place of the faces where all lie half that thickness inside of the lines: the rooms may stay as they are drawn. `usual` counts
    where the file draws no wall, mm.
    """
    found = [[depths.face(edge) for edge in room] for room in edges]
    inside = [
        (2 * (edge.at - face) * edge.out, edge.length)
        for room, own in zip(edges, found, strict=True) for edge, face in zip(room, own, strict=True) if face is not None
    ]  # fmt: skip
    if not inside:
        return usual, None
    thickness = max(0, int(weighted_median(inside)))
    if all(abs(twice - thickness) <= ALIKE for twice, _ in inside):
        return thickness, None
    half = thickness // 2
    return thickness, [
        [edge._replace(at=edge.at - edge.out * half if face is None else face) for edge, face in zip(room, own, strict=True)]
        for room, own in zip(edges, found, strict=True)
    ]


def outer_thicknesses(
    rooms: Sequence[DrawnRoom], depths: WallDepths, edges: Sequence[Sequence[PlanEdge]], usual: int
) -> list[tuple[float | None, ...] | None]:
    """Returns for each room how thick its outer walls are where they are not as the usual, m, by its edges; None where all are.

    Rooms say it, else walls as drawn. Edges lie along the lines of walls; `usual` is the scene's thickness, mm.
    """
    facing = FacingEdges(edges)
    found = []
    for room, own in zip(rooms, edges, strict=True):
        sides = _sides_said(room, usual)
        outer = [max(facing.alone(edge), key=lambda one: one[1] - one[0], default=None) for edge in own]
        said = tuple(
            None if one is None else _said(sides, edge) or _own(depths, edge._replace(low=one[0], high=one[1]), usual)
            for edge, one in zip(own, outer, strict=True)
        )
        found.append(said if any(one is not None for one in said) else None)
    return found


def _sides_said(room: DrawnRoom, usual: int) -> list[tuple[tuple[Spot, Spot], int]]:
    """Returns the sides of a room's outline of which it says that their walls are not as thick as the usual, and how thick, mm."""
    said = [(side, round(one)) for side, one in zip(edges_round(room.points), room.outer, strict=False) if one is not None]
    return [(side, one) for side, one in said if THINNEST <= one <= THICKEST and one != usual]


def _said(sides: Sequence[tuple[tuple[Spot, Spot], int]], edge: PlanEdge) -> float | None:
    """Returns how thick the wall of an edge is by the side of the drawn outline that became it, m; None where nothing is said of it."""
    return next((to_m(thickness) for side, thickness in sides if _became(side, edge)), None)


def _became(side: tuple[Spot, Spot], edge: PlanEdge) -> bool:
    """Tells whether a side of a drawn outline lies in an edge that was made of it, straightened."""
    along, across = (0, 1) if edge.axis == "x" else (1, 0)
    middle = [(side[0][axis] + side[1][axis]) / 2 for axis in (0, 1)]
    return abs(middle[across] - edge.at) <= NEAR and edge.low <= middle[along] <= edge.high


def _own(depths: WallDepths, edge: PlanEdge, usual: int) -> float | None:
    face = edge.at - edge.out * usual / 2
    band = depths.behind(edge, face + edge.out * BESIDE)
    if band is None or abs(band.thickness - usual) <= ALIKE:
        band = _hiding(depths, edge)
    elif abs(band.at - edge.out * band.thickness / 2 - face) > ALIKE or band.covered < min(band.thickness, edge.length / 2):
        return None  # another wall, or the end of the one around the corner
    if band is None or abs(band.thickness - usual) <= ALIKE:
        return None
    return to_m(min(1000, round(band.thickness)))


def _hiding(depths: WallDepths, edge: PlanEdge) -> WallBand | None:
    """Returns the wall around a corner between whose faces an edge lies whole: of the edge's own wall nothing is seen there."""
    low, high = sorted((edge.at, edge.at + edge.out * THICKEST_JOINED))
    middle = (edge.low + edge.high) / 2
    band = depths.behind(edge._replace(axis="z" if edge.axis == "x" else "x", low=low, high=high), middle)
    return band if band and edge.length / 2 + abs(band.at - middle) <= band.thickness / 2 else None


class FacingEdges:
    """Edges of rooms, along the lines of their walls, by what they look at across a wall."""

    def __init__(self, edges: Sequence[Sequence[PlanEdge]]) -> None:
        self._edges: dict[tuple[str, int], list[PlanEdge]] = defaultdict(list)
        for edge in (edge for room in edges for edge in room):
            self._edges[edge.axis, edge.out].append(edge)
        for found in self._edges.values():
            found.sort(key=lambda edge: edge.at)
        self._places = {key: [edge.at for edge in found] for key, found in self._edges.items()}

    def across(self, edge: PlanEdge) -> Iterator[tuple[PlanEdge, int]]:
        """Yields the edges of other rooms on the other side of an edge's wall, and how much of it they share, mm."""
        key = edge.axis, -edge.out
        low, high = sorted((edge.at, edge.at + edge.out * THICKEST_JOINED))
        places = self._places.get(key, [])
        for one in self._edges.get(key, [])[bisect_left(places, low) : bisect_right(places, high)]:
            common = min(edge.high, one.high) - max(edge.low, one.low)
            if one.room != edge.room and common > 0:
                yield one, common

    def alone(self, edge: PlanEdge) -> list[tuple[int, int]]:
        """Returns the stretches of an edge that have no other room on the other side of their wall, nor the end of a wall between two."""
        found, at = [], edge.low
        for low, high in sorted((one.low, one.high) for one, _ in self.across(edge)):
            if low - at > (THICKEST_JOINED if at > edge.low else 0):
                found.append((at, low))
            at = max(at, high)
        return [*found, (at, edge.high)] if edge.high > at else found

    def shared(self, edge: PlanEdge) -> int:
        """Returns how much of an edge has other rooms on the other side of its wall, mm, the walls between those included."""
        return edge.length - sum(high - low for low, high in self.alone(edge))
