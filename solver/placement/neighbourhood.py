"""A walkable placement found by freeing a few pieces at a time: those in conflict, then their neighbours, the others where they are.

Large neighbourhood search (Shaw, 1998): what is freed is searched over all its ways at once, the fewest that could help first; what is
found bounds what is sought next.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np

from solver.geometry import Rect, rotate, turned
from solver.pieces import Candidate, Piece, Space
from solver.placement.budget import Budget, charge, is_call_spent
from solver.placement.core import Core, Limits
from solver.placement.encode import encode

SEARCH = Limits(required=30, required_qps=300)
"""What one neighbourhood may try, first the cheapest ways, then, as often, the farthest that was come to: it helps soon or seldom."""
BETTER_WORK = 10000.0
"""What the search goes on for once something was found, in QPs of a small room."""
PAIR_WORK = 0.0025
"""What two pieces count each time a room is tried with one more of them; measured."""
MOST_FREED = 12
"""Pieces freed at once, at most."""


@dataclass(frozen=True)
class Found:
    """Where all pieces may stand: of each its candidate and footprint, in the pieces' order."""

    ways: tuple[Candidate, ...]
    places: tuple[Rect, ...]


def as_wished(space: Space, pieces: Sequence[Piece]) -> Found | None:
    """Returns every piece's first candidate, of those whose parent comes before, where it is wished; what is carried where its carrier is.

    None where a piece has no such candidate.
    """
    found: dict[str, Rect] = {}
    turns: dict[str, int] = {}
    ways = []
    for piece in pieces:
        way = next((way for way in piece.candidates if way.attach is None or way.attach.parent in found), None)
        if way is None:
            return None
        ways.append(way)
        turn, attach = way.rotation, way.attach
        if attach is not None:
            turn = (turn + turns[attach.parent]) % 360
        turns[piece.label], extent = turn, turned(*way.size_mm[:2], turn)
        found[piece.label] = Rect.around(way.anchor_mm, extent)
        if attach is not None:
            parent = found[attach.parent]
            across, along = attach.wish_twice_mm
            dx, dz = rotate(across // 2, along // 2, turns[attach.parent])
            x, z = parent.x0 + (parent.width - extent[0]) // 2 + dx, parent.z0 + (parent.depth - extent[1]) // 2 + dz
            found[piece.label] = Rect(x, z, x + extent[0], z + extent[1])
    return Found(tuple(ways), tuple(found.values()))


@dataclass(frozen=True)
class Neighbourhood:
    """A room whose pieces stand somewhere (`base`), some of them in conflict; parents before what is attached to them."""

    space: Space
    pieces: tuple[Piece, ...]
    base: Found

    @cached_property
    def rects(self) -> dict[str, Rect]:
        """Where every piece stands."""
        return {piece.label: place for piece, place in zip(self.pieces, self.base.places, strict=True)}

    @cached_property
    def ways(self) -> dict[str, Candidate]:
        """How every piece stands."""
        return {piece.label: way for piece, way in zip(self.pieces, self.base.ways, strict=True)}

    def neighbourhoods(self) -> Iterator[frozenset[str]]:
        """Yields which pieces to free, one set after the other: each holds the one before."""
        roots = {self._root(label) for label in self.in_the_way}
        sliding = {label for label in self.in_the_way if (attach := self.ways[label].attach) is not None and attach.wish_mm}
        freed = (roots | sliding) & self._loose
        step = 1
        if freed:
            yield frozenset(freed)
        while len(freed) < min(MOST_FREED, len(self._loose)):
            freed |= set(self._nearest(freed, step))
            step = min(2 * step, 4)
            yield frozenset(freed)

    @cached_property
    def in_the_way(self) -> tuple[str, ...]:
        """Labels of the pieces that may move without which the others can be used as they were sent: with any one more they cannot.

        Where the call's work is spent, so are all that were not looked at yet.
        """
        stand = self.standing(None)
        return tuple(self.pieces[k].label for k in self._order if k not in stand and not self.pieces[k].candidates[0].stays)

    def standing(self, budget: Budget | None) -> set[int]:
        """Returns the numbers of pieces that can be used together as they were sent: as many as a budget, or the call's, allows.

        Those that are held least strongly, share space with others or are small come last.
        """
        still = [replace(piece, candidates=(self._still(piece),)) for piece in self.pieces]
        core = Core(encode(self.space, still, "test"))
        decisions, found = core.blank(), set[int]()
        for piece in self._order:
            way, rect = self.base.ways[piece], self.base.places[piece]
            inside = way.attach is not None or (way.within or self.space.clear).contains(rect)
            trial = core.with_first(decisions, piece) if inside else None
            work = PAIR_WORK * len(still) ** 2
            if budget is None:
                charge(work)
            else:
                budget.left -= work
            if trial is not None and not (is_call_spent() if budget is None else budget.spent) and core.stands_walkable(trial):
                decisions = trial
                found.add(piece)
        return found

    @cached_property
    def _order(self) -> list[int]:
        return sorted(range(len(self.pieces)), key=self._steadiness)

    def _steadiness(self, number: int) -> tuple[bool, float, int, float, int]:
        """Sorts what cannot move before what is held strongly, what shares space with few and what is large."""
        piece, way = self.pieces[number], self.base.ways[number]
        loose = piece.label in self._loose
        return loose, -way.weights[0], self._shared[number], -way.size_mm[0] * way.size_mm[1], number

    @cached_property
    def _shared(self) -> list[int]:
        """With how many others each piece shares space."""
        x0, z0, x1, z1 = np.array(self.base.places, dtype=np.int64).reshape(-1, 4).T
        return [int(((x0 < e) & (x1 > w) & (z0 < s) & (z1 > n)).sum()) - (e > w and s > n) for w, n, e, s in self.base.places]

    @cached_property
    def _loose(self) -> frozenset[str]:
        """Labels of the pieces that may stand elsewhere than as sent, by themselves."""
        return frozenset(p.label for p in self.pieces if not p.candidates[0].stays and any(way.attach is None for way in p.candidates))

    def _root(self, label: str) -> str:
        """Returns what carries a piece in the end."""
        while (attach := self.ways[label].attach) is not None:
            label = attach.parent
        return label

    def _nearest(self, freed: Collection[str], count: int) -> list[str]:
        """Returns the loose pieces nearest to those that are free; where none is, to the doors."""
        near = [self.rects[label] for label in freed] or [door.square for door in self.space.doorways] or [self.space.clear]
        away = {label: min(self.rects[label].distance_to(rect) for rect in near) for label in self._loose if label not in freed}
        order = {piece.label: k for k, piece in enumerate(self.pieces)}
        return sorted(away, key=lambda label: (away[label], order[label]))[:count]

    def searched(self, freed: Collection[str], budget: Budget) -> Found | None:
        """Searches the freed pieces over all their ways, the others where they were sent; None where nothing is found."""
        moving: set[str] = set()
        for piece in self.pieces:
            parents = {way.attach.parent for way in piece.candidates if way.attach is not None}
            if piece.label in freed or parents & moving:
                moving.add(piece.label)
        still = [replace(p, candidates=(self._still(p),)) for p in self.pieces if p.label not in moving]
        bound = {p.label for p in self.pieces if p.label in self._loose and p.label not in freed}
        free = [replace(p, candidates=(self.ways[p.label],)) if p.label in bound else p for p in self.pieces if p.label in moving]
        core = Core(encode(self.space, (*still, *free), "loose"))
        decisions = core.joined(len(still), SEARCH, budget)
        if decisions is None or not core.evaluate(decisions, SEARCH.required_qps, budget, True):
            return None
        rects, own = core.bodies(), {piece.label: k for k, piece in enumerate(core.encoded.pieces)}
        taken = {label: core.decided(int(decisions[own[label]])) for label in moving}
        ways = tuple(taken.get(p.label, self.ways[p.label]) for p in self.pieces)
        return Found(ways, tuple(rects[own[p.label]] for p in self.pieces))

    def _still(self, piece: Piece) -> Candidate:
        way = self.ways[piece.label]
        return way if way.attach is not None else replace(way, within=self.rects[piece.label])


def freed_search(space: Space, pieces: Sequence[Piece], budget: Budget) -> Iterator[Found]:
    """Frees more and more pieces from where they are wished until all can stand and be used; then some more, for what is cheaper.

    Yields what is found. Parents come before what is attached to them.
    """
    wished = as_wished(space, pieces)
    if wished is None:
        return
    room = Neighbourhood(space, tuple(pieces), wished)
    end = -inf
    for freed in room.neighbourhoods():
        found = room.searched(freed, budget)
        if found is not None:
            yield found
            if end < 0:
                end = budget.left - BETTER_WORK
        if budget.left < end or budget.spent:
            return


def in_the_way(space: Space, pieces: Sequence[Piece]) -> tuple[str, ...]:
    """Returns pieces without which the others can be used where they are wished; with any one more they cannot."""
    wished = as_wished(space, pieces)
    return Neighbourhood(space, tuple(pieces), wished).in_the_way if wished else ()


def standing(space: Space, pieces: Sequence[Piece], budget: Budget) -> Neighbourhood:
    """Returns a room of those pieces that can be used together where they are wished; of none where one is wished nowhere."""
    wished = as_wished(space, pieces)
    if wished is None:
        return Neighbourhood(space, (), Found((), ()))
    room = Neighbourhood(space, tuple(pieces), wished)
    return _of(space, [pieces[k] for k in sorted(room.standing(budget))], room.ways, room.rects)


def joined_in_turn(room: Neighbourhood, pieces: Sequence[Piece], budget: Budget) -> Neighbourhood:
    """Returns a room with each of those pieces that are not in it, in order, that finds a place beside all others where these stand."""
    wished = as_wished(room.space, pieces)
    if wished is None:
        return room
    every = Neighbourhood(room.space, tuple(pieces), wished)
    for label in [piece.label for piece in pieces if piece.label not in room.ways]:
        if budget.spent:
            break
        here = [piece for piece in pieces if piece.label in room.ways or piece.label == label]
        near = _of(room.space, here, every.ways | room.ways, every.rects | room.rects)
        found = near.searched({label}, budget)
        room = room if found is None else replace(near, base=found)
    return room


def _of(space: Space, pieces: Sequence[Piece], ways: Mapping[str, Candidate], rects: Mapping[str, Rect]) -> Neighbourhood:
    """Returns a room of some pieces in their ways, where they stand."""
    base = Found(tuple(ways[piece.label] for piece in pieces), tuple(rects[piece.label] for piece in pieces))
    return Neighbourhood(space, tuple(pieces), base)
