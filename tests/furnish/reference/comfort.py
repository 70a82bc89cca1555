"""Floor that people like to have free about a piece, in Python: as solver/core/furnish/comfort.cpp, which it judges.

Comes in: a wanted piece. Goes out: wanted pieces that stand for that floor (`Piece.is_floor`): rigid at a side of the
piece, no bodies, but bodies keep out of them; people, doors and other kept floor do not. Each may be left out for COMFORT_COST:
comfort is kept where there is a way and never hard.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catalogs.schema import Catalogs
from solver.geometry import to_mm
from solver.pieces import Attach, Candidate, Piece
from solver.relations.at_side import at_side, spans, whole

COMFORT_COST = 0.6
"""What doing without a piece's comfort costs (measured: kept in nearly all pieces)."""
PERSON_MM = 1800
"""Height of the space to be kept free."""
WEIGHTS = (0.02, 0.02)


def with_comfort(wanted: Sequence[Piece], catalogs: Catalogs) -> tuple[Piece, ...]:
    """Returns the pieces and the floor to keep free: what required pieces wish for before the optional pieces, the rest last."""
    required = [piece for piece in wanted if piece.required]
    optional = [piece for piece in wanted if not piece.required]
    floors = [[floor for piece in pieces for floor in _kept_floor(piece, catalogs)] for pieces in (required, optional)]
    return (*required, *floors[0], *optional, *floors[1])


def _kept_floor(piece: Piece, catalogs: Catalogs) -> Iterator[Piece]:
    """Yields the floor to keep free about a piece, one a side."""
    ways = {(one.kind, one.stance): one for one in piece.candidates}.values()
    wishes = {name: spec.comfort for name in {one.kind: None for one in ways} if (spec := catalogs.furniture.get(name))}
    sides = dict.fromkeys(side for comfort in wishes.values() for side in comfort)
    for side in sides:
        strips = (_strip(piece.label, one, side, wishes[one.kind][side]) for one in ways if side in wishes.get(one.kind, {}))
        cost = COMFORT_COST / len(sides)
        yield Piece(f"floor at the {side} of {piece.label}", False, tuple(strips), skip_cost=cost, is_floor=True)


def _strip(label: str, parent: Candidate, side: str, depth_m: float) -> Candidate:
    """Returns the floor at a side of a piece that stands so."""
    width, depth, _ = parent.size_mm
    extent = (to_mm(depth_m), depth) if side in ("left", "right") else (width, to_mm(depth_m))
    across, along = spans(whole(at_side(((width, depth), extent), side, (0, 0), "centre")))
    attach = Attach(label, parent.kind, across, along, parent_stance=parent.stance)
    return Candidate("floor", (*extent, PERSON_MM), 0, weights=WEIGHTS, attach=attach)
