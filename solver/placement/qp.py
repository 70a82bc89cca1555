"""The final continuous solve of a whole house by OSQP, as one block-diagonal problem with the choices made.

OSQP begins at the search's optimum and at the multipliers that belong to it, so that it confirms rather than solves. OSQP: Stellato et al.,
Mathematical Programming Computation 2020.
"""

import math
from collections.abc import Callable, Sequence
from itertools import accumulate
from struct import Struct
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from solver.core import CoreInstance
from solver.errors import RequestError
from solver.pieces import Residuals
from solver.placement.layout import EXHAUSTED, Engine, Floats
from solver.placement.made_rooms import RoomAnswer
from solver.placement.osqp_binary import OsqpAnswer, Programme, SparseColumns, solve
from solver.placement.problem import DifferenceRow, Force

SETTINGS = {
    "verbose": False,
    "scaling": 0,  # begun at its optimum the programme needs none
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
REFUTED = {"osqp": 1e-5, "reference": 1e-3}
"""A proven optimum that is this far, m, from a solver's is none: an interior point's comes less near where hardly anything draws."""
_HEAD, _JUDGEMENT = 40, 4
"""Bytes of `struct HouseProblem` of solver/core/placement/house.hpp, and numbers of `struct Judgement`."""
_COUNT, _HOLDING = Struct("<q"), Struct("<6qd")
"""`struct Holding` and `struct HoldingRow` of solver/core/placement/confirm.hpp."""
Numbers = TypeVar("Numbers", Floats, NDArray[np.int32])


class OptimumRefuted(Exception):
    """OSQP finds another optimum than the one that was called proven: a fault of ours. The problem is `struct FinalProblem`."""

    def __init__(self, problem: bytes) -> None:
        super().__init__(f"OSQP finds a cheaper placement than the proven one of {problem!r}")
        self.problem = problem


class Judged(NamedTuple):
    """What OSQP says of a room: how exactly it finds the same optimum, and how far from it, m."""

    residuals: Residuals
    moved: float


class HouseAnswer(NamedTuple):
    """OSQP's answer for a house: by column, m, by row, m^-1, and what it says of each room."""

    x: Floats
    y: Floats
    rooms: list[Judged]


def house_residuals(
    core: CoreInstance, rooms: Sequence[RoomAnswer], problems: Sequence[int], engine: str = "osqp"
) -> list[Residuals | None]:
    """Says how exactly a solver finds the same optimum of each room of a house, their final problems being at addresses in a core's memory.

    Raises:
        OptimumRefuted: it finds another optimum than one that was proven.
        RequestError: there is no such solver.
    """
    answer = solved_house(core, problems, engine)
    if answer is None:
        return [None] * len(rooms)
    for room, judged in zip(rooms, answer.rooms, strict=True):
        if room.made.optimal and judged.moved > REFUTED[engine]:
            raise OptimumRefuted(room.problem)
    return [None if room.made.widened else judged.residuals for room, judged in zip(rooms, answer.rooms, strict=True)]


def forces_in(engine: Engine) -> tuple[Force, ...]:
    """Says what holds in a room what the last search of its work space found, by OSQP; nothing where that has no success.

    Raises:
        OptimumRefuted: it finds another optimum than one that was proven.
    """
    core, mark = engine.instance, engine.instance.mark()
    problem = int(core.call("final_problem", engine.desk))
    answer = solved_house(core, [problem])
    found = list[Force]()
    if answer is not None:
        if engine.nodes.result[EXHAUSTED] and answer.rooms[0].moved > REFUTED["osqp"]:
            raise OptimumRefuted(core.read(problem, 8 * _COUNT.unpack(core.read(problem, _COUNT.size))[0]))
        address = int(core.call("holding", engine.desk, core.write(answer.y.tobytes())))
        (count,) = _COUNT.unpack(core.read(address, _COUNT.size))
        rows = _HOLDING.iter_unpack(core.read(address + _COUNT.size, _HOLDING.size * count))
        found += [Force(DifferenceRow(*row), per_m, None if choice < 0 else choice, bool(bound)) for *row, choice, bound, per_m in rows]
    core.release(mark)
    return tuple(found)


def _solver(engine: str) -> Callable[..., OsqpAnswer]:
    if engine == "osqp":
        return solve
    if engine != "reference":
        raise RequestError("engine", f"is {engine!r}", "'osqp' or 'reference'")
    try:
        from solver.placement import reference  # noqa: PLC0415 - cvxpy takes 0.8 s to import
    except ModuleNotFoundError as missing:
        problem = f"'reference' needs {missing.name}, which is not installed"
        raise RequestError("engine", problem, "'osqp'; or install compose-homes[reference]") from None
    return reference.solve


def solved_house(core: CoreInstance, problems: Sequence[int], engine: str = "osqp") -> HouseAnswer | None:
    """Solves the final problems of a house's rooms, at these addresses in a core's memory, as one; None where the solver has no success."""
    solve_programme = _solver(engine)
    rooms, count = core.write(np.array(problems, dtype=np.int64).tobytes()), len(problems)
    house = int(core.call("join", rooms, count))
    size, columns, rows, squares, entries = np.frombuffer(core.read(house, _HEAD), dtype=np.int64).tolist()
    data = core.read(house, size)
    values = 2 * columns + 3 * rows + squares + entries
    floats, indices = np.frombuffer(data, np.float64, values, _HEAD), np.frombuffer(data, np.int32, -1, _HEAD + 8 * values)
    linear, start, low, high, multipliers, P_entries, A_entries = _split(floats, columns, columns, rows, rows, rows, squares, entries)
    P_begins, P_rows, A_begins, A_rows = _split(indices, columns + 1, squares, columns + 1, entries)
    x, y = start, np.zeros(rows)
    if columns:
        P = SparseColumns((columns, columns), P_entries, P_rows, P_begins)
        A = SparseColumns((rows, columns), A_entries, A_rows, A_begins)
        answer = solve_programme(Programme(P, linear, A, low, high), (start, multipliers), SETTINGS)
        if not answer.solved:
            return None
        x, y = answer.x, answer.y
    judged = int(core.call("judge", rooms, count, core.write(x.tobytes()), core.write(y.tobytes())))
    said = np.frombuffer(core.read(judged, 8 * _JUDGEMENT * count), dtype=np.float64).reshape(-1, _JUDGEMENT).tolist()
    return HouseAnswer(
        x, y, [Judged(Residuals(_decade(broken), _decade(drawn), _decade(gap)), moved) for broken, drawn, gap, moved in said]
    )


def _split(numbers: Numbers, *sizes: int) -> list[Numbers]:
    """Returns views of parts that lie one behind the other."""
    ends = list(accumulate(sizes))
    return [numbers[end - size : end] for end, size in zip(ends, sizes, strict=True)]


def _decade(value: float) -> int:
    """Returns the least power of ten that a value does not exceed, so that the last digits of a machine decide nothing."""
    return max(LEAST_DECADE, math.ceil(math.log10(value))) if value > 10.0**LEAST_DECADE else LEAST_DECADE
