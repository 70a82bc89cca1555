"""What is asked of the core about one room, the functions of solver/core/placement/entry.cpp; and its work space in an instance."""

import numpy as np

from solver.core import taken
from solver.placement.layout import Engine, Floats, Ints
from solver.placement.problem import Solution

HOLDING_ROW = 7
"""Numbers of `struct HoldingRow`."""


def new_engine(request: bytes) -> Engine:
    """Returns all work space for a room, and the room in it.

    Raises:
        CoreFull: the core's memory is too small for it.
    """
    instance = taken(roomy=True)
    return Engine(instance, int(instance.call("new_desk", instance.write(request))))


def assemble(engine: Engine, decisions: Ints) -> bool:
    """Writes the problem of the decisions to `work`; False where the bounds alone rule them out."""
    engine.call.decisions[:] = decisions
    return bool(engine.instance.call("assemble", engine.desk))


def open_decisions(engine: Engine, decisions: Ints, piece: int) -> tuple[Ints, Floats]:
    """Returns the decisions possible for a piece beside those decided, and their preference costs; views of the engine."""
    engine.call.decisions[:] = decisions
    count = engine.instance.call("open_decisions", engine.desk, piece)
    return engine.tree.found[:count], engine.tree.found_cost[:count]


def hand_over(engine: Engine, solution: Solution) -> None:
    """Puts what a search found where `final_problem` and `confirm` look for it."""
    call = engine.call
    for axis, own in enumerate(solution.positions):
        call.owns[axis, : len(own)] = own
    call.taken[: len(solution.taken)] = solution.taken
    call.force_rows[: len(solution.force_rows)] = solution.force_rows
    call.multipliers[: len(solution.multipliers)] = solution.multipliers
    call.handed[:] = len(solution.taken), len(solution.multipliers)


def final_problem(engine: Engine, solution: Solution) -> Ints:
    """Returns the numbers of a room's final problem, with the choices of a solution, as `struct FinalProblem` of confirm.hpp has them."""
    hand_over(engine, solution)
    instance, mark = engine.instance, engine.instance.mark()
    address = int(instance.call("final_problem", engine.desk))
    size = int(np.frombuffer(instance.read(address, 8), dtype=np.int64)[0])
    found = np.frombuffer(instance.read(address, 8 * size), dtype=np.int64)
    instance.release(mark)
    return found


def confirm(engine: Engine, solution: Solution, x: Floats, y: Floats) -> Ints:
    """Says what holds at an answer to a room's final problem; all positions, m, are left in call.finals.

    The answer is `x` by column, m, and `y` by row, m^-1. Returns one row each, as `struct HoldingRow` of solver/core/placement/confirm.hpp
    says.
    """
    hand_over(engine, solution)
    instance, mark = engine.instance, engine.instance.mark()
    at, multipliers = instance.write(x.tobytes()), instance.write(y.tobytes())
    address = int(instance.call("confirm", engine.desk, at, multipliers))
    count = int(np.frombuffer(instance.read(address, 8), dtype=np.int64)[0])
    rows = np.frombuffer(instance.read(address + 8, 8 * HOLDING_ROW * count), dtype=np.int64)
    instance.release(mark)
    return rows.reshape(-1, HOLDING_ROW)


def walkable(engine: Engine) -> bool:
    """Tells whether doors and use sides are joined with the bodies of `work` at grid.positions."""
    return bool(engine.instance.call("walkable", engine.desk))


def new_proof(engine: Engine, most: int) -> int:
    """Takes space for a proof's open nodes, for so many at most; returns its address."""
    return int(engine.instance.call("new_proof", engine.desk, most))


def prove(engine: Engine, nodes: int, most: int) -> tuple[int, int]:
    """Proves that the assembled pieces cannot be used together, or finds where they can: that is then in grid.positions.

    Looks at `most` nodes at most, in the space at `nodes`. Returns IMPOSSIBLE, POSSIBLE or UNKNOWN, and how many nodes were looked at.
    """
    verdict = int(engine.instance.call("prove", engine.desk, nodes, most))
    return verdict, int(engine.call.report[0])
