"""Can a square person get from the doors to every use side? Exact, on the compressed grid; and what blocks the way.

Bodies are inflated by half the person and the walls moved in by as much; cuts at the inflated edges make cells that are wholly
free or wholly blocked. Lengths are doubled millimetres, so that halves stay integers, and the person is 1 mm smaller than
asked, so that a gap of exactly its size counts. Targets then never lie on a cut.
"""

from __future__ import annotations

from solver.placement.kernel.barriers import HEADROOM_MM
from solver.placement.kernel.frames import facing
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABSENT,
    ALL_OF,
    ANY_OF,
    EAST,
    EXT_X,
    LEAST_FLOOR,
    LOW,
    N_PARTS,
    NORTH,
    OFF_X,
    ROBOT,
    STAND,
    STANDS,
    VAR_X,
    WALL_ZONE,
    WEST,
    X0,
    X1,
    Ints,
    RoomArrays,
    WalkGrid,
    Work,
)

# WalkGrid.areas of the walk: number of blocks, of targets, of cuts along x and z, of components, of target numbers, the door's component
BLOCKS, TARGETS, CUTS_X, CUTS_Z, COMPONENTS, NUMBERS, ENTERED = range(7)


@compiled(lambda t: t.none(t.int_rows, t.ints, t.i8, t.i8, t.i8, t.i8, t.i8, t.i8))
def _add(table: Ints, state: Ints, kind: int, x0: int, z0: int, x1: int, z1: int, number: int) -> None:
    """Adds a rectangle with a number to a table whose length is state[kind]."""
    k = state[kind]
    table[k, 0], table[k, 1], table[k, 2], table[k, 3], table[k, 4] = x0, z0, x1, z1, number
    state[kind] = k + 1


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.WalkGrid, t.int_rows, t.int_rows, t.i8, t.i8))
def _side_target(room: RoomArrays, work: Work, grid: WalkGrid, low: Ints, high: Ints, piece: int, side: int) -> None:
    """Adds where the person's centre may be while it touches a side of a piece that stands between low and high, mm."""
    body, wall = work.body_part[piece], facing(side, work.rotation[piece])
    parts, robot = work.parts, room.space[ROBOT]
    u, v = parts[body, VAR_X], parts[body, VAR_X + 1]
    x0, z0 = 2 * (low[0, u] + parts[body, OFF_X]), 2 * (low[1, v] + parts[body, OFF_X + 1])
    x1, z1 = 2 * (high[0, u] + parts[body, OFF_X]), 2 * (high[1, v] + parts[body, OFF_X + 1])
    wide, deep = 2 * parts[body, EXT_X], 2 * parts[body, EXT_X + 1]
    table, state, number = grid.targets, grid.state, grid.state[NUMBERS]
    if wall == NORTH:
        _add(table, state, TARGETS, x0, z0 - robot, x1 + wide, z1 - robot, number)
    elif wall == WEST:
        _add(table, state, TARGETS, x0 - robot, z0, x1 - robot, z1 + deep, number)
    elif wall == EAST:
        _add(table, state, TARGETS, x0 + wide + robot, z0, x1 + wide + robot, z1 + deep, number)
    else:
        _add(table, state, TARGETS, x0, z0 + deep + robot, x1 + wide, z1 + deep + robot, number)


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.WalkGrid, t.int_rows, t.int_rows))
def _gather(room: RoomArrays, work: Work, grid: WalkGrid, low: Ints, high: Ints) -> None:
    """Collects what is blocked wherever the bodies stand between low and high, and what is to be reached: doors first, then use sides."""
    grow, parts, zones, doors, sides = room.space[ROBOT] - 1, work.parts, room.zones, room.doors, room.sides
    blocks, table, state = grid.blocks, grid.targets, grid.state
    state[BLOCKS] = state[TARGETS] = 0
    for k in range(work.counts[N_PARTS]):
        if parts[k, STAND] == 0 and parts[k, LOW] < HEADROOM_MM:
            u, v = parts[k, VAR_X], parts[k, VAR_X + 1]
            x0, z0 = high[0, u] + parts[k, OFF_X], high[1, v] + parts[k, OFF_X + 1]
            x1, z1 = low[0, u] + parts[k, OFF_X] + parts[k, EXT_X], low[1, v] + parts[k, OFF_X + 1] + parts[k, EXT_X + 1]
            if x0 < x1 and z0 < z1:
                _add(blocks, state, BLOCKS, 2 * x0 - grow, 2 * z0 - grow, 2 * x1 + grow, 2 * z1 + grow, k)
    for k in range(len(zones)):
        if zones[k, WALL_ZONE]:
            x0, z0, x1, z1 = 2 * zones[k, 0], 2 * zones[k, 1], 2 * zones[k, 2], 2 * zones[k, 3]
            _add(blocks, state, BLOCKS, x0 - grow, z0 - grow, x1 + grow, z1 + grow, -1 - k)
    for k in range(len(doors)):
        _add(table, state, TARGETS, doors[k, 0], doors[k, 1], doors[k, 2], doors[k, 3], k)
    state[NUMBERS] = len(doors)
    for piece in range(len(room.pieces)):
        if work.taken_candidate[piece] == ABSENT:
            continue
        side = work.taken_side[piece]
        for bit in range(4):
            if (sides[side, STANDS] | sides[side, ALL_OF]) & (1 << bit):
                _side_target(room, work, grid, low, high, piece, 1 << bit)
                state[NUMBERS] += 1
        for bit in range(4):
            if sides[side, ANY_OF] & (1 << bit):
                _side_target(room, work, grid, low, high, piece, 1 << bit)
        if sides[side, ANY_OF]:
            state[NUMBERS] += 1


