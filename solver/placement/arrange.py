"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces: best-first over prefixes. Optional pieces follow by importance, everything movable. The room stays walkable
throughout. Limits are counts; ties go to the earlier. The work is the kernel's; here is what to ask it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import inf

from solver.placement.around import around_a_floor
from solver.placement.budget import Budget
from solver.placement.core import Arranged, Core, Limits
from solver.placement.encode import LEAST_FLOOR_MM2, door_target, empty_floor, encode
from solver.placement.kernel.fill import COVERED, NO_WAY, SPENT
from solver.placement.kernel.layout import ABSENT, Ints
from solver.placement.outcome import Outcome
from solver.placement.problem import Problem
from solver.placement.usable import Found, Use, usable
from solver.wanted import EMPTY_FLOOR, Alternative, Space, Wanted

LIMITS = Limits()
FIX_LIMITS = Limits(required=600, required_qps=500)
"""A repair tries fewer ways: the first is nearly always the best, and someone is dragging."""
MARGIN_MM = 2
"""Rounding to millimetres moves each of two bodies by less than one."""
TOGETHER_QPS = {"least": 6000, "stands": 3000, "mixed": 6000, "test": 3000}
"""QPs of a repair's search for all pieces at once, by how the walk asks for use sides."""
CHEAPER_QPS = 1500
"""The same where one is found already."""
REACHES_MM = (600, 200, 50, 2)
"""How far from where they were found usable pieces may be moved back to where they are wished, most first."""
REASONS = {
    NO_WAY: "none of the ways to stand it leaves the room valid and walkable",
    COVERED: "the floor is covered as densely as wished without it",
    SPENT: "no place found for it within the search's limit",
}


@dataclass(frozen=True)
class Chosen:
    """A wanted piece with the alternative taken, the use sides that are free, and its absolute rotation."""

    wanted: Wanted
    alternative: Alternative
    sides: tuple[str, ...]
    rotation: int


@dataclass
class Draft:
    """A room's arrangement before it is settled on the lattice.

    `cost` counts terms and preferences; `proven` tells that the placement of the chosen ways is the optimum and
    that no required piece left out could stand beside those before it, `best` that no
    other choice of ways for the required pieces is cheaper; both within the widenings tried.
    """

    space: Space
    core: Core
    decisions: Ints
    problem: Problem
    outcome: Outcome
    chosen: tuple[Chosen, ...]
    cost: float
    left_out: list[tuple[Wanted, str]] = field(default_factory=list)
    solves: int = 0
    proven: bool = True
    best: bool = True
    walkable: bool = True


def arrange(space: Space, wanted: Sequence[Wanted], walk: bool = True, budget: Budget | None = None, limits: Limits = LIMITS) -> Draft:
    """Chooses a way to stand for every piece that fits.

    Args:
        space: where the room's furniture may stand.
        wanted: pieces in order of importance.
        walk: whether doors and use sides must be joined. Where even the empty room is not walkable, nobody asks.
        budget: the work it may cost.
        limits: how much each step may try.

    Returns:
        The best arrangement found within the limits, its pieces' choices made.
    """
    allowed = budget or Budget()
    pieces = sorted(wanted, key=lambda piece: not piece.required)
    walk = walk and walkable_when_empty(space)
    left_out: list[tuple[Wanted, str]] = []
    solves, sure = 0, True
    while True:
        core, arranged = _attempt(space, pieces, walk, limits, allowed)
        solves += arranged.solves
        if arranged.complete:
            draft = _draft(core, arranged, left_out, solves, walk)
            return replace(draft, proven=draft.proven and sure)
        if allowed.spent:
            return _cut_short(core, left_out, solves, walk)
        sure &= arranged.closed
        missing = pieces.pop(arranged.deepest)
        word = "no way to stand it is free" if arranged.closed else "no place was found for it"
        left_out.append((missing, f"{word} beside the pieces before it"))


