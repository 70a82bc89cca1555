"""From a list of pieces with relations, asked for by a user, to pieces to be placed whose candidates hold those relations.

Unlike a room type's relations, which cost by degree, a relation asked for is held or not. So every candidate says which it
holds: those to the room by a rectangle that its footprint stays in, those to another piece by a box in that piece's frame, for
each way that other piece may be turned. What a candidate does not hold, it pays for.
"""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf
from operator import attrgetter
from typing import NamedTuple

from catalogs.schema import RelationSpec
from solver.furnish.attached import UNSURE, attached, between_others
from solver.furnish.habits import Habits
from solver.furnish.stances import FEW, Costed, Kept, ListedPiece, PairRelation, within_both
from solver.furnish.zones import scope_of
from solver.geometry import ALONG_X, Rect, turned
from solver.pieces import Candidate, Piece, Placed, Space, Stance
from solver.relations.asking import pulls, traits
from solver.relations.subject import Footing, Kind, Parent, Subject
from solver.requested import PieceRequest
from solver.scene import Room

PULL = 0.03
"""Pull of a piece to where a candidate would like it best, m^-2: order, not preference."""
FREE_COST = 0.2
"""What standing in the middle of the room costs a piece that may also stand at a wall."""
GONE = 100.0
"""What it costs that a piece which is not required is missing."""
ELSEWHERE = 1.0
"""What standing elsewhere than in its own part of the floor costs a piece."""

_cost = attrgetter("cost")


@dataclass(frozen=True)
class ListedPieces:
    """The pieces of a list, each with its candidates, behind those that stand already; and what these are made from, by label.

    `unpaid` are (piece, relation) that no candidate pays for: to any of several later pieces.
    """

    pieces: tuple[Piece, ...]
    listed: Mapping[str, ListedPiece]
    unpaid: Sequence[tuple[str, RelationSpec]]

    @cached_property
    def sure_cost(self) -> float:
        """What a placement costs at least that takes a candidate which a limit kept out; one that costs no more is the best of all."""
        least = {piece.label: min(map(_cost, piece.candidates), default=0.0) for piece in self.pieces}
        more = [min(one.dropped) - least[label] for label, one in self.listed.items() if one.dropped]
        more += [one.kept.dear for one in self.listed.values() if one.unlikely]
        return sum(least.values()) + max(0.0, min(more, default=inf))

    def between(self, placed: Sequence[Placed], labels: Container[str]) -> tuple[Piece, ...]:
        """Returns the pieces, those labelled so with further candidates: where all their relations hold with the rest as it stands."""
        poses = {one.label: one for one in placed}
        return tuple(
            replace(piece, candidates=_by_cost(between_others(self.listed[piece.label], poses), piece.candidates))
            if piece.label in labels and piece.label in self.listed
            else piece
            for piece in self.pieces
        )


def _by_cost(*found: Sequence[Candidate]) -> tuple[Candidate, ...]:
    return tuple(sorted((candidate for some in found for candidate in some), key=_cost))


class Listing(NamedTuple):
    """What is asked for, each piece after those its relations refer to; a relation to a later one is left to the caller.

    `kinds` are theirs and those of what stands already, by id; `habits` say where those stand best that say nothing of it.
    """

    requests: Sequence[PieceRequest]
    kinds: Mapping[str, Kind]
    habits: Habits


def listed_pieces(room: Room, space: Space, listing: Listing, standing: Sequence[Piece]) -> ListedPieces:
    """Returns the pieces of a list, in its order, behind those that stand already, one candidate each; of the others few each."""
    found = kept_pieces(room, space, listing, standing, FEW)
    assert found is not None, "few candidates are no more than are kept in all"
    return found