@compiled(lambda t: t.i8(t.WalkGrid, t.i8, t.i8, t.i8))
def _cut(grid: WalkGrid, axis: int, low: int, high: int) -> int:
    """Writes the sorted cuts of an axis, without repeats; returns how many."""
    cuts, blocks, n = grid.cuts[axis], grid.blocks, 2
    cuts[0], cuts[1] = low, high
    for k in range(grid.state[BLOCKS]):
        for end in range(2):
            edge = blocks[k, axis + 2 * end]
            if edge <= low or edge >= high:
                continue
            at = n
            while cuts[at - 1] > edge:
                at -= 1
            if cuts[at - 1] == edge:
                continue
            for move in range(n, at, -1):
                cuts[move] = cuts[move - 1]
            cuts[at] = edge
            n += 1
    return n


@compiled(lambda t: t.i8(t.ints, t.i8, t.i8))
def first_cell(cuts: Ints, n: int, value: int) -> int:
    """Returns the number of the first cut at or above a value."""
    low, high = 0, n
    while low < high:
        middle = (low + high) // 2
        if cuts[middle] < value:
            low = middle + 1
        else:
            high = middle
    return low


@compiled(lambda t: t.none(t.WalkGrid, t.i8, t.i8))
def _mark(grid: WalkGrid, nx: int, nz: int) -> None:
    """Labels cells 0 where free, -1 where blocked."""
    labels, blocks, xs, zs = grid.labels, grid.blocks, grid.cuts[0], grid.cuts[1]
    for k in range(nx * nz):
        labels[k] = 0
    for k in range(grid.state[BLOCKS]):
        x0, x1 = first_cell(xs, nx + 1, blocks[k, 0]), first_cell(xs, nx + 1, blocks[k, 2])
        z0, z1 = first_cell(zs, nz + 1, blocks[k, 1]), first_cell(zs, nz + 1, blocks[k, 3])
        for i in range(x0, min(x1, nx)):
            for j in range(z0, min(z1, nz)):
                labels[i * nz + j] = -1


@compiled(lambda t: t.none(t.WalkGrid, t.i8, t.i8))
def _flood(grid: WalkGrid, nx: int, nz: int) -> None:
    """Numbers the components of free cells from 1 and sums their areas, doubled millimetres squared."""
    labels, queue, cuts, areas, count = grid.labels, grid.queue, grid.cuts, grid.areas, 0
    for start in range(nx * nz):
        if labels[start] != 0:
            continue
        count += 1
        labels[start] = count
        queue[0] = start
        size, area = 1, 0
        while size > 0:
            size -= 1
            cell = queue[size]
            i, j = cell // nz, cell % nz
            area += (cuts[0, i + 1] - cuts[0, i]) * (cuts[1, j + 1] - cuts[1, j])
            for way in range(4):
                u = i + (1 if way == 0 else -1 if way == 1 else 0)
                v = j + (1 if way == 2 else -1 if way == 3 else 0)
                if 0 <= u < nx and 0 <= v < nz and labels[u * nz + v] == 0:
                    labels[u * nz + v] = count
                    queue[size] = u * nz + v
                    size += 1
        areas[count] = area
    grid.state[COMPONENTS] = count


