"""Why a generated room lacks a required piece, in lengths; and what is said where a search ended at its limit.

Not here: how the lengths are found (placement), conflicts of sent rooms (conflicts).
"""

from collections.abc import Sequence
from dataclasses import replace

from solver.pieces import Arrangement, Piece, Space
from solver.pipeline.repair_room import missing_length
from solver.placement import Budget, minimal_conflict
from solver.placement.lengths import sentence

REASON_WORK = 4_000.0
"""Work a reason may cost, in QPs of a small room; above it the reason says how long the free stretches of wall are."""


def with_lengths(space: Space, wanted: Sequence[Piece], arrangement: Arrangement) -> Arrangement:
    """Says of every required piece that was left out which pieces it cannot stand with, and what length is missing."""
    reasons = []
    for label, reason in arrangement.left_out:
        found = _reason(space, wanted, label) if any(piece.label == label and piece.required for piece in wanted) else None
        reasons.append((label, reason if found is None else f"{found}; {reason}"))
    return replace(arrangement, left_out=tuple(reasons))


def _reason(space: Space, wanted: Sequence[Piece], label: str) -> str | None:
    """Returns which required pieces cannot be used together with one, and why; None where a limit was hit."""
    budget, required = Budget(REASON_WORK), [piece for piece in wanted if piece.required]
    members = minimal_conflict(space, required, label, budget, True)
    if members is None:
        return None
    pieces = [piece for piece in required if piece.label in members]
    short = missing_length(space, pieces, budget, walk=True)
    how = "anywhere" if len(members) == 1 else "together"
    lengths = f": {sentence(short)}" if short else ""
    return f"{' and '.join(members)} cannot stand and be used {how}{lengths}" if short or len(members) > 1 else None


AT_LIMIT = "the search ended at its limit; with less in the room, or with it turned or smaller, one may be found"
"""What may help where no more is known than that nothing was found."""


def at_limit(name: str, walk: bool, where: str = "") -> str:
    """Says of a piece what was looked for in vain: a place or, with `walk`, ways to it."""
    if walk:
        return f"not found: ways{where} by which somebody can get to {name}: it can stand there, but {AT_LIMIT}"
    return f"not found: a place for {name}{where} beside all else: {AT_LIMIT}"


def cannot(ids: Sequence[str], walk: bool, stay: bool) -> str:
    """Says what some pieces cannot: of one that stays as sent, no more than that it cannot stand there."""
    if walk:
        return "can stand but cannot be reached" if len(ids) == 1 else "can stand but cannot all be reached"
    if len(ids) > 1:
        return "cannot stand together"
    return "cannot stand" if stay else "cannot stand anywhere"
