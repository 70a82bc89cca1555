"""From a list of pieces with relations, asked for by a user, to pieces to be placed whose candidates hold those relations.

The work is the core's: solver/core/furnish/listed.hpp says what a candidate holds, and what it pays for.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from math import inf
from operator import attrgetter
from struct import Struct
from typing import Final, NamedTuple

from catalogs.schema import RelationSpec
from solver.core import ask
from solver.furnish.compiled_types import FloorAbout, KindTables
from solver.furnish.core_rows import Answer, answer_of, candidate_of, labels_in, links_of, room_rows
from solver.furnish.habits import Habits
from solver.geometry import to_mm
from solver.pieces import Candidate, Piece, Placed, Space, Stance, Zone
from solver.relations.subject import Kind
from solver.requested import PieceRequest
from solver.scene import WALL_NUMBERS, Room

_LIST: Final = Struct("<6i")
_ASKED: Final = Struct("<6i4q2i")
_STANDS: Final = Struct("<4q2iq")
_SURE: Final = Struct("<d")
_NOWHERE: Final = (0, 0, 0, 0)
_FREE: Final = Stance(0)
_COST: Final = attrgetter("cost")


@dataclass(frozen=True)
class ListedPieces:
    """The pieces of a list, each with its candidates, behind those that stand already.

    A placement costs at least `sure_cost` that takes a candidate which a limit kept out; one that costs no more is the best of all.
    `unpaid` are (piece, relation) that no candidate pays for: to any of several later pieces.
    """

    pieces: tuple[Piece, ...]
    sure_cost: float
    unpaid: Sequence[tuple[str, RelationSpec]]


class _Rows(NamedTuple):
    """A list as the core reads it: its kinds and relations; the room; the pieces, how many stand already, and their labels."""

    kinds: bytes
    room: bytes
    pieces: bytes
    standing: int
    labels: Sequence[str]


@dataclass(frozen=True)
class Listing:
    """What is asked for in a room, each piece after those its relations refer to; a relation to a later one is left to the caller.

    `kinds` are theirs and those of what stands already, by id; `habits` say where those stand best that say nothing of it; `there` stands
    already, one candidate each. `zones` are the room's own: their edges are walls, those of what stands, which `space` may have, are not.
    """

    room: Room
    space: Space
    zones: tuple[Zone, ...]
    requests: Sequence[PieceRequest]
    kinds: Mapping[str, Kind]
    habits: Habits
    there: Sequence[Piece]
    floors: Mapping[str, Sequence[FloorAbout]]
    """What the fronts of those kinds open over, by id."""
    ceiling: float | None = None
    """How high the room is, m, where that is known."""

    @cached_property
    def listed(self) -> Mapping[str, PieceRequest]:
        """The requests of the pieces of the list, by label."""
        return {label: request for request in self.requests for label in request.labels}

    @cached_property
    def few(self) -> ListedPieces:
        """The pieces, with the few candidates each that find a good placement of any list."""
        return self._with(self._asked(every=False))

    @cached_property
    def nearly_all(self) -> ListedPieces | None:
        """The pieces with nearly all their candidates, to prove a placement the best; None where these are too many."""
        data = self._asked(every=True)
        return None if _SURE.unpack_from(data)[0] < 0 else self._with(data)

    def between(self, placed: Sequence[Placed], loose: Collection[str]) -> tuple[Piece, ...]:
        """Returns the few, those labelled so with further candidates: where all their relations hold with the rest as it stands."""
        made = self._pieces(answer_of(self._asked(every=False, placed=placed, loose=loose)), self.few.pieces)
        further = {piece.label: piece.candidates for piece in made}
        ways = ((*further.get(piece.label, ()), *piece.candidates) for piece in self.few.pieces)
        return tuple(replace(piece, candidates=tuple(sorted(own, key=_COST))) for piece, own in zip(self.few.pieces, ways, strict=True))

    def relations(self, label: str) -> Sequence[RelationSpec]:
        """Returns what a piece of the list wishes for, or what is usual."""
        return self.listed[label].relations or self.habits.relations.get(label, ())

    @cached_property
    def _rows(self) -> _Rows:
        return _ListTables().of(self)

    @cached_property
    def fronts(self) -> tuple[Piece, ...]:
        """The floor that the fronts of the pieces open over, at each that has such."""
        answer = answer_of(self._asked(every=False, fronts=True))
        return tuple(piece for piece in self._pieces(answer, self.there) if piece.is_floor)

    def _asked(self, every: bool, placed: Sequence[Placed] = (), loose: Collection[str] = (), fronts: bool = False) -> bytes:
        kinds, room, pieces, standing, labels = self._rows
        poses = {one.label: one for one in placed}
        stands = [_stands_row(poses.get(label), label in loose) for label in labels] if placed else []
        head = _LIST.pack(standing, len(labels) - standing, len(stands), every, fronts, 0)
        return ask("listed_pieces", kinds, b"".join((room, head, pieces, *stands)))

    def _with(self, data: bytes) -> ListedPieces:
        answer, labels = answer_of(data), self._rows.labels
        unpaid = [(labels[piece], self.relations(labels[piece])[rule]) for piece, rule in answer.counted]
        return ListedPieces((*self.there, *self._pieces(answer, self.there)), _SURE.unpack_from(data)[0], unpaid)

    def _pieces(self, answer: Answer, known: Sequence[Piece]) -> list[Piece]:
        kinds, labels = [*self.kinds.values()], labels_in(answer, self._rows.labels)
        candidates, links = (candidate_of(row, kinds, labels) for row in answer.candidates), iter(links_of(answer, labels))
        pieces, stances = list[Piece](), {piece.label: _stances(piece.candidates) for piece in known}
        most = inf if self.ceiling is None else to_mm(self.ceiling)
        for label, (at, _, number, ways, bonds, side, required, _, skip_cost) in zip(labels, answer.pieces, strict=True):
            raised, bound = _raised(islice(candidates, ways), stances), tuple(islice(links, bonds))
            if side >= 0:
                pieces.append(Piece(label, bool(required), tuple(raised), skip_cost=skip_cost, is_floor=True))
                continue
            own, kind = tuple(way for way in raised if way.bottom_mm + way.size_mm[2] <= most), kinds[number]
            stances.setdefault(label, _stances(own))
            if at >= self._rows.standing:
                only = kind.name, kind.size
                pieces.append(Piece(label, bool(required), own, bound, kind.stands, kind.need_all, skip_cost=skip_cost, only=only))
        return pieces


def _stances(ways: Iterable[Candidate]) -> Sequence[Stance]:
    """Returns how ways stand, each once."""
    return [*dict.fromkeys(way.stance for way in ways if way.stance)]


def _raised(ways: Iterable[Candidate], stances: Mapping[str, Sequence[Stance]]) -> Iterator[Candidate]:
    """Yields the ways of a piece, those at another one, by label, once for each height at which that stands so: on it, as much higher.

    Floor at a piece is there however that stands.
    """
    for way in ways:
        attach = way.attach
        if attach is None:
            yield way
            continue
        for stance in stances[attach.parent]:
            if attach.parent_stance is None or stance[:2] == attach.parent_stance[:2]:
                bottom = way.bottom_mm + (stance.bottom_mm if way.on or way.stance is None else 0)
                at = attach._replace(parent_stance=stance)
                yield replace(way, attach=at, bottom_mm=bottom, stance=way.stance and way.stance._replace(bottom_mm=bottom))


def _stands_row(placed: Placed | None, is_loose: bool) -> bytes:
    """Returns where a piece stands, and how, as a row."""
    stance = placed.chosen.stance if placed else None
    rotation, wall, _ = stance or _FREE
    return _STANDS.pack(*(placed.footprint if placed and stance else _NOWHERE), rotation, WALL_NUMBERS[wall], is_loose)


class _ListTables(KindTables):
    """The tables of a list while they are written."""

    def of(self, listing: Listing) -> _Rows:
        """Returns a list as the core reads it."""
        number = {name: k for k, name in enumerate(listing.kinds)}
        there = [piece for piece in listing.there if piece.label in number]
        rows = []
        for piece in there:
            way, word = piece.candidates[0], self._word(piece.label)
            rotation, wall, _ = way.stance or _FREE
            rows.append(_ASKED.pack(word, word, number[piece.label], 1, 0, 0, *(way.within or _NOWHERE), rotation, WALL_NUMBERS[wall]))
        for label, request in listing.listed.items():
            rules = self._added("rule", listing.habits.dealt.get(label) or listing.relations(label), self._rule)
            words = self._word(label), self._word(request.id)
            cell = listing.habits.cells.get(label, _NOWHERE)
            rows.append(_ASKED.pack(*words, number[request.id], request.required, *rules, *cell, _FREE.rotation, WALL_NUMBERS[None]))
        for name, kind in listing.kinds.items():
            self._add_kind(kind, listing.floors.get(name, ()), 0)
        room = room_rows(listing.room, replace(listing.space, zones=listing.zones), 0.0, 0)
        labels = [*(piece.label for piece in there), *listing.listed]
        return _Rows(self._packed(len(self._words), False, 0), room, b"".join(rows), len(there), labels)


def tucks(spec: RelationSpec) -> bool:
    """Tells whether a relation lets a piece reach under another one, as far as their parts do not cross."""
    return spec.type == "under" or (spec.gap is not None and spec.gap[0] < 0)
