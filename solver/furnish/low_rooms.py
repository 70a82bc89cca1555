"""Room types of rooms under a ceiling: of what they list, the kinds that are no higher than the room."""

from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

from catalogs import Catalogs
from catalogs.schema import PieceSpec


class LowRooms(NamedTuple):
    """Catalogs whose room types list what fits under a ceiling; by room type the pieces of which nothing does, and why."""

    catalogs: Catalogs
    left_out: Mapping[str, tuple[tuple[str, str], ...]]


@lru_cache(maxsize=16)
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
        left_out[name] = tuple((f"{piece.piece}_1", _why(piece, height, catalogs)) for piece in gone)
    return LowRooms(catalogs.model_copy(update={"rooms": rooms}), left_out) if left_out else LowRooms(catalogs, {})


def _why(piece: PieceSpec, height: float, catalogs: Catalogs) -> str:
    lowest = min((one.kind for one in piece.variants), key=lambda kind: catalogs.furniture[kind].size[2])
    return f"the lowest, {lowest}, is {catalogs.furniture[lowest].size[2]:.2f} m high, and the room {height:.2f} m"
