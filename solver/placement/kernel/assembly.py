"""From decisions to a problem: variables, bounds, parts, terms, rows and choices.

`decisions[p]` is the candidate of piece p times 8 plus the number of its choice of sides, or ABSENT. Rigid companions share their
parent's variables, so that nothing has to be searched between them. A stand is a person's square before a use side.
"""

from __future__ import annotations

from typing import Final

from solver.placement.kernel.barriers import add_barriers, add_row
from solver.placement.kernel.frames import facing, turned_x, turned_z
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    ABOVE,
    ABSENT,
    ACROSS_0,
    ACROSS_1,
    ALIGN,
    ALONG_0,
    ALONG_1,
    ANCHOR_X,
    ASSEMBLED,
    AXIS,
    BOTTOM,
    DEPTH,
    EAST,
    EMPTY,
    EXT_X,
    GAP,
    HEIGHT,
    HIGH,
    IN_X0,
    LINK_0,
    LINK_1,
    LOW,
    N_CHOICES,
    N_PARTS,
    N_PULLS,
    NEAR,
    NORTH,
    OF,
    OFF_X,
    ON,
    ORIGIN,
    PARENT,
    PERSON_MM,
    PIECE,
    PULL_OFFSET,
    PULL_WEIGHT,
    ROBOT,
    SIDES_0,
    SLACK,
    SOUTH,
    STAND,
    STANDS,
    TURN,
    UNDER,
    VAR_X,
    WALL,
    WALL_ZONE,
    WEIGHT_X,
    WEST,
    WIDTH,
    X0,
    X1,
    Floats,
    I,
    Ints,
    J,
    RoomArrays,
    S,
    Work,
)

STAND_WEIGHT: Final = 0.02
"""Pull of a person's square to the middle of its side, m^-2: least weight that keeps the Hessian positive definite."""


