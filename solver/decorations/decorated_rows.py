"""Rooms to be decorated as the core reads them, and decorations from the rows it answers with (solver/core/dress/room.hpp).

Comes in: a furnished room and its space. Goes out: bytes for the core; from its bytes, decorations. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from struct import Struct
from typing import Final

from solver.decorations.compiled_dressing import CompiledDressing
from solver.free_floor import DOORWAY, HEADROOM_MM, WALL_NUMBERS, sides_seen
from solver.free_places import FLAT_MM, footprint
from solver.geometry import Rect, strip_at, to_mm, wall_faced, wall_turned
from solver.pieces import Space
from solver.scene import WALLS, Decoration, Furniture, Opening, Room

OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
_ROOM: Final = Struct("<Q4q2d4q10i")
_PIECE: Final = Struct("<6q10i")
_OPENING: Final = Struct("<2i4q")
_ZONE: Final = Struct("<6q")
_ANSWER: Final = Struct("<Qq")
_RECT: Final = Struct("<4q")
_THING: Final = Struct("<6i8q")
_WALL_NAMES: Final = (*WALLS, None)
_OUTLINE: Final = "outline"
"""The cause of zones that are missing parts of a rectangle."""


def decorated_rows(room: Room, space: Space, known: CompiledDressing, height: float, state: int) -> bytes:
    """Returns a room as bytes.

    Args:
        room: furnished at right angles.
        space: its `space_of`.
        known: the dressing.
        height: m from floor to ceiling.
        state: the stream's.
    """
    numbers = {piece.id: k for k, piece in enumerate(room.furniture)}
    openings = [_opening(opening) for opening in room.openings if opening.wall is not None]
    kept = [rect for piece in room.furniture for rect in _kept_floor(piece, known)]
    counts = len(room.furniture), len(openings), len(space.zones), len(space.doorways), len(kept), 0
    flags = known.words.get(room.type, -1), room.outdoor, not room.outline, bool(room.accent)
    lines = to_mm(room.width), to_mm(room.depth)
    rows = [_ROOM.pack(state, *space.clear, room.width, room.depth, *lines, to_mm(height), space.robot_mm, *flags, *counts)]
    rows += [_piece(piece, known, numbers) for piece in room.furniture]
    rows += openings
    rows += [_ZONE.pack(*zone.rect, zone.above_mm, zone.cause == _OUTLINE) for zone in space.zones]
    rows += [DOORWAY.pack(WALL_NUMBERS[door.wall], 0, *door.square) for door in space.doorways]
    rows += [_RECT.pack(*rect) for rect in kept]
    return b"".join(rows)


def _piece(piece: Furniture, known: CompiledDressing, numbers: dict[str, int]) -> bytes:
    low, height = to_mm(piece.y), to_mm(piece.height)
    sides, need_all = known.uses.get(piece.name, ((), False))
    return _PIECE.pack(
        *footprint(piece), low, low + height, round(piece.rotation) % 360 if piece.rotation % 90 == 0 else 0,
        known.words.get(piece.name, -1), *known.surfaces.get((piece.name, (to_mm(piece.width), to_mm(piece.depth), height)), (0, 0)),
        -1 if piece.under is None else numbers.get(piece.under, -1), piece.name in known.faced,
        piece.height * 1000 > FLAT_MM and piece.y * 1000 < HEADROOM_MM,
        sides_seen(wall_faced(side, piece.rotation) for side in sides), need_all, 0,
    )  # fmt: skip


def _kept_floor(piece: Furniture, known: CompiledDressing) -> Iterator[Rect]:
    """Yields the floor at the sides of a right-angled piece on the floor that is better kept free."""
    if piece.rotation % 90 or piece.on is not None:
        return
    turn, own = round(piece.rotation) % 360, footprint(piece)
    for side, wish in known.comforts.get(piece.kind or piece.name, {}).items():
        faced, back = wall_faced(side, turn), wall_faced("back", turn)
        low, high = own.along(faced)
        behind = to_mm(wish.behind) if side in ("left", "right") else 0
        ends = (low + behind, high) if back in ("north", "west") else (low, high - behind)
        if ends[0] < ends[1]:
            yield strip_at(wall_turned(faced, 180), own.line(faced), ends, to_mm(wish.depth))


def _opening(opening: Opening) -> bytes:
    """Returns where nothing hangs at an opening."""
    half, top = opening.width / 2, opening.sill + opening.height
    along = to_mm(opening.position - half) - OPENING_MM, to_mm(opening.position + half) + OPENING_MM
    return _OPENING.pack(WALL_NUMBERS[opening.wall or ""], 0, *along, to_mm(opening.sill) - OPENING_MM, to_mm(top) + OPENING_MM)


def stream_after(answer: bytes) -> int:
    """Returns the stream's state at the end."""
    return int(_ANSWER.unpack_from(answer)[0])


def decorations_in(answer: bytes, room: Room, known: CompiledDressing) -> Iterator[Decoration]:
    """Yields the decorations of an answer, in the order in which they were put there.

    Their ids go on counting behind the furniture of the same name.
    """
    counts = Counter(piece.name for piece in room.furniture)
    ids = [piece.id for piece in room.furniture]
    for kind, parent, wall, rotation, colour, _, x0, z0, x1, z1, low, *size in _THING.iter_unpack(answer[_ANSWER.size :]):
        name = known.kinds[kind]
        counts[name] += 1
        ids.append(f"{room.id}/{name}_{counts[name]}")
        width, depth, height = (extent / 1000 for extent in size)
        made = object.__new__(Decoration)
        own = made.__dict__  # a frozen dataclass's own `__init__` takes three times as long, and there are a hundred in a room
        own["id"], own["name"], own["parent"], own["mounted_on_wall"] = (
            ids[-1],
            name,
            None if parent < 0 else ids[parent],
            _WALL_NAMES[wall],
        )
        own["x"], own["y"], own["z"], own["rotation"] = (x0 + x1) / 2000, low / 1000, (z0 + z1) / 2000, rotation
        own["width"], own["depth"], own["height"] = width, depth, height
        own["color"] = room.accent if colour < 0 else known.colours[kind][colour]
        own["kind"] = known.book.kind_of("decoration", name, (width, depth, height)) if name in known.tipped else name
        own["extra"] = {}
        yield made
