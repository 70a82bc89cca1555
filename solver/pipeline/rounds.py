"""From the candidates of pieces to the placement that holds most: the placement stage, asked several times.

The first round decides the candidates of all pieces together, best-first, those with the least freedom first. Then pieces that are
missing or miss a relation are taken out and put in again between the others, where more is held then, and again while a required one is
missing. The judge of the relations says which round is better; only the last goes through the final solve.

Other placements: from one that was found, the stance of one of its pieces is forbidden and the rest solved again (after Lawler, 1972): once
for every piece, cheapest placement first. Two differ truly where a piece stands at another wall or is turned otherwise, or where one that
stands free is clearly elsewhere.
"""

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace

from catalogs.schema import RelationSpec
from solver.furnish import ListedPieces
from solver.geometry import turned
from solver.pieces import Arrangement, Piece, Placed, Space, Stance
from solver.pipeline.place_task import PlaceTask, finished, lost
from solver.placement import ROOM_WORK, Budget, SolvedRoom, arrange, finish, is_call_spent
from solver.placement.arrange import needed
from solver.placement.core import Limits
from solver.placement.walkable import find_walkable
from solver.requested import Placement, relations_of

FIRST, MENDING = Limits(required=100, required_qps=100), Limits(required=40, required_qps=60)
"""What a first round, and what every other one, may try."""
THOROUGH = Limits(required=3000, required_qps=1000)
"""What is tried next to prove a placement best or find a better one; where a piece is missing without it, all that is for a house."""
NEARLY_BEST = 3.0
"""Candidates that cost this much more than a piece's best one count for how free it is: half a relation."""
SLIDES_MM = 100
"""What every candidate counts for at least along each axis."""

Score = tuple[int, int, float, float, float]


@dataclass(frozen=True)
class Round:
    """An arrangement as it was drafted, and its rank, less being better.

    The rank: required pieces that are missing or break a required relation, whether it cannot be walked, how early these are in the list,
    the cost of relations that are not held and of optional pieces that are missing, the solver's cost. `lost` pairs a piece with a relation
    of it that is not held. `whole`: all candidates were there to choose from, or those that were not could only have cost more. `given_up`:
    pieces left out since their required relations were not held.
    """

    draft: SolvedRoom
    arrangement: Arrangement
    lost: Sequence[tuple[str, RelationSpec]]
    score: Score
    whole: bool
    given_up: tuple[str, ...] = ()

    @property
    def perfect(self) -> bool:
        """Whether all stands and all is held."""
        return self.score[:4] == (0, 0, 0.0, 0.0)

    @property
    def breaking(self) -> list[str]:
        """The pieces that stand though a required relation of theirs is not held."""
        there = {one.label for one in self.arrangement.placed}
        return [label for label, spec in self.lost if spec.required and label in there]

    @property
    def is_best(self) -> bool:
        """Whether no other candidates are cheaper."""
        return self.whole and self.arrangement.best and self.arrangement.proven


def best_placement(task: PlaceTask, wanted: Sequence[Piece], quick: bool = False) -> Round:
    """Returns the best placement of all rounds, without the pieces whose required relations it does not hold.

    The pieces come each after those it refers to. `quick`: without the longest rounds, which `thorough_placement` makes up for.
    """
    best, given_up = _best(task, wanted, quick), list[str]()
    while broken := best.breaking:
        given_up.append(broken[-1])
        wanted = [replace(piece, candidates=(), links=()) if piece.label in given_up else piece for piece in wanted]
        best = _best(task, wanted, quick)
    return replace(best, given_up=tuple(given_up))


def _best(task: PlaceTask, wanted: Sequence[Piece], quick: bool) -> Round:
    best = _first(task, wanted, FIRST)
    if not best.perfect and not is_call_spent():
        best = _best_mended(task, wanted, best)
    if wanted is not task.pieces or quick or best.is_best:
        missing = best.score[0] and not is_call_spent()
        return min(best, _first(task, wanted, Limits()), key=lambda one: one.score) if missing else best
    thorough = _thorough(task, best)
    return thorough if thorough is best or not thorough.score[0] or is_call_spent() else _best_mended(task, wanted, thorough)


