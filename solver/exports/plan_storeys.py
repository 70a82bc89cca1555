"""A storey as a plan shows it: what stands in it, seen from above, its walls, and where its names and dimensions are written."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from operator import itemgetter
from typing import Final, Literal, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.model import DoorLeaf, FloorPlate, HouseModel, ModelBody, PlacedOpening
from solver.exports.plan_rooms import (
    Dimension,
    Facades,
    Obstacle,
    PlanBox,
    PlanRoom,
    RoomLabel,
    chains_of,
    clear_corners,
    label_of,
    name_of,
    words_of,
)
from solver.exports.plan_sheet import PlanSheet, sheet_for
from solver.geometry import gaps_between, square_metres

Place = tuple[float, float]


class OpenLeaf(NamedTuple):
    """A leaf that stands open at a right angle: its corners, and its free end when it is shut and open, (x, z)."""

    corners: tuple[Place, Place, Place, Place]
    shut: Place
    opened: Place


@dataclass(frozen=True)
class PlanStorey:
    """A storey: its file's name without ending, what is in it, what is cut as walls, what railings cover, and what is written."""

    stem: str
    sheet: PlanSheet
    rooms: list[FloorPlate]
    bodies: list[ModelBody]
    openings: list[PlacedOpening]
    leaves: list[DoorLeaf]
    walls: list[PlanBox]
    railings: list[PlanBox]
    labels: list[RoomLabel]
    outside: list[Dimension]
    words: list[str]


def storeys_of(model: HouseModel, scale: int | None = None, called: Mapping[str, str] | None = None) -> list[PlanStorey]:
    """Returns the storeys of a house, the lowest first, drawn at 1 to `scale`; a house without rooms has an empty one.

    `called` says what room types are named, where not in English.
    """
    levels = model.levels
    return [_storey(_Asked(model, scale, called or {}), level, len(levels) > 1) for level in levels]


def open_leaf(leaf: DoorLeaf) -> OpenLeaf:
    """Returns where a leaf is that stands open."""
    (x, _, z), width, half = leaf.hinge, leaf.width, leaf.thickness / 2
    shut, opened = math.radians(leaf.closed), math.radians(leaf.closed + leaf.swing)
    dx, dz = math.cos(opened), -math.sin(opened)
    near = (x - dz * half, z + dx * half), (x + dz * half, z - dx * half)
    far = (near[1][0] + dx * width, near[1][1] + dz * width), (near[0][0] + dx * width, near[0][1] + dz * width)
    tips = [(x + math.cos(at) * width, z - math.sin(at) * width) for at in (shut, opened)]
    return OpenLeaf((*near, *far), tips[0], tips[1])


def drawing_ranks(bodies: Sequence[ModelBody]) -> dict[str, float]:
    """Returns by id how late bodies are drawn: by their tops, but what lies on another after it unless a part of that covers it.

    So a pillow is seen though the headboard is higher, and a book under a shelf's next board is not.
    """
    ranks: dict[str, float] = {}
    known = {body.id: body for body in bodies}
    for body in bodies:
        path, at = dict[str, ModelBody](), known.get(body.id)
        while at and at.id not in ranks and at.id not in path:
            path[at.id], at = at, known.get(at.parent or "")
        for one in reversed(path.values()):
            top, below = one.y + one.height, ranks.get(one.parent or "", -math.inf)
            ranks[one.id] = below + 1e-4 if top <= below and not covers(known[one.parent or ""], one) else top
    return ranks


def covers(carrier: ModelBody, body: ModelBody) -> bool:
    """Tells whether a part of what carries a body lies over its middle."""
    x, z = carrier.local(body.x, body.z)
    top = body.y + body.height - carrier.y
    return any(
        part.at[1] + part.size[1] / 2 > top and abs(x - part.at[0]) < part.size[0] / 2 and abs(z - part.at[2]) < part.size[2] / 2
        for part in carrier.parts
    )


def opening_box(opening: PlacedOpening, share: float = 1.0) -> PlanBox:
    """Returns the floor that an opening takes of its wall, or the middle `share` of it."""
    return on_line(opening.axis, (opening.start, opening.end), opening.line, opening.thickness / 2 * share)


def on_line(axis: str, along: tuple[float, float], line: float, half: float) -> PlanBox:
    """Returns the floor that a stretch of a line along an axis takes, by half its thickness, m."""
    (start, end), low, high = along, line - half, line + half
    return (start, low, end, high) if axis == "x" else (low, start, high, end)


class _Asked(NamedTuple):
    model: HouseModel
    scale: int | None
    called: Mapping[str, str]


def _storey(asked: _Asked, level: int, several: bool) -> PlanStorey:
    model = asked.model
    rooms = [room for room in model.rooms if room.level == level]
    inside = {room.id for room in rooms}
    openings = [opening for opening in model.openings if opening.level == level]
    here = {opening.id for opening in openings}
    walls = _walls(model, level)
    facades = Facades(rooms, openings, model.thickness / 2, walls)
    sheet = sheet_for(facades.bounds() if rooms else (0.0, 0.0, 1.0, 1.0), asked.scale)
    bodies = [body for body in model.bodies if body.room in inside]
    leaves = [leaf for leaf in model.leaves if leaf.opening in here]
    labels = _named(asked, sheet, rooms, _obstacles(rooms, bodies, openings, leaves))
    return PlanStorey(
        stem=f"{model.name}_level_{level}" if several else model.name,
        sheet=sheet,
        rooms=rooms,
        bodies=bodies,
        openings=openings,
        leaves=leaves,
        walls=walls,
        railings=_railings(model, rooms),
        labels=labels,
        outside=chains_of(facades, sheet.gap) if rooms else [],
        words=_words(model, labels, sheet, f", storey {level}" if several else ""),
    )


