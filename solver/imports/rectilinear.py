"""Polygons whose edges all run along x or z, in whole mm: their edges, areas, and whether they are simple.

Comes in and goes out: corners (x, z), mm; clockwise seen from above where it matters (x east, z south).
"""

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple

import numpy as np

from solver.geometry import ALONG_X, INWARDS, doubled_area, walls_round

FloorCorner = tuple[int, int]
FloorCorners = list[FloorCorner]


class DrawnLine(NamedTuple):
    """A line along an axis: its coordinate across it, and from where to where it goes, mm."""

    axis: Literal["x", "z"]
    at: int
    low: int
    high: int


class PlanEdge(NamedTuple):
    """An edge of a room: along `axis` at coordinate `at` across it, from `low` to `high`; `out` points out of the room, 1 or -1.

    `side` is its place in the outline.
    """

    room: int
    side: int
    axis: Literal["x", "z"]
    at: int
    low: int
    high: int
    out: int

    @property
    def length(self) -> int:
        """Its length, mm."""
        return self.high - self.low


def weighted_median(values: Iterable[tuple[int | float, float]]) -> int | float:
    """Returns the value up to which half of all weight lies; 0 where there is none. Values come with their weights."""
    ordered = sorted(values)
    half, total = sum(weight for _, weight in ordered) / 2, 0.0
    for value, weight in ordered:
        total += weight
        if total >= half:
            return value
    return 0


def tidied(corners: Sequence[FloorCorner]) -> FloorCorners:
    """Returns corners clockwise, from the most northern (of these the most western) on, without repeated or collinear ones."""
    kept: FloorCorners = list(corners)
    before = -1
    while len(kept) != before:
        before = len(kept)
        kept = [corner for at, corner in enumerate(kept) if corner != kept[at - 1]]
        kept = [kept[at] for at in range(len(kept)) if not _is_passed(kept[at - 1], kept[at], kept[(at + 1) % len(kept)])]
    if len(kept) < 4:
        return []
    if doubled_area(kept) < 0:
        kept.reverse()
    first = min(range(len(kept)), key=lambda at: (kept[at][1], kept[at][0]))
    return kept[first:] + kept[:first]


def _is_passed(before: FloorCorner, here: FloorCorner, after: FloorCorner) -> bool:
    """Tells whether a corner is none: the outline goes straight on, or back the way it came."""
    return before[0] == here[0] == after[0] or before[1] == here[1] == after[1]


def edges_of_corners(room: int, corners: Sequence[FloorCorner]) -> list[PlanEdge]:
    """Returns the edges of a room."""
    return [
        PlanEdge(room, side, "x" if wall in ALONG_X else "z", at, low, high, -INWARDS[wall])
        for side, (wall, at, low, high) in enumerate(walls_round(corners))
    ]


def is_simple(corners: Sequence[FloorCorner]) -> bool:
    """Tells whether an outline neither crosses nor touches itself along a line."""
    edges = edges_of_corners(0, corners)
    along = [np.array([(e.at, e.low, e.high) for e in edges if e.axis == axis], dtype=np.int64).reshape(-1, 3) for axis in ("x", "z")]
    level, upright = along
    crossing = (
        (level[:, 1:2] < upright[None, :, 0]) & (upright[None, :, 0] < level[:, 2:3])
        & (upright[None, :, 1] < level[:, 0:1]) & (level[:, 0:1] < upright[None, :, 2])
    )  # fmt: skip
    return not crossing.any() and not any(_overlapping(one) for one in along)


def _overlapping(edges: np.ndarray) -> bool:
    """Tells whether two edges of one direction lie on each other."""
    ordered = edges[np.lexsort((edges[:, 1], edges[:, 0]))]
    same = ordered[1:, 0] == ordered[:-1, 0]
    return bool((same & (ordered[1:, 1] < ordered[:-1, 2])).any())
