"""What is proven where the walk binds: nothing on a raster is cheaper, judged by a flood of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from solver.geometry import Rect
from solver.pieces import Candidate, Doorway, Piece, Space, Zone
from solver.placement import arrange
from solver.streams import Stream
from tests.every import every
from tests.oracles.walk import missed
from tests.sweeps import seeds

SEEDS = seeds(range(320), 31)
RASTER = 100
DOOR = 800
QPS = range(400), 32_800
"""Rooms, and the small QPs that they may take in all: a fortieth more than were counted when this was written.

Where places are also searched for that a sibling opened, they take a twenty-fifth more; where ways are, too, that were opened before, by
a sibling or with less room, a ninth.
"""
SQUARES = 700, 400
"""Floor kept free before a door: deeper than who walks, and less deep, so that a piece may cover where one comes in."""


def two_doors(seed: int) -> tuple[Space, list[Piece]]:
    """A room of 1.8-3 m with a door in the south wall and one in the north, and three pieces that want to stand anywhere in it."""
    stream = Stream(seed, "rooms between two doors")
    width, depth = (2000 + RASTER * stream.below(12) for _ in range(2))
    at = [RASTER * stream.below((width - DOOR) // RASTER + 1) for _ in range(2)]
    square = SQUARES[seed % 4 == 3]
    doors = (
        Doorway("door_1", "south", Rect(at[0], depth - square, at[0] + DOOR, depth), "hall"),
        Doorway("door_2", "north", Rect(at[1], 0, at[1] + DOOR, square), "hall"),
    )
    space = Space("room", Rect(0, 0, width, depth), tuple(Zone(door.square, 0, door.id) for door in doors), doors)
    pieces = []
    for k in range(3):
        size = RASTER * (2 + stream.below(9)), RASTER * (2 + stream.below(9)), 800
        anchor = RASTER * stream.below(width // RASTER), RASTER * stream.below(depth // RASTER)
        pieces.append(Piece(f"piece_{k}", True, (Candidate("box", size, 0, None, anchor),)))
    return space, pieces


def cost_of(piece: Piece, rect: Rect) -> float:
    """A square metre a square metre from where its middle is wished."""
    x, z = piece.candidates[0].anchor_mm
    return ((rect.x0 + rect.x1 - 2 * x) ** 2 + (rect.z0 + rect.z1 - 2 * z) ** 2) / 4e6


def places(space: Space, piece: Piece) -> list[tuple[float, Rect]]:
    """Where a piece may stand on the raster by itself, the cheapest first."""
    (width, depth), clear = piece.candidates[0].extent, space.clear
    corners = ((x, z) for x in range(0, clear.width - width + 1, RASTER) for z in range(0, clear.depth - depth + 1, RASTER))
    rects = (Rect(x, z, x + width, z + depth) for x, z in corners)
    free = [rect for rect in rects if not any(rect.overlaps(zone.rect) for zone in space.zones)]
    return sorted(((cost_of(piece, rect), rect) for rect in free), key=lambda one: one[0])


def cheaper(options: Sequence[list[tuple[float, Rect]]], below: float, before: Sequence[Rect] = ()) -> Iterator[list[Rect]]:
    """All ways for pieces to stand apart on the raster that cost less."""
    if not options:
        yield list(before)
        return
    for cost, rect in options[0]:
        if cost >= below:
            return
        if not any(rect.overlaps(other) for other in before):
            yield from cheaper(options[1:], below - cost, [*before, rect])


def proven_cost(seed: int, walk: bool = True) -> float | None:
    space, pieces = two_doors(seed)
    found = arrange(space, pieces, walk=walk)
    made = found.arrangement
    return found.cost if len(made.placed) == len(pieces) and made.proven and found.walkable == walk else None


@every("seed", SEEDS)
def test_nothing_on_the_raster_is_cheaper_than_what_is_proven(seed: int) -> None:
    cost = proven_cost(seed)
    if cost is None:
        return
    space, pieces = two_doors(seed)
    better = cheaper([places(space, piece) for piece in pieces], cost - 1e-6)
    assert next((rects for rects in better if not missed(space, rects, [])), None) is None


def test_the_walk_makes_many_of_the_rooms_dearer() -> None:
    dearer = [seed for seed in SEEDS if (cost := proven_cost(seed)) is not None and cost > (proven_cost(seed, walk=False) or 0) + 1e-3]
    assert len(dearer) >= len(SEEDS) // 4


def test_rooms_whose_doors_pieces_would_cover_are_proven_too() -> None:
    covering = seeds(range(3, 320, 4), 2)
    assert sum(proven_cost(seed) is not None for seed in covering) >= 0.75 * len(covering)


def test_nothing_is_searched_twice_for_the_walk() -> None:
    rooms, most = QPS
    assert most / 2 < sum(arrange(*two_doors(seed)).arrangement.solves for seed in rooms) < most
