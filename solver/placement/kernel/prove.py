"""Whether decided pieces can be used together at all: branch and bound over where they stand, in whole millimetres.

A node holds an interval for every variable. Rows and choices narrow it; where a body covers floor wherever in its interval it stands,
that floor is certainly taken. If the rest has no component that meets all doors and use sides and is large enough, nobody can
walk in any placement of the node. A node that is left is parted: by a choice, then by the widest interval.
"""

from __future__ import annotations

from typing import Final

from solver.placement.kernel.grid import may_be_walkable, walkable
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    AXIS,
    EXT_X,
    IMPOSSIBLE,
    N_CHOICES,
    N_PARTS,
    N_ROWS,
    OFF_X,
    ORIGIN,
    POSSIBLE,
    STAND,
    UNKNOWN,
    VAR_X,
    X0,
    X1,
    I,
    Ints,
    J,
    RoomArrays,
    S,
    WalkGrid,
    Work,
)

UNDECIDED: Final = -1
SETTLED: Final = -2
"""What a node has of a choice, unless the number of the option that it took."""
ROUNDS: Final = 40
"""Passes over the rows at a node, at most; fewer only prune less."""


@compiled(lambda t: t.i8(t.int_rows, t.int_rows, t.i8, t.i8, t.i8, t.i8))
def _tighten(low: Ints, high: Ints, axis: int, i: int, j: int, s: int) -> int:
    """Narrows two intervals to p_j - p_i >= s; returns 1 where that changed one, -1 where it cannot hold."""
    if i == j:
        return -1 if s > 0 else 0
    first = 0 if i == ORIGIN else low[axis, i]
    last = 0 if j == ORIGIN else high[axis, j]
    if last - first < s:
        return -1
    changed = 0
    if j != ORIGIN and low[axis, j] < first + s:
        low[axis, j] = first + s
        changed = 1
    if i != ORIGIN and high[axis, i] > last - s:
        high[axis, i] = last - s
        changed = 1
    return changed


@compiled(lambda t: t.i8(t.int_rows, t.int_rows, t.int_rows, t.i8))
def _holds(low: Ints, high: Ints, options: Ints, option: int) -> int:
    """Tells whether an option holds anywhere in the intervals (1), nowhere (-1), or that depends (0)."""
    axis, i, j, s = options[option, AXIS], options[option, I], options[option, J], options[option, S]
    if i == j:
        return 1 if s <= 0 else -1
    least, most = 0, 0
    if j != ORIGIN:
        least, most = low[axis, j], high[axis, j]
    if i != ORIGIN:
        least, most = least - high[axis, i], most - low[axis, i]
    return 1 if least >= s else -1 if most < s else 0


@compiled(lambda t: t.i8(t.Work, t.int_rows, t.int_rows, t.ints, t.ints, t.i8))
def _decide(work: Work, low: Ints, high: Ints, picks: Ints, refused: Ints, choice: int) -> int:
    """Narrows the intervals by one choice; as `_tighten`."""
    options, changed = work.options, 0
    for k in range(work.choice_size[choice]):
        if refused[choice] & (1 << k):
            row = options[4 * choice + k]
            step = _tighten(low, high, row[AXIS], row[J], row[I], 1 - row[S])
            if step < 0:
                return -1
            changed |= step
    if picks[choice] == UNDECIDED:
        left, only = 0, 0
        for k in range(work.choice_size[choice]):
            holds = _holds(low, high, options, 4 * choice + k)
            if holds > 0:
                picks[choice] = SETTLED
                return changed
            if holds == 0 and not refused[choice] & (1 << k):
                left, only = left + 1, k
        if left == 0:
            return -1
        if left == 1:
            picks[choice] = only
    if picks[choice] >= 0:
        row = options[4 * choice + picks[choice]]
        step = _tighten(low, high, row[AXIS], row[I], row[J], row[S])
        return -1 if step < 0 else changed | step
    return changed


