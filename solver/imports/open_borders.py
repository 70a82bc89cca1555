"""Fourth step, second half: a border without a wall runs where the furniture lets it that is drawn across it, of one room or of the other.

Nothing shows such a border but the rooms' names: moved, it lies before or behind what stands there.

Comes in: rooms' corners, walls, openings, pieces, mm. Goes out: corners. May import: rectilinear, missing_walls, drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Final, NamedTuple

from solver.geometry import doubled_area, extents
from solver.imports.drawn import DrawnOpening, DrawnPiece, DrawnPlan, PlanNotes
from solver.imports.joining import REACH
from solver.imports.missing_walls import AlongWall, unwalled
from solver.imports.rectilinear import FloorCorners, PlanEdge, edges_of_corners, holds, is_simple, tidied
from solver.imports.to_scene import NamedRoom

MOST: Final = 1000
"""A border is moved by so much at most, mm."""
FEW: Final = 30
"""By no more, mm, it is the furniture that is moved."""
BESIDE: Final = 100
"""An opening is shifted by so much at most, mm, to stay in its room's wall."""
FLAT: Final = 0.02
"""What is no higher, m, lies under others."""
OVERHEAD: Final = 2.0
"""What hangs higher, m, stands nowhere."""
LEAST: Final = 1_000_000
"""So much floor stays to a room, mm2."""


class _Standing(NamedTuple):
    """A piece: what it is called, the room that its middle is in, from where to where it reaches along x and z, mm."""

    name: str
    room: int
    x: AlongWall
    z: AlongWall

    def along(self, axis: str) -> AlongWall:
        return self.x if axis == "x" else self.z

    def across(self, axis: str) -> AlongWall:
        return self.z if axis == "x" else self.x


def with_borders_moved(rooms: Sequence[NamedRoom], plan: DrawnPlan, half: int, notes: PlanNotes) -> list[FloorCorners]:
    """Returns the corners of rooms, their borders without a wall moved to where no piece stands across them, if there is such a place.

    Args:
        rooms: of one level, along the lines of their walls.
        plan: walls; openings: a border stays where the strip it would give away has one at its end; pieces, of which those count that
            say their size.
        half: half the usual wall, mm: it is clear of furniture on either side of a border.
        notes: what was moved is noted there.
    """
    corners = [room.corners for room in rooms]
    standing = [one for piece in plan.pieces if (one := _standing(piece, corners)) is not None]
    if not standing:
        return corners
    edges = [edges_of_corners(number, own) for number, own in enumerate(corners)]
    for edge, other, span in list(unwalled(edges, plan.walls)):
        near = [one for one in standing if one.room in (edge.room, other.room) and _overlap(one.along(edge.axis), span) > 0]
        line = _line_between(edge, other, near, half) if edge.at == other.at else edge.at
        if abs(line - edge.at) <= FEW or _has_opening(plan.openings, edge.axis, span, (edge.at, line)):
            continue
        moved = [_pushed(corners[one.room], one, span, line) for one in (edge, other)]
        if all(doubled_area(one) >= 2 * LEAST and is_simple(one) for one in moved):
            corners[edge.room], corners[other.room] = moved
            names = rooms[edge.room].id, rooms[other.room].id
            words = f"its border to {names[1]}, where no wall is drawn, is moved by {abs(line - edge.at)} mm: furniture is drawn across it"
            notes.change("wall_lines", names[0], abs(line - edge.at) / 1000, words)
    return corners


def _standing(piece: DrawnPiece, corners: Sequence[FloorCorners]) -> _Standing | None:
    """Returns a piece as it stands; None where it says no size, stands in no room or in nobody's way."""
    if piece.size is None or piece.decoration or piece.size[2] <= FLAT or piece.y >= OVERHEAD:
        return None
    room = next((number for number, own in enumerate(corners) if holds(own, piece.x, piece.z)), None)
    if room is None:
        return None
    x, z = (
        (math.floor(at - size * 500), math.ceil(at + size * 500))
        for at, size in zip((piece.x, piece.z), extents(piece.size[0], piece.size[1], piece.rotation), strict=True)
    )
    return _Standing(piece.name, room, x, z)


def _overlap(one: AlongWall, other: AlongWall) -> int:
    return min(one[1], other[1]) - max(one[0], other[0])


def _line_between(edge: PlanEdge, other: PlanEdge, near: Iterable[_Standing], half: int) -> int:
    """Returns the line nearest to a border that is clear of what stands on either side of it; the border's own where there is none."""
    sides: dict[int, list[AlongWall]] = {edge.room: [], other.room: []}
    for one in near:
        sides[one.room].append(one.across(edge.axis))
    before = max((high for _, high in sides[edge.room]), default=edge.at - MOST) + half
    behind = min((low for low, _ in sides[other.room]), default=edge.at + MOST) - half
    line = min(max(edge.at, before), behind)
    return line if before <= line <= behind and abs(line - edge.at) <= MOST else edge.at


def _has_opening(openings: Sequence[DrawnOpening], axis: str, span: AlongWall, across: AlongWall) -> bool:
    """Tells whether an opening is drawn in a wall that a strip, given to the other room, would take over."""
    along, other = (0, 1) if axis == "x" else (1, 0)
    low, high = sorted(across)
    for one in openings:
        start, end = sorted((one.start[other], one.end[other]))
        middle = (one.start[along] + one.end[along]) / 2
        if min(abs(middle - at) for at in span) <= REACH and min(end, high) - max(start, low) > BESIDE:
            return True
    return False


def _pushed(corners: FloorCorners, edge: PlanEdge, span: AlongWall, line: int) -> FloorCorners:
    """Returns a room whose edge runs along another line over a span of it; no corners where that edge is moved already."""
    same = (one for one in edges_of_corners(edge.room, corners) if (one.axis, one.at, one.out) == (edge.axis, edge.at, edge.out))
    side = next((one.side for one in same if one.low <= span[0] and span[1] <= one.high), None)
    if side is None:
        return []
    along = 0 if edge.axis == "x" else 1
    first, last = span if corners[side][along] < corners[(side + 1) % len(corners)][along] else span[::-1]
    spots = [(first, edge.at), (first, line), (last, line), (last, edge.at)]
    added = spots if edge.axis == "x" else [(z, x) for x, z in spots]
    return tidied([*corners[: side + 1], *added, *corners[side + 1 :]])
