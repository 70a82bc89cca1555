"""Ways between doors that are wider than who walks, against what the same room costs without: both added up here."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from catalogs import load_catalogs
from solver import Request, generate
from solver.pieces import Piece
from solver.pipeline.generate import wanted_in
from solver.placement import SolvedRoom, arrange

DEAREST = 20.0
"""The most that a wider way may cost a room: docs/maths.md."""
ROUNDED = 1e-6
HOMES: list[dict[str, Any]] = [
    *({"seed": seed, "program": "studio", "robot_width": 0.9} for seed in range(4)),
    {"seed": 236688762202, "program": "studio", "outdoor": True, "robot_width": 0.9, "outline": "rectangle", "wall_thickness": 0.2},
    {"seed": 662917804233, "program": "studio", "outdoor": True, "robot_width": 0.8, "outline": "any", "wall_thickness": 0.12},
    {"seed": 814586637241, "program": "one_bed", "robot_width": 0.9, "outline": "T"},
]
"""Homes for people who are wide; the last are such in which a way once cost more."""


def whole_cost(solved: SolvedRoom, wanted: Sequence[Piece]) -> float:
    """What a room costs with all that it leaves out."""
    there = {one.label for one in solved.arrangement.placed}
    return solved.cost + sum(piece.skip_cost or 0.0 for piece in wanted if piece.label not in there)


def test_a_room_pays_no_more_for_wider_ways_than_they_are_worth() -> None:
    dearer, rooms = 0, 0
    for asked in HOMES:
        home = generate(Request(people=False, **asked)).scene
        for room in home.rooms:
            space, wanted = wanted_in(home, room, load_catalogs())
            usual, wide = arrange(space, wanted), arrange(space, wanted, wide=True)
            more = whole_cost(wide, wanted) - whole_cost(usual, wanted)
            assert more <= DEAREST + ROUNDED, (asked["seed"], room.id)
            dearer, rooms = dearer + (more > 1.0), rooms + 1
    assert rooms > 20
    assert dearer, "no room pays for its ways: this shows nothing"
