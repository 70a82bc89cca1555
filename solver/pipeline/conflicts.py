"""Why pieces of a room cannot stand, or be used, together: a minimal conflict, in lengths, with what would help.

Comes in: the repair of a room in which some found no place. Goes out: Conflicts. May import: every stage. Not here: the search for
a place (repair_room), what would help (repairs).
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from solver.geometry import Rect
from solver.pieces import Piece, Space
from solver.pipeline.least_movement import missing_length
from solver.pipeline.repair_room import RoomRepair
from solver.pipeline.repairs import RepairGoal, repairs_of, unlocked
from solver.placement import Budget, minimal_conflict
from solver.placement.lengths import centimetres, metres, sentence
from solver.repair import all_bodies, pieces_as_sent
from solver.scene import Conflict

WALKING_SHARE = 4
"""Why pieces are out of reach may cost this part of what telling may: it is said, not repaired."""

NO_WAY = {
    False: "none of the ways to stand, clear of doors and windows, leaves room for all",
    True: "wherever they stand, clear of doors and windows, some way is too narrow",
}
"""Why pieces cannot stand, or be reached, where no length says it."""


def conflicts_of(repair: RoomRepair) -> tuple[Conflict, ...]:
    """Explains what is locked wrongly, every piece that found no place, and those that stand where nobody can use them.

    Each by a minimal set that cannot stand, or be used, together; or by saying that none was found.
    """
    settings = repair.problem.settings
    sent = tuple(piece.label for piece in pieces_as_sent(repair.problem)) if repair.misplaced else ()
    found = [_of_a_lock(repair, sent, label, problem) for label, problem in repair.misplaced.items()]
    budget = Budget(settings.explaining_work)
    names = {body.id: f"{body.name} {body.width:.2f} x {body.depth:.2f} m" for body in all_bodies(repair.asked)}
    for label, group in _by_themselves(repair):
        found.append(_conflict(_goal(repair, group, budget), names, repair.pieces, group, label))
    if repair.unreached:
        pieces = pieces_as_sent(replace(repair.problem, room=repair.room))
        goal = replace(_goal(repair, pieces, Budget(settings.explaining_work / WALKING_SHARE)), walk=True)
        for label in repair.unreached:
            if not any(label in conflict.ids for conflict in found):
                found.append(_conflict(goal, names, pieces, pieces, label))
    return tuple(found)


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


def _of_a_lock(repair: RoomRepair, sent: tuple[str, ...], label: str, problem: str) -> Conflict:
    """Says why one of the pieces sent is locked wrongly."""
    repaired = unlocked(RepairGoal((repair.problem,), sent, Budget(repair.problem.settings.work)), label)
    repairs = (*([repaired] if repaired else []), {"action": "leave_out", "id": label})
    return Conflict((label,), f"locked where it cannot stand: {problem}", repairs)


def _goal(repair: RoomRepair, group: Sequence[Piece], budget: Budget) -> RepairGoal:
    """Returns what has to be made possible, in the room that is answered, and in the room as sent where it differs."""
    rooms = (repair.room,) if repair.room == repair.asked else (repair.room, repair.asked)
    problems = tuple(replace(repair.problem, room=room) for room in rooms)
    return RepairGoal(problems, tuple(piece.label for piece in group), budget)


def _conflict(goal: RepairGoal, names: Mapping[str, str], pieces: Sequence[Piece], group: Sequence[Piece], label: str) -> Conflict:
    """Explains why one of the room's pieces, each of which is named so, cannot stand, or be used, with a group of them."""
    sent, space = goal.problems[-1].room, goal.problems[0].space
    ids = minimal_conflict(space, group, label, goal.budget, goal.walk)
    if ids is None and not goal.walk and goal.problems[0].settings.walk:
        return _conflict(replace(goal, walk=True), names, pieces, group, label)
    if ids is None:
        missing = f"a way to {names[label]}, which can stand," if goal.walk else f"a place for {names[label]}"
        words = f"not found: the search for {missing} in {sent.id} ended at its limit"
        anew = replace(goal, budget=Budget(goal.problems[0].settings.explaining_work))
        return Conflict((label,), words, repairs_of(anew, (label,), None))
    members = [piece if goal.walk else replace(piece, stands=()) for piece in pieces if piece.label in ids]
    stay = all(_still(piece) is not None for piece in members)
    short = None if stay else missing_length(space, members, goal.budget, goal.walk, prove=False)
    why = ("" if goal.walk else _where_they_stay(space, members)) or (sentence(short) if short else NO_WAY[goal.walk])
    what = f"{' and '.join(names[member] for member in ids)} {_cannot(len(ids) == 1, goal.walk)} in {sent.id}"
    return Conflict(ids, f"{what}: {why}", repairs_of(goal, ids, short))


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