def kept_pieces(room: Room, space: Space, listing: Listing, standing: Sequence[Piece], kept: Kept) -> ListedPieces | None:
    """Returns what `listed_pieces` does, with as many candidates as are kept; None where these are too many in all."""
    requests, kinds, habits = listing
    scope = scope_of(room, space)
    pieces = list(standing)
    labels = {one.label: (one.label,) for one in pieces}
    parents: dict[str, tuple[Parent, ...]] = {
        one.label: (Parent(one.label, kinds[one.label], one.candidates[0].stance),) for one in pieces if one.label in kinds
    }
    reach = {key: rect for one in pieces for key, rect in _reach(one, space.clear).items()}
    asked = [spec for request in requests for spec in request.relations]
    named = {name for spec in (*asked, *(spec for specs in habits.relations.values() for spec in specs)) for name in spec.of}
    unlikely: set[tuple[str, Stance]] = set()
    listed: dict[str, ListedPiece] = {}
    meant = {**labels, **{request.id: request.labels for request in requests}}
    for request in requests:
        kind = kinds[request.id]
        for label in request.labels:
            relations = request.relations or habits.relations.get(label, ())
            subject = Subject(scope, ((kind, 0.0),), relations, dict(labels), dict(parents))
            asks = ((name, spec) for name, one in listed.items() for spec in one.subject.relations)
            owed = tuple(PairRelation(spec, name) for name, spec in asks if label in _owing(name, spec, meant))
            listed[label] = ListedPiece(subject, space, reach, frozenset(unlikely), habits.cells.get(label), kept, owed)
            piece = _piece(listed[label], label, request.required)
            pieces.append(piece)
            if sum(len(one.candidates) for one in pieces) > kept.in_all:
                return None
            if {request.id, label} & named:
                reach = reach | _reach(piece, space.clear)
                unlikely |= _unlikely(piece, kept.dear)
            labels[request.id] = (*labels.get(request.id, ()), label)
            labels[label] = labels.get(label, (label,)) if label == request.id else (label,)
            parents[label] = tuple(Parent(label, kind, stance) for stance in _stances(piece))
    later = ((label, spec) for label, one in listed.items() for spec in one.subject.relations if not one.subject.labels(spec.of))
    unpaid = [(label, spec) for label, spec in later if any(name in meant for name in spec.of) and not _owing(label, spec, meant)]
    return ListedPieces(tuple(pieces), listed, unpaid)


def _owing(label: str, spec: RelationSpec, meant: Mapping[str, Sequence[str]]) -> list[str]:
    """Returns the pieces that have to keep to another's relation, those of them that come later: all it is to, or the only one.

    `meant` are the labels that each name of an `of` stands for.
    """
    others = [other for name in spec.of for other in meant.get(name, ()) if other != label]
    return others if spec.type != "on" and (len(others) == 1 or traits(spec.type).with_all) else []


def _stances(piece: Piece) -> dict[Stance, list[Candidate]]:
    """Returns the candidates by their stance, in the order in which these come."""
    found: dict[Stance, list[Candidate]] = {}
    for candidate in piece.candidates:
        if candidate.stance is not None:
            found.setdefault(candidate.stance, []).append(candidate)
    return found


