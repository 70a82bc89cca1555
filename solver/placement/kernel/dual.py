"""The node QP: a dual active-set method on difference rows (Goldfarb & Idnani, Mathematical Programming 27, 1983).

minimise 1/2 x'Hx + f'x subject to low <= x <= high and x_j - x_i >= s. H's inverse is given; the solution, the active set
and the multipliers of the parent node are continued, since one row more leaves them dual feasible. Constraint c < n is the
lower bound of variable c, n <= c < 2n the upper bound of c - n, c >= 2n row c - 2n.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from solver.placement.kernel.jit import compiled
from solver.placement.kernel.layout import Floats, Ints

FEASIBLE: Final = 1e-9
"""A constraint is violated by more than this, m."""
DEPENDENT: Final = 1e-9
"""A constraint whose direction keeps less than this share of its length depends on the active ones."""
NEGLIGIBLE: Final = 1e-9
"""A multiplier's rate of change below this is rounding."""
SOLVED, INFEASIBLE, TOO_DEAR = 0, 1, 2


@compiled(lambda t: t.f8(t.floats, t.int_rows, t.i8, t.i8))
def _along(vector: Floats, rows: Ints, n: int, c: int) -> float:
    """Returns the constraint's normal times a vector."""
    if c < n:
        return vector[c]
    if c < 2 * n:
        return -vector[c - n]
    i, j = rows[0, c - 2 * n], rows[1, c - 2 * n]
    value = 0.0
    if j >= 0:
        value = vector[j]
    if i >= 0:
        value -= vector[i]
    return value


@compiled(lambda t: t.f8(t.floats, t.float_rows, t.int_rows, t.floats, t.i8, t.i8))
def _slack(x: Floats, bounds: Floats, rows: Ints, s: Floats, n: int, c: int) -> float:
    """Returns how far a constraint holds, m."""
    if c < n:
        return x[c] - bounds[0, c]
    if c < 2 * n:
        return bounds[1, c - n] - x[c - n]
    return _along(x, rows, n, c) - s[c - 2 * n]


@compiled(lambda t: t.none(t.float_rows, t.int_rows, t.i8, t.i8, t.floats))
def _column(inverse: Floats, rows: Ints, n: int, c: int, out: Floats) -> None:
    """Writes H's inverse times the constraint's normal."""
    if c < n:
        for k in range(n):
            out[k] = inverse[c, k]
        return
    if c < 2 * n:
        for k in range(n):
            out[k] = -inverse[c - n, k]
        return
    i, j = rows[0, c - 2 * n], rows[1, c - 2 * n]
    for k in range(n):
        value = 0.0
        if j >= 0:
            value = inverse[j, k]
        if i >= 0:
            value -= inverse[i, k]
        out[k] = value


@compiled(lambda t: t.none(t.int_rows, t.i8, t.ints, t.float_rows, t.float_rows, t.i8, t.i8))
def _factorise(rows: Ints, n: int, active: Ints, columns: Floats, factor: Floats, first: int, q: int) -> None:  # noqa: PLR0913
    """Writes rows first ... q - 1 of the Cholesky factor of N'H^-1N."""
    for a in range(first, q):
        for b in range(a + 1):
            value = _along(columns[b], rows, n, active[a])
            for k in range(b):
                value -= factor[a, k] * factor[b, k]
            factor[a, b] = np.sqrt(value) if a == b else value / factor[b, b]


@compiled(lambda t: t.i8(t.i8, t.i8, t.floats, t.float_rows, t.int_rows, t.floats))
def _most_violated(n: int, m: int, x: Floats, bounds: Floats, rows: Ints, s: Floats) -> int:  # noqa: PLR0913
    """Returns the constraint violated most, ties by lowest number, or -1."""
    worst, found = -FEASIBLE, -1
    for k in range(n):
        slack = x[k] - bounds[0, k]
        if slack < worst:
            worst, found = slack, k
    for k in range(n):
        slack = bounds[1, k] - x[k]
        if slack < worst:
            worst, found = slack, n + k
    for r in range(m):
        i, j = rows[0, r], rows[1, r]
        slack = -s[r]
        if j >= 0:
            slack += x[j]
        if i >= 0:
            slack -= x[i]
        if slack < worst:
            worst, found = slack, 2 * n + r
    return found


