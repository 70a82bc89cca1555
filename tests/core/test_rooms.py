"""Rooms in the core's memory: what is given back, what stays, and that one room's leavings never show in another."""

from __future__ import annotations

import gc
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from solver.core import CoreFailed
from solver.core.host import _idle
from solver.placement import kernel, place
from solver.placement.arrange import arrange
from solver.placement.core import Core
from solver.placement.encode import encode
from solver.streams import Stream
from tests.placement.rooms import random_space, random_wanted

ROOMS = 24


def room(seed: int) -> str:
    stream = Stream(seed, "rooms in a row")
    space = random_space(stream)
    return repr(place([(space, random_wanted(space, stream, 3 + seed % 9))]))


def idle_sizes() -> list[list[int]]:
    gc.collect()
    return [sorted(instance.size for instance in instances) for instances in _idle.values()]


def test_rooms_in_a_row_take_the_same_memory() -> None:
    first = [room(seed) for seed in range(ROOMS)]
    sizes = idle_sizes()
    assert [room(seed) for seed in range(ROOMS)] == first
    assert idle_sizes() == sizes
    assert len(sizes[True]) <= 2


def test_rooms_at_once_are_what_they_are_alone() -> None:
    alone = [room(seed) for seed in range(ROOMS)]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(room, range(ROOMS))) == alone


def test_a_failure_in_a_room_harms_no_other() -> None:
    stream = Stream(1, "failing")
    space = random_space(stream)
    wanted = random_wanted(space, stream, 5)
    before = arrange(space, wanted).arrangement
    core = Core(encode(space, wanted))
    outside = np.full_like(core.blank(), 8 * 10_000_000)  # candidates whose rows would lie far behind the memory's end
    with pytest.raises(CoreFailed, match="total_preference ended in a trap"):
        core.preference(outside)
    with pytest.raises(CoreFailed, match="failed before"):
        kernel.walkable(core.engine)
    assert arrange(space, wanted).arrangement == before
