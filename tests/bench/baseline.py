"""OSQP with heuristics: what is done where nobody searches. Least penetration, one QP, re-pick, up to six rounds.

Every choice takes the option that is violated least where the pieces wish to stand; one QP of both axes with these rows;
then the options are picked again at its solution and it is solved again, until every choice holds or the rounds are spent.
The matrices are assembled as cheaply as NumPy allows and OSQP is set up once a round (its rows change).
"""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
import osqp
from numpy.typing import NDArray
from scipy import sparse

from tests.oracles.problem import Problem

ROUNDS = 6
HELD = 1e-4
"""A choice violated by less counts as held, m: what these tolerances give."""
SETTINGS = {
    "verbose": False, "eps_abs": 1e-6, "eps_rel": 1e-6, "max_iter": 4000, "check_termination": 25,
    "adaptive_rho": 1, "adaptive_rho_interval": 25, "polishing": False,
}  # fmt: skip
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Guess:
    """What the heuristics came to: `found` tells whether every choice holds. CPU times in seconds; `osqp_cpu` without assembly."""

    found: bool
    cost: float
    cpu: float
    osqp_cpu: float
    rounds: int


class _Arrays:
    """A problem as arrays: P, q, constant, bounds, fixed rows, and all options by choice; a last column stands for 0."""

    def __init__(self, problem: Problem) -> None:
        self.shift = (0, len(problem.low[0]))
        self.n = self.shift[1] + len(problem.low[1])
        self.low, self.high = (np.array([*bounds[0], *bounds[1]]) / 1000 for bounds in (problem.low, problem.high))
        self._objective(problem)
        self.rows = self._table(list(problem.rows))
        width = max((len(choice.options) for choice in problem.choices), default=0)
        filled = [[*choice.options, *[choice.options[0]] * (width - len(choice.options))] for choice in problem.choices]
        self.choices = [self._table([options[k] for options in filled]) for k in range(width)]

    def _objective(self, problem: Problem) -> None:
        P, self.q, self.constant = np.zeros((self.n, self.n)), np.zeros(self.n), 0.0
        for term in problem.terms:
            shift, w = self.shift[term.axis], 2 * term.weight
            wish = term.offset
            signs = [(shift + term.j, 1.0), *([(shift + term.i, -1.0)] if term.i >= 0 else [])]
            for a, sign_a in signs:
                self.q[a] -= w * wish * sign_a
                for b, sign_b in signs:
                    P[a, b] += w * sign_a * sign_b
            self.constant += term.weight * wish**2
        self.P, self.upper_P = P, sparse.csc_matrix(np.triu(P))

    def _table(self, rows: list[tuple[int, int, int, int]]) -> tuple[NDArray[np.int64], NDArray[np.int64], Floats]:
        at = [(self.n if v < 0 else self.shift[axis] + v) for axis, i, j, _ in rows for v in (i, j)]
        pairs = np.array(at, dtype=np.int64).reshape(-1, 2)
        return pairs[:, 0], pairs[:, 1], np.array([row[3] for row in rows]) / 1000

    def slacks(self, p: Floats) -> Floats:
        """Returns the slack of every option, m, shape (options, choices)."""
        whole = np.append(p, 0.0)
        return np.array([whole[j] - whole[i] - s for i, j, s in self.choices])

    def cost(self, p: Floats) -> float:
        """Returns the sum of the terms at positions p, m."""
        return float(self.constant + self.q @ p + 0.5 * p @ self.P @ p)

    def matrix(self, picked: NDArray[np.int64]) -> tuple[sparse.csc_matrix, Floats, Floats]:
        """Returns A, l, u: bounds, fixed rows and the picked option of every choice."""
        i, j, s = self.rows
        if self.choices:
            tables = np.array([np.stack(table) for table in self.choices])
            chosen = tables[picked, :, np.arange(len(picked))].T
            i, j, s = (np.concatenate([a, b]) for a, b in zip(self.rows, chosen, strict=True))
        k = np.arange(len(s))
        full = sparse.coo_matrix(
            (np.concatenate([np.ones(len(s)), -np.ones(len(s))]), (np.tile(k, 2), np.concatenate([j, i]).astype(int))),
            shape=(len(s), self.n + 1),
        )  # fmt: skip
        A = sparse.vstack([sparse.identity(self.n), full.tocsc()[:, : self.n]], format="csc")
        return A, np.concatenate([self.low, s]), np.concatenate([self.high, np.full(len(s), np.inf)])


def guess(problem: Problem, rounds: int = ROUNDS) -> Guess:
    """Places a room by least penetration and OSQP, re-picking up to `rounds` times."""
    if any(not choice.options for choice in problem.choices):
        return Guess(False, float("inf"), 0.0, 0.0, 0)
    start, inside = time.process_time(), 0.0
    arrays = _Arrays(problem)
    p = np.clip(np.linalg.solve(arrays.P + 1e-9 * np.eye(arrays.n), -arrays.q), arrays.low, arrays.high)
    for k in range(1, rounds + 1):
        picked = arrays.slacks(p).argmax(axis=0) if arrays.choices else np.zeros(0, dtype=np.int64)
        A, low, high = arrays.matrix(picked)
        before = time.process_time()
        solved = _solved(arrays, A, low, high)
        inside += time.process_time() - before
        if solved is None:
            break
        p = solved
        if not arrays.choices or (arrays.slacks(p).max(axis=0) >= -HELD).all():
            return Guess(True, arrays.cost(p), time.process_time() - start, inside, k)
    return Guess(False, float("inf"), time.process_time() - start, inside, k)


def _solved(arrays: _Arrays, A: sparse.csc_matrix, low: Floats, high: Floats) -> Floats | None:
    if not (low <= high).all():
        return None
    solver = osqp.OSQP()
    solver.setup(arrays.upper_P, arrays.q, A, low, high, **SETTINGS)
    result = solver.solve(raise_error=False)
    solution: Floats | None = result.x if result.info.status_val == 1 else None
    return solution
