"""What stands in a room already, when pieces are placed around it.

Comes in: a Room with furniture and its Space. Goes out: wanted pieces that stay where they are, and the Space without the
floor of those that break a rule as they stand and so cannot be wanted pieces. Not here: new pieces.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from catalogs import Catalogs
from solver.free_places import footprint
from solver.geometry import turned
from solver.repair import Body, all_bodies, floor_bodies, squared
from solver.requested import kind_of
from solver.scene import Furniture, Room
from solver.wanted import Alternative, Space, Stand, Wanted, Zone


def obstacles(room: Room, space: Space, catalogs: Catalogs) -> tuple[Space, tuple[Wanted, ...]]:
    """Returns the space around what stands in a room, and what stands there as pieces with one way each.

    Args:
        room: as sent; nothing in it moves.
        space: the room's `space_of`.
        catalogs: with a kind for every piece that stands.
    """
    loose = {body.id for body in floor_bodies(room)}
    bodies = [body for body in all_bodies(room) if body.id in loose or (isinstance(body, Furniture) and body.on is not None)]
    named = {body.id for body in bodies}
    held = {body.id: _held(body, named, catalogs) for body in bodies}
    broken = _broken(space, bodies, held)
    zones = tuple(Zone(footprint(body), max(-1, round(body.y * 1000)), body.id) for body in bodies if body.id in broken)
    stands = [body for body in bodies if body.id not in broken]
    stands.sort(key=lambda body: isinstance(body, Furniture) and (body.on or body.under) is not None)
    return replace(space, zones=(*space.zones, *zones)), tuple(held[body.id] for body in stands)


def _held(body: Body, named: set[str], catalogs: Catalogs) -> Wanted:
    """Returns a body as a piece with one way to stand: its bounding rectangle where it is."""
    rect, rotation = footprint(body), squared(body.rotation)
    width, depth = turned(rect.width, rect.depth, rotation)
    kind = catalogs.furniture.get(kind_of(body.id))
    piece = body if isinstance(body, Furniture) else None
    way = Alternative(
        kind_of(body.id) if kind else body.name,
        (width, depth, max(1, round(body.height * 1000))),
        rotation,
        anchor_mm=((rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2),
        within=rect,
        bottom_mm=round(body.y * 1000),
        under=piece.under if piece and piece.under in named else None,
        on=piece.on if piece and piece.on in named else None,
    )
    use = kind.use if kind else None
    sides = tuple(Stand(side) for side in (use.sides if use else ()))
    return Wanted(body.id, True, (way,), stands=sides, need_all=bool(use and use.need == "all"))


def _broken(space: Space, bodies: Sequence[Body], held: Mapping[str, Wanted]) -> set[str]:
    """Returns who overlaps a zone or another body without leave, as sent."""
    found = {body.id for body in bodies if _in_zone(space, held[body.id].alternatives[0])}
    for k, body in enumerate(bodies):
        for other in bodies[:k]:
            if _clash(held[body.id], held[other.id]):
                found |= {body.id, other.id}
    return found


def _in_zone(space: Space, way: Alternative) -> bool:
    rect, top = way.within, way.bottom_mm + way.size_mm[2]
    return rect is not None and any(zone.rect.overlaps(rect) and top > zone.above_mm for zone in space.zones)


def _clash(one: Wanted, other: Wanted) -> bool:
    a, b = one.alternatives[0], other.alternatives[0]
    if a.within is None or b.within is None or {a.under, a.on} & {other.label} or {b.under, b.on} & {one.label}:
        return False
    level = a.bottom_mm < b.bottom_mm + b.size_mm[2] and b.bottom_mm < a.bottom_mm + a.size_mm[2]
    return level and a.within.overlaps(b.within)
