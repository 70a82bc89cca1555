"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Comes in: a space and pieces. Goes out: a SolvedRoom, in metres still. Required pieces are searched best-first over prefixes;
optional ones follow by importance, everything movable. The room stays walkable throughout. Limits are counts; ties go to the
earlier. The work is the kernel's; here is what to ask it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.geometry import Rect
from solver.pieces import Candidate, Piece, Space
from solver.placement.budget import Budget
from solver.placement.core import Arranged, Core, Limits, rounded
from solver.placement.empty_floor import empty_floor
from solver.placement.encode import encode
from solver.placement.layout import ABSENT, COVERED, NO_WAY, SPENT, Engine, Ints
from solver.placement.neighbourhood import freed_search
from solver.placement.problem import Problem, Solution
from solver.placement.walkable import find_walkable

LIMITS = Limits()
FIX_LIMITS = Limits(required=600, required_qps=500)
"""A repair tries fewer candidates: the first is nearly always the best, and someone is dragging."""
CANNOT_STAND = "no way to stand it is free beside the pieces before it"
NOT_FOUND = "no place was found for it beside the pieces before it"
NOT_WALKABLE = "no walkable arrangement of the required pieces was found"
FREEING_WORK = 4000.0
"""What freeing a few pieces may cost a question whether they can stand, in QPs of a small room."""
REASONS = {
    NO_WAY: "none of the ways to stand it leaves the room valid and walkable",
    COVERED: "the floor is covered as densely as wished without it",
    SPENT: "no place found for it within the search's limit",
}


@dataclass(frozen=True)
class Chosen:
    """A piece with its number in the room, the candidate taken, and its absolute rotation."""

    number: int
    piece: Piece
    candidate: Candidate
    rotation: int


@dataclass(frozen=True)
class SolvedRoom:
    """A room whose candidates are chosen and whose places are solved, in metres still.

    Args:
        core: the kernel's work space, for the walk.
        decisions: the kernel's numbers of what was chosen.
        preference: what the candidates chosen cost.
        solution: the cheapest placement.
        walkable: whether the solution is, rounded to millimetres.
        left_out: pieces without a place, each with the reason.
        solves: QPs.
        proven: the placement is the optimum, and no required piece left out could stand beside those before it.
        best: no other candidates of the required pieces are cheaper; both within the widenings tried.
    """

    core: Core
    decisions: Ints
    preference: float
    solution: Solution
    walkable: bool
    left_out: tuple[tuple[Piece, str], ...] = ()
    solves: int = 0
    proven: bool = True
    best: bool = True

    @cached_property
    def problem(self) -> Problem:
        """The problem with those candidates, for reading; its core must not have gone on to another one."""
        return self.core.problem()

    @property
    def engine(self) -> Engine:
        """The work space that the problem is in."""
        return self.core.engine

    @property
    def space(self) -> Space:
        """Where the room's furniture may stand."""
        return self.core.encoded.space

    @property
    def cost(self) -> float:
        """Terms and preferences."""
        return self.solution.cost + self.preference

    @property
    def chosen(self) -> tuple[Chosen, ...]:
        """The pieces that stand."""
        core, decided = self.core, zip(self.core.encoded.pieces, self.decisions.tolist(), strict=True)
        return tuple(
            Chosen(k, piece, core.decided(k, decision)[0], core.rotation(k))
            for k, (piece, decision) in enumerate(decided)
            if decision != ABSENT and not piece.is_floor
        )

    def footprints(self) -> list[Rect]:
        """Returns where the chosen pieces are, rounded to millimetres."""
        return self.core.footprints([chosen.number for chosen in self.chosen], rounded(self.solution.positions))


