"""Where door leaves hang and how they turn."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

from solver.exports.door_parts import LeafLook, parts_of_leaf
from solver.exports.model import DoorLeaf, PlacedOpening
from solver.exports.paints import Paints
from solver.exports.wall_panels import RAILING_HEIGHT, WallPlan
from solver.scene import Room
from solver.wall_fittings import FRAME, GROUND_GAP, LEAF_THICKNESS, leaf_offset, leaf_spans

LEAF_DENSITY: Final = 12.0
"""What a leaf weighs, kg/m2: a hollow core of chipboard (EN 1530 class 2 doors weigh 10 to 20)."""


def leaves_of(plan: WallPlan, paints: Paints) -> list[DoorLeaf]:
    """Returns the leaves of a house: one or two for each door, one for each garage door, none for passages and windows."""
    rooms = {room.id: room for room in plan.rooms}
    shut = [opening for opening in plan.openings if opening.kind in ("door", "garage_door")]
    return [leaf for opening in shut for leaf in _leaves(opening, plan, rooms, paints)]


def _leaves(opening: PlacedOpening, plan: WallPlan, rooms: Mapping[str, Room], paints: Paints) -> Iterator[DoorLeaf]:
    """Yields the leaves of a door, the one at its hinge first."""
    ends = opening.start, opening.end
    spans = leaf_spans(ends, opening.hinge) if opening.kind == "door" else [((ends[0] + FRAME, ends[1] - FRAME), "start")]
    for number, (span, hung) in enumerate(spans, 1):
        at = span[0] if hung == "start" else span[1]
        width = (ends[1] - ends[0] - 2 * FRAME) / len(spans)
        yield _leaf(_Hung(opening, f"{opening.id}/{number}" if number > 1 else opening.id, at, hung == "start", width), plan, rooms, paints)


class _Hung(NamedTuple):
    """A leaf of an opening: its id, where it hangs along the wall, m, whether that is its lower end, its width, m."""

    opening: PlacedOpening
    id: str
    at: float
    from_start: bool
    width: float


def _leaf(hung: _Hung, plan: WallPlan, rooms: Mapping[str, Room], paints: Paints) -> DoorLeaf:
    opening, at, width = hung.opening, hung.at, hung.width
    swings = opening.kind == "door"
    along = 1 if hung.from_start else -1
    offset = opening.towards * leaf_offset(opening.thickness) if swings else 0.0
    closed = _degrees(along, 0) if opening.axis == "x" else _degrees(0, along)
    open_to = _degrees(0, opening.towards) if opening.axis == "x" else _degrees(opening.towards, 0)
    x, z = (at, opening.line + offset) if opening.axis == "x" else (opening.line + offset, at)
    is_gate = _has_railing(opening, plan)
    height = (min(opening.head, RAILING_HEIGHT) if is_gate else opening.head) - GROUND_GAP
    look = LeafLook("gate" if is_gate and swings else _look(opening, rooms), width, height, paints)
    made = parts_of_leaf(look)
    return DoorLeaf(
        id=hung.id,
        opening=opening.id,
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