def _best_mended(task: PlaceTask, wanted: Sequence[Piece], best: Round) -> Round:
    """Returns a placement or a better one that was mended, once and then as long as a required piece is missing and that helps."""
    while (other := _mended(task, wanted, best)).score[:4] < best.score[:4]:
        best = other
        if not best.score[0] or is_call_spent():
            break
    return best


def thorough_placement(task: PlaceTask, found: Round) -> Round:
    """Returns a placement that was found quickly, or a better one of the longest rounds."""
    other = _thorough(task, found)
    return found if other.breaking or other.score[:4] > found.score[:4] else other


def _thorough(task: PlaceTask, best: Round) -> Round:
    """Returns what is proven best among nearly all candidates; where that is not shown, the better one of a longer search among the few."""
    for listed in (task.listing.nearly_all, task.listing.few):
        if listed is not None and not is_call_spent():
            thorough = _first(task, listed.pieces, THOROUGH, listed, [label for label, _ in best.lost])
            if thorough.is_best and thorough.score[:4] <= best.score[:4]:
                return thorough
            best = min(best, thorough, key=lambda one: one.score)
    return best


def walked_placement(task: PlaceTask) -> Round | None:
    """Returns a placement round the required pieces where branch and bound finds these walkable, if it does: no wish counts for it."""
    space, firm = task.listing.space, needed(task.pieces)
    _, found = find_walkable(space, [piece for piece in task.pieces if piece.label in firm], Budget(ROOM_WORK), prove=False)
    at = {one.piece.label: one.near(0, space.clear) for one in found}
    return _judged(task, arrange(space, [at.get(piece.label, piece) for piece in task.pieces], limits=FIRST)) if at else None


def quick_placement(task: PlaceTask, wanted: Sequence[Piece]) -> Round:
    """Returns a good placement in at most two rounds of the pieces, perhaps with fewer candidates."""
    found = _first(task, wanted, FIRST)
    return found if found.perfect or is_call_spent() else min(found, _mended(task, wanted, found), key=lambda one: one.score)


def _first(
    task: PlaceTask, wanted: Sequence[Piece], limits: Limits, listed: ListedPieces | None = None, blamed: Container[str] = ()
) -> Round:
    """Decides all pieces together, those blamed for what is missed first, then the least free ones."""
    listed = listed or task.listing.few
    rank = {piece.label: 0.0 if piece.label in blamed else -_freedom(task.listing.space, piece) for piece in wanted}
    found = _judged(task, arrange(task.listing.space, _ordered(wanted, rank), limits=limits))
    unpaid = any(one in listed.unpaid for one in found.lost)
    return replace(found, whole=wanted is listed.pieces and not unpaid and found.draft.cost <= listed.sure_cost)


def _freedom(space: Space, piece: Piece) -> float:
    """Returns how much floor a piece's best candidates leave it to slide on, in its own footprints: none where it is there already."""
    if piece.is_there:
        return 0.0
    dearest = min((candidate.cost for candidate in piece.candidates), default=0.0) + NEARLY_BEST
    total = 0
    for candidate in piece.candidates:
        if candidate.cost < dearest:
            rect = candidate.within or space.clear
            turn = candidate.stance.rotation if candidate.stance else candidate.rotation
            width, depth = turned(*candidate.size_mm[:2], turn)
            total += (rect.width - width + SLIDES_MM) * (rect.depth - depth + SLIDES_MM)
    return total / max(width * depth, 1) if total else 0.0


def _mended(task: PlaceTask, wanted: Sequence[Piece], found: Round) -> Round:
    """Takes pieces that are missing or miss a relation out and puts them in again between the others, which may slide."""
    loose = {label for label, _ in (*found.arrangement.left_out, *found.lost)}
    return _judged(task, arrange(task.listing.space, _reopened(task, wanted, found, loose), limits=MENDING))


