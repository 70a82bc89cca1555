"""Floor that people like to have free about a piece: beside a toilet, behind a chair, before a kitchen run.

Comes in: a wanted piece. Goes out: wanted pieces that stand for that floor (`wanted.EMPTY_FLOOR`): rigid at a side of the
piece, no bodies, but bodies keep out of them; people, doors and other kept floor do not. Each may be left out for COMFORT_COST:
comfort is kept where there is a way and never hard.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from catalogs.schema import Catalogs
from solver.furnish.relations.slots import beside_offset
from solver.geometry import to_mm
from solver.wanted import EMPTY_FLOOR, Alternative, Attach, Wanted

COMFORT_COST = 0.6
"""What doing without a piece's comfort costs (measured: kept in nearly all pieces)."""
PERSON_MM = 1800
"""Height of the space to be kept free."""
WEIGHTS = (0.02, 0.02)


def with_comfort(wanted: Sequence[Wanted], catalogs: Catalogs) -> tuple[Wanted, ...]:
    """Returns the pieces and the floor to keep free: what required pieces wish for before the optional pieces, the rest last."""
    required = [piece for piece in wanted if piece.required]
    optional = [piece for piece in wanted if not piece.required]
    floors = [[floor for piece in pieces for floor in _kept_floor(piece, catalogs)] for pieces in (required, optional)]
    return (*required, *floors[0], *optional, *floors[1])


def _kept_floor(piece: Wanted, catalogs: Catalogs) -> Iterator[Wanted]:
    """Yields the floor to keep free about a piece, one a side."""
    kinds = {alternative.kind: alternative.size_mm for alternative in piece.alternatives}
    sides = dict.fromkeys(side for kind in kinds for side in catalogs.furniture[kind].comfort)
    for side in sides:
        depths = {kind: to_mm(catalogs.furniture[kind].comfort[side]) for kind in kinds if side in catalogs.furniture[kind].comfort}
        yield Wanted(
            f"{EMPTY_FLOOR} {side} of {piece.label}", False, tuple(_strips(piece, side, kinds, depths)), skip_cost=COMFORT_COST / len(sides)
        )


def _strips(piece: Wanted, side: str, kinds: Mapping[str, tuple[int, int, int]], depths: Mapping[str, int]) -> Iterator[Alternative]:
    for kind, deep in depths.items():
        width, depth, _ = kinds[kind]
        extent = (deep, depth) if side in ("left", "right") else (width, deep)
        across, along = beside_offset(kinds[kind], extent, side, (0, 0), "centre")
        yield Alternative("floor", (*extent, PERSON_MM), 0, weights=WEIGHTS, attach=Attach(piece.label, kind, across, along))
