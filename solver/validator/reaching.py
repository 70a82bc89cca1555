"""The rule `unreachable`: a square as wide as the robot comes to every room and every use side."""

from collections.abc import Iterator
from typing import Final

from catalogs.entries import Use
from solver.geometry import LEAST_FLOOR_MM2, OPPOSITE
from solver.scene import WALLS, Furniture
from solver.validator.judging import Finding, RuleCase
from solver.validator.lattice import PER_METRE, words
from solver.validator.walk import Walk
from solver.validator.world import PlacedRoom, World, side_of

LEAST_FLOOR: Final = LEAST_FLOOR_MM2 * (PER_METRE // 1000) ** 2
"""How much of a room's free centres must be reached, in square lattice steps."""


def unreachable(case: RuleCase) -> Iterator[Finding]:
    """The robot's square cannot come to the room, or to a piece's use side. In a room it cannot come to, pieces go unsaid."""
    world, walk, place = case.world, case.walk, case.room
    if walk.floor(place) < LEAST_FLOOR:
        yield Finding((), world.robot, _room_message(world, walk, place))
        return
    missed = walk.missed[place.room.id]
    for number in (number for number, touched in enumerate(missed) if touched) if any(missed) else ():
        piece, use = place.room.furniture[number], case.kinds.uses[place.keys[number]]
        assert use is not None, "what is not used misses nothing"
        yield Finding((piece.id,), world.robot, _side_message(world, piece, use, missed[number]))


def _room_message(world: World, walk: Walk, place: PlacedRoom) -> str:
    wide = f"somebody {words(world.robot)} wide"
    ways = ", ".join(dict.fromkeys(hole.opening.id for hole in walk.entrances))
    if walk.floor(place, only_entered=False) < LEAST_FLOOR:
        return f"{place.room.id} has less than 0.25 m2 where {wide} can stand"
    openings = (*place.holes, *(hole for _, hole in world.leading_to.get(place.room.id, ())))
    if all(hole.opening.kind == "window" for hole in openings):
        return f"{place.room.id} has no door or passage{_behind(world, place)}"
    if walk.entrances and not walk.comes_in:
        return f"{wide} cannot get in through {ways}, so not to {place.room.id}"
    return f"{wide} cannot get to {place.room.id} from {ways or 'the largest free floor'}"


def _behind(world: World, place: PlacedRoom) -> str:
    """Says which room could be come from through a wall: where the most wall is shared, and somebody fits through."""
    shared = [
        (min(own.end, edge.end) - max(own.start, edge.start), own.side, other.room.id)
        for own in (edge.moved(place.x, place.z) for edge in place.edges)
        for other, edge in world.walls_along.get((place.room.level, OPPOSITE[own.side], own.line), ())
        if other is not place
    ]
    length, wall, room = max(shared, key=lambda one: one[0], default=(0, "", ""))
    return f"; it shares {words(length)} of its {wall} wall with {room}" if length >= world.robot else ""


def _side_message(world: World, piece: Furniture, use: Use, touched: int) -> str:
    """Says which use sides cannot be come to; of `touched` the bits of walls are those that its sides which can be look to."""
    joined, looks_to = " and its " if use.need == "all" else " or its ", {side: side_of(piece.rotation, side) for side in use.sides}
    sides = joined.join(f"{side} ({wall})" for side, wall in looks_to.items() if not touched >> WALLS.index(wall) & 1)
    return f"somebody {words(world.robot)} wide cannot get to {piece.id}'s {sides}"
