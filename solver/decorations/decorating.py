"""decorated_rooms(): the rooms of a house. The work is the core's: solver/core/decorate."""

from collections.abc import Iterable
from typing import Final, NamedTuple

from solver.body_rows import count_furniture, told
from solver.core import borrowed
from solver.decorations.compiled_decorating import compiled_decorating
from solver.decorations.decorated_rows import decorated_rows, rows_told, stream_after
from solver.decorations.decoration_settings import DecorationSettings
from solver.demanded import demand
from solver.pieces import Space
from solver.scene import Room
from solver.streams import Stream

PAIR_WORK: Final = 0.4
"""What two pieces of a room cost, at worst: things keep clear of every piece [see demanded.py]. Measured."""


class BareRoom(NamedTuple):
    """A room to be decorated: furnished at right angles; what decorated it before goes.

    `space` is its clear rectangle, and what its doors and windows keep free; `stream` is the room's own.
    """

    room: Room
    space: Space
    stream: Stream


def decorated_rooms(bare: Iterable[BareRoom], settings: DecorationSettings) -> list[Room]:
    """Returns furnished rooms with what decorates them, naming its kinds; their furniture stays as it is.

    Raises:
        TooMuch: the call may not have so much work.
        CoreFailed: an error within the core.
    """
    known, wanted = compiled_decorating(settings), list(bare)
    demand(PAIR_WORK * sum(count_furniture(one.room) ** 2 for one in wanted))
    rows = [decorated_rows(room, space, known, settings, stream.state) for room, space, stream in wanted]
    with borrowed() as core:
        sent = core.send(rows)
        core.call("decorate", core.write(known.data), len(known.data), sent, len(rows))
        answers = [answer for _, answer in core.told(sent, len(rows))]
    for one, answer in zip(wanted, answers, strict=True):
        one.stream.state = stream_after(answer)
    return [told(one.room, rows_told(answer, one.room, known)) for one, answer in zip(wanted, answers, strict=True)]