def solved_room(core: Core, decisions: Ints, walk: bool, solution: Solution | None = None) -> SolvedRoom:
    """Returns what the last search of a core found, or an earlier solution of it; the core lets go of what searching took.

    Args:
        core: whose last problem is that of the decisions.
        decisions: one a piece.
        walk: whether only walkable placements were looked for; else it is tested.
        solution: an earlier one.

    Raises:
        ValueError: nothing was found.
    """
    solution = solution or core.solution()
    if solution is None:
        raise ValueError(f"{core.encoded.space.room}: nothing was found for the decisions")
    walkable = walk or core.walkable_near(solution)
    preference = core.preference(decisions)
    core.release()
    return SolvedRoom(core, decisions, preference, solution, walkable, solves=solution.solves, proven=solution.proven)


def arrange(space: Space, pieces: Sequence[Piece], walk: bool = True, budget: Budget | None = None, limits: Limits = LIMITS) -> SolvedRoom:
    """Chooses a candidate for every piece that fits.

    Args:
        space: where the room's furniture may stand.
        pieces: in order of importance.
        walk: whether doors and use sides must be joined. Where even the empty room is not walkable, nobody asks.
        budget: the work it may cost.
        limits: how much each step may try.

    Returns:
        The best arrangement found within the limits.
    """
    allowed = budget or Budget()
    ordered = sorted(pieces, key=lambda piece: not piece.required)
    walk = walk and walkable_when_empty(space)
    left_out: list[tuple[Piece, str]] = []
    solves, sure = 0, True
    while True:
        core, arranged = _attempt(space, ordered, walk, limits, allowed)
        solves += arranged.solves
        if arranged.complete or allowed.spent:
            break
        sure &= arranged.closed
        gone = ordered.pop(arranged.deepest)
        if not gone.is_floor:
            left_out.append((gone, CANNOT_STAND if arranged.closed else NOT_FOUND))
        ordered = [piece for piece in ordered if not _goes_with(piece, gone)]
    decisions = arranged.decisions if arranged.complete else core.deepest_decisions()
    if not core.found or not arranged.complete:  # the budget ended before: once more, for this placement alone
        core.evaluate(decisions, LIMITS.required_qps, Budget(), walk)
    for piece, decision, fate in zip(core.encoded.pieces, decisions.tolist(), arranged.fates.tolist(), strict=True):
        if decision == ABSENT and not piece.is_floor:
            left_out.append((piece, REASONS[fate if arranged.complete else SPENT]))
    proven = arranged.complete and arranged.proven and sure
    best = arranged.complete and arranged.closed and len(ordered) == len(pieces)
    return replace(solved_room(core, decisions, walk), left_out=tuple(left_out), solves=solves, proven=proven, best=best)


def _goes_with(piece: Piece, gone: Piece) -> bool:
    """Tells whether a piece is floor that was asked for at a piece which is left out."""
    attached = (one.attach for one in piece.candidates)
    return piece.is_floor and piece.required and all(attach is not None and attach.parent == gone.label for attach in attached)


def _attempt(space: Space, pieces: Sequence[Piece], walk: bool, limits: Limits, budget: Budget) -> tuple[Core, Arranged]:
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
    core = Core(encode(space, ()))
    return core.evaluate(core.blank(), 10, Budget(), True)


def _found_by_freeing(space: Space, pieces: Sequence[Piece], budget: Budget) -> bool:
    """Tells whether pieces can be used with few of them freed, for little work."""
    rest = max(budget.left - FREEING_WORK, 0.0)
    budget.left -= rest
    found = next(freed_search(space, pieces, budget), None)
    budget.left += rest
    return found is not None


def feasible(space: Space, pieces: Sequence[Piece], budget: Budget | None = None, walk: bool = False, prove: bool = True) -> bool | None:
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
        if _found_by_freeing(space, pieces, allowed):
            return True
        known, _ = find_walkable(space, pieces, allowed, prove)
        if known is not None:
            return known
    core = Core(encode(space, pieces, "stands" if walk else "none"))
    decisions, exact = core.stand_together(LIMITS if prove else FIX_LIMITS, allowed, walk)
    if decisions is not None:
        return True
    if exact or not walk:
        return False if exact else None
    with_floor = Core(encode(space, (empty_floor(space), *pieces), "stands"))
    return True if with_floor.stand_together(FIX_LIMITS, allowed, True)[0] is not None else None
