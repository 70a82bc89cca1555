"""From the ways that pieces may stand to the placement that holds most: the placement stage, asked several times.

The first round decides the ways of all pieces together, best-first, those with the least freedom first. Then pieces that are
missing or miss a relation are taken out and put in again between the others, for as long as more is held. The judge of the
relations says which round is better; only the last goes through the final solve.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace

from solver.furnish.stances import stance_of
from solver.pipeline.asked import Terms, finished, lost
from solver.placement import settle
from solver.placement.arrange import Draft, arrange
from solver.placement.core import Limits
from solver.requested import Placement, relations_of
from solver.wanted import Arrangement, Placed, Space, Wanted

ROUNDS = 3
"""Most rounds of one placement."""
FIRST, MENDING = Limits(required=100, required_qps=100), Limits(required=40, required_qps=60)
"""What a first round, and what every other one, may try."""
THOROUGH = Limits(required=300, required_qps=300)
"""What is tried next where a required piece is missing; then all that the stage tries for a house."""
NEARLY_BEST = 3.0
"""Ways that cost this much more than a piece's best one count for how free it is: half a relation."""
SLIDES_MM = 100
"""What every way counts for at least along each axis."""

Score = tuple[int, int, float, float]


@dataclass(frozen=True)
class Found:
    """An arrangement as it was drafted, and its rank, less being better.

    The rank: required pieces that are missing, whether it cannot be walked, the cost of relations that are not held, the
    solver's cost. `lost` pairs a piece with the worth of a relation of it that is not held.
    """

    draft: Draft
    arrangement: Arrangement
    lost: Sequence[tuple[str, float]]
    score: Score

    @property
    def perfect(self) -> bool:
        """Whether all stands and all is held."""
        return self.score[:3] == (0, 0, 0.0)


def best_placement(terms: Terms, wanted: Sequence[Wanted]) -> Found:
    """Returns the best placement of all rounds.

    Args:
        terms: the request.
        wanted: the pieces, each after those it refers to.
    """
    best = _first(terms, wanted, FIRST)
    for _ in range(ROUNDS - 1):
        found = best if best.perfect else _mended(terms, wanted, best)
        if found.score[:3] >= best.score[:3]:
            break
        best = found
    for limits in (THOROUGH, Limits()):
        if best.score[0]:
            best = min(best, _first(terms, wanted, limits), key=lambda one: one.score)
    return best


def quick_placement(terms: Terms, wanted: Sequence[Wanted]) -> Found:
    """Returns a good placement in at most two rounds.

    Args:
        terms: the request.
        wanted: the pieces, perhaps with fewer ways to stand.
    """
    found = _first(terms, wanted, FIRST)
    return found if found.perfect else min(found, _mended(terms, wanted, found), key=lambda one: one.score)


def _first(terms: Terms, wanted: Sequence[Wanted], limits: Limits) -> Found:
    """Decides all pieces together, the least free ones first."""
    rank = {piece.label: -_freedom(terms.space, piece) for piece in wanted}
    return _judged(terms, arrange(terms.space, _ordered(wanted, rank), limits=limits))


def _freedom(space: Space, piece: Wanted) -> float:
    """Returns how much floor a piece's best ways leave it to slide on, in its own footprints."""
    dearest = min((way.cost for way in piece.alternatives), default=0.0) + NEARLY_BEST
    total = 0
    for way in piece.alternatives:
        if way.cost < dearest:
            rect = way.within or space.clear
            width, depth, _ = way.size_mm
            if stance_of(way.kind)[1] % 180:
                width, depth = depth, width
            total += (rect.width - width + SLIDES_MM) * (rect.depth - depth + SLIDES_MM)
    return total / (width * depth) if total else 0.0


def _mended(terms: Terms, wanted: Sequence[Wanted], found: Found) -> Found:
    """Takes pieces that are missing or miss a relation out and puts them in again between the others, which may slide."""
    return _judged(terms, arrange(terms.space, _reopened(terms, wanted, found, set(_squeaking(found))), limits=MENDING))


def _reopened(terms: Terms, wanted: Sequence[Wanted], found: Found, loose: set[str]) -> list[Wanted]:
    """Returns the pieces with all ways for the loose ones and their dependants, which come last, and one way for the others."""
    stands = {one.label: one for one in found.arrangement.placed}
    pieces = terms.asked.between(found.arrangement.placed, loose)
    if wanted is not terms.wanted:
        allowed = {(piece.label, way.kind) for piece in wanted for way in piece.alternatives}
        pieces = tuple(_only(piece, allowed) for piece in pieces)
    free = set(loose) | {piece.label for piece in pieces if piece.label not in stands}
    for piece in pieces:
        if free & set(_refers_to(piece)) and stands.get(piece.label) and stands[piece.label].chosen.attach:
            free.add(piece.label)
    first = [_as_it_stands(piece, stands[piece.label]) for piece in pieces if piece.label not in free]
    rank = {piece.label: int(piece.label not in free) for piece in pieces}
    return _ordered([*first, *(piece for piece in pieces if piece.label in free)], rank)


def _only(piece: Wanted, allowed: Container[tuple[str, str]]) -> Wanted:
    return replace(piece, alternatives=tuple(way for way in piece.alternatives if (piece.label, way.kind) in allowed))


def _as_it_stands(piece: Wanted, placed: Placed) -> Wanted:
    """Leaves a piece the way it has, wished where it is; it may still slide."""
    rect = placed.footprint
    middle = ((rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2)
    return replace(piece, alternatives=(replace(placed.chosen, anchor_mm=middle, cost=0.0),))


def _judged(terms: Terms, draft: Draft) -> Found:
    arrangement = settle([draft], "search")[0]
    required = {piece.label for piece in terms.wanted if piece.required}
    missing = sum(label in required for label, _ in arrangement.left_out)
    missed = lost(terms, arrangement)
    score = (missing, len(arrangement.notes), round(sum(cost for _, cost in missed), 6), arrangement.cost)
    return Found(draft, arrangement, missed, score)


def _squeaking(found: Found) -> list[str]:
    """Returns the pieces that are missing or miss a relation."""
    return list(dict.fromkeys([*(label for label, _ in found.arrangement.left_out), *(label for label, _ in found.lost)]))


def settled(terms: Terms, found: Found) -> Placement:
    """Returns the placement of an arrangement after the final solve."""
    placement = finished(terms, settle([found.draft], terms.engine)[0])
    worth = [rule.cost for _, rule in relations_of(terms.wishes)]
    missed = round(sum(cost for relation, cost in zip(placement.relations, worth, strict=True) if not relation.held), 6)
    return replace(placement, cost=missed)


def _ordered(wanted: Sequence[Wanted], blame: Mapping[str, float]) -> list[Wanted]:
    """Returns the most blamed first, each behind what it refers to; ties in the order given."""
    by_label = {piece.label: piece for piece in wanted}
    ordered: dict[str, Wanted] = {}

    def add(piece: Wanted) -> None:
        for label in _refers_to(piece):
            if label in by_label and label not in ordered:
                add(by_label[label])
        ordered.setdefault(piece.label, piece)

    for piece in sorted(wanted, key=lambda piece: -blame[piece.label]):
        add(piece)
    return list(ordered.values())


def _refers_to(piece: Wanted) -> list[str]:
    tied = [way.attach.parent for way in piece.alternatives if way.attach is not None]
    return list(dict.fromkeys([*tied, *(link.of for link in piece.links)]))
