"""The same rooms in the core as it is built, and in a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.core import CoreInstance, borrowed, taken
from solver.placement import Budget
from solver.placement.arrange import LIMITS, asked_of_room
from solver.placement.encode import lay_out
from solver.placement.layout import Engine, Floats, Ints
from solver.placement.made_rooms import answer_at
from solver.streams import Stream
from tests.core.native import Native, framed
from tests.placement.rooms import random_space, random_wanted
from tests.sweeps import seeds

SEEDS = seeds(range(120), 4)
HOLDING_ROW = 7
"""Numbers of `struct HoldingRow` of confirm.hpp."""


class Room(NamedTuple):
    """A room's request with what comes behind it, and what the core made of it: see native_steps.hpp."""

    sent: tuple[bytes, bytes]
    answer: bytes


@cache
def room(seed: int) -> Room:
    """A random room; every fifth need not be walkable."""
    stream, walk, wide = Stream(seed, "native"), seed % 5 > 0, seed % 7 == 0
    space = random_space(stream)
    _, request = lay_out(space, random_wanted(space, stream, 2 + seed % 11), ("stands", "mixed", "test")[seed % 3])
    core, asked = taken(roomy=True), asked_of_room(LIMITS, Budget(), walk=walk, wide=wide, tidy=True)
    address = int(core.call("make_room", core.write(request), core.write(asked)))
    told = answer_at(core, address, space.room)
    engine = Engine(core, number_at(core, address + told.size))
    final_at = int(core.call("final_problem", engine.desk))
    final = np.frombuffer(core.read(final_at, 8 * number_at(core, final_at)), np.int64)
    columns, rows = final[1:3].tolist()
    ends = np.cumsum([5, columns, columns, 2 * rows, rows])
    x, y = (final[start:end].view(np.float64) for start, end in (ends[1:3], ends[3:5]))
    holding_at = int(core.call("holding", engine.desk, core.write(y.tobytes())))
    holding = core.read(holding_at + 8, 8 * HOLDING_ROW * number_at(core, holding_at))
    answer = core.read(address, told.size), final, *joined_and_judged(final, x, y), holding
    return Room((request, asked), b"".join(part if isinstance(part, bytes) else part.tobytes() for part in answer))


def number_at(core: CoreInstance, address: int) -> int:
    """A whole number in the core's memory."""
    return int.from_bytes(core.read(address, 8), "little")


def joined_and_judged(problem: Ints, x: Floats, y: Floats) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """What the core says of a room's final problem as a house's, and of an answer to it, as bytes."""
    with borrowed() as core:
        problems = core.write(np.array([core.write(problem.tobytes())]).tobytes())
        house = int(core.call("join", problems, 1))
        size = int.from_bytes(core.read(house, 8), "little")
        said = int(core.call("judge", problems, 1, core.write(x.tobytes()), core.write(y.tobytes())))
        return np.frombuffer(core.read(house, size), np.uint8), np.frombuffer(core.read(said, 32), np.uint8)


def test_checked_and_as_built_agree_to_the_last_bit(native: Native) -> None:
    rooms = [room(seed) for seed in SEEDS]
    assert native.answers("make", (one.sent for one in rooms)) == b"".join(one.answer for one in rooms)
    assert len({one.answer for one in rooms}) > 0.9 * len(SEEDS)


def test_the_native_build_stops_at_a_bad_room(native: Native) -> None:
    assert native.run("make", framed(room(0).sent)[:200]).returncode < 0
