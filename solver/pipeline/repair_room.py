"""One broken room -> the same room repaired, and what of it could not be: `RoomProblem` -> `RoomRepair`.

Not here: which rooms are broken (fix), why something cannot stand (conflicts).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from solver.answers import Issue
from solver.pieces import Arrangement, Piece
from solver.pipeline.fewest import is_whole, without_fewest
from solver.pipeline.least_movement import least_moved_from_last
from solver.placement import is_call_spent, walkable_when_empty
from solver.repair import RoomProblem, holders, pieces_as_sent, without, written_back
from solver.scene import Room

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
    room = written_back(trial, arrangement.placed)
    found = RoomRepair(problem, room, asked, pieces, _labels_left_out(arrangement), misplaced)
    return found if found.whole or problem.settings.remove else until_nothing_changes(found)


def unchanged(problem: RoomProblem) -> RoomRepair:
    """Returns a room that needs no repair."""
    return RoomRepair(problem, problem.room, problem.room)


def until_nothing_changes(repair: RoomRepair) -> RoomRepair:
    """Returns a repair as a further repair would leave it: repeated until nothing changes, or else the room as sent.

    Where the call's work is spent, it stays as the best of them.
    """
    settled, best = replace(repair.problem, room=repair.room, settings=replace(repair.problem.settings, previous={})), repair
    rounds = ROUNDS
    while rounds:
        if is_call_spent():
            return best
        _, arrangement = _placed(settled, repair.misplaced)
        last = replace(repair, room=written_back(settled, arrangement.placed), unplaced=_labels_left_out(arrangement))
        if last.room == settled.room:
            return last
        is_better = len(last.unplaced) < len(best.unplaced) and (last.unplaced != () or is_repaired(settled, arrangement))
        best, rounds = (last, ROUNDS) if is_better else (best, rounds - 1)
        settled = replace(settled, room=last.room)
    return replace(repair, room=repair.asked)


def unreached_in(repair: RoomRepair, errors: Sequence[Issue]) -> tuple[str, ...]:
    """Returns which pieces of a repaired room stand but cannot all be used, by what the validator says of it."""
    labels = {piece.label for piece in pieces_as_sent(replace(repair.problem, room=repair.sound))}
    return tuple(label for issue in errors if issue.rule == "unreachable" for label in issue.ids if label in labels)


def _misplaced(problem: RoomProblem) -> dict[str, str]:
    """Says of bodies that are locked outside the room, or far from their wall, what is wrong with them."""
    locked = holders(problem.room, problem.settings)
    found: dict[str, list[str]] = {}
    for issue in problem.errors:
        if issue.rule in ("out_of_bounds", "wall_far") and set(issue.ids) <= locked.keys():
            found.setdefault(issue.ids[0], []).append(issue.message)
    return {label: " and ".join(messages) for label, messages in found.items()}


def _placed(problem: RoomProblem, misplaced: Collection[str]) -> tuple[Sequence[Piece], Arrangement]:
    """Places a room's pieces; where those that are misplaced leave no way, as if they were not there."""
    pieces = pieces_as_sent(problem)
    arrangement = least_moved_from_last(problem, pieces)
    if arrangement.left_out and misplaced:
        gone = [piece for piece in pieces if piece.label in misplaced or _stands_only_with(piece, misplaced)]
        pieces = tuple(piece for piece in pieces if piece not in gone)
        arrangement = least_moved_from_last(problem, pieces)
    if not is_whole(arrangement) and _is_walked_in(problem):
        arrangement = without_fewest(problem.space, pieces, problem.settings.work) or arrangement
    return pieces, arrangement


def is_repaired(problem: RoomProblem, arrangement: Arrangement) -> bool:
    """Tells whether all pieces of a room stand and can be used, or at least stand where nobody can walk in it anyway."""
    return is_whole(arrangement) or not (arrangement.left_out or _is_walked_in(problem))


def _labels_left_out(arrangement: Arrangement) -> tuple[str, ...]:
    return tuple(label for label, _ in arrangement.left_out)


def _is_walked_in(problem: RoomProblem) -> bool:
    return problem.settings.walk and walkable_when_empty(problem.space)


def _stands_only_with(piece: Piece, parents: Collection[str]) -> bool:
    return all(way.attach is not None and way.attach.parent in parents for way in piece.candidates)
