"""The final continuous solve of a whole house by OSQP, as one block-diagonal problem with the choices made.

OSQP: Stellato et al., Mathematical Programming Computation 2020. Blocks are the axes of the rooms.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import osqp
from scipy import sparse

from solver.placement.axis import AxisProgram
from solver.placement.constraints import Row
from solver.placement.problem import Problem
from solver.placement.terms import Floats

SETTINGS = {
    "verbose": False,
    "eps_abs": 1e-9,
    "eps_rel": 1e-9,
    "max_iter": 20_000,
    "check_termination": 25,
    "adaptive_rho": 1,  # by iterations: time-based rho is not deterministic
    "adaptive_rho_interval": 25,
    "polishing": False,  # prints to stdout whatever `verbose` says; 1e-9 needs none
    "warm_starting": False,
}
"""OSQP 1.x settings."""
NEAR = 0.05
"""Rows with more slack than this at the search's optimum, m, are left out: they cannot bind at the same optimum, and
whatever the solver returns is snapped and checked against all of them."""
_SOLVED = 1


@dataclass(frozen=True)
class Decided:
    """A room's problem with its choices made: `rows` hold one option each; `positions` is the search's solution, m."""

    problem: Problem
    rows: tuple[Row, ...]
    positions: tuple[Floats, Floats]


@dataclass(frozen=True)
class _Block:
    program: AxisProgram
    A: Floats
    lower: Floats


def _blocks(rooms: Sequence[Decided]) -> list[_Block | None]:
    blocks: list[_Block | None] = []
    for room in rooms:
        for axis in (0, 1):
            program = AxisProgram(room.problem, axis)
            stacked = program.stack(_near(room, axis))
            if not program.free or stacked is None:
                blocks.append(None)
            else:
                blocks.append(_Block(program, stacked[0], stacked[1]))
    return blocks


def _near(room: Decided, axis: int) -> list[Row]:
    p: list[float] = (room.positions[axis] * 1000).tolist()
    own = [p, p]
    return [row for row in room.rows if row.axis == axis and row.slack(own) <= NEAR * 1000]


def solve_house(rooms: Sequence[Decided]) -> list[tuple[Floats, Floats]]:
    """Solves all rooms at once.

    Returns:
        Positions per room, axis and variable, m. Where OSQP does not report success, the search's own positions, which
        are optimal already.
    """
    blocks = _blocks(rooms)
    found = [list(room.positions) for room in rooms]
    live = [(index, block) for index, block in enumerate(blocks) if block is not None]
    if live:
        x = _solve([block for _, block in live])
        if x is not None:
            start = 0
            for index, block in live:
                size = len(block.program.free)
                found[index // 2][index % 2] = block.program.spread(x[start : start + size])
                start += size
    return [(axes[0], axes[1]) for axes in found]


def _diagonal(parts: Sequence[Floats]) -> sparse.csc_matrix:
    """Returns the block-diagonal matrix of dense parts, zeros left out; scipy's own takes a millisecond."""
    values, indices, counts, row = [], [], [], 0
    for part in parts:
        columns, rows = np.nonzero(part.T)
        values.append(part[rows, columns])
        indices.append(rows + row)
        counts.append(np.bincount(columns, minlength=part.shape[1]))
        row += part.shape[0]
    starts = np.concatenate([[0], np.cumsum(np.concatenate(counts))])
    return sparse.csc_matrix((np.concatenate(values), np.concatenate(indices), starts), shape=(row, len(starts) - 1))


def _solve(blocks: Sequence[_Block]) -> Floats | None:
    P = _diagonal([np.triu(block.program.H) for block in blocks])
    q = np.concatenate([block.program.f for block in blocks])
    A = _diagonal([np.vstack([np.eye(len(block.program.free)), block.A]) for block in blocks])
    lower = np.concatenate([block.lower for block in blocks])
    upper = np.concatenate([np.concatenate([block.program.high, np.full(len(block.A), np.inf)]) for block in blocks])
    if not (lower <= upper).all():  # OSQP would keep silent
        return None
    solver = osqp.OSQP(algebra="builtin")
    solver.setup(P, q, A, np.where(lower < -1e20, -np.inf, lower), upper, **SETTINGS)
    result = solver.solve(raise_error=False)
    if result.info.status_val != _SOLVED:
        return None
    x: Floats = result.x
    return x
