"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces: best-first over prefixes. Optional pieces follow by importance, everything movable. The room stays walkable
throughout. Limits are counts; ties go to the earlier. The work is the kernel's; here is what to ask it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from solver.geometry import Rect
from solver.placement.budget import Budget
from solver.placement.core import Arranged, Core, Limits
from solver.placement.encode import LEAST_FLOOR_MM2, door_target, empty_floor, encode
from solver.placement.kernel.fill import COVERED, NO_WAY, SPENT
from solver.placement.kernel.layout import ABSENT, Ints
from solver.placement.outcome import Outcome
from solver.placement.problem import Problem
from solver.placement.usable import Use, usable
from solver.wanted import EMPTY_FLOOR, Alternative, Space, Wanted

LIMITS = Limits()
FIX_LIMITS = Limits(required=600, required_qps=500)
"""A repair tries fewer ways: the first is nearly always the best, and someone is dragging."""
MARGIN_MM = 2
"""Rounding to millimetres moves each of two bodies by less than one."""
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

    def footprints(self) -> list[Rect]:
        """Returns where the chosen pieces are, rounded to millimetres."""
        bodies = {part.label: part for part in self.problem.parts if not part.stand}
        p = [[math.floor(x * 1000 + 0.5) for x in axis.tolist()] for axis in self.outcome.positions or ()]
        return [bodies[chosen.wanted.label].rect(p) for chosen in self.chosen]


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
    found = found_by(core, arranged.decisions, arranged.preference, walk)
    best = arranged.closed and not left_out
    return replace(found, left_out=absent, solves=solves, proven=arranged.proven, best=best)


def found_by(core: Core, decisions: Ints, preference: float, walkable: bool, outcome: Outcome | None = None) -> Draft:
    """Returns what the last search of a core found, or an earlier outcome of it, and lets the core go of what it took."""
    outcome = outcome or core.outcome()
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
    found = found_by(core, draft.decisions, draft.cost - draft.outcome.cost, True)
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
    found = found_by(core, decisions, core.preference(decisions), walk)
    return replace(found, left_out=[*left_out, *absent], solves=solves, proven=False, best=False)


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
