"""The node QP: a dual active-set method on difference rows (Goldfarb & Idnani, Mathematical Programming 27, 1983).

minimise 1/2 x'Hx + f'x subject to low <= x <= high and x_j - x_i >= s, along one axis. H's inverse is given; the solution, the
active set and the multipliers of the parent node are continued, since one row more leaves them dual feasible. Constraint c < n
is the lower bound of variable c, n <= c < 2n the upper bound of c - n, c >= 2n row c - 2n.

The parent's columns H^-1 N and the Cholesky factor of N'H^-1 N are built once for all its children: a child appends to them,
and only one that drops a constraint spoils them. Arrays come whole, with the axis (and the node's slot) as first indices:
taking slices would cost more than the arithmetic.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import Floats, Ints, Nodes, Programs

FEASIBLE: Final = 1e-9
"""A constraint is violated by more than this, m."""
DEPENDENT: Final = 1e-9
"""A constraint whose direction keeps less than this share of its length depends on the active ones."""
NEGLIGIBLE: Final = 1e-9
"""A multiplier's rate of change below this is rounding."""
SOLVED, INFEASIBLE, TOO_DEAR = 0, 1, 2


@compiled(lambda t: t.f8(t.float_cubes, t.i8, t.i8, t.int_cubes, t.i8, t.i8))
def _along(columns: Floats, axis: int, k: int, rows: Ints, n: int, c: int) -> float:
    """Returns the normal of constraint c times column k."""
    if c < n:
        return columns[axis, k, c]
    if c < 2 * n:
        return -columns[axis, k, c - n]
    i, j = rows[axis, 0, c - 2 * n], rows[axis, 1, c - 2 * n]
    value = 0.0
    if j >= 0:
        value = columns[axis, k, j]
    if i >= 0:
        value -= columns[axis, k, i]
    return value


@compiled(lambda t: t.f8(t.float_cubes, t.i8, t.i8, t.float_cubes, t.int_cubes, t.float_rows, t.i8, t.i8))
def _slack(x: Floats, slot: int, axis: int, bounds: Floats, rows: Ints, s: Floats, n: int, c: int) -> float:
    """Returns how far a constraint holds, m."""
    if c < n:
        return x[slot, axis, c] - bounds[axis, 0, c]
    if c < 2 * n:
        return bounds[axis, 1, c - n] - x[slot, axis, c - n]
    i, j = rows[axis, 0, c - 2 * n], rows[axis, 1, c - 2 * n]
    value = -s[axis, c - 2 * n]
    if j >= 0:
        value += x[slot, axis, j]
    if i >= 0:
        value -= x[slot, axis, i]
    return value


@compiled(lambda t: t.none(t.float_cubes, t.i8, t.int_cubes, t.i8, t.i8, t.float_cubes, t.i8))
def _column(inverse: Floats, axis: int, rows: Ints, n: int, c: int, columns: Floats, at: int) -> None:
    """Writes H's inverse times the normal of constraint c to column `at`."""
    if c < n:
        for k in range(n):
            columns[axis, at, k] = inverse[axis, c, k]
        return
    if c < 2 * n:
        for k in range(n):
            columns[axis, at, k] = -inverse[axis, c - n, k]
        return
    i, j = rows[axis, 0, c - 2 * n], rows[axis, 1, c - 2 * n]
    for k in range(n):
        value = 0.0
        if j >= 0:
            value = inverse[axis, j, k]
        if i >= 0:
            value -= inverse[axis, i, k]
        columns[axis, at, k] = value


@compiled(lambda t: t.none(t.int_cubes, t.i8, t.i8, t.int_cubes, t.i8, t.float_cubes, t.float_cubes, t.i8, t.i8))
def _factorise(rows: Ints, n: int, axis: int, active: Ints, slot: int, columns: Floats, factor: Floats, first: int, q: int) -> None:
    """Writes rows first ... q - 1 of the Cholesky factor of N'H^-1 N."""
    for a in range(first, q):
        for b in range(a + 1):
            value = _along(columns, axis, b, rows, n, active[slot, axis, a])
            for k in range(b):
                value -= factor[axis, a, k] * factor[axis, b, k]
            factor[axis, a, b] = np.sqrt(value) if a == b else value / factor[axis, b, b]


