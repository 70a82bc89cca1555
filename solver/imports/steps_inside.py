"""A room with slanted or curved walls, or one that crosses itself, as the largest rectilinear floor inside it, in steps of 0.1 m."""

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.geometry import doubled_area, edges_round, encloses
from solver.imports.drawn import Spot
from solver.imports.rectilinear import DrawnLine, FloorCorners, tidied

STEP: Final = 100
"""How long the steps before a slanted line are, mm."""
MOST_CELLS: Final = 40_000
"""Cells that one room may be cut into; steps grow until there are no more."""
ALL_CELLS: Final = 400_000
"""The same of all rooms of a plan together, dealt to them alike."""
Polygon = Sequence[Spot]
SlantedLine = tuple[Spot, Spot]
"""A line along no axis, mm."""
Cells = NDArray[np.bool_]
CellCuts = NDArray[np.int64]
CellPart = tuple[Cells, CellCuts, CellCuts]
"""Which cells of a box are covered, by column and row, and between which x and z they lie."""


def stepped(polygon: Polygon, rooms: int = 1) -> FloorCorners:
    """Returns the corners of the largest rectilinear part inside a polygon, mm; empty where there is none, or it is too intricate.

    The work is dealt to the plan's `rooms`.
    """
    step, most = STEP, min(MOST_CELLS, ALL_CELLS // rooms)
    sides = [(a, b) for a, b in edges_round(polygon) if a != b]
    lines = [_line(a, b) for a, b in sides if a[0] == b[0] or a[1] == b[1]]
    slants = [(a, b) for a, b in sides if a[0] != b[0] and a[1] != b[1]]
    while step <= 64 * STEP:
        xs, zs = (
            places_cut([one.at for one in lines if one.axis != axis], [(a[along], b[along]) for a, b in slants], step)
            for along, axis in enumerate("xz")
        )
        if min(len(xs), len(zs)) < 2:
            return []
        if len(xs) * len(zs) <= most:
            outlines = [outline_of_cells(*part) for part in parts_between(lines, slants, xs, zs)]
            inside = [one for one in outlines if one and encloses(polygon, one[0][0] + 0.5, one[0][1] + 0.5)]
            return max(inside, key=doubled_area, default=[])
        step *= 2
    return []


def _line(a: Spot, b: Spot) -> DrawnLine:
    along = 0 if a[1] == b[1] else 1
    low, high = sorted((round(a[along]), round(b[along])))
    return DrawnLine("z" if along else "x", round(a[1 - along]), low, high)


def places_cut(straight: Iterable[int], slanted: Iterable[tuple[float, float]], step: int) -> CellCuts:
    """Returns where the floor is cut into cells along an axis: at some places, and in steps along slanted lines."""
    found = set(straight)
    for ends in slanted:
        found.update(range(math.floor(min(ends) / step) * step, math.ceil(max(ends) / step) * step + 1, step))
    return np.array(sorted(found), dtype=np.int64)


def parts_between(lines: Sequence[DrawnLine], slants: Sequence[SlantedLine], xs: CellCuts, zs: CellCuts) -> Iterator[CellPart]:
    """Yields the connected parts of the floor that straight and slanted lines enclose.

    A line that ends between two cuts goes on to the next.
    """
    free = _free(lines, xs, zs)
    for slant in slants:
        _cover(free, slant, xs, zs)
    for spots in islice(connected(free), 1, None):
        (west, north), (east, south) = spots.min(axis=0) // 2 - 1, spots.max(axis=0) // 2 + 1
        columns, rows = xs[west:east], zs[north:south]
        part = np.zeros((2 * len(columns) + 1, 2 * len(rows) + 1), dtype=np.bool_)
        part[tuple((spots - (2 * west, 2 * north)).T)] = True
        yield part[2:-1:2, 2:-1:2], columns, rows


def _free(lines: Sequence[DrawnLine], xs: CellCuts, zs: CellCuts) -> Cells:
    """Returns what no line covers, by column and row: even ones are cells, odd ones the lines between them, and a ring around all."""
    free = np.ones((2 * len(xs) + 1, 2 * len(zs) + 1), dtype=np.bool_)
    for axis, at, low, high in lines:
        along, across = (xs, zs) if axis == "x" else (zs, xs)
        first, last = 2 * int(np.searchsorted(along, low, "right")) - 1, 2 * int(np.searchsorted(along, high)) + 1
        row = 2 * int(np.searchsorted(across, at)) + 1
        free[(slice(first, last + 1), row) if axis == "x" else (row, slice(first, last + 1))] = False
    return free


def _cover(free: Cells, slant: SlantedLine, xs: CellCuts, zs: CellCuts) -> None:
    """Covers the cells that a slanted line goes through."""
    (x0, z0), (x1, z1) = sorted(slant)
    columns = np.arange(max(0, int(np.searchsorted(xs, x0, "right")) - 1), min(len(xs) - 1, int(np.searchsorted(xs, x1, "left"))))
    ends = z0 + (z1 - z0) * (np.clip((xs[columns], xs[columns + 1]), x0, x1) - x0) / (x1 - x0)
    first = 2 * np.maximum(np.searchsorted(zs, ends.min(axis=0), "right") - 1, 0) + 1
    last = 2 * np.searchsorted(zs, ends.max(axis=0), "left") + 1
    rows = np.arange(free.shape[1])
    is_met = (rows >= first[:, None]) & (rows <= last[:, None])
    for beside in (1, 2, 3):
        free[2 * columns + beside] &= ~is_met


def connected(free: Cells) -> list[NDArray[np.int64]]:
    """Returns the places of each connected part, that of the first free place first."""
    from scipy.ndimage import label  # noqa: PLC0415 - it takes 0.2 s to import, and most plans need none of it

    parts, count = label(free)
    spots = np.argwhere(parts)[np.argsort(parts[free], kind="stable")]
    return np.split(spots, np.cumsum(np.bincount(parts[free])[1:-1])) if count else []


def outline_of_cells(part: Cells, xs: NDArray[np.int64], zs: NDArray[np.int64]) -> FloorCorners:
    """Returns the outer outline of connected cells, the floor at its right; where cells touch at a corner it stays with its own."""
    if not part.any():
        return []
    ways: dict[tuple[int, int], list[tuple[int, int]]] = {}
    framed = np.pad(part, 1)
    for column, row in np.argwhere(part).tolist():
        sides = (
            (framed[column + 1, row], (column, row), (1, 0)),
            (framed[column + 2, row + 1], (column + 1, row), (0, 1)),
            (framed[column + 1, row + 2], (column + 1, row + 1), (-1, 0)),
            (framed[column, row + 1], (column, row + 1), (0, -1)),
        )
        for covered, start, way in sides:
            if not covered:
                ways.setdefault(start, []).append(way)
    first = min(ways, key=lambda at: (at[1], at[0]))
    at, way, walked = first, (1, 0), [first]
    while True:
        at = (at[0] + way[0], at[1] + way[1])
        if at == first:
            break
        walked.append(at)
        right = (-way[1], way[0])
        way = right if right in ways[at] else next(one for one in ways[at] if len(ways[at]) == 1 or one != (-right[0], -right[1]))
    return tidied([(int(xs[column]), int(zs[row])) for column, row in walked])