@compiled(lambda t: t.none(t.ints, t.int_rows, t.float_rows, t.i8, t.i8, t.i8, t.f8, t.f8))
def _pull(counts: Ints, pulls: Ints, costs: Floats, axis: int, i: int, j: int, offset: float, weight: float) -> None:
    k = counts[N_PULLS]
    pulls[k, AXIS], pulls[k, I], pulls[k, J] = axis, i, j
    costs[k, PULL_OFFSET], costs[k, PULL_WEIGHT] = offset, weight
    counts[N_PULLS] = k + 1


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8, t.i8))
def _rooted(room: RoomArrays, work: Work, piece: int, candidate: int) -> None:
    """Adds a body with its own variables: in the room, or flush at a wall."""
    candidates, space, parts, sizes = room.candidates, room.space, work.parts, work.sizes
    turn, wall, slack = candidates[candidate, TURN], candidates[candidate, WALL], candidates[candidate, SLACK]
    body = work.counts[N_PARTS]
    work.counts[N_PARTS] = body + 1
    parts[body, PIECE], parts[body, STAND] = piece, room.pieces[piece, EMPTY]
    across = turn == 90 or turn == 270
    near, far = (space[GAP], space[GAP]) if slack < 0 else (0, slack)
    for axis in range(2):
        extent = candidates[candidate, DEPTH] if across == (axis == 0) else candidates[candidate, WIDTH]
        low, high = candidates[candidate, IN_X0 + axis], candidates[candidate, IN_X0 + 2 + axis] - extent
        if (axis == 1 and wall == NORTH) or (axis == 0 and wall == WEST):
            low, high = max(low, space[X0 + axis] + near), min(high, space[X0 + axis] + far)
        elif (axis == 1 and wall == SOUTH) or (axis == 0 and wall == EAST):
            end = space[X1 + axis] - extent
            low, high = max(low, end - far), min(high, end - near)
        v = sizes[axis]
        sizes[axis] = v + 1
        work.low[axis, v], work.high[axis, v] = low, high
        work.anchor_at[axis, v] = (2 * candidates[candidate, ANCHOR_X + axis] - extent) / 2000
        work.anchor_weight[axis, v] = room.candidate_costs[candidate, WEIGHT_X + axis]
        parts[body, VAR_X + axis], parts[body, OFF_X + axis], parts[body, EXT_X + axis] = v, 0, extent
    parts[body, LOW], parts[body, HIGH] = candidates[candidate, BOTTOM], candidates[candidate, BOTTOM] + candidates[candidate, HEIGHT]
    work.body_part[piece], work.rotation[piece] = body, turn


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8, t.i8))
def _attached(room: RoomArrays, work: Work, piece: int, candidate: int) -> None:
    """Adds a body that stands at a slot of its parent: with the parent's variable where the slot is rigid."""
    candidates, parts, sizes = room.candidates, work.parts, work.sizes
    counts, lows, highs = work.counts, work.low, work.high
    parent = work.body_part[candidates[candidate, PARENT]]
    turn = work.rotation[candidates[candidate, PARENT]]
    rotation = (turn + candidates[candidate, TURN]) % 360
    body = counts[N_PARTS]
    counts[N_PARTS] = body + 1
    parts[body, PIECE], parts[body, STAND] = piece, room.pieces[piece, EMPTY]
    across = rotation == 90 or rotation == 270
    for axis in range(2):
        extent = candidates[candidate, DEPTH] if across == (axis == 0) else candidates[candidate, WIDTH]
        if axis == 0:
            first = turned_x(candidates[candidate, ACROSS_0], candidates[candidate, ALONG_0], turn)
            last = turned_x(candidates[candidate, ACROSS_1], candidates[candidate, ALONG_1], turn)
        else:
            first = turned_z(candidates[candidate, ACROSS_0], candidates[candidate, ALONG_0], turn)
            last = turned_z(candidates[candidate, ACROSS_1], candidates[candidate, ALONG_1], turn)
        least, most = min(first, last), max(first, last)
        low, high = candidates[candidate, IN_X0 + axis], candidates[candidate, IN_X0 + 2 + axis] - extent
        u = parts[parent, VAR_X + axis]
        shift = (parts[parent, EXT_X + axis] - extent) // 2 + parts[parent, OFF_X + axis]
        if least == most:
            v = u
            parts[body, OFF_X + axis] = shift + least
            lows[axis, v] = max(lows[axis, v], low - shift - least)
            highs[axis, v] = min(highs[axis, v], high - shift - least)
        else:
            v = sizes[axis]
            sizes[axis] = v + 1
            lows[axis, v], highs[axis, v] = low, high
            work.anchor_weight[axis, v], work.anchor_at[axis, v] = 0.0, 0.0
            parts[body, OFF_X + axis] = 0
            add_row(counts, work.rows, axis, u, v, shift + least)
            add_row(counts, work.rows, axis, v, u, -shift - most)
            middle = (2 * shift + least + most) / 2000
            _pull(counts, work.pulls, work.pull_costs, axis, u, v, middle, room.candidate_costs[candidate, WEIGHT_X + axis])
        parts[body, VAR_X + axis], parts[body, EXT_X + axis] = v, extent
    parts[body, LOW], parts[body, HIGH] = candidates[candidate, BOTTOM], candidates[candidate, BOTTOM] + candidates[candidate, HEIGHT]
    work.body_part[piece], work.rotation[piece] = body, rotation


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8, t.i8))
def _stand(room: RoomArrays, work: Work, piece: int, side: int) -> None:
    """Adds the person's square at a use side: touching it, its centre sliding along the side."""
    parts, space, sizes, size = work.parts, room.space, work.sizes, room.space[ROBOT]
    counts, lows, highs, rows = work.counts, work.low, work.high, work.rows
    body, wall = work.body_part[piece], facing(side, work.rotation[piece])
    normal = 0 if wall == EAST or wall == WEST else 1
    along = 1 - normal
    part = counts[N_PARTS]
    counts[N_PARTS] = part + 1
    parts[part, PIECE], parts[part, STAND] = piece, side
    offset = parts[body, OFF_X + normal] + (parts[body, EXT_X + normal] if wall == EAST or wall == SOUTH else -size)
    v = parts[body, VAR_X + normal]
    lows[normal, v] = max(lows[normal, v], space[X0 + normal] - offset)
    highs[normal, v] = min(highs[normal, v], space[X1 + normal] - size - offset)
    parts[part, VAR_X + normal], parts[part, OFF_X + normal], parts[part, EXT_X + normal] = v, offset, size
    start, extent, v = parts[body, OFF_X + along], parts[body, EXT_X + along], parts[body, VAR_X + along]
    own = sizes[along]
    sizes[along] = own + 1
    lows[along, own], highs[along, own] = space[X0 + along], space[X1 + along] - size
    work.anchor_weight[along, own], work.anchor_at[along, own] = 0.0, 0.0
    add_row(counts, rows, along, v, own, start - size // 2)
    add_row(counts, rows, along, own, v, size // 2 - extent - start)
    _pull(counts, work.pulls, work.pull_costs, along, v, own, (2 * start + extent - size) / 2000, STAND_WEIGHT)
    parts[part, VAR_X + along], parts[part, OFF_X + along], parts[part, EXT_X + along] = own, 0, size
    parts[part, LOW], parts[part, HIGH] = 0, PERSON_MM


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8))
def _linked(room: RoomArrays, work: Work, piece: int) -> None:
    """Adds the quadratic terms of a piece's relations to the pieces before it."""
    parts, own, links, costs = work.parts, work.body_part[piece], room.links, room.link_costs
    for link in range(room.pieces[piece, LINK_0], room.pieces[piece, LINK_1]):
        of = links[link, OF]
        if work.taken_candidate[of] == ABSENT:
            continue
        other = work.body_part[of]
        across = 0 if work.rotation[of] % 180 == 0 else 1
        for axis in range(2):
            weight = costs[link, NEAR]
            if axis == across:
                weight += costs[link, ALIGN]
            i, j = parts[other, VAR_X + axis], parts[own, VAR_X + axis]
            if weight > 0 and i != j:
                middle = 2 * (parts[other, OFF_X + axis] - parts[own, OFF_X + axis])
                middle += parts[other, EXT_X + axis] - parts[own, EXT_X + axis]
                _pull(work.counts, work.pulls, work.pull_costs, axis, i, j, middle / 2000, weight)


