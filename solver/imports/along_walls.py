"""Whether rooms are drawn along their walls' middle lines or along the inner faces, measured at the walls that the file draws.

Comes in: rooms and walls as drawn. Goes out: a `DrawnAlong`, and the usual thickness; outer walls that rooms speak of. May import: drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from statistics import median
from typing import Final

import numpy as np

from solver.imports.drawn import DrawnAlong, DrawnRoom, DrawnWall

PARALLEL: Final = 0.02
"""The sine of the largest angle between a room's edge and its wall."""
THINNER: Final = 10.0
"""What is as much thinner than a file's thickest wall is no wall."""
WITHIN: Final = 0.2
"""An edge that lies deeper in its wall than this share of the thinnest one is not drawn along the face."""


def outer_walls(room: DrawnRoom, thicknesses: Sequence[float | None], usual: float) -> Iterator[DrawnWall]:
    """Yields the outer walls of a room that says how thick they are, where its outline is the usual wall's middle line.

    Args:
        room: whose outline's points come clockwise or not.
        thicknesses: by edge, in the file's unit; None where it is the usual.
        usual: thickness.
    """
    pairs = list(zip(room.points, (*room.points[1:], *room.points[:1]), strict=True))
    clockwise = 1 if sum(x * next_z - next_x * z for (x, z), (next_x, next_z) in pairs) >= 0 else -1
    for (a, b), thickness in zip(pairs, thicknesses, strict=False):
        length = math.dist(a, b)
        if thickness is not None and length:
            by = clockwise * (thickness - usual) / 2 / length
            x, z = (b[1] - a[1]) * by, (a[0] - b[0]) * by
            yield DrawnWall((a[0] + x, a[1] + z), (b[0] + x, b[1] + z), thickness, room.where, room.level)


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
        for a, b in zip(room.points, (*room.points[1:], *room.points[:1]), strict=True):
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
