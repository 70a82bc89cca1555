"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces: best-first over prefixes. Optional pieces follow by importance, everything movable. The room stays walkable
throughout. Limits are counts; ties go to the earlier. The work is the kernel's; here is what to ask it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from solver.placement.budget import Budget
from solver.placement.core import Arranged, Core, Limits
from solver.placement.encode import encode
from solver.placement.kernel.fill import COVERED, NO_WAY, SPENT
from solver.placement.kernel.layout import ABSENT, Ints
from solver.placement.outcome import Outcome
from solver.placement.problem import Problem
from solver.wanted import Alternative, Space, Wanted

LIMITS = Limits()
FIX_LIMITS = Limits(required=400, required_qps=2000)
"""A repair tries fewer ways: the first is nearly always the best, and someone is dragging."""
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

    `cost` counts terms and preferences; `proven` tells that the placement of the chosen ways is the optimum, `best` that no
    other choice of ways for the required pieces is cheaper; both within the widenings tried.
    """

    space: Space
    core: Core
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
    solves = 0
    while True:
        core = Core(encode(space, pieces, "stands" if walk else "none"))
        arranged = core.arrange(limits, allowed, walk)
        solves += arranged.solves
        if arranged.complete:
            return _draft(core, arranged, left_out, solves, walk)
        if allowed.spent:
            return _cut_short(core, left_out, solves, walk)
        missing = pieces.pop(arranged.deepest)
        word = "no way to stand it is free" if arranged.closed else "no place was found for it"
        left_out.append((missing, f"{word} beside the pieces before it"))


def walkable_when_empty(space: Space) -> bool:
    """Tells whether a person can walk through all doors of the empty room."""
    core = Core(encode(space, ()))
    return core.evaluate(core.blank(), 10, Budget(), True)


def _draft(core: Core, arranged: Arranged, left_out: list[tuple[Wanted, str]], solves: int, walk: bool) -> Draft:
    absent = list(left_out)
    for k, piece in enumerate(core.encoded.wanted):
        if arranged.decisions[k] == ABSENT:
            absent.append((piece, REASONS[int(arranged.fates[k])]))
    outcome = core.outcome()
    return Draft(
        core.encoded.space,
        core,
        core.problem(),
        outcome,
        _chosen(core, arranged.decisions),
        outcome.cost + arranged.preference,
        absent,
        solves,
        arranged.proven,
        arranged.closed and not left_out,
        walk,
    )


def _chosen(core: Core, decisions: Ints) -> tuple[Chosen, ...]:
    return tuple(
        Chosen(piece, *core.decided(k, int(decisions[k])), core.rotation(k))
        for k, piece in enumerate(core.encoded.wanted)
        if decisions[k] != ABSENT
    )


def _cut_short(core: Core, left_out: list[tuple[Wanted, str]], solves: int, walk: bool) -> Draft:
    """Returns the deepest prefix of the required pieces, where the budget ended before all stood."""
    decisions = core.deepest_decisions()
    core.evaluate(decisions, LIMITS.required_qps, Budget(), walk)
    outcome, preference = core.outcome(), core.preference(decisions)
    absent = [(piece, REASONS[SPENT]) for k, piece in enumerate(core.encoded.wanted) if decisions[k] == ABSENT]
    chosen = _chosen(core, decisions)
    cost = outcome.cost + preference
    return Draft(core.encoded.space, core, core.problem(), outcome, chosen, cost, [*left_out, *absent], solves, False, False, walk)


def arrange_as_wished(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft:
    """Keeps every piece in its first way if all can stand so; else arranges them; all that are to be used can be reached.

    The first ways are the cheapest, so where their placement costs less than any other way would, it is the best. Where no
    walkable placement is found the best that is not is returned, `walkable` False.
    """
    together = _together(space, wanted, budget)
    others = [a.cost for piece in wanted for a in piece.alternatives[1:] if a.cost > 0]
    least = min(others, default=float("inf"))
    if together is not None and together.walkable and together.cost <= least:
        return together
    if others and walkable_when_empty(space):
        draft = arrange(space, wanted, budget=budget, limits=FIX_LIMITS)
        if not draft.left_out and (together is None or not together.walkable or draft.cost < together.cost):
            return draft
    if together is not None and (together.walkable or together.cost <= least):
        return together
    draft = arrange(space, wanted, walk=False, budget=budget, limits=FIX_LIMITS)
    worse = bool(draft.left_out) or (together is not None and draft.cost >= together.cost)
    if together is not None and worse:
        return together
    return replace(draft, walkable=False)


def _together(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft | None:
    """Searches a place for all pieces at once, each in its first way: with least movement, then walkable if it is not."""
    least: Draft | None = None
    for walk, mode in ((False, "test"), (True, "test"), (True, "stands")):
        core = Core(encode(space, wanted, mode))
        decisions = core.first_ways()
        if decisions is None or not core.evaluate(decisions, LIMITS.final_qps, budget, walk):
            if least is None:
                return None
            continue
        outcome = core.outcome()
        draft = Draft(
            space,
            core,
            core.problem(),
            outcome,
            _chosen(core, decisions),
            outcome.cost + core.preference(decisions),
            solves=outcome.solves,
            proven=outcome.proven,
            walkable=walk or core.walkable_near(outcome),
        )
        if draft.walkable:
            return draft
        least = draft
    return least


def feasible(space: Space, pieces: Sequence[Wanted], budget: Budget | None = None, walk: bool = False) -> bool | None:
    """Tells whether the pieces can all stand together; None where a limit was hit first.

    Args:
        space: the room.
        pieces: all of them are asked for, required or not.
        budget: the work it may cost.
        walk: whether doors and use sides must be joined too. "No" is then only said where the search without the last
            test, whether all free floor is one, is infeasible already.
    """
    core = Core(encode(space, pieces, "stands" if walk else "none"))
    decisions, exact = core.stand_together(LIMITS, budget or Budget(), walk)
    if decisions is not None:
        return True
    return False if exact else None
