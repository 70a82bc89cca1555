"""The quadratic programmes of a problem's two axes: fixed variables taken out, H inverted once, rows over free variables.

minimise the sum of anchors w (p - at)^2 and pulls w (p_j - p_i - offset)^2 along each axis. H is block diagonal (pulls join
few variables), so that the inversion skips most of it.
"""

from __future__ import annotations

from solver.placement.kernel.dual import FEASIBLE, continue_dual
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import (
    AXIS,
    N_PULLS,
    N_ROWS,
    ORIGIN,
    PULL_OFFSET,
    PULL_WEIGHT,
    Floats,
    I,
    Ints,
    J,
    Nodes,
    Programs,
    S,
    Work,
)


@compiled(lambda t: t.b1(t.int_rows, t.float_rows, t.int_cubes, t.float_rows, t.i8, t.i8, t.i8, t.i8, t.i8))
def append_row(column: Ints, value: Floats, rows: Ints, row_s: Floats, axis: int, at: int, i: int, j: int, s: int) -> bool:
    """Writes row number `at` of an axis, p_j - p_i >= s (mm) over all variables; False where it can never hold.

    The arrays are those of `Programs`.
    """
    rest = s / 1000
    column_i, column_j = -1, -1
    if j != ORIGIN and i != j:
        column_j = column[axis, j]
        if column_j < 0:
            rest -= value[axis, j]
    if i != ORIGIN and i != j:
        column_i = column[axis, i]
        if column_i < 0:
            rest += value[axis, i]
    rows[axis, 0, at], rows[axis, 1, at], row_s[axis, at] = column_i, column_j, rest
    return column_i >= 0 or column_j >= 0 or rest <= FEASIBLE


@compiled(lambda t: t.none(t.Work, t.Programs, t.i8))
def _split(work: Work, programs: Programs, axis: int) -> None:
    """Numbers the free variables of an axis and fixes the others."""
    lows, highs, value, column, bounds = work.low, work.high, programs.value, programs.column, programs.bounds
    n = 0
    for v in range(work.sizes[axis]):
        low, high = lows[axis, v], highs[axis, v]
        value[axis, v] = low / 1000
        if low < high:
            column[axis, v] = n
            bounds[axis, 0, n] = low / 1000
            bounds[axis, 1, n] = high / 1000
            n += 1
        else:
            column[axis, v] = -1
    programs.size[axis] = n


@compiled(lambda t: t.none(t.Work, t.Programs, t.i8))
def _objective(work: Work, programs: Programs, axis: int) -> None:
    """Writes H into `inverse` and f into `start`."""
    n = programs.size[axis]
    H, f, column, value = programs.inverse, programs.start, programs.column, programs.value
    weight, at, pulls, pull_costs = work.anchor_weight, work.anchor_at, work.pulls, work.pull_costs
    for a in range(n):
        f[axis, a] = 0.0
        for b in range(n):
            H[axis, a, b] = 0.0
    for v in range(work.sizes[axis]):
        a = column[axis, v]
        if a >= 0:
            H[axis, a, a] += 2 * weight[axis, v]
            f[axis, a] -= 2 * weight[axis, v] * at[axis, v]
    for k in range(work.counts[N_PULLS]):
        if pulls[k, AXIS] == axis:
            i, j = pulls[k, I], pulls[k, J]
            w, offset = 2 * pull_costs[k, PULL_WEIGHT], pull_costs[k, PULL_OFFSET]
            a, b = column[axis, i], column[axis, j]
            if a >= 0:
                H[axis, a, a] += w
                f[axis, a] += w * offset
                if b < 0:
                    f[axis, a] -= w * value[axis, j]
            if b >= 0:
                H[axis, b, b] += w
                f[axis, b] -= w * offset
                if a < 0:
                    f[axis, b] -= w * value[axis, i]
            if a >= 0 and b >= 0:
                H[axis, a, b] -= w
                H[axis, b, a] -= w