def _attempt(space: Space, pieces: Sequence[Wanted], walk: bool, limits: Limits, budget: Budget) -> tuple[Core, Arranged]:
    """Arranges the pieces; where walking alone stands against the required ones, once more with empty floor asked for.

    That floor is one way to be walkable among others, so what is found with it is not proven best.
    """
    core = Core(encode(space, pieces, "stands" if walk else "none"))
    arranged = core.arrange(limits, budget, walk)
    if arranged.complete or arranged.closed or not walk or budget.spent:
        return core, arranged
    with_floor = Core(encode(space, (empty_floor(space), *pieces), "stands"))
    again = with_floor.arrange(limits, budget, walk)
    return (with_floor, replace(again, closed=False, proven=False)) if again.complete else (core, arranged)


def walkable_when_empty(space: Space) -> bool:
    """Tells whether a person can walk through all doors of the empty room."""
    if any(zone.cause == "outline" for zone in space.zones):
        core = Core(encode(space, ()))
        return core.evaluate(core.blank(), 10, Budget(), True)
    clear, half = space.clear, space.robot_mm - 1  # all free centres are one rectangle, in doubled millimetres
    x0, z0, x1, z1 = 2 * clear.x0 + half, 2 * clear.z0 + half, 2 * clear.x1 - half, 2 * clear.z1 - half
    if x1 <= x0 or z1 <= z0 or (x1 - x0) * (z1 - z0) < 4 * LEAST_FLOOR_MM2:
        return False
    targets = [door_target(space, door) for door in space.doorways]
    return all(a <= x1 and b <= z1 and c >= x0 and d >= z0 for a, b, c, d in targets)


def _draft(core: Core, arranged: Arranged, left_out: list[tuple[Wanted, str]], solves: int, walk: bool) -> Draft:
    absent = list(left_out)
    for k, piece in enumerate(core.encoded.wanted):
        if arranged.decisions[k] == ABSENT and not piece.label.startswith(EMPTY_FLOOR):
            absent.append((piece, REASONS[int(arranged.fates[k])]))
    if core.outcome().positions is None:  # the budget ended with the last piece: once more, for the placement alone
        core.evaluate(arranged.decisions, LIMITS.required_qps, Budget(), walk)
    found = _found(core, arranged.decisions, arranged.preference, walk)
    best = arranged.closed and not left_out
    return replace(found, left_out=absent, solves=solves, proven=arranged.proven, best=best)


def _found(core: Core, decisions: Ints, preference: float, walkable: bool) -> Draft:
    """Returns what the last search of a core found, and lets the core go of what it took."""
    outcome = core.outcome()
    draft = Draft(
        core.encoded.space,
        core,
        decisions,
        core.problem(),
        outcome,
        _chosen(core, decisions),
        outcome.cost + preference,
        solves=outcome.solves,
        proven=outcome.proven,
        walkable=walkable or core.walkable_near(outcome),
    )
    core.release()
    return draft


def with_margin(draft: Draft) -> Draft | None:
    """Searches a draft's placement once more for a person `MARGIN_MM` wider, so that the walk outlasts the snap; None if none."""
    wider = replace(draft.space, robot_mm=draft.space.robot_mm + MARGIN_MM)
    core = Core(encode(wider, draft.core.encoded.wanted, draft.core.encoded.walk))
    if not core.evaluate(draft.decisions, LIMITS.final_qps, Budget(), True):
        return None
    found = _found(core, draft.decisions, draft.cost - draft.outcome.cost, True)
    return replace(found, left_out=draft.left_out, solves=draft.solves, proven=False, best=False)


def _chosen(core: Core, decisions: Ints) -> tuple[Chosen, ...]:
    return tuple(
        Chosen(piece, *core.decided(k, int(decisions[k])), core.rotation(k))
        for k, piece in enumerate(core.encoded.wanted)
        if decisions[k] != ABSENT and not piece.label.startswith(EMPTY_FLOOR)
    )


