"""One broken room -> the same room repaired, and what of it could not be: `RoomProblem` -> `RoomRepair`.

All pieces are placed with least movement; near the last answer while something is dragged. Where no place is found for all, a few of those
in the way are left out, the least important that help. Not here: which rooms are broken (fix), why something cannot stand (conflicts).
"""

from collections.abc import Callable, Collection, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace

from solver.answers import Issue
from solver.pieces import Arrangement, Piece, Space, with_relying
from solver.placement import (
    Budget,
    can_be_used,
    feasible,
    in_the_way,
    is_call_spent,
    joined_in_turn,
    move_least,
    moved_back,
    standing,
    walkable_when_empty,
)
from solver.placement.lengths import Shortfall, shortfall
from solver.repair import LastAnswer, RoomProblem, all_bodies, holders, pieces_as_sent, with_bodies, without, written_back
from solver.scene import Room

JOINING_WORK = 400_000.0
"""Work that having the pieces of a crowd stand one after the other may cost, in QPs of a small room, once the call's is spent."""
ROUNDS = 3
"""Times a room that cannot be repaired whole is repaired again, until nothing changes any more; as long as fewer are left out, more."""


@dataclass(frozen=True)
class RoomRepair:
    """The answer for one room.

    Args:
        problem: the room as sent.
        room: with new poses; what could not stand is in it, as near as can be.
        asked: the room whose pieces were placed: as sent, without what was taken out before.
        pieces: those that were placed, as sent.
        unplaced: labels of those that found no place.
        misplaced: what is wrong with bodies that break a rule by themselves where they are locked, by id.
        unreached: labels of those that stand but cannot all be used.
    """

    problem: RoomProblem
    room: Room
    asked: Room
    pieces: Sequence[Piece] = ()
    unplaced: tuple[str, ...] = ()
    misplaced: Mapping[str, str] = field(default_factory=dict)
    unreached: tuple[str, ...] = ()

    @property
    def whole(self) -> bool:
        """Whether every piece found its place."""
        return not self.unplaced and not self.misplaced

    @property
    def sound(self) -> Room:
        """The room without what found no place, or stands wrongly."""
        return without(self.room, {*self.unplaced, *self.misplaced})

    @property
    def answer(self) -> Room:
        """The room as it is answered: where that was asked for, without what cannot stand and all it carries."""
        return without(self.room, self.unplaced) if self.problem.settings.remove else self.room


def repair_room(problem: RoomProblem) -> RoomRepair:
    """Repairs one room with least movement, around what is misplaced where it is locked."""
    misplaced = _misplaced(problem)
    asked = without(problem.room, misplaced) if misplaced and problem.settings.remove else problem.room
    trial = replace(problem, room=asked)
    pieces, arrangement = _placed(trial, () if problem.settings.remove else misplaced)
    found = RoomRepair(problem, written_back(trial, arrangement.placed), asked, pieces, _labels_left_out(arrangement), misplaced)
    while problem.settings.remove and arrangement.left_out and arrangement.notes and not is_call_spent():
        trial = replace(problem, room=found.answer)
        arrangement = _placed(trial, ())[1]
        gone = (*found.unplaced, *_labels_left_out(arrangement))
        found = replace(found, room=written_back(trial, arrangement.placed), unplaced=gone)
    if problem.settings.remove:
        return _put_back(found)
    return found if found.whole else until_nothing_changes(found)


def with_joined(repair: RoomRepair) -> RoomRepair:
    """Returns a repair that the end of the call's work ended with each piece in the way that finds a place beside the others, in turn.

    The others stand as they were sent or as the search left them, whichever way more stand.
    """
    if not _is_walked_in(repair.problem):
        return repair
    space, budget = repair.problem.space, Budget(JOINING_WORK, is_known=True)
    now = {body.id: body for body in all_bodies(repair.room)}
    come_to = with_bodies(repair.asked, [now.get(body.id, body) for body in all_bodies(repair.asked)])
    there = {piece.label for piece in repair.pieces}
    starts = [replace(repair.problem, room=room) for room in (repair.asked, come_to)]
    pieces = [[piece for piece in _used(start, repair.misplaced) if piece.label in there] for start in starts]
    stand = [standing(space, some, budget) for some in pieces]
    best = max(range(len(starts)), key=lambda k: len(stand[k].pieces))
    joined = joined_in_turn(stand[best], pieces[best], budget)
    unplaced = tuple(piece.label for piece in pieces[best] if piece.label not in joined.ways and not piece.candidates[0].stays)
    near = moved_back(space, [replace(piece, candidates=(joined.ways[piece.label],)) for piece in joined.pieces], joined.base.places)
    if near is None or len(joined.pieces) == len(stand[best].pieces):
        return repair
    return replace(repair, room=written_back(starts[best], near.arrangement.placed), unplaced=unplaced)


