"""The ways a sent body may stand: where it was sent, at another wall, in another's frame, or not moved at all.

Comes in: a body as sent. Goes out: alternatives. May import: the ground floor.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from solver.free_places import footprint
from solver.geometry import OPPOSITE, ROTATION_AT_WALL, Rect, rotate, strip, turned
from solver.repair.bodies import Body, bounding_size, size_of, squared
from solver.repair.wishes import Wishes
from solver.scene import Furniture
from solver.wanted import Alternative, Attach

MOVED_WEIGHT = 20.0
"""Weight of a piece the user has just moved against 1 for the others."""
OTHER_WALL_COST = 4.0
"""What standing at another wall than the sent one costs: as much as moving 2 m."""
OTHER_EDGE_COST = 0.05
"""What standing at another stretch of the sent wall costs, where an outline has several."""
WALL_FAR_MM = 200
"""Contract, rule wall_far: a piece whose wall is set stays within this of the wall's line."""

Edge = tuple[str, int, int, int]
"""A stretch of wall line: the wall it is part of, its coordinate across, and its ends along, mm."""


@dataclass(frozen=True)
class Walls:
    """The walls of a room, for the pieces that hug them, mm.

    Args:
        clear: the bounding rectangle of the wall lines, half a wall in.
        half_mm: half a wall's thickness.
        inner: edges of an outline, those on the bounding rectangle left aside.
    """

    clear: Rect
    half_mm: int
    inner: tuple[Edge, ...] = ()


def held(body: Body, table: Body | None) -> Alternative:
    """The one way of a body that stays: its bounding rectangle where it is."""
    rect = footprint(body)
    middle = ((rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2)
    return Alternative(
        body.name,
        bounding_size(body, rect),
        squared(body.rotation),
        anchor_mm=middle,
        within=rect,
        bottom_mm=round(body.y * 1000),
        under=table.id if table else None,
    )


def carried(child: Body, parent: Body) -> Alternative:
    """The one way of a body that keeps its place in another's frame."""
    turn = squared(parent.rotation)
    own, other = footprint(child), footprint(parent)
    dx = (own.x0 + own.x1 - other.x0 - other.x1) // 2
    dz = (own.z0 + own.z1 - other.z0 - other.z1) // 2
    across, along = rotate(dx, dz, -turn % 360)
    attach = Attach(parent.id, parent.name, (across, across), (along, along))
    rotation = (squared(child.rotation) - turn) % 360
    return Alternative(child.name, bounding_size(child, own), rotation, attach=attach)


def loose(body: Body, walls: Walls, wishes: Wishes) -> tuple[Alternative, ...]:
    """The ways of a loose body, least costly first: as sent; for one with a wall also at the other walls."""
    sent = _as_sent(body, wishes)
    wall = body.wall if isinstance(body, Furniture) else None
    if wall is None:
        return (sent,)
    turn = (sent.rotation - ROTATION_AT_WALL[wall]) % 360
    found = []
    for other in (wall, *_beside(wall), OPPOSITE[wall]):
        way = replace(sent, rotation=(ROTATION_AT_WALL[other] + turn) % 360, cost=0.0 if other == wall else OTHER_WALL_COST)
        at_wall = _at_wall(way, other, walls)
        if other == wall:
            rect = footprint(body)
            at_wall.sort(key=lambda stretch: _outside(rect, stretch[1]))
            at_wall[1:] = [(replace(later, cost=OTHER_EDGE_COST), region) for later, region in at_wall[1:]]
        found += [stretch for stretch, _ in at_wall]
    return tuple(found)


def _as_sent(body: Body, wishes: Wishes) -> Alternative:
    weight = MOVED_WEIGHT if body.id in wishes.moved else 1.0
    anchor = (math.floor(body.x * 1000 + 0.5), math.floor(body.z * 1000 + 0.5))  # the snap takes halves down again
    weights = (weight, weight)
    return Alternative(body.name, size_of(body), squared(body.rotation), None, anchor, weights, bottom_mm=round(body.y * 1000))


def _at_wall(way: Alternative, wall: str, walls: Walls) -> list[tuple[Alternative, Rect]]:
    """Returns a way at each stretch of one wall, and where its footprint may be there: at inner edges at least half before them."""
    width, depth = turned(way.size_mm[0], way.size_mm[1], way.rotation)
    across, along = (depth, width) if wall in ("north", "south") else (width, depth)
    slack = WALL_FAR_MM - walls.half_mm
    outer = strip(walls.clear, wall, walls.clear.along(wall), across + slack)
    found = [(replace(way, wall=wall, slack_mm=slack), outer)]
    for name, line, start, end in walls.inner:
        if name == wall:
            region = _before(walls, (name, line, start - along // 2, end + along // 2), across + slack)
            found.append((replace(way, wall=None, within=region), region))
    return found


def _before(walls: Walls, edge: Edge, deep: int) -> Rect:
    """Returns the clear rectangle before an edge, from the wall's face on, `deep` mm into the room."""
    wall, line, start, end = edge
    face = line + walls.half_mm if wall in ("north", "west") else line - walls.half_mm
    low, high = (face, face + deep) if wall in ("north", "west") else (face - deep, face)
    r = Rect(start, low, end, high) if wall in ("north", "south") else Rect(low, start, high, end)
    clear = walls.clear
    return Rect(max(r.x0, clear.x0), max(r.z0, clear.z0), min(r.x1, clear.x1), min(r.z1, clear.z1))


def _outside(rect: Rect, region: Rect) -> int:
    """Returns how far a footprint has to move to lie in a region, mm, both axes added."""
    return max(0, region.x0 - rect.x0, rect.x1 - region.x1) + max(0, region.z0 - rect.z0, rect.z1 - region.z1)


def _beside(wall: str) -> tuple[str, str]:
    return ("east", "west") if wall in ("north", "south") else ("north", "south")
