"""Rooms in the core's memory: what is given back, what stays, and that one room's leavings never show in another."""

from __future__ import annotations

import gc
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from solver.core import CoreFailed
from solver.core.host import _idle
from solver.geometry import Rect
from solver.pieces import Candidate, Doorway, Piece, Space, Stand, Zone
from solver.placement import Budget, kernel, place
from solver.placement.arrange import arrange
from solver.placement.core import Core
from solver.placement.encode import encode
from solver.placement.layout import COUNT, SHOWN_BYTES
from solver.placement.problem import Solution
from solver.streams import Stream
from tests.placement.rooms import random_space, random_wanted

ROOMS = 24


def core_of(seed: int) -> Core:
    """A room whose pieces stand at their first ways."""
    stream = Stream(seed, "rooms in the core")
    space = random_space(stream)
    core = Core(encode(space, random_wanted(space, stream, 2 + seed % 8)))
    decisions = core.first_decisions()
    assert decisions is not None
    core.evaluate(decisions, 400, Budget(), True)
    return core


def answers(core: Core, found: Solution | None) -> tuple[object, ...]:
    """What is asked of a room once its search is over, and has found a placement or none."""
    problem, numbers = core.problem(), range(len(core.encoded.pieces))
    low = [core.walkable_at(problem.low), core.walkable_at(problem.high)]
    settled = [(core.settle(found.positions, found, True, tidy), core.footprints(numbers)) for tidy in (False, True)] if found else []
    return problem, low, settled, [core.rotation(k) for k in numbers]


@pytest.mark.parametrize("seed", range(ROOMS))
def test_a_room_answers_the_same_without_its_search(seed: int) -> None:
    core = core_of(seed)
    found = core.solution()
    before = answers(core, found)
    core.release()
    assert answers(core, found) == before
    assert [len(array) for array in (core.engine.nodes.best, core.engine.tree.budget, core.engine.work.wide)] == [0, 0, 0]
    with pytest.raises(IndexError):
        core.evaluate(core.blank(), 1, Budget(), False)


def test_what_each_walk_writes_anew_is_not_copied() -> None:
    """The cells of a walk past a thousand corners are most of a room's work space."""
    door = Doorway("door_1", "south", Rect(0, 9100, 900, 10_000), "hall")
    corners = tuple(Zone(Rect(9000, 4 * k, 10_000, 4 * k + 2), -1, "outline") for k in range(1000))
    piece = Piece("box", True, (Candidate("box", (500, 500, 800), 0, None, (2000, 2000)),), stands=(Stand("front"),))
    core = Core(encode(Space("room", Rect(0, 0, 10_000, 10_000), corners, (door,)), [piece]))
    decisions = core.first_decisions()
    assert decisions is not None
    core.evaluate(decisions, 400, Budget(), True)
    found = core.solution()
    assert found is not None
    before, desk = answers(core, found), core.engine.desk
    kept, walked = core.engine.instance.view(desk + SHOWN_BYTES * COUNT, (2,), np.int32).tolist()
    core.release()
    assert answers(core, found) == before
    assert kept - desk < (walked - desk) / 20


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
    before = arrange(space, wanted).decisions.tolist()
    core = Core(encode(space, wanted))
    outside = np.full_like(core.blank(), 8 * 10_000_000)  # candidates whose rows would lie far behind the memory's end
    with pytest.raises(CoreFailed, match="total_preference ended in a trap"):
        core.preference(outside)
    with pytest.raises(CoreFailed, match="failed before"):
        kernel.walkable(core.engine)
    assert arrange(space, wanted).decisions.tolist() == before
