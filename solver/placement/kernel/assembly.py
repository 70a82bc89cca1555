"""From decisions to a problem: variables, bounds, parts, terms, rows and choices.

`decisions[p]` is the alternative of piece p times 8 plus the number of its choice of sides, or ABSENT. Rigid companions share their
parent's variables, so that nothing has to be searched between them. A stand is a person's square before a use side.
"""

from __future__ import annotations

from typing import Final

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
    AXIS,
    BACK,
    BOTTOM,
    DEPTH,
    EAST,
    EXT_X,
    FRONT,
    GAP,
    HEIGHT,
    HIGH,
    IN_X0,
    LEFT,
    LINK_0,
    LINK_1,
    LOW,
    N_CHOICES,
    N_PARTS,
    N_PULLS,
    N_ROWS,
    NEAR,
    NO_WALL,
    NORTH,
    OF,
    OFF_X,
    ON,
    ORIGIN,
    PARENT,
    PIECE,
    PULL_OFFSET,
    PULL_WEIGHT,
    RIGHT,
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
    I,
    Ints,
    J,
    Room,
    S,
    Work,
)

STAND_WEIGHT: Final = 0.02
"""Pull of a person's square to the middle of its side, m^-2: least weight that keeps the Hessian positive definite."""
PERSON_MM: Final = 1800
"""Height a standing person needs free, mm."""


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


@compiled(lambda t: t.i8(t.Work, t.i8, t.i8, t.i8))
def _variable(work: Work, axis: int, low: int, high: int) -> int:
    v = work.sizes[axis]
    work.low[axis, v], work.high[axis, v] = low, high
    work.anchor_weight[axis, v], work.anchor_at[axis, v] = 0.0, 0.0
    work.sizes[axis] = v + 1
    return v


@compiled(lambda t: t.none(t.Work, t.i8, t.i8, t.i8, t.i8))
def _tighten(work: Work, axis: int, v: int, low: int, high: int) -> None:
    work.low[axis, v] = max(work.low[axis, v], low)
    work.high[axis, v] = min(work.high[axis, v], high)


@compiled(lambda t: t.none(t.Work, t.i8, t.i8, t.i8, t.i8))
def _row(work: Work, axis: int, i: int, j: int, s: int) -> None:
    k = work.counts[N_ROWS]
    work.rows[k, AXIS], work.rows[k, I], work.rows[k, J], work.rows[k, S] = axis, i, j, s
    work.counts[N_ROWS] = k + 1


@compiled(lambda t: t.none(t.Work, t.i8, t.i8, t.i8, t.f8, t.f8))
def _pull(work: Work, axis: int, i: int, j: int, offset: float, weight: float) -> None:  # noqa: PLR0913
    k = work.counts[N_PULLS]
    work.pulls[k, AXIS], work.pulls[k, I], work.pulls[k, J] = axis, i, j
    work.pull_costs[k, PULL_OFFSET], work.pull_costs[k, PULL_WEIGHT] = offset, weight
    work.counts[N_PULLS] = k + 1


@compiled(lambda t: t.i8(t.Work, t.i8, t.i8))
def _part(work: Work, piece: int, stand: int) -> int:
    k = work.counts[N_PARTS]
    work.parts[k, PIECE], work.parts[k, STAND] = piece, stand
    work.counts[N_PARTS] = k + 1
    return k


