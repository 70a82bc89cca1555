"""Third step: rooms as they are drawn -> rooms whose walls run along x and z, in whole mm.

Runs of nearly straight edges are moved, never single corners: runs of all rooms that lie within 25 mm of each other come to lie on one
line. A plan that stands at an angle as a whole is turned first. What is slanted or curved becomes the steps inside it (`steps_inside`).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from solver.geometry import doubled_area, edges_round
from solver.imports.drawn import PlanNotes, Spot
from solver.imports.rectilinear import FloorCorners, is_simple, tidied, weighted_median
from solver.imports.steps_inside import stepped

NEAR: Final = 25.0
"""Lines no farther apart, mm, are one."""
STRAIGHT: Final = math.tan(math.radians(1.0))
"""How far from an axis a long edge may run and still be straight."""
TINY: Final = 40.0
"""A slanted edge no longer than this, mm, tells nothing by itself."""
SLOPED: Final = 0.15
"""The same of an edge whose ends lie within NEAR of a line."""
CURVING: Final = 500.0
"""An edge no longer than this, mm, that leans and goes on from a slanted one is part of its curve."""
SMALLEST_ROOM: Final = 500_000
"""A room has more floor, mm2."""
TOLD: Final = 1.0
"""A wall that moves by more, mm, is told of."""


@dataclass
class StraightRun:
    """Edges of one room on one line: along `axis`, at `at` across it (mm); `looks` is positive where the room is on its one side."""

    axis: Literal["x", "z"]
    points: list[Spot]
    at: int = 0
    looks: float = 0.0

    @property
    def across(self) -> list[float]:
        """Where its points lie across it."""
        return [point[1 if self.axis == "x" else 0] for point in self.points]

    @property
    def middle(self) -> float:
        """The mean of where its edges lie, by their lengths."""
        total = weight = 0.0
        for a, b in zip(self.points, self.points[1:], strict=False):
            length = math.dist(a, b)
            total, weight = total + length * (a[self._across] + b[self._across]) / 2, weight + length
        return total / weight if weight else self.points[0][self._across]

    @property
    def _across(self) -> int:
        return 1 if self.axis == "x" else 0

    @property
    def along(self) -> tuple[float, float]:
        """Its ends along its axis, the lower first."""
        along = [point[1 - self._across] for point in self.points]
        return min(along), max(along)

    @property
    def length(self) -> float:
        """From its first to its last point, mm."""
        return math.dist(self.points[0], self.points[-1])

    @property
    def shift(self) -> float:
        """How far its farthest point is moved, mm."""
        return max(abs(across - self.at) for across in self.across)


Slant: TypeAlias = list[Spot]
"""Points along a slanted or curved wall, its ends included."""
OutlinePart: TypeAlias = StraightRun | Slant


@dataclass
class StraightRoom:
    """A room after the step: `corners` empty where nothing of it is left; `is_stepped` where walls became steps."""

    corners: FloorCorners
    is_stepped: bool = False
    is_mended: bool = False
    shift: float = 0.0


def turn_of(polygons: Sequence[Sequence[Spot]]) -> float:
    """Returns by how many degrees (from -45 to 45) a plan stands at an angle; 0 where most of its walls run along x and z, or nowhere."""
    weights: dict[int, float] = {}
    angles: list[tuple[float, float]] = []
    for polygon in polygons:
        for a, b in edges_round(polygon):
            length, angle = math.dist(a, b), math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])) % 90.0
            angles.append((angle, length))
            weights[round(angle * 2) % 180] = weights.get(round(angle * 2) % 180, 0.0) + length
    total = sum(length for _, length in angles)
    if not total:
        return 0.0
    peak = max(weights, key=lambda key: (weights[key], -key)) / 2
    offsets = [((angle - peak + 45.0) % 90.0 - 45.0, length) for angle, length in angles]
    near = [(offset, length) for offset, length in offsets if abs(offset) <= 1.0]
    found = peak + sum(offset * length for offset, length in near) / max(sum(length for _, length in near), 1e-9)
    found = (found + 45.0) % 90.0 - 45.0
    level = sum(length for angle, length in angles if min(angle, 90.0 - angle) <= 1.0)
    turned = sum(length for _, length in near)
    return found if level < total / 2 < turned else 0.0


def turned_by(spot: Spot, degrees: float) -> Spot:
    """Returns a point turned back by an angle about the origin."""
    if not degrees:
        return spot
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return spot[0] * c + spot[1] * s, spot[1] * c - spot[0] * s


def straightened(polygons: Sequence[Sequence[Spot]], apart: float = NEAR) -> list[StraightRoom]:
    """Returns rooms of one storey with straight walls.

    What lies no farther apart than `apart`, mm, and before each other is one wall line and not the two faces of a wall.
    """
    stretches = [_stretches(polygon) for polygon in polygons]
    runs: dict[str, list[StraightRun]] = {}
    for room, polygon in zip(stretches, polygons, strict=True):
        clockwise = doubled_area(polygon)
        for run in room:
            if isinstance(run, StraightRun):
                run.looks = clockwise * (run.points[-1][run.axis == "z"] - run.points[0][run.axis == "z"])
                runs.setdefault(run.axis, []).append(run)
    for together in runs.values():
        _gather(together, min(apart, NEAR))
    return [_straight(room, len(polygons)) for room in stretches]


def tell_of(of: str, room: StraightRoom, notes: PlanNotes) -> None:
    """Notes what the step did to a room."""
    if room.shift > TOLD:
        notes.change("straighten", of, room.shift / 1000, f"walls moved by up to {room.shift:.0f} mm, so that they are straight")
    if room.is_stepped:
        notes.change("straighten", of, 0.1, "slanted or curved walls are taken as the steps of 0.1 m inside them")
    if room.is_mended:
        notes.change("straighten", of, 0.0, "its outline crosses or touches itself: the largest part of it is taken")


def _stretches(polygon: Sequence[Spot]) -> list[OutlinePart]:
    """Cuts an outline into runs and slanted walls, in order."""
    points = [spot for at, spot in enumerate(polygon) if math.dist(spot, polygon[at - 1]) > 1.0]
    if len(points) < 3:
        return []
    kinds = _kinds(points)
    count = len(points)
    first = next((at for at in range(count) if kinds[at] != kinds[at - 1] and kinds[at] != "tiny"), None)
    if first is None:
        return [[*points, points[0]]]
    found: list[OutlinePart] = []
    for step in range(count):
        at = (first + step) % count
        a, b, kind = points[at], points[(at + 1) % count], kinds[at]
        last = found[-1] if found else None
        if kind == "tiny" and last is not None:
            continue
        if kind == "slanted":
            found = [*found, [a, b]] if not isinstance(last, list) else [*found[:-1], [*last, b]]
        elif isinstance(last, StraightRun) and last.axis == kind and _spread([*last.points, a, b], kind) <= 2 * NEAR:
            last.points += [a, b]
        else:
            found.append(StraightRun("x" if kind == "x" else "z", [a, b]))
    return _closed(found)


def _closed(found: list[OutlinePart]) -> list[OutlinePart]:
    """Joins the last stretch with the first where they are one."""
    first, last = found[0], found[-1]
    if len(found) > 2 and isinstance(first, StraightRun) and isinstance(last, StraightRun) and first.axis == last.axis:
        points = [*last.points, *first.points]
        if _spread(points, first.axis) <= 2 * NEAR:
            return [StraightRun(first.axis, points), *found[1:-1]]
    return found


def _spread(points: Sequence[Spot], axis: str) -> float:
    across = [point[1 if axis == "x" else 0] for point in points]
    return max(across) - min(across)


def _kinds(points: Sequence[Spot]) -> list[str]:
    """Tells of each edge whether it runs along x or z, is slanted, or too short to tell."""
    count, kinds, curving = len(points), [], []
    for a, b in edges_round(points):
        dx, dz = abs(b[0] - a[0]), abs(b[1] - a[1])
        minor, major = min(dx, dz), max(dx, dz)
        level = minor <= STRAIGHT * major and minor <= 2 * NEAR
        straight = level or (minor <= NEAR and minor <= SLOPED * major)
        kinds.append("tiny" if major <= TINY and not straight else ("x" if dx >= dz else "z") if straight else "slanted")
        curving.append(major <= 2 * NEAR or (not level and major <= CURVING))
    for _ in range(2):
        for at in (*range(count), *range(count - 1, -1, -1)):
            if curving[at] and "slanted" in (kinds[at - 1], kinds[(at + 1) % count]):
                kinds[at] = "slanted"
    following = [kinds[(at + 1) % count] for at in range(count)]
    return ["slanted" if kind == "tiny" and "tiny" in (kinds[at - 1], following[at]) else kind for at, kind in enumerate(kinds)]


def _gather(runs: list[StraightRun], apart: float) -> None:
    """Gives runs that lie near each other one coordinate: their median, weighted by length.

    Runs that look opposite ways are the two faces of one wall line only where they lie before each other, and near enough.
    """
    groups = [*_near_each_other([run for run in runs if run.looks > 0]), *_near_each_other([run for run in runs if run.looks <= 0])]
    groups.sort(key=lambda group: group[0].middle)
    at = 0
    while at + 1 < len(groups):
        both = sorted((*groups[at], *groups[at + 1]), key=lambda run: run.middle)
        if both[-1].middle - both[0].middle <= apart and _face(both):
            groups[at : at + 2] = [both]
        else:
            at += 1
    for group in groups:
        line = round(weighted_median((run.middle, max(run.length, 1.0)) for run in group))
        for run in group:
            run.at = line


def _near_each_other(runs: list[StraightRun]) -> list[list[StraightRun]]:
    groups: list[list[StraightRun]] = []
    for run in sorted(runs, key=lambda run: run.middle):
        if groups and run.middle - groups[-1][0].middle <= NEAR:
            groups[-1].append(run)
        else:
            groups.append([run])
    return groups


def _face(runs: Sequence[StraightRun]) -> bool:
    """Tells whether two of the runs that look opposite ways share some of their length."""
    ends = {True: -math.inf, False: -math.inf}
    for run in sorted(runs, key=lambda run: run.along[0]):
        low, high = run.along
        if min(ends[run.looks <= 0], high) - low > TOLD:
            return True
        ends[run.looks > 0] = max(ends[run.looks > 0], high)
    return False


def _straight(stretches: list[OutlinePart], rooms: int) -> StraightRoom:
    if not stretches:
        return StraightRoom([])
    points: list[Spot] = []
    for at, stretch in enumerate(stretches):
        before, after = stretches[at - 1], stretches[(at + 1) % len(stretches)]
        points += _of_run(stretch, after) if isinstance(stretch, StraightRun) else _of_slant(stretch, before, after)
    slanted = any(isinstance(stretch, list) for stretch in stretches)
    shift = max((run.shift for run in stretches if isinstance(run, StraightRun)), default=0.0)
    if slanted:
        return _kept(StraightRoom(stepped(points, rooms), is_stepped=True, shift=shift))
    corners = tidied([(round(x), round(z)) for x, z in points])
    if corners and is_simple(corners):
        return _kept(StraightRoom(corners, shift=shift))
    return _kept(StraightRoom(stepped(points, rooms), is_mended=bool(corners), shift=shift))


def _kept(room: StraightRoom) -> StraightRoom:
    return room if doubled_area(room.corners) >= 2 * SMALLEST_ROOM else StraightRoom([])


def _of_run(run: StraightRun, after: OutlinePart) -> list[Spot]:
    """Returns the corners at a run's end."""
    end = run.points[-1]
    if isinstance(after, list):
        return []
    if after.axis == run.axis:
        return (
            [(round(end[0]), run.at), (round(end[0]), after.at)]
            if run.axis == "x"
            else [(run.at, round(end[1])), (after.at, round(end[1]))]
        )
    return [(after.at, run.at) if run.axis == "x" else (run.at, after.at)]


def _of_slant(slant: Slant, before: OutlinePart, after: OutlinePart) -> list[Spot]:
    """Returns a slanted wall's points, its ends on the runs beside it."""
    ends = [_onto(slant[0], before), *slant[1:-1], _onto(slant[-1], after)]
    return ends if before is not after or isinstance(before, StraightRun) else ends[:-1]


def _onto(spot: Spot, stretch: OutlinePart) -> Spot:
    if isinstance(stretch, list):
        return spot
    return (float(round(spot[0])), float(stretch.at)) if stretch.axis == "x" else (float(stretch.at), float(round(spot[1])))
