"""place(): a room of the user's own and a list of pieces -> the best placement, or several, or the reason why not."""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import TypeAlias

from catalogs import Catalogs, load_catalogs
from solver.answers import Conflict
from solver.errors import RequestError
from solver.pieces import Piece, with_relying
from solver.pipeline.place_task import PlaceSetting, PlaceTask, first_copies, task_of, without_partings, without_wishes
from solver.pipeline.reasons import at_limit
from solver.pipeline.rounds import (
    Round,
    best_placement,
    other_placements,
    quick_placement,
    thorough_placement,
    walked_placement,
    with_fronts_open,
)
from solver.pipeline.timing import Clock, Timing
from solver.placement import ROOM_WORK, Budget, feasible, is_call_spent, minimal_conflict
from solver.requested import MOST_ALTERNATIVES, Answered, PieceRequest, Placement, labels_by_name
from solver.scene import ROBOT_WIDTH, Room
from solver.scene_bodies import check_is

Asking: TypeAlias = Callable[[Sequence[PieceRequest]], PlaceTask]
"""Makes the task of other requests for the same room."""


MOST_FIRM = 4
"""How many of those left out are asked for with all that comes before them in the list."""
MOST_FREED = 6
"""Relations of a piece without a place that are left out in turn, to say which keeps it from one."""


def place(  # noqa: PLR0913 - keyword-only options of a public function
    room: Room,
    pieces: Sequence[PieceRequest],
    *,
    alternatives: int = 1,
    wall_thickness: float = 0.0,
    robot_width: float = ROBOT_WIDTH,
    height: float | None = None,
    catalogs: Catalogs | None = None,
    engine: str = "osqp",
    clock: Clock | None = None,
) -> Answered:
    """Places a list of pieces in a room.

    Args:
        room: its openings and outline count; what stands in it already stays and is in the way.
        pieces: what is wanted, most important first.
        alternatives: how many placements, at most; they differ in a wall, a rotation or clearly in a place.
        wall_thickness: of the room's walls, m.
        robot_width: side, m, of the square that must be able to walk everywhere.
        height: of the room, m; by default it is not known, and nothing is too high.
        catalogs: whose kinds are known; ours by default.
        engine: who confirms the optimum, "osqp" or "reference".
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        RequestError: a field of the request is wrong.

    Example:
        >>> from compose_homes import RelationSpec, Room, PieceRequest, place
        >>> shelf = PieceRequest("shelf", "bookshelf", relations=(RelationSpec(type="in_corner"),))
        >>> answer = place(Room("den", width=4, depth=3.5), [shelf])
        >>> [(held.piece, held.type, held.held) for held in answer.best.relations]
        [('shelf', 'in_corner', True)]
    """
    check_is("room", room, Room, "a Room", RequestError)
    check_is("alternatives", alternatives, int, f"a whole number from 1 to {MOST_ALTERNATIVES}", RequestError)
    for field, given in (("wall_thickness", wall_thickness), ("robot_width", robot_width), ("height", height or 0.0)):
        check_is(field, given, (int, float), "a number of metres", RequestError)
    if not 1 <= alternatives <= MOST_ALTERNATIVES:
        raise RequestError("alternatives", f"is {alternatives}", f"a whole number from 1 to {MOST_ALTERNATIVES}")
    timing = Timing(clock)
    setting = PlaceSetting(wall_thickness, robot_width, engine, height)
    in_room = partial(task_of, room, catalogs=catalogs or load_catalogs())
    task = in_room(pieces, setting=setting)
    timing.lap("furnish")
    task, found = _placed(in_room, task, pieces)
    found, best = with_fronts_open(task, found)
    timing.lap("placement")
    others = other_placements(task, found, alternatives - 1)
    timing.lap("alternatives")
    if found.score[0]:  # what a distance from the walls, or its habit to stand at them, keeps out has a place
        task = in_room(pieces, setting=setting._replace(flush=True, roaming=_bound(pieces)))
    conflicts = _conflicts(task, best, found, partial(in_room, setting=task.setting))
    timing.lap("reasons")
    return Answered(best, tuple(others), conflicts, timing.ms, task.understood_as)


