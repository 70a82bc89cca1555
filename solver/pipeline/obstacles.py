"""What stands in a room already, when pieces are placed around it.

Not here: new pieces.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from catalogs import Catalogs
from catalogs.entries import Side
from solver.free_places import footprint
from solver.geometry import Rect
from solver.pieces import Candidate, Piece, Space, Stance, Stand, Zone
from solver.repair import Body, all_bodies, as_it_stands, floor_bodies
from solver.scene import Furniture, Room

NOWHERE = Rect(1 << 40, 1 << 40, -1 << 40, -1 << 40)
"""Shares space with nothing."""


def obstacles(room: Room, space: Space, catalogs: Catalogs) -> tuple[Space, tuple[Piece, ...]]:
    """Returns the space around what stands in a room, and what stands there, which does not move, as pieces with one way each."""
    loose = {body.id for body in floor_bodies(room)}
    bodies = [body for body in all_bodies(room) if body.id in loose or (isinstance(body, Furniture) and body.on is not None)]
    named = {body.id for body in bodies}
    used = catalogs.use_sides()
    held = {body.id: _held(body, named, used.get(body.name, ((), False))) for body in bodies}
    broken = _broken(space, bodies, held)
    zones = tuple(Zone(footprint(body), max(-1, round(body.y * 1000)), body.id) for body in bodies if body.id in broken)
    stands = [body for body in bodies if body.id not in broken]
    stands.sort(key=lambda body: isinstance(body, Furniture) and (body.on or body.under) is not None)
    return replace(space, zones=(*space.zones, *zones)), tuple(held[body.id] for body in stands)


def _held(body: Body, named: set[str], use: tuple[tuple[Side, ...], bool]) -> Piece:
    """Returns a body as a piece that stays as it stands; `use` tells its use sides, and whether all are needed."""
    way = as_it_stands(body)
    way = replace(way, kind=body.name, stance=Stance(way.rotation))
    if not isinstance(body, Furniture):
        return Piece(body.id, True, (way,))
    under, on = (label if label in named else None for label in (body.under, body.on))
    stands = tuple(Stand(side) for side in use[0])
    return Piece(body.id, True, (replace(way, under=under, on=on),), stands=stands, need_all=use[1])


def _broken(space: Space, bodies: Sequence[Body], held: Mapping[str, Piece]) -> set[str]:
    """Returns who overlaps a zone or another body without leave, as sent."""
    ways = [held[body.id].candidates[0] for body in bodies]
    broken = np.array([_in_zone(space, way) for way in ways], dtype=bool)
    boxes = np.array([(*(way.within or NOWHERE), way.bottom_mm, way.bottom_mm + way.size_mm[2]) for way in ways], np.int64).reshape(-1, 6)
    number = {body.id: k for k, body in enumerate(bodies)}
    excused: list[list[int]] = [[k] for k in range(len(ways))]
    for k, way in enumerate(ways):
        for label in {way.under, way.on} & number.keys():
            excused[k].append(number[str(label)])
            excused[number[str(label)]].append(k)
    west, north, east, south, low, high = boxes.T
    for k, (x0, z0, x1, z1, bottom, top) in enumerate(boxes.tolist()):
        meets = (west < x1) & (x0 < east) & (north < z1) & (z0 < south) & (low < top) & (bottom < high)
        meets[excused[k]] = False
        broken[k] |= meets.any()
    return {body.id for body, is_broken in zip(bodies, broken, strict=True) if is_broken}


def _in_zone(space: Space, way: Candidate) -> bool:
    rect, top = way.within, way.bottom_mm + way.size_mm[2]
    return rect is not None and any(zone.rect.overlaps(rect) and top > zone.above_mm for zone in space.zones)
