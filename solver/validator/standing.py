"""The rules for where bodies stand: one function each, a room at a time.

Comes in: a `World` and one of its places. Goes out: findings. May import: scene. Every comparison is of integers.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

from solver.validator.judging import Finding, RuleCase
from solver.validator.lattice import ExactBox, WallEdge, exact, words
from solver.validator.world import DOOR_KINDS, Hole, PlacedBody, PlacedRoom, World

WALL_REACH: Final = exact(0.2)
"""A piece with a wall is no farther than this from its line."""
DOOR_DEPTH: Final = exact(0.9)
"""A door's square is as deep as the door is wide, at most this."""
WINDOW_DEPTH: Final = exact(0.5)
WINDOW_MARGIN: Final = exact(0.1)
"""What tall pieces leave free before a window, and beside it."""
SITTING_ROOM: Final = exact(0.15)
"""How much of a tucked chair's depth must stay out from under its table."""


class Square(NamedTuple):
    """Floor that a door needs, and the heights it needs there."""

    hole: Hole
    box: ExactBox


def out_of_bounds(case: RuleCase) -> Iterator[Finding]:
    """A body leaves its room's clear area: the wall lines moved in by half a wall."""
    place = case.room
    for body in place.bodies:
        amount, where = _outside(place, body.box.grown(case.world.half_wall))
        if amount > 0:
            yield Finding((body.id,), amount, f"{body.id} leaves the clear floor of {place.room.id} {where} by {words(amount)}")


def _outside(place: PlacedRoom, box: ExactBox) -> tuple[int, str]:
    """Returns how far a box leaves the wall lines, and which way."""
    bounds = place.outline.bounds
    ways = [
        (bounds.x0 - box.x0, "to the west"),
        (box.x1 - bounds.x1, "to the east"),
        (bounds.z0 - box.z0, "to the north"),
        (box.z1 - bounds.z1, "to the south"),
    ]
    ways += [(min(box.shared(part)), "into a corner that is not part of it") for part in place.outline.missing]
    return max(ways, key=lambda way: way[0])


def overlap(case: RuleCase) -> Iterator[Finding]:
    """Two bodies share space; but a chair may be tucked under its table, and a thing may stand on another."""
    bodies, bounds = case.room.bodies, case.room.outline.bounds
    axis = 0 if bounds.x1 - bounds.x0 >= bounds.z1 - bounds.z0 else 1
    ranked = sorted(range(len(bodies)), key=lambda index: bodies[index].box[axis])
    found: list[tuple[tuple[int, int], Finding]] = []
    for position, index in enumerate(ranked):
        end = bodies[index].box[axis + 2]
        for later in range(position + 1, len(ranked)):
            other = ranked[later]
            if bodies[other].box[axis] >= end:
                break
            first, second = sorted((index, other))
            found += (((first, second), finding) for finding in _collision(bodies[first], bodies[second]))
    yield from (finding for _, finding in sorted(found))


def _collision(a: PlacedBody, b: PlacedBody) -> Iterator[Finding]:
    wide, deep = a.box.shared(b.box)
    tall = min(a.high, b.high) - max(a.low, b.low)
    if min(wide, deep, tall) <= 0 or a.on == b.id or b.on == a.id:
        return
    if a.under == b.id or b.under == a.id:
        chair, table = (a, b) if a.under == b.id else (b, a)
        yield from _tucked_too_far(chair, table)
        return
    size = f"{words(wide)} from west to east, {words(deep)} from north to south"
    yield Finding((a.id, b.id), min(wide, deep, tall), f"{a.id} and {b.id} share space: {size}, {words(tall)} in height")


def _tucked_too_far(chair: PlacedBody, table: PlacedBody) -> Iterator[Finding]:
    wide, deep = chair.box.shared(table.box)
    tucked = wide if chair.front in ("east", "west") else deep
    allowed = max(0, chair.depth - SITTING_ROOM)
    if tucked > allowed:
        amount = tucked - allowed
        room = f"{words(tucked)} of its {words(chair.depth)} depth, {words(amount)} too far to sit down"
        yield Finding((chair.id, table.id), amount, f"{chair.id} is tucked under {table.id} by {room}")


