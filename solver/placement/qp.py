"""The final continuous solve of a whole house by OSQP, as one block-diagonal problem with the choices made.

Comes in: solved rooms, whose problems the core lays out. Goes out: positions, how exactly they are the optimum, and what holds each piece.
OSQP begins at the search's optimum and at the multipliers that belong to it, so that it confirms rather than solves.
OSQP: Stellato et al., Mathematical Programming Computation 2020.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
import osqp
from scipy import sparse

from solver.pieces import Residuals
from solver.placement import kernel
from solver.placement.layout import Engine, Floats, Ints
from solver.placement.problem import Confirmed, Problem, Solution

SETTINGS = {
    "verbose": False,
    "eps_abs": 1e-9,
    "eps_rel": 1e-9,
    "max_iter": 20_000,
    "check_termination": 1,  # from the search's optimum a few iterations do
    "adaptive_rho": 1,  # by iterations: time-based rho is not deterministic
    "adaptive_rho_interval": 25,
    "polishing": False,  # prints to stdout whatever `verbose` says; 1e-9 needs none
}
"""OSQP 1.x settings."""
LEAST_DECADE = -6
"""Residuals below 10 to this power are said to be that: the last digits, which a machine may change, decide no byte."""
REFUTED = 1e-5
"""A proven optimum that is this far, m, from OSQP's is none."""
_SOLVED = 1


class Solved(Protocol):
    """A room with what the search found in it."""

    @property
    def engine(self) -> Engine:
        """Its work space, the problem in it."""

    @property
    def problem(self) -> Problem:
        """The same for reading."""

    @property
    def solution(self) -> Solution:
        """What the search found."""


class OptimumRefuted(Exception):
    """OSQP finds another optimum than the one that was called proven: a fault of ours.

    Args:
        problem: the room's.
        solution: what was called its optimum.
    """

    def __init__(self, problem: Problem, solution: Solution) -> None:
        super().__init__(f"OSQP finds a cheaper placement than the proven one of {problem}: {solution}")
        self.problem, self.solution = problem, solution


class _Matrix(NamedTuple):
    """Where the entries of each column end, their rows, and the entries."""

    ends: Ints
    rows: Ints
    entries: Floats


class _Block:
    """A room: minimise 1/2 x'Px + q'x subject to low <= Ax <= high; of P the upper triangle, as OSQP wants it.

    Args:
        numbers: as `kernel.final_problem` returns them.
    """

    def __init__(self, numbers: Ints) -> None:
        _, self.columns, self.rows, squares, differences = numbers[:5].tolist()
        sizes = [self.columns] * 2 + [self.rows] * 3
        sizes += [self.columns, squares, squares, self.columns, differences, differences]
        parts = np.split(numbers[5:], np.cumsum(sizes)[:-1])
        self.linear, self.start, self.low, self.high, self.multipliers = (part.view(np.float64) for part in parts[:5])
        self.squares = _Matrix(parts[5], parts[6], parts[7].view(np.float64))
        self.differences = _Matrix(parts[8], parts[9], parts[10].view(np.float64))


def confirmed(rooms: Sequence[Solved]) -> list[Confirmed]:
    """Solves all rooms at once.

    Raises:
        OptimumRefuted: OSQP finds another optimum than one that was proven.

    Returns:
        What OSQP says of each room. Where it does not report success, the search's own positions, which are optimal already, with
        no residuals.
    """
    answers = _solved([_Block(kernel.final_problem(room.engine, room.solution)) for room in rooms])
    if answers is None:
        return [Confirmed(room.solution.positions) for room in rooms]
    return [_judged(room, *answer) for room, answer in zip(rooms, answers, strict=True)]


def _judged(room: Solved, x: Floats, y: Floats) -> Confirmed:
    engine, own = room.engine, room.solution.positions
    residuals, holding = kernel.confirm(engine, room.solution, x, y)
    found = engine.call.finals[0, : len(own[0])].copy(), engine.call.finals[1, : len(own[1])].copy()
    if room.solution.proven and max(_moved(p, q) for p, q in zip(found, own, strict=True)) > REFUTED:
        raise OptimumRefuted(room.problem, room.solution)
    return Confirmed(found, Residuals(*map(_decade, residuals.tolist())), holding)


def _solved(blocks: Sequence[_Block]) -> list[tuple[Floats, Floats]] | None:
    """Returns each block's positions and multipliers; None where OSQP does not report success."""
    columns = np.cumsum([0, *(block.columns for block in blocks)])
    rows = np.cumsum([0, *(block.rows for block in blocks)])
    if not columns[-1]:
        return [(block.start, np.zeros(block.rows)) for block in blocks]
    P = _joined([block.squares for block in blocks], columns, columns)
    A = _joined([block.differences for block in blocks], rows, columns)
    names = ("linear", "low", "high", "start", "multipliers")
    linear, low, high, start, multipliers = (np.concatenate([getattr(block, name) for block in blocks]) for name in names)
    solver = osqp.OSQP(algebra="builtin")
    solver.setup(P, linear, A, low, high, **SETTINGS)
    solver.warm_start(start, multipliers)
    result = solver.solve(raise_error=False)
    if result.info.status_val != _SOLVED:
        return None
    return [
        (result.x[columns[k] : columns[k + 1]], result.y[rows[k] : rows[k + 1]]) for k in range(len(blocks))
    ]  # fmt: skip


def _joined(blocks: Sequence[_Matrix], rows: Ints, columns: Ints) -> sparse.csc_matrix:
    """Returns the block-diagonal matrix of blocks that begin at rows and columns, whose ends come last."""
    first = np.cumsum([0, *(len(block.entries) for block in blocks)])
    starts = [0, *np.concatenate([block.ends + before for block, before in zip(blocks, first, strict=False)]).tolist()]
    at = np.concatenate([block.rows + before for block, before in zip(blocks, rows, strict=False)])
    entries = np.concatenate([block.entries for block in blocks])
    return sparse.csc_matrix((entries, at, starts), shape=(rows[-1], columns[-1]))


def _moved(p: Floats, q: Floats) -> float:
    return float(np.abs(p - q).max(initial=0.0))


def _decade(value: float) -> int:
    """Returns the least power of ten that a value does not exceed, so that the last digits of a machine decide nothing."""
    return max(LEAST_DECADE, math.ceil(math.log10(value))) if value > 0 else LEAST_DECADE
