"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces are searched best-first over prefixes; optional ones follow by importance, everything movable. The room stays walkable
throughout. Limits are counts; ties go to the earlier. The work is the kernel's; here is what to ask it.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.geometry import Rect
from solver.pieces import Candidate, Doorway, Piece, Space
from solver.placement import kernel
from solver.placement.budget import Budget, is_call_spent
from solver.placement.core import Core, Limits
from solver.placement.empty_floor import FLOOR, PULL
from solver.placement.encode import Encoded, encode, lay_out
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
    NO_WAY: "no way to stand it was found that leaves the room valid and walkable",
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
        best: no other candidates of the required pieces are cheaper, within the widenings tried first.
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
            Chosen(k, piece, core.decided(decision), core.rotation(k))
            for k, (piece, decision) in enumerate(decided)
            if decision != ABSENT and not piece.is_floor
        )

    def footprints(self) -> list[Rect]:
        """Returns where the chosen pieces are, on whole millimetres at which all that holds between them still does."""
        self.core.settle(self.solution.positions, self.solution, self.walkable, tidy=False)
        return self.core.footprints([chosen.number for chosen in self.chosen])


def solved_room(core: Core, decisions: Ints, walk: bool, solution: Solution | None = None) -> SolvedRoom:
    """Returns what the last search of a core found, or an earlier solution of it; the core lets go of what searching took.

    The decisions are those of its last problem. `walk`: only walkable placements were looked for; else it is tested.

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


def needed(pieces: Sequence[Piece]) -> set[str]:
    """Returns the labels of the required pieces and of all that they may be attached to or refer to, which come before them."""
    found = {piece.label for piece in pieces if piece.required}
    for piece in reversed(pieces):
        if piece.label in found:
            found.update(candidate.attach.parent for candidate in piece.candidates if candidate.attach is not None)
            found.update(link.of for link in piece.links)
    return found


def arrange(  # noqa: PLR0913 - keyword-only options: how hard it is tried, and for what
    space: Space,
    pieces: Sequence[Piece],
    *,
    walk: bool = True,
    budget: Budget | None = None,
    limits: Limits = LIMITS,
    wide: bool = False,
) -> SolvedRoom:
    """Chooses a candidate for every piece that fits: `arrange_whole` of solver/core/placement/whole.hpp.

    Args:
        space: where the room's furniture may stand.
        pieces: in order of importance.
        walk: whether doors and use sides must be joined. Where even the empty room is not walkable, nobody asks.
        budget: the work it may cost.
        limits: how much each step may try.
        wide: whether ways from door to door are to be wider than who walks, where the room costs little more for them: a wish. A try
            counts only where it is proven, holds all required pieces and most of what stands without it. Each width may cost the budget.

    Returns:
        The best arrangement found within the limits.
    """
    allowed = budget or Budget()
    necessary = needed(pieces)
    ordered = sorted((replace(piece, required=piece.label in necessary) for piece in pieces), key=lambda piece: not piece.required)
    tables, request = lay_out(space, ordered, "stands")
    whole = kernel.arrange_whole(request, limits.row, allowed.left, walk, wide)
    allowed.left -= whole.spent
    core = Core(_as_arranged(replace(space, ways_mm=whole.ways or space.ways_mm), ordered, tables.candidates, whole))
    gone = [(ordered[piece], CANNOT_STAND if certain else NOT_FOUND) for piece, certain in whole.left_out]
    left_out = [(piece, why) for piece, why in gone if not piece.is_floor]
    decisions, fates = core.engine.call.decisions.copy(), core.engine.call.fates.tolist()
    for piece, decision, fate in zip(core.encoded.pieces, decisions.tolist(), fates, strict=True):
        if decision == ABSENT and not piece.is_floor:
            left_out.append((piece, REASONS[fate if whole.complete else SPENT]))
    found = solved_room(core, decisions, whole.walk)
    return replace(found, left_out=tuple(left_out), solves=whole.solves, proven=whole.proven, best=whole.best)


def _as_arranged(space: Space, pieces: Sequence[Piece], ways: Sequence[Candidate], whole: kernel.ArrangedRoom) -> Encoded:
    """Returns a room as the core arranged it in the end: without what was left out, with floor to be kept empty where that helped."""
    shapes = whole.engine.room.candidates[: whole.candidates.count(-1)].tolist()
    floor = tuple(Candidate(FLOOR, (row[1], row[2], row[3]), 0, None, (row[6], row[7]), PULL) for row in shapes)
    stand = tuple(pieces[k] if k >= 0 else Piece(FLOOR, True, floor, is_floor=True) for k in whole.pieces)
    left = [ways[k] for k in whole.candidates if k >= 0]
    return Encoded(space, stand, (*floor, *left), (), "stands" if whole.walk else "none", whole.engine)


def walkable_when_empty(space: Space, there: Sequence[Piece] = ()) -> bool:
    """Tells whether a person can walk through all doors of the room, empty but for what is `there` already, and come to that."""
    core = Core(encode(space, there, "test"))
    decisions = core.first_decisions()
    return decisions is not None and core.evaluate(decisions, 10, Budget(is_known=True), True)


def with_joined_doors(space: Space, entrances: Collection[str]) -> Space:
    """Returns the space with those doors to be joined that its empty floor joins: where one comes in, by ids of doors, else the most."""
    if len(space.doorways) < 2 or walkable_when_empty(space):
        return space

    def joins(*doors: Doorway) -> bool:
        return walkable_when_empty(replace(space, doorways=doors))

    parts = [[other for other in space.doorways if other is door or joins(door, other)] for door in space.doorways if joins(door)]
    best = max(parts, key=lambda part: (any(door.id in entrances for door in part), len(part)), default=space.doorways)
    return replace(space, doorways=tuple(door if door in best else door._replace(walked="not") for door in space.doorways))


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
    if is_call_spent():
        return None
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
    return False if exact else None
