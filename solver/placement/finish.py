"""Rooms from pieces: each is made by the core, then a solver of its own confirms the optimum of the house.

Not here: which candidates are taken (arrange).
"""

from collections.abc import Sequence

from solver.core import borrowed
from solver.pieces import Arrangement, Piece, Space
from solver.placement.arrange import arrange
from solver.placement.made_rooms import SolvedRoom
from solver.placement.qp import house_residuals


def place(rooms: Sequence[tuple[Space, Sequence[Piece]]], engine: str = "osqp", tidy: bool = False) -> list[Arrangement]:
    """Places the pieces of every room of a house.

    Args:
        rooms: each room's space and pieces, in order of importance.
        engine: who confirms the optimum: "osqp", or "reference" for the cvxpy model.
        tidy: whether slivers are closed or opened afterwards (solver/core/placement/tidy.hpp), at a cost of at most 0.8 a room.

    Returns:
        One arrangement a room, in the same order, exactly valid on the millimetre lattice.
    """
    return finish([arrange(space, pieces, wide=True, tidy=tidy) for space, pieces in rooms], engine)


def finish(rooms: Sequence[SolvedRoom], engine: str = "osqp") -> list[Arrangement]:
    """Has the optimum of all rooms confirmed, as one block-diagonal programme.

    Raises:
        OptimumRefuted: another optimum is found than one that was proven.
    """
    answers = [room.answer for room in rooms]
    with borrowed() as core:
        said = house_residuals(core, answers, [core.write(answer.problem) for answer in answers], engine)
    return [room.with_(residuals=residuals).arrangement for room, residuals in zip(rooms, said, strict=True)]
