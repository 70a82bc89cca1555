"""place(): a room of the user's own and a list of pieces -> the best placement, or several, or the reason why not.

Comes in: a Room and Wishes. Goes out: Answered. May import: every stage. Not here: what a stage does inside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from catalogs import Catalogs, load_catalogs
from solver.certificate import room_certificate
from solver.errors import RequestError
from solver.furnish import asked_pieces, space_of
from solver.furnished import furnished
from solver.pipeline.obstacles import obstacles
from solver.pipeline.timing import Clock, Timing
from solver.placement import ROOM_WORK, Budget, feasible, minimal_conflict
from solver.placement import place as arranged
from solver.relations_held import held, judged
from solver.requested import (
    MOST_ALTERNATIVES,
    Answered,
    Held,
    Placement,
    Unplaced,
    Wish,
    checked,
    in_order,
    kinds_for,
    labels_by_name,
    pieces_of,
    relations_of,
)
from solver.scene import ROBOT_WIDTH, Conflict, Furniture, Room, Scene
from solver.streams import Stream
from solver.validate import RULES, validate
from solver.wanted import Arrangement, Space, Wanted


@dataclass(frozen=True)
class Terms:
    """What every placement of one request shares."""

    room: Room
    wishes: tuple[Wish, ...]
    catalogs: Catalogs
    wall_thickness: float
    robot_width: float
    engine: str
    space: Space
    wanted: tuple[Wanted, ...]


def place(  # noqa: PLR0913 - keyword-only options of the public door
    room: Room,
    pieces: Sequence[Wish],
    *,
    alternatives: int = 1,
    wall_thickness: float = 0.0,
    robot_width: float = ROBOT_WIDTH,
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
        catalogs: whose kinds are known; ours by default.
        engine: of the final continuous solve, "osqp" or "reference".
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        RequestError: a field of the request is wrong.
    """
    if not 1 <= alternatives <= MOST_ALTERNATIVES:
        raise RequestError("alternatives", f"is {alternatives}", f"a whole number from 1 to {MOST_ALTERNATIVES}")
    timing = Timing(clock)
    terms = _terms(room, pieces, catalogs or load_catalogs(), (wall_thickness, robot_width, engine))
    timing.lap("furnish")
    best = _placement(terms, terms.wanted)
    timing.lap("placement")
    conflicts = _conflicts(terms, best)
    timing.lap("reasons")
    return Answered(best, (), conflicts, timing.ms)


def _terms(room: Room, pieces: Sequence[Wish], known: Catalogs, setting: tuple[float, float, str]) -> Terms:
    wall_thickness, robot_width, engine = setting
    wishes = in_order(checked(room, pieces, known))
    catalogs = kinds_for(room, wishes, known)
    space, standing = obstacles(room, space_of(room, wall_thickness, robot_width), catalogs)
    wanted = asked_pieces(room, space, catalogs, pieces_of(wishes), standing)
    return Terms(room, wishes, catalogs, wall_thickness, robot_width, engine, space, wanted)


def _placement(terms: Terms, wanted: Sequence[Wanted]) -> Placement:
    return _finished(terms, arranged([(terms.space, wanted)], terms.engine)[0])


def _finished(terms: Terms, arrangement: Arrangement) -> Placement:
    """Writes an arrangement down and judges it."""
    room = _written(terms, arrangement)
    scene = Scene(
        request={"robot_width": terms.robot_width},
        wall_thickness=terms.wall_thickness,
        rooms=(room,),
        certificate={"rules": list(RULES), "rooms": {room.id: room_certificate(arrangement)}},
    )
    stands = {piece.id for piece in terms.room.furniture}
    unplaced = tuple(Unplaced(label, reason) for label, reason in arrangement.left_out if label not in stands)
    return Placement(scene, relations_report(terms, room), unplaced, arrangement.cost, validate(scene, terms.catalogs))


def _written(terms: Terms, arrangement: Arrangement) -> Room:
    stream = Stream(0, "colour", terms.room.index)
    made = furnished(terms.room, arrangement, terms.catalogs, stream).furniture
    labels = {piece.id: placed.label for piece, placed in zip(made, arrangement.placed, strict=True)}
    stands = {piece.id for piece in terms.room.furniture}
    fresh = [_called(piece, labels) for piece in made if labels[piece.id] not in stands]
    return replace(terms.room, furniture=(*terms.room.furniture, *fresh))


def _called(piece: Furniture, labels: dict[str, str]) -> Furniture:
    under, on = labels.get(piece.under or ""), labels.get(piece.on or "")
    return replace(piece, id=labels[piece.id], under=under, on=on)


def relations_report(terms: Terms, room: Room) -> tuple[Held, ...]:
    """Judges every relation that was asked for in a finished room."""
    surfaces = {
        piece.id: [surface.height for surface in terms.catalogs.furniture[f"asked {name}"].surfaces]
        for name, labels in labels_by_name(terms.room, terms.wishes).items()
        for piece in room.furniture
        if piece.id in labels
    }
    seen = judged(room, terms.wall_thickness, labels_by_name(terms.room, terms.wishes), surfaces)
    report = []
    for label, rule in relations_of(terms.wishes):
        holds, of = held(seen, label, rule)
        report.append(Held(label, rule.type, of, holds))
    return tuple(report)


def _conflicts(terms: Terms, placement: Placement) -> tuple[Conflict, ...]:
    """Explains every required piece that found no place: a minimal set that cannot stand together, or that none was found."""
    missing = [entry.id for entry in placement.unplaced]
    required = [piece for piece in terms.wanted if piece.required]
    conflicts, budget = [], Budget(ROOM_WORK)
    for piece in required:
        if piece.label in missing:
            others = [other for other in required if other.label not in missing or other is piece]
            conflicts.append(_conflict(terms, others, piece, budget))
    return tuple(conflicts)


def _conflict(terms: Terms, pieces: Sequence[Wanted], missing: Wanted, budget: Budget) -> Conflict:
    members = minimal_conflict(terms.space, pieces, missing.label, budget)
    if members is None:
        if feasible(terms.space, pieces, budget):
            return Conflict((missing.label,), f"{_sized(missing)} can stand with the others, but not where it and they can be reached")
        return Conflict((missing.label,), f"not found: the search for a place for {_sized(missing)} ended at its limit")
    by_label = {piece.label: piece for piece in pieces}
    clear = terms.space.clear
    floor = f"the {clear.width / 1000:.2f} x {clear.depth / 1000:.2f} m of {terms.room.id}, clear of its doors and windows"
    how = "cannot stand as asked anywhere in" if len(members) == 1 else "cannot stand together in"
    removals = tuple(
        {"action": "leave_out", "id": member}
        for member in members
        if feasible(terms.space, [piece for piece in pieces if piece.label != member], budget)
    )
    return Conflict(members, f"{' and '.join(_sized(by_label[member]) for member in members)} {how} {floor}", removals)


def _sized(piece: Wanted) -> str:
    width, depth, _ = piece.alternatives[0].size_mm
    return f"{piece.label} {width / 1000:.2f} x {depth / 1000:.2f} m"
