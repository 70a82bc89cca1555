"""The rule `unreachable`: a square as wide as the robot comes to every room and every use side."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from catalogs.entries import Use
from solver.geometry import LEAST_FLOOR_MM2
from solver.scene import Furniture
from solver.validator.judging import Finding, RuleCase
from solver.validator.kinds import Kinds
from solver.validator.lattice import PER_METRE, words
from solver.validator.walk import Walk
from solver.validator.world import SIDES, PlacedRoom, World, side_of

LEAST_FLOOR: Final = LEAST_FLOOR_MM2 * (PER_METRE // 1000) ** 2
"""How much of a room's free centres must be reached, in square lattice steps."""


def unreachable(case: RuleCase) -> Iterator[Finding]:
    """The robot's square cannot come to the room, or to a piece's use side. In a room it cannot come to, pieces go unsaid."""
    world, walk, place = case.world, case.walk, case.room
    if walk.floor(place) < LEAST_FLOOR:
        yield Finding((), world.robot, _room_message(world, walk, place))
        return
    for number, use in used_pieces(place, case.kinds):
        missed = missed_sides(walk, place, number, use)
        if missed:
            piece = place.room.furniture[number]
            yield Finding((piece.id,), world.robot, _side_message(world, piece, use, missed))


def used_pieces(place: PlacedRoom, kinds: Kinds) -> Iterator[tuple[int, Use]]:
    """Yields the pieces of a room that are used from a side, by their numbers there, and from which."""
    use_of = kinds.use_of
    return ((number, use) for number, (key, _) in enumerate(place.pieces) if (use := use_of(key)) is not None)


def missed_sides(walk: Walk, place: PlacedRoom, number: int, use: Use) -> tuple[str, ...]:
    """Returns the use sides of a piece, by its number in its room, that the square cannot come to; none where enough are reached."""
    touched = walk.touched(place, number)
    if len(touched) == len(SIDES):
        return ()
    rotation = place.pieces[number][1]
    missed = tuple([side for side in use.sides if side_of(rotation, side) not in touched])
    return missed if use.need == "all" or len(missed) == len(use.sides) else ()


def _room_message(world: World, walk: Walk, place: PlacedRoom) -> str:
    wide = f"somebody {words(world.robot)} wide"
    ways = ", ".join(dict.fromkeys(hole.opening.id for hole in walk.entrances))
    if walk.floor(place, only_entered=False) < LEAST_FLOOR:
        return f"{place.room.id} has less than 0.25 m2 where {wide} can stand"
    if walk.entrances and not walk.comes_in:
        return f"{wide} cannot get in through {ways}, so not to {place.room.id}"
    return f"{wide} cannot get to {place.room.id} from {ways or 'the largest free floor'}"


def _side_message(world: World, piece: Furniture, use: Use, missed: tuple[str, ...]) -> str:
    joined = " and its " if use.need == "all" else " or its "
    sides = joined.join(f"{side} ({side_of(piece.rotation, side)})" for side in missed)
    return f"somebody {words(world.robot)} wide cannot get to {piece.id}'s {sides}"
