"""A room with slanted or curved walls, or one that crosses itself, as the largest rectilinear floor inside it, in steps of 0.1 m."""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.geometry import edges_round
from solver.imports.rectilinear import FloorCorners, tidied

STEP: Final = 100
"""How long the steps along a slanted wall are, mm."""
MOST_CELLS: Final = 40_000
"""Cells that one room may be cut into; steps grow until there are no more."""
ALL_CELLS: Final = 400_000
"""The same of all rooms of a plan together, dealt to them alike."""
Polygon = Sequence[tuple[float, float]]
Cells = NDArray[np.bool_]


def stepped(polygon: Polygon, rooms: int = 1) -> FloorCorners:
    """Returns the corners of the largest rectilinear part inside a polygon, mm; empty where there is none, or it is too intricate.

    The work is dealt to the plan's `rooms`.
    """
    step, most = STEP, min(MOST_CELLS, ALL_CELLS // rooms)
    while step <= 64 * STEP:
        xs, zs = _cuts(polygon, 0, step), _cuts(polygon, 1, step)
        if len(xs) * len(zs) <= most:
            return outline_of_cells(_largest(_inside(polygon, xs, zs), xs, zs), xs, zs)
        step *= 2
    return []


def _cuts(polygon: Polygon, axis: int, step: int) -> NDArray[np.int64]:
    """Returns where the floor is cut: at every edge along the other axis, and in steps along slanted edges."""
    found: set[int] = set()
    for a, b in edges_round(polygon):
        if a[axis] == b[axis]:
            found.add(round(a[axis]))
        elif a[1 - axis] != b[1 - axis]:
            low, high = math.floor(min(a[axis], b[axis])), math.ceil(max(a[axis], b[axis]))
            found.update(range(low - low % step, high + step, step))
        if len(found) > MOST_CELLS:
            break
    return np.array(sorted(found), dtype=np.int64)


def _inside(polygon: Polygon, xs: NDArray[np.int64], zs: NDArray[np.int64]) -> Cells:
    """Returns which cells lie wholly inside the polygon, by column and row."""
    if len(xs) < 2 or len(zs) < 2:
        return np.zeros((0, 0), dtype=np.bool_)
    mid_x, mid_z = (xs[1:] + xs[:-1]) / 2, (zs[1:] + zs[:-1]) / 2
    inside, cut = np.zeros((len(mid_x), len(mid_z)), dtype=np.bool_), np.zeros((len(mid_x), len(mid_z)), dtype=np.bool_)
    for (ax, az), (bx, bz) in edges_round(polygon):
        if ax == bx:
            continue
        (x0, z0), (x1, z1) = sorted(((ax, az), (bx, bz)))
        slope = (z1 - z0) / (x1 - x0)
        spanned = (mid_x >= x0) & (mid_x < x1)
        inside[spanned] ^= mid_z[None, :] > (z0 + (mid_x[spanned] - x0) * slope)[:, None]
        if slope:
            met = (xs[1:] > x0) & (xs[:-1] < x1)
            ends = np.stack([z0 + (np.clip(side[met], x0, x1) - x0) * slope for side in (xs[:-1], xs[1:])])
            cut[met] |= (zs[None, 1:] > ends.min(axis=0)[:, None]) & (zs[None, :-1] < ends.max(axis=0)[:, None])
    return inside & ~cut


def _largest(inside: Cells, xs: NDArray[np.int64], zs: NDArray[np.int64]) -> Cells:
    """Returns the cells of the largest connected part."""
    best = np.zeros_like(inside)
    areas = np.diff(xs)[:, None] * np.diff(zs)[None, :] if inside.size else inside
    largest = max(connected(inside), key=lambda spots: int(areas[tuple(spots.T)].sum()), default=None)
    if largest is not None:
        best[tuple(largest.T)] = True
    return best


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