def _walls(model: HouseModel, level: int) -> list[PlanBox]:
    found: list[PlanBox] = []
    for panel in model.panels:
        if panel.level == level:
            spans = gaps_between((panel.start, panel.end), ((hole.start, hole.end) for hole in panel.holes))
            found += [on_line(panel.axis, span, panel.line, panel.thickness / 2) for span in spans]
    return found


def _railings(model: HouseModel, rooms: list[FloorPlate]) -> list[PlanBox]:
    if not rooms:
        return []
    return list(dict.fromkeys((box.x0, box.z0, box.x1, box.z1) for box in model.railings(rooms[0])))


def _obstacles(
    rooms: list[FloorPlate], bodies: list[ModelBody], openings: list[PlacedOpening], leaves: list[DoorLeaf]
) -> dict[str, list[Obstacle]]:
    """Returns what no name should stand on, by room: furniture and where doors turn."""
    found: dict[str, list[Obstacle]] = {room.id: [] for room in rooms}
    for body in bodies:
        if body.sort == "furniture" and body.y + body.height > 0.1 and body.room:
            found[body.room].append((*body.footprint, 1.0))
    rooms_of = {opening.id: opening.rooms for opening in openings}
    for leaf in leaves:
        for room in rooms_of[leaf.opening]:
            if room in found and leaf.motion == "swing":
                found[room].append((*_swept(leaf), 1.0))
    return found


def _swept(leaf: DoorLeaf) -> PlanBox:
    """Returns the box of the quarter circle that a leaf turns through."""
    opened = open_leaf(leaf)
    xs, zs = zip((leaf.hinge[0], leaf.hinge[2]), opened.shut, opened.opened, strict=True)
    return min(xs), min(zs), max(xs), max(zs)


def _named(asked: _Asked, sheet: PlanSheet, rooms: list[FloorPlate], obstacles: dict[str, list[Obstacle]]) -> list[RoomLabel]:
    labels = []
    for plate in rooms:
        corners = clear_corners(plate, asked.model.panels, asked.model.thickness / 2)
        labels.append(label_of(PlanRoom(plate, name_of(plate, asked.called), corners, obstacles[plate.id], sheet.letters)))
    return labels


def _words(model: HouseModel, labels: list[RoomLabel], sheet: PlanSheet, storey: str) -> list[str]:
    indoors = [label for label in labels if not label.room.outdoor]
    rooms = "1 room" if len(indoors) == 1 else f"{len(indoors)} rooms"
    return [
        words_of(model.name) + storey,
        f"{rooms}, {square_metres(sum(label.area for label in indoors))} indoors.",
        "Lengths in metres; outside to wall lines.",
        "Areas and room sizes between wall faces.",
        f"Scale 1:{sheet.scale} as printed.",
    ]


SMALLEST: Final = 0.03
"""Parts that are smaller than this both ways, m, are not drawn: handles, buttons."""
HIGH: Final = 1.4
"""What hangs higher than this, m, is above the plane that plans are cut at and is drawn dashed."""
_SOFT: Final = 0.12
"""The radius of a soft corner as a share of the lesser side."""


class PlanMark(NamedTuple):
    """An outline seen from above: a rectangle with corners of a radius, or an ellipse; about its middle, m.

    `part` is the index of the part it belongs to.
    """

    form: Literal["rectangle", "ellipse"]
    x: float
    z: float
    width: float
    depth: float
    radius: float
    part: int


@lru_cache(maxsize=1 << 12)
def marks_of(parts: tuple[BodyPart, ...]) -> tuple[PlanMark, ...]:
    """Returns the outlines of a body's parts as seen from above, the lowest first; at least one."""
    ordered = sorted([(part.at[1] + part.size[1] / 2, index) for index, part in enumerate(parts)], key=itemgetter(0))
    kept: list[PlanMark] = []
    covers: list[tuple[float, float, float, float]] = []
    for _, index in reversed(ordered):
        form, (width, _, depth), (x, _, z), axis, *_ = parts[index]
        if width < SMALLEST and depth < SMALLEST and kept:
            continue
        x0, x1, z0, z1 = x - width / 2 + 1e-6, x + width / 2 - 1e-6, z - depth / 2 + 1e-6, z + depth / 2 - 1e-6
        if any(a <= x0 and x1 <= b and c <= z0 and z1 <= d for a, b, c, d in covers):
            continue
        if form == "box":
            kept.append(PlanMark("rectangle", x, z, width, depth, 0.0, index))
            covers.append((x0 - 2e-6, x1 + 2e-6, z0 - 2e-6, z1 + 2e-6))
        elif form == "ball" or (axis == "y" and form != "rounded"):
            kept.append(PlanMark("ellipse", x, z, width, depth, 0.0, index))
        else:
            share = _SOFT if form == "rounded" else 0.5 if form == "capsule" else 0.0
            kept.append(PlanMark("rectangle", x, z, width, depth, share * min(width, depth), index))
            covers.append((x0 - 2e-6, x1 + 2e-6, z0 - 2e-6, z1 + 2e-6))
    return tuple(reversed(kept))
