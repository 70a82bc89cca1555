"""A run of pieces along one wall, round a corner or at two opposite walls, planned as a whole: counter, sink, stove, refrigerator.

Comes in: a room and the run of its type. Goes out: where each piece of the run is meant to stand. Pieces that are put one by one
end at each other's wrong side; so whole runs are drawn by seed, and the best of those that fit is taken: nearest to a working
triangle, with worktop where it is wanted, and with what is wanted in it. Placement has the last word: a planned place is the cheapest
way to stand, not the only one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from operator import itemgetter

from catalogs.entries import Leaving, Run
from solver.geometry import FACING, OPPOSITE, Rect, strip, to_mm, turned, walls_beside
from solver.pieces import Candidate
from solver.relations.subject import Kind, Scope, Subject
from solver.scene import WALLS
from solver.streams import Stream
from tests.furnish.reference.drawn import CountedPiece
from tests.furnish.reference.effects import effect_of
from tests.furnish.reference.occupancy import TakenWalls
from tests.furnish.reference.own_places import at_wall

DRAWS = 5000
"""Runs drawn for a room; the best of those that fit is taken (measured: more find hardly better ones)."""
LEG = (1.2, 2.7)
"""Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter
than 4 feet or longer than 9 feet)."""
PERIMETER = (4.0, 7.9)
"""Least and greatest sum of its legs, m (the same guideline: at most 26 feet; 4 m is what three shortest legs come to)."""
BROKEN_COST, LEG_COST, PERIMETER_COST = 8.0, 8.0, 8.0
"""What a triangle costs that is not within these, and what a metre beyond them."""
MISSED_COST = 2.0
"""What a run without a piece that it could hold costs."""
CORNER_CHANCE, OPPOSITE_CHANCE = 0.6, 0.5
"""How often a run goes round a corner it could, and how often another one goes on at the opposite wall."""
LANDING_COST, END_COST = 10.0, 6.0
"""What a side without worktop costs where it is wanted, and what belongs at an end within the worktop."""
WORKTOP, WORKTOP_COST = 4.0, 4.0
"""Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs."""
BEFORE_MM, ASIDE_MM = 700, 600
"""Floor before a run, where a cook works, and beside its ends, that is not left to others."""
PREFERENCE = 1.6
"""Most that a run costs by the seed alone."""
FIRM = 20.0
"""Pull of a piece to its place in the run, m^-2."""
OFF_PLAN_COST = 8.0
"""What standing elsewhere than planned costs."""
AISLE_MM = 1067
"""Least floor between two opposite rows (guideline 6: work aisle of 42 inches for one cook)."""

Item = tuple[str, Kind, float]
"""A piece of a run: its name, kind, and what that variant costs."""


@dataclass(frozen=True)
class Leg:
    """Items along one wall, the first at `start` from the wall's west or north end, mm, the others after it."""

    wall: str
    items: tuple[Item, ...]
    start: int


@dataclass(frozen=True)
class Drawn:
    """A run as it is drawn: its items, how they are laid, and where in a wall's clear stretches its legs begin."""

    items: tuple[Item, ...]
    form: str
    wall: str
    high: tuple[bool, bool]
    stretch: tuple[float, float]
    first: int
    cost: float


