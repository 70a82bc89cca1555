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

from catalogs.schema import Piece, Run
from solver.furnish.ask import Scope, Size
from solver.geometry import FACING, ROTATION_AT_WALL
from solver.scene import WALLS
from solver.streams import Stream
from solver.wanted import Alternative

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
WHIM = 0.5
"""Most that a run costs by the seed's whim alone."""
FIRM = 20.0
"""Pull of a piece to its place in the run, m^-2."""
OFF_PLAN_COST = 3.0
"""What standing elsewhere than planned costs."""
NEXT_WALL = {"north": ("west", "east"), "south": ("west", "east"), "west": ("north", "south"), "east": ("north", "south")}
"""The walls at the low and the high end of a wall."""

CORNER_MM = 900 + 50
"""Least width of a piece in a corner: what stands round the corner covers 0.6 m of its front, a person takes half of 0.6 m."""

Item = tuple[str, str, float]
"""A piece of a run: its name, variant, and that variant's cost."""


@dataclass(frozen=True)
class Leg:
    """Items along one wall, the first at `start` from the wall's west or north end, mm, the others after it."""

    wall: str
    items: tuple[Item, ...]
    start: int


class _Walls:
    """Where bodies of a depth and height may stand along the walls; asked many times, looked up once."""

    def __init__(self, scope: Scope) -> None:
        self.scope = scope
        self._sizes: dict[str, Size] = {}
        self._free: dict[tuple[str, int, int], list[tuple[int, int]]] = {}

    def size(self, kind: str) -> Size:
        """Returns a kind's unrotated extents, mm."""
        if kind not in self._sizes:
            self._sizes[kind] = self.scope.size(kind)
        return self._sizes[kind]

    def holds(self, wall: str, kind: str, start: int) -> bool:
        """Tells whether a piece may stand at a wall from a coordinate on."""
        width, depth, height = self.size(kind)
        key = (wall, depth, height)
        if key not in self._free:
            self._free[key] = self.scope.walls.stretches(wall, depth, height, occupied=False)
        return any(a <= start and start + width <= b for a, b in self._free[key])


def planned_run(scope: Scope, run: Run, pieces: Mapping[str, Piece], stream: Stream) -> dict[str, Alternative]:
    """Returns where each piece of the best run drawn is meant to stand; empty where none fits.

    Args:
        scope: the room.
        run: the run of its type.
        pieces: the pieces that are wanted, by name, with the variants that suit the room.
        stream: the room's own.
    """
    best, least, walls = dict[str, Alternative](), math.inf, _Walls(scope)
    for _ in range(DRAWS):
        legs, cost = _drawn(walls, run, pieces, stream)
        places = _places(walls, legs)
        if places is None:
            continue
        cost += _triangle_cost(run.triangle, places)
        if cost < least:
            best, least = places, cost
    return best


def _drawn(walls: _Walls, run: Run, pieces: Mapping[str, Piece], stream: Stream) -> tuple[list[Leg], float]:
    """Draws a run: an order, which way round, what it holds in which variants, at a wall or round a corner; and what it costs."""
    order, mirrored = stream.pick(run.orders), stream.chance(0.5)
    cost = stream.uniform(0.0, WHIM)
    items: list[Item] = []
    for name in order[::-1] if mirrored else order:
        piece = pieces.get(name)
        if piece is None:
            continue
        if not piece.required and stream.chance(0.3):
            cost += MISSED_COST
            continue
        variant = stream.pick(piece.variants)
        items.append((name, variant.kind, variant.cost))
        cost += variant.cost
    wall, high = stream.pick(WALLS), stream.chance(0.5)
    corners = [i for i, (name, kind, _) in enumerate(items[:-1]) if name in run.corners and walls.size(kind)[0] >= CORNER_MM]
    at = stream.pick(corners) + 1 if corners and stream.chance(0.7) else len(items)
    return _legs(walls, wall, high, (items[:at], items[at:])), cost


def _legs(walls: _Walls, wall: str, high: bool, halves: tuple[list[Item], list[Item]]) -> list[Leg]:
    """Lays the first half along a wall into its low or high corner, the second half from there along the next wall.

    The first half's last item is the one in the corner.
    """
    clear, gap = walls.scope.space.clear, walls.scope.space.gap_mm
    first, second = halves
    low, end = clear.along(wall)
    length = sum(walls.size(kind)[0] for _, kind, _ in first)
    legs = [Leg(wall, tuple(first), end - gap - length) if high else Leg(wall, tuple(reversed(first)), low + gap)]
    if second:
        turn = NEXT_WALL[wall][high]
        beyond = gap + walls.size(first[-1][1])[1]
        low, end = clear.along(turn)
        if wall in ("north", "west"):
            legs.append(Leg(turn, tuple(second), low + beyond))
        else:
            length = sum(walls.size(kind)[0] for _, kind, _ in second)
            legs.append(Leg(turn, tuple(reversed(second)), end - beyond - length))
    return legs


def _places(walls: _Walls, legs: Sequence[Leg]) -> dict[str, Alternative] | None:
    """Returns the places of a run's pieces; None where one of them is in the way of an opening or does not fit."""
    found: dict[str, Alternative] = {}
    for leg in legs:
        at = leg.start
        for name, kind, cost in leg.items:
            size = walls.size(kind)
            if not walls.holds(leg.wall, kind, at):
                return None
            found[name] = replace(_at(walls.scope, leg.wall, kind, at + size[0] // 2), cost=cost)
            at += size[0]
    return found


def _at(scope: Scope, wall: str, kind: str, centre: int) -> Alternative:
    size, clear, gap = scope.size(kind), scope.space.clear, scope.space.gap_mm
    across = gap + size[1] // 2
    anchor = {
        "north": (centre, clear.z0 + across),
        "south": (centre, clear.z1 - across),
        "west": (clear.x0 + across, centre),
        "east": (clear.x1 - across, centre),
    }[wall]
    return Alternative(kind, size, ROTATION_AT_WALL[wall], wall, anchor, (FIRM, FIRM))


def _triangle_cost(names: Sequence[str], places: Mapping[str, Alternative]) -> float:
    """Returns what a run costs by its working triangle, measured between the middles of the fronts."""
    fronts = [_front(places[name]) for name in names if name in places]
    legs = [math.dist(one, two) / 1000 for one, two in combinations(fronts, 2)]
    beyond = sum(max(LEG[0] - leg, leg - LEG[1], 0.0) for leg in legs)
    around = max(PERIMETER[0] - sum(legs), sum(legs) - PERIMETER[1], 0.0)
    return LEG_COST * beyond + PERIMETER_COST * around


def _front(place: Alternative) -> tuple[float, float]:
    dx, dz = FACING[place.rotation]
    return place.anchor_mm[0] + dx * place.size_mm[1] / 2, place.anchor_mm[1] + dz * place.size_mm[1] / 2
