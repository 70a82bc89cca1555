"""A room as it is wished, with least movement: every piece in its first way if all can stand so, and walkable.

The placement with least movement is exact where one can walk in it. Where not, walkable ones are sought in several ways, each
exact within what it keeps free; what of that nobody needs is given back, and the least movement of them all counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

from solver.geometry import Rect
from solver.placement.around import around_a_floor
from solver.placement.arrange import FIX_LIMITS, Draft, arrange, found_by, walkable_when_empty
from solver.placement.budget import Budget
from solver.placement.core import Core
from solver.placement.encode import WHOLE_SHAPES, empty_floor, encode
from solver.placement.kernel.layout import ABSENT
from solver.placement.outcome import Outcome
from solver.placement.usable import Found, Use, usable
from solver.wanted import Space, Wanted

LEAST_QPS = 6000
"""QPs of a repair's search for all pieces at once, wherever they can be used or not."""
WALK_QPS = 3000
"""The same where a way to every use side is asked for, and nothing else was found."""
QUICK_QPS = 500
"""The same while there are other shapes of floor to try: most of what is found at all is found within as many."""
FLOOR_WORK = 2500.0
"""What the searches with a piece of floor kept empty may cost a room, in QPs of a small room."""
REACHES_MM = (600, 200, 50, 2)
"""How far from where they were found usable pieces may be moved back to where they are wished, most first."""


def arrange_as_wished(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft:
    """Keeps every piece in its first way if all can stand so; else arranges them; all that are to be used can be reached.

    The first ways are the cheapest, so where their placement costs less than any other way would, it is the best. Where no
    walkable placement is found the best that is not is returned, `walkable` False; where none exists none is looked for.
    """
    core = Core(encode(space, wanted, "test"))
    decisions = core.first_ways()
    if decisions is None or not core.evaluate(decisions, LEAST_QPS, budget, False):
        return _not_as_usual(space, wanted, budget, None)
    least, preference = core.outcome(), core.preference(decisions)
    if core.walkable_near(least):
        return _dearer(space, wanted, budget, found_by(core, decisions, preference, True))
    nearest = _nearest(core, space, wanted, budget)
    together = found_by(core, decisions, preference, nearest is not None, nearest or least)
    if nearest is not None:
        return _dearer(space, wanted, budget, replace(together, best=False))
    return _not_as_usual(space, wanted, budget, together)


def _nearest(core: Core, space: Space, wanted: Sequence[Wanted], budget: Budget) -> Outcome | None:
    """Returns the least movement found of the pieces assembled in their first ways, and walkable; None where none was found.

    Kept free are persons' squares at the use sides, alone and with a piece of floor besides; nothing is sought but what is
    cheaper than all before it.
    """
    floor, spare = empty_floor(space, WHOLE_SHAPES), Budget(min(budget.left, FLOOR_WORK))
    modes = ("mixed", "stands") if any(len(piece.stands) > 1 for piece in wanted) else ("stands",)
    nearest: Outcome | None = None
    for mode in modes:
        freed = Core(encode(space, (floor, *wanted), mode))
        decisions = freed.first_ways()
        if decisions is None:
            continue
        for shape in range(-1, WHOLE_SHAPES):
            decisions[0] = ABSENT if shape < 0 else 8 * shape
            ceiling = nearest.cost if nearest else inf
            if freed.evaluate(decisions, QUICK_QPS, budget if shape < 0 else spare, True, ceiling):
                found = core.pulled_back(freed.bodies(1))
                nearest = found if found is not None and found.cost < ceiling else nearest
    return nearest


def _not_as_usual(space: Space, wanted: Sequence[Wanted], budget: Budget, least: Draft | None) -> Draft:
    """Arranges pieces for which no walkable placement was found in their first ways, of which `least` is the best to stand."""
    use, found = usable(space, wanted, budget)
    if use is Use.NEVER:
        return _out_of_reach(space, wanted, budget, least)
    if use is Use.SOMEHOW:
        return _dearer(space, wanted, budget, _near(space, found, budget) or least)
    for places in around_a_floor(space, wanted, budget):
        rescued = _near(space, places, budget)
        if rescued is not None:
            return rescued
    return _dearer(space, wanted, budget, least)


def _next_cost(wanted: Sequence[Wanted]) -> float:
    """Returns the least cost of another than the first way."""
    return min((a.cost for piece in wanted for a in piece.alternatives[1:] if a.cost > 0), default=inf)


def _dearer(space: Space, wanted: Sequence[Wanted], budget: Budget, together: Draft | None) -> Draft:
    """Tries other ways than the first ones, where that may be cheaper or leave all within reach."""
    least = _next_cost(wanted)
    if together is not None and together.walkable and together.cost <= least:
        return together
    choosy = any(len(piece.stands) > 1 and not piece.need_all for piece in wanted)
    if (least < inf or choosy or together is not None) and walkable_when_empty(space):
        draft = arrange(space, wanted, budget=budget, limits=FIX_LIMITS)
        if not draft.left_out:
            draft = _brought_back(draft, [replace(chosen.wanted, alternatives=(chosen.alternative,)) for chosen in draft.chosen])
        if not draft.left_out and (together is None or not together.walkable or draft.cost < together.cost):
            return draft
    return together if together is not None and together.walkable else _out_of_reach(space, wanted, budget, together)


def _out_of_reach(space: Space, wanted: Sequence[Wanted], budget: Budget, together: Draft | None) -> Draft:
    """Returns the best placement that nobody has to walk in."""
    if together is not None and together.cost <= _next_cost(wanted):
        return together
    draft = arrange(space, wanted, walk=False, budget=budget, limits=FIX_LIMITS)
    worse = bool(draft.left_out) or (together is not None and draft.cost >= together.cost)
    if together is not None and worse:
        return together
    return replace(draft, walkable=False)


def _near(space: Space, found: Sequence[Found], budget: Budget) -> Draft | None:
    """Returns the placement with least movement near where the pieces were found usable; None where none is walkable."""
    for reach in REACHES_MM:
        core = Core(encode(space, [one.near(reach, space.clear) for one in found], "stands"))
        decisions = core.first_ways()
        if decisions is not None and core.evaluate(decisions, WALK_QPS, budget, True):
            return _brought_back(found_by(core, decisions, core.preference(decisions), True), [one.free for one in found])
    return brought_from(space, [one.free for one in found], [one.footprint for one in found])


def _brought_back(draft: Draft, pieces: Sequence[Wanted]) -> Draft:
    """Returns a walkable arrangement of pieces in their only ways brought back towards their wishes, as far as all holds."""
    given = brought_from(draft.space, pieces, draft.footprints())
    return draft if given is None else replace(given, solves=draft.solves)


def brought_from(space: Space, pieces: Sequence[Wanted], places: Sequence[Rect | None]) -> Draft | None:
    """Brings pieces in their only ways from their places back towards their wishes; None if they cannot be used between there.

    Args:
        space: the room's.
        pieces: with one way each.
        places: of each piece; None for one that stands where another takes it.
    """
    core = Core(encode(space, pieces, "test"))
    decisions = core.first_ways()
    if decisions is None or not core.assemble(decisions):
        return None
    outcome = core.pulled_back(places)
    return None if outcome is None else replace(found_by(core, decisions, core.preference(decisions), True, outcome), best=False)