def _cut_short(core: Core, left_out: list[tuple[Wanted, str]], solves: int, walk: bool) -> Draft:
    """Returns the deepest prefix of the required pieces, where the budget ended before all stood."""
    decisions = core.deepest_decisions()
    core.evaluate(decisions, LIMITS.required_qps, Budget(), walk)
    absent = [
        (piece, REASONS[SPENT])
        for k, piece in enumerate(core.encoded.wanted)
        if decisions[k] == ABSENT and not piece.label.startswith(EMPTY_FLOOR)
    ]
    found = _found(core, decisions, core.preference(decisions), walk)
    return replace(found, left_out=[*left_out, *absent], solves=solves, proven=False, best=False)


def arrange_as_wished(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft:
    """Keeps every piece in its first way if all can stand so; else arranges them; all that are to be used can be reached.

    The first ways are the cheapest, so where their placement costs less than any other way would, it is the best. Where no
    walkable placement is found the best that is not is returned, `walkable` False; where none exists none is looked for.
    """
    least = _all_at_once(space, wanted, budget, "least")
    together = least if least is None or least.walkable else _together(space, wanted, budget)
    if together is not None:
        return _dearer(space, wanted, budget, together)
    use, found = usable(space, wanted, budget)
    if use is Use.NEVER:
        return _out_of_reach(space, wanted, budget, least)
    if least is not None:
        least = _all_at_once(space, wanted, budget, "test") or least
    if use is Use.UNKNOWN and not (least is not None and least.walkable):
        rescued = _near_found(space, around_a_floor(space, wanted, budget), budget)
        if rescued is not None:
            return rescued
    best = _dearer(space, wanted, budget, least)
    return best if best.walkable else _near_found(space, found, budget) or best


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


def _near_found(space: Space, found: Sequence[Found], budget: Budget) -> Draft | None:
    """Returns the placement with least movement near where the pieces were found usable; None where none is walkable."""
    for reach in REACHES_MM if found else ():
        draft = _all_at_once(space, [one.near(reach, space.clear) for one in found], budget, "stands")
        if draft is not None:
            return draft
    return None


def _together(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft | None:
    """Searches a place for all pieces at once, each in its first way, with persons' squares at the use sides."""
    modes = ("stands", "mixed") if any(len(piece.stands) > 1 for piece in wanted) else ("stands",)
    best: Draft | None = None
    for mode in modes:
        best = _all_at_once(space, wanted, budget, mode, best.cost if best else inf) or best
    return best


def _all_at_once(space: Space, wanted: Sequence[Wanted], budget: Budget, mode: str, ceiling: float = inf) -> Draft | None:
    """Searches a place for all pieces at once, each in its first way, cheaper than the ceiling.

    `mode` is how the walk asks for use sides (`encode`), or "least": nobody has to walk, but whether one could is told.
    """
    walk = mode != "least"
    core = Core(encode(space, wanted, mode if walk else "test"))
    decisions = core.first_ways()
    if decisions is None:
        return None
    preference = core.preference(decisions)
    limit = TOGETHER_QPS[mode] if ceiling == inf else CHEAPER_QPS
    if not core.evaluate(decisions, limit, budget, walk, ceiling - preference):
        return None
    return _found(core, decisions, preference, walk)


def feasible(space: Space, pieces: Sequence[Wanted], budget: Budget | None = None, walk: bool = False, prove: bool = True) -> bool | None:
    """Tells whether the pieces can all stand together; None where a limit was hit first.

    Args:
        space: the room.
        pieces: all of them are asked for, required or not.
        budget: the work it may cost.
        walk: whether doors and use sides must be joined too. "No" is then only said where that is proven, for every
            placement in whole millimetres.
        prove: whether "no" is worth the work of its proof to the caller.
    """
    allowed = budget or Budget()
    if walk and pieces:
        use, _ = usable(space, pieces, allowed, prove)
        if use is not Use.UNKNOWN:
            return use is Use.SOMEHOW
    core = Core(encode(space, pieces, "stands" if walk else "none"))
    decisions, exact = core.stand_together(LIMITS if prove else FIX_LIMITS, allowed, walk)
    if decisions is not None:
        return True
    if exact or not walk:
        return False if exact else None
    with_floor = Core(encode(space, (empty_floor(space), *pieces), "stands"))
    return True if with_floor.stand_together(FIX_LIMITS, allowed, True)[0] is not None else None
