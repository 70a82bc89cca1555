"""Whether pieces can be used together: against every layout on a raster and thousands between, judged by a flood of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import pytest

from solver.geometry import Rect, turned
from solver.pieces import Candidate, Doorway, Piece, Space, Stand, Zone
from solver.placement import Budget, feasible, minimal_conflict, move_least
from solver.placement.empty_floor import places_round_a_floor
from solver.placement.walkable import find_walkable
from solver.streams import Stream
from tests.every import every
from tests.oracles.walk import missed, side_towards

SEEDS = range(60)
RASTER = 100
SAMPLES = 500
SIDES = ("front", "back", "left", "right")


def room(width: int, depth: int, *doors: Doorway) -> Space:
    zones = tuple(Zone(door.square, 0, door.id) for door in doors)
    return Space("room", Rect(0, 0, width, depth), zones, doors)


def free(label: str, size: tuple[int, int], rotation: int, sides: Sequence[str] = (), need_all: bool = False) -> Piece:
    way = Candidate(label, (*size, 800), rotation, None, (500, 500))
    return Piece(label, True, (way,), stands=tuple(Stand(side) for side in sides), need_all=need_all)


def tight(seed: int) -> tuple[Space, list[Piece]]:
    """A room of 1.5-2.8 m with a door in two of three, and two or three pieces that leave little of it."""
    stream = Stream(seed, "tight rooms to use")
    width, depth = 1500 + RASTER * stream.below(14), 1500 + RASTER * stream.below(14)
    door = Doorway("door_1", "south", Rect(RASTER * 2, depth - 800, RASTER * 2 + 800, depth), "hall")
    pieces = []
    for k in range(2 + stream.below(2)):
        size = RASTER * (3 + stream.below(14)), RASTER * (3 + stream.below(9))
        sides = [side for side in SIDES if stream.chance(0.3)]
        pieces.append(free(f"piece_{k}", size, 90 * stream.below(4), sides, stream.chance(0.5)))
    return room(width, depth, *([door] if stream.chance(0.66) else [])), pieces


def extents(piece: Piece) -> tuple[int, int]:
    way = piece.candidates[0]
    return turned(way.size_mm[0], way.size_mm[1], way.rotation)


def holds(space: Space, pieces: Sequence[Piece], rects: Sequence[Rect]) -> bool:
    """Whether a layout breaks no rule and all of it can be used."""
    clear = space.clear
    if any(r.x0 < clear.x0 or r.z0 < clear.z0 or r.x1 > clear.x1 or r.z1 > clear.z1 for r in rects):
        return False
    if any(r.overlaps(zone.rect) for r in rects for zone in space.zones):
        return False
    if any(a.overlaps(b) for k, a in enumerate(rects) for b in rects[:k]):
        return False
    uses = [
        (piece.label, rect, [side_towards(stand.side, piece.candidates[0].rotation) for stand in piece.stands], piece.need_all)
        for piece, rect in zip(pieces, rects, strict=True)
        if piece.stands
    ]
    return missed(space, rects, uses) == []


def layouts(space: Space, pieces: Sequence[Piece], seed: int) -> Iterator[list[Rect]]:
    """Every layout on the raster where these are few, and some in whole millimetres, many of them at walls."""
    clear, sizes = space.clear, [extents(piece) for piece in pieces]
    slack = [(clear.width - wide, clear.depth - deep) for wide, deep in sizes]
    if min(min(pair) for pair in slack) < 0:
        return
    places = [list(product(range(0, w + 1, RASTER), range(0, d + 1, RASTER))) for w, d in slack]
    if len(pieces) == 2 and len(places[0]) * len(places[1]) <= 4 * SAMPLES:
        for corners in product(*places):
            yield [Rect(x, z, x + wide, z + deep) for (x, z), (wide, deep) in zip(corners, sizes, strict=True)]
    stream = Stream(seed, "layouts")
    for _ in range(SAMPLES):
        corners = tuple((anywhere(stream, w), anywhere(stream, d)) for w, d in slack)
        yield [Rect(x, z, x + wide, z + deep) for (x, z), (wide, deep) in zip(corners, sizes, strict=True)]


def anywhere(stream: Stream, slack: int) -> int:
    return (0, slack, stream.below(slack + 1))[stream.below(3)]


@every("seed", SEEDS)
def test_never_is_never_and_what_is_found_holds(seed: int) -> None:
    space, pieces = tight(seed)
    possible, found = find_walkable(space, pieces, Budget())
    if possible:
        assert [one.piece.label for one in found] == [piece.label for piece in pieces]
        assert holds(space, pieces, [one.footprint for one in found])
    if possible is False:
        assert [rects for rects in layouts(space, pieces, seed) if holds(space, pieces, rects)] == []


def test_the_rooms_above_are_of_both_kinds_and_hardly_one_stays_open() -> None:
    verdicts = [find_walkable(*tight(seed), Budget())[0] for seed in SEEDS]
    assert verdicts.count(True) >= 12
    assert verdicts.count(False) >= 20
    assert verdicts.count(None) <= 3


def pockets(depth: int) -> tuple[Space, list[Piece]]:
    """A strip of floor between a bed and a wardrobe, which a chest that fits nowhere else cuts in two."""
    bed, wardrobe = free("bed", (1900, 2100), 0), free("wardrobe", (2000, 550), 90, ("front",))
    return room(3200, depth), [bed, wardrobe, free("chest", (400, 400), 0)]


def test_a_strip_of_floor_cut_in_two_is_a_minimal_conflict() -> None:
    space, pieces = pockets(2300)
    assert feasible(space, pieces, walk=True) is False
    assert minimal_conflict(space, pieces, "chest", walk=True) == ("bed", "wardrobe", "chest")
    for gone in range(3):
        possible, found = find_walkable(space, pieces[:gone] + pieces[gone + 1 :], Budget())
        assert possible
        assert holds(space, pieces[:gone] + pieces[gone + 1 :], [one.footprint for one in found])


def test_a_chest_that_fits_beside_the_bed_cuts_nothing() -> None:
    space, pieces = pockets(2600)
    possible, found = find_walkable(space, pieces, Budget())
    assert possible
    assert holds(space, pieces, [one.footprint for one in found])


def test_each_of_several_ways_is_looked_at() -> None:
    ways = tuple(Candidate("desk", (1200, 600, 800), rotation, None, (500, 500)) for rotation in (0, 90))
    desk = Piece("desk", True, ways, stands=(Stand("front"),))
    assert find_walkable(room(1200, 1640), [desk], Budget())[0] is True
    assert find_walkable(room(1640, 1200), [desk], Budget())[0] is True
    assert find_walkable(room(1640, 1190), [desk], Budget())[0] is False


def test_without_work_left_nothing_is_claimed() -> None:
    assert find_walkable(*pockets(2300), Budget(0.0)) == (None, ())


def crowd(seed: int) -> tuple[Space, list[Piece]]:
    """Eight to ten pieces that cover more than half of a room without a door, most of them used from one side of several."""
    stream = Stream(seed, "crowds")
    pieces = [free("sofa", (2200, 900), 90), free("table", (1500, 900), 0), free("shelf", (1800, 400), 0)]
    for k in range(5 + stream.below(3)):
        size = 450 + stream.below(350), 500 + stream.below(400)
        pieces.append(free(f"chair_{k}", size, 90 * stream.below(4), ("back", "left", "right")[: 1 + stream.below(3)]))
    area = sum(wide * deep for wide, deep in map(extents, pieces))
    side = int((area / 0.62) ** 0.5)
    return room(side + 100, side - 100), pieces


@pytest.mark.parametrize("seed", range(8))
def test_what_finds_its_places_round_a_floor_is_arranged(seed: int) -> None:
    space, pieces = crowd(seed)
    found = any(places_round_a_floor(space, pieces, Budget()))
    arrangement = move_least(space, pieces, Budget()).arrangement
    rects = {placed.label: placed.footprint for placed in arrangement.placed}
    assert not found or (arrangement.notes == () and holds(space, pieces, [rects[piece.label] for piece in pieces]))


def test_round_a_floor_most_of_the_crowds_find_their_places() -> None:
    assert sum(any(places_round_a_floor(*crowd(seed), Budget())) for seed in range(8)) >= 5
