"""The ways of a room against the tests' own flood of it: the same verdict on random rooms."""

from __future__ import annotations

import pytest

from solver.furnish import space_of
from solver.geometry import Rect
from solver.scene import Opening, Room
from solver.streams import Stream
from solver.wanted import Space
from solver.ways import Goal, Ways
from tests.oracles.walk import missed

WALLS = ("north", "south", "west", "east")


def cluttered(seed: int) -> tuple[Space, list[Rect], list[Goal], Rect]:
    """A room with two doors, boxes on a raster of 10 cm so that many gaps are just as wide as who walks, and one box more."""
    stream = Stream(seed, "cluttered")
    width, depth = 2.4 + stream.below(20) / 10, 2.4 + stream.below(20) / 10
    doors = tuple(
        Opening(f"door_{k}", "door", WALLS[stream.below(4)], 0.7 + stream.below(10) / 10, 0.8, connects_to=f"room_{k}") for k in (1, 2)
    )
    outline = None
    if stream.chance(0.3):
        outline = ((0.0, 0.0), (width, 0.0), (width, depth), (1.0, depth), (1.0, depth - 1.0), (0.0, depth - 1.0))
    room = Room("room_0", width=round(width, 1), depth=round(depth, 1), openings=doors, outline=outline)
    space = space_of(room, 0.1)
    boxes = [_box(space.clear, stream) for _ in range(2 + stream.below(5))]
    goals = [Goal(box, tuple(WALLS[: 1 + stream.below(4)]), stream.chance(0.3)) for box in boxes[:3]]
    return space, boxes, goals, _box(space.clear, stream)


def _box(clear: Rect, stream: Stream) -> Rect:
    wide, deep = 100 * (2 + stream.below(7)), 100 * (2 + stream.below(7))
    x, z = clear.x0 + 100 * stream.below(clear.width // 100), clear.z0 + 100 * stream.below(clear.depth // 100)
    return Rect(x, z, min(x + wide, clear.x1), min(z + deep, clear.z1))


@pytest.mark.parametrize("start", range(0, 600, 60))
def test_they_agree(start: int) -> None:
    verdicts = []
    for seed in range(start, start + 60):
        space, boxes, goals, more = cluttered(seed)
        uses = [(str(k), goal.rect, goal.sides, goal.need_all) for k, goal in enumerate(goals)]
        also = Goal(more, WALLS)
        found = Ways(space, boxes, goals).open([more], [also])
        told = missed(space, [*boxes, more], [*uses, ("more", more, WALLS, False)])
        assert found == (not told), (seed, told)
        verdicts.append(found)
    assert len(set(verdicts)) == 2


def test_a_gap_just_as_wide_lets_through_and_a_millimetre_less_does_not() -> None:
    room = Room("room_0", width=3.0, depth=4.0, openings=(Opening("door", "door", "north", 1.5, 0.9, connects_to="EXTERIOR"),))
    space = space_of(room, 0.1)
    far = Goal(Rect(1200, 3500, 1800, 3950), ("north",))
    for gap, passes in ((600, True), (599, False)):
        barrier = [Rect(50, 1500, 2950 - gap, 2000), far.rect]
        assert Ways(space, barrier, [far]).open() is passes


def test_a_room_narrower_than_who_walks_is_closed() -> None:
    room = Room("room_0", width=0.6, depth=4.0, openings=(Opening("door", "door", "north", 0.3, 0.5, connects_to="EXTERIOR"),))
    assert not Ways(space_of(room, 0.1), [], []).open()
