"""A repair, done: what applying one of the repairs that /fix offers does to the room.

Comes in: a Room and a repair. Goes out: the Room. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeVar

from solver.repair.written import without
from solver.scene import Decoration, Furniture, Room

Repair = Mapping[str, Any]
T = TypeVar("T", Furniture, Decoration)


def applied(room: Room, repair: Repair) -> Room:
    """Returns the room with a repair applied; `unlock` also takes the id out of the request's `locked`.

    move and unlock shift the body by dx and dz, m, and set its rotation and wall; turn sets its rotation; shrink its width
    and depth, m; leave_out takes it out with all it carries.
    """
    if repair["action"] == "leave_out":
        return without(room, frozenset((repair["id"],)))
    furniture = tuple(_changed(piece, repair) if piece.id == repair["id"] else piece for piece in room.furniture)
    decorations = tuple(_changed(thing, repair) if thing.id == repair["id"] else thing for thing in room.decorations)
    return replace(room, furniture=furniture, decorations=decorations)


def _changed(body: T, repair: Repair) -> T:
    keys = [key for key in ("rotation", "width", "depth") if key in repair]
    changes: dict[str, Any] = {key: repair[key] for key in keys}
    if "dx" in repair:
        changes |= {"x": round(body.x + repair["dx"], 4), "z": round(body.z + repair["dz"], 4)}
    if isinstance(body, Furniture) and "wall" in repair:
        changes["wall"] = repair["wall"]
    if isinstance(body, Furniture) and repair["action"] == "unlock":
        changes["locked"] = False
    return replace(body, **changes)
