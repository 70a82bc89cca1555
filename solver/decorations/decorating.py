"""decorated_rooms(): the rooms of a house. The work is the core's, which reads and answers rows: solver/core/decorate/room.hpp."""

from collections.abc import Iterable
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.body_rows import BodyTurn, DecorationRows, count_furniture, furniture_turns, looks_in, told
from solver.core import borrowed
from solver.decorations.compiled_decorating import CompiledDecorating, DecorationSettings, compiled_decorating
from solver.demanded import demand
from solver.free_places import RECT, furniture_as_told
from solver.geometry import to_mm
from solver.pieces import DOORWAY, Space
from solver.scene import WALL_NUMBERS, Opening, Room
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


OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
_ROOM: Final = Struct("<Q4q2d4q10i")
_OPENING: Final = Struct("<2i4q")
_ANSWER: Final = Struct("<Qq")


def decorated_rows(room: Room, space: Space, known: CompiledDecorating, settings: DecorationSettings, state: int) -> bytes:
    """Returns a room that is furnished at right angles as bytes; `state` is its stream's."""
    manners: dict[BodyTurn, int] = {}
    numbers = [manners.setdefault(one, len(manners)) for one in furniture_turns(room)]
    openings = [_opening(opening) for opening in room.openings if opening.wall is not None]
    kept = settings.kept.get(room.id, ())
    counts = len(numbers), len(openings), len(space.zones), len(space.rows[1]) // DOORWAY.size, len(kept), len(manners)
    flags = known.words.get(room.type, -1), room.outdoor, not room.outline, bool(room.accent)
    lines = to_mm(room.width), to_mm(room.depth)
    rows = [_ROOM.pack(state, *space.clear, room.width, room.depth, *lines, to_mm(settings.height), space.robot_mm, *flags, *counts)]
    rows += [furniture_as_told(room), pack(f"<{len(numbers)}q", *numbers), *map(known.manners.rows.__getitem__, manners)]
    return b"".join([*rows, *openings, *space.rows, *(RECT.pack(*rect) for rect in kept)])


def _opening(opening: Opening) -> bytes:
    """Returns where nothing hangs at an opening."""
    half, top = opening.width / 2, opening.sill + opening.height
    along = to_mm(opening.position - half) - OPENING_MM, to_mm(opening.position + half) + OPENING_MM
    return _OPENING.pack(WALL_NUMBERS[opening.wall or ""], 0, *along, to_mm(opening.sill) - OPENING_MM, to_mm(top) + OPENING_MM)


def stream_after(answer: bytes) -> int:
    """Returns the stream's state at the end."""
    return int(_ANSWER.unpack_from(answer)[0])


def rows_told(answer: bytes, room: Room, known: CompiledDecorating) -> DecorationRows:
    """Returns the things of an answer."""
    content = answer[_ANSWER.size :]
    return DecorationRows(content, room, looks_in(content, known.looks), known.colours, known.styled)
