"""Why pieces of a room cannot stand, or be used, together: a minimal conflict, in lengths, with what would help.

What would help is the cheapest changes with which the rest can stand, each of them tried. Not here: the search for a place (repair_room).
"""

from bisect import bisect
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from typing import Any

from solver.answers import Conflict
from solver.geometry import Rect
from solver.pieces import Piece, Space
from solver.pipeline.left_over import is_shut_by_itself, judged_again
from solver.pipeline.reasons import at_limit, cannot
from solver.pipeline.repair_room import RoomRepair, is_repaired, least_moved, missing_length, repair_room
from solver.placement import Budget, charge, feasible, is_call_spent, minimal_conflict, work_of_call
from solver.placement.lengths import Shortfall, centimetres, least_that, metres, sentence
from solver.repair import Body, Repair, RoomProblem, all_bodies, applied, holders, pieces_as_sent, squared, without, written_back
from solver.scene import Furniture, Room
from solver.validator import Checked

SHARE = 4
"""Why pieces are out of reach, and what helps the room as it is answered alone, may cost this part of what telling may."""

NO_WAY = {
    False: "none of the ways to stand, clear of doors and windows, leaves room for all",
    True: "wherever they stand, clear of doors and windows, some way is too narrow",
}
"""Why pieces cannot stand, or be reached, where no length says it."""


@dataclass(frozen=True)
class _Verdict:
    """Why one piece cannot stand, or be used: the conflict it is in, that in words, and which lengths are missing, where that is known.

    `proven` unless a limit ended the search for a place, or for a way.
    """

    label: str
    ids: tuple[str, ...]
    message: str
    short: Shortfall | None = None
    proven: bool = True


def conflicts_of(house: Checked, repair: RoomRepair) -> tuple[Conflict, ...]:
    """Explains what is locked wrongly, every piece that found no place, and those that stand where nobody can use them.

    Each by a minimal set that cannot stand, or be used, together; or by saying that none was found. Each repair of a room's only conflict
    leaves the room clean. Where there are several, it does so with the first of each other one: to leave out what that is about.
    """
    verdicts, settings = [*_verdicts(repair)], repair.problem.settings
    told = [Conflict(one.ids, one.message) for one in verdicts]
    if verdicts and settings.offering:
        bare, asked = house.after(replace(house.scene, dynamic=())), _asked(repair)
        budget = Budget(settings.explaining_work)
        goal = RepairGoal(bare, asked, budget, is_shut_by_itself(bare, repair.problem.room, budget))
        told = _with_repairs(goal, verdicts) or told
        if len(asked) > 1 and not all(one.repairs for one in told):
            answered = replace(goal, problems=asked[:1], budget=Budget(settings.explaining_work / SHARE))
            told = min(told, _with_repairs(answered, verdicts) or told, key=lambda some: sum(not one.repairs for one in some))
    return tuple(one for k, one in enumerate(told) if one not in told[:k])  # of two pieces the reason may be the same


def _with_repairs(goal: "RepairGoal", verdicts: Sequence[_Verdict]) -> list[Conflict]:
    """Returns the conflicts with what helps, as far as some does; none where not even to leave out what each is about helps."""
    settings = goal.problems[0].settings
    if len(verdicts) > 1 and not _helps_to_leave_all(goal, verdicts):
        return []
    walking = replace(goal, budget=Budget(settings.explaining_work / SHARE))
    kept = verdicts if settings.remove else _by_itself(walking, verdicts)
    return [Conflict(one.ids, one.message, _offered(goal, one, kept)) for one in kept]


def _leaving(one: _Verdict) -> Repair:
    return {"action": "leave_out", "id": one.label}


def _helps_to_leave_all(goal: "RepairGoal", verdicts: Sequence[_Verdict]) -> bool:
    """Tells whether to leave out what every conflict is about leaves the room clean."""
    first, *others = verdicts
    return helps(_without(goal, [one.label for one in others]), _leaving(first))