@compiled(lambda t: t.b1(t.int_rows, t.int_rows, t.ints, t.i8, t.i8))
def _must_part(parts: Ints, candidates: Ints, taken_candidate: Ints, a: int, b: int) -> bool:
    """Tells whether two parts must not share space."""
    first, second = parts[a, PIECE], parts[b, PIECE]
    if first == second or (parts[a, STAND] != 0 and parts[b, STAND] != 0):
        return False
    if parts[a, HIGH] <= parts[b, LOW] or parts[b, HIGH] <= parts[a, LOW]:
        return False
    if parts[a, STAND] != 0 or parts[b, STAND] != 0:
        return True
    one, two = taken_candidate[first], taken_candidate[second]
    if candidates[one, UNDER] == second or candidates[one, ON] == second:
        return False
    return candidates[two, UNDER] != first and candidates[two, ON] != first


@compiled(lambda t: t.b1(t.int_rows, t.int_rows, t.int_rows, t.ints, t.i8, t.i8, t.i8, t.i8, t.i8))
def _offer(low: Ints, high: Ints, options: Ints, choice_size: Ints, choice: int, axis: int, i: int, j: int, s: int) -> bool:
    """Adds an option to a choice where the bounds allow it; True where they hold it anyway."""
    least, most = 0, 0
    if i != j:
        if j != ORIGIN:
            least, most = low[axis, j], high[axis, j]
        if i != ORIGIN:
            least, most = least - high[axis, i], most - low[axis, i]
    if least >= s:
        return True
    if most >= s:
        at = 4 * choice + choice_size[choice]
        options[at, AXIS], options[at, I], options[at, J], options[at, S] = axis, i, j, s
        choice_size[choice] += 1
    return False


@compiled(lambda t: t.b1(t.int_rows, t.int_rows, t.int_rows, t.ints, t.int_rows, t.i8, t.i8, t.i8))
def _apart(low: Ints, high: Ints, options: Ints, choice_size: Ints, parts: Ints, choice: int, a: int, b: int) -> bool:
    """Writes the options that keep two parts apart, a left of, right of, north of, south of b; False where the bounds do."""
    choice_size[choice] = 0
    for axis in range(2):
        u, v = parts[a, VAR_X + axis], parts[b, VAR_X + axis]
        shift = parts[a, OFF_X + axis] - parts[b, OFF_X + axis]
        if _offer(low, high, options, choice_size, choice, axis, u, v, parts[a, EXT_X + axis] + shift):
            return False
        if _offer(low, high, options, choice_size, choice, axis, v, u, parts[b, EXT_X + axis] - shift):
            return False
    return True


@compiled(lambda t: t.b1(t.int_rows, t.int_rows, t.int_rows, t.ints, t.int_rows, t.int_rows, t.i8, t.i8, t.i8))
def _clear_of(low: Ints, high: Ints, options: Ints, choice_size: Ints, parts: Ints, zones: Ints, choice: int, a: int, zone: int) -> bool:
    """Writes the options that keep a part out of a zone; False where the bounds do."""
    choice_size[choice] = 0
    for axis in range(2):
        v, offset, extent = parts[a, VAR_X + axis], parts[a, OFF_X + axis], parts[a, EXT_X + axis]
        if _offer(low, high, options, choice_size, choice, axis, v, ORIGIN, extent + offset - zones[zone, axis]):
            return False
        if _offer(low, high, options, choice_size, choice, axis, ORIGIN, v, zones[zone, 2 + axis] - offset):
            return False
    return True


