"""Whether rooms are drawn along their walls' middle lines or along the inner faces, measured at the walls that the file draws."""

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from statistics import median
from typing import Final

import numpy as np

from solver.geometry import doubled_area, edges_round, gaps_between
from solver.imports.drawn import DrawnAlong, DrawnRoom, DrawnWall, Spot

PARALLEL: Final = 0.02
"""The sine of the largest angle between a room's edge and its wall."""
THINNER: Final = 10.0
"""What is as much thinner than a file's thickest wall is no wall."""
WITHIN: Final = 0.2
"""An edge that lies deeper in its wall than this share of the thinnest one is not drawn along the face."""


def outer_walls(rooms: Sequence[DrawnRoom], thicknesses: Sequence[Sequence[float | None]], usual: float) -> Iterator[DrawnWall]:
    """Yields the outer walls of rooms that say how thick they are, where their outlines are the usual wall's middle line.

    What another room shares of such a line is no outer wall. Thicknesses are by edge, in the file's unit, None where it is the usual;
    points come clockwise or not.
    """
    lines = _Lines(rooms)
    for number, (room, own) in enumerate(zip(rooms, thicknesses, strict=True)):
        clockwise = 1 if doubled_area(room.points) >= 0 else -1
        for (a, b), thickness in zip(edges_round(room.points), own, strict=False):
            length = math.dist(a, b)
            if thickness is None or not length:
                continue
            way, by = ((b[0] - a[0]) / length, (b[1] - a[1]) / length), clockwise * (thickness - usual) / 2
            for low, high in lines.alone(number, room.level, a, b):
                start, end = ((a[0] + way[0] * at + way[1] * by, a[1] + way[1] * at - way[0] * by) for at in (low, high))
                yield DrawnWall(start, end, thickness, room.level)


class _Lines:
    """The edges of rooms that run along x or z, by their lines."""

    def __init__(self, rooms: Sequence[DrawnRoom]) -> None:
        self._edges: dict[tuple[int, int, float], list[tuple[int, float, float]]] = defaultdict(list)
        for number, room in enumerate(rooms):
            for a, b in edges_round(room.points):
                for axis in (0, 1):
                    if a[1 - axis] == b[1 - axis]:
                        ends = min(a[axis], b[axis]), max(a[axis], b[axis])
                        self._edges[room.level, axis, a[1 - axis]].append((number, *ends))

    def alone(self, number: int, level: int, a: Spot, b: Spot) -> list[tuple[float, float]]:
        """Returns the stretches of a room's edge from a to b that no other room has, by how far from a they are."""
        axis = 0 if a[1] == b[1] else 1
        ahead = 1 if b[axis] >= a[axis] else -1
        others = self._edges.get((level, axis, a[1 - axis]), []) if a[1 - axis] == b[1 - axis] else []
        ends = ((ahead * (low - a[axis]), ahead * (high - a[axis])) for room, low, high in others if room != number)
        return gaps_between((0.0, math.dist(a, b)), ((min(pair), max(pair)) for pair in ends))


def drawn_along(rooms: Sequence[DrawnRoom], walls: Sequence[DrawnWall]) -> tuple[DrawnAlong, float | None]:
    """Returns what rooms are drawn along, `inner` faces where there are no walls to tell; and the walls' usual thickness."""
    solid = [wall for wall in walls if wall.thickness > 0 and math.dist(wall.start, wall.end) > 0]
    if not solid:
        return "inner", None
    starts, ends = np.array([wall.start for wall in solid]), np.array([wall.end for wall in solid])
    lengths = np.linalg.norm(ends - starts, axis=1)
    ways, thick = (ends - starts) / lengths[:, None], np.array([wall.thickness for wall in solid])
    levels = np.array([wall.level for wall in solid])
    within = float(thick[thick >= thick.max() / THINNER].min()) * WITHIN
    on_line = measured = 0.0
    for room in rooms:
        for a, b in edges_round(room.points):
            length = math.dist(a, b)
            if not length:
                continue
            offset = np.array([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]) - starts
            across = np.abs(offset[:, 0] * ways[:, 1] - offset[:, 1] * ways[:, 0])
            along = (offset * ways).sum(axis=1)
            tilt = np.abs((b[0] - a[0]) * ways[:, 1] - (b[1] - a[1]) * ways[:, 0]) / length
            near = (levels == room.level) & (tilt < PARALLEL) & (along >= 0) & (along <= lengths) & (across <= thick)
            if near.any():
                nearest = np.flatnonzero(near)[across[near].argmin()]
                measured += length
                on_line += length * bool(thick[nearest] / 2 - across[nearest] > within)
    return ("lines" if on_line > measured / 2 else "inner"), float(median(thick.tolist()))
