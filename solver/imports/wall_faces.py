"""A drawing of walls alone -> rooms: the faces that its wall lines enclose, once the gaps at doors and windows are closed."""

import math
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.imports.drawn import Spot
from solver.imports.rectilinear import DrawnLine, FloorCorners, edges_of_corners, weighted_median
from solver.imports.steps_inside import STEP, SlantedLine, connected, outline_of_cells, parts_between, places_cut

STRAIGHT: Final = 15
"""A line may leave its axis by so much from end to end, mm."""
SAME_LINE: Final = 5
"""Coordinates no farther apart, mm, are one."""
CRACK: Final = 150
"""A gap in a wall's line that is no longer, mm, is none."""
REACH: Final = 250
"""Nor is one up to a wall across its way, or to a corner: half an outer wall, by which single lines may fail to meet."""
NARROWEST: Final = 650
"""A face into which no square of that side fits, mm, is the inside of a wall."""
NARROWEST_CLOSET: Final = 400
"""So it is of a face in which the name of a room stands and into which a door leads."""
THICKEST: Final = 600
"""Of a wall, mm."""
FAR: Final = 10**9
"""Farther than any wall, mm."""
MOST_CELLS: Final = 250_000
"""Cells that the drawing may be cut into."""


class RowGap(NamedTuple):
    """A gap in a line; whether the line goes on behind it, or something lies across the way there."""

    line: DrawnLine
    in_line: bool


class ClosetSigns(NamedTuple):
    """Where names of rooms stand, and where one stands who goes through a door or passage, mm: what has both may be narrow."""

    names: Sequence[Spot] = ()
    doors: Sequence[Spot] = ()


NO_SIGNS: Final = ClosetSigns()


class WallFace(NamedTuple):
    """A room between walls: its corners, mm, and those of what lies within it."""

    corners: FloorCorners
    holes: list[FloorCorners]


def line_between(a: Spot, b: Spot) -> DrawnLine | None:
    """Returns the line between two points in mm; None where it is slanted, or nothing."""
    wide, high = abs(a[0] - b[0]), abs(a[1] - b[1])
    if min(wide, high) > STRAIGHT or max(wide, high) < 1:
        return None
    axis, along = ("x", 0) if wide >= high else ("z", 1)
    low, far = sorted((round(a[along]), round(b[along])))
    return DrawnLine("x" if axis == "x" else "z", round((a[1 - along] + b[1 - along]) / 2), low, far)


def faces_between(
    walls: Sequence[DrawnLine], signs: ClosetSigns = NO_SIGNS, slants: Sequence[SlantedLine] = (), step: int = STEP
) -> list[WallFace] | None:
    """Returns the rooms that walls enclose, from north to south; None where the drawing is too intricate.

    Slanted lines enclose, too: rooms reach to the steps before them.
    """
    lines = gathered(walls)
    slants = [_lengthened(one) for one in slants]
    xs, zs = (
        places_cut(
            {one.at for one in lines if one.axis != axis} | {end for one in lines if one.axis == axis for end in (one.low, one.high)},
            [(a[along], b[along]) for a, b in slants],
            step,
        )
        for along, axis in enumerate("xz")
    )
    if len(xs) < 2 or len(zs) < 2:
        return []
    if len(xs) * len(zs) * 4 > MOST_CELLS:
        return None
    parts = [one for one in parts_between(_closed(lines), slants, xs, zs) if _is_room(*one, signs)]
    found = [WallFace(outline_of_cells(*one), list(_holes(*one))) for one in parts]
    return sorted((one for one in found if one.corners), key=lambda one: (one.corners[0][1], one.corners[0][0]))


def gathered(walls: Sequence[DrawnLine]) -> list[DrawnLine]:
    """Returns walls with coordinates that nearly meet made one, along and across, each once."""
    values = sorted({value for one in walls for value in (one.at, one.low, one.high)})
    first: dict[int, int] = {}
    for before, value in zip([None, *values], values, strict=False):
        first[value] = first[before] if before is not None and value - first[before] <= SAME_LINE else value
    return list(dict.fromkeys(DrawnLine(one.axis, first[one.at], first[one.low], first[one.high]) for one in walls))


