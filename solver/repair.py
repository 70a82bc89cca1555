"""A room as sent -> wanted pieces whose anchors are the sent poses: /fix is no second solver.

Comes in: a Room and its Space. Goes out: Wanted pieces in order of importance, and a Room with the placed poses written
back, what stands on or hangs over a piece moved and turned with it. May import: the ground floor. Not here: solving.
"""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from solver.geometry import FACING, OPPOSITE, ROTATION_AT_WALL, WALL_BEHIND, Rect, half_m, rotate, turned
from solver.scene import Decoration, Furniture, Room
from solver.wanted import Alternative, Attach, Placed, Wanted

MOVED_WEIGHT = 20.0
"""Weight of a piece the user has just moved against 1 for the others."""
OTHER_WALL_COST = 4.0
"""What standing at another wall than the sent one costs: as much as moving 2 m."""
WALL_FAR_MM = 200
"""Contract, rule wall_far: a piece whose wall is set stays within this of the wall's line."""
BODY_MM = 20
"""A floor decoration is a body when it is higher than this (contract, Rules)."""
RESTS_MM = 20
"""How far a body's underside may be from the top it rests on."""

UNTUCKED_MM = 150
"""Depth of a tucked chair that stays outside its table (contract, rule overlap)."""
FREE_COST = 1.0
"""What leaving its table costs a tucked chair."""

Body = Furniture | Decoration
T = TypeVar("T", Furniture, Decoration)
Moved = Mapping[str, tuple[Body, Body]]


@dataclass(frozen=True)
class Wishes:
    """Who is wished what: locked ids stay to the millimetre, moved ids are held most strongly."""

    locked: frozenset[str] = frozenset()
    moved: frozenset[str] = frozenset()
    required_kinds: frozenset[str] = frozenset()

    def is_locked(self, body: Body) -> bool:
        """Tells whether the body must stay exactly as sent."""
        return body.id in self.locked or (isinstance(body, Furniture) and body.locked)


def squared(rotation: float) -> int:
    """Returns the nearest right angle in [0, 360)."""
    return round(rotation / 90) * 90 % 360


def footprint(body: Body) -> Rect:
    """Returns the bounding rectangle of a sent body, mm, rounded outwards by less than a millimetre."""
    angle = math.radians(body.rotation % 360)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    if body.rotation % 90 == 0:
        c, s = round(c), round(s)
    width, depth = body.width * c + body.depth * s, body.width * s + body.depth * c
    sides = (body.x - width / 2, body.z - depth / 2, body.x + width / 2, body.z + depth / 2)
    low, high = [math.floor(v * 1000 + 1e-6) for v in sides[:2]], [math.ceil(v * 1000 - 1e-6) for v in sides[2:]]
    return Rect(low[0], low[1], high[0], high[1])


def all_bodies(room: Room) -> tuple[Body, ...]:
    """Returns a room's furniture and decorations."""
    return (*room.furniture, *room.decorations)


def floor_bodies(room: Room) -> list[Body]:
    """Returns what the solver may move: furniture that rests on nothing else, and floor decorations that are bodies."""
    carried = carriers(room)
    bodies: list[Body] = [piece for piece in room.furniture if piece.id not in carried]
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
        inside = abs(piece.x - other.x) * 2 < other.width and abs(piece.z - other.z) * 2 < other.depth
        if other.id != piece.id and inside and other.y < piece.y and abs(top - piece.y) * 1000 <= RESTS_MM:
            return other
    return None


def _loops(start: str, carried: Mapping[str, str | None]) -> bool:
    seen, at = {start}, carried.get(start)
    while at is not None:
        if at in seen:
            return True
        seen.add(at)
        at = carried.get(at)
    return False


def wanted_as_sent(room: Room, thickness_mm: int, wishes: Wishes) -> tuple[Wanted, ...]:
    """Turns a sent room into wanted pieces, most important first; every piece is to be kept.

    Args:
        room: the room as sent.
        thickness_mm: the scene's wall thickness.
        wishes: what is locked and what was moved.
    """
    bodies = floor_bodies(room)
    by_id = {body.id: body for body in bodies}
    slack_mm = WALL_FAR_MM - thickness_mm // 2
    tucked = {body.id: table for body in bodies if (table := _table_of(body, by_id)) is not None}
    held = {table.id for chair, table in tucked.items() if wishes.is_locked(by_id[chair])}
    above = carriers(room)
    held |= {_climb(piece.id, above) for piece in room.furniture if wishes.is_locked(piece)}
    pieces = []
    for k in sorted(range(len(bodies)), key=lambda k: _importance(bodies[k], wishes, k)):
        body, table = bodies[k], tucked.get(bodies[k].id)
        if wishes.is_locked(body) or body.id in held:
            alternatives: tuple[Alternative, ...] = (_held(body, table),)
        elif table is not None:
            free = tuple(replace(way, cost=way.cost + FREE_COST) for way in _ways(body, slack_mm, wishes))
            alternatives = (replace(_with(body, table), under=table.id), *free)
        else:
            alternatives = _ways(body, slack_mm, wishes)
        pieces.append(Wanted(body.id, True, alternatives))
    return (*pieces, *_carried(room, by_id))


