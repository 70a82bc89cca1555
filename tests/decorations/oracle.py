"""What is wrong with a decorated house, by brute force and plane geometry: shares no code with what it judges.

Footprints are turned rectangles, as their poses say, compared by separating axes; not their bounding rectangles. Lengths in metres.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

from catalogs import load_catalogs
from solver.scene import Decoration, Furniture, Room, Scene

CLOSE = 1e-4
"""Half of the last decimal of a pose, and a little."""
ROUNDED = 1.1e-3
"""Heights inside furniture are rounded up to whole mm."""
Point = tuple[float, float]
Body = Furniture | Decoration


@dataclass(frozen=True)
class Turned:
    """A footprint's corners and heights."""

    corners: tuple[Point, ...]
    low: float
    high: float


def turned(body: Body, inset: float = 0.0) -> Turned:
    angle = math.radians(body.rotation)
    across, along = body.width / 2 - inset, body.depth / 2 - inset
    corners = [(sx * across, sz * along) for sx, sz in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    # Counter-clockwise from above with x east and z south.
    spun = tuple(
        (body.x + x * math.cos(angle) + z * math.sin(angle), body.z - x * math.sin(angle) + z * math.cos(angle)) for x, z in corners
    )
    return Turned(spun, body.y, body.y + body.height)


def shares(a: Turned, b: Turned) -> bool:
    """Tells whether two turned boxes share space, by more than CLOSE along every separating axis."""
    if min(a.high, b.high) - max(a.low, b.low) <= CLOSE:
        return False
    for corners in (a.corners, b.corners):
        for (x0, z0), (x1, z1) in zip(corners, (*corners[1:], corners[0]), strict=True):
            length = math.hypot(x1 - x0, z1 - z0)
            normal = (z1 - z0) / length, (x0 - x1) / length
            one = [x * normal[0] + z * normal[1] for x, z in a.corners]
            other = [x * normal[0] + z * normal[1] for x, z in b.corners]
            if min(max(one), max(other)) - max(min(one), min(other)) <= CLOSE:
                return False
    return True


def complaints(scene: Scene) -> Iterator[str]:
    """Yields everything wrong with a scene's decorations, but for what the validator says of bodies."""
    for room in scene.rooms:
        half = scene.wall_thickness / 2
        yield from _outside(room, half)
        yield from _unsupported(room, half)
        yield from _together(room)
        yield from _before_openings(room, half)
        yield from _in_ways(room)


def _outside(room: Room, half: float) -> Iterator[str]:
    for thing in room.decorations:
        for x, z in turned(thing).corners:
            if not (half - CLOSE <= x <= room.width - half + CLOSE and half - CLOSE <= z <= room.depth - half + CLOSE):
                yield f"{thing.id} leaves the room's clear floor at {x:.3f}, {z:.3f}"


def surfaces(body: Body) -> list[tuple[float, Turned]]:
    """Returns heights and extents of what a body carries on, straight from the catalogs' entries."""
    known = load_catalogs()
    entries = [
        entry.surfaces
        for kind, entry in known.furniture.items()
        if (entry.name or kind) == body.name and entry.size[:2] == (body.width, body.depth)
    ]
    if isinstance(body, Decoration):
        entries = [known.decorations[body.name].surfaces]
    return [(body.y + one.height, turned(body, one.inset)) for one in (entries[0] if entries else ())]


def boards(body: Body) -> list[tuple[float, Turned]]:
    """Returns heights and extents of the boards of a piece's carcass and of its drawers' trays, as its shape has them."""
    known, angle = load_catalogs(), math.radians(body.rotation)
    if isinstance(body, Decoration):
        return []
    found = []
    size = body.width, body.depth, body.height
    kinds = [kind for kind, entry in known.furniture.items() if known.name_of(kind) == body.name and entry.size == size]
    for solid in known.shapes.get(body.kind or next(iter(kinds), ""), ()):
        if solid.board is not None:
            corners = [((x - 0.5) * body.width, (z - 0.5) * body.depth) for x, z in itertools.product(solid.x, solid.z)]
            spun = [
                (body.x + x * math.cos(angle) + z * math.sin(angle), body.z - x * math.sin(angle) + z * math.cos(angle)) for x, z in corners
            ]
            top = body.y + solid.y[1] * body.height
            found.append((top, Turned((spun[0], spun[1], spun[3], spun[2]), body.y + solid.y[0] * body.height, top)))
    return found


def _unsupported(room: Room, half: float) -> Iterator[str]:
    bodies: dict[str, Body] = {body.id: body for group in (room.furniture, room.decorations) for body in group}
    for thing in room.decorations:
        if thing.mounted_on_wall:
            xs, zs = zip(*turned(thing).corners, strict=True)
            off = {
                "north": min(zs) - half,
                "south": room.depth - half - max(zs),
                "west": min(xs) - half,
                "east": room.width - half - max(xs),
            }
            if abs(off[thing.mounted_on_wall]) > CLOSE:
                yield f"{thing.id} hangs {off[thing.mounted_on_wall]:.4f} from its wall's face"
        elif thing.parent is None:
            if thing.y != 0:
                yield f"{thing.id} stands on nothing"
        else:
            carriers = [area for height, area in surfaces(bodies[thing.parent]) if abs(height - thing.y) < CLOSE]
            carriers += [area for height, area in boards(bodies[thing.parent]) if -CLOSE < thing.y - height < ROUNDED]
            if not any(_within(turned(thing).corners, area.corners) for area in carriers):
                yield f"{thing.id} does not lie wholly on {thing.parent}"


def _within(corners: Sequence[Point], area: Sequence[Point]) -> bool:
    """Tells whether all corners lie inside a convex area."""
    centre = sum(x for x, _ in area) / 4, sum(z for _, z in area) / 4
    for (x0, z0), (x1, z1) in zip(area, (*area[1:], area[0]), strict=True):
        length = math.hypot(x1 - x0, z1 - z0)
        normal = (z1 - z0) / length, (x0 - x1) / length
        inner = (centre[0] - x0) * normal[0] + (centre[1] - z0) * normal[1]
        for x, z in corners:
            if ((x - x0) * normal[0] + (z - z0) * normal[1]) * math.copysign(1, inner) < -CLOSE:
                return False
    return True


def _ancestors(thing: Decoration, room: Room) -> set[str]:
    parents = {one.id: one.parent for one in room.decorations}
    found, at = set[str](), thing.parent
    while at is not None and at not in found:
        found.add(at)
        at = parents.get(at)
    return found


def _together(room: Room) -> Iterator[str]:
    """Things share no space with each other nor with furniture, but with what they lie in or on, and chairs tucked there."""
    chairs: dict[str, set[str]] = {}
    for piece in room.furniture:
        chairs.setdefault(piece.under or "", set()).add(piece.id)
    things = [(thing, turned(thing), _ancestors(thing, room)) for thing in room.decorations if _is_solid(thing)]
    pieces = [(piece, turned(piece)) for piece in room.furniture]
    for thing, box, above in things:
        excepted = above | {chair for carrier in above for chair in chairs.get(carrier, ())}
        for piece, other in pieces:
            if piece.id not in excepted and shares(box, other):
                yield f"{thing.id} shares space with {piece.id}"
    for (one, box, above), (two, other, beyond) in combinations(things, 2):
        if one.id not in beyond and two.id not in above and shares(box, other):
            yield f"{one.id} shares space with {two.id}"


def _is_solid(thing: Decoration) -> bool:
    return thing.parent is not None or thing.mounted_on_wall is not None or thing.height > 0.02


def _before_openings(room: Room, half: float) -> Iterator[str]:
    for thing in room.decorations:
        if thing.mounted_on_wall is None:
            continue
        along = 0 if thing.mounted_on_wall in ("north", "south") else 1
        ends = [corner[along] for corner in turned(thing).corners]
        for opening in room.openings:
            beside = min(max(ends), opening.position + opening.width / 2) - max(min(ends), opening.position - opening.width / 2)
            high = min(thing.y + thing.height, opening.sill + opening.height) - max(thing.y, opening.sill)
            if opening.wall == thing.mounted_on_wall and min(beside, high) > CLOSE:
                yield f"{thing.id} hangs before {opening.id}"
        for piece in room.furniture:
            hidden = turned(piece)
            spans = [corner[along] for corner in hidden.corners]
            level = min(thing.y + thing.height, hidden.high) - max(thing.y, hidden.low)
            over = min(min(max(ends), max(spans)) - max(min(ends), min(spans)), level) > CLOSE
            if over and _away(hidden, thing.mounted_on_wall, room) < half + 0.1:
                yield f"{thing.id} hangs behind {piece.id}"


def _in_ways(room: Room) -> Iterator[str]:
    """Nothing hangs before a door or passage, up to 0.9 m from it, below its top: its leaf swings there, and one walks there."""
    for opening in room.openings:
        if opening.kind == "window" or opening.wall is None:
            continue
        side, deep = opening.width, min(opening.width, 0.9)
        low = opening.position - side / 2
        far = {"north": 0.0, "south": room.depth - deep, "west": 0.0, "east": room.width - deep}[opening.wall]
        x, z, width, depth = (low, far, side, deep) if opening.wall in ("north", "south") else (far, low, deep, side)
        corners = ((x, z), (x + width, z), (x + width, z + depth), (x, z + depth))
        before = Turned(corners, opening.sill, opening.sill + opening.height)
        for thing in room.decorations:
            if thing.mounted_on_wall is not None and shares(turned(thing), before):
                yield f"{thing.id} hangs in the way through {opening.id}"


def _away(box: Turned, wall: str, room: Room) -> float:
    """Returns how far a box is from a wall's line."""
    xs, zs = zip(*box.corners, strict=True)
    return {"north": min(zs), "south": room.depth - max(zs), "west": min(xs), "east": room.width - max(xs)}[wall]
