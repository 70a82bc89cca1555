"""The bodies of a sent room: footprints, who is on the floor, who is carried by whom.

Comes in: a Room in metres. Goes out: rectangles in integer millimetres, ids. May import: the ground floor.
"""

from __future__ import annotations

import math
from collections.abc import Container, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeVar

from solver.free_places import footprint
from solver.geometry import Rect, turned
from solver.scene import Decoration, Furniture, Room

T = TypeVar("T", Furniture, Decoration)

BODY_MM = 20
"""Furniture or a floor decoration is a body when it is higher than this (contract, Rules)."""
RESTS_MM = 20
"""How far a body's underside may be from the top it rests on."""
UNTUCKED_MM = 150
"""Depth of a tucked chair that stays outside its table (contract, rule overlap)."""

Body = Furniture | Decoration


def squared(rotation: float) -> int:
    """Returns the nearest right angle in [0, 360)."""
    return round(rotation / 90) * 90 % 360


def size_of(body: Body) -> tuple[int, int, int]:
    """Returns the unrotated extents, mm, rounded up."""
    return (
        math.ceil(body.width * 1000 - 1e-6),
        math.ceil(body.depth * 1000 - 1e-6),
        math.ceil(body.height * 1000 - 1e-6),
    )


def bounding_size(body: Body, rect: Rect) -> tuple[int, int, int]:
    """Returns the unrotated size whose footprint at the squared rotation is the rectangle."""
    width, depth = turned(rect.width, rect.depth, squared(body.rotation))
    return width, depth, size_of(body)[2]


def all_bodies(room: Room) -> tuple[Body, ...]:
    """Returns a room's furniture and decorations."""
    return (*room.furniture, *room.decorations)


def floor_bodies(room: Room) -> list[Body]:
    """Returns what the solver may move: bodies that rest on nothing else, no rugs or mats among them."""
    carried = carriers(room)
    bodies: list[Body] = [piece for piece in room.furniture if piece.id not in carried and piece.height * 1000 > BODY_MM]
    for thing in room.decorations:
        loose = thing.parent is None and thing.mounted_on_wall is None and thing.y < RESTS_MM / 1000
        if loose and thing.height * 1000 > BODY_MM:
            bodies.append(thing)
    return bodies


def carriers(room: Room) -> dict[str, str]:
    """Returns who carries whom: the id of each piece that stands on another -> that other's id."""
    known = {piece.id for piece in room.furniture}
    carried = {piece.id: piece.on for piece in room.furniture if piece.on in known and piece.on != piece.id}
    for piece in room.furniture:
        if piece.id not in carried and piece.y * 1000 > RESTS_MM:
            below = _resting_on(piece, room.furniture)
            if below is not None:
                carried[piece.id] = below.id
    return {child: parent for child, parent in carried.items() if parent is not None and not _loops(child, carried)}


def _resting_on(piece: Furniture, others: Sequence[Furniture]) -> Furniture | None:
    for other in others:
        top = other.y + other.height
        if other.id != piece.id and _over(piece, other) and other.y < piece.y and abs(top - piece.y) * 1000 <= RESTS_MM:
            return other
    return None


def _over(body: Body, other: Body) -> bool:
    """Tells whether a body's middle is over another's footprint."""
    rect = footprint(other)
    return rect.x0 < body.x * 1000 < rect.x1 and rect.z0 < body.z * 1000 < rect.z1


def _lying_in(thing: Decoration, pieces: Sequence[Furniture]) -> Furniture | None:
    """Returns the piece on or in which a thing lies that names no parent of its room: the one whose top is nearest to it."""
    within = [piece for piece in pieces if _over(thing, piece) and piece.y < thing.y <= piece.y + piece.height + RESTS_MM / 1000]
    return min(within, key=lambda piece: piece.y + piece.height, default=None)


def _loops(start: str, carried: Mapping[str, str | None]) -> bool:
    seen, at = {start}, carried.get(start)
    while at is not None:
        if at in seen:
            return True
        seen.add(at)
        at = carried.get(at)
    return False


def above(room: Room) -> dict[str, str]:
    """Returns who stands on, hangs over or lies under whom: child's id -> its parent's, or of what it lies on if it names none."""
    found, known = carriers(room), {body.id for body in all_bodies(room)}
    for thing in room.decorations:
        below = None if thing.mounted_on_wall is not None else _lying_in(thing, room.furniture)
        if thing.parent in known and thing.parent is not None:
            found[thing.id] = thing.parent
        elif below is not None and thing.y * 1000 > RESTS_MM:
            found[thing.id] = below.id
    return found


def climb(start: str, parents: Mapping[str, str], stop: Container[str] = ()) -> str:
    """Returns the first in `stop` of a body and those that carry it, or the last of them."""
    at, seen = start, {start}
    while at not in stop and at in parents and parents[at] not in seen:
        at = parents[at]
        seen.add(at)
    return at


def carried_along(thing: T, before: Body | None, after: Body | None) -> T:
    """Returns a thing moved as what carries it was; as it is where that is not there or did not move."""
    if before is None or after is None or before is after:
        return thing
    x, y, z = (round(a + c - b, 4) for a, b, c in zip(_at(thing), _at(before), _at(after), strict=True))
    pose: dict[str, Any] = {"x": x, "y": y, "z": z}
    return replace(thing, **pose)


def _at(body: Body) -> tuple[float, float, float]:
    return body.x, body.y, body.z


def tables_of(bodies: Sequence[Body]) -> dict[str, Body]:
    """Returns under which table each chair stands that names one."""
    by_id = {body.id: body for body in bodies}
    tables = {body.id: by_id.get(body.under or "") for body in bodies if isinstance(body, Furniture)}
    return {label: table for label, table in tables.items() if table is not None and table.id != label}


def too_deep_mm(chair: Body, table: Body) -> int:
    """Returns how much too far a chair is tucked: by at most its depth less 0.15 m (contract, rule overlap); 0 for none, mm."""
    own, other = footprint(chair), footprint(table)
    wide, deep = (min(own.x1, other.x1) - max(own.x0, other.x0), min(own.z1, other.z1) - max(own.z0, other.z0))
    if wide <= 0 or deep <= 0:
        return 0
    return max(0, (deep if squared(chair.rotation) % 180 == 0 else wide) - _tuck_mm(chair))


def drawn_out(chair: Furniture, table: Body) -> Furniture:
    """Returns a chair pulled out from under its table, the shorter way, until it is not tucked too far."""
    if too_deep_mm(chair, table) == 0:
        return chair
    own, other, tuck = footprint(chair), footprint(table), _tuck_mm(chair)
    if squared(chair.rotation) % 180 == 0:
        return replace(chair, z=chair.z + min(other.z0 + tuck - own.z1, other.z1 - tuck - own.z0, key=abs) / 1000)
    return replace(chair, x=chair.x + min(other.x0 + tuck - own.x1, other.x1 - tuck - own.x0, key=abs) / 1000)


def _tuck_mm(chair: Body) -> int:
    return max(0, math.floor(chair.depth * 1000 + 1e-6) - UNTUCKED_MM)
