"""The bodies of a sent room: footprints, who is on the floor, who is tucked under a table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from solver.free_places import FLAT_MM, footprint
from solver.geometry import Rect, turned
from solver.repair.carried import RESTS_MM, Body, carriers, squared
from solver.scene import Furniture, Room

AT_TABLE_MM = 300
"""How far a chair may be from its table and still be that table's."""
UNTUCKED_MM = 150
"""Depth of a tucked chair that stays outside its table (docs/scene.md, overlap)."""


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


def floor_bodies(room: Room) -> list[Body]:
    """Returns what the solver may move: bodies that rest on nothing else, no rugs or mats among them."""
    carried = carriers(room)
    bodies: list[Body] = [piece for piece in room.furniture if piece.id not in carried and piece.height * 1000 > FLAT_MM]
    for thing in room.decorations:
        loose = thing.parent is None and thing.mounted_on_wall is None and thing.y < RESTS_MM / 1000
        if loose and thing.height * 1000 > FLAT_MM:
            bodies.append(thing)
    return bodies


def tables_of(bodies: Sequence[Body]) -> dict[str, Body]:
    """Returns under which table each chair stands that names one."""
    by_id = {body.id: body for body in bodies}
    tables = {body.id: by_id.get(body.under or "") for body in bodies if isinstance(body, Furniture)}
    return {label: table for label, table in tables.items() if table is not None and table.id != label}


def too_deep_mm(chair: Body, table: Body) -> int:
    """Returns how much too far a chair is tucked: by at most its depth less 0.15 m (docs/scene.md, overlap); 0 for none, mm."""
    own, other = footprint(chair), footprint(table)
    if not own.overlaps(other):
        return 0
    shared = own.common(other)
    return max(0, (shared.depth if squared(chair.rotation) % 180 == 0 else shared.width) - _tuck_mm(chair))


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
