"""Placed poses -> the room, with all that is carried.

Comes in: a Room and Placed bodies. Goes out: the Room. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

from solver.geometry import FACING, ROTATION_AT_WALL, WALL_BEHIND, half_m
from solver.repair.bodies import Body, above, all_bodies, climb, squared
from solver.repair.wishes import Wishes
from solver.scene import Decoration, Dynamic, Furniture, Room
from solver.wanted import Placed

T = TypeVar("T", Furniture, Decoration)
Moved = Mapping[str, tuple[Body, Body]]


def written_back(room: Room, placed: Iterable[Placed], wishes: Wishes) -> Room:
    """Returns the room with the placed poses; what is carried by a piece follows it."""
    poses = {p.label: p for p in placed}
    parents = above(room)
    moved: dict[str, tuple[Body, Body]] = {}
    for body in all_bodies(room):
        p = poses.get(body.id)
        if p is not None and not wishes.is_locked(body):
            moved[body.id] = (body, _at(body, p, carried=body.id in parents))
    furniture = tuple(_after(piece, moved, parents) for piece in room.furniture)
    decorations = tuple(_after(thing, moved, parents) for thing in room.decorations)
    return replace(room, furniture=furniture, decorations=decorations)


def without(room: Room, gone: frozenset[str]) -> Room:
    """Returns the room without the bodies of those ids and all that they carry."""
    parents = above(room)
    furniture = tuple(piece for piece in room.furniture if climb(piece.id, parents, gone) not in gone)
    decorations = tuple(thing for thing in room.decorations if climb(thing.id, parents, gone) not in gone)
    return replace(room, furniture=furniture, decorations=decorations)


def _at(body: Body, p: Placed, carried: bool) -> Body:
    """Returns the body at its placed pose; what is carried keeps its own angle in the frame of what carries it."""
    x, z = half_m(p.footprint.x0 + p.footprint.x1), half_m(p.footprint.z0 + p.footprint.z1)
    rotation: float = p.rotation
    if carried:
        rotation = (body.rotation + p.rotation - squared(body.rotation)) % 360
    if isinstance(body, Furniture):
        return replace(body, x=x, z=z, rotation=rotation, wall=body.wall if carried else _wall(body, p))
    return replace(body, x=x, z=z, rotation=rotation)


def _wall(piece: Furniture, p: Placed) -> str | None:
    """Returns the wall a piece stands at now: its back keeps its angle to the wall, at inner edges of an outline too."""
    if piece.wall is None:
        return None
    if p.wall is not None or p.chosen.attach is not None:
        return p.wall
    return WALL_BEHIND[(ROTATION_AT_WALL[piece.wall] + p.rotation - squared(piece.rotation)) % 360]


def _after(thing: T, moved: Moved, parents: Mapping[str, str]) -> T:
    """Returns a thing where it was placed, or where what carries it took it."""
    mover = climb(thing.id, parents, moved)
    if mover not in moved:
        return thing
    after = moved[mover][1]
    if mover == thing.id and isinstance(after, type(thing)):
        return after
    x, z, rotation, turn = carried_pose(thing, *moved[mover])
    pose: dict[str, Any] = {"x": x, "z": z, "rotation": rotation}
    if isinstance(thing, Decoration) and thing.mounted_on_wall is not None:
        pose["mounted_on_wall"] = WALL_BEHIND[(ROTATION_AT_WALL[thing.mounted_on_wall] + turn) % 360]
    return replace(thing, **pose)


def carried_pose(thing: Body | Dynamic, before: Body, after: Body) -> tuple[float, float, float, int]:
    """Returns x, z and rotation of a thing that keeps its place in the frame of what carries it, and the turn."""
    turn = (squared(after.rotation) - squared(before.rotation)) % 360
    tx, tz = _turned_offset(thing.x - before.x, thing.z - before.z, turn)
    rotation = (thing.rotation + turn) % 360 if turn else thing.rotation
    return round(after.x + tx, 4), round(after.z + tz, 4), rotation, turn


def _turned_offset(dx: float, dz: float, turn: int) -> tuple[float, float]:
    fx, fz = FACING[turn]
    return dx * fz + dz * fx, dz * fz - dx * fx
