"""Floor that people like to have free about a piece, in Python: as solver/core/furnish/comfort.cpp, which it judges.

Comes in: a wanted piece. Goes out: wanted pieces that stand for that floor (`Piece.is_floor`): rigid at a side of the
piece, no bodies, but bodies keep out of them; people, doors and other kept floor do not. Each may be left out for its cost:
comfort is kept where there is a way and never hard.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from catalogs.schema import Catalogs, Comfort
from solver.geometry import to_mm
from solver.pieces import Attach, Candidate, Piece
from solver.relations.at_side import at_side, spans, whole

WEIGHED = 1.0
"""Floor of a required piece that is worth as much is weighed together with where the required pieces stand."""
PERSON_MM = 1800
"""Height of the space to be kept free."""
WEIGHTS = (0.02, 0.02)


def with_comfort(wanted: Sequence[Piece], catalogs: Catalogs) -> tuple[Piece, ...]:
    """Returns the pieces and the floor to keep free: what required pieces wish for before the optional pieces, the rest last."""
    required = [piece for piece in wanted if piece.required]
    floors = [floor for piece in required for floor in _kept_floor(piece, catalogs)]
    found = [*required, *sorted(floors, key=lambda floor: not floor.required)]
    waiting: list[Piece] = []
    last: list[Piece] = []
    for piece in (piece for piece in wanted if not piece.required):
        found.append(piece)
        floors = list(_kept_floor(piece, catalogs))
        waiting += [floor for floor in floors if floor.skip_cost >= WEIGHED]
        last += [floor for floor in floors if floor.skip_cost < WEIGHED]
        if not piece.with_next:
            found += waiting
            waiting = []
    return (*found, *waiting, *last)


def _kept_floor(piece: Piece, catalogs: Catalogs) -> Iterator[Piece]:
    """Yields the floor to keep free about a piece, one a side."""
    ways = {(one.kind, one.stance): one for one in piece.candidates}.values()
    wishes = {name: spec.comfort for name in {one.kind: None for one in ways} if (spec := catalogs.furniture.get(name))}
    sides = dict.fromkeys(side for comfort in wishes.values() for side in comfort)
    for side in sides:
        own = [one for one in ways if side in wishes.get(one.kind, {})]
        strips = [_strip(piece.label, one, side, wishes[one.kind][side]) for one in own]
        cost = max(wish[side].cost for wish in wishes.values() if side in wish) / len(sides)
        weighed = piece.required and cost >= WEIGHED
        without = [_nothing(piece.label, one, cost) for one in ways] if weighed else []
        yield Piece(f"floor at the {side} of {piece.label}", weighed, (*strips, *without), skip_cost=cost, is_floor=True)


def _strip(label: str, parent: Candidate, side: str, wish: Comfort) -> Candidate:
    """Returns the floor at a side of a piece that stands so."""
    width, depth, _ = parent.size_mm
    extent = (to_mm(wish.depth), depth - to_mm(wish.behind)) if side in ("left", "right") else (width, to_mm(wish.depth))
    across, along = spans(whole(at_side(((width, depth), extent), side, (0, 0), "front" if side in ("left", "right") else "centre")))
    attach = Attach(label, parent.kind, across, along, parent_stance=parent.stance)
    return Candidate("floor", (*extent, PERSON_MM), 0, weights=WEIGHTS, attach=attach)


def _nothing(label: str, parent: Candidate, cost: float) -> Candidate:
    """Returns no floor: a point within the piece itself, at what doing without costs."""
    attach = Attach(label, parent.kind, (0, 0), (0, 0), parent_stance=parent.stance)
    return Candidate("floor", (2, 2, PERSON_MM), 0, weights=WEIGHTS, attach=attach, under=label, cost=cost)
