"""Back towards where it was wished: every body as far as all rules and the walk still hold, in whole millimetres.

A walkable placement was found with more kept free than the rules ask: a square at every use side, a piece of floor, a person's
width between whole pairs. What of that nobody needs is given back here, one body after the other, along both axes at once and
along each, until nothing moves any more.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.grid import COMPONENTS, ENTERED, walkable
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    AXIS,
    EXHAUSTED,
    FOUND,
    LEAST_FLOOR,
    N_CHOICES,
    N_PARTS,
    N_ROWS,
    PICKS,
    STAND,
    VAR_X,
    X0,
    Engine,
    I,
    Ints,
    J,
    RoomArrays,
    S,
    WalkGrid,
    Work,
)

STEP_MM: Final = 50
"""Places this far apart are tried from the wished one on; before the first that does, the last millimetres are bisected."""
MOST_ROUNDS: Final = 8
"""Rounds over all bodies; nearly always the second changes nothing."""
DOUBT_MM: Final = 2
"""Each measure of a patch counts it narrower or wider by less than this."""
BOTH: Final = 2
"""After the axes 0 and 1: along the straight line."""


@compiled(lambda t: t.b1(t.Work, t.int_rows))
def holds(work: Work, p: Ints) -> bool:
    """Tells whether bounds, rows and choices hold at integer positions p (2, variables + 1), mm; the last column is 0."""
    rows, options, choice_size = work.rows, work.options, work.choice_size
    for axis in range(2):
        for v in range(work.sizes[axis]):
            if p[axis, v] < work.low[axis, v] or p[axis, v] > work.high[axis, v]:
                return False
    for k in range(work.counts[N_ROWS]):
        if p[rows[k, AXIS], rows[k, J]] - p[rows[k, AXIS], rows[k, I]] < rows[k, S]:
            return False
    for c in range(work.counts[N_CHOICES]):
        held = False
        for k in range(4 * c, 4 * c + choice_size[c]):
            if p[options[k, AXIS], options[k, J]] - p[options[k, AXIS], options[k, I]] >= options[k, S]:
                held = True
                break
        if not held:
            return False
    return True


@compiled(lambda t: t.f8(t.Work, t.int_rows))
def movement(work: Work, p: Ints) -> float:
    """Returns what the distances from the wished places cost at integer positions."""
    cost = 0.0
    for axis in range(2):
        for v in range(work.sizes[axis]):
            away = p[axis, v] / 1000 - work.anchor_at[axis, v]
            cost += work.anchor_weight[axis, v] * away * away
    return cost


@compiled(lambda t: t.i8(t.Work, t.i8, t.i8))
def _wished(work: Work, axis: int, v: int) -> int:
    """Returns a variable's wished place within its bounds, mm; halves go down, as in the snap."""
    at = np.int64(np.floor(work.anchor_at[axis, v] * 1000 + 0.49))
    return min(max(at, work.low[axis, v]), work.high[axis, v])


@compiled(lambda t: t.b1(t.RoomArrays, t.WalkGrid))
def _floor_is_sure(room: RoomArrays, grid: WalkGrid) -> bool:
    """Tells whether the patch that the walk entered would be entered, and be large enough, by any measure.

    How large a patch is depends on the millimetre by which the person is smaller; a room without doors is entered at the largest.
    """
    space, areas, entered = room.space, grid.areas, grid.state[ENTERED]
    doubt = 2 * DOUBT_MM * (space[X0 + 2] - space[X0] + space[X0 + 3] - space[X0 + 1])
    if space[LEAST_FLOOR] > 0 and areas[entered] < 4 * space[LEAST_FLOOR] + doubt:
        return False
    if len(room.doors) == 0:
        for c in range(1, grid.state[COMPONENTS] + 1):
            if c != entered and areas[c] + 2 * doubt > areas[entered]:
                return False
    return True


@compiled(lambda t: t.b1(t.Engine, t.i8, t.i8, t.i8, t.i8))
def _may(engine: Engine, u: int, v: int, x: int, z: int) -> bool:
    """Puts the variables u along x and v along z to a place; tells whether all holds there."""
    p = engine.grid.positions
    p[0, u], p[1, v] = x, z
    return holds(engine.work, p) and walkable(engine.room, engine.work, engine.grid, p) and _floor_is_sure(engine.room, engine.grid)


@compiled(lambda t: t.b1(t.Engine, t.i8, t.i8, t.i8))
def _pull(engine: Engine, u: int, v: int, direction: int) -> bool:
    """Brings one body back along a direction as far as it goes; tells whether it moved."""
    p, work = engine.grid.positions, engine.work
    x, z = p[0, u], p[1, v]
    dx, dz = _wished(work, 0, u) - x, _wished(work, 1, v) - z
    if direction == 0:
        dz = 0
    elif direction == 1:
        dx = 0
    far = max(abs(dx), abs(dz))
    if far == 0 or (direction == BOTH and (dx == 0 or dz == 0)):
        return False
    good, bad = 0, far + 1
    while bad > 1:
        at = far if bad > far else (bad - 1) // STEP_MM * STEP_MM
        if at == 0:
            break
        if _may(engine, u, v, x + dx * at // far, z + dz * at // far):
            good = at
            break
        bad = at
    while bad - good > 1:
        middle = (good + bad) // 2
        if _may(engine, u, v, x + dx * middle // far, z + dz * middle // far):
            good = middle
        else:
            bad = middle
    p[0, u], p[1, v] = x + dx * good // far, z + dz * good // far
    return good > 0


@compiled(lambda t: t.b1(t.Engine))
def pull_back(engine: Engine) -> bool:
    """Brings the bodies of the assembled problem back towards their wishes; what stands free of another stays so.

    Args:
        engine: the work space, with integer positions, mm, in `grid.positions`; the result is left where a search leaves it.

    Returns:
        Whether all rules and the walk held at those positions; if not, nothing is changed.
    """
    work, nodes, p = engine.work, engine.nodes, engine.grid.positions
    p[0, -1] = p[1, -1] = 0
    if not holds(work, p) or not walkable(engine.room, work, engine.grid, p):
        return False
    for _ in range(MOST_ROUNDS):
        moved = False
        for k in range(work.counts[N_PARTS]):
            u, v = work.parts[k, VAR_X], work.parts[k, VAR_X + 1]
            if work.parts[k, STAND] == 1 or work.anchor_weight[0, u] == 0 or work.anchor_weight[1, v] == 0:
                continue
            for turn in range(3):
                if _pull(engine, u, v, BOTH - turn):
                    moved = True
        if not moved:
            break
    for axis in range(2):
        for v in range(work.sizes[axis]):
            nodes.best[axis, v] = p[axis, v] / 1000
    nodes.best_cost[0] = movement(work, p)
    nodes.result[FOUND], nodes.result[EXHAUSTED], nodes.result[PICKS] = 1, 0, 0
    return True