@compiled(lambda t: t.none(t.Programs, t.i8))
def _invert(programs: Programs, axis: int) -> None:
    """Inverts H in place (Gauss-Jordan; H is positive definite) and writes the unconstrained optimum to `start`."""
    n = programs.size[axis]
    A, f, vectors = programs.inverse, programs.start, programs.vectors
    for k in range(n):
        pivot = 1 / A[axis, k, k]
        A[axis, k, k] = 1.0
        for b in range(n):
            A[axis, k, b] *= pivot
        for a in range(n):
            factor = A[axis, a, k]
            if a != k and factor != 0.0:
                A[axis, a, k] = 0.0
                for b in range(n):
                    A[axis, a, b] -= factor * A[axis, k, b]
    for a in range(n):
        vectors[axis, 0, a] = f[axis, a]
    for a in range(n):
        value = 0.0
        for b in range(n):
            if A[axis, a, b] != 0.0:
                value -= A[axis, a, b] * vectors[axis, 0, b]
        f[axis, a] = value


@compiled(lambda t: t.f8(t.Work, t.i8, t.float_rows))
def cost_at(work: Work, axis: int, positions: Floats) -> float:
    """Returns the terms' value along an axis at positions (2, variables), m."""
    weight, at, pulls, pull_costs = work.anchor_weight, work.anchor_at, work.pulls, work.pull_costs
    total = 0.0
    for v in range(work.sizes[axis]):
        if weight[axis, v] > 0.0:
            off = positions[axis, v] - at[axis, v]
            total += weight[axis, v] * off * off
    for k in range(work.counts[N_PULLS]):
        if pulls[k, AXIS] == axis:
            off = positions[axis, pulls[k, J]] - positions[axis, pulls[k, I]] - pull_costs[k, PULL_OFFSET]
            total += pull_costs[k, PULL_WEIGHT] * off * off
    return total


@compiled(lambda t: t.none(t.ints, t.floats, t.i8, t.floats, t.floats))
def spread(column: Ints, value: Floats, count: int, x: Floats, positions: Floats) -> None:
    """Writes the positions of all `count` variables of an axis from those of the free ones."""
    for v in range(count):
        positions[v] = value[v] if column[v] < 0 else x[column[v]]


@compiled(lambda t: t.b1(t.Work, t.Programs, t.Nodes))
def prepare(work: Work, programs: Programs, nodes: Nodes) -> bool:
    """Builds both programmes; False where bounds or fixed rows can never hold."""
    low, high, rows, fixed_rows = work.low, work.high, work.rows, programs.fixed_rows
    for axis in range(2):
        for v in range(work.sizes[axis]):
            if low[axis, v] > high[axis, v]:
                return False
        _split(work, programs, axis)
        _objective(work, programs, axis)
        _invert(programs, axis)
        spread(programs.column[axis], programs.value[axis], work.sizes[axis], programs.start[axis], nodes.positions[axis])
        programs.start_cost[axis] = cost_at(work, axis, nodes.positions)
        fixed_rows[axis] = 0
    column, value, own, own_s = programs.column, programs.value, programs.rows, programs.row_s
    for k in range(work.counts[N_ROWS]):
        axis = rows[k, AXIS]
        if not append_row(column, value, own, own_s, axis, fixed_rows[axis], rows[k, I], rows[k, J], rows[k, S]):
            return False
        fixed_rows[axis] += 1
    return True


@compiled(lambda t: t.i8(t.Programs, t.Nodes, t.i8, t.i8, t.i8, t.i8, t.f8), inlined=True)
def solve_axis(programs: Programs, nodes: Nodes, slot: int, axis: int, m: int, first: int, ceiling: float) -> int:
    """Continues a node's programme along an axis with m rows, beginning with constraint `first` or -1."""
    task = nodes.task
    task[0], task[1], task[2], task[3], task[4], task[5] = axis, slot, programs.size[axis], m, first, 0
    return continue_dual(programs, nodes, ceiling)