@compiled(
    lambda t: t.none(t.i8, t.i8, t.i8, t.i8, t.float_cubes, t.int_cubes, t.int_cubes, t.float_cubes, t.float_cubes)
)  # fmt: skip
def build_base(axis: int, slot: int, n: int, q: int, inverse: Floats, rows: Ints, active: Ints, columns: Floats, factor: Floats) -> None:
    """Writes the columns and the factor of a node's active set."""
    for a in range(q):
        _column(inverse, axis, rows, n, active[slot, axis, a], columns, a)
    _factorise(rows, n, axis, active, slot, columns, factor, 0, q)


@compiled(lambda t: t.i8(t.i8, t.i8, t.float_cubes, t.i8, t.i8, t.float_cubes, t.int_cubes, t.float_rows))
def _most_violated(n: int, m: int, x: Floats, slot: int, axis: int, bounds: Floats, rows: Ints, s: Floats) -> int:
    """Returns the constraint violated most, ties by lowest number, or -1."""
    worst, found = -FEASIBLE, -1
    for k in range(n):
        value = x[slot, axis, k]
        if value - bounds[axis, 0, k] < worst:
            worst, found = value - bounds[axis, 0, k], k
        if bounds[axis, 1, k] - value < worst:
            worst, found = bounds[axis, 1, k] - value, n + k
    for r in range(m):
        i, j = rows[axis, 0, r], rows[axis, 1, r]
        slack = -s[axis, r]
        if j >= 0:
            slack += x[slot, axis, j]
        if i >= 0:
            slack -= x[slot, axis, i]
        if slack < worst:
            worst, found = slack, 2 * n + r
    return found


@compiled(lambda t: t.f8(t.i8, t.int_cubes, t.i8, t.i8, t.i8, t.float_cubes, t.float_cubes, t.float_cubes))
def _directions(axis: int, rows: Ints, n: int, q: int, c: int, columns: Floats, factor: Floats, vectors: Floats) -> float:
    """Writes y = L^-1 N'H^-1 n_c to vectors[0] and the multipliers' rates r = L^-T y to vectors[1]; returns y'y."""
    square = 0.0
    for a in range(q):
        value = _along(columns, axis, a, rows, n, c)
        for k in range(a):
            value -= factor[axis, a, k] * vectors[axis, 0, k]
        value /= factor[axis, a, a]
        vectors[axis, 0, a] = value
        square += value * value
    for a in range(q - 1, -1, -1):
        value = vectors[axis, 0, a]
        for k in range(a + 1, q):
            value -= factor[axis, k, a] * vectors[axis, 1, k]
        vectors[axis, 1, a] = value / factor[axis, a, a]
    return square


@compiled(lambda t: t.none(t.i8, t.i8, t.i8, t.i8, t.i8, t.int_cubes, t.float_cubes, t.float_cubes))
def _drop(k: int, q: int, n: int, slot: int, axis: int, active: Ints, multiplier: Floats, columns: Floats) -> None:
    """Takes active constraint number k out; the factor's rows from k on are then void."""
    for a in range(k, q - 1):
        active[slot, axis, a] = active[slot, axis, a + 1]
        multiplier[slot, axis, a] = multiplier[slot, axis, a + 1]
        for v in range(n):
            columns[axis, a, v] = columns[axis, a + 1, v]


@compiled(
    lambda t: t.none(t.i8, t.i8, t.i8, t.i8, t.f8, t.b1, t.float_cubes, t.float_cubes, t.float_cubes, t.float_cubes)
)  # fmt: skip
def _move(
    slot: int, axis: int, n: int, q: int, step: float, primal: bool, x: Floats, multiplier: Floats, columns: Floats, vectors: Floats
) -> None:
    """Takes a step: the multipliers always, the solution where the new constraint does not depend on the active ones."""
    if primal:
        for v in range(n):
            change = columns[axis, n, v]
            for a in range(q):
                change -= vectors[axis, 1, a] * columns[axis, a, v]
            x[slot, axis, v] += step * change
    for a in range(q):
        multiplier[slot, axis, a] -= step * vectors[axis, 1, a]


