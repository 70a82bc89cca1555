"""The final problem in cvxpy, for a solver that shares nothing with OSQP: `--engine reference`; never on the default path."""

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import cvxpy
import numpy as np

from solver.placement.layout import Floats
from solver.placement.osqp_binary import OsqpAnswer, Programme, SparseColumns

cp: Any = cvxpy  # its annotations do not cover its own names


def _matrix(columns: SparseColumns) -> Floats:
    found = np.zeros(columns.shape)
    for column, (begin, end) in enumerate(zip(columns.indptr, columns.indptr[1:], strict=False)):
        found[columns.indices[begin:end], column] = columns.data[begin:end]
    return found


def solve(programme: Programme, begun_at: tuple[Floats, Floats] | None, settings: Mapping[str, float]) -> OsqpAnswer:
    """Solves a programme as `osqp_binary.solve` does, from nought and with settings of its own."""
    upper, A = _matrix(programme.P), _matrix(programme.A)
    x = cp.Variable(A.shape[1])
    over, under = np.isfinite(programme.low), np.isfinite(programme.high)
    above, below = A[over] @ x >= programme.low[over], A[under] @ x <= programme.high[under]
    whole = cp.psd_wrap(upper + np.triu(upper, 1).T)
    problem = cp.Problem(cp.Minimize(cp.quad_form(x, whole) / 2 + programme.q @ x), [above, below])
    with suppress(cp.SolverError):  # it has no status then
        problem.solve(solver=cp.CLARABEL, **dict.fromkeys(("tol_gap_abs", "tol_gap_rel", "tol_feas"), 1e-12))
    y = np.zeros(len(A))
    if problem.status != cp.OPTIMAL:
        return OsqpAnswer(False, np.zeros(A.shape[1]), y, 0)
    y[over] -= above.dual_value
    y[under] += below.dual_value
    return OsqpAnswer(True, np.asarray(x.value, dtype=np.float64), y, problem.solver_stats.num_iters)
