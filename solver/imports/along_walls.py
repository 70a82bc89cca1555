"""Whether rooms are drawn along their walls' middle lines or along the inner faces, measured at the walls that the file draws.

Comes in: rooms and walls as drawn. Goes out: a `DrawnAlong`, and the usual thickness. May import: drawn.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import median
from typing import Final

import numpy as np

from solver.imports.drawn import DrawnAlong, DrawnRoom, DrawnWall

PARALLEL: Final = 0.02
"""The sine of the largest angle between a room's edge and its wall."""


def drawn_along(rooms: Sequence[DrawnRoom], walls: Sequence[DrawnWall]) -> tuple[DrawnAlong, float | None]:
    """Returns what rooms are drawn along, `inner` faces where there are no walls to tell; and the walls' usual thickness."""
    solid = [wall for wall in walls if wall.thickness > 0 and math.dist(wall.start, wall.end) > 0]
    if not solid:
        return "inner", None
    starts, ends = np.array([wall.start for wall in solid]), np.array([wall.end for wall in solid])
    lengths = np.linalg.norm(ends - starts, axis=1)
    ways, thick = (ends - starts) / lengths[:, None], np.array([wall.thickness for wall in solid])
    levels = np.array([wall.level for wall in solid])
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
                on_line += length * bool(across[nearest] < thick[nearest] / 4)
    return ("lines" if on_line > measured / 2 else "inner"), float(median(thick.tolist()))