def _reach(piece: Piece, clear: Rect) -> dict[tuple[str, Stance], Rect]:
    """Returns where the centre of a piece may be, by its stance."""
    found: dict[tuple[str, Stance], Rect] = {}
    for stance, candidates in _stances(piece).items():
        width, depth = turned(*candidates[0].size_mm[:2], stance.rotation)
        rects = {candidate.within or clear for candidate in candidates}
        fits = [rect for rect in rects if width <= rect.width and depth <= rect.depth]
        if fits:
            x0, z0 = min(rect.x0 for rect in fits), min(rect.z0 for rect in fits)
            x1, z1 = max(rect.x1 for rect in fits), max(rect.z1 for rect in fits)
            found[piece.label, stance] = Rect(x0 + width // 2, z0 + depth // 2, x1 - width // 2, z1 - depth // 2)
    return found


def _unlikely(piece: Piece, dear: float) -> set[tuple[str, Stance]]:
    """Returns the stances that cost at least `dear` more than the cheapest."""
    costs = {stance: min(map(_cost, candidates)) for stance, candidates in _stances(piece).items()}
    least = min(costs.values(), default=0.0) + dear
    return {(piece.label, stance) for stance, cost in costs.items() if cost >= least}


def _piece(listed: ListedPiece, label: str, required: bool) -> Piece:
    kind, subject = listed.kind, listed.subject
    ways, only = _candidates(listed), (kind.name, kind.size)
    links = [link for spec in listed.to_pieces if ways for link in pulls(spec, subject.labels(spec.of))]
    return Piece(label, required, ways, tuple(links), kind.stands, kind.need_all, skip_cost=GONE, only=only)


def _candidates(listed: ListedPiece) -> tuple[Candidate, ...]:
    """Returns all candidates, cheapest first; none where the piece is too large, or hard relations rule all of them out."""
    every = [(footing, _some(listed, found)) for footing, found in listed.places]
    hard, most = any(spec.required for spec in listed.to_pieces), listed.kept.attached
    alone = [] if hard else list(_alone(listed, every))
    dearest = min(map(_cost, alone), default=inf) + sum(pair.spec.cost for pair in listed.pairs)
    bound = sorted(attached(listed, every, dearest), key=_cost)
    listed.dropped.extend(candidate.cost for candidate in bound[most : most + 1])
    listed.dropped.extend([dearest] if listed.pairs and alone else [])
    return _by_cost(alone, bound[:most])


def _some(listed: ListedPiece, found: Sequence[Costed]) -> list[Costed]:
    """Returns the few that cost least, and the dearest: where nothing is held, a piece can still stand."""
    each = listed.kept.each
    listed.dropped.extend(cost for _, cost in found[each:-1][:1])
    return [*found[:each], *found[each:][-1:]]


def _alone(listed: ListedPiece, every: Sequence[tuple[Footing, Sequence[Costed]]]) -> Iterator[Candidate]:
    """Yields the ways to stand at walls and in the room, attached to nobody."""
    pairs = sum(_unsure(pair.spec) for pair in listed.pairs)
    for footing, found in every:
        for rect, cost in _in_its_cell(listed, footing, found):
            free = FREE_COST if footing.wall is None else 0.0
            yield Candidate(
                listed.kind.name, listed.kind.size, footing.rotation, footing.wall, _anchor(listed, footing, rect), (PULL, PULL),
                within=rect, cost=round(cost + pairs + free, 6), stance=footing.stance,
            )  # fmt: skip


def _unsure(spec: RelationSpec) -> float:
    """Returns what is paid for a relation by a way to stand that does not know whether it holds; without a required one a piece is gone."""
    return GONE if spec.required else spec.cost * (UNSURE if traits(spec.type).by_degree else 1.0)


def _in_its_cell(listed: ListedPiece, footing: Footing, found: Sequence[Costed]) -> Sequence[Costed]:
    """Returns the rectangles of a piece that stands free; its part of the floor first, if it has one, and the others dearer."""
    if listed.cell is None or footing.wall is not None:
        return found
    own = within_both(footing.reach, listed.cell, footing.extent)
    return [*([(own, 0.0)] if own else []), *((other, cost + ELSEWHERE) for other, cost in found)]


def _anchor(listed: ListedPiece, footing: Footing, rect: Rect) -> tuple[int, int]:
    """Returns where in its rectangle a piece would like to stand: in the middle of the longest clear stretch of its wall."""
    x, z = rect.centre
    if footing.wall is None:
        return x, z
    low, high = rect.along(footing.wall)
    cut = [(max(a, low), min(b, high)) for a, b in listed.stretches[footing.wall]]
    a, b = max(cut, key=lambda stretch: stretch[1] - stretch[0], default=(low, high))
    middle = (a + b) // 2 if b > a else (low + high) // 2
    return (middle, z) if footing.wall in ALONG_X else (x, middle)
