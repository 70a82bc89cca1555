"""One broken room -> the same room repaired, or the reason why not.

Comes in: a room, its space, what is locked and moved. Goes out: the room with new poses, conflicts, removals.
Not here: which rooms are broken (validate), the whole flow (fix).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from solver.geometry import to_mm
from solver.placement import Budget, arrange_as_wished, feasible, minimal_conflict, settle
from solver.repair import Wishes, all_bodies, wanted_as_sent, without, written_back
from solver.scene import Conflict, Room
from solver.wanted import Arrangement, Space, Wanted

ROUNDS = 3
"""Times a room that cannot be repaired whole is repaired again, until nothing changes any more."""


@dataclass(frozen=True)
class Mended:
    """The answer for one room."""

    room: Room
    conflicts: tuple[Conflict, ...] = ()
    removed: tuple[Mapping[str, str], ...] = ()


@dataclass(frozen=True)
class Terms:
    """On what terms every room of a scene is repaired.

    Args:
        wishes: what is locked and what was moved.
        wall_thickness: m.
        on_conflict: "report" or "remove".
        work: what each attempt and the explanation may cost a room, in QPs of a small room.
    """

    wishes: Wishes
    wall_thickness: float
    on_conflict: str
    work: float


def mend_room(room: Room, space: Space, terms: Terms) -> Mended:
    """Repairs one room with least movement.

    Args:
        room: as sent.
        space: where its furniture may stand.
        terms: on what terms.
    """
    wanted = _wanted(room, terms)
    arrangement = _solved(space, wanted, terms)
    stuck = [label for label, _ in arrangement.left_out]
    mended = written_back(room, arrangement.placed, terms.wishes)
    if not stuck:
        return Mended(mended)
    conflicts = _conflicts(room, space, wanted, arrangement, Budget(terms.work))
    if terms.on_conflict == "remove":
        removed = tuple({"id": label, "reason": next(c.message for c in conflicts if label in c.ids)} for label in stuck)
        return Mended(without(mended, frozenset(stuck)), conflicts, removed)
    return Mended(_settled(room, mended, space, terms), conflicts)


def _wanted(room: Room, terms: Terms) -> tuple[Wanted, ...]:
    return wanted_as_sent(room, to_mm(terms.wall_thickness), terms.wishes)


def _solved(space: Space, wanted: Sequence[Wanted], terms: Terms) -> Arrangement:
    return settle([arrange_as_wished(space, wanted, Budget(terms.work))])[0]


def _settled(sent: Room, mended: Room, space: Space, terms: Terms) -> Room:
    """Returns a partly repaired room that a further repair leaves alone, or the room as sent."""
    for _ in range(ROUNDS):
        again = _solved(space, _wanted(mended, terms), terms)
        next_room = written_back(mended, again.placed, terms.wishes)
        if next_room == mended:
            return mended
        mended = next_room
    return sent


def _conflicts(room: Room, space: Space, wanted: Sequence[Wanted], arrangement: Arrangement, budget: Budget) -> tuple[Conflict, ...]:
    """Explains every piece that found no place: a minimal set that cannot stand together, or that none was found."""
    placed = {p.label for p in arrangement.placed}
    sizes = {body.id: f"{body.name} {body.width:.2f} x {body.depth:.2f} m" for body in all_bodies(room)}
    conflicts = []
    for label, _ in arrangement.left_out:
        group = [piece for piece in wanted if piece.label in placed or piece.label == label]
        members = minimal_conflict(space, group, label, budget)
        if members is None:
            message = f"not found: the search for a place for {sizes[label]} in {room.id} ended at its limit"
            conflicts.append(Conflict((label,), message))
        else:
            message = _message(room, space, [sizes[member] for member in members])
            conflicts.append(Conflict(members, message, _repairs(space, group, members, budget)))
    return tuple(conflicts)


def _message(room: Room, space: Space, sizes: Sequence[str]) -> str:
    clear = space.clear
    floor = f"the {clear.width / 1000:.2f} x {clear.depth / 1000:.2f} m of {room.id}, clear of its doors and windows"
    how = "cannot stand anywhere in" if len(sizes) == 1 else "cannot stand together in"
    return f"{' and '.join(sizes)} {how} {floor}"


def _repairs(space: Space, group: Sequence[Wanted], members: Sequence[str], budget: Budget) -> tuple[Mapping[str, str], ...]:
    """Offers to turn a member by 90 degrees or to leave it out, where that lets all the others stand: each is solved."""
    turns = [
        {"action": "turn", "id": member}
        for member in members
        if feasible(space, [_turned(piece) if piece.label == member else piece for piece in group], budget)
    ]
    removals = [
        {"action": "leave_out", "id": member}
        for member in members
        if feasible(space, [piece for piece in group if piece.label != member], budget)
    ]
    return (*turns, *removals)


def _turned(piece: Wanted) -> Wanted:
    return replace(piece, alternatives=tuple(replace(a, rotation=(a.rotation + 90) % 360) for a in piece.alternatives))