def wall_far(case: RuleCase) -> Iterator[Finding]:
    """A piece whose `wall` is set is more than 0.2 m from that wall's line."""
    place = case.room
    for body in place.bodies:
        if body.wall is not None:
            distance = min((_distance(body.box, edge) for edge in _walls(place, body)), default=0)
            if distance > WALL_REACH:
                where = f"{words(distance)} from the {body.wall} wall of {place.room.id}"
                yield Finding((body.id,), distance - WALL_REACH, f"{body.id} stands {where}, at most {words(WALL_REACH)} is allowed")


def _walls(place: PlacedRoom, body: PlacedBody) -> list[WallEdge]:
    """Returns the pieces of a body's wall: those it stands before, else all of them."""
    edges = [edge for edge in place.edges if edge.side == body.wall]
    return [edge for edge in edges if _stands_before(body.box, edge)] or edges


def _stands_before(box: ExactBox, edge: WallEdge) -> bool:
    start, end = (box.x0, box.x1) if edge.runs_east else (box.z0, box.z1)
    return start < edge.end and edge.start < end


def _distance(box: ExactBox, edge: WallEdge) -> int:
    """Returns how far a box is from the edge's line; 0 where the line runs through it."""
    low, high = (box.z0, box.z1) if edge.runs_east else (box.x0, box.x1)
    return max(0, low - edge.line, edge.line - high)


def blocks_door(case: RuleCase) -> Iterator[Finding]:
    """A body stands in the square of a door or passage, on either side of it."""
    place = case.room
    for square in squares(case.world, place):
        for body in place.bodies:
            stands_there = body.low < square.hole.top and body.high > square.hole.sill
            if stands_there and body.box.meets(square.box):
                amount = min(body.box.shared(square.box))
                opening = square.hole.opening
                message = f"{body.id} stands {words(amount)} in the way of the {opening.kind} {opening.id} in {place.room.id}"
                yield Finding((body.id,), amount, message)


def squares(world: World, place: PlacedRoom) -> Iterator[Square]:
    """Returns the door squares in a room: of its own doors, and of those that only the other room lists."""
    for hole in place.holes:
        if hole.opening.kind in DOOR_KINDS:
            yield Square(hole, hole.edge.strip(hole.start, hole.end, _square_depth(hole)))
    own = {opening.id for opening in place.room.openings}
    for other, hole in world.leading_to.get(place.room.id, ()):
        if other is not place and hole.opening.id not in own and hole.opening.kind in DOOR_KINDS:
            box = hole.edge.strip(hole.start, hole.end, 0, outwards=_square_depth(hole))
            yield Square(hole, box.moved(other.x - place.x, other.z - place.z))


def _square_depth(hole: Hole) -> int:
    return min(hole.end - hole.start, DOOR_DEPTH)


def blocks_window(case: RuleCase) -> Iterator[Finding]:
    """A piece taller than the sill stands within 0.5 m of a window, its width plus 0.1 m each side."""
    place = case.room
    for hole in place.holes:
        if hole.opening.kind == "window":
            zone = window_zone(hole)
            for body in place.bodies:
                hides = body.is_furniture and body.high > hole.sill and body.low < hole.top
                if hides and body.box.meets(zone):
                    yield _hiding(place, body, hole, zone)


def window_zone(hole: Hole) -> ExactBox:
    """Returns the strip before a window where nothing taller than its sill stands."""
    return hole.edge.strip(hole.start - WINDOW_MARGIN, hole.end + WINDOW_MARGIN, WINDOW_DEPTH)


def _hiding(place: PlacedRoom, body: PlacedBody, hole: Hole, zone: ExactBox) -> Finding:
    amount = min(body.box.shared(zone))
    above = words(body.high - hole.sill)
    message = f"{body.id} stands {words(amount)} before the window {hole.opening.id} of {place.room.id} and is {above} higher than its sill"
    return Finding((body.id,), amount, message)
