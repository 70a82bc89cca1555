"""What no search has to find out: a body that leaves no way past itself parts the room in two.

Where a body is so long that the gaps at its two ends together are narrower than a person, everyone stays on one side of it:
the side it is used from. So all other use sides, and the doors, lie on that side; each is a fixed row.
"""

from __future__ import annotations

from solver.placement.kernel.frames import facing
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABSENT,
    AXIS,
    EAST,
    EMPTY_FLOOR,
    EXT_X,
    LOW,
    N_PARTS,
    N_ROWS,
    NORTH,
    OFF_X,
    ORIGIN,
    PIECE,
    ROBOT,
    STAND,
    VAR_X,
    WEST,
    X0,
    X1,
    I,
    Ints,
    J,
    RoomArrays,
    S,
    Work,
)

HEADROOM_MM = 2000
"""What hangs higher is walked under (as the validator has it)."""


@compiled(lambda t: t.none(t.ints, t.int_rows, t.i8, t.i8, t.i8, t.i8))
def add_row(counts: Ints, rows: Ints, axis: int, i: int, j: int, s: int) -> None:
    """Appends a fixed row, p_j - p_i >= s along an axis."""
    k = counts[N_ROWS]
    rows[k, AXIS], rows[k, I], rows[k, J], rows[k, S] = axis, i, j, s
    counts[N_ROWS] = k + 1


@compiled(lambda t: t.i8(t.ints, t.int_rows, t.ints, t.i8))
def _barred(space: Ints, parts: Ints, rotation: Ints, stand: int) -> int:
    """Returns the wall towards which a stand's body is used if nobody can pass the body's ends, else ABSENT."""
    piece = parts[stand, PIECE]
    wall = facing(parts[stand, STAND], rotation[piece])
    along = 1 if wall == EAST or wall == WEST else 0
    body = stand
    while parts[body, PIECE] == piece and parts[body, STAND] != 0:
        body -= 1
    left = space[X1 + along] - space[X0 + along] - parts[body, EXT_X + along]
    return wall if left < space[ROBOT] and parts[body, LOW] < HEADROOM_MM else ABSENT


@compiled(lambda t: t.none(t.ints, t.int_rows, t.int_rows, t.i8, t.i8, t.i8))
def _keep_beside(counts: Ints, rows: Ints, parts: Ints, stand: int, other: int, wall: int) -> None:
    """Keeps another stand on the side of a body that its own stand is on."""
    axis = 0 if wall == EAST or wall == WEST else 1
    u, v = parts[stand, VAR_X + axis], parts[other, VAR_X + axis]
    near, far = parts[stand, OFF_X + axis], parts[other, OFF_X + axis]
    if wall == NORTH or wall == WEST:
        add_row(counts, rows, axis, v, u, far + parts[other, EXT_X + axis] - near - parts[stand, EXT_X + axis])
    else:
        add_row(counts, rows, axis, u, v, near - far)


@compiled(lambda t: t.none(t.ints, t.int_rows, t.int_rows, t.int_rows, t.i8, t.i8, t.i8))
def _keep_door(counts: Ints, rows: Ints, parts: Ints, doors: Ints, stand: int, door: int, wall: int) -> None:
    """Keeps a body with a stand on the far side of a door; doors are in doubled millimetres."""
    axis = 0 if wall == EAST or wall == WEST else 1
    u, near, size = parts[stand, VAR_X + axis], parts[stand, OFF_X + axis], parts[stand, EXT_X + axis]
    if wall == NORTH or wall == WEST:
        add_row(counts, rows, axis, ORIGIN, u, doors[door, axis] // 2 - size // 2 - near - 1)
    else:
        add_row(counts, rows, axis, u, ORIGIN, size // 2 + near - doors[door, 2 + axis] // 2 - 1)


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8))
def add_barriers(room: RoomArrays, work: Work, known: int) -> None:
    """Adds the rows between a new piece, whose parts begin with number `known`, and the pieces before it."""
    space, doors, parts, rotation = room.space, room.doors, work.parts, work.rotation
    counts, rows = work.counts, work.rows
    for stand in range(counts[N_PARTS]):
        if parts[stand, STAND] == 0 or parts[stand, STAND] == EMPTY_FLOOR:
            continue
        wall = _barred(space, parts, rotation, stand)
        if wall == ABSENT:
            continue
        for other in range(0 if stand >= known else known, counts[N_PARTS]):
            own = parts[other, PIECE] == parts[stand, PIECE] and stand >= known
            if parts[other, STAND] != 0 and other != stand and (own or parts[other, PIECE] != parts[stand, PIECE]):
                _keep_beside(counts, rows, parts, stand, other, wall)
        if stand >= known:
            for door in range(len(doors)):
                _keep_door(counts, rows, parts, doors, stand, door, wall)
