"""Where door leaves hang, how they turn and what they are made of."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.model import DoorLeaf, Paint, PlacedOpening
from solver.exports.paints import Paints, shade
from solver.exports.wall_panels import RAILING_HEIGHT, WallPlan, frame_parts
from solver.geometry import turned_back
from solver.scene import Room
from solver.wall_fittings import (
    GROUND_GAP,
    HANDLE_FROM_EDGE,
    HANDLE_HEIGHT,
    HANDLE_PROUD,
    LEAF_THICKNESS,
    LEVER,
    LEVER_INWARDS,
    frame_of,
    leaf_offset,
    leaf_spans,
    within_frame,
)

Painted = tuple[BodyPart, Paint]
LEAF_DENSITY: Final = 12.0
"""What a leaf weighs, kg/m2: a hollow core of chipboard (EN 1530 class 2 doors weigh 10 to 20)."""


def leaves_of(plan: WallPlan, paints: Paints) -> list[DoorLeaf]:
    """Returns the leaves of a house: one or two for each door, one for each garage door, none for passages and windows."""
    rooms = {room.id: room for room in plan.rooms}
    shut = [opening for opening in plan.openings if opening.kind in ("door", "garage_door") and opening.head > GROUND_GAP]
    return [leaf for opening in shut for leaf in _leaves(opening, plan, rooms, paints)]


def _leaves(opening: PlacedOpening, plan: WallPlan, rooms: Mapping[str, Room], paints: Paints) -> Iterator[DoorLeaf]:
    """Yields the leaves of a door, the one at its hinge first."""
    ends = opening.start, opening.end
    spans = leaf_spans(ends, opening.hinge) if opening.kind == "door" else [(within_frame(ends), "start")]
    for number, (span, hung) in enumerate(spans, 1):
        at = span[0] if hung == "start" else span[1]
        width = (ends[1] - ends[0] - 2 * frame_of(ends[1] - ends[0])) / len(spans)
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


def shut_parts(opening: PlacedOpening, leaves: Sequence[DoorLeaf], turn: float) -> list[Painted]:
    """Returns an opening as one thing: its frame's boards, a window's pane and its leaves, shut.

    They are in a frame of that turn, degrees, about the middle of the opening's foot.
    """
    size = opening.end - opening.start, opening.head - opening.sill, opening.thickness
    found = frame_parts(opening.kind, size)
    for leaf in leaves:
        x, z = hinge_in(opening, leaf, turn)
        way = 1 if round(leaf.closed - turn) % 360 == 0 else -1
        for part, paint in zip(leaf.parts, leaf.paints, strict=True):
            along, up, across = part.at
            found.append((part._replace(at=(x + way * (along + leaf.width / 2), up + GROUND_GAP, z + way * across)), paint))
    return found


def hinge_in(opening: PlacedOpening, leaf: DoorLeaf, turn: float) -> tuple[float, float]:
    """Returns where a leaf's hinge is in that frame, m: along it, and towards its front."""
    x, z = opening.middle
    return turned_back(leaf.hinge[0] - x, leaf.hinge[2] - z, turn)


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


_ENTRANCE = Paint("#c0392b", 0.55)
_TERRACE = Paint("#e6e2d9", 0.55)
_GARAGE = Paint("#c3c9ce", 0.5)
_GATE = Paint("#8a7a66", texture="wood")
_GLASS = Paint("#bfe0f0", 0.08, opacity=0.4)
_WOOD = Paint("#a87f55", texture="wood")
_METAL = Paint("#b4b8bc", 0.35, 0.6)

_STILE = 0.11
_TOP_RAIL = 0.12
_BOTTOM_RAIL = 0.2
_LOCK_RAIL = (0.88, 1.06)
_LEVER = 0.016
_INSET = 0.012
_MOULDING = 0.05
_SECTION = 0.55
_GROOVE = 0.012
_SLAT = 0.05
_NARROWEST = 0.3
_LOWEST = 1.4
"""In what is less wide or high rails, mouldings and handles do not fit beside each other; nor in a gate less than 0.3 m high."""

Reach = tuple[float, float]


@dataclass(frozen=True)
class LeafLook:
    """How a leaf looks: its name (inner, entrance, glazed, sectional or gate), its width and height, m, and a house's door paints."""

    name: str
    width: float
    height: float
    paints: Paints

    @property
    def wood(self) -> Paint:
        """What inner doors are made of."""
        return self.paints.of("wood", None) if self.paints.has("wood") else _WOOD

    @property
    def metal(self) -> Paint:
        """What handles are made of."""
        return self.paints.of("metal", None) if self.paints.has("metal") else _METAL


@lru_cache(maxsize=512)
def parts_of_leaf(look: LeafLook) -> tuple[Painted, ...]:
    """Returns a leaf's parts, closed and whole; a leaf too small for its rails is a larger one, made smaller."""
    width, height = max(look.width, _NARROWEST), max(look.height, _NARROWEST if look.name == "gate" else _LOWEST)
    across, up = look.width / width, look.height / height
    made = _made(replace(look, width=width, height=height))
    return made if across == up == 1.0 else tuple((_pressed(part, across, up), paint) for part, paint in made)


