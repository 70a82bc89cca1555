"""From a list of pieces with relations, asked for by a user, to wanted pieces whose ways to stand hold those relations.

Unlike a room type's rules, which cost by degree, a relation asked for is held or not. So every way to stand says which it
holds: those to the room by a rectangle that its footprint stays in (regions), those to another piece by a box in that piece's
frame (boxes), for each way that other piece may be turned. What a way does not hold, it pays for.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from catalogs.checks import OPENINGS
from catalogs.schema import Catalogs, Piece
from solver.furnish.ask import Ask, Scope
from solver.furnish.openings import openings_of
from solver.furnish.stances import Asking, Kept, Stance, stance_of, variant
from solver.furnish.ties import tied, ways_between
from solver.furnish.walls import WallOccupancy
from solver.geometry import Rect, turned
from solver.scene import Room, Sides
from solver.wanted import Alternative, Link, Placed, Space, Stand, Wanted

PULL = 0.03
"""Pull of a piece to where a way to stand would like it best, m^-2: order, not preference."""
FREE_COST = 0.2
"""What standing in the middle of the room costs a piece that may also stand at a wall."""
UNSURE = 0.25
"""The part of a relation's cost that a way pays which neither holds nor breaks it."""
TIED = 400
"""Most ways of a piece that are tied to another one."""
EACH = 3
"""Most ways of one stance that differ in what they hold."""
DEAR = 5.0
"""What a way costs more than a piece's best that is too unlikely for others to be tied to it: less than a relation."""
NEAR_PULL, ALIGN_PULL = 0.2, 0.5
"""Weights, m^-2, of the pulls towards pieces that a way is not tied to."""
FAR = 2.0
"""What far_from takes for far where the rule names no distance, m."""

_cost = attrgetter("cost")


@dataclass(frozen=True)
class Asked:
    """The wanted pieces of a list, and what each was asked with."""

    wanted: tuple[Wanted, ...]
    askings: Mapping[str, Asking]

    def between(self, placed: Sequence[Placed], labels: Container[str]) -> tuple[Wanted, ...]:
        """Returns the pieces, the named ones with further ways: where all their relations hold with the rest as it stands.

        Args:
            placed: where the pieces stand.
            labels: whose ways are sought.
        """
        poses = {one.label: one for one in placed}
        return tuple(
            replace(piece, alternatives=_with_more(piece, ways_between(self.askings[piece.label], poses)))
            if piece.label in labels and piece.label in self.askings
            else piece
            for piece in self.wanted
        )


def _with_more(piece: Wanted, more: Sequence[Alternative]) -> tuple[Alternative, ...]:
    return tuple(sorted((*more, *piece.alternatives), key=_cost))


def asked_pieces(room: Room, space: Space, catalogs: Catalogs, pieces: Sequence[Piece], standing: Sequence[Wanted]) -> Asked:
    """Returns the wanted pieces of a list, in its order, behind those that stand already.

    Args:
        room: with its openings.
        space: the room's `space_of`.
        catalogs: with the kinds of the pieces and of what stands already.
        pieces: each after those its rules refer to; a rule to a later one is left to the caller.
        standing: what stands in the room already, one way each.

    Returns:
        Pieces whose alternatives' kinds name, behind an @, how the piece stands: that is what ties depend on.
    """
    area = room.width * room.depth
    scope = Scope(space, WallOccupancy(space), catalogs, openings_of(room), room.exterior_walls or Sides(), area)
    wanted = [_standing(one) for one in standing]
    earlier: dict[str, tuple[str, ...]] = {one.label: (one.label,) for one in wanted}
    kinds: dict[str, tuple[str, ...]] = {one.label: (one.alternatives[0].kind,) for one in wanted}
    askings: dict[str, Asking] = {}
    named = {name for piece in pieces for rule in piece.rules for name in rule.of}
    dear: set[tuple[str, str]] = set()
    reach = {key: rect for one in wanted for key, rect in _reach(one, space.clear).items()}
    for piece in pieces:
        for number in range(1, piece.count + 1):
            label = piece.piece if piece.count == 1 else f"{piece.piece}_{number}"
            asking = _asking(Ask(scope, piece, number, dict(earlier), dict(kinds)), reach, dear)
            one, askings[label] = _wanted(asking, label), asking
            wanted.append(one)
            if piece.piece in named:
                reach |= _reach(one, space.clear)
                dear |= _dear(one)
            earlier[piece.piece] = (*earlier.get(piece.piece, ()), label)
            kinds[label] = tuple(dict.fromkeys(way.kind for way in one.alternatives))
    return Asked(tuple(wanted), askings)


def _standing(piece: Wanted) -> Wanted:
    """Says of a piece that stands already how it does."""
    way = piece.alternatives[0]
    return replace(piece, alternatives=(replace(way, kind=variant(way.kind, way.rotation, way.wall)),))


