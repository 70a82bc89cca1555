"""Near the last answer: while a piece is dragged, the others stay where they were unless elsewhere is clearly better.

Comes in: wanted pieces and the poses of the last answer. Goes out: wanted pieces that may only stand near those.
May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from solver.geometry import Rect, rotate, turned
from solver.repair.bodies import squared
from solver.repair.wishes import Wishes
from solver.scene import Pose
from solver.wanted import Alternative, Attach, Wanted

REACH_MM = 200
"""How far along each axis a piece may go from its last pose without having jumped."""
SAME_MM = 2
"""Two places that differ by no more are the same: odd millimetres turned by 90 degrees are."""

Poses = Mapping[str, Pose]


def near_previous(wanted: Sequence[Wanted], clear: Rect, poses: Poses, wishes: Wishes) -> tuple[Wanted, ...] | None:
    """Restricts pieces to the wall, the rotation and the neighbourhood of their last poses.

    Args:
        wanted: all pieces of a room.
        clear: the room's clear rectangle.
        poses: of the last answer, by id; pieces without one are free.
        wishes: pieces that were just moved are free too.

    Returns:
        The restricted pieces; None where none of them has a pose or one can have no such way.
    """
    found = []
    for piece in wanted:
        bound = piece.label in poses and piece.label not in wishes.moved
        found.append(replace(piece, alternatives=_near(piece, clear, poses)) if bound else piece)
    unbound = all(new is old for new, old in zip(found, wanted, strict=True))
    return None if unbound or any(not piece.alternatives for piece in found) else tuple(found)


def _near(piece: Wanted, clear: Rect, poses: Poses) -> tuple[Alternative, ...]:
    """Returns the ways that hold at a pose: at the parent's side where it was there, else near where it was."""
    ways, pose = piece.alternatives, poses[piece.label]
    attached = tuple(way for way in ways if way.attach is not None)
    if attached and (len(attached) == len(ways) or all(_was_there(pose, way.attach, poses) for way in attached)):
        return attached
    free = (_around(way, clear, pose) for way in ways if way.attach is None)
    return tuple(way for way in free if way is not None)


def _was_there(own: Pose, attach: Attach | None, poses: Poses) -> bool:
    parent = poses.get(attach.parent) if attach else None
    if parent is None or attach is None:
        return False
    dx, dz = round((own.x - parent.x) * 1000), round((own.z - parent.z) * 1000)
    across, along = rotate(dx, dz, -squared(parent.rotation) % 360)
    return abs(across - attach.across_mm[0]) <= SAME_MM and abs(along - attach.along_mm[0]) <= SAME_MM


def _around(way: Alternative, clear: Rect, pose: Pose) -> Alternative | None:
    """Returns a way kept within reach of a pose, or None where it is another rotation or lies elsewhere."""
    width, depth = turned(way.size_mm[0], way.size_mm[1], way.rotation)
    bounds = way.within or clear
    if (bounds.width, bounds.depth) == (width, depth):
        return way
    if way.rotation != squared(pose.rotation):
        return None
    x, z = round(pose.x * 1000 - width / 2), round(pose.z * 1000 - depth / 2)
    low = max(x - REACH_MM, bounds.x0), max(z - REACH_MM, bounds.z0)
    high = min(x + width + REACH_MM, bounds.x1), min(z + depth + REACH_MM, bounds.z1)
    near = Rect(*low, *high)
    return replace(way, within=near) if near.width >= width and near.depth >= depth else None