def _reopened(task: PlaceTask, wanted: Sequence[Piece], found: Round, loose: set[str]) -> list[Piece]:
    """Returns the pieces with all candidates for the loose ones and their dependants, which come last, and one for the others."""
    stands = {one.label: one for one in found.arrangement.placed}
    pieces = task.listing.between(found.arrangement.placed, loose)
    if wanted is not task.pieces:
        allowed = {(piece.label, candidate.stance) for piece in wanted for candidate in piece.candidates}
        pieces = tuple(_only(piece, allowed) for piece in pieces)
    free = set(loose) | {piece.label for piece in pieces if piece.label not in stands}
    for piece in pieces:
        if free & set(_refers_to(piece)) and stands.get(piece.label) and stands[piece.label].chosen.attach:
            free.add(piece.label)
    first = [_as_it_stands(piece, stands[piece.label]) for piece in pieces if piece.label not in free]
    rank = {piece.label: int(piece.label not in free) for piece in pieces}
    return _ordered([*first, *(piece for piece in pieces if piece.label in free)], rank)


def _only(piece: Piece, allowed: Container[tuple[str, Stance | None]]) -> Piece:
    return replace(piece, candidates=tuple(candidate for candidate in piece.candidates if (piece.label, candidate.stance) in allowed))


def _as_it_stands(piece: Piece, placed: Placed) -> Piece:
    """Leaves a piece the candidate it has, wished where it is; it may still slide."""
    return replace(piece, candidates=(replace(placed.chosen, anchor_mm=placed.footprint.centre, cost=0.0),))


def _judged(task: PlaceTask, draft: SolvedRoom) -> Round:
    arrangement = draft.arrangement
    missed = lost(task, arrangement)
    found = Round(draft, arrangement, missed, (0, 0, 0.0, 0.0, 0.0), False)
    breaking, left_out = {*found.breaking}, {label for label, _ in arrangement.left_out}
    listed = [label for request in task.requests if request.required for label in request.labels]
    early = _early(listed, breaking | left_out)
    missing = len(left_out.intersection(listed)) + len(breaking)
    wished = [label for request in task.requests if not request.required for label in request.labels]
    skipped = sum(piece.skip_cost for piece in task.pieces if piece.label in left_out.intersection(wished)) + _early(wished, left_out)
    cost = round(sum(spec.cost for _, spec in missed) + skipped, 6)
    return replace(found, score=(missing, len(arrangement.notes), early, cost, arrangement.cost))


def _early(listed: Sequence[str], gone: Container[str]) -> float:
    """Returns how early in a list those are that are gone, less than 1: of two lists the one with the first of them is more."""
    return sum(2.0 ** -(place + 1) for place, label in enumerate(listed) if label in gone)


def settled(task: PlaceTask, found: Round) -> Placement:
    """Returns the placement of an arrangement after the final solve."""
    arrangement = finish([found.draft], task.setting.engine)[0]
    placement = finished(task, replace(arrangement, best=arrangement.best and found.whole))
    worth = [rule.cost for _, rule in relations_of(task.requests)]
    missed = round(sum(cost for relation, cost in zip(placement.relations, worth, strict=True) if not relation.held), 6)
    return replace(placement, cost=missed)


def with_fronts_open(task: PlaceTask, found: Round) -> tuple[Round, Placement]:
    """Returns an arrangement and its placement after the final solve, with fewer fronts blocked where no relation is lost for it.

    The piece of each blocked front, and those that it meets, are taken out and put in again where all fronts open over empty floor.
    """
    best = settled(task, found)
    for blocked in _blocked(best):
        if is_call_spent() or blocked not in _blocked(best):
            continue
        other = _cleared(task, found, set(blocked))
        if other and other.score[:4] > found.score[:4]:
            other = _cleared(task, other, {label for label, _ in other.lost})
        if other is None or other.score[:4] > found.score[:4]:
            continue
        placement = settled(task, other)
        if placement.cost <= best.cost and len(_blocked(placement)) < len(_blocked(best)):
            found, best = other, placement
    return found, best


