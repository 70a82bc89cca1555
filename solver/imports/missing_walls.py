"""Fifth step, second half: where the file draws no wall between two rooms there is a passage; and niches at doors are part of the wall."""

import math
from collections.abc import Container, Iterable, Sequence
from typing import Final

import numpy as np

from solver.geometry import gaps_between
from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnWall, PlanNotes, Spot
from solver.imports.joining import Joined
from solver.imports.rectilinear import FloorCorner, FloorCorners, PlanEdge, tidied
from solver.imports.shape_openings import between, to_lines
from solver.imports.wall_depths import FacingEdges

WALL_REACH: Final = 200
"""How far from a room's edge its wall may be drawn, mm, or as half of what the file's walls are thick, if that is more."""
NARROWEST: Final = 600
"""A gap in the walls that is a passage is wider, mm."""
WIDEST: Final = 2000
"""A gap between the faces of walls that is a passage is no wider, mm."""
NICHE: Final = 200
"""A niche at a door is no deeper, mm, or than to the middle of the wall that is drawn there, if that is more."""
SHALLOW: Final = 40
"""A niche that is no deeper, mm, is none, whether there is a door or not."""
MOVED: Final = 90
"""No farther, mm, are straightened corners from where they are drawn; steps before slanted walls are deeper."""
AlongWall = tuple[int, int]


def passages(
    rooms: Sequence[Sequence[PlanEdge]], plan: DrawnPlan, found: Sequence[Joined], apart: Container[int], notes: PlanNotes
) -> list[Joined]:
    """Returns passages where two rooms meet and no wall is drawn between them; none where the file draws no walls at all.

    Of walls of which it draws the faces alone, one is missing where some of it is there, and the gap no wider than a passage.
    Two rooms that are `apart` have none, such as gardens that each have a door: files draw no railings, and what is there would be moved.
    """
    walls = plan.walls or [DrawnWall(a, b, 0.0) for a, b in plan.faces]
    facing, edges = FacingEdges(rooms), [edge for room in rooms for edge in room if edge.out > 0] if walls else []
    reach, made = max(WALL_REACH, (plan.wall_thickness or 0.0) / 2 + SHALLOW), list[Joined]()
    for edge in edges:
        for other, common in sorted(facing.across(edge)):
            if common < NARROWEST or (edge.room in apart and other.room in apart):
                continue
            span = (max(edge.low, other.low), min(edge.high, other.high))
            taken = [_of_wall(wall, edge, reach) for wall in walls] + [
                (one.low, one.high) for one in found if edge in one.edges or other in one.edges
            ]
            for low, high in _left(span, (part for part in taken if part)):
                is_gap = plan.walls or (high - low <= WIDEST and span != (low, high))
                if high - low >= NARROWEST and is_gap:
                    walls_of = tuple(sorted((edge, other), key=lambda one: one.room))
                    made.append(Joined(_drawn(edge, low, high), low, high, walls_of, None, None))
                    notes.change("join", f"passage_{len(made) - 1}", (high - low) / 1000, "no wall is drawn between two rooms: a passage")
    return made


def _drawn(edge: PlanEdge, low: int, high: int) -> DrawnOpening:
    ends = ((low, edge.at), (high, edge.at)) if edge.axis == "x" else ((edge.at, low), (edge.at, high))
    return DrawnOpening("passage", *ends, "where no wall is drawn")


def _of_wall(wall: DrawnWall, edge: PlanEdge, reach: float) -> AlongWall | None:
    """Returns what a wall covers of an edge's line."""
    along, across = (0, 1) if edge.axis == "x" else (1, 0)
    run, rise = abs(wall.end[along] - wall.start[along]), abs(wall.end[across] - wall.start[across])
    line = (wall.start[across] + wall.end[across]) / 2
    if rise > run / 2 or abs(line - edge.at) > reach + wall.thickness / 2:
        return None
    low, high = sorted((wall.start[along], wall.end[along]))
    return math.floor(low - wall.thickness / 2), math.ceil(high + wall.thickness / 2)


def _left(span: AlongWall, taken: Iterable[AlongWall]) -> list[AlongWall]:
    """Returns the stretches of a span that nothing takes, each as long as one whose middle is on whole mm."""
    return [(low, high - (high - low) % 2) for low, high in gaps_between(span, taken)]


def without_niches(
    corners: FloorCorners, drawn: Sequence[Spot], openings: Sequence[DrawnOpening], walls: Sequence[DrawnWall]
) -> tuple[FloorCorners, int]:
    """Returns a room without the niches that its outline makes at doors, and how deep the deepest was, mm.

    Steps before the slanted walls of a bay are none: `drawn` are the corners of the outline as it is drawn. The narrowest goes first:
    what is between two others, at the ends of a wall, looks like one too.
    """
    deepest = 0
    for _ in range(len(corners)):
        count = len(corners)
        found = [at for at in range(count) if count > 4 and _is_niche(corners, at, drawn, openings, walls)]
        if not found:
            break
        niche = min(found, key=lambda at: math.dist(corners[at], corners[(at + 1) % count]))
        b, c = corners[niche], corners[(niche + 1) % count]
        deepest = max(deepest, math.floor(math.dist(corners[niche - 1], b)))
        corners = tidied([one for one in corners if one not in (b, c)])
    return corners, deepest


def _is_niche(corners: FloorCorners, at: int, drawn: Sequence[Spot], openings: Sequence[DrawnOpening], walls: Sequence[DrawnWall]) -> bool:
    """Tells whether the edge from a corner on is the bottom of a niche: its sides lead back to one line, no deeper than a reveal."""
    count = len(corners)
    a, b, c, d = (corners[(at + step) % count] for step in (-1, 0, 1, 2))
    inwards = (a[0] - b[0], a[1] - b[1])
    way = (c[0] - b[0], c[1] - b[1])
    depth = abs(inwards[0]) + abs(inwards[1])
    if inwards != (d[0] - c[0], d[1] - c[1]) or depth == 0 or way[0] * inwards[1] - way[1] * inwards[0] <= 0:
        return False
    if depth <= SHALLOW:
        return True
    are_drawn = all(any(math.dist(one, spot) <= MOVED for spot in drawn) for one in (a, d))
    return are_drawn and any(depth <= _reveal(one, walls) for one in openings if _lies_in(one, b, c))


def _reveal(opening: DrawnOpening, walls: Sequence[DrawnWall]) -> float:
    """Returns how deep a niche at an opening may be, mm: up to the middle of its wall, but for what is lost by whole mm."""
    spot = between(opening.start, opening.end)
    deep = (one for one in walls if one.thickness > 2 * NICHE)
    return max((NICHE, *(one.thickness / 2 + 1 for one in deep if to_lines(spot, np.array([(*one.start, *one.end)])) <= one.thickness / 2)))


def _lies_in(opening: DrawnOpening, b: FloorCorner, c: FloorCorner) -> bool:
    """Tells whether an opening lies at an edge and covers half of it."""
    along, across = (0, 1) if b[1] == c[1] else (1, 0)
    low, high = sorted((b[along], c[along]))
    start, end = sorted((opening.start[along], opening.end[along]))
    middle = (opening.start[across] + opening.end[across]) / 2
    return abs(middle - b[across]) <= 2 * NICHE and min(high, end) - max(low, start) >= (high - low) / 2
