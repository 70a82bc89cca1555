"""Wider ways between doors: what is recalled of another search is what a search of its own finds; those worth it are taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from catalogs import load_catalogs
from solver import Request, generate
from solver.pieces import Piece, Space
from solver.pipeline.generate import wanted_in
from solver.placement import Budget, OpenRoom, opened
from solver.placement.core import Limits
from solver.placement.layout import ABSENT
from tests.furnish.wanting_rooms import wanting_room
from tests.oracles.problem import found_in
from tests.sweeps import seeds

Asked = tuple[Space, Sequence[Piece]]

MARGINS = {200: (0.9, 10.0), 100: (0.8, 12.0), 50: (0.6, 20.0)}
"""By how much ways are asked wider than who walks, mm, one after the other: the share of what optional pieces are worth without that must
stand with them, and what the room may cost more."""
LIMITS = Limits(required=600, required_qps=500)
"""How much is tried for each."""


def rooms() -> list[Asked]:
    """Rooms of homes and random ones that want something, with two doors and more."""
    found, known = list[Asked](), load_catalogs()
    for seed in seeds(range(300, 420), 12):
        scene = generate(Request(seed=seed, program=("family", "large", None)[seed % 3])).scene
        found += [wanted_in(scene, room, known) for room in scene.rooms]
    found += [wanting_room(seed).pieces() for seed in seeds(range(400), 8)]
    return [(space, pieces) for space, pieces in found if pieces and len(space.doorways) > 1]


def told(room: OpenRoom) -> tuple[object, ...]:
    """All that is said of a room, its places to the last bit."""
    solution = found_in(room.engine)
    places = [own.tobytes() for own in solution.positions]
    made = room.solved.arrangement
    verdicts = made.solves, made.proven, made.best, room.solved.walkable, made.left_out
    return room.decisions.tolist(), room.preference, solution.cost, places, verdicts


def standing(room: OpenRoom) -> tuple[int, float, float]:
    """Counts the required pieces that stand; what the optional ones that do are worth; what the room costs with those left out."""
    required, worth, cost = 0, 0.0, room.solved.cost
    for piece, decision in zip(room.core.encoded.pieces, room.decisions.tolist(), strict=True):
        if decision == ABSENT:
            cost += piece.skip_cost
        elif not piece.is_floor:
            required += piece.required
            worth += 0.0 if piece.required else piece.skip_cost
    return required, worth, cost


def is_walked(room: OpenRoom) -> bool:
    """Tells whether somebody walks in a room: where not even the empty one lets them, nobody is asked to."""
    return room.core.encoded.walk == "stands"


def is_worth(wider: int, wide: OpenRoom, usual: OpenRoom) -> bool:
    """Tells whether wider ways are to be taken."""
    (required, worth, cost), (least, most, usually) = standing(wide), standing(usual)
    share, more = MARGINS[wider]
    may_be_other = wide.solved.arrangement.proven or not usual.solved.arrangement.proven
    return is_walked(wide) and may_be_other and required >= least and worth >= share * most and cost <= usually + more


def test_wider_ways_are_those_of_a_search_from_nothing() -> None:
    wide = narrow = spared = given_up = 0
    for space, pieces in rooms():
        spent = dict[int, float]()

        def alone(wider: int, space: Space = space, pieces: Sequence[Piece] = pieces, spent: dict[int, float] = spent) -> OpenRoom:
            budget, asked = Budget(), replace(space, ways_mm=space.robot_mm + wider) if wider else space
            answer = opened(asked, pieces, budget=budget, limits=LIMITS if wider else Limits())
            spent[wider] = Budget().left - budget.left
            return answer

        budget = Budget()
        found, usual = opened(space, pieces, budget=budget, wide=True), alone(0)
        taken = next((wider for wider in MARGINS if is_walked(usual) and is_worth(wider, alone(wider), usual)), 0)
        assert found.ways_mm == (space.robot_mm + taken if taken else 0)
        assert told(found) == told(alone(taken))
        wide, narrow = wide + (taken > 0), narrow + (taken == 0)
        work, unasked = Budget().left - budget.left, spent.pop(0)
        if is_walked(usual):
            every = sum(spent.values()) + unasked
            spared += taken == max(MARGINS) and work < every - 1
            given_up += taken < max(MARGINS) and work < every - 1
            assert work < every + 1e-6 and (taken < max(MARGINS) or spent[taken] < work + 1e-6)
    assert wide > 60 and narrow > 0 and spared > 20 and given_up > 0, (wide, narrow, spared, given_up)
