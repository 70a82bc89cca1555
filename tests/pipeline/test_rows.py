"""What stands in rows looks as if somebody had set it: chairs across a table."""

from __future__ import annotations

from itertools import chain

import pytest

from solver import Request, generate
from solver.scene import Furniture, Room


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