def _put_back(repair: RoomRepair) -> RoomRepair:
    """Returns a repair with as few taken out: of several, the most important first, each for which there is a place with all that stay."""
    for label in [piece.label for piece in repair.pieces if piece.label in repair.unplaced]:
        gone = tuple(other for other in repair.unplaced if other != label)
        if not gone or is_call_spent():
            break
        trial = replace(repair.problem, room=without(repair.asked, gone), settings=replace(repair.problem.settings, remove=False))
        pieces, arrangement = _placed(trial, ())
        found = RoomRepair(trial, written_back(trial, arrangement.placed), trial.room, pieces, _labels_left_out(arrangement))
        found = until_nothing_changes(found) if found.unplaced else found
        if not found.unplaced and (arrangement.left_out or is_repaired(trial, arrangement)):
            repair = replace(repair, room=found.room, unplaced=gone)
    return repair


def unchanged(problem: RoomProblem) -> RoomRepair:
    """Returns a room that needs no repair."""
    return RoomRepair(problem, problem.room, problem.room)


def until_nothing_changes(repair: RoomRepair) -> RoomRepair:
    """Returns a repair as a further repair would leave it: repeated until nothing changes, or else the room as sent.

    Where the call's work is spent, it stays as the best of them.
    """
    settled, best = replace(repair.problem, room=repair.room, settings=replace(repair.problem.settings, previous={})), repair
    rounds = ROUNDS
    while rounds and not is_call_spent():
        _, arrangement = _placed(settled, repair.misplaced)
        if is_call_spent():
            break
        last = replace(repair, room=written_back(settled, arrangement.placed), unplaced=_labels_left_out(arrangement))
        if last.room == settled.room:
            return last
        is_better = len(last.unplaced) < len(best.unplaced) and (last.unplaced != () or is_repaired(settled, arrangement))
        best, rounds = (last, ROUNDS) if is_better else (best, rounds - 1)
        settled = replace(settled, room=last.room)
    return best if is_call_spent() else replace(repair, room=repair.asked)


def unreached_in(repair: RoomRepair, errors: Sequence[Issue]) -> tuple[str, ...]:
    """Returns which pieces of a repaired room stand but cannot all be used, by what the validator says of it."""
    labels = {piece.label for piece in pieces_as_sent(replace(repair.problem, room=repair.sound))}
    return tuple(label for issue in errors if issue.rule == "unreachable" for label in issue.ids if label in labels)


def _misplaced(problem: RoomProblem) -> dict[str, str]:
    """Says of bodies that are locked outside the room, far from their wall, or out of reach by themselves, what is wrong with them."""
    locked = holders(problem.room, problem.settings)
    found: dict[str, list[str]] = {}
    for issue in problem.errors:
        if issue.rule in ("out_of_bounds", "wall_far") and set(issue.ids) <= locked.keys():
            found.setdefault(issue.ids[0], []).append(issue.message)
    shut = {label: [f"nobody can get to {label} where it stands"] for label in _out_of_reach(problem, locked.keys() - found.keys())}
    return {label: " and ".join(messages) for label, messages in (found | shut).items()}


def _out_of_reach(problem: RoomProblem, locked: Set[str]) -> list[str]:
    """Returns the labels of those pieces that nobody could use, where they are locked, with nothing else in the room."""
    if not locked or not _is_walked_in(problem):
        return []
    budget = Budget(problem.settings.work / WORK_SHARE)
    used = [piece for piece in pieces_as_sent(problem) if piece.label in locked and piece.stands and not piece.candidates[0].attach]
    return [piece.label for piece in used if not can_be_used(problem.space, [piece], budget)]


def _placed(problem: RoomProblem, misplaced: Collection[str]) -> tuple[Sequence[Piece], Arrangement]:
    """Places a room's pieces; nobody has to reach those that are misplaced; where these leave no way, as if they were not there."""
    pieces = _used(problem, misplaced)
    arrangement = least_moved_from_last(problem, pieces)
    if arrangement.left_out and misplaced:
        gone = with_relying(pieces, misplaced)
        pieces = tuple(piece for piece in pieces if piece.label not in gone)
        arrangement = least_moved_from_last(problem, pieces)
    if not is_whole(arrangement) and _is_walked_in(problem):
        arrangement = without_fewest(problem.space, pieces, problem.settings.work) or arrangement
    return pieces, arrangement


def _used(problem: RoomProblem, misplaced: Collection[str]) -> tuple[Piece, ...]:
    return tuple(replace(piece, stands=()) if piece.label in misplaced else piece for piece in pieces_as_sent(problem))


def is_repaired(problem: RoomProblem, arrangement: Arrangement) -> bool:
    """Tells whether all pieces of a room stand and can be used, or at least stand where nobody can walk in it anyway."""
    return is_whole(arrangement) or not (arrangement.left_out or _is_walked_in(problem))


