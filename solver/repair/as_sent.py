"""A room as sent -> wanted pieces, every one of them to be kept.

Comes in: a Room. Goes out: Wanted pieces in order of importance. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from solver.free_places import footprint
from solver.repair.bodies import Body, carriers, climb, drawn_out, floor_bodies, tables_of, too_deep_mm
from solver.repair.ways import Walls, carried, held, loose
from solver.repair.wishes import Wishes
from solver.scene import Furniture, Room
from solver.wanted import Alternative, Stand, Wanted

FREE_COST = 1.0
"""What leaving its table costs a tucked chair."""


@dataclass(frozen=True)
class _Sent:
    """What decides the ways of a room's bodies."""

    walls: Walls
    wishes: Wishes
    tables: Mapping[str, Body]
    held: frozenset[str]


def wanted_as_sent(room: Room, walls: Walls, wishes: Wishes) -> tuple[Wanted, ...]:
    """Turns a sent room into wanted pieces, most important first.

    Args:
        room: the room as sent.
        walls: what its wall-hugging pieces may stand at.
        wishes: what is locked and what was moved; pieces ask for their use sides where it knows some.
    """
    bodies = floor_bodies(room)
    by_id = {body.id: body for body in bodies}
    sent = _Sent(walls, wishes, tables_of(bodies), frozenset(holders(room, wishes)))
    order = sorted(range(len(bodies)), key=lambda k: _importance(bodies[k], wishes, k))
    pieces = [_wanted(bodies[k], _alternatives(bodies[k], sent), wishes) for k in order]
    return (*pieces, *_carried(room, by_id, wishes))


def holders(room: Room, wishes: Wishes) -> dict[str, tuple[str, ...]]:
    """Returns for every body on the floor that stays as sent the locked ids that make it: its own, or what it carries."""
    bodies = floor_bodies(room)
    by_id, tables, parents = {body.id: body for body in bodies}, tables_of(bodies), carriers(room)
    found: dict[str, list[str]] = {body.id: [body.id] for body in bodies if wishes.is_locked(body)}
    for chair, table in tables.items():
        if wishes.is_locked(by_id[chair]) and not too_deep_mm(by_id[chair], table):
            found.setdefault(table.id, []).append(chair)
    for piece in room.furniture:
        root = climb(piece.id, parents)
        if piece.id in parents and root in by_id and wishes.is_locked(piece):
            found.setdefault(root, []).append(piece.id)
    return {label: tuple(ids) for label, ids in found.items()}


def _wanted(body: Body, alternatives: tuple[Alternative, ...], wishes: Wishes) -> Wanted:
    sides, need_all = wishes.uses.get(body.name, ((), False)) if isinstance(body, Furniture) else ((), False)
    return Wanted(body.id, True, alternatives, stands=tuple(Stand(side) for side in sides), need_all=need_all)


def _alternatives(body: Body, sent: _Sent) -> tuple[Alternative, ...]:
    table = sent.tables.get(body.id)
    if body.id in sent.held:
        return (held(body, None if table is not None and too_deep_mm(body, table) else table),)
    ways = loose(body, sent.walls, sent.wishes)
    if table is None or not isinstance(body, Furniture):
        return ways
    free = tuple(replace(way, cost=way.cost + FREE_COST) for way in ways)
    return (replace(carried(drawn_out(body, table), table), under=table.id), *free)


def _carried(room: Room, floor: Mapping[str, Body], wishes: Wishes) -> list[Wanted]:
    """What stands on other pieces, rigid in the frame of the piece on the floor below it."""
    parents = carriers(room)
    pieces = []
    for piece in room.furniture:
        root = floor.get(climb(piece.id, parents))
        if piece.id in parents and root is not None:
            way = replace(carried(_brought_back(piece, root), root), on=parents[piece.id], bottom_mm=round(piece.y * 1000))
            pieces.append(_wanted(piece, (way,), wishes))
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