def _blocked(placement: Placement) -> Sequence[tuple[str, ...]]:
    """Returns the pieces of which fronts are blocked, each with what these meet."""
    return [issue.ids for issue in placement.issues if issue.rule == "front_blocked"]


def _cleared(task: PlaceTask, found: Round, loose: set[str]) -> Round | None:
    """Returns the same pieces placed with empty floor before their fronts, the loose ones anew; None where one has no place then."""
    stands = {one.label: one for one in found.arrangement.placed}
    pieces = [piece for piece in _reopened(task, task.pieces, found, loose & set(task.listing.listed)) if piece.label in stands]
    fronts = {piece.candidates[0].attach.parent: piece for piece in task.listing.fronts if piece.candidates[0].attach}
    behind = [part for piece in pieces for part in (piece, fronts.get(piece.label)) if part]
    before, wanted = found.arrangement, {piece.label: piece for piece in task.pieces}
    gone = [replace(wanted[label], required=False, left_out=fate) for label, fate in found.draft.fates.items()]
    gone = [replace(piece, candidates=()) if piece.label in found.given_up else piece for piece in gone]
    draft = arrange(task.listing.space, [*behind, *gone], limits=MENDING)
    if len(draft.arrangement.left_out) > len(gone):
        return None
    other = _judged(task, draft.with_(skipped=before.skipped, best=before.best))
    return replace(other, whole=found.whole, given_up=found.given_up)


def _ordered(wanted: Sequence[Piece], blame: Mapping[str, float]) -> list[Piece]:
    """Returns the most blamed first, each behind what it refers to; ties in the order given."""
    by_label = {piece.label: piece for piece in wanted}
    ordered: dict[str, Piece] = {}

    def add(piece: Piece) -> None:
        for label in _refers_to(piece):
            if label in by_label and label not in ordered:
                add(by_label[label])
        ordered.setdefault(piece.label, piece)

    for piece in sorted(wanted, key=lambda piece: -blame[piece.label]):
        add(piece)
    return list(ordered.values())


def _refers_to(piece: Piece) -> list[str]:
    attached_to = [candidate.attach.parent for candidate in piece.candidates if candidate.attach is not None]
    return list(dict.fromkeys([*attached_to, *(link.of for link in piece.links)]))


ELSEWHERE_MM = 500
"""How far a free piece must have moved to be clearly elsewhere."""
TRIES_EACH = 6
"""Most placements tried for every one that is asked for."""

Forbidden = frozenset[tuple[str, Stance | None]]


def other_placements(task: PlaceTask, best: Round, number: int) -> list[Placement]:
    """Returns up to that many placements that differ truly from the best and from each other, by rank."""
    found: list[tuple[Round, Placement]] = []
    frontier: list[tuple[Round, Forbidden]] = [(best, frozenset())]
    tries = TRIES_EACH * number
    while frontier and tries > 0 and len(found) < number and not is_call_spent():
        source, forbidden = frontier.pop(0)
        for placed in source.arrangement.placed:
            if tries <= 0 or is_call_spent() or placed.label not in task.listing.listed:
                continue
            tries -= 1
            without = forbidden | {(placed.label, placed.chosen.stance)}
            wanted = _without(task.pieces, without)
            if wanted is None:
                continue
            other = quick_placement(task, wanted)
            known = (best, *(one for one, _ in found))
            if not other.breaking and other.score[:2] == best.score[:2] and all(_differ(other, one) for one in known):
                opened = with_fronts_open(task, other)
                found.append(opened if all(_differ(opened[0], one) for one in known) else (other, settled(task, other)))
                frontier.append((found[-1][0], without))
        frontier.sort(key=lambda entry: entry[0].score)
    return [placement for _, placement in sorted(found, key=lambda one: one[0].score)[:number]]


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
