"""What would help: the cheapest changes with which the rest can stand, each of them tried.

Comes in: a minimal conflict. Goes out: repairs, as docs/fix.md describes them. Not here: why it is one (conflicts).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from solver.pieces import Piece, Placed
from solver.pipeline.least_movement import least_moved
from solver.placement import Budget, charge, feasible, is_call_spent
from solver.placement.encode import kin
from solver.placement.lengths import Shortfall
from solver.repair import Body, Repair, RoomProblem, all_bodies, applied, holders, pieces_as_sent, squared
from solver.scene import Furniture

HANDFUL = 6
"""Repairs offered for a conflict, at most."""
STEP_MM = 10
"""Steps in which a piece is shrunk where no length says how much is missing."""
LEAST_SHARE = 0.6
"""A piece is not shrunk below this share of its width or depth."""
PIECE_WORK, BODY_WORK = 20.0, 2.0
"""What each piece of a conflict, and each body of its room, counts when a repair of the room is tried: all are looked at anew; measured."""


@dataclass(frozen=True)
class RepairGoal:
    """What a repair has to do.

    Args:
        problems: the room that is answered, and the room as sent: a repair must do for both.
        group: labels of the pieces that must all be able to stand.
        budget: what trying may cost.
        walk: whether they must be within reach too.
    """

    problems: tuple[RoomProblem, ...]
    group: tuple[str, ...]
    budget: Budget
    walk: bool = False

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The bodies of the room that is answered, by id."""
        return {body.id: body for body in all_bodies(self.problems[0].room)}

    @property
    def locks(self) -> Mapping[str, Sequence[str]]:
        """Those of its bodies that stay as sent, with the locked ids that make it."""
        return holders(self.problems[0].room, self.problems[0].settings)


def repairs_of(goal: RepairGoal, members: Sequence[str], short: Shortfall | None) -> tuple[Repair, ...]:
    """Returns what would help, cheapest first: what leaves all within reach, or else what lets them stand. None if none is asked."""
    if not goal.problems[0].settings.offering or goal.budget.spent:
        return ()
    walks = goal.problems[0].settings.walk and not goal.walk
    within_reach = _repairs(replace(goal, walk=True), members, short) if walks else ()
    return within_reach or _repairs(goal, members, short)


def _repairs(goal: RepairGoal, members: Sequence[str], short: Shortfall | None) -> tuple[Repair, ...]:
    """Tries to stand free of its wall, to unlock, to leave out, to turn, to shrink; stops where enough is offered."""
    bodies, locked = goal.bodies, goal.locks
    loose = [bodies[member] for member in members if member not in locked]
    moves = [_set_free(goal, body) for body in loose if isinstance(body, Furniture) and body.wall is not None]
    unlocks = [unlocked(goal, member) for member in members if member in locked]
    leaving = [repair for member in members if (repair := _tried(goal, {"action": "leave_out", "id": member}))]
    able = {repair["id"] for repair in leaving}
    loose = [body for body in loose if body.id in able]  # what does not help by leaving does not by turning or shrinking
    by_way = sorted((repair for repair in (*moves, *unlocks) if repair), key=_distance)
    room_for = HANDFUL - min(len(leaving), 2)
    others = islice((repair for repair in _smaller_changes(goal, loose, short) if repair), max(room_for - len(by_way), 0))
    return (*by_way[:room_for], *others, *leaving)[:HANDFUL]


def _smaller_changes(goal: RepairGoal, loose: Sequence[Body], short: Shortfall | None) -> Iterator[Repair | None]:
    """Tries to turn each body, then to shrink it: by the lengths that are missing where they are known, else by what does."""
    for body in loose:
        yield _tried(goal, {"action": "turn", "id": body.id, "rotation": (squared(body.rotation) + 90) % 360})
    by_lengths = False
    for repair in _shrunk_by_lengths(goal, short) if short else ():
        by_lengths |= repair is not None
        yield repair
    for body in () if by_lengths else loose:
        yield _least_shrunk(goal, body)


