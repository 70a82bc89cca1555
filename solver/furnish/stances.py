"""How an asked piece may be turned and at which wall its back may be, and where in the room it then holds which relations."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeAlias

from catalogs.schema import Rule
from solver.furnish.ask import Ask, Size
from solver.furnish.relations.regions import REGIONS, Way, within_both
from solver.furnish.walls import Stretch
from solver.geometry import ROTATION_AT_WALL, Rect, turned
from solver.scene import WALLS

Stance: TypeAlias = Way
Kept: TypeAlias = tuple[Rect, float]
"""Where a footprint stays, and what it costs to miss the relations that do not hold there."""
AT_WALLS = ("against_wall", "in_row", "opposite")
PLACES_KEPT = 12
"""Most rectangles of one stance."""
TURNING = ("facing", "opposite", "around", "under", "in_row")


@dataclass(frozen=True)
class Asking:
    """One copy of a piece with its rules, those to the room apart from those to other pieces."""

    ask: Ask
    to_room: tuple[Rule, ...]
    to_pieces: tuple[Rule, ...]
    reach: Mapping[tuple[str, str], Rect]
    """Where the centre of another piece may be, by its label and the way it stands, mm."""
    dear: Collection[tuple[str, str]]
    """Ways of other pieces that miss a relation which others of their ways hold: too unlikely to seek places beside them."""

    @cached_property
    def kind(self) -> str:
        """Its kind in the catalogs."""
        return self.ask.piece.variants[0].kind

    @cached_property
    def size(self) -> Size:
        """Its unrotated extents, mm."""
        return self.ask.scope.size(self.kind)

    @cached_property
    def at_walls(self) -> bool:
        """Whether its kind hugs a wall."""
        return self.ask.scope.entry(self.kind).stands == "wall"

    @cached_property
    def stretches(self) -> Mapping[str, list[Stretch]]:
        """The clear stretches of each wall for it."""
        return {wall: self.ask.scope.walls.stretches(wall, self.size[1], self.size[2]) for wall in WALLS}

    @cached_property
    def places(self) -> Sequence[tuple[Stance, list[Kept]]]:
        """Its stances, each with the rectangles that hold relations to the room."""
        return [(stance, kept(self, stance)) for stance in stances(self)]


def variant(kind: str, rotation: int, wall: str | None) -> str:
    """Returns what a kind is called while it stands so: a tie holds for one way of the other piece only."""
    return f"{kind}@{rotation}{'w' if wall else ''}"


@lru_cache(maxsize=4096)
def stance_of(kind: str) -> tuple[str, int, bool]:
    """Splits what `variant` joined: the kind, the rotation, whether it stands at a wall."""
    base, _, stance = kind.rpartition("@")
    return base, int(stance.removesuffix("w")), stance.endswith("w")


def stances(asking: Asking) -> Iterator[Stance]:
    """Yields the ways a piece may be turned: with its back at each wall, and free in the room."""
    clear, gap = asking.ask.scope.space.clear, asking.ask.scope.space.gap_mm
    width, depth, _ = asking.size
    bands = {
        "north": Rect(clear.x0, clear.z0 + gap, clear.x1, clear.z0 + gap + depth),
        "south": Rect(clear.x0, clear.z1 - gap - depth, clear.x1, clear.z1 - gap),
        "west": Rect(clear.x0 + gap, clear.z0, clear.x0 + gap + depth, clear.z1),
        "east": Rect(clear.x1 - gap - depth, clear.z0, clear.x1 - gap, clear.z1),
    }
    if asking.at_walls or any(rule.type in AT_WALLS for rule in asking.ask.piece.rules):
        for wall in WALLS:
            yield Way(turned(width, depth, ROTATION_AT_WALL[wall]), ROTATION_AT_WALL[wall], wall, bands[wall])
    if not asking.at_walls:
        for rotation in _turns(asking):
            yield Way(turned(width, depth, rotation), rotation, None, clear)


def _turns(asking: Asking) -> tuple[int, ...]:
    """Returns the rotations that make a difference to a free piece."""
    use = asking.ask.scope.entry(asking.kind).use
    if any(rule.type in TURNING for rule in asking.ask.piece.rules) or (use and len(use.sides) < 4):
        return (0, 90, 180, 270)
    return (0,) if asking.size[0] == asking.size[1] else (0, 90)


def kept(asking: Asking, stance: Stance) -> list[Kept]:
    """Returns rectangles for a stance, each holding some of the relations to the room, cheapest first."""
    found = [(stance.reach, 0.0)] if within_both(stance.reach, stance.reach, stance.extent) else []
    for rule in asking.to_room:
        regions = REGIONS[rule.type](asking.ask.scope, rule, stance)
        held = [(both, cost) for rect, cost in found for region in regions if (both := within_both(rect, region, stance.extent))]
        without = missed(rule)
        found = best_places([*held, *((rect, cost + without) for rect, cost in found)])
    return found


def missed(rule: Rule) -> float:
    """Returns what doing without a rule costs: everything, where it is hard."""
    return math.inf if rule.required else rule.cost


def best_places(found: Sequence[Kept]) -> list[Kept]:
    """Sorts by cost and drops what lies within a rectangle that costs no more."""
    best: list[Kept] = []
    for rect, cost in sorted(found, key=_by_cost_then_size):
        if len(best) == PLACES_KEPT or cost == math.inf:
            break
        if not any(other.contains(rect) for other, _ in best):
            best.append((rect, cost))
    return best


def _by_cost_then_size(place: Kept) -> tuple[float, int]:
    (x0, z0, x1, z1), cost = place
    return cost, (x0 - x1) * (z1 - z0)
