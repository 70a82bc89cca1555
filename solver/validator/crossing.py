"""The rule for shapes: no part of one body is in a part of another.

Comes in: a room, and what the catalogs say of the shapes of kinds. Goes out: findings. May import: scene.

Parts are boxes here, the round ones too, turned with their body; how deep they are in each other is counted in lattice steps. Bodies
far apart, the most by far, are told by floats first. Where both bodies stand on the floor and neither is under or on the other,
`overlap` speaks of them. Bodies of kinds without a shape are passed over: what they are made of is not known.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from solver.scene import Decoration, Dynamic, Furniture
from solver.validator.judging import Finding, RuleCase
from solver.validator.kinds import Kinds, UnitBox
from solver.validator.lattice import exact, words
from solver.validator.world import FLAT, home_of

AnyBody = Furniture | Decoration | Dynamic
TOUCHING: Final = exact(0.002)
"""Parts that are no deeper in each other only touch."""
FLAT_M: Final = FLAT / exact(1.0)
SLIGHT: Final = 0.0009
"""A little less than half of what parts that touch may be in each other: so much is looked away from at every side, m."""


class BodyBounds(NamedTuple):
    """A body and the room it takes up at most, m: from west to east, from north to south, from bottom to top."""

    west: float
    east: float
    north: float
    south: float
    bottom: float
    top: float
    body: AnyBody
    on_floor: bool


Shared = tuple[float, float, float, float, float, float]
"""Room that two bodies may share, m: its middle (x, z), half its extents along x and z, its bottom and top."""


class PlacedPart(NamedTuple):
    """A part in the room: its middle, half its extents along its own axes, cosine and sine of how it is turned, its heights."""

    x: int
    z: int
    half_x: int
    half_z: int
    cosine: float
    sine: float
    low: int
    high: int


def shapes_cross(case: RuleCase) -> Iterator[Finding]:
    """A part of a body is more than 2 mm deep in a part of another."""
    found: list[Finding] = []
    for a, b in _meeting(case):
        deep = _deepest(case.kinds, a, b)
        if deep > TOUCHING:
            first, second = sorted((a.body.id, b.body.id))
            message = f"{first} and {second} cross: a part of one is {words(deep)} deep in a part of the other"
            found.append(Finding((first, second), deep, message))
    yield from sorted(found)


def _meeting(case: RuleCase) -> Iterator[tuple[BodyBounds, BodyBounds]]:
    """Yields the pairs of bodies that may cross, but for those that `overlap` speaks of."""
    bodies = sorted(_around(case), key=lambda one: one.west)
    for k, a in enumerate(bodies):
        _, east, north, south, bottom, top, body, on_floor = a
        for b in bodies[k + 1 :]:
            if b.west >= east:
                break
            if b.bottom >= top or bottom >= b.top or b.north >= south or north >= b.south:
                continue
            if not (on_floor and b.on_floor) or body.id in _carriers(b.body) or b.body.id in _carriers(body):
                yield a, b


def _around(case: RuleCase) -> Iterator[BodyBounds]:
    room, scene = case.room.room, case.world.scene
    people = [person for person in scene.dynamic if home_of(scene, person) == room.id]
    bodies: list[AnyBody] = [*room.furniture, *room.decorations, *people]
    for body in bodies:
        x, y, z, width, depth, height = body.x, body.y, body.z, body.width / 2, body.depth / 2, body.height
        if body.rotation % 180 == 90:
            width, depth = depth, width
        elif body.rotation % 180:
            width = depth = width + depth
        rests = isinstance(body, Decoration) and (body.parent is not None or body.mounted_on_wall is not None or y != 0)
        if height > FLAT_M or y > 0:
            yield BodyBounds(x - width, x + width, z - depth, z + depth, y, y + height, body, not rests)


def _carriers(body: AnyBody) -> tuple[str | None, ...]:
    """Returns whom a body is under or on."""
    return (body.under, body.on) if isinstance(body, Furniture) else (body.on,) if isinstance(body, Dynamic) else (body.parent,)


def _made_of(kinds: Kinds, body: AnyBody) -> Sequence[UnitBox]:
    if isinstance(body, Dynamic):
        return kinds.living(body.kind, body.on is not None)
    sort = "furniture" if isinstance(body, Furniture) else "decoration"
    return kinds.made_of(sort, body.name, (body.width, body.depth, body.height), body.kind)


def _deepest(kinds: Kinds, a: BodyBounds, b: BodyBounds) -> int:
    """Returns how deep any part of one body is in any of another."""
    west, north, bottom = max(a.west, b.west) + SLIGHT, max(a.north, b.north) + SLIGHT, max(a.bottom, b.bottom) + SLIGHT
    east, south, top = min(a.east, b.east) - SLIGHT, min(a.south, b.south) - SLIGHT, min(a.top, b.top) - SLIGHT
    if west > east or north > south or bottom > top:
        return 0
    shared = (west + east) / 2, (north + south) / 2, (east - west) / 2, (south - north) / 2, bottom, top
    mine = _placed(a.body, _made_of(kinds, a.body), shared)
    its = _placed(b.body, _made_of(kinds, b.body), shared) if mine else ()
    return max((_depth(one, other) for one in mine for other in its), default=0)


def _placed(body: AnyBody, made_of: Sequence[UnitBox], shared: Shared) -> list[PlacedPart]:
    """Returns a body's parts that reach into some room, where they are; at right angles whole numbers all through."""
    cosine, sine = _turn(body.rotation)
    reaching = _reaching(body, made_of, shared, (cosine, sine))
    if not reaching:
        return []
    x, y, z = exact(body.x), exact(body.y), exact(body.z)
    width, height, depth = exact(body.width), exact(body.height), exact(body.depth)
    right, swapped, found = body.rotation % 90 == 0, body.rotation % 180 == 90, []
    for (x0, x1), (y0, y1), (z0, z1) in reaching:
        across, along = round((x0 + x1 - 1) / 2 * width), round((z0 + z1 - 1) / 2 * depth)
        half = round((x1 - x0) / 2 * width), round((z1 - z0) / 2 * depth)
        at = x + round(across * cosine + along * sine), z + round(along * cosine - across * sine)
        low, high = y + round(y0 * height), y + round(y1 * height)
        if right:
            found.append(PlacedPart(*at, *(half[::-1] if swapped else half), 1.0, 0.0, low, high))
        else:
            found.append(PlacedPart(*at, *half, cosine, sine, low, high))
    return found


