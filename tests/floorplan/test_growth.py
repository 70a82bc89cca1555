"""A plan's work grows with its rooms, no faster: counted in calls, never timed."""

from __future__ import annotations

import sys
from typing import Any

import pytest

from catalogs import load_catalogs
from solver.floorplan import draw
from solver.request import Request


def calls_a_room(**fields: Any) -> tuple[int, float]:
    """The rooms of a house, and the calls of functions that each costs."""
    request, catalogs, count = Request(seed=7, max_depth=16, **fields), load_catalogs(), 0

    def counted(_: object, event: str, __: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(counted)
    try:
        plan = draw(request, catalogs)
    finally:
        sys.setprofile(None)
    return len(plan.rooms), count / len(plan.rooms)


@pytest.mark.parametrize(
    ("small", "large", "fields"),
    [
        ((30.0, 30.0), (65.0, 65.0), {"use_spine": False}),
        ((30.0, 9.0), (300.0, 9.0), {"outer_wall_thickness": 0.3}),
    ],
    ids=["no spine", "long, outer walls thicker"],
)
def test_a_room_costs_as_much_in_a_large_house_as_in_a_small_one(
    small: tuple[float, float], large: tuple[float, float], fields: dict[str, Any]
) -> None:
    sizes = small, small, large  # a process's first plan reads what later ones know
    _, (few, least), (many, most) = (calls_a_room(width=width, depth=depth, **fields) for width, depth in sizes)
    assert many > 4 * few
    assert most < 1.2 * least, (few, many, least, most)
