"""Floor that people like to have free about a piece, in Python: as solver/core/furnish/comfort.cpp, which it judges.

Comes in: a wanted piece. Goes out: wanted pieces that stand for that floor (`Piece.is_floor`): rigid at a side of the
piece, no bodies, but bodies keep out of them; people, doors and other kept floor do not. Each may be left out for its cost:
comfort is kept where there is a way and never hard.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from catalogs.schema import Catalogs
from solver.furnish.compiled_types import FloorAbout, floors_about
from solver.pieces import Attach, Candidate, Piece
from tests.furnish.reference.at_side import at_side, spans, whole

WEIGHED = 1.0
"""Floor of a required piece that is worth as much is weighed together with where the required pieces stand."""
PERSON_MM = 1800
"""Height of the space to be kept free."""
WEIGHTS = (0.02, 0.02)
NOWHERE_MM = 100_000
"""Underside of what is in nobody's way."""
BLOCKED = 12.0
"""What it costs a required piece that its fronts do not open half of their way."""


def with_comfort(wanted: Sequence[Piece], catalogs: Catalogs, in_run: Collection[str], worktop: Collection[str]) -> tuple[Piece, ...]:
    """Returns the pieces and the floor to keep free: what required pieces wish for before the optional pieces, the rest last.

    What the fronts of a piece open over comes right behind it; an optional piece stands with it or not at all. That of the `worktop` and
    of the required pieces `in_run` comes when the run is whole, and they stand without, too.
    """
    required = [piece for piece in wanted if piece.required]
    optional = [piece for piece in wanted if not piece.required]
    every = [piece for piece in (*required, *optional) if _name(piece) in in_run]
    run = [piece for piece in every if piece.required or _name(piece) in worktop]
    coming = sum(not piece.required for piece in every)
    of_run = [floor for piece in run for floor in _opened(piece, catalogs, in_run=True)]
    floors = [floor for piece in required for floor in _kept_floor(piece, catalogs)]
    opened = [floor for piece in required if piece not in run for floor in _opened(piece, catalogs)]
    found = [*required, *opened, *sorted(floors, key=lambda floor: not floor.required), *(() if coming else of_run)]
    waiting: list[Piece] = []
    last: list[Piece] = []
    for piece in optional:
        before = [] if piece in run else list(_opened(piece, catalogs))
        found += [replace(piece, with_next=piece.with_next or bool(before)), *before]
        if piece in every:
            coming -= 1
            found += () if coming else of_run
        floors = list(_kept_floor(piece, catalogs))
        waiting += [floor for floor in floors if floor.skip_cost >= WEIGHED]
        last += [floor for floor in floors if floor.skip_cost < WEIGHED]
        if not piece.with_next:
            found += waiting
            waiting = []
    return (*found, *waiting, *last)


def _name(piece: Piece) -> str:
    return piece.label.rpartition("_")[0]


def _about(piece: Piece, catalogs: Catalogs) -> tuple[list[Candidate], dict[str, list[FloorAbout]]]:
    """Returns the ways of a piece that differ, and the floor about each of its kinds."""
    ways = {(one.kind, one.stance): one for one in piece.candidates}.values()
    kinds = {one.kind: catalogs.furniture.get(one.kind) for one in ways}
    return list(ways), {name: list(floors_about(spec, catalogs.shapes.get(name, ()))) if spec else [] for name, spec in kinds.items()}


def _kept_floor(piece: Piece, catalogs: Catalogs) -> Iterator[Piece]:
    """Yields the floor to keep free about a piece, one a side."""
    ways, about = _about(piece, catalogs)
    wishes = {name: {one.side: one for one in floors if not one.opens} for name, floors in about.items()}
    sides = dict.fromkeys(side for comfort in wishes.values() for side in comfort)
    for side in sides:
        own = [one for one in ways if side in wishes.get(one.kind, {})]
        strips = [_strip(piece.label, one, wishes[one.kind][side], wishes[one.kind][side].depth) for one in own]
        cost = max(wish[side].cost for wish in wishes.values() if side in wish) / len(sides)
        weighed = piece.required and cost >= WEIGHED
        without = [_nothing(piece.label, one, cost) for one in ways] if weighed else []
        yield Piece(f"floor at the {side} of {piece.label}", weighed, (*strips, *without), skip_cost=cost, is_floor=True)


def _opened(piece: Piece, catalogs: Catalogs, in_run: bool = False) -> Iterator[Piece]:
    """Yields the floor that a piece's fronts open over, if they do."""
    ways, about = _about(piece, catalogs)
    opening = {name: [one for one in floors if one.opens] for name, floors in about.items()}
    every = [one for floors in opening.values() for one in floors]
    if not every or piece.candidates[0].on is not None:
        return
    found: list[Candidate] = []
    required = piece.required and not in_run
    for way in ways:
        for one in opening[way.kind]:
            found.append(_strip(piece.label, way, one, one.depth))
            if one.half < one.depth:
                found.append(replace(_strip(piece.label, way, one, one.half), cost=one.cost))
        if not opening[way.kind] or required:
            lost = BLOCKED if opening[way.kind] else 0.0
            found.append(replace(_nothing(piece.label, way, lost), bottom_mm=NOWHERE_MM))
    label = f"floor opened over at the {every[-1].side} of {piece.label}"
    cost = BLOCKED if in_run else max(one.cost for one in every)
    yield Piece(label, required, tuple(found), skip_cost=cost, with_next=piece.with_next, is_floor=True)


def _strip(label: str, parent: Candidate, wish: FloorAbout, deep: int) -> Candidate:
    """Returns the floor so deep at a side of a piece that stands so."""
    width, depth, _ = parent.size_mm
    lateral = wish.side in ("left", "right")
    extent = (deep, depth - wish.behind) if lateral else (wish.right - wish.left if wish.opens else width, deep - wish.off)
    across, along = spans(whole(at_side(((width, depth), extent), wish.side, (wish.off, wish.off), "front" if lateral else "centre")))
    aside = (wish.left + wish.right) // 2 if wish.opens else 0
    attach = Attach(label, parent.kind, (across[0] + aside, across[1] + aside), along, parent_stance=parent.stance)
    return Candidate("floor", (*extent, PERSON_MM), 0, weights=WEIGHTS, attach=attach, bottom_mm=wish.above)


def _nothing(label: str, parent: Candidate, cost: float) -> Candidate:
    """Returns no floor: a point within the piece itself, at what doing without costs."""
    attach = Attach(label, parent.kind, (0, 0), (0, 0), parent_stance=parent.stance)
    return Candidate("floor", (2, 2, PERSON_MM), 0, weights=WEIGHTS, attach=attach, under=label, cost=cost)
