"""Why pieces of a room cannot stand together: a minimal conflict, in lengths, with what would help.

Comes in: a room whose pieces did not all find a place. Goes out: Conflicts. Not here: the search for a place (attempt).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.geometry import Rect
from solver.pipeline.attempt import Terms, placed, wanted_of
from solver.pipeline.repairs import Case, repairs_of, unlocked
from solver.placement import Budget, feasible, minimal_conflict
from solver.placement.lengths import Shortfall, centimetres, metres, sentence, shortfall
from solver.repair import Body, all_bodies, holders
from solver.scene import Conflict, Issue, Room
from solver.wanted import Space, Wanted

STANDING = ("cannot stand anywhere", "cannot stand together")


@dataclass(frozen=True)
class Unplaced:
    """A room in which some pieces found no place.

    Args:
        sent: the room as sent.
        answer: the room as it will be answered.
        space: where its furniture may stand.
        wanted: its pieces, as sent.
        stuck: those without a place, or out of reach.
    """

    sent: Room
    answer: Room
    space: Space
    wanted: Sequence[Wanted]
    stuck: Sequence[str]

    @property
    def rooms(self) -> tuple[Room, ...]:
        """The room that is answered, and the room as sent where it differs."""
        return (self.answer,) if self.answer == self.sent else (self.answer, self.sent)


def conflicts_of(unplaced: Unplaced, terms: Terms, budget: Budget) -> tuple[Conflict, ...]:
    """Explains every piece that found no place: a minimal set that cannot stand together, or that none was found."""
    found = []
    for label in unplaced.stuck:
        group = [piece for piece in unplaced.wanted if piece.label == label or piece.label not in unplaced.stuck]
        found.append(_conflict(unplaced, group, label, Case(unplaced.rooms, unplaced.space, terms, _labels(group), budget)))
    return tuple(found)


def unreached(unplaced: Unplaced, terms: Terms, budget: Budget) -> tuple[Conflict, ...]:
    """Explains pieces that stand where nobody can come to use them: a minimal set that cannot be used together."""
    found: list[Conflict] = []
    case = Case(unplaced.rooms, unplaced.space, terms, _labels(unplaced.wanted), budget, walk=True)
    for label in unplaced.stuck:
        if not any(label in conflict.ids for conflict in found):
            found.append(_conflict(unplaced, unplaced.wanted, label, case))
    return tuple(found)


def _conflict(unplaced: Unplaced, group: Sequence[Wanted], label: str, case: Case) -> Conflict:
    names = names_of(unplaced.sent)
    members = minimal_conflict(unplaced.space, group, label, case.budget, case.walk)
    if members is None:
        missing = f"a way to {names[label]}, which can stand," if case.walk else f"a place for {names[label]}"
        message = f"not found: the search for {missing} in {unplaced.sent.id} ended at its limit"
        return Conflict((label,), message)
    pieces = [piece if case.walk else replace(piece, stands=()) for piece in unplaced.wanted if piece.label in members]
    short = _shortfall(unplaced.space, pieces, case)
    return Conflict(members, _message(unplaced, members, case.walk, short), repairs_of(case, members, short))


def _labels(pieces: Sequence[Wanted]) -> tuple[str, ...]:
    return tuple(piece.label for piece in pieces)


def names_of(room: Room) -> dict[str, str]:
    """Returns what every body is and its size, by id."""
    return {body.id: _name(body) for body in all_bodies(room)}


def _name(body: Body) -> str:
    return f"{body.name} {body.width:.2f} x {body.depth:.2f} m"


def _shortfall(space: Space, pieces: Sequence[Wanted], case: Case) -> Shortfall | None:
    if all(_still(piece) is not None for piece in pieces):
        return None
    budget = case.budget
    return shortfall(
        space,
        pieces,
        lambda longer, some: feasible(longer, some, budget, case.walk, prove=False),
        lambda longer, some: placed(longer, some, budget),
    )


def _message(unplaced: Unplaced, members: Sequence[str], walk: bool, short: Shortfall | None) -> str:
    names = names_of(unplaced.sent)
    alone, together = ("can stand but cannot be reached", "can stand but cannot all be reached") if walk else STANDING
    how = alone if len(members) == 1 else together
    what = f"{' and '.join(names[member] for member in members)} {how} in {unplaced.sent.id}"
    fixed = "" if walk else _where_they_stay(unplaced, members)
    if fixed:
        return f"{what}: {fixed}"
    clear = unplaced.space.clear
    floor = f"the {metres(clear.width)} x {metres(clear.depth)} m of {unplaced.sent.id}, clear of its doors and windows"
    return f"{what}: {sentence(short)}" if short else f"{what}: no one length is missing in {floor}"


def _still(piece: Wanted) -> Rect | None:
    """Returns where a piece stays, if it may stand in one place only."""
    way = piece.alternatives[0]
    return way.within if len(piece.alternatives) == 1 else None


def _where_they_stay(unplaced: Unplaced, members: Sequence[str]) -> str:
    """Says how pieces that all stay as sent are in each other's way, or in that of a door; empty where some may move."""
    rects = [_still(piece) for piece in unplaced.wanted if piece.label in members]
    still = [rect for rect in rects if rect is not None]
    if len(still) < len(rects):
        return ""
    if len(still) == 2:
        wide, deep = _shared(still[0], still[1])
        return f"both stay as sent and share {metres(wide)} x {metres(deep)} m"
    blocked = [(zone, min(_shared(still[0], zone.rect))) for zone in unplaced.space.zones if zone.rect.overlaps(still[0])]
    where = [f"{centimetres(by)} {_in_words(zone.cause)}" for zone, by in blocked]
    return f"it stays as sent, {' and '.join(where)}" if where else ""


def _in_words(cause: str) -> str:
    return "outside the outline" if cause == "outline" else f"in the floor before {cause}"


def _shared(a: Rect, b: Rect) -> tuple[int, int]:
    return min(a.x1, b.x1) - max(a.x0, b.x0), min(a.z1, b.z1) - max(a.z0, b.z0)


def locked_wrongly(room: Room, space: Space, terms: Terms, issues: Sequence[Issue]) -> tuple[Conflict, ...]:
    """Names the bodies that break a rule all by themselves where they are locked: outside the room, or far from their wall."""
    locked = holders(room, terms.wishes)
    reasons: dict[str, list[str]] = {}
    for issue in issues:
        if issue.rule in ("out_of_bounds", "wall_far") and issue.room == room.id and set(issue.ids) <= locked.keys():
            reasons.setdefault(issue.ids[0], []).append(issue.message)
    everyone = tuple(piece.label for piece in wanted_of(room, space, terms)) if reasons else ()
    found = []
    for label, messages in reasons.items():
        repair = unlocked(Case((room,), space, terms, everyone, Budget(terms.work)), label)
        repairs = (*([repair] if repair else []), {"action": "leave_out", "id": label})
        found.append(Conflict((label,), f"locked where it cannot stand: {' and '.join(messages)}", repairs))
    return tuple(found)
