"""Crowds of chairs, more than one round of repair finds places for: repaired on as long as each round finds more."""

from __future__ import annotations

from functools import cache

import pytest

from solver import fix
from solver.answers import Fixed
from solver.scene import Opening
from solver.streams import Stream
from tests.pipeline.fix_rooms import body, room_of

DOOR = Opening("door", "door", "south", 1.0, 0.9, connects_to="EXTERIOR", main_entrance=True)
SEEDS = (1, 2, 3)


@cache
def repaired(seed: int) -> Fixed:
    """Repairs eighteen chairs thrown into a room of 3.5 x 3.5 m, in which some places for all of them let everyone pass."""
    stream = Stream(seed, "crowds")
    spots = [(0.3 + stream.below(2900) / 1000, 0.3 + stream.below(2900) / 1000) for _ in range(18)]
    chairs = (body(f"chair_{k}", x, z, (0.45, 0.5, 0.9)) for k, (x, z) in enumerate(spots))
    return fix(room_of(*chairs, width=3.5, depth=3.5, openings=(DOOR,)), repairs=False)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_crowd_is_repaired_as_far_as_repairing_it_again_would(seed: int) -> None:
    fixed = repaired(seed)
    assert fixed.moves
    assert fix(fixed.scene, repairs=False).moves == ()


@pytest.mark.parametrize("seed", SEEDS)
def test_each_conflict_of_a_crowd_is_about_a_piece_that_breaks_a_rule(seed: int) -> None:
    """Where they shut the door, nothing else is said of any."""
    fixed = repaired(seed)
    errors = [issue for issue in fixed.issues if issue.severity == "error"]
    wrong = {label for issue in errors for label in issue.ids}
    assert bool(errors) == bool(fixed.conflicts)
    assert all(wrong.intersection(conflict.ids) for conflict in fixed.conflicts) or any(not issue.ids for issue in errors)