@compiled(lambda t: t.b1(t.Work, t.int_rows, t.int_rows, t.ints, t.ints))
def _narrow(work: Work, low: Ints, high: Ints, picks: Ints, refused: Ints) -> bool:
    """Narrows the intervals until nothing changes; False where a row or a choice cannot hold."""
    for _ in range(ROUNDS):
        changed = 0
        for k in range(work.counts[N_ROWS]):
            row = work.rows[k]
            step = _tighten(low, high, row[AXIS], row[I], row[J], row[S])
            if step < 0:
                return False
            changed |= step
        for choice in range(work.counts[N_CHOICES]):
            if picks[choice] != SETTLED or refused[choice]:
                step = _decide(work, low, high, picks, refused, choice)
                if step < 0:
                    return False
                changed |= step
        if not changed:
            return True
    return True


@compiled(lambda t: t.i8(t.Work, t.int_rows, t.int_rows, t.ints, t.ints))
def _open_choice(work: Work, low: Ints, high: Ints, picks: Ints, refused: Ints) -> int:
    """Returns the undecided choice with the fewest options left, of these the one between the largest parts; -1 where all are decided."""
    best, fewest, largest = -1, 9, 0
    for choice in range(work.counts[N_CHOICES]):
        if picks[choice] != UNDECIDED:
            continue
        left = 0
        for k in range(work.choice_size[choice]):
            if not refused[choice] & (1 << k) and _holds(low, high, work.options, 4 * choice + k) == 0:
                left += 1
        size = 0
        for end in range(2):
            part = work.choice_parts[choice, end]
            if part >= 0:
                size += work.parts[part, EXT_X] * work.parts[part, EXT_X + 1]
        if left < fewest or (left == fewest and size > largest):
            best, fewest, largest = choice, left, size
    return best


@compiled(lambda t: t.i8(t.Work, t.int_rows, t.int_rows))
def _widest(work: Work, low: Ints, high: Ints) -> int:
    """Returns 2 * variable + axis of the widest interval of a body; -1 where all are single millimetres."""
    best, most = -1, 0
    for k in range(work.counts[N_PARTS]):
        if work.parts[k, STAND] == 0:
            for axis in range(2):
                v = work.parts[k, VAR_X + axis]
                if high[axis, v] - low[axis, v] > most:
                    best, most = 2 * v + axis, high[axis, v] - low[axis, v]
    return best


@compiled(lambda t: t.none(t.int_cubes, t.int_cubes, t.int_rows, t.int_rows, t.i8, t.i8))
def _copy(lows: Ints, highs: Ints, picks: Ints, refused: Ints, source: int, target: int) -> None:
    """Copies a node."""
    for axis in range(2):
        for v in range(lows.shape[2]):
            lows[target, axis, v], highs[target, axis, v] = lows[source, axis, v], highs[source, axis, v]
    for choice in range(picks.shape[1]):
        picks[target, choice], refused[target, choice] = picks[source, choice], refused[source, choice]


@compiled(lambda t: t.i8(t.Work, t.int_cubes, t.int_cubes, t.int_rows, t.int_rows, t.i8, t.i8))
def _part_by_choice(work: Work, lows: Ints, highs: Ints, picks: Ints, refused: Ints, node: int, choice: int) -> int:
    """Replaces a node by one for every option left of a choice, each without what those before it hold; returns the nodes' number."""
    first, last = -1, node
    for k in range(work.choice_size[choice]):
        if not refused[node, choice] & (1 << k) and _holds(lows[node], highs[node], work.options, 4 * choice + k) == 0:
            if first < 0:
                first = k
            else:
                last += 1
                _copy(lows, highs, picks, refused, node, last)
                picks[last, choice] = k
                for other in range(k):
                    refused[last, choice] |= 1 << other
    picks[node, choice] = first
    return last + 1


