"""Rooms as the core reads them, and pieces from the rows it answers with (solver/core/furnish/furnish.cpp)."""

from collections.abc import Sequence
from itertools import starmap
from struct import Struct
from typing import Any, Final, NamedTuple

from solver.furnish.compiled_types import CompiledType
from solver.geometry import WALL_BEHIND, Rect
from solver.pieces import DOORWAY, Attach, Candidate, Link, Piece, Space, Stance, Stand
from solver.relations.subject import NO_SIDES, RELATION_WORDS, SIDES, WALLS_ASKED, Kind, opened_rows
from solver.scene import WALLS, Room

_ROOM: Final = Struct("<Qd5q6i")
_ANSWER: Final = Struct("<Q4i")
_COUNT: Final = Struct("<2i")
_PIECE: Final = Struct("<8id")
_CANDIDATE: Final = Struct("<12i12q2d2q")
_LINK: Final = Struct("<6i5d")
_WALL_NAMES: Final = (*WALLS, None)
_SIDE, _SEAT, _SURFACE = 1, 2, 3
"""What a slot is called by."""
_STANCES: Final = (None, *map(Stance, WALL_BEHIND), *starmap(Stance, WALL_BEHIND.items()))
"""As the core numbers them."""
_FLOOR: Final = "floor"
"""The kind of floor that is better kept free."""
_FLOORS: Final = ("floor at the", "floor opened over at the", "floor asked for at the")
_RECT: Final = Struct("<4q")
_TURNING, _APPROACH = 12, 13
_PERSON_MM: Final = 1800
"""Height of the space to be kept free there."""
_PLACE: Final = Struct("<3q")


class Answer(NamedTuple):
    """What the core says: the stream's state at the end, (spec, copies) in the order of importance, and the pieces' rows.

    Of a list it says no state, and (piece, relation) of what no candidate pays for.
    """

    state: int
    counted: list[tuple[int, int]]
    pieces: list[tuple[Any, ...]]
    candidates: list[tuple[Any, ...]]
    links: list[tuple[Any, ...]]


NOBODY: Final = (-1, 0)
"""In place of a piece that is insisted on."""


def room_rows(room: Room, space: Space, area: float, state: int, insisted: tuple[int, int] = NOBODY) -> bytes:
    """Returns a room as bytes.

    `area` is that between its wall lines, m2, `state` its stream's, `insisted` the piece that is wanted as if it were required: its place
    in the room's type and the number of the copy.
    """
    exterior = room.exterior_walls or NO_SIDES
    walls = bool(exterior.north) + 2 * bool(exterior.south) + 4 * bool(exterior.east) + 8 * bool(exterior.west)
    counts = len(space.openings), len(space.zones), len(space.approaches)
    rows = _ROOM.pack(state, area, *space.clear, space.gap_mm, walls, *counts, *insisted), opened_rows(space.openings), space.rows[0]
    return b"".join([*rows, *starmap(_RECT.pack, space.approaches)])


