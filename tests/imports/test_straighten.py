"""Which walls come to lie on one line."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import pytest

from solver.imports import steps_inside
from solver.imports.drawn import Spot
from solver.imports.steps_inside import ALL_CELLS
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
    one, other = straightened([outline[::-1] if turned else outline for outline in outlines])
    assert len({max(z for _, z in one.corners), min(z for _, z in other.corners)}) == lines


def test_faces_that_look_the_same_way_are_one_line_wherever_they_lie() -> None:
    one, other = straightened([rectangle(0, 0, 4000, 4000), rectangle(4100, 500, 8000, 4020)])
    assert max(z for _, z in one.corners) == max(z for _, z in other.corners)


def jagged(seed: int) -> list[Spot]:
    """A room whose first wall goes to and fro a little."""
    rng = random.Random(seed)
    wall = [(0.0, 0.0)]
    for _ in range(rng.randint(1, 5)):
        x, z = wall[-1]
        wall.append((x + rng.choice((20, 35, 100, 300, 2000, 3000)), z + rng.choice((0, 0, 20, 24, 25, 40, 48, -24))))
    return [*wall, (wall[-1][0], 3000.0), (0.0, 3000.0)]


WORST: list[Spot] = [(0, 0), (2000, 0), (2035, 40), (2055, 40), (2090, 60), (4090, 85), (4090, 3000), (0, 3000)]


def test_no_wall_is_moved_by_more_than_the_documents_say() -> None:
    """Points of one run lie within 50 mm, and its line within 25 mm of where it would lie by itself."""
    shifts = []
    for room in (*map(jagged, range(400)), WORST):
        end = max(x for x, _ in room)
        shifts.append(straightened([room, rectangle(end + 1000, -24, end + 45_000, 3000)])[0].shift)
    assert 60 < max(shifts) <= 75


def test_slanted_rooms_share_the_cells_they_are_cut_into(monkeypatch: pytest.MonkeyPatch) -> None:
    """Five hundred rooms of a plan took 290 s when each could be cut into as many cells as one alone."""
    cells: list[int] = []
    between = steps_inside.parts_between

    def noted(lines: Any, slants: Any, xs: np.ndarray, zs: np.ndarray) -> Any:
        cells.append(len(xs) * len(zs))
        return between(lines, slants, xs, zs)

    monkeypatch.setattr(steps_inside, "parts_between", noted)
    slanted = [(0.0, 0.0), (30_000.0, 4_000.0), (17_000.0, 30_000.0), (4_000.0, 21_000.0)]
    for count in (1, 25, 400):
        cells.clear()
        assert all(room.is_stepped for room in straightened([slanted] * count))
        assert len(cells) == count
        assert sum(cells) <= ALL_CELLS
