"""Which walls come to lie on one line."""

from __future__ import annotations

import pytest

from solver.imports.drawn import Spot
from solver.imports.straighten import straightened


def rectangle(x0: float, z0: float, x1: float, z1: float) -> list[Spot]:
    return [(x0, z0), (x1, z0), (x1, z1), (x0, z1)]


@pytest.mark.parametrize("turned", [False, True], ids=["clockwise", "the other way"])
@pytest.mark.parametrize(
    ("x0", "x1", "lines"),
    [(0, 4000, 1), (3000, 7000, 1), (4100, 8000, 2)],
    ids=["before each other", "in part", "beside each other"],
)
def test_faces_that_look_opposite_ways_are_one_line_only_where_they_lie_before_each_other(
    x0: float, x1: float, lines: int, turned: bool
) -> None:
    """Of two rooms that lie corner to corner, faces on either side of two lines may lie 2 cm apart by chance."""
    outlines = [rectangle(0, 0, 4000, 4000), rectangle(x0, 4020, x1, 8000)]
    one, other = straightened([outline[::-1] if turned else outline for outline in outlines], [0, 0])
    assert len({max(z for _, z in one.corners), min(z for _, z in other.corners)}) == lines


def test_faces_that_look_the_same_way_are_one_line_wherever_they_lie() -> None:
    one, other = straightened([rectangle(0, 0, 4000, 4000), rectangle(4100, 500, 8000, 4020)], [0, 0])
    assert max(z for _, z in one.corners) == max(z for _, z in other.corners)
