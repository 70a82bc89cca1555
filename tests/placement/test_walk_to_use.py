"""What is proven where pieces must be come to, and wide doors may be covered: nothing on a raster is cheaper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice

from solver.geometry import Rect
from solver.pieces import Candidate, Doorway, Piece, Space, Stand, Zone
from solver.placement import arrange
from solver.streams import Stream
from tests.every import every
from tests.oracles.walk import missed, side_towards
from tests.placement.test_walk_optimum import RASTER, cheaper, places
from tests.sweeps import seeds

DOOR, SQUARE = 1200, 300
"""A door wider than who walks, and floor before it that is less deep: a piece may cover a part of where one comes in."""
MOST = 20_000
"""Arrangements on the raster that are looked at in a room."""


def used_room(seed: int) -> tuple[Space, list[Piece]]:
    """A room of 1.8-2.9 m with one wide door or two, and two pieces that are used from one side, or from either of two, or from both."""
    stream = Stream(seed, "rooms with sides")
    width, depth = (1800 + RASTER * stream.below(12) for _ in range(2))
    at = [RASTER * stream.below((width - DOOR) // RASTER + 1) for _ in range(2)]
    doors = [Doorway("door_1", "south", Rect(at[0], depth - SQUARE, at[0] + DOOR, depth), "hall")]
    if stream.below(2):
        doors.append(Doorway("door_2", "north", Rect(at[1], 0, at[1] + DOOR, SQUARE), "hall"))
    pieces = []
    for k in range(2):
        size = RASTER * (3 + stream.below(9)), RASTER * (2 + stream.below(6)), 800
        anchor = RASTER * stream.below(width // RASTER), RASTER * stream.below(depth // RASTER)
        way = Candidate("box", size, 90 * stream.below(4), None, anchor)
        sides = ("front",) if stream.below(3) else ("left", "right")
        pieces.append(Piece(f"piece_{k}", True, (way,), stands=tuple(map(Stand, sides)), need_all=bool(stream.below(2))))
    return Space("room", Rect(0, 0, width, depth), tuple(Zone(door.square, 0, door.id) for door in doors), tuple(doors)), pieces


def is_used(space: Space, pieces: Sequence[Piece], rects: Sequence[Rect]) -> bool:
    """Tells whether somebody comes to all doors and pieces that stand there."""
    turned = [[side_towards(one.side, piece.candidates[0].rotation) for one in piece.stands] for piece in pieces]
    uses = [(piece.label, rect, walls, piece.need_all) for piece, rect, walls in zip(pieces, rects, turned, strict=True)]
    return not missed(space, rects, uses)


def cost_there(space: Space, pieces: Sequence[Piece], rects: Sequence[Rect]) -> float:
    """Returns what it costs that pieces stand there, with what the floor at their sides is worth."""
    fixed = [replace(piece, candidates=(replace(piece.candidates[0], within=rect),)) for piece, rect in zip(pieces, rects, strict=True)]
    return arrange(space, fixed, walk=True).cost


@every("seed", seeds(range(3000, 3400), 31))
def test_nothing_on_the_raster_is_cheaper_than_what_is_proven(seed: int) -> None:
    space, pieces = used_room(seed)
    found = arrange(space, pieces, walk=True)
    if len(found.arrangement.placed) < len(pieces) or not found.arrangement.proven or not found.walkable:
        return
    ways = islice(cheaper([places(space, piece) for piece in pieces], found.cost - 1e-6), MOST)
    assert all(cost_there(space, pieces, rects) >= found.cost - 1e-6 for rects in ways if is_used(space, pieces, rects))


def test_most_rooms_are_proven() -> None:
    found = [arrange(*used_room(seed), walk=True) for seed in range(3000, 3200)]
    walked = [one for one in found if len(one.arrangement.placed) == 2 and one.walkable]
    assert sum(one.arrangement.proven for one in walked) >= 0.9 * len(walked) > 100
