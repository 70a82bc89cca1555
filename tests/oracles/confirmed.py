"""What OSQP says of what a search found, at more length than the solver asks for."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from solver.pieces import Residuals
from solver.placement.layout import Engine
from solver.placement.problem import Force
from solver.placement.qp import forces_in, solved_house
from tests.oracles.problem import Positions, Problem


class Confirmed(NamedTuple):
    """A room's final positions, m, by axis and variable; how exactly they are the optimum, and what holds there."""

    positions: Positions
    residuals: Residuals
    forces: tuple[Force, ...]


def confirmed(engine: Engine, problem: Problem) -> Confirmed:
    """Solves the problem in a work space, with the choices that the last search made.

    Raises:
        OptimumRefuted: OSQP finds another optimum than one that was proven.
    """
    core = engine.instance
    answer = solved_house(core, [int(core.call("final_problem", engine.desk))])
    assert answer is not None
    x = iter(answer.x.tolist())
    bounds = [zip(problem.low[axis], problem.high[axis], strict=True) for axis in (0, 1)]
    along_x, along_z = (np.array([next(x) if low < high else low / 1000 for low, high in own]) for own in bounds)
    return Confirmed((along_x, along_z), answer.rooms[0].residuals, forces_in(engine))
