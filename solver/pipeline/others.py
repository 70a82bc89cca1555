"""Other placements of the same request, truly different from the best.

From a placement found, the way one of its pieces stands is forbidden and the rest solved again (after Lawler, 1972): once for
every piece, cheapest placement first. Two placements differ truly where a piece stands at another wall or is turned
otherwise, or where one that stands free is clearly elsewhere.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from solver.pipeline.asked import Terms
from solver.pipeline.rounds import Found, quick_placement
from solver.wanted import Placed, Wanted

ELSEWHERE_MM = 500
"""How far a free piece must have moved to be clearly elsewhere."""
TRIES_EACH = 6
"""Most placements tried for every one that is asked for."""

Forbidden = frozenset[tuple[str, str]]


def other_placements(terms: Terms, best: Found, number: int) -> list[Found]:
    """Returns up to that many placements that differ truly from the best and from each other, by rank."""
    found: list[Found] = []
    frontier: list[tuple[Found, Forbidden]] = [(best, frozenset())]
    tries = TRIES_EACH * number
    while frontier and tries > 0 and len(found) < number:
        source, forbidden = frontier.pop(0)
        for placed in source.arrangement.placed:
            if tries <= 0 or placed.label not in terms.asked.askings:
                continue
            tries -= 1
            without = forbidden | {(placed.label, placed.chosen.kind)}
            wanted = _without(terms.wanted, without)
            if wanted is None:
                continue
            other = quick_placement(terms, wanted)
            if other.score[:2] == best.score[:2] and all(_differ(other, one) for one in (best, *found)):
                found.append(other)
                frontier.append((other, without))
        frontier.sort(key=lambda entry: entry[0].score)
    return sorted(found, key=lambda one: one.score)[:number]


def _without(wanted: Sequence[Wanted], forbidden: Forbidden) -> list[Wanted] | None:
    """Returns the pieces without the ways forbidden; None where one has no other."""
    left = [replace(piece, alternatives=tuple(a for a in piece.alternatives if (piece.label, a.kind) not in forbidden)) for piece in wanted]
    return left if all(piece.alternatives for piece in left) else None


def _differ(a: Found, b: Found) -> bool:
    there = {placed.label: placed for placed in b.arrangement.placed}
    here = {placed.label for placed in a.arrangement.placed}
    return here != set(there) or any(_moved(placed, there[placed.label]) for placed in a.arrangement.placed)


def _moved(a: Placed, b: Placed) -> bool:
    if a.chosen.kind != b.chosen.kind:
        return True
    free = a.wall is None and a.chosen.attach is None
    one, other = a.footprint, b.footprint
    return free and max(abs(one.x0 - other.x0), abs(one.z0 - other.z0)) > ELSEWHERE_MM
