"""How walls end where they meet others: nothing hangs on the last digit of where one begins."""

from __future__ import annotations

import pytest

from solver.exports.wall_bands import WallRun
from solver.exports.wall_panels import WallPlan, panels_of

LAST_DIGIT = 1e-9
"""Of a length that was added up, m."""


@pytest.mark.parametrize("start", [0.05, -0.05], ids=["ends within the other's shift", "goes on beyond it"])
def test_a_wall_ends_alike_on_either_side_of_a_last_digit(start: float) -> None:
    """A wall along x ends at one along z that begins just where the first one's shift ends."""
    reached = set()
    for digit in (-LAST_DIGIT, 0.0, LAST_DIGIT):
        along = WallRun((0, "x", 0.0), 0.0, 4.0, "wall", 0.1, 0.05)
        across = WallRun((0, "z", 4.0), start + digit, 3.0, "wall", 0.2, 0.0)
        first = next(panel for panel in panels_of(WallPlan((along, across), (), {}, ())) if panel.axis == "x")
        reached.add(round(first.end, 6))
    assert len(reached) == 1
