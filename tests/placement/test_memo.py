"""Wider ways between doors: what is recalled from the search without them is what a search of its own finds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from catalogs import load_catalogs
from solver import Request, generate
from solver.pieces import Piece, Space
from solver.pipeline.generate import wanted_in
from solver.placement.arrange import SolvedRoom, arrange
from solver.placement.budget import Budget
from solver.placement.core import Limits
from tests.furnish.wanting_rooms import wanting_room
from tests.sweeps import seeds

Asked = tuple[Space, Sequence[Piece]]

WIDER = (200, 100, 50)
"""By how much ways are asked wider than who walks, mm; one after the other."""
LIMITS = Limits(required=600, required_qps=500)
"""How much is tried for each."""


def rooms() -> list[Asked]:
    """Rooms of homes and random ones that want something, with two doors and more."""
    found, known = list[Asked](), load_catalogs()
    for seed in seeds(range(300, 420), 12):
        scene = generate(Request(seed=seed, program=("family", "large", None)[seed % 3])).scene
        found += [wanted_in(scene, room, known)[:2] for room in scene.rooms]
    found += [wanting_room(seed).pieces() for seed in seeds(range(400), 8)]
    return [(space, pieces) for space, pieces in found if pieces and len(space.doorways) > 1]


def told(room: SolvedRoom) -> tuple[object, ...]:
    """All that is said of a room, its places to the last bit."""
    places = [own.tobytes() for own in room.solution.positions]
    verdicts = room.solves, room.proven, room.best, room.walkable, room.left_out
    return room.decisions.tolist(), room.preference, room.solution.cost, places, verdicts


def test_wider_ways_are_those_of_a_search_from_nothing() -> None:
    wide = narrow = 0
    for space, pieces in rooms():
        budget, spent = Budget(), 0.0
        found = arrange(space, pieces, budget=budget, wide=True)
        for wider in (0, *WIDER):
            alone = Budget()
            asked = replace(space, ways_mm=space.robot_mm + wider) if wider else space
            answer = arrange(asked, pieces, budget=alone, limits=LIMITS if wider else Limits())
            spent += Budget().left - alone.left
            if wider and found.space.ways_mm == asked.ways_mm:
                assert told(found) == told(answer)
                wide += 1
                break
            if not wider and not found.space.ways_mm:
                assert told(found) == told(answer)
                narrow += 1
        if found.walkable:
            assert Budget().left - budget.left == spent
    assert wide > 60 and narrow > 0, (wide, narrow)