def _carried(room: Room, floor: Mapping[str, Body]) -> list[Wanted]:
    """What stands on other pieces, rigid in the frame of the piece on the floor below it."""
    above = carriers(room)
    pieces = []
    for piece in room.furniture:
        root = floor.get(_climb(piece.id, above))
        if piece.id in above and root is not None:
            way = replace(_with(_brought_back(piece, root), root), on=above[piece.id], bottom_mm=round(piece.y * 1000))
            pieces.append(Wanted(piece.id, True, (way,)))
    return pieces


def _brought_back(piece: Furniture, root: Body) -> Furniture:
    """Returns a carried piece brought back over what carries it, where its centre is not over it any more."""
    below, own = footprint(root), footprint(piece)
    x, z = piece.x, piece.z
    if not below.x0 <= x * 1000 <= below.x1:
        x = _nearest(x, below.x0, below.x1, own.width)
    if not below.z0 <= z * 1000 <= below.z1:
        z = _nearest(z, below.z0, below.z1, own.depth)
    return replace(piece, x=x, z=z)


def _nearest(at: float, low: int, high: int, extent: int) -> float:
    """Returns the centre nearest to `at`, m, at which the extent lies within [low, high], mm, or their middle."""
    first, last = low + extent / 2, high - extent / 2
    return (low + high) / 2000 if first > last else min(max(at, first / 1000), last / 1000)


def _importance(body: Body, wishes: Wishes, k: int) -> tuple[bool, bool, bool, bool, float, int]:
    """Sorts locked before moved before required before large; what is tucked under something comes after it."""
    tucked = isinstance(body, Furniture) and body.under is not None
    required = body.name in wishes.required_kinds
    locked = wishes.is_locked(body)
    return (not locked, tucked, body.id not in wishes.moved, not required, -body.width * body.depth, k)


def _size(body: Body) -> tuple[int, int, int]:
    return (
        math.ceil(body.width * 1000 - 1e-6),
        math.ceil(body.depth * 1000 - 1e-6),
        math.ceil(body.height * 1000 - 1e-6),
    )


def _held(body: Body, table: Body | None) -> Alternative:
    """The one way of a body that stays: its bounding rectangle where it is."""
    rect = footprint(body)
    return Alternative(
        body.name,
        _bounding_size(body, rect),
        squared(body.rotation),
        anchor_mm=_middle(rect),
        within=rect,
        bottom_mm=round(body.y * 1000),
        under=table.id if table else None,
    )


def _bounding_size(body: Body, rect: Rect) -> tuple[int, int, int]:
    """Returns the unrotated size whose footprint at the squared rotation is the rectangle."""
    width, depth = turned(rect.width, rect.depth, squared(body.rotation))
    return width, depth, _size(body)[2]


