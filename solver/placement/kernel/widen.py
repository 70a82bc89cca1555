"""Where the way is blocked: the pairs that close it become choices again, with the person's width between them.

A link is a pair of inflated boxes (or a box and a wall) that overlap in a rectangle which touches the component entered and
another one. Children are sorted by cost, the best 12 kept, at most 4 widenings on a path.
"""

from __future__ import annotations

from solver.placement.kernel.grid import BLOCKS, CUTS_X, CUTS_Z, ENTERED, first_cell
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    AXIS,
    EXT_X,
    N_WIDE,
    OFF_X,
    ORIGIN,
    ROBOT,
    VAR_X,
    X0,
    X1,
    I,
    J,
    RoomArrays,
    S,
    WalkGrid,
    Work,
)


@compiled(lambda t: t.b1(t.WalkGrid, t.i8, t.i8, t.i8, t.i8))
def _divides(grid: WalkGrid, x0: int, z0: int, x1: int, z1: int) -> bool:
    """Tells whether a rectangle of blocked floor touches the component entered and another one."""
    nx, nz = grid.state[CUTS_X] - 1, grid.state[CUTS_Z] - 1
    i0, i1 = first_cell(grid.cuts[0], nx + 1, x0), first_cell(grid.cuts[0], nx + 1, x1)
    j0, j1 = first_cell(grid.cuts[1], nz + 1, z0), first_cell(grid.cuts[1], nz + 1, z1)
    labels, entered = grid.labels, grid.state[ENTERED]
    inside, outside = False, False
    for i in range(max(i0 - 1, 0), min(i1 + 1, nx)):
        for j in range(max(j0 - 1, 0), min(j1 + 1, nz)):
            label = labels[i * nz + j]
            if label == entered:
                inside = True
            elif label > 0:
                outside = True
    return inside and outside


@compiled(lambda t: t.none(t.Work, t.i8, t.i8, t.i8, t.i8))
def _wide(work: Work, axis: int, i: int, j: int, s: int) -> None:
    """Adds a wider row where the bounds leave room for it."""
    if i == j or work.counts[N_WIDE] >= len(work.wide):
        return
    most = work.high[axis, j] if j != ORIGIN else 0
    if i != ORIGIN:
        most -= work.low[axis, i]
    if most >= s:
        row = work.wide[work.counts[N_WIDE]]
        row[AXIS], row[I], row[J], row[S] = axis, i, j, s
        work.counts[N_WIDE] += 1


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8, t.i8))
def _between_parts(room: RoomArrays, work: Work, a: int, b: int) -> None:
    parts, robot = work.parts, room.space[ROBOT]
    for axis in range(2):
        u, v = parts[a, VAR_X + axis], parts[b, VAR_X + axis]
        shift = parts[a, OFF_X + axis] - parts[b, OFF_X + axis]
        _wide(work, axis, u, v, parts[a, EXT_X + axis] + shift + robot)
        _wide(work, axis, v, u, parts[b, EXT_X + axis] - shift + robot)


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8, t.i8))
def _from_zone(room: RoomArrays, work: Work, a: int, zone: int) -> None:
    parts, robot = work.parts, room.space[ROBOT]
    for axis in range(2):
        v, offset, extent = parts[a, VAR_X + axis], parts[a, OFF_X + axis], parts[a, EXT_X + axis]
        _wide(work, axis, v, ORIGIN, extent + offset - room.zones[zone, axis] + robot)
        _wide(work, axis, ORIGIN, v, room.zones[zone, 2 + axis] - offset + robot)


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.WalkGrid, t.i8))
def _from_walls(room: RoomArrays, work: Work, grid: WalkGrid, k: int) -> None:
    """Adds the rows that make room between a block and the walls it is too near to."""
    block = grid.blocks[k]
    parts, a, robot = work.parts, grid.blocks[k, 4], room.space[ROBOT]
    nx, nz = grid.state[CUTS_X] - 1, grid.state[CUTS_Z] - 1
    for axis in range(2):
        other = 1 - axis
        low, high = grid.cuts[axis, 0], grid.cuts[axis, nx if axis == 0 else nz]
        v, offset, extent = parts[a, VAR_X + axis], parts[a, OFF_X + axis], parts[a, EXT_X + axis]
        start, end = block[other], block[2 + other]
        if block[axis] < low:
            touched = _divides(grid, low, start, low, end) if axis == 0 else _divides(grid, start, low, end, low)
            if touched:
                _wide(work, axis, ORIGIN, v, room.space[X0 + axis] + robot - offset)
        if block[2 + axis] > high:
            touched = _divides(grid, high, start, high, end) if axis == 0 else _divides(grid, start, high, end, high)
            if touched:
                _wide(work, axis, v, ORIGIN, extent + offset + robot - room.space[X1 + axis])


@compiled(lambda t: t.i8(t.RoomArrays, t.Work, t.WalkGrid))
def links(room: RoomArrays, work: Work, grid: WalkGrid) -> int:
    """Appends the rows that might open the way to `wide`; returns the number of the first.

    `grid` is as `walkable` left it.
    """
    first = work.counts[N_WIDE]
    if grid.state[ENTERED] == 0:
        return first
    for k in range(grid.state[BLOCKS]):
        if grid.blocks[k, 4] >= 0:
            _from_walls(room, work, grid, k)
        for other in range(k):
            a, b = grid.blocks[other], grid.blocks[k]
            x0, x1 = max(a[0], b[0]), min(a[2], b[2])
            z0, z1 = max(a[1], b[1]), min(a[3], b[3])
            if x0 >= x1 or z0 >= z1 or not _divides(grid, x0, z0, x1, z1):
                continue
            if a[4] >= 0 and b[4] >= 0:
                _between_parts(room, work, a[4], b[4])
            elif a[4] >= 0:
                _from_zone(room, work, a[4], -1 - b[4])
            elif b[4] >= 0:
                _from_zone(room, work, b[4], -1 - a[4])
    return first