@compiled(lambda t: t.none(t.i8, t.i8, t.i8, t.i8, t.i8, t.f8, t.int_cubes, t.float_cubes, t.float_cubes))
def _append(slot: int, axis: int, n: int, q: int, c: int, length: float, active: Ints, columns: Floats, factor: Floats) -> None:
    """Makes the candidate in column n active constraint number q; its row of the factor is written but for the diagonal."""
    factor[axis, q, q] = np.sqrt(length)
    for v in range(n):
        columns[axis, q, v] = columns[axis, n, v]
    active[slot, axis, q] = c


@compiled(lambda t: t.b1(t.Programs, t.Nodes, t.i8), inlined=True)
def _enforce(programs: Programs, nodes: Nodes, c: int) -> bool:
    """Steps until constraint c, whose column is number n, holds; False where it never can."""
    bounds, rows, s, columns = programs.bounds, programs.rows, programs.row_s, programs.columns
    factor, vectors, task, x = programs.factor, programs.vectors, nodes.task, nodes.x
    active, multiplier, active_size, costs = nodes.active, nodes.multiplier, nodes.active_size, nodes.cost
    axis, slot, n, q = task[0], task[1], task[2], active_size[task[1], task[0]]
    own, added = _along(columns, axis, n, rows, n, c), 0.0
    slack = _slack(x, slot, axis, bounds, rows, s, n, c)
    while slack < -FEASIBLE:
        length = own - _directions(axis, rows, n, q, c, columns, factor, vectors)
        step, dropped = np.inf, -1
        for a in range(q):
            rate = vectors[axis, 1, a]
            if rate > NEGLIGIBLE and multiplier[slot, axis, a] < step * rate:
                step, dropped = multiplier[slot, axis, a] / rate, a
        full = -slack / length if length > DEPENDENT * own else np.inf
        if dropped < 0 and full == np.inf:
            return False
        taken = min(step, full)
        _move(slot, axis, n, q, taken, full < np.inf, x, multiplier, columns, vectors)
        if full < np.inf:
            costs[slot, axis] += taken * length * (0.5 * taken + added)
        added += taken
        if full <= step:
            for a in range(q):
                factor[axis, q, a] = vectors[axis, 0, a]
            _append(slot, axis, n, q, c, length, active, columns, factor)
            multiplier[slot, axis, q] = added
            active_size[slot, axis] = q + 1
            return True
        task[5] = 1
        _drop(dropped, q, n, slot, axis, active, multiplier, columns)
        q -= 1
        active_size[slot, axis] = q
        _factorise(rows, n, axis, active, slot, columns, factor, dropped, q)
        slack = _slack(x, slot, axis, bounds, rows, s, n, c)
    return True


@compiled(lambda t: t.i8(t.Programs, t.Nodes, t.f8), inlined=True)
def continue_dual(programs: Programs, nodes: Nodes, ceiling: float) -> int:
    """Continues a node from a dual feasible solution until no constraint is violated.

    Args:
        programs: both axes' programmes; the base must be built.
        nodes: the node's x, active, multiplier, active_size and cost are changed in place. nodes.task says which: axis, slot,
            number of variables n, of rows m, the constraint to begin with or -1; its sixth is set to 1 where a constraint was
            dropped, which spoils the base.
        ceiling: the cost at which to stop.

    Returns:
        SOLVED | INFEASIBLE | TOO_DEAR.
    """
    inverse, bounds, rows, s, columns = programs.inverse, programs.bounds, programs.rows, programs.row_s, programs.columns
    task, x, costs = nodes.task, nodes.x, nodes.cost
    axis, slot, n, m, c = task[0], task[1], task[2], task[3], task[4]
    for _ in range(20 * (n + m) + 100):
        if c < 0:
            c = _most_violated(n, m, x, slot, axis, bounds, rows, s)
            if c < 0:
                return SOLVED
        _column(inverse, axis, rows, n, c, columns, n)
        if not _enforce(programs, nodes, c):
            return INFEASIBLE
        if costs[slot, axis] >= ceiling:
            return TOO_DEAR
        c = -1
    return INFEASIBLE