@compiled(lambda t: t.none(t.WalkGrid, t.i8, t.i8))
def _reach(grid: WalkGrid, nx: int, nz: int) -> None:
    """Counts, for every component, how many target numbers it meets."""
    reached, targets, labels, xs, zs = grid.reached, grid.targets, grid.labels, grid.cuts[0], grid.cuts[1]
    for c in range(grid.state[COMPONENTS] + 1):
        reached[c, 0], reached[c, 1] = 0, -1
    for k in range(grid.state[TARGETS]):
        x0, x1 = first_cell(xs, nx + 1, targets[k, 0]) - 1, first_cell(xs, nx + 1, targets[k, 2])
        z0, z1 = first_cell(zs, nz + 1, targets[k, 1]) - 1, first_cell(zs, nz + 1, targets[k, 3])
        for i in range(max(x0, 0), min(x1, nx)):
            for j in range(max(z0, 0), min(z1, nz)):
                label = labels[i * nz + j]
                if label > 0 and reached[label, 1] != targets[k, 4]:
                    reached[label, 1] = targets[k, 4]
                    reached[label, 0] += 1


@compiled(lambda t: t.i8(t.RoomArrays, t.WalkGrid, t.i8, t.i8))
def _entered(room: RoomArrays, grid: WalkGrid, nx: int, nz: int) -> int:
    """Returns the component one walks in: of those at the first door the one that meets most; without doors the largest."""
    best = 0
    if len(room.doors) == 0:
        for c in range(1, grid.state[COMPONENTS] + 1):
            if best == 0 or grid.areas[c] > grid.areas[best]:
                best = c
        return best
    target = grid.targets[0]
    x0, x1 = first_cell(grid.cuts[0], nx + 1, target[0]) - 1, first_cell(grid.cuts[0], nx + 1, target[2])
    z0, z1 = first_cell(grid.cuts[1], nz + 1, target[1]) - 1, first_cell(grid.cuts[1], nz + 1, target[3])
    for i in range(max(x0, 0), min(x1, nx)):
        for j in range(max(z0, 0), min(z1, nz)):
            c = grid.labels[i * nz + j]
            if c > 0 and (best == 0 or grid.reached[c, 0] > grid.reached[best, 0]):
                best = c
    return best


@compiled(lambda t: t.b1(t.RoomArrays, t.Work, t.WalkGrid, t.int_rows, t.int_rows))
def _part_floor(room: RoomArrays, work: Work, grid: WalkGrid, low: Ints, high: Ints) -> bool:
    """Parts the floor that is free into components and counts what each meets; False where the room is too narrow for a person."""
    _gather(room, work, grid, low, high)
    grow, space = room.space[ROBOT] - 1, room.space
    low_x, low_z = 2 * space[X0] + grow, 2 * space[X0 + 1] + grow
    high_x, high_z = 2 * space[X1] - grow, 2 * space[X1 + 1] - grow
    grid.state[ENTERED] = grid.state[CUTS_X] = grid.state[CUTS_Z] = 0
    if low_x >= high_x or low_z >= high_z:
        return False
    grid.state[CUTS_X] = _cut(grid, 0, low_x, high_x)
    grid.state[CUTS_Z] = _cut(grid, 1, low_z, high_z)
    nx, nz = grid.state[CUTS_X] - 1, grid.state[CUTS_Z] - 1
    _mark(grid, nx, nz)
    _flood(grid, nx, nz)
    _reach(grid, nx, nz)
    return True


@compiled(lambda t: t.b1(t.RoomArrays, t.Work, t.WalkGrid, t.int_rows))
def walkable(room: RoomArrays, work: Work, grid: WalkGrid, p: Ints) -> bool:
    """Tells whether all doors and use sides are joined, with the bodies at integer positions p (2, variables), mm.

    Leaves labels, cuts and the entered component in `grid`.
    """
    space = room.space
    if not _part_floor(room, work, grid, p, p):
        return grid.state[NUMBERS] <= min(len(room.doors), 1) and space[LEAST_FLOOR] == 0
    entered = _entered(room, grid, grid.state[CUTS_X] - 1, grid.state[CUTS_Z] - 1)
    grid.state[ENTERED] = entered
    if entered == 0:
        return grid.state[NUMBERS] == 0 and space[LEAST_FLOOR] == 0
    return grid.reached[entered, 0] == grid.state[NUMBERS] and grid.areas[entered] >= 4 * space[LEAST_FLOOR]


@compiled(lambda t: t.b1(t.RoomArrays, t.Work, t.WalkGrid, t.int_rows, t.int_rows))
def may_be_walkable(room: RoomArrays, work: Work, grid: WalkGrid, low: Ints, high: Ints) -> bool:
    """Tells whether the bodies may leave one component of the least free centres that meets all doors and use sides.

    "No" is certain for all positions between low and high: only what is covered at every one of them blocks the way, and
    whatever may be a place to come to counts as one.
    """
    if not _part_floor(room, work, grid, low, high):
        return False
    for c in range(1, grid.state[COMPONENTS] + 1):
        if grid.reached[c, 0] == grid.state[NUMBERS] and grid.areas[c] >= 4 * room.space[LEAST_FLOOR]:
            return True
    return False
