"""Seeded synthetic rooms, realistic and tight: 3-12 pieces, some at walls, some free, some companions."""

from __future__ import annotations

from solver.geometry import ROTATION_AT_WALL, Rect
from solver.pieces import Attach, Candidate, Doorway, Piece, Space, Stand, Zone
from solver.streams import Stream

WALLS = tuple(ROTATION_AT_WALL)


def random_space(stream: Stream) -> Space:
    """A room of 2.4-5 m with a door in the south wall and a window in the north one."""
    width, depth = 2400 + 10 * stream.below(260), 2400 + 10 * stream.below(260)
    clear = Rect(50, 50, width - 50, depth - 50)
    at = 500 + 10 * stream.below((width - 1000) // 10 + 1)
    square = Rect(at - 450, depth - 900, at + 450, depth)
    middle = 700 + 10 * stream.below((width - 1400) // 10 + 1)
    window = Rect(middle - 700, 0, middle + 700, 500)
    zones = (Zone(square, 0, "door_1"), Zone(window, 900, "window_1"))
    return Space("room", clear, zones, (Doorway("door_1", "south", square, "hall"),))


def at_walls(size: tuple[int, int, int], space: Space, stream: Stream) -> tuple[Candidate, ...]:
    """One alternative a wall, its anchor somewhere along it."""
    found = []
    for wall in WALLS:
        low, high = space.clear.along(wall)
        along = low + stream.below(high - low)
        anchor = (along, 0) if wall in ("north", "south") else (0, along)
        cost = stream.below(30) / 10
        found.append(Candidate("piece", size, ROTATION_AT_WALL[wall], wall, anchor, cost=cost))
    return tuple(found)


def free(size: tuple[int, int, int], space: Space, stream: Stream) -> tuple[Candidate, ...]:
    """Both rotations, anchored anywhere in the room."""
    clear = space.clear
    anchor = (clear.x0 + stream.below(clear.width), clear.z0 + stream.below(clear.depth))
    return tuple(Candidate("piece", size, rotation, None, anchor) for rotation in (0, 90))


def random_size(stream: Stream) -> tuple[int, int, int]:
    """0.3-1.8 m wide, 0.3-0.9 m deep, odd millimetres among them."""
    return 300 + stream.below(1500), 300 + stream.below(600), 400 + stream.below(1800)


def random_wanted(space: Space, stream: Stream, count: int) -> tuple[Piece, ...]:
    """Pieces in order of importance; the first two are required, every fourth is a companion."""
    pieces: list[Piece] = []
    for k in range(count):
        size = random_size(stream)
        label = f"piece_{k + 1}"
        if k % 4 == 3:
            parent = pieces[k - 1]
            wide, deep, _ = parent.candidates[0].size_mm
            attach = Attach(parent.label, "piece", (-wide // 2, wide // 2), ((deep + size[1]) // 2 + 1,) * 2)
            alternatives: tuple[Candidate, ...] = (Candidate("companion", size, 180, attach=attach),)
        elif stream.chance(0.7):
            alternatives = at_walls(size, space, stream)
        else:
            alternatives = free(size, space, stream)
        stands = (Stand("front"),) if stream.chance(0.5) else ()
        pieces.append(Piece(label, k < 2, alternatives, stands=stands))
    return tuple(pieces)
