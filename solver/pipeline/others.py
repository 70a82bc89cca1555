"""Other placements of the same request, truly different from the best.

From a placement found, the stance of one of its pieces is forbidden and the rest solved again (after Lawler, 1972): once for
every piece, cheapest placement first. Two placements differ truly where a piece stands at another wall or is turned
otherwise, or where one that stands free is clearly elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from solver.pieces import Piece, Placed, Stance
from solver.pipeline.place_task import PlaceTask
from solver.pipeline.rounds import Round, quick_placement
from solver.placement import is_call_spent

ELSEWHERE_MM = 500
"""How far a free piece must have moved to be clearly elsewhere."""
TRIES_EACH = 6
"""Most placements tried for every one that is asked for."""

Forbidden = frozenset[tuple[str, Stance | None]]


def other_placements(task: PlaceTask, best: Round, number: int) -> list[Round]:
    """Returns up to that many placements that differ truly from the best and from each other, by rank."""
    found: list[Round] = []
    frontier: list[tuple[Round, Forbidden]] = [(best, frozenset())]
    tries = TRIES_EACH * number
    while frontier and tries > 0 and len(found) < number and not is_call_spent():
        source, forbidden = frontier.pop(0)
        for placed in source.arrangement.placed:
            if tries <= 0 or is_call_spent() or placed.label not in task.listed.listed:
                continue
            tries -= 1
            without = forbidden | {(placed.label, placed.chosen.stance)}
            wanted = _without(task.pieces, without)
            if wanted is None:
                continue
            other = quick_placement(task, wanted)
            if not other.breaking and other.score[:2] == best.score[:2] and all(_differ(other, one) for one in (best, *found)):
                found.append(other)
                frontier.append((other, without))
        frontier.sort(key=lambda entry: entry[0].score)
    return sorted(found, key=lambda one: one.score)[:number]


def _without(wanted: Sequence[Piece], forbidden: Forbidden) -> list[Piece] | None:
    """Returns the pieces without the stances forbidden; None where one has no other."""
    left = [replace(piece, candidates=tuple(a for a in piece.candidates if (piece.label, a.stance) not in forbidden)) for piece in wanted]
    return left if all(piece.candidates for piece in left) else None


def _differ(a: Round, b: Round) -> bool:
    there = {placed.label: placed for placed in b.arrangement.placed}
    here = {placed.label for placed in a.arrangement.placed}
    return here != set(there) or any(_moved(placed, there[placed.label]) for placed in a.arrangement.placed)


def _moved(a: Placed, b: Placed) -> bool:
    if a.chosen.stance != b.chosen.stance:
        return True
    free = a.wall is None and a.chosen.attach is None
    one, other = a.footprint, b.footprint
    return free and max(abs(one.x0 - other.x0), abs(one.z0 - other.z0)) > ELSEWHERE_MM
