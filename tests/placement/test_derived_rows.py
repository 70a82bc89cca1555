"""What the core derives of the rows it is sent of a room: kins of candidates, groups of pieces; held to what these words mean."""

from __future__ import annotations

from dataclasses import astuple, replace

from solver.pieces import Candidate, Link, Piece, Space
from solver.placement.encode import encode
from solver.placement.layout import CANDIDATE_0, CANDIDATE_1, GROUP_END, KIN
from solver.streams import Stream
from tests.placement.rooms import random_space, random_wanted
from tests.sweeps import seeds

SEEDS = seeds(range(400), 100)


def some(seed: int) -> tuple[Space, list[Piece]]:
    """A random room; some pieces have ways twice, wished elsewhere, or come only with the next one, which may rely on them."""
    stream = Stream(seed, "derived")
    space, pieces = random_space(stream), list[Piece]()
    for piece in random_wanted(space, stream, 2 + stream.below(9)):
        again = [replace(way, anchor_mm=(stream.below(4000), 1000), cost=way.cost + 1) for way in piece.candidates if stream.chance(0.5)]
        links = (Link("beside", pieces[-1].label, required=stream.chance(0.5)),) if pieces and stream.chance(0.4) else ()
        ways = (*piece.candidates, *again)
        pieces.append(replace(piece, candidates=ways, links=links, with_next=stream.chance(0.6), required=stream.chance(0.2)))
    return space, pieces


def as_it_stands(way: Candidate) -> tuple[object, ...]:
    return astuple(replace(way, anchor_mm=(0, 0), cost=0.0, weights=(0.0, 0.0)))


def last_of_group(pieces: list[Piece], at: int) -> int:
    """A piece that comes only with the next brings that one's group, where it can stand only with such pieces or must relate to it."""
    own = pieces[at]
    if not own.with_next or own.required or at + 1 == len(pieces):
        return at
    chain = {own.label}
    for before in reversed(pieces[:at]):
        if not before.with_next:
            break
        chain.add(before.label)
    after = pieces[at + 1]
    bound = any(link.required and link.of == own.label for link in after.links)
    return last_of_group(pieces, at + 1) if bound or all(parent in chain for parent in after.parents) else at


def test_kins_differ_in_nothing_but_their_wishes_and_groups_are_as_said() -> None:
    kin, grouped = 0, 0
    for seed in SEEDS:
        space, pieces = some(seed)
        room = encode(space, pieces).engine.room
        for k, (piece, row) in enumerate(zip(pieces, room.pieces, strict=True)):
            assert row[GROUP_END] == last_of_group(pieces, k) + 1, (seed, piece.label)
            grouped += row[GROUP_END] > k + 1
            numbers = room.candidates[row[CANDIDATE_0] : row[CANDIDATE_1], KIN].tolist()
            for i, one in enumerate(piece.candidates):
                for j, other in enumerate(piece.candidates[:i]):
                    assert (numbers[i] == numbers[j]) == (as_it_stands(one) == as_it_stands(other)), (seed, piece.label)
                    kin += numbers[i] == numbers[j]
    assert kin > len(SEEDS) and grouped > len(SEEDS) // 4