@compiled(lambda t: t.i8(t.int_cubes, t.int_cubes, t.int_rows, t.int_rows, t.i8, t.i8))
def _part_by_interval(lows: Ints, highs: Ints, picks: Ints, refused: Ints, node: int, where: int) -> int:
    """Replaces a node by its two halves along an interval; returns how many nodes there are."""
    axis, v = where % 2, where // 2
    middle = (lows[node, axis, v] + highs[node, axis, v]) // 2
    _copy(lows, highs, picks, refused, node, node + 1)
    highs[node, axis, v], lows[node + 1, axis, v] = middle, middle + 1
    return node + 2


@compiled(lambda t: t.b1(t.RoomArrays, t.Work, t.WalkGrid, t.int_cubes, t.int_cubes, t.int_rows, t.int_rows, t.i8))
def _somewhere(room: RoomArrays, work: Work, grid: WalkGrid, lows: Ints, highs: Ints, picks: Ints, refused: Ints, node: int) -> bool:
    """Tells whether a placement of a node whose choices are decided is walkable, of a few: all near a wall, or all to one end."""
    positions, space = grid.positions, room.space
    for sample in range(3):
        _copy(lows, highs, picks, refused, node, node + 1)
        low, high, whole = lows[node + 1], highs[node + 1], True
        if sample == 0:
            for part in range(work.counts[N_PARTS]):
                for axis in range(2):
                    v = work.parts[part, VAR_X + axis]
                    if low[axis, v] < high[axis, v]:
                        middle = low[axis, v] + high[axis, v] + 2 * work.parts[part, OFF_X + axis] + work.parts[part, EXT_X + axis]
                        if middle < space[X0 + axis] + space[X1 + axis]:
                            high[axis, v] = low[axis, v]
                        else:
                            low[axis, v] = high[axis, v]
                        whole &= _narrow(work, low, high, picks[node + 1], refused[node + 1])
        for axis in range(2):
            for v in range(work.sizes[axis]):
                at = high[axis, v] if sample == 2 else low[axis, v]
                low[axis, v], high[axis, v], positions[axis, v] = at, at, at
        if whole and _narrow(work, low, high, picks[node + 1], refused[node + 1]) and walkable(room, work, grid, positions):
            return True
    return False


@compiled(lambda t: t.i8(t.RoomArrays, t.Work, t.WalkGrid, t.int_cubes, t.int_cubes, t.int_rows, t.int_rows, t.ints))
def prove(room: RoomArrays, work: Work, grid: WalkGrid, lows: Ints, highs: Ints, picks: Ints, refused: Ints, allowed: Ints) -> int:
    """Proves that the assembled pieces cannot be used together, or finds where they can.

    Args:
        room, work, grid: the work space, assembled with persons' squares at the use sides.
        lows, highs: room for the nodes' intervals: (nodes, 2, variables).
        picks, refused: room for what they have of each choice: (nodes, choices).
        allowed: nodes that may still be looked at; counted down.

    Returns:
        IMPOSSIBLE, proven; POSSIBLE, a walkable placement is in grid.positions; or UNKNOWN.
    """
    for axis in range(2):
        for v in range(work.sizes[axis]):
            lows[0, axis, v], highs[0, axis, v] = work.low[axis, v], work.high[axis, v]
    picks[0, :], refused[0, :] = UNDECIDED, 0
    count, verdict = 1, IMPOSSIBLE
    while count > 0:
        if allowed[0] <= 0 or count + 4 > len(picks):
            return UNKNOWN
        allowed[0] -= 1
        node = count - 1
        low, high = lows[node], highs[node]
        if not _narrow(work, low, high, picks[node], refused[node]) or not may_be_walkable(room, work, grid, low, high):
            count -= 1
            continue
        choice = _open_choice(work, low, high, picks[node], refused[node])
        if choice >= 0:
            count = _part_by_choice(work, lows, highs, picks, refused, node, choice)
            continue
        if _somewhere(room, work, grid, lows, highs, picks, refused, node):
            return POSSIBLE
        where = _widest(work, low, high)
        if where < 0:
            verdict = UNKNOWN
            count -= 1
            continue
        count = _part_by_interval(lows, highs, picks, refused, node, where)
    return verdict
