"""Walls without rooms -> the rooms between them, in the drawing's own unit."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from statistics import median

from solver.imported import Unread
from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnRoom, DrawnWall, Spot
from solver.imports.units import told_by_doors
from solver.imports.wall_faces import STRAIGHT, faces_between, free_ends, line_between, thickness_about

NO_UNIT = "no rooms are drawn, and neither a unit nor doors tell how thick walls are: `unit` says it"
"""Why walls are left out where nothing tells how long they are."""
GAPS = "enclose no room: gaps in which no door, window or opening is drawn leave them open"
"""Why there are no rooms where each end of a wall meets another wall."""


def with_rooms_between(plan: DrawnPlan, metres: float | None) -> DrawnPlan:
    """Returns a plan that draws thick walls and no room with the rooms that its walls enclose on each level; any other as it is.

    `metres` is the length of its unit, where the caller says it.
    """
    walls = [one for one in plan.walls if one.thickness > 0 and math.dist(one.start, one.end) > 0]
    if plan.rooms or not walls:
        return plan
    unit = metres or told_by_doors(plan.openings, plan.metres)
    rooms: list[DrawnRoom] = []
    unread = list(plan.unread)
    for level in sorted({one.level for one in walls}):
        outlines = [_outline(one) for one in walls if one.level == level]
        found, _, told = rooms_between(outlines, [one for one in plan.openings if one.level == level], unit)
        rooms += (replace(room, level=level, where=f"{room.where} of level {level}") for room in found)
        unread += (replace(one, place=f"walls of level {level}") for one in told)
    return replace(plan, rooms=tuple(rooms), drawn="inner", wall_thickness=median(one.thickness for one in walls), unread=tuple(unread))


def _outline(wall: DrawnWall) -> tuple[Spot, ...]:
    """Returns the corners of a wall's footprint, the first one again at the end."""
    (x0, z0), (x1, z1) = wall.start, wall.end
    by = wall.thickness / 2 / math.dist(wall.start, wall.end)
    x, z = (z1 - z0) * by, (x0 - x1) * by
    return (x0 + x, z0 + z), (x1 + x, z1 + z), (x1 - x, z1 - z), (x0 - x, z0 - z), (x0 + x, z0 + z)


def rooms_between(
    walls: Sequence[tuple[Spot, ...]], openings: Sequence[DrawnOpening], metres: float | None
) -> tuple[list[DrawnRoom], float | None, list[Unread]]:
    """Returns the rooms that walls enclose, how thick walls are (None where they are drawn as single lines), what could not be read.

    Closed outlines repeat their first point; openings close gaps in walls. `metres` is the length of the drawing's unit, None where nothing
    tells it.
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
    if not found:
        free = free_ends(lines, gaps)
        words = f"enclose no room: {free} of their ends meet neither another wall nor an opening"
        unread.append(Unread("walls", words if free else GAPS))
    rooms = [
        DrawnRoom(tuple((x / scale + west, z / scale + north) for x, z in corners), "", f"between walls, room {at}")
        for at, corners in enumerate(found)
    ]
    thickness = thickness_about(found, lines)
    return rooms, thickness and thickness / scale, unread
