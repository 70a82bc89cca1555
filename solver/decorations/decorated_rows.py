"""Rooms to be decorated as the core reads them, and decorations from the rows it answers with (solver/core/dress/room.hpp).

Comes in: a furnished room and its space. Goes out: bytes for the core; from its bytes, decorations. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from struct import Struct
from typing import Final

from solver.decorations.compiled_dressing import CompiledDressing
from solver.decorations.decoration_settings import DecorationSettings
from solver.free_floor import DOORWAY, HEADROOM_MM, WALL_NUMBERS, sides_seen
from solver.free_places import FLAT_MM, footprint
from solver.geometry import Rect, strip_at, to_mm, wall_faced, wall_turned
from solver.pieces import Space
from solver.scene import WALLS, Decoration, Furniture, Opening, Room

AT_WALL_MM: Final = 150
"""Nothing hangs on a wall that a front comes so near to as it opens. Our choice."""
OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
_ROOM: Final = Struct("<Q4q2d4q10i")
_PIECE: Final = Struct("<6q14i")
_OPENING: Final = Struct("<2i4q")
_ZONE: Final = Struct("<6q")
_ANSWER: Final = Struct("<Qq")
_RECT: Final = Struct("<4q")
_THING: Final = Struct("<6i8q")
_WALL_NAMES: Final = (*WALLS, None)
_OUTLINE: Final = "outline"
"""The cause of zones that are missing parts of a rectangle."""


def decorated_rows(room: Room, space: Space, known: CompiledDressing, settings: DecorationSettings, state: int) -> bytes:
    """Returns a room as bytes.

    Args:
        room: furnished at right angles.
        space: its `space_of`.
        known: the dressing.
        settings: how high the room is, and what of its floor is kept free.
        state: the stream's.
    """
    numbers = {piece.id: k for k, piece in enumerate(room.furniture)}
    openings = [_opening(opening) for opening in room.openings if opening.wall is not None]
    for piece in room.furniture:
        openings += _fronts_at_walls(piece, known, space)
    kept = [rect for piece in room.furniture for rect in (*_kept_floor(piece, known), *_opened_over(piece, known))]
    kept += settings.kept.get(room.id, ())
    counts = len(room.furniture), len(openings), len(space.zones), len(space.doorways), len(kept), 0
    flags = known.words.get(room.type, -1), room.outdoor, not room.outline, bool(room.accent)
    lines = to_mm(room.width), to_mm(room.depth)
    rows = [_ROOM.pack(state, *space.clear, room.width, room.depth, *lines, to_mm(settings.height), space.robot_mm, *flags, *counts)]
    rows += [_piece(piece, known, numbers) for piece in room.furniture]
    rows += openings
    rows += [_ZONE.pack(*zone.rect, zone.above_mm, zone.cause == _OUTLINE) for zone in space.zones]
    rows += [DOORWAY.pack(WALL_NUMBERS[door.wall], 0, *door.square) for door in space.doorways]
    rows += [_RECT.pack(*rect) for rect in kept]
    return b"".join(rows)


def _piece(piece: Furniture, known: CompiledDressing, numbers: dict[str, int]) -> bytes:
    low, height = to_mm(piece.y), to_mm(piece.height)
    size = to_mm(piece.width), to_mm(piece.depth), height
    sides, need_all = known.uses.get(piece.name, ((), False))
    before = None if piece.rotation % 90 else known.fronts.get(_kind(piece, known))
    opens = (0, 0) if before is None else (to_mm(before.depth), to_mm(before.above))
    return _PIECE.pack(
        *footprint(piece), low, low + height, round(piece.rotation) % 360 if piece.rotation % 90 == 0 else 0,
        known.words.get(piece.name, -1), *known.surfaces.get((piece.name, size), (0, 0)),
        *(known.insides.get((_kind(piece, known), size), (0, 0)) if piece.rotation % 90 == 0 else (0, 0)),
        -1 if piece.under is None else numbers.get(piece.under, -1), piece.name in known.faced,
        piece.height * 1000 > FLAT_MM and piece.y * 1000 < HEADROOM_MM,
        sides_seen(wall_faced(side, piece.rotation) for side in sides), need_all, *opens, 0,
    )  # fmt: skip


def _kind(piece: Furniture, known: CompiledDressing) -> str:
    return piece.kind or known.book.kind_of("furniture", piece.name, (piece.width, piece.depth, piece.height)) or piece.name


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


def _opened_over(piece: Furniture, known: CompiledDressing) -> Iterator[Rect]:
    """Yields the floor that the fronts of a right-angled piece open over."""
    before = known.fronts.get(_kind(piece, known))
    if before is None or piece.rotation % 90 or to_mm(piece.y + before.above) >= HEADROOM_MM:
        return
    ahead, own = wall_faced("front", round(piece.rotation) % 360), footprint(piece)
    yield strip_at(wall_turned(ahead, 180), own.line(ahead), own.along(ahead), to_mm(before.depth))


def _fronts_at_walls(piece: Furniture, known: CompiledDressing, space: Space) -> Iterator[bytes]:
    """Yields where nothing hangs on a wall because a front opens along it or towards it."""
    for floor in _opened_over(piece, known):
        bottom = to_mm(piece.y + known.fronts[_kind(piece, known)].above)
        for wall in WALLS:
            if floor.wall_distance(wall, space.clear) <= AT_WALL_MM:
                yield _OPENING.pack(WALL_NUMBERS[wall], 0, *floor.along(wall), bottom, to_mm(piece.y + piece.height))


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
    counts: dict[str, int] = Counter(piece.name for piece in room.furniture)
    ids = [piece.id for piece in room.furniture]
    kind_of, tipped, kinds, colours = known.book.kind_of, known.tipped, known.kinds, known.colours
    for kind, parent, wall, rotation, colour, _, x0, z0, x1, z1, low, *size in _THING.iter_unpack(answer[_ANSWER.size :]):
        name, width, depth, height = kinds[kind], size[0] / 1000, size[1] / 1000, size[2] / 1000
        counts[name] = number = counts.get(name, 0) + 1
        ids.append(f"{room.id}/{name}_{number}")
        made = object.__new__(Decoration)
        own = made.__dict__  # a frozen dataclass's own `__init__` takes three times as long, and there are a hundred in a room
        own["id"], own["name"] = ids[-1], name
        own["parent"], own["mounted_on_wall"] = None if parent < 0 else ids[parent], _WALL_NAMES[wall]
        own["x"], own["y"], own["z"], own["rotation"] = (x0 + x1) / 2000, low / 1000, (z0 + z1) / 2000, rotation
        own["width"], own["depth"], own["height"] = width, depth, height
        own["color"] = _accent(room, kind, known) if colour < 0 else colours[kind][colour]
        own["kind"] = kind_of("decoration", name, (width, depth, height)) if name in tipped else name
        own["extra"] = {}
        yield made


def _accent(room: Room, kind: int, known: CompiledDressing) -> str | None:
    """Returns the colour of what has its room's: one of the style's, where it has some for that kind, alike in one room."""
    colours = known.colours[kind]
    return colours[room.index % len(colours)] if known.kinds[kind] in known.styled else room.accent
