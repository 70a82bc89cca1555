"""What stands in rows looks as if somebody had set it: chairs across a table, kitchens up to their walls."""

from __future__ import annotations

from itertools import chain

import pytest

from solver import Request, generate
from solver.scene import Furniture, Room

RUN = ("counter", "sink", "stove", "refrigerator", "dishwasher")


@pytest.fixture(scope="module")
def rooms() -> list[Room]:
    return list(chain.from_iterable(generate(Request(seed=seed, program="family")).scene.rooms for seed in range(7_810_000, 7_810_030)))


def beside(table: Furniture, chair: Furniture) -> tuple[float, float]:
    """Returns how far a chair is along a table from its middle, and how far across."""
    along, across = chair.x - table.x, chair.z - table.z
    return (along, across) if table.rotation % 180 == 0 else (across, along)


def test_each_chair_at_a_long_side_of_a_dining_table_has_one_across(rooms: list[Room]) -> None:
    seats = 0
    for room in (one for one in rooms if one.type == "dining_room"):
        table = next(piece for piece in room.furniture if piece.name == "dining_table")
        places = [beside(table, piece) for piece in room.furniture if piece.name == "dining_chair"]
        long = [(along, across) for along, across in places if abs(along) < table.width / 2]
        assert len(long) >= 2
        for along, across in long:
            seats += 1
            assert any(abs(along - other) < 0.002 and across * side < 0 for other, side in long), (room.id, places)
    assert seats > 100


def test_runs_of_kitchens_touch_their_walls_or_leave_room_to_clean(rooms: list[Room]) -> None:
    kitchens = [room for room in rooms if room.type == "kitchen"]
    slivers = 0
    for room in kitchens:
        run = [piece for piece in room.furniture if piece.name in RUN and piece.wall]
        ways = [(piece.x, room.width) if piece.rotation % 180 == 0 else (piece.z, room.depth) for piece in run]
        gaps = [
            [middle - piece.width / 2 - 0.05, whole - 0.05 - middle - piece.width / 2]
            for piece, (middle, whole) in zip(run, ways, strict=True)
        ]
        slivers += any(0.05 <= gap < 0.15 for gap in chain.from_iterable(gaps))
    assert len(kitchens) == 30
    assert slivers <= 2
