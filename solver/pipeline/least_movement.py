"""Pieces of a sent room -> where they go with least movement; near the last answer while something is dragged.

Not here: what becomes of a room whose pieces cannot all stand (repair_room), why (conflicts).
"""

from __future__ import annotations

from collections.abc import Sequence

from solver.pieces import Arrangement, Piece, Space
from solver.placement import Budget, feasible, finish, move_least, moved_back
from solver.placement.lengths import Shortfall, shortfall
from solver.repair import LastAnswer, RoomProblem

JUMP_COST = 0.2
"""What it costs that a neighbour of the dragged piece goes elsewhere than near its last pose: as much as moving it by 45 cm."""
JUMP_SHARE = 0.1
"""What it costs besides, as a share of the cost: where much is in the way, little is gained by it."""
MOST_FREED = 3
"""How many neighbours are tried elsewhere, each alone."""
LIVE_WORK = 60_000.0
"""Work each attempt near the last answer may cost, in QPs of a small room: about 60 ms."""


def least_moved(space: Space, pieces: Sequence[Piece], budget: Budget) -> Arrangement:
    """Places pieces with least movement."""
    return finish([move_least(space, pieces, budget)], "search")[0]


def missing_length(space: Space, pieces: Sequence[Piece], budget: Budget, walk: bool, prove: bool = True) -> Shortfall | None:
    """Returns which lengths add up to more than the room has for a minimal conflict; None where no one length is missing.

    `walk`: the pieces must be within reach, too; `prove`: a "no" on the way is worth the work of its proof.
    """
    return shortfall(
        space,
        pieces,
        lambda longer, some: feasible(longer, some, budget, walk, prove),
        lambda longer, some: least_moved(longer, some, budget),
    )


def least_moved_from_last(problem: RoomProblem, pieces: Sequence[Piece]) -> Arrangement:
    """Places the pieces of a room with least movement; near the last answer unless elsewhere is clearly better."""
    space, settings = problem.space, problem.settings
    last = LastAnswer(pieces, space.clear, settings.previous, settings.moved)
    if not last.bound:
        return least_moved(space, pieces, Budget(settings.work))
    work = min(settings.work, LIVE_WORK)
    free = least_moved(space, pieces, Budget(work))
    jumped = last.jumped(free)
    if not jumped and not free.left_out and not free.notes:
        return free
    alone = [(label,) for label in jumped[:MOST_FREED] if len(jumped) > 1]
    restricted = [near for near in map(last.near, [(), *alone]) if near is not None]
    answers = [least_moved(space, near, Budget(work)) for near in restricted]
    stood = last.places()
    draft = moved_back(space, [piece for piece, _ in stood], [place for _, place in stood]) if stood else None
    answers += [finish([draft], "search")[0]] if draft else []
    return min([*answers, free], key=lambda answer: (len(answer.left_out), len(answer.notes), _cost(answer, last)))


def _cost(answer: Arrangement, last: LastAnswer) -> float:
    """Returns what an answer costs, its jumps counted."""
    jumps = len(last.jumped(answer))
    return answer.cost * (1 + JUMP_SHARE * jumps) + JUMP_COST * jumps