@compiled(lambda t: t.none(t.Room, t.Work, t.i8, t.i8))
def _rooted(room: Room, work: Work, piece: int, alt: int) -> None:
    """Adds a body with its own variables: in the room, or flush at a wall."""
    alts, space = room.alts, room.space
    turn, wall = alts[alt, TURN], alts[alt, WALL]
    body = _part(work, piece, 0)
    across = turn == 90 or turn == 270
    for axis in range(2):
        extent = alts[alt, DEPTH] if across == (axis == 0) else alts[alt, WIDTH]
        low, high = alts[alt, IN_X0 + axis], alts[alt, IN_X0 + 2 + axis] - extent
        slack = alts[alt, SLACK]
        near, far = (space[GAP], space[GAP]) if slack < 0 else (0, slack)
        if (axis == 1 and wall == NORTH) or (axis == 0 and wall == WEST):
            low, high = max(low, space[X0 + axis] + near), min(high, space[X0 + axis] + far)
        elif (axis == 1 and wall == SOUTH) or (axis == 0 and wall == EAST):
            end = space[X1 + axis] - extent
            low, high = max(low, end - far), min(high, end - near)
        v = _variable(work, axis, low, high)
        work.parts[body, VAR_X + axis], work.parts[body, OFF_X + axis], work.parts[body, EXT_X + axis] = v, 0, extent
        work.anchor_at[axis, v] = (2 * alts[alt, ANCHOR_X + axis] - extent) / 2000
        work.anchor_weight[axis, v] = room.alt_costs[alt, WEIGHT_X + axis]
    work.parts[body, LOW], work.parts[body, HIGH] = alts[alt, BOTTOM], alts[alt, BOTTOM] + alts[alt, HEIGHT]
    work.body_part[piece], work.rotation[piece] = body, turn


@compiled(lambda t: t.none(t.Room, t.Work, t.i8, t.i8))
def _attached(room: Room, work: Work, piece: int, alt: int) -> None:
    """Adds a body that stands at a slot of its parent: with the parent's variable where the slot is rigid."""
    alts, parts = room.alts, work.parts
    parent = work.body_part[alts[alt, PARENT]]
    turn = work.rotation[alts[alt, PARENT]]
    rotation = (turn + alts[alt, TURN]) % 360
    body = _part(work, piece, 0)
    across = rotation == 90 or rotation == 270
    for axis in range(2):
        extent = alts[alt, DEPTH] if across == (axis == 0) else alts[alt, WIDTH]
        if axis == 0:
            first = turned_x(alts[alt, ACROSS_0], alts[alt, ALONG_0], turn)
            last = turned_x(alts[alt, ACROSS_1], alts[alt, ALONG_1], turn)
        else:
            first = turned_z(alts[alt, ACROSS_0], alts[alt, ALONG_0], turn)
            last = turned_z(alts[alt, ACROSS_1], alts[alt, ALONG_1], turn)
        least, most = min(first, last), max(first, last)
        low, high = room.space[X0 + axis], room.space[X1 + axis] - extent
        shift = (parts[parent, EXT_X + axis] - extent) // 2 + parts[parent, OFF_X + axis]
        if least == most:
            v = parts[parent, VAR_X + axis]
            parts[body, OFF_X + axis] = shift + least
            _tighten(work, axis, v, low - shift - least, high - shift - least)
        else:
            v = _variable(work, axis, low, high)
            parts[body, OFF_X + axis] = 0
            _row(work, axis, parts[parent, VAR_X + axis], v, shift + least)
            _row(work, axis, v, parts[parent, VAR_X + axis], -shift - most)
            middle = (2 * shift + least + most) / 2000
            _pull(work, axis, parts[parent, VAR_X + axis], v, middle, room.alt_costs[alt, WEIGHT_X + axis])
        parts[body, VAR_X + axis], parts[body, EXT_X + axis] = v, extent
    parts[body, LOW], parts[body, HIGH] = alts[alt, BOTTOM], alts[alt, BOTTOM] + alts[alt, HEIGHT]
    work.body_part[piece], work.rotation[piece] = body, rotation


@compiled(lambda t: t.i8(t.i8, t.i8))
def facing(side: int, rotation: int) -> int:
    """Returns the wall that a side of a body with that rotation looks at."""
    x = 1 if side == RIGHT else -1 if side == LEFT else 0
    z = 1 if side == FRONT else -1 if side == BACK else 0
    dx, dz = turned_x(x, z, rotation), turned_z(x, z, rotation)
    if dx == 0:
        return SOUTH if dz > 0 else NORTH
    return EAST if dx > 0 else WEST


