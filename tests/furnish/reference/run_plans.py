"""A run of pieces along one wall, round a corner or at two opposite walls, planned as a whole: counter, sink, stove, refrigerator.

Comes in: a room and the run of its type. Goes out: where each piece of the run is meant to stand. Pieces that are put one by one
end at each other's wrong side; so whole runs are drawn by seed, the best of them is varied, and what is best of all is taken: nearest to
a working triangle, with worktop where it is wanted, and with what is wanted in it. Placement has the last word: a planned place is the
cheapest way to stand, not the only one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, product
from operator import itemgetter

from catalogs.entries import Leaving, Run
from solver.geometry import FACING, OPPOSITE, Rect, strip, to_mm, turned, walls_beside
from solver.pieces import Candidate
from solver.relations.subject import Kind, Scope
from solver.scene import WALLS
from solver.streams import Stream
from tests.furnish.reference.drawn import CountedPiece
from tests.furnish.reference.effects import effect_of
from tests.furnish.reference.occupancy import TakenWalls
from tests.furnish.reference.own_places import at_wall
from tests.furnish.reference.subject import Subject

SEARCHES, DRAWS, AT_RANDOM, CHANGES = 8, 100, 32, 4
"""How often the best run is searched for from the start, and in how many draws; how many of these are at random, and how many numbers of
the best one so far are drawn anew in each of the others."""
OF_PIECES = 10
"""Numbers that a run is read from before those of its pieces, two each."""
LEG = (1.2, 2.7)
"""Least and greatest leg of a working triangle, m (NKBA Kitchen Planning Guidelines, guideline 5: work triangle: no leg shorter
than 4 feet or longer than 9 feet)."""
PERIMETER = (4.0, 7.9)
"""Least and greatest sum of its legs, m (the same guideline: at most 26 feet; 4 m is what three shortest legs come to)."""
BROKEN_COST, LEG_COST, PERIMETER_COST = 8.0, 8.0, 8.0
"""What a triangle costs that is not within these, and what a metre beyond them."""
MISSED_COST, MISSED_CHANCE = 6.0, 0.3
"""What a run without a piece that it could hold costs, and how often one is drawn without it."""
CORNER_CHANCE, OPPOSITE_CHANCE = 0.6, 0.5
"""How often a run goes round a corner it could, and how often another one goes on at the opposite wall."""
LANDING_COST, ALONE_COST, END_COST = 10.0, 20.0, 6.0
"""What a side without worktop costs where it is wanted, what stands alone across, and what belongs at an end within the worktop."""
WORKTOP, WORKTOP_COST = 4.0, 4.0
"""Worktop that a cook wants, m (guideline 25: 158 inches of frontage), and what a metre less costs."""
SLIVER_COST, TOUCHING_MM, SLIVER_MM = 4.0, 50, 150
"""What a gap between an end of a run and the wall there costs, which neither is contact nor lets a hand in."""
BEFORE_MM, ASIDE_MM = 700, 600
"""Floor before a run, where a cook works, and beside its ends, that is not left to others."""
FIRM = 20.0
"""Pull of a piece to its place in the run, m^-2."""
OFF_PLAN_COST = 8.0
"""What standing elsewhere than planned costs."""
AISLE_MM = 1067
"""Least floor between two opposite rows (guideline 6: work aisle of 42 inches for one cook)."""

Item = tuple[str, Kind, float]
"""A piece of a run: its name, kind, and what that variant costs."""


class Read:
    """What random numbers of 64 bits stand for, one after the other."""

    def __init__(self, numbers: Sequence[int]) -> None:
        self.numbers = iter(numbers)

    def below(self, n: int) -> int:
        """Returns an integer in [0, n)."""
        return (next(self.numbers) * n) >> 64

    def unit(self) -> float:
        """Returns a float in [0, 1)."""
        return (next(self.numbers) >> 11) * 2.0**-53


@dataclass
class Leg:
    """Items along one wall, laid from `at` on towards its west or north end, or from there on; in the order in which they are laid."""

    wall: str
    high: bool
    at: int
    share: float | None
    """In which of the stretches for its first item the leg begins, as a share of them; None where it begins at `at`."""
    laid: list[tuple[Item, int]] = field(default_factory=list)
    """Items, and the west or north end of each, mm."""

    @property
    def over(self) -> tuple[int, int]:
        """The interval of the wall that is covered."""
        return min(low for _, low in self.laid), max(low + kind.size[0] for (_, kind, _), low in self.laid)

    @property
    def deepest(self) -> int:
        """The depth of its deepest item."""
        return max(kind.size[1] for (_, kind, _), _ in self.laid)


@dataclass
class Drawn:
    """A run as it is drawn: how it is laid, its legs, and what it costs by what it holds."""

    form: str
    legs: list[Leg]
    cost: float = 0.0

    @property
    def laid(self) -> list[tuple[Item, int, str]]:
        """Its items, where each begins, and its wall: those of the first leg, with what was laid first last, then those of the second."""
        first, *others = [[(item, low, leg.wall) for item, low in leg.laid] for leg in self.legs]
        return first[::-1] + [one for other in others for one in other]

    @property
    def first(self) -> int:
        """How many items stand along the first wall."""
        return len(self.legs[0].laid)


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

    def drawn(self, numbers: Sequence[int]) -> Drawn | None:
        """Returns the run that numbers stand for; None where something does not fit that has to.

        Each leg is laid from its corner, or an end of its wall, on; of what comes next one of the variants stands there that fit.
        """
        read = Read(numbers)
        order = self.run.orders[read.below(len(self.run.orders))]
        mirrored = read.unit() < 0.5
        names = [name for name in (order[::-1] if mirrored else order) if name in self.pieces]
        wall, high, other_high = WALLS[read.below(4)], read.unit() < 0.5, read.unit() < 0.5
        share, other_share = read.unit(), read.unit()
        turns, crosses, cut = read.unit() < CORNER_CHANCE, read.unit() < OPPOSITE_CHANCE, read.unit()
        hidden = "left" if (wall in ("south", "west")) == high else "right"
        corners = [k for k, name in enumerate(names[:-1]) if self.in_corner(name, hidden)]
        drawn = Drawn("straight", [self._leg(wall, high, self.scope.gap_mm, share)])
        first = len(names)
        if turns and corners:
            drawn.form, drawn.legs[0].share = "corner", None
            first = corners[int(cut * len(corners))] + 1
        elif crosses and len(names) > 1:
            drawn.form, first = "opposite", 1 + int(cut * (len(names) - 1))
            drawn.legs.append(self._leg(OPPOSITE[wall], other_high, self.scope.gap_mm, other_share))
        own = {name: (read.unit() < MISSED_CHANCE, next(read.numbers)) for name in names}
        if drawn.form != "corner":
            fit = [
                self._lay(drawn, leg, name, own[name])
                for leg, part in zip(drawn.legs, (names[:first], names[first:]), strict=False)
                for name in part[::-1]
            ]
            return drawn if all(fit) and all(leg.laid for leg in drawn.legs) else None
        corner = names[first - 1]
        if not self._lay(drawn, drawn.legs[0], corner, (False, own[corner][1]), self.in_corner(corner, hidden)) or not drawn.legs[0].laid:
            return None
        depth = drawn.legs[0].laid[0][0][1].size[1]
        drawn.legs.append(self._leg(walls_beside(wall)[high], wall not in ("north", "west"), self.scope.gap_mm + depth, None))
        fit = [self._lay(drawn, drawn.legs[0], name, own[name]) for name in names[: first - 1][::-1]]
        for name in names[first:]:
            deepest = None if drawn.legs[1].laid else depth
            fit.append(
                self._lay(
                    drawn, drawn.legs[1], name, own[name], [one for one in self.items(name) if deepest is None or one[1].size[1] <= deepest]
                )
            )
        return drawn if all(fit) and drawn.legs[1].laid else None

    def items(self, name: str) -> list[Item]:
        """Returns the variants of a piece."""
        return [(name, kind, cost) for kind, cost in self.pieces[name].variants]

    def in_corner(self, name: str, hidden: str) -> list[Item]:
        """Returns what stands for the variants of a piece in a corner where that hides one end: of each the first as wide."""
        if name not in self.run.worktop:
            return []
        made = [(name, one, cost) for side, one, cost in self.pieces[name].corners if side == hidden]
        standing = [[one for one in made if one[1].size[0] == kind.size[0]][:1] for _, kind, _ in self.items(name)]
        return [one for ones in standing for one in ones]

    def _leg(self, wall: str, high: bool, beyond: int, share: float | None) -> Leg:
        low, end = self.scope.clear.along(wall)
        return Leg(wall, high, end - beyond if high else low + beyond, share)

    def _lay(self, drawn: Drawn, leg: Leg, name: str, own: tuple[bool, int], items: Sequence[Item] | None = None) -> bool:
        """Lays what stands next in a leg; tells whether something fits there, or nothing has to."""
        missed, number = own
        required = self.pieces[name].spec.required
        fitting: list[tuple[Item, int]] = []
        for item in self.items(name) if items is None else items:
            low = self._next(leg, item[1])
            if any(a <= low and low + item[1].size[0] <= b for a, b in self.free(leg.wall, item[1])):
                fitting.append((item, low))
        if not fitting or (missed and not required):
            drawn.cost += MISSED_COST
            return not required
        item, low = fitting[Read([number]).below(len(fitting))]
        leg.laid.append((item, low))
        leg.at = low if leg.high else low + item[1].size[0]
        drawn.cost += item[2]
        return True

    def _next(self, leg: Leg, kind: Kind) -> int:
        """Returns the west or north end of a piece of a kind that stands next in a leg, mm."""
        at, free = leg.at, self.free(leg.wall, kind)
        if not leg.laid and leg.share is not None and free:
            start = free[int(leg.share * len(free))][leg.high]
            at = at if start == self.scope.clear.along(leg.wall)[leg.high] else start
        return at - kind.size[0] if leg.high else at

    def has_aisle(self, legs: Sequence[Leg]) -> bool:
        """Tells whether a cook has room between two opposite rows."""
        clear = self.scope.clear
        across = clear.depth if legs[0].wall in ("north", "south") else clear.width
        return across - sum(self.scope.gap_mm + leg.deepest for leg in legs) >= AISLE_MM

    def places(self, drawn: Drawn) -> dict[str, Candidate]:
        """Returns the places of a run's pieces."""
        found = {item: at_wall(self.scope, item[1], wall, low + item[1].size[0] // 2, item[2]) for item, low, wall in drawn.laid}
        return {name: replace(place, weights=(FIRM, FIRM)) for (name, _, _), place in found.items()}

    def row_cost(self, drawn: Drawn) -> float:
        """Returns what a run costs by what stands beside what."""
        names, run, cost = [name for (name, _, _), _, _ in drawn.laid], self.run, 0.0
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
            cost += ALONE_COST * ((drawn.first == 1) + (len(names) - drawn.first == 1))
        return cost

    def worktop_cost(self, drawn: Drawn) -> float:
        """Returns what a run costs by the worktop it lacks; what is hidden round a corner is none."""
        length = sum(kind.size[0] for (name, kind, _), _, _ in drawn.laid if name in self.run.worktop)
        hidden = drawn.laid[drawn.first][0][1].size[1] if drawn.form == "corner" else 0
        return WORKTOP_COST * max(WORKTOP - (length - hidden) / 1000.0, 0.0) if self.run.worktop else 0.0

    def sliver_cost(self, legs: Sequence[Leg]) -> float:
        """Returns what a run costs by gaps between its ends and the walls there."""
        ends = [(leg.over, self.scope.clear.along(leg.wall)) for leg in legs if leg.laid]
        gaps = (gap for over, whole in ends for gap in (over[0] - whole[0], whole[1] - over[1]))
        return SLIVER_COST * sum(TOUCHING_MM <= gap < SLIVER_MM for gap in gaps)

    def left_to(self, wish: Leaving, legs: Sequence[Leg]) -> Candidate | None:
        """Returns the place nearest to the room's middle that a run leaves to a piece; None where there is none."""
        kind, clear = self.pieces[wish.to].variants[0][0], self.scope.clear
        taken = [zone.rect for zone in self._walls.space.zones if zone.above_mm < kind.size[2]]
        for leg in legs:
            along = (leg.over[0] - ASIDE_MM, leg.over[1] + ASIDE_MM)
            taken.append(strip(clear, leg.wall, along, self.scope.gap_mm + leg.deepest + BEFORE_MM))
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

    def judged(self, numbers: Sequence[int], least: float) -> tuple[dict[str, Candidate], float]:
        """Returns the places of the run that numbers stand for and what it costs, infinite where it does not fit or costs no less."""
        drawn = self.drawn(numbers)
        if drawn is None or (drawn.form == "opposite" and not self.has_aisle(drawn.legs)):
            return {}, math.inf
        cost = drawn.cost + self.row_cost(drawn) + self.worktop_cost(drawn) + self.sliver_cost(drawn.legs)
        if cost >= least:
            return {}, math.inf
        places = self.places(drawn)
        cost += _triangle_cost(self.run.triangle, places)
        cost += self.room_cost(drawn, places)
        left = [(wish, self.left_to(wish, drawn.legs)) for wish in self.run.leaves if wish.to in self.pieces] if cost < least else []
        places |= {wish.to: place for wish, place in left if place is not None}
        return places, cost + sum(wish.cost for wish, place in left if place is None)

    def room_cost(self, drawn: Drawn, places: Mapping[str, Candidate]) -> float:
        """Returns what a run costs by what the rules of its pieces ask of the room."""
        cost = 0.0
        for (name, _, _), _, _ in drawn.laid:
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
    used = OF_PIECES + 2 * max(sum(name in pieces for name in order) for order in run.orders)
    for _ in range(SEARCHES):
        kept, found = list[int](), math.inf
        for draw in range(DRAWS):
            if draw < AT_RANDOM or not kept:
                numbers = [stream.bits() for _ in range(used)]
            else:
                numbers = list(kept)
                for _ in range(CHANGES):
                    changed = stream.below(used)
                    numbers[changed] = stream.bits()
            places, cost = planner.judged(numbers, found)
            if cost < found:
                kept, found = numbers, cost
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