def _placed(in_room: Callable[..., PlaceTask], task: PlaceTask, pieces: Sequence[PieceRequest]) -> tuple[PlaceTask, Round]:
    """Returns the best placement, and the task that it solves.

    Where not all can stand it counts what matters most: before all, that of the list which is required and was left out first. Where one
    cannot, no distance from the walls counts, then that what has to stand by something may do so free of walls, then no wish, and at last
    they stand where a proof finds that all can be come to.
    """
    found = best_placement(task, task.pieces)
    if found.arrangement.left_out and not is_call_spent():
        listed = in_room(pieces, setting=task.setting._replace(flush=found.score[0] > 0), as_sent=True)
        other = best_placement(listed, listed.pieces, quick=True)
        if other.score[:3] <= found.score[:3]:
            task, found = listed, thorough_placement(listed, other)
    first, (task, found) = found, _first_of_the_list(in_room, task, found, pieces)
    if found is not first:
        found = replace(thorough_placement(task, found), whole=False)
    gone = {label for label, _ in found.arrangement.left_out}
    apart = [without_partings(request, gone) for request in pieces]
    if apart != [*pieces] and not is_call_spent():
        listed = replace(in_room(apart, setting=task.setting, as_sent=True), requests=task.requests)
        other = quick_placement(listed, listed.pieces)
        if other.score < found.score and not other.breaking:
            task, found = listed, replace(other, whole=False)
    setting = task.setting._replace(flush=True, roaming=_bound(pieces))
    if found.score[0] and setting.roaming and not is_call_spent():
        listed = in_room(pieces, setting=setting)
        other = best_placement(listed, listed.pieces, quick=True)
        if other.score[0] < found.score[0]:
            task, found = listed, replace(thorough_placement(listed, other), whole=False)
    if found.score[0] and not is_call_spent():
        bare = in_room([without_wishes(piece) for piece in pieces], setting=setting)
        other = best_placement(bare, bare.pieces, quick=True)
        other = walked_placement(bare) or other if other.score[0] and not is_call_spent() else other
        if not other.score[0]:
            return replace(bare, requests=task.requests), replace(other, whole=False)
    return task, found


def _first_of_the_list(
    in_room: Callable[..., PlaceTask], task: PlaceTask, found: Round, pieces: Sequence[PieceRequest]
) -> tuple[PlaceTask, Round]:
    """Returns the better one of a placement and those in which what was left out of it stands with all that comes before it in the list.

    Each is asked for with those before it that stand, all later ones only if they find a place; optional pieces after the required ones,
    and at last all of them together that are still left out.
    """
    best, last, held, tries = (task, found), found, set[str](), 0
    for piece in sorted(pieces, key=lambda one: not one.required):
        gone = {label for label, _ in last.arrangement.left_out}
        if not gone or tries == MOST_FIRM or is_call_spent():
            break
        if gone.isdisjoint(piece.labels):
            held.add(piece.id)
        elif {*held, piece.id} != {one.id for one in pieces if one.required}:  # that was tried
            tries += 1
            if (other := _with_these(in_room, task, pieces, {*held, piece.id})) is not None:
                held.add(piece.id)
                best, last = min(best, other, key=lambda one: one[1].score), other[1]
    gone = {label for label, _ in best[1].arrangement.left_out}
    optional = {one.id for one in pieces if not one.required and not gone.isdisjoint(one.labels)}
    if len(optional) > 1 and not is_call_spent():
        others = {one.id for one in pieces if one.required and gone.isdisjoint(one.labels)}
        best = min(best, _with_these(in_room, task, pieces, optional | others) or best, key=lambda one: one[1].score)
    return best


def _with_these(
    in_room: Callable[..., PlaceTask], task: PlaceTask, pieces: Sequence[PieceRequest], firm: Collection[str]
) -> tuple[PlaceTask, Round] | None:
    """Returns a placement of a list in which those stand, all others only if they find a place; None where one of those does not."""
    asked = [replace(one, required=one.id in firm) for one in pieces]
    listed = replace(in_room(asked, setting=task.setting, as_sent=True), requests=task.requests)
    found = best_placement(listed, listed.pieces, quick=True)
    gone = {label for label, _ in found.arrangement.left_out}
    return (listed, replace(found, whole=False)) if all(gone.isdisjoint(one.labels) for one in asked if one.required) else None


