"""Can these pieces all stand in a room and be walked to? The programme of room.py, and for every goal a way to it.

A way is a chain of squares of the person's size, from the first door to a goal (another door, a use side), each a straight
move from the one before, along x and z in turn; the rectangle every move sweeps is free. First the programme without ways: if
even that has no answer, or its answer happens to be walkable by the flood of walk.py, it is done. Else with ways of three
moves, then of five. An answer is shown by the flood; where it leaves less than 0.25 m2 to walk on, the question stays open.
"None" then speaks of ways of five moves: in a room with so few pieces every way there is, but for spirals.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from solver.pieces import Doorway, Piece, Space
from tests.oracles.programme import Terms
from tests.oracles.room import Answer, Box, Model, shown
from tests.oracles.rules import unreached
from tests.oracles.verdict import SECONDS
from tests.oracles.walk import FLOOR

MOVES = (3, 5)


def stand_and_walk(space: Space, pieces: Sequence[Piece], seconds: float = SECONDS) -> Answer:
    """Tells whether pieces can all stand such that all doors and use sides are joined for the space's person.

    Args:
        space: the room; it has a doorway.
        pieces: all must stand; what is attached comes after its parent.
        seconds: time limit of each programme solved on the way.
    """
    verdict, arrangement = Model(space, pieces, stands=True).solve(seconds)
    if arrangement is None:
        return Answer(verdict, "no choice of ways and sides" if verdict is False else "time ran out")
    if not unreached(space, pieces, arrangement):
        return Answer(True, "shown", shown(space, pieces, arrangement))
    for moves in MOVES:
        model = Model(space, pieces, stands=True)
        if not _add_ways(model, moves):
            return Answer(False, "a door too narrow for the person")
        verdict, arrangement = model.solve(seconds)
        if arrangement is not None:
            short = unreached(space, pieces, arrangement)
            if short == [FLOOR]:
                return Answer(None, "a way, but hardly any floor")
            if short:
                raise RuntimeError(f"the oracle's way leads nowhere: {short}")
            return Answer(True, f"shown, {moves} moves", shown(space, pieces, arrangement))
        if verdict is None:
            return Answer(None, "time ran out")
    return Answer(False, f"no way of {MOVES[-1]} moves")


def _add_ways(model: Model, moves: int) -> bool:
    """Adds a way from the first door to every goal; False where a door cannot be passed at all."""
    always = model.programme.variable(1, 1, whole=True)
    doors = [_at_door(model, door) for door in model.space.doorways]
    if None in doors:
        return False
    first, *others = [door for door in doors if door is not None]
    for goal, used in [*((door, always) for door in others), *model.people]:
        _way(model, (first, goal), used, moves)
    return True


def _at_door(model: Model, door: Doorway) -> Box | None:
    """Returns the square of a person who has just come through a door."""
    clear, size = model.space.clear, model.space.robot_mm
    axis = 0 if door.wall in ("north", "south") else 1
    low, high = clear.along(door.wall)
    a, b = door.square.along(door.wall)
    a, b = max(a, low), min(b, high) - size
    if a > b:
        return None
    own = door.square
    starts = {"north": max(clear.z0, own.z0), "west": max(clear.x0, own.x0)}
    face = {**starts, "south": min(clear.z1, own.z1) - size, "east": min(clear.x1, own.x1) - size}[door.wall]
    ends = [(face, face), (face, face)]
    ends[axis] = (a, b)
    at = tuple([(model.programme.variable(*ends[k]), 1.0)] for k in (0, 1))
    return Box(door.id, (at[0], at[1]), (at[0], at[1]), False, size=size)


def _way(model: Model, between: tuple[Box, Box], used: int, moves: int) -> None:
    """Adds a chain of squares, first straight in from the door, whose sweeps are free where the binary is 1."""
    start, goal = between
    inwards_x = any(door.id == start.label and door.wall in ("east", "west") for door in model.space.doorways)
    squares = [start, *(model.square("") for _ in range(moves - 1)), goal]
    for k, (a, b) in enumerate(pairwise(squares)):
        along = k % 2 if inwards_x else 1 - k % 2
        _equal(model, a.starts[1 - along], b.starts[1 - along])
        model.free(_sweep(model, a, b, along), used)


def _equal(model: Model, a: Terms, b: Terms) -> None:
    difference = [*a, *((v, -c) for v, c in b)]
    model.programme.at_least(difference, 0)
    model.programme.at_least([(v, -c) for v, c in difference], 0)


def _sweep(model: Model, a: Box, b: Box, along: int) -> Box:
    """Returns the rectangle between two squares, ends included."""
    clear, programme = model.space.clear, model.programme
    bounds = (clear.x0, clear.x1) if along == 0 else (clear.z0, clear.z1)
    low, high = programme.variable(*bounds), programme.variable(*bounds)
    for square in (a, b):
        programme.at_least([*square.starts[along], (low, -1.0)], 0)
        programme.at_least([(high, 1.0), *((v, -c) for v, c in square.starts[along])], 0)
    starts, ends = [a.starts[0], a.starts[1]], [a.starts[0], a.starts[1]]
    starts[along], ends[along] = [(low, 1.0)], [(high, 1.0)]
    return Box("", (starts[0], starts[1]), (ends[0], ends[1]), False, size=a.size)
