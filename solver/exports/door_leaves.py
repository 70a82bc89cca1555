"""Where door leaves hang and how they turn.

Comes in: a house's openings and wall lines. Goes out: `DoorLeaf`s. May import: the ground floor, the model.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

from solver.exports.door_parts import LeafLook, parts_of_leaf
from solver.exports.model import DoorLeaf, PlacedOpening
from solver.exports.paints import Paints
from solver.exports.wall_panels import RAILING_HEIGHT, WallPlan
from solver.scene import Room
from solver.wall_fittings import FRAME, GROUND_GAP, LEAF_THICKNESS, leaf_offset

LEAF_DENSITY: Final = 12.0
"""What a leaf weighs, kg/m2: a hollow core of chipboard (EN 1530 class 2 doors weigh 10 to 20)."""


def leaves_of(plan: WallPlan, paints: Paints) -> list[DoorLeaf]:
    """Returns the leaves of a house: one for each door and garage door, none for passages and windows."""
    rooms = {room.id: room for room in plan.rooms}
    return [_leaf(opening, plan, rooms, paints) for opening in plan.openings if opening.kind in ("door", "garage_door")]


def _leaf(opening: PlacedOpening, plan: WallPlan, rooms: Mapping[str, Room], paints: Paints) -> DoorLeaf:
    swings = opening.kind == "door"
    from_start = not swings or opening.hinge == "start"
    along = 1 if from_start else -1
    at = opening.start + FRAME if from_start else opening.end - FRAME
    offset = opening.towards * leaf_offset(opening.thickness) if swings else 0.0
    closed = _degrees(along, 0) if opening.axis == "x" else _degrees(0, along)
    open_to = _degrees(0, opening.towards) if opening.axis == "x" else _degrees(opening.towards, 0)
    x, z = (at, opening.line + offset) if opening.axis == "x" else (opening.line + offset, at)
    is_gate = _has_railing(opening, plan)
    width = opening.end - opening.start - 2 * FRAME
    height = (min(opening.head, RAILING_HEIGHT) if is_gate else opening.head) - GROUND_GAP
    look = LeafLook("gate" if is_gate and swings else _look(opening, rooms), width, height, paints)
    made = parts_of_leaf(look)
    return DoorLeaf(
        id=opening.id,
        motion="swing" if swings else "roll",
        look=look.name,
        hinge=(x, plan.storey(opening.level).elevation + GROUND_GAP, z),
        width=width,
        height=height,
        thickness=LEAF_THICKNESS,
        closed=closed,
        swing=90.0 if math.sin(math.radians(open_to - closed)) > 0 else -90.0,
        mass=round(LEAF_DENSITY * width * height, 3),
        parts=tuple(part for part, _ in made),
        paints=tuple(paint for _, paint in made),
        open=opening.open,
    )


def _degrees(x: float, z: float) -> float:
    """Returns the turn about +y that brings +x to a direction of the plan."""
    return math.degrees(math.atan2(-z, x))


def _has_railing(opening: PlacedOpening, plan: WallPlan) -> bool:
    line = (opening.level, opening.axis, opening.line)
    return any(run.kind == "railing" and run.line == line and run.start < opening.end and opening.start < run.end for run in plan.runs)


def _look(opening: PlacedOpening, rooms: Mapping[str, Room]) -> str:
    if opening.kind == "garage_door":
        return "sectional"
    if opening.is_main_entrance:
        return "entrance"
    one, other = (rooms.get(room or "") for room in opening.rooms)
    return "glazed" if one and other and one.outdoor != other.outdoor else "inner"
