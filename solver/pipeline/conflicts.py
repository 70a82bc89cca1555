"""Why pieces of a room cannot stand, or be used, together: a minimal conflict, in lengths, with what would help.

Not here: the search for a place (repair_room), what would help (repairs).
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from solver.answers import Conflict
from solver.geometry import Rect
from solver.pieces import Piece, Space
from solver.pipeline.least_movement import missing_length
from solver.pipeline.repair_room import RoomRepair
from solver.pipeline.repairs import HANDFUL, RepairGoal, helps, repairs_of
from solver.placement import Budget, minimal_conflict
from solver.placement.lengths import Shortfall, centimetres, metres, sentence
from solver.repair import Repair, RoomProblem, all_bodies, pieces_as_sent, without
from solver.validator import Checked

WALKING_SHARE = 4
"""Why pieces are out of reach may cost this part of what telling may: it is said, not repaired."""

NO_WAY = {
    False: "none of the ways to stand, clear of doors and windows, leaves room for all",
    True: "wherever they stand, clear of doors and windows, some way is too narrow",
}
"""Why pieces cannot stand, or be reached, where no length says it."""


@dataclass(frozen=True)
class _Verdict:
    """Why one piece cannot stand, or be used: the conflict it is in, that in words, and which lengths are missing, where that is known."""

    label: str
    ids: tuple[str, ...]
    message: str
    short: Shortfall | None = None


def conflicts_of(house: Checked, repair: RoomRepair) -> tuple[Conflict, ...]:
    """Explains what is locked wrongly, every piece that found no place, and those that stand where nobody can use them.

    Each by a minimal set that cannot stand, or be used, together; or by saying that none was found. Each repair of a room's only conflict
    leaves the room clean. Where there are several, it does so with the first of each other one: to leave out what that is about.
    """
    verdicts = [*_verdicts(repair)]
    offered = _offered(house, repair, verdicts) if verdicts and repair.problem.settings.offering else [()] * len(verdicts)
    return tuple(Conflict(one.ids, one.message, repairs) for one, repairs in zip(verdicts, offered, strict=True))


def _offered(house: Checked, repair: RoomRepair, verdicts: Sequence[_Verdict]) -> list[tuple[Repair, ...]]:
    """Returns what is offered for each conflict; nothing where to leave out what every one is about does not leave the room clean."""
    bare, work = house.after(replace(house.scene, dynamic=())), repair.problem.settings.explaining_work
    goal = RepairGoal(bare, _asked(repair), Budget(work))
    if len(verdicts) == 1:
        return [repairs_of(goal, verdicts[0].ids, verdicts[0].short)]
    every, offered = frozenset(one.label for one in verdicts), list[tuple[Repair, ...]]()
    for one in verdicts:
        leaving: Repair = {"action": "leave_out", "id": one.label}
        rest = _without(goal, every - {one.label})
        if not offered and not helps(rest, leaving):
            return [()] * len(verdicts)
        offered.append((leaving, *(other for other in repairs_of(rest, one.ids, one.short) if other != leaving))[:HANDFUL])
    return offered


def _verdicts(repair: RoomRepair) -> Iterator[_Verdict]:
    for label, problem in repair.misplaced.items():
        yield _Verdict(label, (label,), f"locked where it cannot stand: {problem}")
    work = repair.problem.settings.explaining_work
    asked = _WhyNot(repair, repair.pieces, Budget(work))
    known = set(repair.misplaced)
    for label, group in _by_themselves(repair):
        verdict = asked.why(group, label)
        known.update(verdict.ids)
        yield verdict
    if repair.unreached:
        pieces = pieces_as_sent(replace(repair.problem, room=repair.sound))
        asked = _WhyNot(repair, pieces, Budget(work / WALKING_SHARE))
        for label in repair.unreached:
            if label not in known:
                verdict = asked.why(pieces, label, walk=True)
                known.update(verdict.ids)
                yield verdict


def _by_themselves(repair: RoomRepair) -> Iterator[tuple[str, list[Piece]]]:
    """Yields who found no place for a reason of its own, and with whom it does not stand: itself and all that did, as they are sorted.

    What stands only with one that found none goes with that one.
    """
    missing = set(repair.unplaced)
    at = {piece.label: k for k, piece in enumerate(repair.pieces)}
    standing = [k for k, piece in enumerate(repair.pieces) if piece.label not in missing]
    placed = [repair.pieces[k] for k in standing]
    for label in repair.unplaced:
        piece = repair.pieces[at[label]]
        parents = {way.attach.parent if way.attach else None for way in piece.candidates}
        if not (parents and parents <= missing):
            before = bisect(standing, at[label])
            yield label, [*placed[:before], piece, *placed[before:]]


def _asked(repair: RoomRepair) -> tuple[RoomProblem, ...]:
    """Returns the room as it is answered, with nothing taken out, and as it was sent where that differs."""
    sent = repair.problem
    return (sent,) if sent.settings.remove or repair.room == sent.room else (replace(sent, room=repair.room), sent)


def _without(goal: RepairGoal, others: Collection[str]) -> RepairGoal:
    """Returns what is to be made possible where some others are left out."""
    return replace(goal, problems=tuple(replace(problem, room=without(problem.room, others)) for problem in goal.problems))


@dataclass(frozen=True)
class _WhyNot:
    """Why pieces of a repaired room cannot stand, or be used, and what finding out may cost."""

    repair: RoomRepair
    pieces: Sequence[Piece]
    budget: Budget

    def why(self, group: Sequence[Piece], label: str, walk: bool = False) -> _Verdict:
        """Explains why one of the pieces cannot stand, or with `walk` be used, with a group of them."""
        space, room = self.repair.problem.space, self.repair.problem.room.id
        ids = minimal_conflict(space, group, label, self.budget, walk)
        if ids is None and not walk and self.repair.problem.settings.walk:
            return self.why(group, label, walk=True)
        if ids is None:
            missing = f"a way to {self._names[label]}, which can stand," if walk else f"a place for {self._names[label]}"
            return _Verdict(label, (label,), f"not found: the search for {missing} in {room} ended at its limit")
        members = [piece if walk else replace(piece, stands=()) for piece in self.pieces if piece.label in ids]
        stay = all(_still(piece) is not None for piece in members)
        short = None if stay else missing_length(space, members, self.budget, walk, prove=False)
        why = ("" if walk else _where_they_stay(space, members)) or (sentence(short) if short else NO_WAY[walk])
        what = f"{' and '.join(self._names[member] for member in ids)} {_cannot(len(ids) == 1, walk)} in {room}"
        return _Verdict(label, ids, f"{what}: {why}", short)

    @cached_property
    def _names(self) -> Mapping[str, str]:
        """What each body is called, with its size, by id."""
        return {body.id: f"{body.name.strip() or body.id} {body.width:.2f} x {body.depth:.2f} m" for body in all_bodies(self.repair.asked)}


def _cannot(alone: bool, walk: bool) -> str:
    if walk:
        return "can stand but cannot be reached" if alone else "can stand but cannot all be reached"
    return "cannot stand anywhere" if alone else "cannot stand together"


def _still(piece: Piece) -> Rect | None:
    """Returns where a piece stays, if it may stand in one place only."""
    way = piece.candidates[0]
    return way.within if len(piece.candidates) == 1 else None


def _where_they_stay(space: Space, members: Sequence[Piece]) -> str:
    """Says how pieces that all stay as sent are in each other's way, or in that of a door; empty where some may move."""
    still = [rect for rect in map(_still, members) if rect is not None]
    if len(still) < len(members):
        return ""
    if len(still) == 2:
        shared = still[0].common(still[1])
        return f"both stay as sent and share {metres(shared.width)} x {metres(shared.depth)} m"
    blocked = [(zone.cause, still[0].common(zone.rect)) for zone in space.zones if zone.rect.overlaps(still[0])]
    where = [f"{centimetres(min(shared.width, shared.depth))} {_in_words(cause)}" for cause, shared in blocked]
    return f"it stays as sent, {' and '.join(where)}" if where else ""


def _in_words(cause: str) -> str:
    return "outside the outline" if cause == "outline" else f"in the floor before {cause}"
