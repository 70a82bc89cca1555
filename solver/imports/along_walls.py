"""Whether rooms are drawn along their walls' middle lines or along the inner faces, measured at the walls that the file draws."""

import math
from collections.abc import Sequence
from statistics import median
from typing import Final

import numpy as np

from solver.geometry import edges_round
from solver.imports.drawn import DrawnAlong, DrawnRoom, DrawnWall

PARALLEL: Final = 0.02
"""The sine of the largest angle between a room's edge and its wall."""
THINNER: Final = 10.0
"""What is as much thinner than a file's thickest wall is no wall."""
WITHIN: Final = 0.2
"""An edge that lies deeper in its wall than this share of the thinnest one is not drawn along the face."""


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