class WallRows:
    """Where lines are drawn, to find what the end of one meets, and what lies ahead of it."""

    def __init__(self, walls: Sequence[DrawnLine]) -> None:
        by_line: dict[tuple[str, int], list[tuple[int, int]]] = {}
        for one in walls:
            by_line.setdefault((one.axis, one.at), []).append((one.low, one.high))
        self._by_line = {key: np.array(parts).T for key, parts in by_line.items()}
        self._by_axis = {axis: np.array([one[1:] for one in walls if one.axis == axis]).reshape(-1, 3).T for axis in ("x", "z")}

    def is_met(self, one: DrawnLine, end: int) -> bool:
        """Tells whether an end of a wall lies on another one, across it or along it."""
        low, high = self._by_line[one.axis, one.at]
        if ((low <= end) & (end <= high)).sum() > 1:
            return True
        low, high = self._by_line.get((_across(one), end), np.empty((2, 0)))
        return bool(((low <= one.at) & (one.at <= high)).any())

    def whole(self) -> Iterator[DrawnLine]:
        """Yields walls, those that overlap in one line as one."""
        for (axis, at), (lows, highs) in self._by_line.items():
            order = np.argsort(lows, kind="stable")
            reach = np.maximum.accumulate(highs[order])
            starts = np.flatnonzero(np.concatenate(([True], lows[order][1:] > reach[:-1])))
            for first, last in zip(starts, [*starts[1:], len(order)], strict=True):
                yield DrawnLine("x" if axis == "x" else "z", at, int(lows[order][first]), int(reach[last - 1]))

    def gap_at(self, one: DrawnLine, end: int) -> RowGap | None:
        """Returns what is free from an end of a wall on to the next piece in its line, or to a wall across the way; None without either."""
        (lows, highs), crossed = self._by_line[one.axis, one.at], self.ahead(one, end, None)
        if end == one.low:
            is_told = crossed and bool((highs[highs < end] >= crossed.at).any())
            return RowGap(DrawnLine(one.axis, one.at, crossed.at, end), in_line=False) if crossed and not is_told else None
        following = int(lows[lows > end].min(initial=FAR))
        far = min(following, crossed.at if crossed else FAR)
        return RowGap(DrawnLine(one.axis, one.at, end, far), in_line=far == following) if far < FAR else None

    def is_face(self, one: DrawnLine, end: int, nearest: int, farthest: int) -> bool:
        """Tells whether another line, so far from one, runs beside most of its last piece before an end: the wall has two faces.

        That piece is as long as the wall may be thick: a shaft in a far corner, or a wall that ends before the line, is no face.
        """
        at, low, high = self._by_axis[one.axis]
        away = np.abs(at - one.at)
        first, last = (one.low, min(one.high, one.low + farthest)) if end == one.low else (max(one.low, one.high - farthest), one.high)
        common = np.minimum(high, last) - np.maximum(low, first)
        return bool(((away >= nearest) & (away <= farthest) & (2 * common > last - first)).any())

    def ahead(self, one: DrawnLine, end: int, within: int | None) -> DrawnLine | None:
        """Returns the nearest wall across the way beyond an end; at most so far ahead and aside, where that is said."""
        at, low, high = self._by_axis[_across(one)]
        gaps, beside = (at - end) * (1 if end == one.high else -1), np.maximum(np.maximum(low - one.at, one.at - high), 0)
        near = np.flatnonzero((gaps > 0) & ((beside == 0) if within is None else ((gaps <= within) & (beside <= within))))
        if not len(near):
            return None
        to = near[np.lexsort((beside[near], gaps[near]))[0]]
        return DrawnLine(_across(one), int(at[to]), int(low[to]), int(high[to]))


def _across(one: DrawnLine) -> Literal["x", "z"]:
    return "z" if one.axis == "x" else "x"


def free_ends(walls: Sequence[DrawnLine]) -> int:
    """Returns how many ends of walls lie on no other wall, once cracks are closed."""
    lines = _closed(gathered(walls))
    rows = WallRows(lines)
    return sum(not rows.is_met(one, end) for one in lines for end in (one.low, one.high))


def _closed(walls: Sequence[DrawnLine]) -> list[DrawnLine]:
    """Returns walls with the lines that close cracks, from pieces to the next ones in their lines, and from free ends to walls across."""
    return [*walls, *_in_cracks(walls), *_reaching(walls)]


