"""The quadratic programmes of a problem's two axes: fixed variables taken out, H inverted once, rows over free variables.

minimise the sum of anchors w (p - at)^2 and pulls w (p_j - p_i - offset)^2 along each axis. H is block diagonal (pulls join
few variables), so that the inversion skips most of it.
"""

from __future__ import annotations

from solver.placement.kernel.dual import FEASIBLE, continue_dual
from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import AXIS, N_PULLS, N_ROWS, ORIGIN, PULL_OFFSET, PULL_WEIGHT, Floats, I, J, Nodes, Programs, S, Work


@compiled(lambda t: t.b1(t.Work, t.Programs, t.i8, t.i8, t.i8, t.i8, t.i8))
def append_row(work: Work, programs: Programs, axis: int, at: int, i: int, j: int, s: int) -> bool:  # noqa: PLR0913
    """Writes row number `at` of an axis, p_j - p_i >= s (mm) over all variables; False where it can never hold."""
    rest = s / 1000
    column_i, column_j = -1, -1
    if j != ORIGIN and i != j:
        column_j = programs.column[axis, j]
        if column_j < 0:
            rest -= programs.value[axis, j]
    if i != ORIGIN and i != j:
        column_i = programs.column[axis, i]
        if column_i < 0:
            rest += programs.value[axis, i]
    programs.rows[axis, 0, at] = column_i
    programs.rows[axis, 1, at] = column_j
    programs.row_s[axis, at] = rest
    return column_i >= 0 or column_j >= 0 or rest <= FEASIBLE


@compiled(lambda t: t.none(t.Work, t.Programs, t.i8))
def _split(work: Work, programs: Programs, axis: int) -> None:
    """Numbers the free variables of an axis and fixes the others."""
    n = 0
    for v in range(work.sizes[axis]):
        low, high = work.low[axis, v], work.high[axis, v]
        programs.value[axis, v] = low / 1000
        if low < high:
            programs.column[axis, v] = n
            programs.bounds[axis, 0, n] = low / 1000
            programs.bounds[axis, 1, n] = high / 1000
            n += 1
        else:
            programs.column[axis, v] = -1
    programs.size[axis] = n


@compiled(lambda t: t.none(t.Work, t.Programs, t.i8))
def _objective(work: Work, programs: Programs, axis: int) -> None:
    """Writes H into `inverse` and f into `start`."""
    n = programs.size[axis]
    H, f, column, value = programs.inverse, programs.start, programs.column, programs.value
    for a in range(n):
        f[axis, a] = 0.0
        for b in range(n):
            H[axis, a, b] = 0.0
    for v in range(work.sizes[axis]):
        a = column[axis, v]
        if a >= 0:
            H[axis, a, a] += 2 * work.anchor_weight[axis, v]
            f[axis, a] -= 2 * work.anchor_weight[axis, v] * work.anchor_at[axis, v]
    for k in range(work.counts[N_PULLS]):
        if work.pulls[k, AXIS] == axis:
            i, j = work.pulls[k, I], work.pulls[k, J]
            w, offset = 2 * work.pull_costs[k, PULL_WEIGHT], work.pull_costs[k, PULL_OFFSET]
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
    A, f = programs.inverse, programs.start
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
        programs.vectors[axis, 0, a] = f[axis, a]
    for a in range(n):
        value = 0.0
        for b in range(n):
            if A[axis, a, b] != 0.0:
                value -= A[axis, a, b] * programs.vectors[axis, 0, b]
        f[axis, a] = value


@compiled(lambda t: t.f8(t.Work, t.Programs, t.i8, t.float_rows))
def cost_at(work: Work, programs: Programs, axis: int, positions: Floats) -> float:
    """Returns the terms' value along an axis at positions (2, variables), m."""
    total = 0.0
    for v in range(work.sizes[axis]):
        weight = work.anchor_weight[axis, v]
        if weight > 0.0:
            off = positions[axis, v] - work.anchor_at[axis, v]
            total += weight * off * off
    for k in range(work.counts[N_PULLS]):
        if work.pulls[k, AXIS] == axis:
            off = positions[axis, work.pulls[k, J]] - positions[axis, work.pulls[k, I]] - work.pull_costs[k, PULL_OFFSET]
            total += work.pull_costs[k, PULL_WEIGHT] * off * off
    return total


@compiled(lambda t: t.none(t.Programs, t.i8, t.i8, t.floats, t.float_rows))
def spread(programs: Programs, axis: int, count: int, x: Floats, positions: Floats) -> None:
    """Writes the positions of all `count` variables of an axis from those of the free ones."""
    for v in range(count):
        column = programs.column[axis, v]
        positions[axis, v] = programs.value[axis, v] if column < 0 else x[column]


@compiled(lambda t: t.b1(t.Work, t.Programs, t.Nodes))
def prepare(work: Work, programs: Programs, nodes: Nodes) -> bool:
    """Builds both programmes; False where bounds or fixed rows can never hold."""
    for axis in range(2):
        for v in range(work.sizes[axis]):
            if work.low[axis, v] > work.high[axis, v]:
                return False
        _split(work, programs, axis)
        _objective(work, programs, axis)
        _invert(programs, axis)
        spread(programs, axis, work.sizes[axis], programs.start[axis], nodes.positions)
        programs.start_cost[axis] = cost_at(work, programs, axis, nodes.positions)
        programs.fixed_rows[axis] = 0
    for k in range(work.counts[N_ROWS]):
        axis = work.rows[k, AXIS]
        at = programs.fixed_rows[axis]
        if not append_row(work, programs, axis, at, work.rows[k, I], work.rows[k, J], work.rows[k, S]):
            return False
        programs.fixed_rows[axis] += 1
    return True


@compiled(lambda t: t.i8(t.Programs, t.Nodes, t.i8, t.i8, t.i8, t.i8, t.f8))
def solve_axis(programs: Programs, nodes: Nodes, slot: int, axis: int, m: int, first: int, ceiling: float) -> int:  # noqa: PLR0913
    """Continues a node's programme along an axis with m rows, beginning with constraint `first` or -1."""
    task = nodes.task
    task[0], task[1], task[2], task[3] = programs.size[axis], m, nodes.active_size[slot, axis], first
    costs = nodes.task_cost
    costs[0], costs[1] = nodes.cost[slot, axis], ceiling
    status, q, cost = continue_dual(
        task,
        programs.inverse[axis],
        programs.bounds[axis],
        programs.rows[axis],
        programs.row_s[axis],
        nodes.x[slot, axis],
        nodes.active[slot, axis],
        nodes.multiplier[slot, axis],
        costs,
        programs.columns,
        programs.factor,
        programs.vectors[axis],
    )
    nodes.active_size[slot, axis] = q
    nodes.cost[slot, axis] = cost
    return status

