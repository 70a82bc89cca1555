"""What would help: the cheapest changes with which the rest can stand, each of them tried.

Comes in: a minimal conflict. Goes out: repairs, as README.md describes them. Not here: why it is one (conflicts).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from solver.pipeline.attempt import Terms, placed, wanted_of
from solver.placement import Budget, feasible
from solver.placement.encode import kin
from solver.placement.lengths import Shortfall
from solver.repair import Body, all_bodies, applied, holders, squared
from solver.scene import Furniture, Room
from solver.wanted import Placed, Space, Wanted

HANDFUL = 6
"""Repairs offered for a conflict, at most."""
STEP_MM = 10
"""Steps in which a piece is shrunk where no length says how much is missing."""
LEAST_SHARE = 0.6
"""A piece is not shrunk below this share of its width or depth."""

Repair = Mapping[str, Any]


@dataclass(frozen=True)
class Case:
    """What a repair has to do.

    Args:
        rooms: the room that is answered, and the room as sent: a repair must do for both.
        space: the room's.
        terms: of the repair.
        group: labels of the pieces that must all be able to stand.
        budget: what trying may cost.
        walk: whether they must be within reach too.
    """

    rooms: tuple[Room, ...]
    space: Space
    terms: Terms
    group: tuple[str, ...]
    budget: Budget
    walk: bool = False


def repairs_of(case: Case, members: Sequence[str], short: Shortfall | None) -> tuple[Repair, ...]:
    """Returns what would help, cheapest first; where ways are kept free, what leaves all within reach, if anything does."""
    if case.terms.wishes.uses and not case.walk:
        return _repairs(replace(case, walk=True), members, short) or _repairs(case, members, short)
    return _repairs(case, members, short)


def _repairs(case: Case, members: Sequence[str], short: Shortfall | None) -> tuple[Repair, ...]:
    """Tries to stand free of its wall, to unlock, to leave out, to turn, to shrink; stops where enough is offered."""
    bodies = {body.id: body for body in all_bodies(case.rooms[0])}
    locked = holders(case.rooms[0], case.terms.wishes)
    loose = [bodies[member] for member in members if member not in locked]
    moves = [_set_free(case, body) for body in loose if isinstance(body, Furniture) and body.wall is not None]
    unlocks = [unlocked(case, member) for member in members if member in locked]
    leaving = [repair for member in members if (repair := _tried(case, {"action": "leave_out", "id": member}))]
    able = {repair["id"] for repair in leaving}
    loose = [body for body in loose if body.id in able]  # what does not help by leaving does not by turning or shrinking
    by_way = sorted((repair for repair in (*moves, *unlocks) if repair), key=_distance)
    room_for = HANDFUL - min(len(leaving), 2)
    others = islice((repair for repair in _smaller_changes(case, loose, short) if repair), max(room_for - len(by_way), 0))
    return (*by_way[:room_for], *others, *leaving)[:HANDFUL]


def _smaller_changes(case: Case, loose: Sequence[Body], short: Shortfall | None) -> Iterator[Repair | None]:
    """Tries to turn each body, then to shrink it: by the lengths that are missing where they are known, else by what does."""
    for body in loose:
        yield _tried(case, {"action": "turn", "id": body.id, "rotation": (squared(body.rotation) + 90) % 360})
    by_lengths = False
    for repair in _shrunk_by_lengths(case, short) if short else ():
        by_lengths |= repair is not None
        yield repair
    for body in () if by_lengths else loose:
        yield _least_shrunk(case, body)


def unlocked(case: Case, label: str) -> Repair | None:
    """Returns the repair that unlocks what holds a body, with the move that follows; None where that does not help."""
    ids = holders(case.rooms[0], case.terms.wishes)[label]
    if len(ids) > 1:
        return None
    return _moved(case, {"action": "unlock", "id": ids[0]}, label)


def _set_free(case: Case, body: Body) -> Repair | None:
    return _moved(case, {"action": "move", "id": body.id, "wall": None}, body.id)


def _moved(case: Case, repair: dict[str, Any], label: str) -> Repair | None:
    """Returns the repair with the move that it leads to, or None where it does not help."""
    if not _tried(case, repair):
        return None
    room = case.rooms[0]
    arrangement = placed(case.space, _wanted(case, room, repair), case.budget)
    if arrangement.left_out:
        return None
    before = next(body for body in all_bodies(room) if body.id == label)
    after = next(p for p in arrangement.placed if p.label == label)
    return {**repair, **_step(before, after)}


def _step(before: Body, after: Placed) -> dict[str, Any]:
    x, z = (after.footprint.x0 + after.footprint.x1) / 2000, (after.footprint.z0 + after.footprint.z1) / 2000
    return {"dx": round(x - before.x, 4), "dz": round(z - before.z, 4), "rotation": after.rotation}


def _distance(repair: Repair) -> float:
    return float(repair["dx"] ** 2 + repair["dz"] ** 2)


def _tried(case: Case, repair: Repair) -> Repair | None:
    """Returns the repair if all the pieces of the case can stand with it, in every room of the case."""
    asked: list[list[Wanted]] = []
    for room in case.rooms:
        wanted = _wanted(case, room, repair)
        if any(_agree(wanted, before) for before in asked):
            continue
        if not feasible(case.space, wanted, case.budget, case.walk, prove=False):
            return None
        asked.append(wanted)
    return repair


def _agree(one: Sequence[Wanted], other: Sequence[Wanted]) -> bool:
    """Tells whether pieces differ in nothing but where they are wished, so that what one can do the other can."""
    return [_freedom(piece) for piece in one] == [_freedom(piece) for piece in other]


def _freedom(piece: Wanted) -> tuple[object, ...]:
    return piece.label, piece.stands, piece.need_all, [kin(way) for way in piece.alternatives]


def _wanted(case: Case, room: Room, repair: Repair) -> list[Wanted]:
    wishes = case.terms.wishes
    if repair["action"] == "unlock":
        wishes = replace(wishes, locked=wishes.locked - {repair["id"]})
    wanted = wanted_of(applied(room, repair), case.space, replace(case.terms, wishes=wishes))
    return [piece for piece in wanted if piece.label in case.group]


def _shrunk_by_lengths(case: Case, short: Shortfall) -> Iterator[Repair | None]:
    """Tries to take the missing millimetres off each body of the chain, off the side that lies along it."""
    bodies = {body.id: body for body in all_bodies(case.rooms[0])}
    free = [length for length in short.lengths if length.label]
    for length in sorted(free, key=lambda one: -one.mm):
        repair = _shrunk(bodies[length.label], "depth" if length.is_depth else "width", short.missing_mm)
        yield _tried(case, repair) if repair else None


def _least_shrunk(case: Case, body: Body) -> Repair | None:
    """Bisects for the least whole centimetres that must be taken off a body's width, or else off its depth."""
    one = replace(case, rooms=case.rooms[:1])
    for side in ("width", "depth"):
        most = int(getattr(body, side) * 1000 * (1 - LEAST_SHARE)) // STEP_MM
        least = _least(most, lambda by, side=side: _helps(one, _shrunk(body, side, by * STEP_MM)))  # type: ignore[misc]
        repair = _shrunk(body, side, least * STEP_MM) if least else None
        if repair is not None and (len(case.rooms) == 1 or _tried(replace(case, rooms=case.rooms[1:]), repair)):
            return repair
    return None


def _helps(case: Case, repair: Repair | None) -> bool:
    return repair is not None and _tried(case, repair) is not None


def _least(most: int, helps: Callable[[int], bool]) -> int | None:
    """Returns the least number in 1 ... most that helps, if the greatest does and helping is monotone."""
    if most < 1 or not helps(most):
        return None
    low, high = 0, most
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if helps(middle) else (middle, high)
    return high


def _shrunk(body: Body, side: str, by_mm: int) -> Repair | None:
    size = {"width": body.width, "depth": body.depth}
    least = size[side] * LEAST_SHARE
    size[side] = round(size[side] - by_mm / 1000, 4)
    return {"action": "shrink", "id": body.id, **size} if size[side] >= least - 1e-9 else None
