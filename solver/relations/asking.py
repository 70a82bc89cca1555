"""What Python asks the core of relations (solver/core/furnish/relations/asked.cpp). Lengths are whole millimetres."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain
from struct import Struct, pack
from typing import Final, NamedTuple

from catalogs.schema import RelationSpec
from solver.core import borrowed
from solver.geometry import Rect
from solver.relations.rows import RELATION_WORDS, RULE, WALL, name_row, opened_rows, rule_row, side_numbers
from solver.relations.subject import Scope

_NONE: Final = Rect(0, 0, 0, 0)
_QUESTION: Final = Struct(RULE + "12q8i")


class Traits(NamedTuple):
    """What a word of the vocabulary is like: `relation.hpp` in the core says of what each of these tells; its usual distance, mm."""

    gives_place: bool
    by_degree: bool
    turns: bool
    with_all: bool
    among_copies: bool
    at_walls: bool
    into_line: bool
    usual_mm: int


@dataclass(frozen=True)
class Standing:
    """A body as it stands in a finished room: its footprint, mm, rotation, underside, the wall at its back, what carries it.

    `levels` are the heights of its surfaces above the floor, mm.
    """

    id: str
    rect: Rect
    rotation: int
    bottom: int = 0
    wall: str | None = None
    on: str | None = None
    levels: tuple[int, ...] = ()


@cache
def traits(word: str) -> Traits:
    """Returns what a relation is like, by its word."""
    with borrowed() as core:
        told = core.call("relation_traits", RELATION_WORDS.index(word))
    bits = len(Traits._fields) - 1
    return Traits._make([*(bool(told >> bits - 1 - k & 1) for k in range(bits)), told >> bits])


def holds_in_room(scope: Scope, spec: RelationSpec, own: Standing, names: Sequence[str] = ()) -> bool:
    """Tells whether a relation to the room, or to any opening of those names, holds."""
    return _holds(_question(spec, own, own, names, scope), True)


def holds_with(spec: RelationSpec, own: Standing, other: Standing) -> bool:
    """Tells whether a relation to another piece holds."""
    return _holds(_question(spec, own, other, (), None), False)


def _question(spec: RelationSpec, own: Standing, other: Standing, names: Sequence[str], scope: Scope | None) -> bytes:
    """Returns a question as bytes: of a body and another one, or of one and its room."""
    sides, openings = side_numbers(spec.sides), scope.openings if scope else ()
    rests = own.on == other.id and own.bottom in other.levels
    head = _QUESTION.pack(
        *rule_row(spec, (0, len(names)), (0, len(sides)), (0, 0)), *(scope.clear if scope else _NONE), *own.rect, *other.rect, own.rotation,
        other.rotation, WALL[own.wall], WALL[other.wall], rests, len(sides), len(names), len(openings),
    )  # fmt: skip
    words = [*sides, *([0] if len(sides) % 2 else []), *chain.from_iterable(name_row(0, name) for name in names)]
    return b"".join((head, pack(f"<{len(words)}i", *words), opened_rows(openings)))


def _holds(question: bytes, in_room: bool) -> bool:
    with borrowed() as core:
        return bool(core.call("relation_holds", core.write(question), len(question), in_room))
