"""Why pieces of a room cannot stand together: a minimal conflict, in lengths, with what would help.

Comes in: a room whose pieces did not all find a place. Goes out: Conflicts. Not here: the search for a place (attempt).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from solver.geometry import Rect
from solver.pipeline.attempt import Terms, placed, wanted_of
from solver.pipeline.repairs import Case, repairs_of, unlocked
from solver.placement import Budget, feasible, minimal_conflict
from solver.placement.lengths import Shortfall, centimetres, metres, sentence, shortfall
from solver.repair import Body, all_bodies, holders
from solver.scene import Conflict, Issue, Room
from solver.wanted import Space, Wanted


@dataclass(frozen=True)
class Unplaced:
    """A room in which some pieces found no place.

    Args:
        sent: the room as sent.
        answer: the room as it will be answered.
        space: where its furniture may stand.
        wanted: its pieces, as sent.
        stuck: those without a place.
    """

    sent: Room
    answer: Room
    space: Space
    wanted: Sequence[Wanted]
    stuck: Sequence[str]


def conflicts_of(unplaced: Unplaced, terms: Terms, budget: Budget) -> tuple[Conflict, ...]:
    """Explains every piece that found no place: a minimal set that cannot stand together, or that none was found."""
    found = []
    names, both = names_of(unplaced.sent), (unplaced.answer, unplaced.sent)
    rooms = both[:1] if both[0] == both[1] else both
    for label in unplaced.stuck:
        group = [piece for piece in unplaced.wanted if piece.label == label or piece.label not in unplaced.stuck]
        members = minimal_conflict(unplaced.space, group, label, budget)
        if members is None:
            message = f"not found: the search for a place for {names[label]} in {unplaced.sent.id} ended at its limit"
            found.append(Conflict((label,), message))
            continue
        short = _shortfall(unplaced, members, budget)
        case = Case(rooms, unplaced.space, terms, tuple(piece.label for piece in group), budget)
        found.append(Conflict(members, _message(unplaced, members, names, short), repairs_of(case, members, short)))
    return tuple(found)


def names_of(room: Room) -> dict[str, str]:
    """Returns what every body is and its size, by id."""
    return {body.id: _name(body) for body in all_bodies(room)}


def _name(body: Body) -> str:
    return f"{body.name} {body.width:.2f} x {body.depth:.2f} m"


def _shortfall(unplaced: Unplaced, members: Sequence[str], budget: Budget) -> Shortfall | None:
    pieces = [piece for piece in unplaced.wanted if piece.label in members]
    if all(_still(piece) is not None for piece in pieces):
        return None
    return shortfall(
        unplaced.space, pieces, lambda space, some: feasible(space, some, budget), lambda space, some: placed(space, some, budget)
    )


def _message(unplaced: Unplaced, members: Sequence[str], names: Mapping[str, str], short: Shortfall | None) -> str:
    how = "cannot stand anywhere in" if len(members) == 1 else "cannot stand together in"
    what = f"{' and '.join(names[member] for member in members)} {how} {unplaced.sent.id}"
    fixed = _where_they_stay(unplaced, members)
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