def _by_itself(goal: "RepairGoal", verdicts: Sequence[_Verdict]) -> list[_Verdict]:
    """Returns the verdicts but those of a limit that end where what the others are about is left out: these last as long as others do."""
    kept = list(verdicts)
    for one in reversed(verdicts):
        others = {other.label for other in kept} - {one.label}
        if not one.proven and others and _repaired(_without(goal, others), None) is not None:
            kept.remove(one)
    return kept


def _offered(goal: "RepairGoal", one: _Verdict, verdicts: Sequence[_Verdict]) -> tuple[Repair, ...]:
    """Returns what helps; of one of several: to leave out what it is about, and what helps where what others are about is left out.

    What would go with one of these, as it stands on that, is helped where they are unlocked.
    """
    if len(verdicts) == 1:
        return repairs_of(goal, one.ids, one.short)
    others = {other.label for other in verdicts} - {one.label}
    rest = _without(goal, others)
    if one.label not in rest.bodies:
        for other in others:
            goal = replace(goal, problems=tuple(_with(problem, {"action": "unlock", "id": other}) for problem in goal.problems))
        rest = goal
    return (_leaving(one), *(other for other in repairs_of(rest, one.ids, one.short) if other != _leaving(one)))[:HANDFUL]


def _verdicts(repair: RoomRepair) -> Iterator[_Verdict]:
    yield from _locked_wrongly(repair)
    work = repair.problem.settings.explaining_work
    asked = _WhyNot(repair, repair.pieces, Budget(work))
    known = set(repair.misplaced)
    for label, group in _by_themselves(repair):
        verdict = asked.why(group, label)
        known.update(verdict.ids)
        yield verdict
    if repair.unreached:
        pieces = pieces_as_sent(replace(repair.problem, room=repair.sound))
        asked = _WhyNot(repair, pieces, Budget(work / SHARE))
        for label in repair.unreached:
            if label not in known:
                verdict = asked.why(pieces, label, walk=True)
                known.update(verdict.ids)
                yield verdict


def _locked_wrongly(repair: RoomRepair) -> Iterator[_Verdict]:
    """Yields what is misplaced; what only the lock of another one keeps there, as that of a piece on it, goes with that one."""
    locks = holders(repair.problem.room, repair.problem.settings)
    kept: dict[str, list[str]] = {}
    for label in repair.misplaced:
        lock, *more = locks[label]
        kept.setdefault(label if more or lock not in repair.misplaced else lock, []).append(label)
    for lock, labels in kept.items():
        problems = " and ".join(repair.misplaced[label] for label in labels)
        yield _Verdict(lock, tuple(labels), f"locked where it cannot stand: {problems}")


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
        if not (piece.candidates and piece.parents <= missing):
            before = bisect(standing, at[label])
            yield label, [*placed[:before], piece, *placed[before:]]


def _asked(repair: RoomRepair) -> tuple[RoomProblem, ...]:
    """Returns the room as it is answered, with nothing taken out, and as it was sent where that differs."""
    sent = repair.problem
    return (sent,) if sent.settings.remove or repair.room == sent.room else (replace(sent, room=repair.room), sent)


def _without(goal: "RepairGoal", others: Collection[str]) -> "RepairGoal":
    """Returns what is to be made possible where some others are left out."""
    return replace(goal, problems=tuple(replace(problem, room=without(problem.room, others)) for problem in goal.problems))