def _bound(pieces: Sequence[PieceRequest]) -> frozenset[str]:
    """Returns the ids of pieces of which a relation must hold."""
    return frozenset(piece.id for piece in pieces if any(spec.required for spec in piece.relations))


def _conflicts(task: PlaceTask, placement: Placement, found: Round, asked: Asking) -> tuple[Conflict, ...]:
    """Explains every required piece that found no place: a minimal set that cannot stand together, or that none was found."""
    missing = [entry.id for entry in placement.unplaced]
    called = first_copies(task.requests, found.arrangement)
    given_up = {called.get(label, label) for label in with_relying((one for one in task.pieces if one.candidates), found.given_up)}
    required = [piece for piece in task.pieces if piece.required]
    before = {piece.label: {one.label for one in task.pieces[:k]} & {*missing} for k, piece in enumerate(task.pieces)}
    conflicts, budget = [], Budget(ROOM_WORK)
    for piece in required:
        if piece.label in given_up:
            words = _not_held(_sized(task, piece), _without_which(task, asked, found, piece.label))
            conflicts.append(Conflict((piece.label,), words, (_leaving_out(piece.label),)))
        elif piece.label in missing and (parents := _asked_beside(task, piece.label, before[piece.label])):
            words = f"{_sized(task, piece)} is asked for in relation to {' or '.join(parents)}, for which there is no place"
            conflicts.append(Conflict((piece.label,), words, (_leaving_out(piece.label),)))
        elif piece.label in missing:
            others = [other for other in required if other.label not in missing or other is piece]
            conflicts.append(_conflict(task, asked, others, piece, budget, found))
    return tuple(conflicts)


def _asked_beside(task: PlaceTask, label: str, missing: set[str]) -> Sequence[str]:
    """Returns the pieces that a required relation of a piece is to, where all of them are missing."""
    labels = labels_by_name(task.room, task.requests)
    rules = [rule for request in task.requests if label in request.labels for rule in request.relations if rule.required]
    others = [[one for name in rule.of if name in labels for one in labels[name] if one != label] for rule in rules]
    return next((names for names in others if names and missing.issuperset(names)), ())


def _conflict(  # noqa: PLR0913, PLR0917 - what was asked, and what came of it
    task: PlaceTask, asked: Asking, pieces: Sequence[Piece], missing: Piece, budget: Budget, found: Round
) -> Conflict:
    """Explains a piece by the fewest that cannot stand, or be reached, together; each without which all others are reached may be left out.

    Where they can as soon as no relation holds them, no more is known than that no place was found: not every place where a relation holds
    is tried.
    """
    members, walk = _fewest(task, pieces, missing.label, budget)
    sent, related, held, bound = task, task.listing.space, pieces, _bound(task.requests)
    if members and missing.label not in members:  # those stand in the answer: not every place where a relation holds is tried
        task = asked([replace(one, relations=()) for one in task.requests])
        pieces = [piece for piece in task.pieces if piece.label in {one.label for one in held}]
        members, walk = _fewest(task, pieces, missing.label, budget)
        members, walk = (members, walk) if missing.label in (members or ()) else (None, False)
    if members is None:
        sized = _sized(task, missing)
        words = _not_held(sized, _without_which(sent, asked, found, missing.label)) if bound else at_limit(sized, walk)
        return Conflict((missing.label,), words, (_leaving_out(missing.label),))
    by_label = {piece.label: piece for piece in pieces}
    removals = tuple(
        _leaving_out(member)
        for member in members
        if member == missing.label or feasible(related, [piece for piece in held if piece.label != member], budget, walk=True)
    )
    names = " and ".join(_sized(task, by_label[member]) for member in members)

    if bound:
        free = asked([replace(one, relations=()) for one in task.requests])
        if feasible(free.listing.space, [piece for piece in free.pieces if piece.label in members], budget, walk) is not False:
            return Conflict(members, _not_held(names, _without_which(sent, asked, found, missing.label)), removals)
    if walk:
        where, there = ("", "it") if len(members) == 1 else ("together ", "them")
        words = f"can stand {where}in {_floor(task)}, but not with ways between all doors and to {there}"
    else:
        words = f"cannot stand {'as asked anywhere' if len(members) == 1 else 'together'} in {_floor(task)}"
    return Conflict(members, f"{names} {words}{_at_walls(task, [by_label[member] for member in members])}", removals)