def _labels_left_out(arrangement: Arrangement) -> tuple[str, ...]:
    return tuple(label for label, _ in arrangement.left_out)


def _is_walked_in(problem: RoomProblem) -> bool:
    return problem.settings.walk and walkable_when_empty(problem.space)


WORK_SHARE = 4
"""Of what an attempt at the whole room may cost a trial may cost this part."""


def without_fewest(space: Space, pieces: Sequence[Piece], work: float) -> Arrangement | None:
    """Returns an arrangement, walkable, of all pieces but a few in the way; None where leaving out all that may be moved does not do.

    Of those in the way, the least important first, as many go as it takes; less those before the last of them that need not go. `work` is
    what one attempt at the whole room may cost, in QPs of a small room.
    """
    blamed = in_the_way(space, pieces)
    order = tuple(piece.label for piece in reversed(pieces) if piece.label in blamed)
    return _Trials(space, pieces, work / WORK_SHARE).answer(order) if order else None


class _Trials:
    """Sets of pieces to leave out, each tried once. Where one does not help, none of its parts is taken to help."""

    def __init__(self, space: Space, pieces: Sequence[Piece], work: float) -> None:
        self.space, self.pieces, self.work = space, pieces, work
        self._helps: dict[tuple[str, ...], bool] = {}

    def answer(self, order: tuple[str, ...]) -> Arrangement | None:
        """Leaves out a few of these and moves the others least; a set with which that does not succeed counts as no help.

        Without the least important one the others are looked for thoroughly: most rooms need no more, and it often finds a place again.
        """
        if answer := self._placed_without(order[:1]):
            return answer
        self._helps[order[:1]] = False
        while (gone := self._few(order)) is not None:
            if answer := self._placed_without(gone):
                return answer
            self._helps[gone] = False
        return None

    def _few(self, order: tuple[str, ...]) -> tuple[str, ...] | None:
        """Returns some of these that help, none of which can stay: those that stand first in order, else the most important, stay out."""
        if not self._without(order):
            return None
        last = _least(1, len(order), lambda count: self._without(order[:count]))
        count = _least(0, last, lambda count: self._without(order[last - count : last]))
        few = order[last - count : last]
        for label in few[-2:0:-1]:
            fewer = tuple(one for one in few if one != label)
            few = fewer if self._without(fewer) else few
        return few

    def _without(self, labels: tuple[str, ...]) -> bool:
        """Tells whether all others can be used without these."""
        if labels not in self._helps:
            self._helps[labels] = not is_call_spent() and can_be_used(self.space, self._others(labels), Budget(self.work))
        return self._helps[labels]

    def _others(self, labels: tuple[str, ...]) -> list[Piece]:
        gone = with_relying(self.pieces, labels)
        return [piece for piece in self.pieces if piece.label not in gone]

    def _placed_without(self, labels: tuple[str, ...]) -> Arrangement | None:
        """Places all but these, and what stands only with them, with least movement; None where that finds no place for all."""
        others = self._others(labels)
        answer = least_moved(self.space, others, Budget(self.work))
        there = {piece.label for piece in others}
        left_out = tuple((piece.label, "no place was found for it beside the others") for piece in self.pieces if piece.label not in there)
        return replace(answer, left_out=left_out, proven=False, best=False) if is_whole(answer) else None


def _least(low: int, high: int, helps: Callable[[int], bool]) -> int:
    """Returns the least number above `low`, which does not help, that does, if `high` helps and helping is monotone."""
    while high - low > 1:
        middle = min(max(2 * low, 1), (low + high) // 2)
        low, high = (low, middle) if helps(middle) else (middle, high)
    return high


def is_whole(answer: Arrangement) -> bool:
    """Tells whether all stand and can be used."""
    return not answer.left_out and not answer.notes


JUMP_COST = 0.2
"""What it costs that a neighbour of the dragged piece goes elsewhere than near its last pose: as much as moving it by 45 cm."""
JUMP_SHARE = 0.1
"""What it costs besides, as a share of the cost: where much is in the way, little is gained by it."""
LIVE_WORK = 60_000.0
"""Work each attempt near the last answer may cost, in QPs of a small room: about 60 ms."""


def least_moved(space: Space, pieces: Sequence[Piece], budget: Budget) -> Arrangement:
    """Places pieces with least movement."""
    return move_least(space, pieces, budget).arrangement


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
    near = last.near()
    if near is None or (is_whole(free) and not last.jumped(free)):
        return free
    answers = (least_moved(space, near, Budget(work)), free)
    return min(answers, key=lambda answer: (len(answer.left_out), len(answer.notes), _cost(answer, last)))


def _cost(answer: Arrangement, last: LastAnswer) -> float:
    jumps = len(last.jumped(answer))
    return answer.cost * (1 + JUMP_SHARE * jumps) + JUMP_COST * jumps
