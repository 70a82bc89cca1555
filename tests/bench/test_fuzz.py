"""A slice of `make fuzz`, and its judge judged: moved, missing and blocked pieces are found."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver.geometry import Rect
from solver.pieces import Arrangement, Piece, Placed, Space
from solver.placement import place
from tests.bench.fuzz import fuzz
from tests.bench.fuzz_rooms import fuzz_room
from tests.oracles.rules import faults, unreached
from tests.sweeps import times

ROOMS = times(300, 120)


@pytest.mark.parametrize("block", range(4))
def test_random_rooms_are_exactly_as_asked_and_conflicts_minimal(block: int) -> None:
    size = ROOMS // 4
    tally = fuzz(block * size, size, oracle=size)
    assert tally.wrong == []
    assert tally.counts["rooms"] == size
    assert tally.counts["placed"] > size
    assert tally.counts["conflicts"] > 0


def full_room() -> tuple[Space, tuple[Piece, ...], Arrangement]:
    """The first room of the fuzz in which five pieces stand and no door or use is blocked."""
    for seed in range(100):
        space, wanted = fuzz_room(seed)
        (arrangement,) = place([(space, wanted)])
        if len(arrangement.placed) >= 5 and space.doorways and not unreached(space, wanted, arrangement):
            return space, wanted, arrangement
    raise AssertionError("no such room")


def moved(piece: Placed, dx: int, dz: int) -> Placed:
    r = piece.footprint
    return replace(piece, footprint=Rect(r.x0 + dx, r.z0 + dz, r.x1 + dx, r.z1 + dz))


def test_the_judge_finds_what_is_moved_swapped_or_gone() -> None:
    space, wanted, arrangement = full_room()
    assert faults(space, wanted, arrangement) == []
    first, *rest = arrangement.placed
    for broken in (moved(first, -9000, 0), moved(first, 0, 9000), replace(first, rotation=(first.rotation + 90) % 360)):
        assert faults(space, wanted, replace(arrangement, placed=(broken, *rest)))
    assert faults(space, wanted, replace(arrangement, placed=tuple(rest)))
    for other in rest:
        dx, dz = other.footprint.x0 - first.footprint.x0, other.footprint.z0 - first.footprint.z0
        assert faults(space, wanted, replace(arrangement, placed=(moved(first, dx, dz), *rest)))


def test_the_judge_finds_a_blocked_door() -> None:
    space, wanted, arrangement = full_room()
    wall = moved(arrangement.placed[0], 0, 0)
    block = replace(wall, footprint=space.doorways[0].square)
    assert unreached(space, wanted, replace(arrangement, placed=(block, *arrangement.placed[1:])))