def _fewest(task: PlaceTask, pieces: Sequence[Piece], missing: str, budget: Budget) -> tuple[tuple[str, ...] | None, bool]:
    """Returns the fewest pieces that cannot stand together, else the fewest that cannot be reached together, and whether it is these."""
    space = task.listing.space
    members = minimal_conflict(space, pieces, missing, budget)
    walk = members is None and bool(feasible(space, pieces, budget))
    return minimal_conflict(space, pieces, missing, budget, True) if walk else members, walk


def _without_which(task: PlaceTask, asked: Asking, found: Round, label: str) -> list[str]:
    """Returns without which required relations, its own or of others to it, a piece has a place and no other loses its: each is tried."""
    words = list[str]()
    for word, requests in islice(_each_freed(task, label), MOST_FREED):
        if is_call_spent():
            break
        freed = asked(requests)
        other = quick_placement(freed, freed.pieces)
        stands = any(one.label == label for one in other.arrangement.placed) and label not in other.breaking
        if stands and other.score[0] < found.score[0]:
            words.append(word)
    return words


def _each_freed(task: PlaceTask, label: str) -> Iterator[tuple[str, Sequence[PieceRequest]]]:
    """Yields each required relation of a piece, and those of others to it with their ids, in words, and the requests without it."""
    labels = labels_by_name(task.room, task.requests)
    for one in sorted(task.requests, key=lambda one: label not in one.labels):
        is_own = label in one.labels
        for spec in one.relations:
            if spec.required and (is_own or any(label in labels.get(name, ()) for name in spec.of)):
                freed = replace(one, relations=tuple(other for other in one.relations if other is not spec))
                yield spec.type if is_own else f"{spec.type} ({one.id})", [freed if other is one else other for other in task.requests]


def _not_held(names: str, without: Sequence[str] = ()) -> str:
    """Says that no place was found, and without which of the relations there is one."""
    words = f"not found: a place for {names} where the required relations hold"
    return f"{words}; without {' or '.join(dict.fromkeys(without))} there is one" if without else words


def _at_walls(task: PlaceTask, pieces: Sequence[Piece]) -> str:
    """Says which of some pieces are to stand at walls alone: elsewhere they might stand."""
    by_habit = {label for label in task.listing.listed if task.kinds[label].at_walls}
    labels = [one.label for one in pieces if one.candidates and (one.label in by_habit or all(way.wall for way in one.candidates))]
    return f", with {' and '.join(labels)} at walls" if labels else ""


def _leaving_out(label: str) -> dict[str, object]:
    return {"action": "leave_out", "id": label}


def _floor(task: PlaceTask) -> str:
    """Says where pieces may stand: in a room of another outline within a rectangle of this size."""
    clear = task.space.clear
    size = f"{clear.width / 1000:.2f} x {clear.depth / 1000:.2f} m"
    where = f"{task.room.id}, which {size} enclose" if task.room.outline else f"the {size} of {task.room.id}"
    return f"{where}, clear of its doors and windows"


def _sized(task: PlaceTask, piece: Piece) -> str:
    kind = task.kinds.get(piece.label)
    if kind is None:  # a thing that stands on the floor
        thing = next(one for one in task.room.decorations if one.id == piece.label)
        return f"{piece.label} {thing.width:.2f} x {thing.depth:.2f} m"
    return f"{piece.label} {kind.size[0] / 1000:.2f} x {kind.size[1] / 1000:.2f} m"