def _reach(piece: Wanted, clear: Rect) -> dict[tuple[str, str], Rect]:
    """Returns where the centre of a piece may be, for every way it may stand."""
    kinds: dict[str, set[Rect]] = {}
    for way in piece.alternatives:
        kinds.setdefault(way.kind, set()).add(way.within or clear)
    found: dict[tuple[str, str], Rect] = {}
    for kind, rects in kinds.items():
        width, depth = turned(*piece.alternatives[0].size_mm[:2], stance_of(kind)[1])
        fits = [rect for rect in rects if width <= rect.width and depth <= rect.depth]
        if fits:
            x0, z0 = min(rect.x0 for rect in fits), min(rect.z0 for rect in fits)
            x1, z1 = max(rect.x1 for rect in fits), max(rect.z1 for rect in fits)
            found[piece.label, kind] = Rect(x0 + width // 2, z0 + depth // 2, x1 - width // 2, z1 - depth // 2)
    return found


def _dear(piece: Wanted) -> set[tuple[str, str]]:
    """Returns the ways that cost at least `DEAR` more than the cheapest."""
    kinds: dict[str, float] = {}
    for way in piece.alternatives:
        kinds[way.kind] = min(way.cost, kinds.get(way.kind, math.inf))
    least = min(kinds.values(), default=0.0) + DEAR
    return {(piece.label, kind) for kind, cost in kinds.items() if cost >= least}


def _asking(ask: Ask, reach: Mapping[tuple[str, str], Rect], dear: Collection[tuple[str, str]]) -> Asking:
    rules = [rule for rule in ask.piece.rules if not rule.of or set(rule.of) & set(OPENINGS) or ask.labels(rule.of)]
    to_room = tuple(rule for rule in rules if not ask.labels(rule.of))
    to_pieces = tuple(rule for rule in rules if ask.labels(rule.of))
    return Asking(ask, to_room, to_pieces, reach, frozenset(dear))


def _wanted(asking: Asking, label: str) -> Wanted:
    ask = asking.ask
    use = ask.scope.entry(asking.kind).use
    return Wanted(
        label,
        ask.piece.required,
        tuple(_ways(asking)),
        links=tuple(_links(asking)),
        stands=tuple(Stand(side) for side in (use.sides if use else ())),
        need_all=bool(use and use.need == "all"),
        skip_cost=ask.piece.skip_cost,
    )


def _ways(asking: Asking) -> list[Alternative]:
    """Returns all ways, cheapest first; none where the piece is too large, or hard relations rule all of them out."""
    every = [(stance, _some(found)) for stance, found in asking.places]
    hard = any(rule.required for rule in asking.to_pieces)
    alone = [] if hard else list(_alone(asking, every))
    dearest = min((way.cost for way in alone), default=math.inf)
    bound = list(tied(asking, every, dearest + _worth(asking)))
    bound.sort(key=_cost)
    return sorted([*alone, *bound[:TIED]], key=_cost)


def _some(found: Sequence[Kept]) -> list[Kept]:
    """Returns the few that cost least, and the dearest: where nothing is held, a piece can still stand."""
    return [*found[:EACH], *found[EACH:][-1:]]


def _worth(asking: Asking) -> float:
    return sum(rule.cost for rule in asking.to_pieces)


def _alone(asking: Asking, every: Sequence[tuple[Stance, Sequence[Kept]]]) -> Iterator[Alternative]:
    """Yields the ways to stand at walls and in the room, tied to nobody."""
    pairs = sum(rule.cost * (UNSURE if rule.type in ("far_from", "aligned_with", "near") else 1.0) for rule in asking.to_pieces)
    for stance, found in every:
        for rect, cost in found:
            free = FREE_COST if stance.wall is None else 0.0
            yield Alternative(
                variant(asking.kind, stance.rotation, stance.wall), asking.size, stance.rotation, stance.wall,
                _anchor(asking, stance, (rect, cost)), (PULL, PULL), within=rect, cost=round(cost + pairs + free, 6),
            )  # fmt: skip


def _anchor(asking: Asking, stance: Stance, place: Kept) -> tuple[int, int]:
    """Returns where in its rectangle a piece would like to stand: in the middle of the longest clear stretch of its wall."""
    rect, _ = place
    x, z = (rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2
    if stance.wall is None:
        return x, z
    low, high = rect.along(stance.wall)
    found = asking.stretches[stance.wall]
    cut = [(max(a, low), min(b, high)) for a, b in found]
    a, b = max(cut, key=lambda stretch: stretch[1] - stretch[0], default=(low, high))
    middle = (a + b) // 2 if b > a else (low + high) // 2
    return (middle, z) if stance.wall in ("north", "south") else (x, middle)


def _links(asking: Asking) -> Iterator[Link]:
    """Yields weak pulls, for the ways that are not tied to the piece a rule names."""
    for rule in asking.to_pieces:
        labels = asking.ask.labels(rule.of)
        if rule.type == "far_from":
            distance = 1.0 + (FAR if rule.distance is None else rule.distance)
            yield from (Link("far_from", label, apart_m=distance, apart_cost=0.25 * rule.cost / distance) for label in labels)
        elif rule.type in ("aligned_with", "opposite"):
            yield Link(rule.type, labels[0], align=ALIGN_PULL)
        else:
            yield Link(rule.type, labels[0], near=NEAR_PULL)
