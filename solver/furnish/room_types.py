"""From a room type's pieces and their relations to pieces to be placed: which, in which order, and their candidates.

The work is the core's: solver/core/furnish. Of what a type lists, rooms under a ceiling want the kinds that are no higher than they are.
"""

from collections.abc import Mapping, Sequence, Set
from dataclasses import replace
from functools import lru_cache, partial
from typing import NamedTuple

from catalogs.checks import OPENINGS
from catalogs.schema import Catalogs, PieceSpec, RoomType
from solver.core import ask
from solver.furnish.compiled_types import CompiledType, compiled_type
from solver.furnish.core_rows import NOBODY, Answer, answer_of, candidate_in, label_of, pieces_of, place_rows, room_rows
from solver.furnish.zones import floor_before_doors
from solver.pieces import Piece, Space, WantedRows
from solver.scene import Room
from solver.streams import Stream


def wanted_pieces(room: Room, space: Space, catalogs: Catalogs, stream: Stream, insisted: str | None = None) -> tuple[Piece, ...]:
    """Returns what a room wants, required pieces first, each with its candidates; of a type the catalogs do not know nothing.

    The room's own stream draws optional pieces and which of equal walls is preferred. The piece whose label is `insisted` is wanted as if
    it were required (solver/core/furnish/demanded.hpp).

    Raises:
        CoreFailed: an error within the core.
    """
    room_type = _type_of(room, catalogs)
    if room_type is None:
        return ()
    known = compiled_type(room_type, catalogs, room.type)
    floor = _with_approaches(room, space, catalogs)
    answer = _asked(known, room_rows(room, floor, room.floor_m2, stream.state, _copy_called(insisted, known)))
    stream.state = answer.state
    return pieces_of(answer, known)


def wanted_rows(room: Room, space: Space, catalogs: Catalogs, stream: Stream, insisted: str | None = None) -> WantedRows:
    """Returns what the core needs to furnish a room as `wanted_pieces` does, and to place what that wants; the stream stays as it is."""
    known = compiled_type(_type_of(room, catalogs), catalogs, room.type)
    floor = _with_approaches(room, space, catalogs)
    rows = room_rows(room, floor, room.floor_m2, stream.state, _copy_called(insisted, known))
    told = partial(label_of, known), partial(candidate_in, known)
    return WantedRows(space, known.data, rows + place_rows(space), known.named, known.looks, *told)


def _copy_called(label: str | None, known: CompiledType) -> tuple[int, int]:
    """Returns the place of a label's piece in a room's type, and the number of its copy."""
    if label is None:
        return NOBODY
    copies = ((at, number) for at, spec in enumerate(known.specs) for number in range(1, spec.count + 1))
    return next(((at, number) for at, number in copies if f"{known.specs[at].piece}_{number}" == label), NOBODY)


def unwanted_pieces(room: Room, space: Space, catalogs: Catalogs, stream: Stream, wanted: Sequence[Piece]) -> tuple[tuple[str, str], ...]:
    """Returns the pieces of a room's type of which fewer are wanted than it lists, each with the reason for a person.

    `wanted` is what `wanted_pieces` returned, `stream` as it was given to it, new.

    Raises:
        CoreFailed: an error within the core.
    """
    room_type = catalogs.rooms.get(room.type)
    if room_type is None:
        return ()
    area, labels = room.floor_m2, {piece.label for piece in wanted}
    found = [(spec.piece, f"only in a home planned without {', '.join(spec.without)}") for spec in room_type.pieces if spec.without]
    known = compiled_type(_type_of(room, catalogs), catalogs, room.type)
    found += [(spec.piece, "only where one enters the home") for spec in room_type.pieces if spec.entered and spec not in known.specs]
    for at, copies in _asked(known, room_rows(room, space, area, stream.state)).counted:
        spec = known.specs[at]
        if any(f"{spec.piece}_{number}" not in labels for number in range(1, copies + 1)):
            found.append((spec.piece, _why_nowhere(spec, labels)))
        elif copies < spec.count:
            found.append((spec.piece, _why_fewer(spec, area, copies)))
    return tuple(found)


def _with_approaches(room: Room, space: Space, catalogs: Catalogs) -> Space:
    """Returns a room's space with the floor before doors that what the home is made for asks for."""
    if catalogs.profile is None or room.type not in catalogs.rooms or catalogs.rooms[room.type].outdoor:
        return space
    floors = floor_before_doors(room, space.clear, catalogs.profile)
    return replace(space, approaches=tuple(floors)) if floors else space


