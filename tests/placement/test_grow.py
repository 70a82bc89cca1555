"""Which way each piece stands: the search over prefixes against all ways together, each searched from nothing."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate
from operator import mul

import pytest

from solver.placement import Budget, kernel
from solver.placement.core import Core, Limits
from solver.placement.encode import encode
from solver.placement.layout import Ints
from solver.streams import Stream
from tests.furnish.wanting_rooms import wanting_room
from tests.placement.rooms import random_space, random_wanted

ROOMS = 300
MOST_WAYS = 200
QPS = 20_000


def random_core(seed: int) -> Core:
    """A room with three or four pieces; every other with the first that a room of a type wants, so many as have few ways together."""
    if seed % 2:
        space, wanted = wanting_room(seed).pieces()
        ways = accumulate((len(piece.candidates) for piece in wanted), mul)
        return Core(encode(space, [piece for piece, count in zip(wanted, ways, strict=True) if count <= MOST_WAYS]))
    stream = Stream(seed, "grow")
    space = random_space(stream)
    return Core(encode(space, random_wanted(space, stream, 3 + seed // 2 % 2)))


def all_ways(core: Core, start: Ints, piece: int = 0) -> Iterator[Ints]:
    """Yields the decisions of all pieces from a number on."""
    if piece == len(start):
        yield start
        return
    for decision in kernel.open_decisions(core.engine, start, piece)[0].tolist():
        grown = start.copy()
        grown[piece] = decision
        yield from all_ways(core, grown, piece + 1)


def cost(core: Core, decisions: Ints, walk: bool) -> float:
    """What decisions cost, searched from nothing; infinite where they cannot stand."""
    if not core.evaluate(decisions, QPS, Budget(), walk):
        return float("inf")
    return float(core.engine.nodes.best_cost[0]) + core.preference(decisions)


@pytest.mark.parametrize("walk", [False, True])
def test_no_other_ways_are_cheaper(walk: bool) -> None:
    """A piece that may stand where it costs least beside the others is not searched for: here all are."""
    found = none = moved = several = exact = 0
    for seed in range(ROOMS):
        core = random_core(seed)
        answer, closed = core.stand_together(Limits(required_qps=QPS), Budget(), walk)
        assert closed or walk
        costs = [cost(core, decisions, walk) for decisions in all_ways(core, core.blank())]
        several, exact = several + (len(costs) > 10), exact + closed
        own = float("inf") if answer is None else cost(core, answer, walk)
        assert own == pytest.approx(min(costs), abs=1e-7), seed
        found, none = found + (answer is not None), none + (answer is None)
        moved += answer is not None and own - core.preference(answer) > 0.01
    assert found > 40 and none > 5 and moved > 20 and several > 50 and exact > 0.85 * ROOMS, (found, none, moved, several, exact)
