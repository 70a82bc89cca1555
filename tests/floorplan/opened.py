"""Houses as their openings come to be cut: plain ones of every size and outline, planned ones, thick walls, standards of access."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from random import Random
from typing import Any, NamedTuple
from unittest.mock import patch

from catalogs import load_catalogs
from solver import Request
from solver.floorplan import draw
from solver.floorplan.openings import OpenedHouse, open_walls
from solver.floorplan.tiling import Joint

KNOWN = load_catalogs()
DRAW = sys.modules["solver.floorplan.draw"]
L = ((0, 0), (14, 0), (14, 6.2), (8.05, 6.2), (8.05, 12), (0, 12))


class OpenedQuestion(NamedTuple):
    """What `open_walls` is asked, and the walls that any two rooms share."""

    house: OpenedHouse
    tree: Sequence[tuple[Joint, int]]
    entrance: tuple[int, str]
    shared: Sequence[Joint]


def opened_question(number: int) -> OpenedQuestion:
    """Returns a house, of as many sorts as there are."""
    rng = Random(f"walls to open {number}")
    inner = rng.choice((None, None, 0.05, 0.2, 0.3))
    asked: dict[str, Any] = {"seed": number, "wall_thickness": inner, "outer_wall_thickness": rng.choice((None, 0.4))}
    if rng.random() < 0.4:
        asked["program"] = rng.choice(("studio", "one_bed", "family", "large"))
        asked["access"] = rng.choice(("none", *sorted(KNOWN.access)))
    else:
        asked["outdoor"], asked["use_spine"] = rng.random() < 0.3, rng.random() < 0.5
        asked["min_room_size"] = least = rng.choice((1.2, 1.6, 2.0, 3.0))
        asked["max_depth"] = rng.randint(3, 7)
        if rng.random() < 0.2:
            asked["outline"] = L
        else:
            asked["width"], asked["depth"] = (round(rng.uniform(2 * least + 2, 22.0), 2) for _ in range(2))
    with patch.object(DRAW, "open_walls", wraps=open_walls) as called:
        plan = draw(Request(**asked), KNOWN.for_access(asked.get("access", "none")))
    house, tree, entrance = called.call_args.args
    if rng.random() < 0.3:  # a door in every wall that takes one, so that they are in each other's way
        tree = [(joint, rng.choice((joint.a, joint.b))) for joint in plan.drawing.shared]
    return OpenedQuestion(house, tree, entrance, plan.drawing.shared)
