"""decorations_of(): one room, top to bottom.

Comes in: a furnished Room, its Space, the settings, a Stream. Goes out: its Decorations. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from solver.decorations.decorated_room import Carrier, DecoratedRoom, DecorationSettings
from solver.decorations.on_floor import stand
from solver.decorations.on_surfaces import lay
from solver.decorations.on_walls import hang, hang_free
from solver.pieces import Space
from solver.scene import Decoration, Room
from solver.streams import Stream


def decorations_of(room: Room, space: Space, settings: DecorationSettings, stream: Stream) -> tuple[Decoration, ...]:
    """Returns what decorates a furnished room; its furniture stays as it is.

    Args:
        room: furnished at right angles.
        space: its clear rectangle, and what its doors and windows keep free.
        settings: with what, in which style, how high the room is.
        stream: of random numbers, the room's own.
    """
    decorated = DecoratedRoom(room, space, settings, stream)
    for group in _groups(decorated):
        lay(decorated, group)
    for piece in decorated.pieces:
        hang(decorated, piece)
    hang_free(decorated)
    _lay_on_things(decorated)
    stand(decorated)
    return tuple(decorated.things)


def _groups(decorated: DecoratedRoom) -> list[list[Carrier]]:
    """Returns the pieces one by one, or together where their dressing says so."""
    groups: dict[str, list[Carrier]] = {}
    for piece in decorated.pieces:
        entry = decorated.catalogs.dressing.get(piece.name)
        groups.setdefault(piece.name if entry and entry.together else piece.id, []).append(piece)
    return list(groups.values())


def _lay_on_things(decorated: DecoratedRoom) -> None:
    """Lays things on the things that have a dressing of their own: a mounted shelf is a parent like any other."""
    for thing in decorated.made:  # grows meanwhile
        if thing.surfaces:
            lay(decorated, [thing])
