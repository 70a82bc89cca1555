"""What a dropped piece says of itself: at which wall its back is, whether it is still under its table.

Comes in: a repaired Room, and who was moved. Goes out: the Room with the same poses. May import: the ground floor.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from solver.free_places import footprint
from solver.geometry import WALL_BEHIND, Rect
from solver.repair.bodies import squared, tables_of
from solver.repair.ways import Walls
from solver.repair.wishes import Wishes
from solver.scene import Furniture, Room

AT_WALL_MM = 100
"""How far a back may be from a wall's face to be at it."""
AT_TABLE_MM = 300
"""How far a chair may be from its table and still be that table's."""


def said(room: Room, walls: Walls, wishes: Wishes, hugging: Collection[str]) -> Room:
    """Returns the room with what its moved pieces say of themselves made true; no pose changes.

    Args:
        room: as repaired.
        walls: its walls.
        wishes: who was moved; what is locked stays as it is.
        hugging: names of the pieces that stand at walls.
    """
    tables = tables_of(room.furniture)
    changed = []
    for piece in room.furniture:
        if piece.id in wishes.moved and not wishes.is_locked(piece):
            table, own = tables.get(piece.id), footprint(piece)
            left = table is not None and not own.overlaps(footprint(table).shrunk(-AT_TABLE_MM))
            wall = _wall_behind(piece, own, walls) if piece.wall is None and piece.name in hugging else piece.wall
            piece = replace(piece, wall=wall, under=None if left else piece.under)  # noqa: PLW2901 - the same piece
        changed.append(piece)
    return room if tuple(changed) == room.furniture else replace(room, furniture=tuple(changed))


def _wall_behind(piece: Furniture, own: Rect, walls: Walls) -> str | None:
    """Returns the wall whose face the back of a squared piece is at."""
    turn = squared(piece.rotation)
    wall = WALL_BEHIND[turn] if turn == piece.rotation % 360 else None
    if wall is None or piece.on is not None:
        return None
    lines = {"north": own.z0, "south": own.z1, "west": own.x0, "east": own.x1}
    start, end = (own.x0, own.x1) if wall in ("north", "south") else (own.z0, own.z1)
    inwards = 1 if wall in ("north", "west") else -1
    clear = walls.clear
    faces = [{"north": clear.z0, "south": clear.z1, "west": clear.x0, "east": clear.x1}[wall]]
    faces += [line + inwards * walls.half_mm for side, line, low, high in walls.inner if side == wall and low < end and start < high]
    return wall if any(0 <= inwards * (lines[wall] - face) <= AT_WALL_MM for face in faces) else None
