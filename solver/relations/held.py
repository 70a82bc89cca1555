"""Is a relation held? Judged from the poses in a finished room alone, by the core (solver/core/furnish/relations/asked.cpp).

A relation to several holds when it holds with any of them; far_from when it holds with all. A relation to what is not in the
room (an opening it does not have, a piece that found no place) is not held; far_from it is.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import chain
from struct import Struct, pack
from typing import Final, NamedTuple

from catalogs.schema import RelationSpec
from solver.core import borrowed
from solver.geometry import WALL_BEHIND, Rect, extents
from solver.relations.subject import RELATION_WORDS, RULE, Scope, name_row, opened_rows, rule_row, side_numbers
from solver.scene import WALL_NUMBERS, Furniture

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
        other.rotation, WALL_NUMBERS[own.wall], WALL_NUMBERS[other.wall], rests, len(sides), len(names), len(openings),
    )  # fmt: skip
    words = [*sides, *([0] if len(sides) % 2 else []), *chain.from_iterable(name_row(0, name) for name in names)]
    return b"".join((head, pack(f"<{len(words)}i", *words), opened_rows(openings)))


def _holds(question: bytes, in_room: bool) -> bool:
    with borrowed() as core:
        return bool(core.call("relation_holds", core.write(question), len(question), in_room))


AT_WALL_MM = 50
"""A piece whose back is at most this far from a wall's face stands at that wall."""


@dataclass(frozen=True)
class FinishedRoom:
    """A room to be judged: its walls and openings, its bodies by id, and the ids that each name of an `of` stands for."""

    scope: Scope
    bodies: Mapping[str, Standing]
    names: Mapping[str, Sequence[str]]


def standing(piece: Furniture, clear: Rect, heights: Sequence[float] = ()) -> Standing:
    """Returns a piece of a scene as it stands: its bounding rectangle counts, its front is that of the nearest right angle.

    `clear` is the room's clear rectangle, `heights` are those of its surfaces above its underside, m.
    """
    width, depth = (math.ceil(round(length, 6)) for length in extents(piece.width * 1000, piece.depth * 1000, piece.rotation))
    x, z = round(piece.x * 2000), round(piece.z * 2000)
    rect = Rect((x - width) // 2, (z - depth) // 2, (x + width) // 2, (z + depth) // 2)
    bottom = round(piece.y * 1000)
    levels = tuple(bottom + round(height * 1000) for height in heights)
    return at_wall(Standing(piece.id, rect, round(piece.rotation / 90) * 90 % 360, bottom, None, piece.on, levels), clear)


def at_wall(body: Standing, clear: Rect) -> Standing:
    """Returns the body with the wall its back is at, if there is one."""
    wall = WALL_BEHIND[body.rotation]
    return replace(body, wall=wall if body.rect.wall_distance(wall, clear) <= AT_WALL_MM else None)


def held(room: FinishedRoom, label: str, spec: RelationSpec) -> tuple[bool, str | None]:
    """Tells whether a piece's relation is held, and with which piece or opening of those it names."""
    own = room.bodies.get(label)
    if own is None:
        return False, spec.of[0] if spec.of else None
    if not spec.of:
        return holds_in_room(room.scope, spec, own), None
    answers = [(name, _holds_with(room, own, spec, name)) for name in spec.of]
    if traits(spec.type).with_all:
        return all(holds for _, holds in answers), spec.of[0]
    return next(((True, name) for name, holds in answers if holds), (False, spec.of[0]))


def _holds_with(room: FinishedRoom, own: Standing, spec: RelationSpec, name: str) -> bool:
    """Tells whether a relation holds with what a name stands for: any of its pieces, or any opening of that kind."""
    if name not in room.names:
        return holds_in_room(room.scope, spec, own, (name,))
    others = [room.bodies[one] for one in room.names[name] if one in room.bodies and one != own.id]
    return (all if traits(spec.type).with_all else any)(holds_with(spec, own, other) for other in others)
