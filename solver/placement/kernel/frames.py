"""Right-angled turns: vectors and sides of a body in the room's frame (0 faces south, 90 east)."""

from __future__ import annotations

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import BACK, EAST, FRONT, LEFT, NORTH, RIGHT, SOUTH, WEST


@compiled(lambda t: t.i8(t.i8, t.i8, t.i8))
def turned_x(x: int, z: int, turn: int) -> int:
    """Returns the x of a vector turned counter-clockwise seen from above (0 faces south, 90 east)."""
    if turn == 0:
        return x
    if turn == 90:
        return z
    return -x if turn == 180 else -z


@compiled(lambda t: t.i8(t.i8, t.i8, t.i8))
def turned_z(x: int, z: int, turn: int) -> int:
    """Returns the z of a vector turned counter-clockwise seen from above."""
    if turn == 0:
        return z
    if turn == 90:
        return -x
    return -z if turn == 180 else x


@compiled(lambda t: t.i8(t.i8, t.i8))
def facing(side: int, rotation: int) -> int:
    """Returns the wall that a side of a body with that rotation looks at."""
    x = 1 if side == RIGHT else -1 if side == LEFT else 0
    z = 1 if side == FRONT else -1 if side == BACK else 0
    dx, dz = turned_x(x, z, rotation), turned_z(x, z, rotation)
    if dx == 0:
        return SOUTH if dz > 0 else NORTH
    return EAST if dx > 0 else WEST