@compiled(lambda t: t.none(t.int_rows, t.i8, t.i8, t.i8, t.float_rows, t.float_rows, t.float_rows))
def _directions(rows: Ints, n: int, q: int, c: int, columns: Floats, factor: Floats, vectors: Floats) -> None:  # noqa: PLR0913
    """Writes y = L^-1 N'H^-1 n_c to vectors[0] and the multipliers' rates r = L^-T y to vectors[1]."""
    for a in range(q):
        value = _along(columns[a], rows, n, c)
        for k in range(a):
            value -= factor[a, k] * vectors[0, k]
        vectors[0, a] = value / factor[a, a]
    for a in range(q - 1, -1, -1):
        value = vectors[0, a]
        for k in range(a + 1, q):
            value -= factor[k, a] * vectors[1, k]
        vectors[1, a] = value / factor[a, a]


@compiled(lambda t: t.none(t.i8, t.i8, t.i8, t.ints, t.floats, t.float_rows))
def _drop(k: int, q: int, n: int, active: Ints, multiplier: Floats, columns: Floats) -> None:  # noqa: PLR0913
    """Takes active constraint number k out; the factor's rows from k on are then void."""
    for a in range(k, q - 1):
        active[a] = active[a + 1]
        multiplier[a] = multiplier[a + 1]
        for v in range(n):
            columns[a, v] = columns[a + 1, v]


@compiled(
    lambda t: t.tuple((t.i8, t.i8, t.f8))(
        t.ints, t.float_rows, t.float_rows, t.int_rows, t.floats, t.floats, t.ints, t.floats,
        t.floats, t.float_rows, t.float_rows, t.float_rows,
    )
)  # fmt: skip
def continue_dual(  # noqa: PLR0913
    task: Ints,
    inverse: Floats,
    bounds: Floats,
    rows: Ints,
    s: Floats,
    x: Floats,
    active: Ints,
    multiplier: Floats,
    costs: Floats,
    columns: Floats,
    factor: Floats,
    vectors: Floats,
) -> tuple[int, int, float]:
    """Continues from a dual feasible solution until no constraint is violated.

    Args:
        task: number of variables n, of rows m, of active constraints q, the constraint to begin with or -1.
        inverse: H^-1, (>= n, >= n).
        bounds: low and high, (2, >= n).
        rows: i and j of every row, (2, >= m), -1 for the constant 0.
        s: of every row, m.
        x, active, multiplier: the solution to continue; changed in place.
        costs: its cost, and the cost at which to stop.
        columns, factor, vectors: scratch, at least (n + 1, n), (n, n), (2, n).

    Returns:
        (SOLVED | INFEASIBLE | TOO_DEAR, size of the active set, cost).
    """
    n, m, q, c = task[0], task[1], task[2], task[3]
    cost, ceiling = costs[0], costs[1]
    for a in range(q):
        _column(inverse, rows, n, active[a], columns[a])
    _factorise(rows, n, active, columns, factor, 0, q)
    for _ in range(20 * (n + m) + 100):
        if c < 0:
            c = _most_violated(n, m, x, bounds, rows, s)
            if c < 0:
                return SOLVED, q, cost
        _column(inverse, rows, n, c, columns[n])
        own = _along(columns[n], rows, n, c)
        added = 0.0
        slack = _slack(x, bounds, rows, s, n, c)
        while slack < -FEASIBLE:
            _directions(rows, n, q, c, columns, factor, vectors)
            length = own
            for a in range(q):
                length -= vectors[0, a] * vectors[0, a]
            step, dropped = np.inf, -1
            for a in range(q):
                if vectors[1, a] > NEGLIGIBLE and multiplier[a] < step * vectors[1, a]:
                    step, dropped = multiplier[a] / vectors[1, a], a
            full = -slack / length if length > DEPENDENT * own else np.inf
            if dropped < 0 and full == np.inf:
                return INFEASIBLE, q, cost
            taken = min(step, full)
            if full < np.inf:
                for v in range(n):
                    change = columns[n, v]
                    for a in range(q):
                        change -= vectors[1, a] * columns[a, v]
                    x[v] += taken * change
                cost += taken * length * (0.5 * taken + added)
            for a in range(q):
                multiplier[a] -= taken * vectors[1, a]
            added += taken
            if full <= step:
                for a in range(q):
                    factor[q, a] = vectors[0, a]
                factor[q, q] = np.sqrt(length)
                for v in range(n):
                    columns[q, v] = columns[n, v]
                active[q], multiplier[q] = c, added
                q += 1
                break
            _drop(dropped, q, n, active, multiplier, columns)
            q -= 1
            _factorise(rows, n, active, columns, factor, dropped, q)
            slack = _slack(x, bounds, rows, s, n, c)
        if cost >= ceiling:
            return TOO_DEAR, q, cost
        c = -1
    return INFEASIBLE, q, cost
