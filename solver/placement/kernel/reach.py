"""How far the rows let each variable go, and with that which options of a choice are still possible: no QP is spent on others.

Bound propagation over difference rows, as in disjunctive scheduling (Carlier & Pinson, Management Science 35, 1989).
"""

from __future__ import annotations

from typing import Final

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import ORIGIN, Floats, Ints

ROUNDING: Final = 1e-7
"""An option is given up only if it misses by more than this, m."""
PASSES: Final = 6
"""Sweeps over the rows; more would only sharpen the bounds."""


@compiled(lambda t: t.none(t.i8, t.i8, t.i8, t.float_cubes, t.int_cubes, t.float_rows, t.float_cubes))
def propagate(axis: int, n: int, m: int, bounds: Floats, rows: Ints, s: Floats, reach: Floats) -> None:
    """Writes the least and greatest positions of an axis's n free variables that its m rows leave."""
    for v in range(n):
        reach[axis, 0, v], reach[axis, 1, v] = bounds[axis, 0, v], bounds[axis, 1, v]
    for _ in range(PASSES):
        changed = False
        for r in range(m):
            i, j = rows[axis, 0, r], rows[axis, 1, r]
            least = (reach[axis, 0, i] if i >= 0 else 0.0) + s[axis, r]
            most = (reach[axis, 1, j] if j >= 0 else 0.0) - s[axis, r]
            if j >= 0 and reach[axis, 0, j] < least - ROUNDING:
                reach[axis, 0, j] = least
                changed = True
            if i >= 0 and reach[axis, 1, i] > most + ROUNDING:
                reach[axis, 1, i] = most
                changed = True
        if not changed:
            return


@compiled(lambda t: t.b1(t.int_rows, t.float_rows, t.float_cubes, t.i8, t.i8, t.i8, t.i8))
def possible(column: Ints, value: Floats, reach: Floats, axis: int, i: int, j: int, s: int) -> bool:
    """Tells whether p_j - p_i >= s (mm, over all variables) is within reach."""
    if i == j:
        return s <= 0
    room = -s / 1000
    if j != ORIGIN:
        room += value[axis, j] if column[axis, j] < 0 else reach[axis, 1, column[axis, j]]
    if i != ORIGIN:
        room -= value[axis, i] if column[axis, i] < 0 else reach[axis, 0, column[axis, i]]
    return room >= -ROUNDING