def unlocked(goal: RepairGoal, label: str) -> Repair | None:
    """Returns the repair that unlocks what holds a body, with the move that follows; None where that does not help."""
    ids = goal.locks[label]
    if len(ids) > 1:
        return None
    return _moved(goal, {"action": "unlock", "id": ids[0]}, label)


def _set_free(goal: RepairGoal, body: Body) -> Repair | None:
    return _moved(goal, {"action": "move", "id": body.id, "wall": None}, body.id)


def _moved(goal: RepairGoal, repair: dict[str, Any], label: str) -> Repair | None:
    """Returns the repair with the move that it leads to, or None where it does not help."""
    if not _tried(goal, repair):
        return None
    arrangement = least_moved(goal.problems[0].space, _pieces(goal, goal.problems[0], repair), goal.budget)
    placed = {one.label: one for one in arrangement.placed}
    return None if arrangement.left_out else {**repair, **_step(goal.bodies[label], placed[label])}


def _step(before: Body, after: Placed) -> dict[str, Any]:
    x, z = (after.footprint.x0 + after.footprint.x1) / 2000, (after.footprint.z0 + after.footprint.z1) / 2000
    return {"dx": round(x - before.x, 4), "dz": round(z - before.z, 4), "rotation": after.rotation}


def _distance(repair: Repair) -> float:
    return float(repair["dx"] ** 2 + repair["dz"] ** 2)


def _tried(goal: RepairGoal, repair: Repair) -> Repair | None:
    """Returns the repair if all the pieces of the goal can stand with it, in every problem of the goal."""
    if is_call_spent():
        return None
    asked: list[list[Piece]] = []
    for problem in goal.problems:
        pieces = _pieces(goal, problem, repair)
        if any(_agree(pieces, before) for before in asked):
            continue
        if not feasible(problem.space, pieces, goal.budget, goal.walk, prove=False):
            return None
        asked.append(pieces)
    return repair


def _agree(one: Sequence[Piece], other: Sequence[Piece]) -> bool:
    """Tells whether pieces differ in nothing but where they are wished, so that what one can do the other can."""
    return [_freedom(piece) for piece in one] == [_freedom(piece) for piece in other]


def _freedom(piece: Piece) -> tuple[object, ...]:
    return piece.label, piece.stands, piece.need_all, [kin(way) for way in piece.candidates]


def _pieces(goal: RepairGoal, problem: RoomProblem, repair: Repair) -> list[Piece]:
    """Returns the goal's pieces in a room with a repair applied."""
    settings = problem.settings
    charge(PIECE_WORK * len(goal.group) + BODY_WORK * len(all_bodies(problem.room)))
    if repair["action"] == "unlock":
        settings = replace(settings, locked=settings.locked - {repair["id"]})
    return list(pieces_as_sent(replace(problem, room=applied(problem.room, repair), settings=settings), goal.group))


def _shrunk_by_lengths(goal: RepairGoal, short: Shortfall) -> Iterator[Repair | None]:
    """Tries to take the missing millimetres off each body of the chain, off the side that lies along it."""
    bodies = goal.bodies
    free = [length for length in short.lengths if length.label]
    for length in sorted(free, key=lambda one: -one.mm):
        repair = _shrunk(bodies[length.label], "depth" if length.is_depth else "width", short.missing_mm)
        yield _tried(goal, repair) if repair else None


def _least_shrunk(goal: RepairGoal, body: Body) -> Repair | None:
    """Bisects for the least whole centimetres that must be taken off a body's width, or else off its depth."""
    one, others = replace(goal, problems=goal.problems[:1]), goal.problems[1:]
    for side in ("width", "depth"):
        most = int(getattr(body, side) * 1000 * (1 - LEAST_SHARE)) // STEP_MM
        least = _least(most, lambda by, side=side: _helps(one, _shrunk(body, side, by * STEP_MM)))  # type: ignore[misc]
        repair = _shrunk(body, side, least * STEP_MM) if least else None
        if repair is not None and (not others or _tried(replace(goal, problems=others), repair)):
            return repair
    return None


def _helps(goal: RepairGoal, repair: Repair | None) -> bool:
    return repair is not None and _tried(goal, repair) is not None


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