def _in_cracks(walls: Sequence[DrawnLine]) -> Iterator[DrawnLine]:
    by_line: dict[tuple[str, int], list[DrawnLine]] = {}
    for one in walls:
        by_line.setdefault((one.axis, one.at), []).append(one)
    for parts in by_line.values():
        parts.sort(key=lambda one: (one.low, one.high))
        end = parts[0].high
        for one in parts[1:]:
            if 0 < one.low - end <= CRACK:
                yield DrawnLine(one.axis, one.at, end, one.low)
            end = max(end, one.high)


def _reaching(walls: Sequence[DrawnLine]) -> Iterator[DrawnLine]:
    rows = WallRows(walls)
    for one in walls:
        for end in (one.low, one.high):
            crossed = None if rows.is_met(one, end) else rows.ahead(one, end, REACH)
            if crossed:
                yield DrawnLine(one.axis, one.at, *sorted((end, crossed.at)))
                if not crossed.low <= one.at <= crossed.high:
                    far = crossed.low if one.at < crossed.low else crossed.high
                    yield DrawnLine(crossed.axis, crossed.at, *sorted((one.at, far)))


def _lengthened(slant: SlantedLine) -> SlantedLine:
    """Returns a slanted line from a little before its beginning to a little behind its end."""
    (x0, z0), (x1, z1) = slant
    by = 2 * SAME_LINE / math.dist(*slant)
    x, z = (x1 - x0) * by, (z1 - z0) * by
    return (x0 - x, z0 - z), (x1 + x, z1 + z)


def _holes(cells: NDArray[np.bool_], xs: NDArray[np.int64], zs: NDArray[np.int64]) -> Iterator[FloorCorners]:
    """Yields the outlines of what cells lie around, if a room fits into it: other rooms with their walls, or a shaft."""
    for spots in islice(connected(~np.pad(cells, 1)), 1, None):
        hole = np.zeros_like(cells)
        hole[tuple((spots - 1).T)] = True
        if _is_room(hole, xs, zs):
            yield outline_of_cells(hole, xs, zs)


def _is_room(cells: NDArray[np.bool_], xs: NDArray[np.int64], zs: NDArray[np.int64], signs: ClosetSigns = NO_SIGNS) -> bool:
    """Tells whether a square of NARROWEST fits into cells, or into those of a closet one of NARROWEST_CLOSET."""

    def is_in(x: float, z: float) -> bool:
        at, row = int(np.searchsorted(xs, x)), int(np.searchsorted(zs, z))
        return bool(0 < at < len(xs) and 0 < row < len(zs) and cells[at - 1, row - 1])

    def is_closet() -> bool:
        return all(any(is_in(*spot) for spot in spots) for spots in signs)

    return _fits(NARROWEST, cells, xs, zs) or (_fits(NARROWEST_CLOSET, cells, xs, zs) and is_closet())


def _fits(size: int, cells: NDArray[np.bool_], xs: NDArray[np.int64], zs: NDArray[np.int64]) -> bool:
    if min(np.ptp(xs), np.ptp(zs)) < size:
        return False
    for start in np.flatnonzero(cells.any(axis=1)).tolist():
        end = int(np.searchsorted(xs, xs[start] + size))
        if end >= len(xs):
            return False
        long = 0
        for row, covered in enumerate(np.all(cells[start:end], axis=0)):
            long = long + int(zs[row + 1] - zs[row]) if covered else 0
            if long >= size:
                return True
    return False


def thickness_about(rooms: Sequence[FloorCorners], walls: Sequence[DrawnLine]) -> int | None:
    """Returns how far behind rooms' faces the other faces of their walls are drawn, mm, at most of their length; None without such."""
    found: list[tuple[int, int]] = []
    along = {axis: np.array([(one.at, one.low, one.high) for one in walls if one.axis == axis]).reshape(-1, 3).T for axis in ("x", "z")}
    for edge in (edge for number, corners in enumerate(rooms) for edge in edges_of_corners(number, corners)):
        at, low, high = along[edge.axis]
        behind = (at - edge.at) * edge.out
        faces = (behind > SAME_LINE) & (behind <= THICKEST) & (2 * (np.minimum(high, edge.high) - np.maximum(low, edge.low)) > edge.length)
        if faces.any():
            found.append((int(behind[faces].min()), edge.length))
    return int(weighted_median(found)) or None