@dataclass(frozen=True)
class _WhyNot:
    """Why pieces of a repaired room cannot stand, or be used, and what finding out may cost."""

    repair: RoomRepair
    pieces: Sequence[Piece]
    budget: Budget

    def why(self, group: Sequence[Piece], label: str, walk: bool = False) -> _Verdict:
        """Explains why one of the pieces cannot stand, or with `walk` be used, with a group of them: by as few as cannot be used either."""
        space, room = self.repair.problem.space, self.repair.problem.room.id
        ids = minimal_conflict(space, group, label, self.budget, walk)
        if not walk and self.repair.problem.settings.walk:
            if ids is None and not self.budget.spent:
                return self.why(group, label, walk=True)
            own = [piece for piece in group if piece.label in (ids or ())]
            fewer = minimal_conflict(space, own, label, self.budget, walk=True) if len(own) > 1 else None
            if fewer is not None and len(fewer) < len(own):
                ids, walk = fewer, True
        if ids is None:
            stands = walk and (label not in self.repair.unplaced or bool(feasible(space, group, self.budget)))
            return _Verdict(label, (label,), at_limit(self._names[label], stands, f" in {room}"), proven=False)
        members = [piece if walk else replace(piece, stands=()) for piece in self.pieces if piece.label in ids]
        stay = all(_still(piece) is not None for piece in members)
        short = None if stay else missing_length(space, members, self.budget, walk, prove=False)
        why = ("" if walk else _where_they_stay(space, members)) or (sentence(short) if short else NO_WAY[walk])
        what = f"{' and '.join(self._names[member] for member in ids)} {cannot(ids, walk, stay)} in {room}{_as_turned(members)}"
        return _Verdict(label, ids, f"{what}: {why}", short)

    @cached_property
    def _names(self) -> Mapping[str, str]:
        """What each body is called, with its size, by id."""
        return {body.id: f"{body.name.strip() or body.id} {body.width:.2f} x {body.depth:.2f} m" for body in all_bodies(self.repair.asked)}


