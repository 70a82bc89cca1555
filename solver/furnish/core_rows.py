"""Rooms as the core reads them, and pieces from the rows it answers with (solver/core/furnish/furnish.cpp).

Comes in: a room's scope and space. Goes out: bytes for the core; from its bytes, the pieces and how many of each were wanted.
"""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct
from typing import Any, Final, NamedTuple

from solver.furnish.compiled_types import RELATION_WORDS, SIDES, WALLS_ASKED, CompiledType
from solver.pieces import Attach, Candidate, Link, Piece, Stand, Zone
from solver.relations.subject import Scope
from solver.scene import WALLS

_ROOM: Final = Struct("<Qd5q4i")
_OPENED: Final = Struct("<2i3q")
_ZONE: Final = Struct("<5q")
_ANSWER: Final = Struct("<Q4i")
_COUNT: Final = Struct("<2i")
_PIECE: Final = Struct("<6i")
_CANDIDATE: Final = Struct("<10i8q2d")
_LINK: Final = Struct("<6i5d")
_OPENING: Final = {"door": 0, "garage_door": 1, "window": 2, "passage": 3}
_WALL: Final = {wall: i for i, wall in enumerate(WALLS)}
_WALL_NAMES: Final = (*WALLS, None)
_SIDE, _SEAT, _SURFACE = 1, 2, 3
"""What a slot is called by."""


class Answer(NamedTuple):
    """What the core says: the stream's state at the end, (spec, copies) in the order of importance, and the pieces' rows."""

    state: int
    counted: list[tuple[int, int]]
    pieces: list[tuple[Any, ...]]
    candidates: list[tuple[Any, ...]]
    links: list[tuple[Any, ...]]


def room_rows(scope: Scope, zones: Sequence[Zone], area: float, state: int, counts_only: bool = False) -> bytes:
    """Returns a room as bytes.

    Args:
        scope: the room.
        zones: its space's.
        area: between its wall lines, m2.
        state: the stream's.
        counts_only: no piece is to be furnished, only counted.
    """
    openings, exterior = scope.openings, scope.exterior
    walls = sum(1 << i for i, wall in enumerate(WALLS) if getattr(exterior, wall))
    rows = [_ROOM.pack(state, area, *scope.clear, scope.gap_mm, walls, len(openings), len(zones), counts_only)]
    rows += [_OPENED.pack(_OPENING.get(one.kind, -1), _WALL[one.wall], *one.interval, one.across) for one in openings]
    rows += [_ZONE.pack(*zone.rect, zone.above_mm) for zone in zones]
    return b"".join(rows)


def answer_of(data: bytes) -> Answer:
    """Reads the core's answer."""
    state, *sizes = _ANSWER.unpack_from(data)
    at, tables = _ANSWER.size, []
    for row, size in zip((_COUNT, _PIECE, _CANDIDATE, _LINK), sizes, strict=True):
        end = at + row.size * size
        tables.append(list(row.iter_unpack(data[at:end])))
        at = end
    return Answer(state, *tables)


def pieces_of(answer: Answer, known: CompiledType) -> tuple[Piece, ...]:
    """Returns the pieces of an answer."""
    labels = [f"{known.specs[spec].piece}_{number}" for spec, number, *_ in answer.pieces]
    candidates, links = iter(_candidates(answer, known, labels)), iter(_links(answer, labels))
    pieces = []
    for label, (spec_at, _, kind_at, ways, bonds, _) in zip(labels, answer.pieces, strict=True):
        spec, kind = known.specs[spec_at], known.kinds[kind_at]
        pieces.append(
            Piece(
                label,
                spec.required,
                tuple(next(candidates) for _ in range(ways)),
                links=tuple(next(links) for _ in range(bonds)),
                stands=tuple(Stand(side) for side in spec.approach) or kind.stands,
                need_all=bool(spec.approach) or kind.need_all,
                skip_cost=spec.skip_cost,
                with_next=spec.with_next,
            )
        )
    return tuple(pieces)


def _candidates(answer: Answer, known: CompiledType, labels: Sequence[str]) -> list[Candidate]:
    kinds, found = known.kinds, list[Candidate]()
    for row in answer.candidates:
        kind_at, rotation, wall, parent, parent_kind, slot, side, is_under, is_on, _, number, x, z, *spans, bottom, weight, cost = row
        kind, label, attach = kinds[kind_at], None, None
        if parent >= 0:
            label, other = labels[parent], kinds[parent_kind]
            name = SIDES[side] if slot != _SURFACE else f"on {other.levels[number].name}"
            attach = Attach(label, other.name, (spans[0], spans[1]), (spans[2], spans[3]), f"{name} {number}" if slot == _SEAT else name)
        made = object.__new__(Candidate)
        own = made.__dict__  # a frozen dataclass's own `__init__` takes three times as long, and there are a hundred in a room
        own["kind"], own["size_mm"], own["rotation"], own["wall"] = kind.name, kind.size, rotation, _WALL_NAMES[wall]
        own["anchor_mm"], own["weights"], own["within"], own["cost"] = (x, z), (weight, weight), None, cost
        own["bottom_mm"], own["attach"], own["slack_mm"], own["stance"] = bottom, attach, None, None
        own["under"], own["on"] = label if is_under else None, label if is_on else None
        found.append(made)
    return found


def _links(answer: Answer, labels: Sequence[str]) -> list[Link]:
    return [
        Link(RELATION_WORDS[word], labels[of], None if turn < 0 else turn, WALLS_ASKED[walls], cost, bool(required), *pulls)
        for word, of, turn, walls, required, _, cost, *pulls in answer.links
    ]
