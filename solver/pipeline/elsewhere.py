"""What rooms hold that others ask for before they want a piece: a table to eat at stands once in a home."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from catalogs import Catalogs
from solver.furnished import names_placed
from solver.pieces import Arrangement
from solver.scene import Room


def asks(room: Room, catalogs: Catalogs) -> bool:
    """Tells whether what a room wants depends on what others hold."""
    kind = catalogs.rooms.get(room.type)
    return kind is not None and kind.asks_elsewhere


def needed(room: Room, catalogs: Catalogs) -> set[str]:
    """Returns the labels of what a room wants where no other room has such: the table that stands nowhere else, not each chair at it."""
    kind = catalogs.rooms.get(room.type)
    return {f"{name}_1" for piece in kind.pieces for name in piece.unless_elsewhere} if kind else set()


def held(rooms: Iterable[Room], catalogs: Catalogs) -> set[str]:
    """Returns the names of all pieces in rooms that do not ask themselves."""
    return {piece.name for room in rooms if not asks(room, catalogs) for piece in room.furniture}


def arranged(arrangements: Mapping[str, Arrangement], catalogs: Catalogs) -> set[str]:
    """Returns the names of all pieces of some arrangements."""
    return {name for one in arrangements.values() for name in names_placed(one, catalogs)}


def parted(rooms: Sequence[Room], catalogs: Catalogs) -> tuple[list[Room], list[Room]]:
    """Returns the rooms that are furnished first, and those that ask what stands in them."""
    return [room for room in rooms if not asks(room, catalogs)], [room for room in rooms if asks(room, catalogs)]
