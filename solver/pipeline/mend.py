"""One broken room -> the same room repaired, or the reason why not.

Comes in: a room, its space, what is locked and moved. Goes out: the room with new poses, conflicts, removals.
Not here: which rooms are broken (validate), the whole flow (fix).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from solver.pipeline.attempt import Terms, attempt, wanted_of
from solver.pipeline.conflicts import Unplaced, conflicts_of, locked_wrongly, unreached
from solver.placement import Budget
from solver.repair import all_bodies, without, written_back
from solver.scene import Conflict, Issue, Room
from solver.wanted import Arrangement, Space, Wanted

ROUNDS = 3
"""Times a room that cannot be repaired whole is repaired again, until nothing changes any more."""

WALKING_SHARE = 4
"""Why pieces are out of reach may cost this part of what telling may: it is said, not mended."""


@dataclass(frozen=True)
class Mended:
    """The answer for one room; `whole` if every piece found its place."""

    room: Room
    conflicts: tuple[Conflict, ...] = ()
    removed: tuple[Mapping[str, str], ...] = ()
    whole: bool = True


def mend_room(room: Room, space: Space, terms: Terms, issues: Sequence[Issue] = ()) -> Mended:
    """Repairs one room with least movement.

    Args:
        room: as sent.
        space: where its furniture may stand.
        terms: on what terms.
        issues: what the validator says of the room.
    """
    wrong = locked_wrongly(room, space, terms, issues)
    reasons = {label: conflict.message for conflict in wrong for label in conflict.ids}
    if terms.on_conflict == "report" or not wrong:
        mended = _mended(room, space, terms, frozenset(reasons))
        return replace(mended, conflicts=(*wrong, *mended.conflicts))
    fewer, removed = _taken_out(room, reasons)
    mended = _mended(fewer, space, terms)
    return replace(mended, conflicts=(*wrong, *mended.conflicts), removed=(*removed, *mended.removed))


def settle_room(sent: Room, mended: Mended, space: Space, terms: Terms) -> Mended:
    """Returns the repair of a room that still breaks a rule as a further repair leaves it."""
    return replace(mended, room=_settled(sent, mended.room, space, replace(terms, previous={}), frozenset()), whole=False)


def explain_unreached(sent: Room, mended: Mended, space: Space, terms: Terms, issues: Sequence[Issue]) -> Mended:
    """Adds to a settled repair which pieces stand but cannot be used together.

    Args:
        sent: the room as sent.
        mended: its repair.
        space: where its furniture may stand.
        terms: on what terms.
        issues: what the validator says of the repaired room.
    """
    wanted = wanted_of(mended.room, space, terms)
    labels = {piece.label for piece in wanted}
    blocked = [issue for issue in issues if issue.rule == "unreachable"]
    stuck = [label for issue in blocked for label in issue.ids if label in labels]
    if blocked and wanted and not stuck:
        stuck = [wanted[-1].label]  # nobody can walk in the room at all: whoever comes last closes it
    conflicts = unreached(Unplaced(sent, mended.room, space, wanted, stuck), terms, Budget(terms.telling / WALKING_SHARE))
    return replace(mended, conflicts=(*mended.conflicts, *conflicts))


def _mended(room: Room, space: Space, terms: Terms, wrong: frozenset[str] = frozenset()) -> Mended:
    """Repairs a room around those who are wrong where they are locked; where they leave no way, as if they were not there."""
    wanted, arrangement = _attempt(room, space, terms, wrong)
    stuck = [label for label, _ in arrangement.left_out]
    mended = written_back(room, arrangement.placed, terms.wishes)
    if not stuck and not wrong:
        return Mended(mended)
    answer = _settled(room, mended, space, replace(terms, previous={}), wrong)
    conflicts = conflicts_of(Unplaced(room, answer, space, wanted, stuck), terms, Budget(terms.telling))
    if terms.on_conflict == "remove":
        reasons = {label: next(c.message for c in conflicts if label in c.ids) for label in stuck}
        fewer, removed = _taken_out(mended, reasons)
        return Mended(fewer, conflicts, removed, whole=not conflicts)
    return Mended(answer, conflicts, whole=False)


def _attempt(room: Room, space: Space, terms: Terms, wrong: frozenset[str]) -> tuple[Sequence[Wanted], Arrangement]:
    wanted = wanted_of(room, space, terms)
    arrangement = attempt(space, wanted, terms)
    if arrangement.left_out and wrong:
        wanted = tuple(piece for piece in wanted if piece.label not in wrong and not _only_with(piece, wrong))
        arrangement = attempt(space, wanted, terms)
    return wanted, arrangement


def _only_with(piece: Wanted, parents: frozenset[str]) -> bool:
    return all(way.attach is not None and way.attach.parent in parents for way in piece.alternatives)


def _taken_out(room: Room, reasons: Mapping[str, str]) -> tuple[Room, tuple[Mapping[str, str], ...]]:
    """Takes bodies out with all they carry, and says so of every one of them."""
    fewer = without(room, frozenset(reasons))
    kept = {body.id for body in all_bodies(fewer)}
    gone = [body.id for body in all_bodies(room) if body.id not in kept]
    carried = "what carries it was removed"
    return fewer, tuple({"id": label, "reason": reasons.get(label, carried)} for label in gone)


def _settled(sent: Room, mended: Room, space: Space, terms: Terms, wrong: frozenset[str]) -> Room:
    """Returns a partly repaired room that a further repair leaves alone, or the room as sent."""
    for _ in range(ROUNDS):
        _, again = _attempt(mended, space, terms, wrong)
        next_room = written_back(mended, again.placed, terms.wishes)
        if next_room == mended:
            return mended
        mended = next_room
    return sent
