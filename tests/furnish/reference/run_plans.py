"""A run of pieces along one wall or round a corner, planned as a whole: counter, sink, stove, refrigerator.

Comes in: a room and the run of its type. Goes out: where each piece of the run is meant to stand. Pieces that are put one by one
end at each other's wrong side; so whole runs are drawn by seed, and the best of those that fit is taken: nearest to a working
triangle, with what is wanted in it. Placement has the last word: a planned place is the cheapest way to stand, not the only one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from catalogs.schema import Run
from solver.geometry import FACING, walls_beside
from solver.pieces import Candidate
from solver.relations.subject import Kind, Scope
from solver.scene import WALLS
from solver.streams import Stream
from tests.furnish.reference.drawn import CountedPiece
from tests.furnish.reference.occupancy import TakenWalls
from tests.furnish.reference.own_places import at_wall

DRAWS = 300
"""Runs drawn for a room; the best of those that fit is taken (measured: more find no better triangles)."""
LEG = (1.2, 2.7)
"""Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter
than 4 feet or longer than 9 feet)."""
PERIMETER = (4.0, 7.9)
"""Least and greatest sum of its legs, m (the same guideline: at most 26 feet; 4 m is what three shortest legs come to)."""
LEG_COST, PERIMETER_COST = 8.0, 8.0
"""What a metre beyond these costs."""
MISSED_COST = 0.7
"""What a run without a piece that it could hold costs."""
PREFERENCE = 0.5
"""Most that a run costs by the seed alone."""
FIRM = 20.0
"""Pull of a piece to its place in the run, m^-2."""
OFF_PLAN_COST = 3.0
"""What standing elsewhere than planned costs."""

CORNER_MM = 900 + 50
"""Least width of a piece in a corner: what stands round the corner covers 0.6 m of its front, a person takes half of 0.6 m."""

Item = tuple[str, Kind, float]
"""A piece of a run: its name, kind, and what that variant costs."""


@dataclass(frozen=True)
class Leg:
    """Items along one wall, the first at `start` from the wall's west or north end, mm, the others after it."""

    wall: str
    items: tuple[Item, ...]
    start: int


class _Walls:
    """Where bodies of a depth and height may stand along the walls; asked many times, looked up once."""

    def __init__(self, scope: Scope, walls: TakenWalls) -> None:
        self.scope, self._walls = scope, walls
        self._free: dict[tuple[str, int, int], list[tuple[int, int]]] = {}

    def holds(self, wall: str, kind: Kind, start: int) -> bool:
        """Tells whether a piece may stand at a wall from a coordinate on."""
        width, depth, height = kind.size
        key = (wall, depth, height)
        if key not in self._free:
            self._free[key] = self._walls.stretches(wall, depth, height, occupied=False)
        return any(a <= start and start + width <= b for a, b in self._free[key])


def planned_run(scope: Scope, free: TakenWalls, run: Run, pieces: Mapping[str, CountedPiece], stream: Stream) -> dict[str, Candidate]:
    """Returns where each piece of the best run drawn is meant to stand; empty where none fits.

    Args:
        scope: the room.
        free: its walls.
        run: the run of its type.
        pieces: the pieces that are wanted, by name.
        stream: the room's own.
    """
    best, least, walls = dict[str, Candidate](), math.inf, _Walls(scope, free)
    for _ in range(DRAWS):
        legs, cost = _drawn(walls, run, pieces, stream)
        places = _places(walls, legs)
        if places is None:
            continue
        cost += _triangle_cost(run.triangle, places)
        if cost < least:
            best, least = places, cost
    return best


def _drawn(walls: _Walls, run: Run, pieces: Mapping[str, CountedPiece], stream: Stream) -> tuple[list[Leg], float]:
    """Draws a run: an order, which way round, what it holds in which variants, at a wall or round a corner; and what it costs."""
    order, mirrored = stream.pick(run.orders), stream.chance(0.5)
    cost = stream.uniform(0.0, PREFERENCE)
    items: list[Item] = []
    for name in order[::-1] if mirrored else order:
        piece = pieces.get(name)
        if piece is None:
            continue
        if not piece.spec.required and stream.chance(0.3):
            cost += MISSED_COST
            continue
        kind, more = stream.pick(piece.variants)
        items.append((name, kind, more))
        cost += more
    wall, high = stream.pick(WALLS), stream.chance(0.5)
    corners = [i for i, (name, kind, _) in enumerate(items[:-1]) if name in run.corners and kind.size[0] >= CORNER_MM]
    at = stream.pick(corners) + 1 if corners and stream.chance(0.7) else len(items)
    return _legs(walls, wall, high, (items[:at], items[at:])), cost


def _legs(walls: _Walls, wall: str, high: bool, halves: tuple[list[Item], list[Item]]) -> list[Leg]:
    """Lays the first half along a wall into its low or high corner, the second half from there along the next wall.

    The first half's last item is the one in the corner.
    """
    clear, gap = walls.scope.clear, walls.scope.gap_mm
    first, second = halves
    low, end = clear.along(wall)
    length = sum(kind.size[0] for _, kind, _ in first)
    legs = [Leg(wall, tuple(first), end - gap - length) if high else Leg(wall, tuple(reversed(first)), low + gap)]
    if second:
        turn = walls_beside(wall)[high]
        beyond = gap + first[-1][1].size[1]
        low, end = clear.along(turn)
        if wall in ("north", "west"):
            legs.append(Leg(turn, tuple(second), low + beyond))
        else:
            length = sum(kind.size[0] for _, kind, _ in second)
            legs.append(Leg(turn, tuple(reversed(second)), end - beyond - length))
    return legs


def _places(walls: _Walls, legs: Sequence[Leg]) -> dict[str, Candidate] | None:
    """Returns the places of a run's pieces; None where one of them is in the way of an opening or does not fit."""
    found: dict[str, Candidate] = {}
    for leg in legs:
        at = leg.start
        for name, kind, cost in leg.items:
            if not walls.holds(leg.wall, kind, at):
                return None
            place = at_wall(walls.scope, kind, leg.wall, at + kind.size[0] // 2, cost)
            found[name] = replace(place, weights=(FIRM, FIRM))
            at += kind.size[0]
    return found


def _triangle_cost(names: Sequence[str], places: Mapping[str, Candidate]) -> float:
    """Returns what a run costs by its working triangle, measured between the middles of the fronts."""
    fronts = [_front(places[name]) for name in names if name in places]
    legs = [math.dist(one, two) / 1000 for one, two in combinations(fronts, 2)]
    beyond = sum(max(LEG[0] - leg, leg - LEG[1], 0.0) for leg in legs)
    around = max(PERIMETER[0] - sum(legs), sum(legs) - PERIMETER[1], 0.0)
    return LEG_COST * beyond + PERIMETER_COST * around


def _front(place: Candidate) -> tuple[float, float]:
    dx, dz = FACING[place.rotation]
    return place.anchor_mm[0] + dx * place.size_mm[1] / 2, place.anchor_mm[1] + dz * place.size_mm[1] / 2
