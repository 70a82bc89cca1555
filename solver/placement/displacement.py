"""A room's pieces where they are wished, with least movement: each with its first candidate if all can stand so, and walkable.

The placement with least movement is exact where it is walkable. Where not, walkable ones are sought in several ways, each exact within what
it keeps free; what of that nobody needs is given back, and the least movement of them all counts.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf

from solver.geometry import Rect
from solver.pieces import Piece, Space
from solver.placement.arrange import FIX_LIMITS, arrange, walkable_when_empty
from solver.placement.budget import Budget
from solver.placement.core import Core
from solver.placement.empty_floor import SHAPES_MM, empty_floor, places_round_a_floor
from solver.placement.encode import encode
from solver.placement.layout import ABSENT
from solver.placement.made_rooms import NOT_WALKABLE, SolvedRoom
from solver.placement.neighbourhood import Found, freed_search
from solver.placement.walkable import WalkablePlace, find_walkable

LEAST_QPS = 6000
"""QPs of a repair's search for all pieces at once, wherever they can be used or not."""
WALK_QPS = 3000
"""The same where a way to every use side is asked for, and nothing else was found."""
QUICK_QPS = 500
"""The same while there are other shapes of floor to try: most of what is found at all is found within as many."""
FLOOR_WORK = 2500.0
"""What the searches with a piece of floor kept empty may cost a room, in QPs of a small room."""
LAST_WORK = 10_000.0
"""What looking for all pieces at once in all their ways may cost, in QPs of a small room, where neither freeing some nor a proof found a
place for all: what is found at all is found early."""
REACHES_MM = (600, 200, 50, 2)
"""How far from where they were found walkable pieces may be moved back to where they are wished, most first."""


def move_least(space: Space, pieces: Sequence[Piece], budget: Budget) -> SolvedRoom:
    """Keeps every piece's first candidate if all can stand so; else arranges them; all that are to be used can be reached.

    The first candidates are the cheapest, so where their placement costs less than any other would, it is the best. Where no
    walkable placement is found the best that is not is returned, `walkable` False; where none exists none is looked for.
    """
    return _Question(space, pieces, budget).answer()


def can_be_used(space: Space, pieces: Sequence[Piece], budget: Budget) -> bool:
    """Tells whether a placement of all pieces was found in which all that are to be used can be reached.

    Less is tried than for the least movement.
    """
    return _Question(space, pieces, budget).is_answered()


def moved_back(space: Space, pieces: Sequence[Piece], places: Sequence[Rect]) -> SolvedRoom | None:
    """Moves pieces, one candidate each, back from their places to where they are wished; None if they cannot be used between there."""
    core = Core(encode(space, pieces, "test"))
    decisions = core.first_decisions()
    if decisions is None or not core.assemble(decisions):
        return None
    return None if core.pulled_back(places) is None else core.told(walk=True).with_(best=False)