class _Planner:
    """Plans the run of one room; what is asked many times is looked up once."""

    def __init__(self, scope: Scope, walls: TakenWalls, run: Run, pieces: Mapping[str, CountedPiece]) -> None:
        self.scope, self.run, self.pieces = scope, run, pieces
        self._walls = walls
        self._free: dict[tuple[str, str], list[tuple[int, int]]] = {}
        names = {name for order in run.orders for name in order if name in pieces}
        self._costs = {name: self._asked(pieces[name]) for name in names}

    def _asked(self, piece: CountedPiece) -> list[Callable[[Candidate], float]]:
        """Returns what the rules of a piece make places cost by the room alone."""
        subject = Subject(self.scope, piece.variants, piece.spec.rules, {}, {})
        effects = (effect_of(subject, rule) for rule in piece.spec.rules)
        return [effect.cost_of for effect in effects if effect.cost_of]

    def free(self, wall: str, kind: Kind) -> list[tuple[int, int]]:
        """Returns the clear stretches of a wall for a kind, less what its fronts would not open in."""
        _, depth, height = kind.size
        key = (wall, kind.name)
        if key not in self._free:
            low, high = (self._walls.opened(kind.name) or self.scope.clear).along(wall)
            stretches = self._walls.stretches(wall, depth, height, occupied=False)
            self._free[key] = [(max(start, low), min(stop, high)) for start, stop in stretches]
        return self._free[key]

    def drawn(self, stream: Stream) -> Drawn:
        """Draws a run: an order, which way round, what it holds in which variants, and how it is laid."""
        order, mirrored = stream.pick(self.run.orders), stream.chance(0.5)
        cost = stream.uniform(0.0, PREFERENCE)
        items: list[Item] = []
        for name in order[::-1] if mirrored else order:
            piece = self.pieces.get(name)
            if piece is None:
                continue
            if not piece.spec.required and stream.chance(0.3):
                cost += MISSED_COST
                continue
            kind, more = stream.pick(piece.variants)
            items.append((name, kind, more))
            cost += more
        wall, high = stream.pick(WALLS), (stream.chance(0.5), stream.chance(0.5))
        stretch = (stream.unit(), stream.unit())
        round_, across, cut = stream.chance(CORNER_CHANCE), stream.chance(OPPOSITE_CHANCE), stream.unit()
        shallow = [(i, one) for i, one in enumerate(items[:-1]) if items[i + 1][1].size[1] <= one[1].size[1]]
        turning = [(i, item) for i, one in shallow for item in self.in_corner(one, wall, high[0])]
        form, first = "straight", len(items)
        if round_ and turning:
            at, item = turning[int(cut * len(turning))]
            cost += item[2] - items[at][2]
            form, first, items[at] = "corner", at + 1, item
        elif across and len(items) > 1:
            form, first = "opposite", 1 + int(cut * (len(items) - 1))
        return Drawn(tuple(items), form, wall, high, stretch, first, cost)

    def in_corner(self, item: Item, wall: str, high: bool) -> list[Item]:
        """Returns an item as it stands in the corner at the high or low end of a wall, in the variant as wide; or nothing."""
        name, kind, _ = item
        if name not in self.run.worktop:
            return []
        hidden = "left" if (wall in ("south", "west")) == high else "right"
        made = [(name, one, cost) for side, one, cost in self.pieces[name].corners if side == hidden and one.size[0] == kind.size[0]]
        return made[:1]

    def legs(self, drawn: Drawn) -> list[Leg]:
        """Lays the first part along a wall, the second from its corner along the next wall, or at the opposite one."""
        first, second = drawn.items[: drawn.first], drawn.items[drawn.first :]
        wall, high = drawn.wall, drawn.high[0]
        low_first = first if high else first[::-1]
        if drawn.form != "corner":
            legs = [self._in_stretch(wall, low_first, drawn.stretch[0], high)]
            if second:
                at = drawn.high[1]
                legs.append(self._in_stretch(OPPOSITE[wall], second if at else second[::-1], drawn.stretch[1], at))
            return legs
        turn, low = walls_beside(wall)[high], wall in ("north", "west")
        beyond = self.scope.gap_mm + first[-1][1].size[1]
        return [self._leg(wall, low_first, self.scope.gap_mm, high), self._leg(turn, second if low else second[::-1], beyond, not low)]

    def _leg(self, wall: str, items: tuple[Item, ...], beyond: int, high: bool) -> Leg:
        """Lays items from a wall's low end up, `beyond` mm from its low or high end."""
        low, end = self.scope.clear.along(wall)
        return Leg(wall, items, end - beyond - sum(kind.size[0] for _, kind, _ in items) if high else low + beyond)

    def _in_stretch(self, wall: str, items: tuple[Item, ...], share: float, high: bool) -> Leg:
        """Lays items at the low or high end of one of the stretches that hold the piece there."""
        free = self.free(wall, items[-1 if high else 0][1])
        if not free:
            return self._leg(wall, items, self.scope.gap_mm, high)
        (start, stop), (low, end) = free[int(share * len(free))], self.scope.clear.along(wall)
        return self._leg(wall, items, (end - stop if high else start - low) or self.scope.gap_mm, high)

    def has_aisle(self, legs: Sequence[Leg]) -> bool:
        """Tells whether a cook has room between two opposite rows."""
        clear = self.scope.clear
        across = clear.depth if legs[0].wall in ("north", "south") else clear.width
        return across - sum(self.scope.gap_mm + max(kind.size[1] for _, kind, _ in leg.items) for leg in legs) >= AISLE_MM

    def places(self, legs: Sequence[Leg]) -> dict[str, Candidate] | None:
        """Returns the places of a run's pieces; None where one of them is in the way of an opening or does not fit."""
        found: dict[str, Candidate] = {}
        for leg in legs:
            at = leg.start
            for name, kind, cost in leg.items:
                if not any(a <= at and at + kind.size[0] <= b for a, b in self.free(leg.wall, kind)):
                    return None
                place = at_wall(self.scope, kind, leg.wall, at + kind.size[0] // 2, cost)
                found[name] = replace(place, weights=(FIRM, FIRM))
                at += kind.size[0]
        return found

    def row_cost(self, drawn: Drawn) -> float:
        """Returns what a run costs by what stands beside what."""
        names, run, cost = [name for name, _, _ in drawn.items], self.run, 0.0
        for i, name in enumerate(names):
            within = 0
            for other in (i - 1, i + 1):
                there = 0 <= other < len(names)
                turns = there and max(i, other) == drawn.first
                if name in run.landing and not (there and not turns and names[other] in run.worktop):
                    cost += LANDING_COST
                if there and not (turns and drawn.form == "opposite") and names[other] not in run.ends:
                    within += 1
            if name in run.ends and within == 2:
                cost += END_COST
        if drawn.form == "opposite":
            cost += LANDING_COST * ((drawn.first == 1) + (len(names) - drawn.first == 1))
        return cost

    def worktop_cost(self, drawn: Drawn) -> float:
        """Returns what a run costs by the worktop it lacks; what is hidden round a corner is none."""
        length = sum(kind.size[0] for name, kind, _ in drawn.items if name in self.run.worktop)
        hidden = drawn.items[drawn.first][1].size[1] if drawn.form == "corner" else 0
        return WORKTOP_COST * max(WORKTOP - (length - hidden) / 1000.0, 0.0) if self.run.worktop else 0.0

    def left_to(self, wish: Leaving, legs: Sequence[Leg]) -> Candidate | None:
        """Returns the place nearest to the room's middle that a run leaves to a piece; None where there is none."""
        kind, clear = self.pieces[wish.to].variants[0][0], self.scope.clear
        taken = [zone.rect for zone in self._walls.space.zones if zone.above_mm < kind.size[2]]
        for leg in legs:
            length, depth = sum(one.size[0] for _, one, _ in leg.items), max(one.size[1] for _, one, _ in leg.items)
            along = (leg.start - ASIDE_MM, leg.start + length + ASIDE_MM)
            taken.append(strip(clear, leg.wall, along, self.scope.gap_mm + depth + BEFORE_MM))
        found: list[tuple[int, Candidate]] = []
        for rotation in (0, 90):
            width, depth = turned(kind.size[0], kind.size[1] + 2 * to_mm(wish.floor), rotation)
            xs = [(clear.x0 + clear.x1 - width) // 2, clear.x0, clear.x1 - width, *(x for one in taken for x in (one.x1, one.x0 - width))]
            zs = [(clear.z0 + clear.z1 - depth) // 2, clear.z0, clear.z1 - depth, *(z for one in taken for z in (one.z1, one.z0 - depth))]
            for x, z in product(xs, zs):
                rect = Rect(x, z, x + width, z + depth)
                if clear.contains(rect) and not any(rect.overlaps(one) for one in taken):
                    away = max(abs(mine - theirs) for mine, theirs in zip(rect.centre, clear.centre, strict=True))
                    found.append((away, Candidate(kind.name, kind.size, rotation, anchor_mm=rect.centre)))
        return min(found, key=itemgetter(0))[1] if found else None

    def room_cost(self, drawn: Drawn, places: Mapping[str, Candidate]) -> float:
        """Returns what a run costs by what the rules of its pieces ask of the room."""
        cost = 0.0
        for name, _, _ in drawn.items:
            for asked in self._costs[name]:
                cost += asked(places[name])
        return cost


def planned_run(scope: Scope, free: TakenWalls, run: Run, pieces: Mapping[str, CountedPiece], stream: Stream) -> dict[str, Candidate]:
    """Returns where each piece of the best run drawn is meant to stand; empty where none fits.

    Args:
        scope: the room.
        free: its walls.
        run: the run of its type.
        pieces: the pieces that are wanted, by name.
        stream: the room's own.
    """
    best, least, planner = dict[str, Candidate](), math.inf, _Planner(scope, free, run, pieces)
    for _ in range(DRAWS):
        drawn = planner.drawn(stream)
        if not drawn.items:
            continue
        cost = drawn.cost + planner.row_cost(drawn) + planner.worktop_cost(drawn)
        if cost >= least:
            continue
        legs = planner.legs(drawn)
        places = None if drawn.form == "opposite" and not planner.has_aisle(legs) else planner.places(legs)
        if places is None:
            continue
        cost += _triangle_cost(run.triangle, places)
        cost += planner.room_cost(drawn, places)
        left = [(wish, planner.left_to(wish, legs)) for wish in run.leaves if wish.to in pieces] if cost < least else []
        places |= {wish.to: place for wish, place in left if place is not None}
        cost += sum(wish.cost for wish, place in left if place is None)
        if cost < least:
            best, least = places, cost
    return best


def _triangle_cost(names: Sequence[str], places: Mapping[str, Candidate]) -> float:
    """Returns what a run costs by its working triangle, measured between the middles of the fronts."""
    fronts = [_front(places[name]) for name in names if name in places]
    legs = [math.dist(one, two) / 1000 for one, two in combinations(fronts, 2)]
    beyond = sum(max(LEG[0] - leg, leg - LEG[1], 0.0) for leg in legs)
    around = max(PERIMETER[0] - sum(legs), sum(legs) - PERIMETER[1], 0.0)
    cost = LEG_COST * beyond + PERIMETER_COST * around
    return BROKEN_COST + cost if cost > 0.0 else 0.0


def _front(place: Candidate) -> tuple[float, float]:
    dx, dz = FACING[place.rotation]
    return place.anchor_mm[0] + dx * place.size_mm[1] / 2, place.anchor_mm[1] + dz * place.size_mm[1] / 2
