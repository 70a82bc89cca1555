"""place(): a room of the user's own and a list of pieces -> the best placement, or several, or the reason why not.

Comes in: a Room and Wishes. Goes out: Answered. May import: every stage. Not here: what a stage does inside.
"""

from __future__ import annotations

from collections.abc import Sequence

from catalogs import Catalogs, load_catalogs
from solver.errors import RequestError
from solver.pipeline.asked import Terms, terms_of
from solver.pipeline.others import other_placements
from solver.pipeline.rounds import best_placement, settled
from solver.pipeline.timing import Clock, Timing
from solver.placement import ROOM_WORK, Budget, feasible, minimal_conflict
from solver.requested import MOST_ALTERNATIVES, Answered, Placement, Wish, kind_of
from solver.scene import ROBOT_WIDTH, Conflict, Room
from solver.wanted import Wanted


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
    terms = terms_of(room, pieces, catalogs or load_catalogs(), (wall_thickness, robot_width, engine))
    timing.lap("furnish")
    found = best_placement(terms, terms.wanted)
    best = settled(terms, found)
    timing.lap("placement")
    others = other_placements(terms, found, alternatives - 1)
    timing.lap("alternatives")
    conflicts = _conflicts(terms, best)
    timing.lap("reasons")
    return Answered(best, tuple(settled(terms, other) for other in others), conflicts, timing.ms)


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
            return Conflict(
                (missing.label,), f"{_sized(terms, missing)} can stand with the others, but not where it and they can be reached"
            )
        return Conflict((missing.label,), f"not found: the search for a place for {_sized(terms, missing)} ended at its limit")
    by_label = {piece.label: piece for piece in pieces}
    clear = terms.space.clear
    floor = f"the {clear.width / 1000:.2f} x {clear.depth / 1000:.2f} m of {terms.room.id}, clear of its doors and windows"
    how = "cannot stand as asked anywhere in" if len(members) == 1 else "cannot stand together in"
    removals = tuple(
        {"action": "leave_out", "id": member}
        for member in members
        if feasible(terms.space, [piece for piece in pieces if piece.label != member], budget)
    )
    return Conflict(members, f"{' and '.join(_sized(terms, by_label[member]) for member in members)} {how} {floor}", removals)


def _sized(terms: Terms, piece: Wanted) -> str:
    entry = terms.catalogs.furniture[kind_of(_name(terms, piece.label))]
    return f"{piece.label} {entry.size[0]:.2f} x {entry.size[1]:.2f} m"


def _name(terms: Terms, label: str) -> str:
    return next((wish.id for wish in terms.wishes if label in wish.labels), label)
