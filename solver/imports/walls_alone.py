"""Shapes of walls without rooms -> the rooms between them, in the drawing's own unit.

Comes in: outlines and lines of walls, openings, texts. Goes out: `DrawnRoom`s along the faces of walls. May import: wall_faces.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from solver.imported import Unread
from solver.imports.drawn import DrawnOpening, DrawnRoom, Spot
from solver.imports.wall_faces import STRAIGHT, faces_between, line_between, thickness_about

NO_UNIT = "no rooms are drawn, and neither a unit nor doors tell how thick walls are: `unit` says it"
"""Why walls are left out where nothing tells how long they are."""


def rooms_between(
    walls: Sequence[tuple[Spot, ...]], openings: Sequence[DrawnOpening], metres: float | None
) -> tuple[list[DrawnRoom], float | None, list[Unread]]:
    """Returns the rooms that walls enclose, how thick walls are (None where they are drawn as single lines), what could not be read.

    Args:
        walls: points of lines and outlines; closed outlines repeat their first point.
        openings: by which gaps in walls are closed.
        metres: the length of the drawing's unit, None where nothing tells it.
    """
    if metres is None:
        return [], None, [Unread("walls", NO_UNIT)]
    scale, (west, north) = metres * 1000, walls[0][0]

    def there(spot: Spot) -> Spot:
        return (spot[0] - west) * scale, (spot[1] - north) * scale

    pairs = [(there(a), there(b)) for points in walls for a, b in pairwise(points)]
    lines = [line for a, b in pairs if (line := line_between(a, b))]
    slanted = sum(1 for a, b in pairs if min(abs(a[0] - b[0]), abs(a[1] - b[1])) > STRAIGHT)
    unread = [Unread("walls", f"{slanted} slanted or curved lines: rooms are looked for between straight ones")] if slanted else []
    gaps = [line for one in openings if (line := line_between(there(one.start), there(one.end)))]
    found = faces_between(lines, gaps)
    if found is None:
        return [], None, [*unread, Unread("walls", f"{len(lines):,} lines: too many to look for rooms between them")]
    rooms = [
        DrawnRoom(tuple((x / scale + west, z / scale + north) for x, z in corners), "", f"between walls, room {at}")
        for at, corners in enumerate(found)
    ]
    thickness = thickness_about(found, lines)
    return rooms, thickness and thickness / scale, unread
