"""decorated_room(): one room.

Comes in: a furnished Room, its Space, the settings, a Stream. Goes out: the Room, decorated. May import: the ground floor, catalogs. The
work is the core's: solver/core/dress.
"""

from __future__ import annotations

from typing import Final

from solver.core import borrowed
from solver.decorations.compiled_dressing import compiled_dressing
from solver.decorations.decorated_rows import decorated_rows, rows_told, stream_after
from solver.decorations.decoration_settings import DecorationSettings
from solver.demanded import demand
from solver.dressed import dressed
from solver.pieces import Space
from solver.scene import Room
from solver.streams import Stream

PAIR_WORK: Final = 0.4
"""What two pieces of a room cost, at worst: things keep clear of every piece [see demanded.py]. Measured."""


def decorated_room(room: Room, space: Space, settings: DecorationSettings, stream: Stream) -> Room:
    """Returns a furnished room with what decorates it, naming its kinds; the room's furniture stays as it is.

    Args:
        room: furnished at right angles; what decorated it before goes.
        space: its clear rectangle, and what its doors and windows keep free.
        settings: with what, in which style, how high the room is.
        stream: of random numbers, the room's own.

    Raises:
        TooMuch: the call may not have so much work.
        CoreFailed: an error within the core.
    """
    demand(PAIR_WORK * len(room.furniture) ** 2)
    known = compiled_dressing(settings)
    rows = decorated_rows(room, space, known, settings, stream.state)
    with borrowed() as core:
        packed = core.call("dress", core.write(known.data), len(known.data), core.write(rows), len(rows))
        answer = core.read(packed & 0xFFFFFFFF, packed >> 32)
    stream.state = stream_after(answer)
    return dressed(room, rows_told(answer, room, known))
