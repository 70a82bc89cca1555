"""A floor's outline cut into rectangles, for formats that know no polygons."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from solver.geometry import edges_round

FloorRectangle = tuple[float, float, float, float]
"""West, north, east, south: x0, z0, x1, z1 in the house, m."""


def rectangles_of(corners: Sequence[tuple[float, float]]) -> list[FloorRectangle]:
    """Returns rectangles that tile what an outline encloses, from north to south, each as deep as it can be."""
    edges = [(a, b) for a, b in edges_round(corners) if a[0] == b[0]]
    done: list[FloorRectangle] = []
    growing: dict[tuple[float, float], float] = {}
    levels = sorted({z for _, z in corners})
    for north, south in pairwise(levels):
        crossed = sorted(a[0] for a, b in edges if min(a[1], b[1]) <= north and south <= max(a[1], b[1]))
        spans = set(zip(crossed[::2], crossed[1::2], strict=False))
        done += [(west, growing.pop((west, east)), east, north) for west, east in sorted(set(growing) - spans)]
        growing |= {span: growing.get(span, north) for span in spans}
    return done + [(west, top, east, levels[-1]) for (west, east), top in sorted(growing.items())]
