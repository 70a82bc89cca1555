"""The cheapest positions of a problem: a big-M mixed-integer quadratic programme in SCIP, polished with its choices fixed.

Comes in: a `Problem`, read as data, and limits of time and work. Goes out: the cost, and whether SCIP closed the gap. The terms are
read by their fields, written from problem.py's docstrings: weight (p_j - p_i - offset)^2, metres; p_-1 is 0.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyscipopt
from pyscipopt import quicksum

from solver.placement.problem import DifferenceRow
from tests.oracles.problem import Problem

SECONDS = 15.0
"""Time limit of one room of the bench."""
NO_LIMIT = -1


@dataclass(frozen=True)
class Optimum:
    """What SCIP says of a problem.

    `closed`: the optimum is proven, or that there is none. `cost` is infinite where nothing was found. `cpu` counts SCIP
    alone, without the building of its model, in seconds.
    """

    cost: float
    closed: bool
    cpu: float


def scip_version() -> str:
    """Returns the version of SCIP itself."""
    model = pyscipopt.Model()
    return f"{model.getMajorVersion()}.{model.getMinorVersion()}.{model.getTechVersion()}"


def optimum(problem: Problem, seconds: float = SECONDS, nodes: int = NO_LIMIT) -> Optimum:
    """Returns the least cost of a problem, as far as SCIP gets within so many seconds by the clock and nodes of its tree."""
    if any(a > b for k in (0, 1) for a, b in zip(problem.low[k], problem.high[k], strict=True)):
        return Optimum(float("inf"), True, 0.0)
    if any(not choice.options for choice in problem.choices):
        return Optimum(float("inf"), True, 0.0)
    model, binaries = _model(problem, seconds)
    model.setParam("limits/nodes", nodes)
    start = time.process_time()
    model.optimize()
    cpu = time.process_time() - start
    closed = model.getStatus() in ("optimal", "gaplimit", "infeasible")
    if model.getNSols() == 0:
        return Optimum(float("inf"), closed, cpu)
    solution = model.getBestSol()
    taken = [row for binary, row in binaries if model.getSolVal(solution, binary) > 0.5]
    return Optimum(cost_with(problem, [*problem.rows, *taken]), closed, cpu)


def _model(problem: Problem, seconds: float) -> tuple[Any, list[tuple[Any, DifferenceRow]]]:
    model = pyscipopt.Model()
    model.hideOutput()
    for name, value in {"limits/time": seconds, "limits/gap": 1e-7, "numerics/feastol": 1e-8, "parallel/maxnthreads": 1}.items():
        model.setParam(name, value)
    p = [[model.addVar(lb=a / 1000, ub=b / 1000) for a, b in zip(problem.low[axis], problem.high[axis], strict=True)] for axis in (0, 1)]
    worst = model.addVar(lb=0)
    model.addCons(quicksum(_squares(problem, p)) <= worst)
    model.setObjective(worst)
    binaries = []
    for row in problem.rows:
        model.addCons(_difference(p, row) >= row.s / 1000)
    for choice in problem.choices:
        own = []
        for row in choice.options:
            binary = model.addVar(vtype="B")
            big = row.s / 1000 - _least(problem, row)
            model.addCons(_difference(p, row) >= row.s / 1000 - max(big, 0.0) * (1 - binary))
            own.append((binary, row))
        model.addCons(quicksum(binary for binary, _ in own) >= 1)
        binaries += own
    return model, binaries


def _squares(problem: Problem, p: Sequence[Sequence[Any]]) -> list[Any]:
    squares = []
    for term in problem.terms:
        own = p[term.axis]
        distance = own[term.j] - (own[term.i] if term.i >= 0 else 0.0) - term.offset
        squares.append(term.weight * distance * distance)
    return squares


def _difference(p: Sequence[Sequence[Any]], row: tuple[int, int, int, int]) -> Any:
    axis, i, j, _ = row
    if i == j:
        return p[0][0] * 0 if p[0] else p[1][0] * 0
    return (p[axis][j] if j >= 0 else 0) - (p[axis][i] if i >= 0 else 0)


def _least(problem: Problem, row: tuple[int, int, int, int]) -> float:
    """Returns the least that p_j - p_i can be within the bounds, m."""
    axis, i, j, _ = row
    if i == j:
        return 0.0
    return ((problem.low[axis][j] if j >= 0 else 0) - (problem.high[axis][i] if i >= 0 else 0)) / 1000


def cost_with(problem: Problem, rows: Sequence[tuple[int, int, int, int]]) -> float:
    """Returns the least cost with these rows held and no choice left, by an interior-point solver to 1e-10."""
    import cvxpy as cp

    total = 0.0
    for axis in (0, 1):
        n = len(problem.low[axis])
        if n == 0:
            continue
        p = cp.Variable(n)
        low, high = (np.array(values, dtype=float) / 1000 for values in (problem.low[axis], problem.high[axis]))
        A, s = _matrix([row for row in rows if row[0] == axis], n)
        root, wish = _residuals(problem, axis, n)
        programme = cp.Problem(cp.Minimize(cp.sum_squares(root @ p - wish)), [p >= low, p <= high, *([A @ p >= s] if len(s) else [])])
        programme.solve(solver=cp.CLARABEL, tol_gap_abs=1e-10, tol_gap_rel=1e-10, tol_feas=1e-10)
        if programme.status not in ("optimal", "optimal_inaccurate"):
            return float("inf")
        total += float(programme.value)
    return total


def _matrix(rows: Sequence[tuple[int, int, int, int]], n: int) -> tuple[np.ndarray, np.ndarray]:
    A = np.zeros((len(rows), n))
    for k, (_, i, j, _) in enumerate(rows):
        for variable, sign in ((j, 1.0), (i, -1.0)):
            if variable >= 0:
                A[k, variable] += sign
    return A, np.array([row[3] for row in rows], dtype=float) / 1000


def _residuals(problem: Problem, axis: int, n: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns R and r such that the axis's terms are |R p - r|^2."""
    own = [term for term in problem.terms if term.axis == axis]
    R, r = np.zeros((len(own), n)), np.zeros(len(own))
    for k, term in enumerate(own):
        root = term.weight**0.5
        R[k, term.j] += root
        if term.i >= 0:
            R[k, term.i] -= root
        r[k] = root * term.offset
    return R, r