@compiled(lambda t: t.none(t.Room, t.Work, t.i8, t.i8))
def _stand(room: Room, work: Work, piece: int, side: int) -> None:
    """Adds the person's square at a use side: touching it, its centre sliding along the side."""
    parts, space, size = work.parts, room.space, room.space[ROBOT]
    body, wall = work.body_part[piece], facing(side, work.rotation[piece])
    normal = 0 if wall == EAST or wall == WEST else 1
    along = 1 - normal
    part = _part(work, piece, side)
    offset = parts[body, OFF_X + normal] + (parts[body, EXT_X + normal] if wall == EAST or wall == SOUTH else -size)
    v = parts[body, VAR_X + normal]
    _tighten(work, normal, v, space[X0 + normal] - offset, space[X1 + normal] - size - offset)
    parts[part, VAR_X + normal], parts[part, OFF_X + normal], parts[part, EXT_X + normal] = v, offset, size
    start, extent, v = parts[body, OFF_X + along], parts[body, EXT_X + along], parts[body, VAR_X + along]
    own = _variable(work, along, space[X0 + along], space[X1 + along] - size)
    _row(work, along, v, own, start - size // 2)
    _row(work, along, own, v, size // 2 - extent - start)
    _pull(work, along, v, own, (2 * start + extent - size) / 2000, STAND_WEIGHT)
    parts[part, VAR_X + along], parts[part, OFF_X + along], parts[part, EXT_X + along] = own, 0, size
    parts[part, LOW], parts[part, HIGH] = 0, PERSON_MM


@compiled(lambda t: t.none(t.Room, t.Work, t.i8))
def _linked(room: Room, work: Work, piece: int) -> None:
    """Adds the quadratic terms of a piece's relations to the pieces before it."""
    parts, own = work.parts, work.body_part[piece]
    for link in range(room.pieces[piece, LINK_0], room.pieces[piece, LINK_1]):
        of = room.links[link, OF]
        if work.taken_alt[of] == ABSENT:
            continue
        other = work.body_part[of]
        across = 0 if work.rotation[of] % 180 == 0 else 1
        for axis in range(2):
            weight = room.link_costs[link, NEAR]
            if axis == across:
                weight += room.link_costs[link, ALIGN]
            i, j = parts[other, VAR_X + axis], parts[own, VAR_X + axis]
            if weight > 0 and i != j:
                middle = 2 * (parts[other, OFF_X + axis] - parts[own, OFF_X + axis])
                middle += parts[other, EXT_X + axis] - parts[own, EXT_X + axis]
                _pull(work, axis, i, j, middle / 2000, weight)


@compiled(lambda t: t.b1(t.Room, t.Work, t.i8, t.i8))
def _must_part(room: Room, work: Work, a: int, b: int) -> bool:
    """Tells whether two parts must not share space."""
    parts = work.parts
    first, second = parts[a, PIECE], parts[b, PIECE]
    if first == second or (parts[a, STAND] and parts[b, STAND]):
        return False
    if parts[a, HIGH] <= parts[b, LOW] or parts[b, HIGH] <= parts[a, LOW]:
        return False
    if parts[a, STAND] or parts[b, STAND]:
        return True
    one, two = room.alts[work.taken_alt[first]], room.alts[work.taken_alt[second]]
    if one[UNDER] == second or one[ON] == second:
        return False
    return two[UNDER] != first and two[ON] != first


@compiled(lambda t: t.b1(t.Work, t.i8, t.i8, t.i8, t.i8, t.i8))
def offer(work: Work, choice: int, axis: int, i: int, j: int, s: int) -> bool:  # noqa: PLR0913
    """Adds an option to a choice where the bounds allow it; True where they hold it anyway."""
    least, most = 0, 0
    if i != j:
        if j != ORIGIN:
            least, most = work.low[axis, j], work.high[axis, j]
        if i != ORIGIN:
            least, most = least - work.high[axis, i], most - work.low[axis, i]
    if least >= s:
        return True
    if most >= s:
        at = 4 * choice + work.choice_size[choice]
        work.options[at, AXIS], work.options[at, I], work.options[at, J], work.options[at, S] = axis, i, j, s
        work.choice_size[choice] += 1
    return False


@compiled(lambda t: t.none(t.Work, t.i8, t.i8))
def _apart(work: Work, a: int, b: int) -> None:
    """Adds the choice that keeps two parts apart: a left of, right of, north of, south of b."""
    parts, choice = work.parts, work.counts[N_CHOICES]
    work.choice_size[choice], work.choice_parts[choice, 0], work.choice_parts[choice, 1] = 0, a, b
    for axis in range(2):
        u, v = parts[a, VAR_X + axis], parts[b, VAR_X + axis]
        shift = parts[a, OFF_X + axis] - parts[b, OFF_X + axis]
        if offer(work, choice, axis, u, v, parts[a, EXT_X + axis] + shift):
            return
        if offer(work, choice, axis, v, u, parts[b, EXT_X + axis] - shift):
            return
    work.counts[N_CHOICES] = choice + 1


@compiled(lambda t: t.none(t.Room, t.Work, t.i8, t.i8))
def _clear_of(room: Room, work: Work, a: int, zone: int) -> None:
    """Adds the choice that keeps a part out of a zone."""
    parts, choice = work.parts, work.counts[N_CHOICES]
    work.choice_size[choice], work.choice_parts[choice, 0], work.choice_parts[choice, 1] = 0, a, -1 - zone
    for axis in range(2):
        v, offset, extent = parts[a, VAR_X + axis], parts[a, OFF_X + axis], parts[a, EXT_X + axis]
        if offer(work, choice, axis, v, ORIGIN, extent + offset - room.zones[zone, axis]):
            return
        if offer(work, choice, axis, ORIGIN, v, room.zones[zone, 2 + axis] - offset):
            return
    work.counts[N_CHOICES] = choice + 1


@compiled(lambda t: t.b1(t.Work))
def _bounds_hold(work: Work) -> bool:
    for axis in range(2):
        for v in range(work.sizes[axis]):
            if work.low[axis, v] > work.high[axis, v]:
                return False
    return True


@compiled(lambda t: t.b1(t.Room, t.Work, t.ints))
def assemble(room: Room, work: Work, decisions: Ints) -> bool:
    """Writes the problem of the decisions; False where the bounds alone rule them out.

    A piece whose parent is absent is an error of the caller. Choices that the bounds settle are left out.
    """
    work.counts[:] = 0
    work.sizes[:] = 0
    for piece in range(len(decisions)):
        work.taken_alt[piece] = ABSENT
        if decisions[piece] == ABSENT:
            continue
        alt = decisions[piece] // 8
        side = room.pieces[piece, SIDES_0] + decisions[piece] % 8
        work.taken_alt[piece], work.taken_side[piece] = alt, side
        if room.alts[alt, PARENT] == NO_WALL:
            _rooted(room, work, piece, alt)
        else:
            _attached(room, work, piece, alt)
        for bit in range(4):
            if room.sides[side, STANDS] & (1 << bit):
                _stand(room, work, piece, 1 << bit)
        _linked(room, work, piece)
    if not _bounds_hold(work):
        return False
    parts = work.parts
    for b in range(work.counts[N_PARTS]):
        for zone in range(len(room.zones)):
            if room.zones[zone, WALL_ZONE] or (not parts[b, STAND] and parts[b, HIGH] > room.zones[zone, ABOVE]):
                _clear_of(room, work, b, zone)
        for a in range(b):
            if _must_part(room, work, a, b):
                _apart(work, a, b)
    return True