def _pressed(part: BodyPart, across: float, up: float) -> BodyPart:
    (width, height, depth), (x, y, z) = part.size, part.at
    return part._replace(size=(width * across, height * up, depth), at=(x * across, y * up, z))


def _made(look: LeafLook) -> tuple[Painted, ...]:
    if look.name == "sectional":
        return tuple(_sectional(look))
    if look.name == "gate":
        return tuple(_gate(look))
    if look.name == "glazed":
        return tuple(_glazed(look))
    return tuple(_panelled(look, _ENTRANCE if look.name == "entrance" else look.wood))


def _block(size: tuple[float, float, float], at: tuple[float, float, float], paint: Paint) -> Painted:
    return BodyPart("box", size, at, "y", 1.0, "body"), paint


def _board(x: Reach, y: Reach, thick: float, paint: Paint) -> Painted:
    """Returns a box between two corners of the leaf's plane."""
    return _block((x[1] - x[0], y[1] - y[0], thick), ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, 0.0), paint)


def _framed(look: LeafLook, fields: Sequence[Reach], paint: Paint, fill: Callable[[Reach, Reach], list[Painted]]) -> list[Painted]:
    """Returns stiles and rails round fields of these heights, and what fills a field."""
    half = look.width / 2
    inner = half - min(_STILE, look.width * 0.17)
    rails = [0.0, *(end for field in fields for end in field), look.height]
    stiles = [_board(x, (0.0, look.height), LEAF_THICKNESS, paint) for x in ((-half, -inner), (inner, half))]
    between = [_board((-inner, inner), (rails[2 * i], rails[2 * i + 1]), LEAF_THICKNESS, paint) for i in range(len(fields) + 1)]
    return [*stiles, *between, *(part for field in fields for part in fill((-inner, inner), field))]


def _handles(look: LeafLook) -> list[Painted]:
    """Returns a lever on both sides, at the end away from the hinge."""
    x, y, half, metal = look.width / 2 - HANDLE_FROM_EDGE, min(HANDLE_HEIGHT, look.height * 0.8), LEAF_THICKNESS / 2, look.metal
    neck = HANDLE_PROUD - _LEVER
    return [
        part
        for side in (-1, 1)
        for part in (
            _block((0.045, 0.17, 0.008), (x, y - 0.03, side * (half + 0.004)), metal),
            _block((0.02, 0.02, neck), (x, y, side * (half + neck / 2)), metal),
            _block((*LEVER, _LEVER), (x - LEVER_INWARDS, y, side * (half + neck + _LEVER / 2)), metal),
        )
    ]


def _panelled(look: LeafLook, paint: Paint) -> list[Painted]:
    sunk = paint._replace(color=shade(paint.color, -0.14))
    fields = [(_BOTTOM_RAIL, _LOCK_RAIL[0]), (_LOCK_RAIL[1], look.height - _TOP_RAIL)]

    def fill(x: Reach, y: Reach) -> list[Painted]:
        raised = (x[0] + _MOULDING, x[1] - _MOULDING), (y[0] + _MOULDING, y[1] - _MOULDING)
        return [_board(x, y, LEAF_THICKNESS - 2 * _INSET, sunk), _board(*raised, LEAF_THICKNESS - _INSET, paint)]

    return [*_framed(look, fields, paint, fill), *_handles(look)]


def _glazed(look: LeafLook) -> list[Painted]:
    fields = [(0.3, 1.1), (1.16, look.height - _TOP_RAIL)]
    return [*_framed(look, fields, _TERRACE, lambda x, y: [_board(x, y, 0.012, _GLASS)]), *_handles(look)]


def _sectional(look: LeafLook) -> list[Painted]:
    """Returns sections one above the other, each with a row of raised fields."""
    count = max(2, int(look.height / _SECTION + 0.5))
    step, columns, half = look.height / count, max(2, int(look.width / 0.7 + 0.5)), look.width / 2
    pitch = look.width / columns
    groove, raised = (_GARAGE._replace(color=shade(_GARAGE.color, share)) for share in (-0.5, 0.2))
    rows = [i * step for i in range(count)]
    fields = [(j * pitch - half + 0.07, (j + 1) * pitch - half - 0.07) for j in range(columns)]
    return [
        _board((-half, half), (0.0, look.height), 0.02, groove),
        *(_board((-half, half), (low, low + step - _GROOVE), LEAF_THICKNESS, _GARAGE) for low in rows),
        *(_board(x, (low + 0.1, low + step - 0.1 - _GROOVE), LEAF_THICKNESS + 0.016, raised) for low in rows for x in fields),
        _board((-0.1, 0.1), (0.04, 0.07), LEAF_THICKNESS + 0.06, look.metal),
    ]


def _gate(look: LeafLook) -> list[Painted]:
    """Returns slats between two rails."""
    half, height = look.width / 2, look.height
    slats = max(3, int(look.width / (2.4 * _SLAT) + 0.5))
    pitch = (look.width - _SLAT) / (slats - 1)
    starts = [i * pitch - half for i in range(slats)]
    return [
        *(_board((at, at + _SLAT), (0.03, height), 0.022, _GATE) for at in starts),
        _board((-half, half), (0.1, 0.16), LEAF_THICKNESS, _GATE),
        _board((-half, half), (height - 0.13, height - 0.07), LEAF_THICKNESS, _GATE),
    ]
