"""What Python asks the core of relations (solver/core/furnish/relations/asked.cpp). Lengths are whole millimetres."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain
from struct import Struct, pack
from typing import Final, NamedTuple

from catalogs.schema import RelationSpec
from solver.core import ask, borrowed
from solver.geometry import Rect, turned
from solver.relations.rows import (
    RELATION_WORDS,
    RULE,
    WALL,
    WALLS_ASKED,
    level_row,
    name_row,
    opened_rows,
    part_row,
    rule_row,
    side_numbers,
)
from solver.relations.subject import Footing, Kind, Scope

ANYWHERE: Final = (-100_000, 100_000)
"""A coordinate without an end, of the boxes that the core tells."""
_NONE: Final = Rect(0, 0, 0, 0)
_QUESTION: Final = Struct(RULE + "15q12i")
_RECT: Final = Struct("<4q")
_PLACE: Final = Struct("<5q")


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


class HeldBox(NamedTuple):
    """Where a centre holds a relation to another piece, in that one's frame; the surface there, by its number, or -1."""

    box: Rect
    level: int


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


def suits(spec: RelationSpec, mine: str | None, theirs: str | None) -> bool:
    """Tells whether the walls at the backs of two pieces lie as a relation wants them."""
    return _suits(spec.type, spec.wall, mine, theirs)


@cache
def _suits(word: str, asked: str | None, mine: str | None, theirs: str | None) -> bool:
    with borrowed() as core:
        return bool(core.call("relation_suits", RELATION_WORDS.index(word), WALLS_ASKED.index(asked), WALL[mine], WALL[theirs]))


class _AskedOf(NamedTuple):
    """What of two bodies, or of one and its room, is told with a question; `at` is the own rotation and the other's."""

    reach: Rect
    extent: tuple[int, int]
    at: tuple[int, int]
    wall: str | None = None
    other: Rect = _NONE
    rests: bool = False


def _question(
    spec: RelationSpec, pose: _AskedOf, scope: Scope | None, kinds: tuple[Kind, Kind] | None, names: Sequence[str] | None
) -> bytes:
    """Returns a question as bytes: of a relation, of the names given; as it is sought where `names` are None."""
    of, sides = spec.of if names is None else names, side_numbers(spec.sides)
    own, other = kinds or (None, None)
    openings = scope.openings if scope else ()
    parts = [[part_row(part) for part in kind.parts] if kind else [] for kind in (other, own)]
    levels = [level_row(level, 0) for level in other.levels] if other else []
    counts = len(sides), len(of), len(openings), len(levels), *map(len, parts)
    head = _QUESTION.pack(
        *rule_row(spec, (0, len(of)), (0, len(sides)), (0, 0)), *(scope.clear if scope else _NONE), *pose.reach, *pose.other, *pose.extent,
        own.size[2] if own else 0, *pose.at, WALL[pose.wall], pose.rests, names is not None, *counts, 0,
    )  # fmt: skip
    numbers = [*chain.from_iterable((*levels, *parts[0], *parts[1]))]
    words = [*sides, *([0] if len(sides) % 2 else []), *chain.from_iterable(name_row(0, name) for name in of)]
    return b"".join((head, pack(f"<{len(words)}i", *words), opened_rows(openings), pack(f"<{len(numbers)}q", *numbers)))


def regions(scope: Scope, spec: RelationSpec, footing: Footing) -> list[Rect]:
    """Returns the rectangles in any of which a footprint surely holds a relation to the room; none where it cannot hold so."""
    pose = _AskedOf(footing.reach, footing.extent, (footing.rotation, 0), footing.wall)
    return [Rect(*row) for row in _RECT.iter_unpack(ask("relation_regions", _question(spec, pose, scope, None, None)))]


def boxes(spec: RelationSpec, own: Kind, other: Kind, turn: int) -> list[HeldBox]:
    """Returns the boxes in any of which a centre surely holds a relation to another piece, in that one's frame; best first.

    `turn` is the own rotation there.
    """
    pose = _AskedOf(_NONE, turned(*own.size[:2], turn), (turn, 0), other=Rect(0, 0, *other.size[:2]))
    told = ask("relation_boxes", _question(spec, pose, None, (own, other), None))
    return [HeldBox(Rect(*row), level) for *row, level in _PLACE.iter_unpack(told)]


def holds_in_room(scope: Scope, spec: RelationSpec, own: Standing, names: Sequence[str] = ()) -> bool:
    """Tells whether a relation to the room, or to any opening of those names, holds."""
    return _holds(
        _question(spec, _AskedOf(own.rect, (own.rect.width, own.rect.depth), (own.rotation, 0), own.wall), scope, None, names), True
    )


def holds_with(spec: RelationSpec, own: Standing, other: Standing) -> bool:
    """Tells whether a relation to another piece holds, its `wall` left aside."""
    rests = own.on == other.id and own.bottom in other.levels
    pose = _AskedOf(own.rect, (own.rect.width, own.rect.depth), (own.rotation, other.rotation), own.wall, other.rect, rests)
    return _holds(_question(spec, pose, None, None, ()), False)


def _holds(question: bytes, in_room: bool) -> bool:
    with borrowed() as core:
        return bool(core.call("relation_holds", core.write(question), len(question), in_room))