def place_rows(space: Space) -> bytes:
    """Returns what placement is asked of a room, as bytes behind its own: PlaceHeader of solver/core/rooms/asking.hpp, and its doorways."""
    return _PLACE.pack(space.robot_mm, space.cover_mm2, len(space.rows[1]) // DOORWAY.size) + space.rows[1]


def answer_of(data: bytes) -> Answer:
    """Reads the core's answer."""
    state, *sizes = _ANSWER.unpack_from(data)
    at, tables = _ANSWER.size, []
    for row, size in zip((_COUNT, _PIECE, _CANDIDATE, _LINK), sizes, strict=True):
        end = at + row.size * size
        tables.append(list(row.iter_unpack(data[at:end])))
        at = end
    return Answer(state, *tables)


def label_of(known: CompiledType, rows: Sequence[tuple[int, int, int]], at: int) -> str:
    """Returns the label of a wanted piece.

    Args:
        known: the room's type.
        rows: of each wanted piece its spec, the number of the copy, and -1; of floor at a side of a piece that piece's place among them and
            the side, four more where fronts open over it, eight more where a standard asks for it; twelve of floor to turn in,
            thirteen of floor before a door.
        at: its place among them.
    """
    spec, number, side = rows[at]
    if side < 0:
        return f"{known.specs[spec].piece}_{number}"
    if side >= _TURNING:
        return "floor to turn in" if side == _TURNING else f"floor before door {number + 1}"
    return _floor_label(side, label_of(known, rows, number))


def _floor_label(side: int, piece: str) -> str:
    return f"{_FLOORS[side // len(SIDES)]} {SIDES[side % len(SIDES)]} of {piece}"


def labels_in(answer: Answer, listed: Sequence[str]) -> list[str]:
    """Returns the labels of a list's pieces, which are called so, and of the floor about them, in an answer."""
    own = [(listed[at], number, side) for at, number, _, _, _, side, *_ in answer.pieces]
    return [label if side < 0 else _floor_label(side, own[number][0]) for label, number, side in own]


def pieces_of(answer: Answer, known: CompiledType) -> tuple[Piece, ...]:
    """Returns the pieces of an answer."""
    named = [(spec, number, side) for spec, number, _, _, _, side, *_ in answer.pieces]
    labels = [label_of(known, named, at) for at in range(len(named))]
    candidates, links = (candidate_of(row, known.kinds, labels) for row in answer.candidates), iter(links_of(answer, labels))
    pieces = []
    for label, (spec_at, _, kind_at, ways, bonds, side, required, with_next, skip_cost) in zip(labels, answer.pieces, strict=True):
        own = tuple(next(candidates) for _ in range(ways))
        if side >= 0:
            pieces.append(Piece(label, bool(required), own, skip_cost=skip_cost, with_next=bool(with_next), is_floor=True))
            continue
        spec, kind = known.specs[spec_at], known.kinds[kind_at]
        pieces.append(
            Piece(
                label,
                bool(required),
                own,
                links=tuple(next(links) for _ in range(bonds)),
                stands=tuple(Stand(side) for side in spec.approach) or kind.stands,
                need_all=bool(spec.approach) or kind.need_all,
                skip_cost=skip_cost,
                with_next=bool(with_next),
            )
        )
    return tuple(pieces)


def candidate_in(known: CompiledType, row: bytes, labels: Sequence[str]) -> Candidate:
    """Returns a candidate from its row."""
    return candidate_of(_CANDIDATE.unpack(row), known.kinds, labels)


def candidate_of(row: tuple[Any, ...], kinds: Sequence[Kind], labels: Sequence[str]) -> Candidate:
    """Returns a candidate from the numbers of its row."""
    kind_at, rotation, wall, parent, parent_kind, slot, side, is_under, is_on, stance, other_stance, _, *lengths = row
    number, x, z, *spans, bottom, weight, cost, wide, deep = lengths
    label, attach, within = None, None, Rect(*spans[4:])
    if parent >= 0:
        label, other = labels[parent], kinds[parent_kind]
        name = "" if not slot else SIDES[side] if slot != _SURFACE else f"on {other.levels[number].name}"
        name = f"{name} {number}" if slot == _SEAT else name
        attach = Attach(label, other.name, (spans[0], spans[1]), (spans[2], spans[3]), name, _STANCES[other_stance])
    made = object.__new__(Candidate)
    own = made.__dict__  # a frozen dataclass's own `__init__` takes three times as long, and there are a hundred in a room
    own["kind"], own["size_mm"] = (_FLOOR, (wide, deep, _PERSON_MM)) if kind_at < 0 else (kinds[kind_at].name, kinds[kind_at].size)
    own["rotation"], own["wall"] = rotation, _WALL_NAMES[wall]
    own["anchor_mm"], own["weights"], own["within"], own["cost"] = (x, z), (weight, weight), within if any(within) else None, cost
    own["bottom_mm"], own["attach"], own["slack_mm"], own["stance"] = bottom, attach, None, _STANCES[stance]
    own["under"], own["on"] = label if is_under else None, label if is_on else None
    return made


def links_of(answer: Answer, labels: Sequence[str]) -> list[Link]:
    """Returns the links of all pieces of an answer, one after the other."""
    return [
        Link(RELATION_WORDS[word], labels[of], None if turn < 0 else turn, WALLS_ASKED[walls], cost, bool(required), *pulls)
        for word, of, turn, walls, required, _, cost, *pulls in answer.links
    ]