def _middle(rect: Rect) -> tuple[int, int]:
    return (rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2


def _ways(body: Body, slack_mm: int, wishes: Wishes) -> tuple[Alternative, ...]:
    """The ways of a loose body: as sent; for one with a wall also at the other walls."""
    weight = MOVED_WEIGHT if body.id in wishes.moved else 1.0
    rotation = squared(body.rotation)
    wall = body.wall if isinstance(body, Furniture) else None
    sent = Alternative(
        body.name,
        _size(body),
        rotation,
        wall,
        (round(body.x * 1000), round(body.z * 1000)),
        (weight, weight),
        bottom_mm=round(body.y * 1000),
        slack_mm=None if wall is None else slack_mm,
    )
    if wall is None:
        return (sent,)
    turn = (rotation - ROTATION_AT_WALL[wall]) % 360
    others = [
        replace(sent, wall=other, rotation=(ROTATION_AT_WALL[other] + turn) % 360, cost=OTHER_WALL_COST)
        for other in (*_beside(wall), OPPOSITE[wall])
    ]
    return (sent, *others)


def _beside(wall: str) -> tuple[str, str]:
    return ("east", "west") if wall in ("north", "south") else ("north", "south")


def _table_of(chair: Body, others: Mapping[str, Body]) -> Body | None:
    """Returns the table a chair is tucked under by at most its depth less 0.15 m (contract, rule overlap)."""
    table = others.get(chair.under or "") if isinstance(chair, Furniture) else None
    if table is None or table.id == chair.id:
        return None
    a, b = footprint(chair), footprint(table)
    deep = min(min(a.x1, b.x1) - max(a.x0, b.x0), min(a.z1, b.z1) - max(a.z0, b.z0))
    return table if deep <= round(chair.depth * 1000) - UNTUCKED_MM else None


def _with(child: Body, parent: Body) -> Alternative:
    """The one way of a body that keeps its place in another's frame."""
    turn = squared(parent.rotation)
    own, other = footprint(child), footprint(parent)
    dx = (own.x0 + own.x1 - other.x0 - other.x1) // 2
    dz = (own.z0 + own.z1 - other.z0 - other.z1) // 2
    across, along = rotate(dx, dz, -turn % 360)
    attach = Attach(parent.id, parent.name, (across, across), (along, along))
    rotation = (squared(child.rotation) - turn) % 360
    return Alternative(child.name, _bounding_size(child, own), rotation, attach=attach)


def written_back(room: Room, placed: Iterable[Placed], wishes: Wishes) -> Room:
    """Returns the room with the placed poses; what is carried by a piece follows it."""
    poses = {p.label: p for p in placed}
    above = _above(room)
    moved: dict[str, tuple[Body, Body]] = {}
    for body in all_bodies(room):
        p = poses.get(body.id)
        if p is not None and not wishes.is_locked(body):
            moved[body.id] = (body, _at(body, p, carried=body.id in above))
    furniture = tuple(_after(piece, moved, above) for piece in room.furniture)
    decorations = tuple(_after(thing, moved, above) for thing in room.decorations)
    return replace(room, furniture=furniture, decorations=decorations)


def _above(room: Room) -> dict[str, str]:
    """Returns who stands on, hangs over or lies under whom: child's id -> its parent's."""
    return {**carriers(room), **{thing.id: thing.parent for thing in room.decorations if thing.parent is not None}}


def without(room: Room, gone: frozenset[str]) -> Room:
    """Returns the room without the bodies of those ids and all that they carry."""
    above = _above(room)
    furniture = tuple(piece for piece in room.furniture if _climb(piece.id, above) not in gone)
    decorations = tuple(thing for thing in room.decorations if _climb(thing.id, above) not in gone)
    return replace(room, furniture=furniture, decorations=decorations)


def _climb(start: str, above: Mapping[str, str], stop: Container[str] = ()) -> str:
    """Returns the first in `stop` of a body and those that carry it, or the last of them."""
    at, seen = start, {start}
    while at not in stop and at in above and above[at] not in seen:
        at = above[at]
        seen.add(at)
    return at


def _at(body: Body, p: Placed, carried: bool) -> Body:
    """Returns the body at its placed pose; what is carried keeps its own angle in the frame of what carries it."""
    x, z = half_m(p.footprint.x0 + p.footprint.x1), half_m(p.footprint.z0 + p.footprint.z1)
    rotation: float = p.rotation
    if carried:
        rotation = (body.rotation + p.rotation - squared(body.rotation)) % 360
    if isinstance(body, Furniture):
        return replace(body, x=x, z=z, rotation=rotation, wall=p.wall if body.wall and not carried else body.wall)
    return replace(body, x=x, z=z, rotation=rotation)


def _after(thing: T, moved: Moved, above: Mapping[str, str]) -> T:
    """Returns a thing where it was placed, or where what carries it took it."""
    mover = _climb(thing.id, above, moved)
    if mover not in moved:
        return thing
    after = moved[mover][1]
    if mover == thing.id and isinstance(after, type(thing)):
        return after
    x, z, rotation, turn = _carried_pose(thing, *moved[mover])
    pose: dict[str, Any] = {"x": x, "z": z, "rotation": rotation}
    if isinstance(thing, Decoration) and thing.mounted_on_wall is not None:
        pose["mounted_on_wall"] = WALL_BEHIND[(ROTATION_AT_WALL[thing.mounted_on_wall] + turn) % 360]
    return replace(thing, **pose)


def _carried_pose(thing: Body, before: Body, after: Body) -> tuple[float, float, float, int]:
    """Returns x, z and rotation of a thing that keeps its place in the frame of what carries it, and the turn."""
    turn = (squared(after.rotation) - squared(before.rotation)) % 360
    tx, tz = _turned_offset(thing.x - before.x, thing.z - before.z, turn)
    rotation = (thing.rotation + turn) % 360 if turn else thing.rotation
    return round(after.x + tx, 4), round(after.z + tz, 4), rotation, turn


def _turned_offset(dx: float, dz: float, turn: int) -> tuple[float, float]:
    fx, fz = FACING[turn]
    return dx * fz + dz * fx, dz * fz - dx * fx


__all__ = ["Body", "Wishes", "all_bodies", "floor_bodies", "footprint", "squared", "wanted_as_sent", "without", "written_back"]