def _reaching(body: AnyBody, made_of: Sequence[UnitBox], shared: Shared, turn: tuple[float, float]) -> list[UnitBox]:
    """Returns the parts of a body whose boxes reach into some room, as seen along the body's own axes."""
    (cosine, sine), (x, z, half_x, half_z, bottom, top) = turn, shared
    dx, dz = x - body.x, z - body.z
    across, along = dx * cosine - dz * sine, dx * sine + dz * cosine
    wide, deep = half_x * abs(cosine) + half_z * abs(sine), half_x * abs(sine) + half_z * abs(cosine)
    width, depth, height, y = body.width, body.depth, body.height, body.y
    left, right = (across - wide) / width + 0.5, (across + wide) / width + 0.5
    back, front = (along - deep) / depth + 0.5, (along + deep) / depth + 0.5
    low, high = (bottom - y) / height, (top - y) / height
    return [
        (xs, ys, zs)
        for xs, ys, zs in made_of
        if ys[0] < high and low < ys[1] and xs[0] < right and left < xs[1] and zs[0] < front and back < zs[1]
    ]


def _turn(rotation: float) -> tuple[float, float]:
    """Returns a rotation's cosine and sine, exact at right angles."""
    if rotation % 90 == 0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(rotation / 90) % 4]
    angle = math.radians(rotation)
    return math.cos(angle), math.sin(angle)


def _depth(a: PlacedPart, b: PlacedPart) -> int:
    """Returns how far a part has to move, along any of their axes, to leave another one; not above 0 where they are apart."""
    tall = min(a.high - b.low, b.high - a.low)
    if tall <= TOUCHING:
        return tall
    dx, dz = b.x - a.x, b.z - a.z
    if not a.sine and not b.sine:
        return min(tall, a.half_x + b.half_x - abs(dx), a.half_z + b.half_z - abs(dz))
    cosine, sine = abs(a.cosine * b.cosine + a.sine * b.sine), abs(a.sine * b.cosine - a.cosine * b.sine)
    shared = []
    for one, other in ((a, b), (b, a)):
        across, along = abs(dx * one.cosine - dz * one.sine), abs(dx * one.sine + dz * one.cosine)
        shared.append(one.half_x + other.half_x * cosine + other.half_z * sine - across)
        shared.append(one.half_z + other.half_x * sine + other.half_z * cosine - along)
    return min(tall, round(min(shared)))
