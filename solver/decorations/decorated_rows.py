"""Rooms to be decorated as the core reads them, and what it answers (solver/core/dress/room.hpp).

Comes in: a furnished room and its space. Goes out: bytes for the core; rows of things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from struct import Struct
from typing import Final, NamedTuple

from catalogs.entries import Side
from catalogs.schema import Comfort
from solver.body_rows import DecorationRows
from solver.decorations.compiled_dressing import CompiledDressing, millimetres
from solver.decorations.decoration_settings import DecorationSettings
from solver.free_floor import DOORWAY, HEADROOM_MM, WALL_NUMBERS, sides_seen
from solver.free_places import FLAT_MM, PlacedBody, furniture_in
from solver.geometry import OPPOSITE, Rect, strip_at, to_mm, wall_faced
from solver.pieces import Space
from solver.scene import WALLS, Opening, Room

AT_WALL_MM: Final = 150
"""Nothing hangs on a wall that a front comes so near to as it opens. Our choice."""
OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
_ROOM: Final = Struct("<Q4q2d4q10i")
_PIECE: Final = Struct("<6q24s3i20s")
_OF_KIND: Final = Struct("<6i")
_OF_USE: Final = Struct("<5i")
_OPENING: Final = Struct("<2i4q")
_ZONE: Final = Struct("<6q")
_ANSWER: Final = Struct("<Qq")
_RECT: Final = Struct("<4q")
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
    furniture = furniture_in(room)
    openings = [_opening(opening) for opening in room.openings if opening.wall is not None]
    pieces: list[bytes] = []
    kept: list[Rect] = []
    for piece in furniture:
        said = _said_of(known, piece.key, piece.rotation)
        own, low, height = piece.block.rect, to_mm(piece.y), to_mm(piece.key[4])
        stands = piece.key[4] * 1000 > FLAT_MM and piece.y * 1000 < HEADROOM_MM
        pieces.append(_PIECE.pack(*own, low, low + height, said.kind_row, piece.under, said.faced, stands, said.use_row))
        if not piece.rests:
            kept += said.kept_floor(own)
        if said.front is not None and to_mm(piece.y + said.front.above) < HEADROOM_MM:
            opened = said.front.over(own)
            kept.append(opened)
            openings += _fronts_at_walls(piece, opened, said.front.above, space)
    kept += settings.kept.get(room.id, ())
    counts = len(furniture), len(openings), len(space.zones), len(space.doorways), len(kept), 0
    flags = known.words.get(room.type, -1), room.outdoor, not room.outline, bool(room.accent)
    lines = to_mm(room.width), to_mm(room.depth)
    rows = [_ROOM.pack(state, *space.clear, room.width, room.depth, *lines, to_mm(settings.height), space.robot_mm, *flags, *counts)]
    rows += pieces
    rows += openings
    rows += [_ZONE.pack(*zone.rect, zone.above_mm, zone.cause == _OUTLINE) for zone in space.zones]
    rows += [DOORWAY.pack(WALL_NUMBERS[door.wall], 0, *door.square) for door in space.doorways]
    rows += [_RECT.pack(*rect) for rect in kept]
    return b"".join(rows)


class _Strip(NamedTuple):
    """Floor at a side of a piece: the wall it faces, how far in from the piece's ends it begins and ends, its depth, mm; its height, m."""

    faced: str
    ends: tuple[int, int]
    deep: int
    above: float = 0.0

    def over(self, own: Rect) -> Rect:
        """Returns the floor at that side of a footprint."""
        low, high = own.along(self.faced)
        return strip_at(OPPOSITE[self.faced], own.line(self.faced), (low + self.ends[0], high - self.ends[1]), self.deep)


class _Said(NamedTuple):
    """What a dressing says of every piece of a kind and size that is turned so; rows as the core reads them."""

    kind_row: bytes
    use_row: bytes
    faced: bool
    kept: tuple[_Strip, ...]
    front: _Strip | None

    def kept_floor(self, own: Rect) -> list[Rect]:
        """Returns the floor at the sides of a footprint on the floor that is better kept free."""
        found = []
        for strip in self.kept:
            low, high = own.along(strip.faced)
            if low + strip.ends[0] < high - strip.ends[1]:
                found.append(strip.over(own))
        return found


@lru_cache(maxsize=4096)
def _said_of(known: CompiledDressing, key: tuple[str, str, float, float, float, str | None], rotation: float) -> _Said:
    """Returns what a dressing says of furniture by what its kind is looked up by, and its turn."""
    _, name, width, depth, height, said = key
    size, is_right = millimetres((width, depth, height)), rotation % 90 == 0
    kind = said or known.book.kind_of("furniture", name, (width, depth, height)) or name
    sides, need_all = known.uses.get(name, ((), False))
    before = known.fronts.get(kind) if is_right else None
    opens = (0, 0) if before is None else (to_mm(before.depth), to_mm(before.above))
    turn = round(rotation) % 360 if is_right else 0
    surfaces, insides = known.surfaces.get((name, size), (0, 0)), known.insides.get((kind, size), (0, 0)) if is_right else (0, 0)
    return _Said(
        _OF_KIND.pack(turn, known.words.get(name, -1), *surfaces, *insides),
        _OF_USE.pack(sides_seen(wall_faced(side, rotation) for side in sides), need_all, *opens, 0),
        name in known.faced,
        tuple(_strips(known.comforts.get(said or name, {}), turn)) if is_right else (),
        None if before is None else _Strip(wall_faced("front", turn), (0, 0), to_mm(before.depth), before.above),
    )


def _strips(comforts: Mapping[Side, Comfort], turn: int) -> Iterator[_Strip]:
    """Yields the floor at the sides of a piece that is better kept free."""
    at_low = wall_faced("back", turn) in ("north", "west")
    for side, wish in comforts.items():
        behind = to_mm(wish.behind) if side in ("left", "right") else 0
        yield _Strip(wall_faced(side, turn), (behind, 0) if at_low else (0, behind), to_mm(wish.depth))


def _fronts_at_walls(piece: PlacedBody, opened: Rect, above: float, space: Space) -> Iterator[bytes]:
    """Yields where nothing hangs on a wall because a front opens along it or towards it, over that floor and from that height on."""
    bottom, clear = to_mm(piece.y + above), space.clear
    near = opened.z0 - clear.z0, clear.z1 - opened.z1, clear.x1 - opened.x1, opened.x0 - clear.x0
    for wall, distance in zip(WALLS, near, strict=True):
        if distance <= AT_WALL_MM:
            yield _OPENING.pack(WALL_NUMBERS[wall], 0, *opened.along(wall), bottom, to_mm(piece.y + piece.key[4]))


def _opening(opening: Opening) -> bytes:
    """Returns where nothing hangs at an opening."""
    half, top = opening.width / 2, opening.sill + opening.height
    along = to_mm(opening.position - half) - OPENING_MM, to_mm(opening.position + half) + OPENING_MM
    return _OPENING.pack(WALL_NUMBERS[opening.wall or ""], 0, *along, to_mm(opening.sill) - OPENING_MM, to_mm(top) + OPENING_MM)


def stream_after(answer: bytes) -> int:
    """Returns the stream's state at the end."""
    return int(_ANSWER.unpack_from(answer)[0])


def rows_told(answer: bytes, room: Room, known: CompiledDressing) -> DecorationRows:
    """Returns the things of an answer."""
    return DecorationRows(answer[_ANSWER.size :], room, known.looks, known.colours, known.styled)
