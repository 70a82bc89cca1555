"""Rooms with a margin to walk in: ways from door to door that are wider than who walks, where they cost little furniture.

Comes in: a space and pieces. Goes out: a `SolvedRoom`. Wider ways are a wish: a try counts only where it is proven, holds all required
pieces and most of what stands without it. Use sides are come to by the person asked for, whatever the ways.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.pieces import Piece, Space
from solver.placement.arrange import SolvedRoom, arrange
from solver.placement.core import Limits


@dataclass(frozen=True)
class Margin:
    """A try: by how much wider, mm, and the share it must keep of what optional pieces are worth without it (by `skip_cost`)."""

    by_mm: int
    worth: float


MARGINS = (Margin(200, 0.9), Margin(100, 0.8), Margin(50, 0.6))
"""The widest first: 0.8, 0.7 and 0.65 m where the person is 0.6 m wide. Our choice."""
LIMITS = Limits(required=300, required_qps=500)
"""A try is given up sooner."""


def arrange_wide(space: Space, pieces: Sequence[Piece]) -> SolvedRoom:
    """Arranges a room with the widest ways between its doors that do not cost it its furniture."""
    found = arrange(space, pieces)
    if len(space.doorways) < 2 or not found.walkable:
        return found
    required, worth = _standing(found)
    for margin in MARGINS:
        wide = arrange(replace(space, ways_mm=space.robot_mm + margin.by_mm), pieces, limits=LIMITS)
        still, left = _standing(wide)
        if wide.walkable and wide.proven >= found.proven and still >= required and left >= margin.worth * worth:
            return wide
    return found


def _standing(room: SolvedRoom) -> tuple[int, float]:
    """Returns how many required pieces stand, and what the optional ones that do are worth."""
    pieces = [chosen.piece for chosen in room.chosen]
    return sum(piece.required for piece in pieces), sum(piece.skip_cost for piece in pieces if not piece.required)