def _type_of(room: Room, catalogs: Catalogs) -> RoomType | None:
    """Returns a room's type; one that nobody enters the home by goes without what is wanted only there."""
    kind = catalogs.rooms.get(room.type)
    return kind if kind is None or any(opening.main_entrance for opening in room.openings) else _not_entered(catalogs, room.type)


@lru_cache(maxsize=1024)
def _not_entered(catalogs: Catalogs, name: str) -> RoomType:
    """Returns a room type without what is wanted only where one enters; the same object each time, as what is compiled is kept by it."""
    kind = catalogs.rooms[name]
    pieces = tuple(spec for spec in kind.pieces if not spec.entered)
    return kind if len(pieces) == len(kind.pieces) else kind.model_copy(update={"pieces": pieces})


def _asked(known: CompiledType, room: bytes) -> Answer:
    """Asks the core what a room wants."""
    return answer_of(ask("furnish", known.data, room))


def _why_nowhere(piece: PieceSpec, wanted: Set[str]) -> str:
    """Says for a person why a piece has no place in the room, beside the labels of what is wanted."""
    names = {label.rpartition("_")[0] for label in wanted} | set(OPENINGS)
    required = [rule for rule in piece.rules if rule.required]
    alone = next((rule for rule in required if rule.of and not names.intersection(rule.of)), None)
    if alone is not None:
        return f"it has to be {alone.type} {' or '.join(alone.of)}, and none is wanted"
    needs = ", ".join(" ".join((rule.type, *rule.of)) for rule in required)
    return f"no place of the kind its relations ask for: {needs}" if needs else "its run has no room for it"


def _why_fewer(piece: PieceSpec, area: float, copies: int) -> str:
    """Says for a person why fewer of a piece than its `count` are wanted in a room of that area, m2."""
    if area < piece.min_area:
        return f"needs {piece.min_area:g} m2"
    if copies == 0:
        return f"by chance {piece.chance:g}, not drawn"
    assert piece.per_area is not None, "the whole count is wanted, or none"
    most = max(1, min(piece.count, int(area / piece.per_area)))
    least = (most + 1) // 2
    drawn = "" if least == most else f", drawn from {least} to {most}"
    return f"{copies} of at most {piece.count}: one for every {piece.per_area:g} m2{drawn}"


class LowRooms(NamedTuple):
    """Catalogs whose room types list what fits under a ceiling; by room type the pieces of which nothing does, and why."""

    catalogs: Catalogs
    left_out: Mapping[str, tuple[tuple[str, str], ...]]


@lru_cache(maxsize=64)
def as_low_as(height: float, catalogs: Catalogs) -> LowRooms:
    """Returns what rooms of a height, m, can hold; the same catalogs where that is all of it."""

    def fits(kind: str) -> bool:
        return catalogs.furniture[kind].size[2] <= height

    rooms, left_out = dict(catalogs.rooms), dict[str, tuple[tuple[str, str], ...]]()
    for name, room in catalogs.rooms.items():
        if room.outdoor or all(fits(one.kind) for piece in room.pieces for one in piece.variants):
            continue
        kinds = [(piece, tuple(one for one in piece.variants if fits(one.kind))) for piece in room.pieces]
        stand = [(piece, own) for piece, own in kinds if any(one.corner is None for one in own)]
        pieces = tuple(piece if own == piece.variants else piece.model_copy(update={"kinds": own}) for piece, own in stand)
        rooms[name] = room.model_copy(update={"pieces": pieces})
        there = {piece.piece for piece in pieces}
        gone = (piece for piece in room.pieces if piece.piece not in there and not piece.without)
        left_out[name] = tuple((f"{piece.piece}_1", _why_too_high(piece, height, catalogs)) for piece in gone)
    if not left_out:
        return LowRooms(catalogs, {})
    return LowRooms(catalogs.model_copy(update={"rooms": rooms, "home": f"{catalogs.home} {height} m high"}), left_out)


def _why_too_high(piece: PieceSpec, height: float, catalogs: Catalogs) -> str:
    lowest = min((one.kind for one in piece.variants), key=lambda kind: catalogs.furniture[kind].size[2])
    return f"the lowest, {lowest}, is {catalogs.furniture[lowest].size[2]:.2f} m high, and the room {height:.2f} m"