def _as_turned(members: Sequence[Piece]) -> str:
    """Says so where a piece that may move keeps its rotation, as one that says no wall does; empty where turning it makes no difference."""
    ways = [piece.candidates for piece in members if _still(piece) is None]
    held = [way[0].size_mm for way in ways if len({one.rotation for one in way}) == 1]
    turning = any(piece.stands for piece in members) or any(width != depth for width, depth, _ in held)
    return " as turned now" if held and turning else ""


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
    """What a repair has to do: the room must break no rule in the house as it is answered, without people, but that it is `shut` by itself.

    `problems` are the room as it is answered, and as it was sent: repaired, all pieces of each must find their places.
    """

    house: Checked
    problems: tuple[RoomProblem, ...]
    budget: Budget
    shut: bool = False

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The bodies of the room that is answered, by id."""
        return {body.id: body for body in all_bodies(self.problems[0].room)}

    @property
    def locks(self) -> Mapping[str, Sequence[str]]:
        """Those of its bodies that stay as sent, with the locked ids that make it."""
        return holders(self.problems[0].room, self.problems[0].settings)


def repairs_of(goal: RepairGoal, members: Sequence[str], short: Shortfall | None) -> tuple[Repair, ...]:
    """Returns what would help a conflict's members, cheapest first: to stand free of its wall, to unlock, to turn, to shrink, to leave out.

    `short` says which lengths are missing, if that is known.
    """
    bodies, locked = goal.bodies, goal.locks
    members = [member for member in members if member in bodies]  # what ends another conflict may leave one out
    loose = [bodies[member] for member in members if member not in locked]
    leaving = [repair for member in members if (repair := _tried(goal, {"action": "leave_out", "id": member}))]
    hung = [body for body in loose if isinstance(body, Furniture) and body.wall is not None]
    moves = [_moved(goal, {"action": "move", "id": body.id, "wall": None}) for body in hung]
    unlocks = [_unlocked(goal, ids) for ids in dict.fromkeys(tuple(locked[member]) for member in members if member in locked)]
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


def _unlocked(goal: RepairGoal, ids: Sequence[str]) -> Repair | None:
    """Returns the repair that unlocks what holds a body, with the move that follows; None where several do, or where that does not help."""
    if len(ids) > 1:
        return None
    return _moved(goal, {"action": "unlock", "id": ids[0]})


def _moved(goal: RepairGoal, repair: dict[str, Any]) -> Repair | None:
    """Returns the repair with the move of its body that it leads to, or None where it does not help."""
    repaired = _repaired(goal, repair)
    if repaired is None:
        return None
    before, after = goal.bodies[repair["id"]], next(body for body in all_bodies(repaired) if body.id == repair["id"])
    return {**repair, "dx": round(after.x - before.x, 4), "dz": round(after.z - before.z, 4), "rotation": after.rotation}


def _distance(repair: Repair) -> float:
    return float(repair["dx"] ** 2 + repair["dz"] ** 2)


def helps(goal: RepairGoal, repair: Repair | None) -> bool:
    """Tells whether a repair does what it has to."""
    return repair is not None and _repaired(goal, repair) is not None


def _tried(goal: RepairGoal, repair: Repair) -> Repair | None:
    return repair if helps(goal, repair) else None


def _repaired(goal: RepairGoal, repair: Repair | None) -> Room | None:
    """Returns the first room as it is once a repair is made, if one is; None where a room does not come out clean."""
    found = None
    for problem in goal.problems:
        if goal.budget.spent or is_call_spent():
            return None
        room = _whole(_with(problem, repair) if repair else problem, goal.budget, thoroughly=found is not None)
        if room is None or not _is_clean(goal, room):
            return None
        found = found or room
    return found


def _whole(problem: RoomProblem, budget: Budget, thoroughly: bool) -> Room | None:
    """Returns a room with all pieces placed with least movement, or with `thoroughly` as /fix repairs it; None where one finds no place."""
    pieces = pieces_as_sent(problem)
    charge(PIECE_WORK * len(pieces) + BODY_WORK * len(all_bodies(problem.room)))
    arrangement = least_moved(problem.space, pieces, Budget(problem.settings.work, of=budget))
    if is_repaired(problem, arrangement):
        return written_back(problem, arrangement.placed)
    if not thoroughly:
        return None
    with work_of_call(budget.left) as call:
        repair = repair_room(problem)
    budget.left -= call.done
    return repair.room if repair.whole else None


def _is_clean(goal: RepairGoal, room: Room) -> bool:
    """Tells whether a room breaks no rule in the house but what it does empty; what floats is put to rest without moving any piece."""
    scene = goal.house.scene
    rooms = tuple(room if one.id == room.id else one for one in scene.rooms)
    errors = judged_again(goal.house, replace(scene, rooms=rooms), (room.id,), goal.budget).errors
    return not any(issue.room == room.id and issue.rule != "floating" and (issue.ids or not goal.shut) for issue in errors)


def _with(problem: RoomProblem, repair: Repair) -> RoomProblem:
    """Returns a room as it is to be repaired once a repair is made."""
    settings = problem.settings
    if repair["action"] == "unlock":
        settings = replace(settings, locked=settings.locked - {repair["id"]})
    return replace(problem, room=applied(problem.room, repair), settings=settings)


def _shrunk_by_lengths(goal: RepairGoal, short: Shortfall) -> Iterator[Repair | None]:
    """Tries to take the missing millimetres off each body of the chain, off the side that lies along it."""
    bodies = goal.bodies
    free = [length for length in short.lengths if length.label in bodies]
    for length in sorted(free, key=lambda one: -one.mm):
        repair = _shrunk(bodies[length.label], "depth" if length.is_depth else "width", short.missing_mm)
        yield _tried(goal, repair) if repair else None


def _least_shrunk(goal: RepairGoal, body: Body) -> Repair | None:
    """Bisects for the least whole centimetres that must be taken off a body's width, or else off its depth."""
    for side in ("width", "depth"):
        most = int(getattr(body, side) * 1000 * (1 - LEAST_SHARE)) // STEP_MM
        least = least_that(lambda by, side=side: helps(goal, _shrunk(body, side, by * STEP_MM)), most)  # type: ignore[misc]
        if least:
            return _shrunk(body, side, least * STEP_MM)
    return None


def _shrunk(body: Body, side: str, by_mm: int) -> Repair | None:
    size = {"width": body.width, "depth": body.depth}
    least = size[side] * LEAST_SHARE
    size[side] = round(size[side] - by_mm / 1000, 4)
    return {"action": "shrink", "id": body.id, **size} if size[side] >= least - 1e-9 else None
