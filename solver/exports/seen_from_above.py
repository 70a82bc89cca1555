"""What a storey looks like from above, cut below its lintels: flat shapes with a colour and a height, the highest last."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.model import Cuboid, DoorLeaf, HouseModel, Paint
from solver.exports.paints import shade

CUT: Final = 2.05
"""What begins higher above the floor is taken away: the walls over doors and windows, ceiling lamps, m."""
WALL_TOP: Final = "#5b5650"
"""The colour of cut walls."""
_AROUND: Final = 20
_DOME: Final = ((1.0, -0.22), (0.86, -0.1), (0.68, 0.0), (0.46, 0.08), (0.24, 0.14))
"""Rings of what is round above: share of its extents, and how much lighter or darker they are."""
_BEVEL: Final = 0.03
Corners = tuple[tuple[float, float], ...]


class SeenShape(NamedTuple):
    """A polygon in the house (x, z), m; its height above the storey's floor, m; an sRGB colour; how much hides what is below, 0 to 1."""

    corners: Corners
    height: float
    color: str
    opacity: float = 1.0


class _Pose(NamedTuple):
    """Where a thing's own origin is in the house, and its turn about +y, degrees."""

    x: float
    y: float
    z: float
    turn: float


def shapes_from_above(model: HouseModel, level: int) -> list[SeenShape]:
    """Returns what stands on a level's floors, doors open, garage doors shut; the floors themselves are left out."""
    floor = next((room.elevation for room in model.rooms if room.level == level), 0.0)
    levels = {room.id: room.level for room in model.rooms}
    found: list[SeenShape] = []
    for wall in model.walls:
        found += _box(wall.box, Paint(WALL_TOP), floor)
    for fitting in model.fittings:
        found += _box(fitting.box, fitting.paint, floor)
    for leaf in model.leaves:
        found += _leaf(leaf, floor)
    for body in model.bodies:
        if levels.get(body.room or "") == level:
            pose = _Pose(body.x, body.y - floor, body.z, body.turn)
            found += _parts(body.parts, body.paints, pose)
    return sorted((one for one in found if one.height > 0.0), key=lambda one: one.height)


def _box(box: Cuboid, paint: Paint, floor: float) -> Iterator[SeenShape]:
    if box.y0 - floor + 0.05 >= 0.0 and box.y0 - floor < CUT:
        corners = ((box.x0, box.z0), (box.x1, box.z0), (box.x1, box.z1), (box.x0, box.z1))
        yield SeenShape(corners, min(box.y1 - floor, CUT), paint.color, paint.opacity)


def _leaf(leaf: DoorLeaf, floor: float) -> Iterator[SeenShape]:
    """Yields the parts of a leaf, turned open about its hinge."""
    above = leaf.hinge[1] - floor
    if 0.0 <= above < CUT:
        x, z = leaf.middle(leaf.wide_open)
        yield from _parts(leaf.parts, leaf.paints, _Pose(x, above, z, leaf.wide_open))


def _parts(parts: Sequence[BodyPart], paints: Sequence[Paint], pose: _Pose) -> Iterator[SeenShape]:
    for part, paint in zip(parts, paints, strict=True):
        low, high = pose.y + part.at[1] - part.size[1] / 2, pose.y + part.at[1] + part.size[1] / 2
        if low < CUT:
            yield from _part(part, paint, pose, min(high, CUT))


def _part(part: BodyPart, paint: Paint, pose: _Pose, top: float) -> Iterator[SeenShape]:
    """Yields a part's outline; what is round or soft above as rings, each a little lighter than the one around it."""
    width, height, depth = part.size
    at = part.at[0], part.at[2]

    def shape(corners: Corners, lighter: float = 0.0, below: float = 0.0) -> SeenShape:
        color = shade(paint.color, lighter) if lighter else paint.color
        return SeenShape(_turned(corners, at, pose), top - below, color, paint.opacity)

    if part.form in ("ball", "capsule") or (part.form == "cone" and part.axis == "y"):
        for share, lighter in _DOME:
            below = height * share if part.form == "cone" else height / 2 * (1.0 - math.sqrt(1.0 - share**2))
            yield shape(_oval(width * share / 2, depth * share / 2), lighter, below)
    elif part.form in ("cylinder", "cone") and part.axis == "y":
        yield shape(_oval(width / 2, depth / 2))
    elif part.form == "cylinder":
        yield from (shape(_lying(part, share), lighter, height / 2 * (1.0 - math.sqrt(1.0 - share**2))) for share, lighter in _DOME)
    elif part.form == "rounded":
        inset = min(_BEVEL, 0.25 * width, 0.25 * depth)
        yield shape(_rectangle(width / 2, depth / 2), -0.12, min(inset, height) / 2)
        yield shape(_rectangle(width / 2 - inset / 2, depth / 2 - inset / 2), -0.05, min(inset, height) / 6)
        yield shape(_rectangle(width / 2 - inset, depth / 2 - inset))
    else:
        yield shape(_rectangle(width / 2, depth / 2))


def _rectangle(x: float, z: float) -> Corners:
    return (-x, -z), (x, -z), (x, z), (-x, z)


def _oval(x: float, z: float) -> Corners:
    return tuple((x * math.cos(turn), z * math.sin(turn)) for turn in (2 * math.pi * n / _AROUND for n in range(_AROUND)))


def _lying(part: BodyPart, share: float) -> Corners:
    """Returns a share of a lying cylinder's outline: as long, but less across."""
    x, z = part.size[0] / 2, part.size[2] / 2
    return _rectangle(x, z * share) if part.axis == "x" else _rectangle(x * share, z)


def _turned(corners: Corners, at: tuple[float, float], pose: _Pose) -> Corners:
    """Returns corners, moved by `at` in the thing's own frame, in the house."""
    turn = math.radians(pose.turn)
    sine, cosine = math.sin(turn), math.cos(turn)
    moved = [(x + at[0], z + at[1]) for x, z in corners]
    return tuple((pose.x + cosine * x + sine * z, pose.z - sine * x + cosine * z) for x, z in moved)