@compiled(lambda t: t.none(t.RoomArrays, t.Work, t.i8))
def _choices(room: RoomArrays, work: Work, first: int) -> None:
    """Appends the choices of the parts from number `first` on: against zones, against the parts before them."""
    parts, zones, candidates, taken_candidate = work.parts, room.zones, room.candidates, work.taken_candidate
    low, high, options, choice_size, choice_parts = work.low, work.high, work.options, work.choice_size, work.choice_parts
    choice = work.counts[N_CHOICES]
    for b in range(first, work.counts[N_PARTS]):
        for zone in range(len(zones)):
            if zones[zone, WALL_ZONE] == 0 and (parts[b, STAND] != 0 or parts[b, HIGH] <= zones[zone, ABOVE]):
                continue
            if _clear_of(low, high, options, choice_size, parts, zones, choice, b, zone):
                choice_parts[choice, 0], choice_parts[choice, 1] = b, -1 - zone
                choice += 1
        for a in range(b):
            if _must_part(parts, candidates, taken_candidate, a, b) and _apart(low, high, options, choice_size, parts, choice, a, b):
                choice_parts[choice, 0], choice_parts[choice, 1] = a, b
                choice += 1
    work.counts[N_CHOICES] = choice


@compiled(lambda t: t.b1(t.Work))
def _bounds_hold(work: Work) -> bool:
    low, high = work.low, work.high
    for axis in range(2):
        for v in range(work.sizes[axis]):
            if low[axis, v] > high[axis, v]:
                return False
    return True


@compiled(lambda t: t.none(t.Work, t.i8, t.i8))
def _mark(work: Work, piece: int, decision: int) -> None:
    """Notes what the problem is once a piece was added, so that the next problem can go on from there."""
    marks, bounds, counts, sizes, low, high = work.marks, work.marked_bounds, work.counts, work.sizes, work.low, work.high
    marks[piece, 0], marks[piece, 1], marks[piece, 2] = decision, sizes[0], sizes[1]
    for k in range(4):
        marks[piece, 3 + k] = counts[k]
    for axis in range(2):
        for v in range(sizes[axis]):
            bounds[piece, axis, v], bounds[piece, 2 + axis, v] = low[axis, v], high[axis, v]


@compiled(lambda t: t.i8(t.Work, t.ints))
def _go_back(work: Work, decisions: Ints) -> int:
    """Brings back the problem of as many pieces as are decided as they were last; returns how many."""
    marks, bounds, counts, sizes, low, high = work.marks, work.marked_bounds, work.counts, work.sizes, work.low, work.high
    first = 0
    while first < min(counts[ASSEMBLED], len(decisions)) and marks[first, 0] == decisions[first]:
        first += 1
    for k in range(4):
        counts[k] = marks[first - 1, 3 + k] if first > 0 else 0
    for axis in range(2):
        sizes[axis] = marks[first - 1, 1 + axis] if first > 0 else 0
        for v in range(sizes[axis]):
            low[axis, v], high[axis, v] = bounds[first - 1, axis, v], bounds[first - 1, 2 + axis, v]
    return first


@compiled(lambda t: t.b1(t.RoomArrays, t.Work, t.ints))
def assemble(room: RoomArrays, work: Work, decisions: Ints) -> bool:
    """Writes the problem of the decisions; False where the bounds alone rule them out.

    A piece whose parent is absent is an error of the caller. Choices that the bounds settle are left out. What the last
    problem began with in the same way is kept.
    """
    taken_candidate, taken_side, candidates, sides = work.taken_candidate, work.taken_side, room.candidates, room.sides
    for piece in range(_go_back(work, decisions), len(decisions)):
        taken_candidate[piece] = ABSENT
        if decisions[piece] != ABSENT:
            candidate, known = decisions[piece] // 8, work.counts[N_PARTS]
            side = room.pieces[piece, SIDES_0] + decisions[piece] % 8
            taken_candidate[piece], taken_side[piece] = candidate, side
            if candidates[candidate, PARENT] == ABSENT:
                _rooted(room, work, piece, candidate)
            else:
                _attached(room, work, piece, candidate)
            for bit in range(4):
                if sides[side, STANDS] & (1 << bit):
                    _stand(room, work, piece, 1 << bit)
            _linked(room, work, piece)
            add_barriers(room, work, known)
            _choices(room, work, known)
        _mark(work, piece, decisions[piece])
    work.counts[ASSEMBLED] = len(decisions)
    return _bounds_hold(work)