@dataclass(frozen=True)
class _Question:
    space: Space
    pieces: Sequence[Piece]
    budget: Budget

    def answer(self) -> SolvedRoom:
        core = Core(encode(self.space, self.pieces, "test"))
        decisions = core.first_decisions()
        if decisions is None or not core.evaluate(decisions, LEAST_QPS, self.budget, False):
            return self._by_proof(None)
        least = core.told()
        if least.walkable:
            return self._or_cheaper(least)
        freed, nearest = self._by_freeing(), self._nearest_walkable(core)
        if freed is not None and (nearest is None or freed.cost < nearest.cost):
            return freed
        if nearest is not None:
            return self._or_cheaper(nearest)
        return self._by_proof(least)

    def is_answered(self) -> bool:
        """Tells whether a walkable placement was found with the first candidates, else by freeing, else near the first candidates."""
        core = Core(encode(self.space, self.pieces, "test"))
        decisions = core.first_decisions()
        stands = decisions is not None and core.evaluate(decisions, LEAST_QPS, self.budget, False)
        if stands and core.told().walkable:
            return True
        if next(freed_search(self.space, self.pieces, self.budget), None) is not None:
            return True
        return stands and self._nearest_walkable(core) is not None

    def _nearest_walkable(self, core: Core) -> SolvedRoom | None:
        """Returns the least movement found of the pieces assembled with their first candidates, and walkable; None if none.

        Kept free are persons' squares at the use sides, alone and with a piece of floor besides; nothing is sought but what is
        cheaper than all before it.
        """
        floor, spare = empty_floor(self.space), Budget(min(self.budget.left, FLOOR_WORK))
        modes = ("mixed", "stands") if any(len(piece.stands) > 1 for piece in self.pieces) else ("stands",)
        nearest, ceiling = None, inf
        for mode in modes:
            freed = Core(encode(self.space, (floor, *self.pieces), mode))
            decisions = freed.first_decisions()
            if decisions is None:
                continue
            for shape in range(-1, len(SHAPES_MM)):
                decisions[0] = ABSENT if shape < 0 else 8 * shape
                if freed.evaluate(decisions, QUICK_QPS, self.budget if shape < 0 else spare, True, ceiling):
                    cost = core.pulled_back(freed.bodies(1))
                    if cost is not None and cost < ceiling:
                        nearest, ceiling = core.told(walk=True).with_(best=False), cost
        return nearest

    def _by_proof(self, least: SolvedRoom | None) -> SolvedRoom:
        """Places pieces that were not found walkable with their first candidates, of which `least` is the best otherwise."""
        if least is None:
            freed = self._by_freeing()
            if freed is not None:
                return freed
        possible, found = find_walkable(self.space, self.pieces, self.budget)
        if possible is False:
            return self._not_walkable(least)
        if possible:
            return self._or_cheaper(self._near(found) or least)
        for places in places_round_a_floor(self.space, self.pieces, self.budget):
            near = self._near(places)
            if near is not None:
                return near
        return self._or_cheaper(least)

    @property
    def _next_cost(self) -> float:
        """The least cost of another than a first candidate."""
        return min((one.cost for piece in self.pieces for one in piece.candidates[1:] if one.cost > 0), default=inf)

    def _or_cheaper(self, together: SolvedRoom | None) -> SolvedRoom:
        """Tries other than the first candidates, where that may be cheaper or walkable."""
        next_cost = self._next_cost
        walkable = together is not None and together.walkable
        if together is not None and walkable and together.cost <= next_cost:
            return together
        choosy = any(len(piece.stands) > 1 and not piece.need_all for piece in self.pieces)
        if (next_cost < inf or choosy or together is not None) and walkable_when_empty(self.space):
            spare = self.budget if walkable else Budget(min(self.budget.left, LAST_WORK))
            other = arrange(self.space, self.pieces, budget=spare, limits=FIX_LIMITS)
            if not other.arrangement.left_out:
                own = {piece.label: piece for piece in self.pieces}
                other = self._moved_back(other, [replace(own[one.label], candidates=(one.chosen,)) for one in other.arrangement.placed])
                if together is None or not walkable or other.cost < together.cost:
                    return other
        return together if together is not None and walkable else self._not_walkable(together)

    def _not_walkable(self, together: SolvedRoom | None) -> SolvedRoom:
        """Returns the best placement that nobody has to walk in."""
        if together is not None and together.cost <= self._next_cost:
            return together
        other = arrange(self.space, self.pieces, walk=False, budget=self.budget, limits=FIX_LIMITS)
        if together is not None and (other.arrangement.left_out or other.cost >= together.cost):
            return together
        return replace(other.with_(notes=(NOT_WALKABLE,)), walkable=False)

    def _by_freeing(self) -> SolvedRoom | None:
        """Returns the least movement found by freeing a few pieces at a time, then all of them in the ways found; None if none."""
        best: SolvedRoom | None = None
        for found in freed_search(self.space, self.pieces, self.budget):
            best = self._nearer(found, best)
        return best

    def _nearer(self, found: Found, best: SolvedRoom | None) -> SolvedRoom | None:
        """Returns what was found moved back, alone and with all pieces free in the ways found; or what is better already."""
        one = [replace(piece, candidates=(way,)) for piece, way in zip(self.pieces, found.ways, strict=True)]
        best = _cheaper(moved_back(self.space, one, found.places), best)
        for mode in ("stands", "test"):
            core = Core(encode(self.space, one, mode))
            decisions = core.first_decisions()
            if best is None or decisions is None:
                continue
            ceiling = best.cost - core.preference(decisions)
            if core.evaluate(decisions, QUICK_QPS, self.budget, True, ceiling):
                best = _cheaper(moved_back(self.space, one, core.bodies()), best)
        return best

    def _near(self, found: Sequence[WalkablePlace]) -> SolvedRoom | None:
        """Returns the placement with least movement near where the pieces were found walkable; None where none is walkable."""
        free = [one.free for one in found]
        for reach in REACHES_MM:
            core = Core(encode(self.space, [one.near(reach, self.space.clear) for one in found], "stands"))
            decisions = core.first_decisions()
            if decisions is not None and core.evaluate(decisions, WALK_QPS, self.budget, True):
                return self._moved_back(core.told(walk=True), free)
        return moved_back(self.space, free, [one.footprint for one in found])

    def _moved_back(self, room: SolvedRoom, pieces: Sequence[Piece]) -> SolvedRoom:
        """Returns a walkable arrangement of pieces with one candidate each moved back towards their wishes, as far as all holds."""
        back = moved_back(self.space, pieces, [one.footprint for one in room.arrangement.placed])
        return room if back is None else back.with_(solves=room.arrangement.solves)


def _cheaper(one: SolvedRoom | None, other: SolvedRoom | None) -> SolvedRoom | None:
    return one if other is None or (one is not None and one.cost < other.cost) else other
