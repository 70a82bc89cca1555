"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces are searched best-first over prefixes; optional ones follow by importance, everything movable. The room stays walkable
throughout. Limits are counts; ties go to the earlier. The work is the core's; here is what to ask it.
"""

from collections.abc import Collection, Sequence
from dataclasses import replace
from struct import Struct
from typing import Final

from solver.core import borrowed
from solver.pieces import Doorway, Piece, Space
from solver.placement.budget import Budget, is_call_spent
from solver.placement.core import Core, Limits
from solver.placement.encode import Tables, encode, lay_out
from solver.placement.made_rooms import SolvedRoom, answer_at, solved_room
from solver.placement.neighbourhood import freed_search
from solver.placement.walkable import find_walkable

LIMITS = Limits()
FIX_LIMITS = Limits(required=600, required_qps=500)
"""A repair tries fewer candidates: the first is nearly always the best, and someone is dragging."""
FREEING_WORK = 4000.0
"""What freeing a few pieces may cost a question whether they can stand, in QPs of a small room."""
_ASKED: Final = Struct("<7qd3q")
"""`struct MakingAsked` of solver/core/placement/making.hpp."""


def needed(pieces: Sequence[Piece]) -> set[str]:
    """Returns the labels of the required pieces and of all that they may be attached to or refer to, which come before them."""
    found = {piece.label for piece in pieces if piece.required}
    for piece in reversed(pieces):
        if piece.label in found:
            found.update(candidate.attach.parent for candidate in piece.candidates if candidate.attach is not None)
            found.update(link.of for link in piece.links)
    return found


def lay_out_first(space: Space, pieces: Sequence[Piece]) -> tuple[Tables, bytes]:
    """Lays a room out to be made: the required pieces first, and all that they may be attached to or refer to."""
    necessary = needed(pieces)
    ordered = [replace(piece, required=piece.label in necessary) for piece in pieces]
    return lay_out(space, sorted(ordered, key=lambda piece: not piece.required), "stands")


def asked_of_room(limits: Limits, budget: Budget, *, walk: bool = True, wide: bool = False, tidy: bool = False) -> bytes:
    """Returns what is asked of a room, as `arrange`, as the core reads it."""
    return _ASKED.pack(*limits.row.tolist(), budget.left, walk, wide, tidy)


def arrange(  # noqa: PLR0913 - keyword-only options: how hard it is tried, and for what
    space: Space,
    pieces: Sequence[Piece],
    *,
    walk: bool = True,
    budget: Budget | None = None,
    limits: Limits = LIMITS,
    wide: bool = False,
    tidy: bool = False,
) -> SolvedRoom:
    """Chooses a candidate for every piece that fits, and places it: `Making` of solver/core/placement/making.hpp.

    Args:
        space: where the room's furniture may stand.
        pieces: in order of importance.
        walk: whether doors and use sides must be joined. Where even the empty room is not walkable, nobody asks.
        budget: the work it may cost.
        limits: how much each step may try.
        wide: whether ways from door to door are to be wider than who walks, where the room costs little more for them: a wish. A try
            counts only where it is proven, holds all required pieces and most of what stands without it. Each width may cost the budget.
        tidy: whether slivers are closed or opened afterwards (solver/core/placement/tidy.hpp), at a cost of at most 0.8.

    Returns:
        The best arrangement found within the limits.
    """
    allowed = budget or Budget()
    tables, request = lay_out_first(space, pieces)
    asked = asked_of_room(limits, allowed, walk=walk, wide=wide, tidy=tidy)
    with borrowed(roomy=True) as core:
        answer = answer_at(core, int(core.call("make_room", core.write(request), core.write(asked))), space.room)
    allowed.left -= answer.made.spent
    return solved_room(space, answer, tables)


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
