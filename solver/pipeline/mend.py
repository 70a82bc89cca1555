"""One broken room -> the same room repaired, or the reason why not.

Comes in: a room, its space, what is locked and moved. Goes out: the room with new poses, conflicts, removals.
Not here: which rooms are broken (validate), the whole flow (fix).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from solver.geometry import to_mm
from solver.placement import arrange, feasible, minimal_conflict, settle
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


def mend_room(room: Room, space: Space, wall_thickness: float, wishes: Wishes, on_conflict: str) -> Mended:
    """Repairs one room with least movement.

    Args:
        room: as sent.
        space: where its furniture may stand.
        wall_thickness: m.
        wishes: what is locked and what was moved.
        on_conflict: "report" or "remove".
    """
    wanted = wanted_as_sent(room, to_mm(wall_thickness), wishes)
    arrangement = _solved(space, wanted)
    stuck = [label for label, _ in arrangement.left_out]
    mended = written_back(room, arrangement.placed, wishes)
    if not stuck:
        return Mended(mended)
    conflicts = _conflicts(room, space, wanted, arrangement)
    if on_conflict == "remove":
        removed = tuple({"id": label, "reason": next(c.message for c in conflicts if label in c.ids)} for label in stuck)
        return Mended(without(mended, frozenset(stuck)), conflicts, removed)
    return Mended(_settled(room, mended, space, wall_thickness, wishes), conflicts)


def _solved(space: Space, wanted: Sequence[Wanted]) -> Arrangement:
    return settle([arrange(space, wanted, walk=False)])[0]


def _settled(sent: Room, mended: Room, space: Space, wall_thickness: float, wishes: Wishes) -> Room:
    """Returns a partly repaired room that a further repair leaves alone, or the room as sent."""
    for _ in range(ROUNDS):
        again = _solved(space, wanted_as_sent(mended, to_mm(wall_thickness), wishes))
        next_room = written_back(mended, again.placed, wishes)
        if next_room == mended:
            return mended
        mended = next_room
    return sent


def _conflicts(room: Room, space: Space, wanted: Sequence[Wanted], arrangement: Arrangement) -> tuple[Conflict, ...]:
    """Explains every piece that found no place: a minimal set that cannot stand together, or that none was found."""
    placed = {p.label for p in arrangement.placed}
    sizes = {body.id: f"{body.name} {body.width:.2f} x {body.depth:.2f} m" for body in all_bodies(room)}
    conflicts = []
    for label, _ in arrangement.left_out:
        group = [piece for piece in wanted if piece.label in placed or piece.label == label]
        members = minimal_conflict(space, group, label)
        if members is None:
            message = f"not found: the search for a place for {sizes[label]} in {room.id} ended at its limit"
            conflicts.append(Conflict((label,), message))
        else:
            message = _message(room, space, [sizes[member] for member in members])
            conflicts.append(Conflict(members, message, _repairs(space, group, members)))
    return tuple(conflicts)


def _message(room: Room, space: Space, sizes: Sequence[str]) -> str:
    clear = space.clear
    floor = f"the {clear.width / 1000:.2f} x {clear.depth / 1000:.2f} m of {room.id}, clear of its doors and windows"
    how = "cannot stand anywhere in" if len(sizes) == 1 else "cannot stand together in"
    return f"{' and '.join(sizes)} {how} {floor}"


def _repairs(space: Space, group: Sequence[Wanted], members: Sequence[str]) -> tuple[Mapping[str, str], ...]:
    """Offers to turn a member by 90 degrees or to leave it out, where that lets all the others stand: each is solved."""
    turns = [
        {"action": "turn", "id": member}
        for member in members
        if feasible(space, [_turned(piece) if piece.label == member else piece for piece in group])
    ]
    removals = [
        {"action": "leave_out", "id": member} for member in members if feasible(space, [piece for piece in group if piece.label != member])
    ]
    return (*turns, *removals)


def _turned(piece: Wanted) -> Wanted:
    return replace(piece, alternatives=tuple(replace(a, rotation=(a.rotation + 90) % 360) for a in piece.alternatives))
