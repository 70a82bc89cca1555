"""From solved rooms to whole millimetres: OSQP confirms the optimum of the house, then the core's snap, exact check and tidying.

Not here: which candidates are taken.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import inf

from solver.errors import RequestError
from solver.geometry import WALL_BEHIND
from solver.pieces import Arrangement, Piece, Placed, Space
from solver.placement.arrange import NOT_WALKABLE, SolvedRoom, arrange
from solver.placement.layout import WAYS
from solver.placement.left_out import why_left_out
from solver.placement.problem import Confirmed
from solver.placement.qp import confirmed

NEAR_WALL_MM = 150
"""A companion whose back is this close to its parent's wall counts as standing at it (the rule wall_far: beyond 0.2 m
from the wall's line)."""


def place(rooms: Sequence[tuple[Space, Sequence[Piece]]], engine: str = "osqp", tidy: bool = False) -> list[Arrangement]:
    """Places the pieces of every room of a house.

    Args:
        rooms: each room's space and pieces, in order of importance.
        engine: of the final solve: "osqp", "reference" for the cvxpy model, or "search" for the search's own positions, which
            are optimal already: for trials.
        tidy: whether slivers are closed or opened afterwards (solver/core/placement/tidy.hpp), at a cost of at most 0.8 a room.

    Returns:
        One arrangement a room, in the same order, exactly valid on the millimetre lattice.
    """
    return finish([arrange(space, pieces, wide=True) for space, pieces in rooms], engine, tidy)


def finish(rooms: Sequence[SolvedRoom], engine: str = "osqp", tidy: bool = False) -> list[Arrangement]:
    """Solves all rooms as one block-diagonal programme, snaps each room and, where asked for, tidies it."""
    return [_arrangement(room, solved, tidy) for room, solved in zip(rooms, _solve(rooms, engine), strict=True)]


def _solve(rooms: Sequence[SolvedRoom], engine: str) -> list[Confirmed]:
    if engine == "search":
        return [Confirmed(room.solution.positions) for room in rooms]
    if engine == "reference":
        try:
            from solver.placement.reference import solve_house as reference_house  # noqa: PLC0415 - cvxpy takes 0.8 s to import
        except ModuleNotFoundError as missing:
            problem = f"'reference' needs {missing.name}, which is not installed"
            raise RequestError("engine", problem, "'osqp'; or install compose-homes[reference]") from None
        return [Confirmed(positions) for positions in reference_house([(room.problem, room.solution) for room in rooms])]
    if engine != "osqp":
        raise RequestError("engine", f"is {engine!r}", "'osqp' or 'reference'")
    return [replace(said, positions=room.solution.positions) for room, said in zip(rooms, confirmed(rooms), strict=True)]


def _arrangement(room: SolvedRoom, confirmed: Confirmed, tidy: bool) -> Arrangement:
    walkable, more = room.core.settle(confirmed.positions, room.solution, room.walkable, tidy)
    if room.walkable and not walkable and room.space.ways_mm:
        room.core.engine.room.space[WAYS] = 0
        walkable, more = room.core.settle(confirmed.positions, room.solution, True, tidy)
    everything, placed = room.chosen, list[Placed]()
    for chosen, rect in zip(everything, room.core.footprints([chosen.number for chosen in everything]), strict=True):
        candidate = chosen.candidate
        wall = candidate.wall
        if wall is None and candidate.attach is not None and candidate.bottom_mm == 0:
            behind = WALL_BEHIND[chosen.rotation]
            parents = any(other.label == candidate.attach.parent and other.wall == behind for other in placed)
            wall = behind if parents and rect.wall_distance(behind, room.space.clear) <= NEAR_WALL_MM else None
        placed.append(Placed(chosen.piece.label, candidate, chosen.rotation, wall, rect))
    gone = {piece.label for piece, _ in room.left_out}
    reasons = tuple((piece.label, f"{why}; {why_left_out(room.space, piece, placed, gone)}") for piece, why in room.left_out)
    skipped = {piece.label: inf if piece.required else piece.skip_cost for piece, _ in room.left_out}
    notes = () if walkable else (NOT_WALKABLE,)
    cost = round(room.cost + more, 6)
    proven, best = room.proven, room.best
    return Arrangement(room.space.room, tuple(placed), reasons, cost, proven, room.solves, notes, best, confirmed.residuals, skipped)
