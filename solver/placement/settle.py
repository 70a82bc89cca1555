"""From drafts to the lattice: one continuous solve for the house, then the snap, then an exact check."""

from __future__ import annotations

from collections.abc import Sequence

from solver.geometry import Rect
from solver.placement.arrange import Draft, arrange, with_margin
from solver.placement.explain import why_left_out
from solver.placement.qp import Decided, solve_house
from solver.placement.snap import snap
from solver.placement.terms import Floats
from solver.placement.tidy import tidied
from solver.wanted import Arrangement, Placed, Space, Wanted

NEAR_WALL_MM = 150
"""A companion whose back is this close to its parent's wall counts as standing at it (contract: wall_far beyond 0.2 m
from the wall's line)."""


def place(rooms: Sequence[tuple[Space, Sequence[Wanted]]], engine: str = "osqp", tidy: bool = False) -> list[Arrangement]:
    """Places the wanted pieces of every room of a house.

    Args:
        rooms: each room's space and wanted pieces, in order of importance.
        engine: of the final solve: "osqp", "reference" for the cvxpy model, or "search" for the search's own positions, which
            are optimal already: for trials.
        tidy: whether slivers are closed or opened afterwards (`tidy`), at a cost of at most MOST_COST a room.

    Returns:
        One arrangement a room, in the same order, exactly valid on the millimetre lattice.
    """
    return settle([arrange(space, wanted) for space, wanted in rooms], engine, tidy)


def settle(drafts: Sequence[Draft], engine: str = "osqp", tidy: bool = False) -> list[Arrangement]:
    """Solves all drafts as one block-diagonal programme, snaps each room and, where asked for, tidies it."""
    rooms = [decided(draft) for draft in drafts]
    return [_arrangement(draft, room, p, tidy) for draft, room, p in zip(drafts, rooms, _solve(rooms, engine), strict=True)]


def _solve(rooms: Sequence[Decided], engine: str) -> list[tuple[Floats, Floats]]:
    if engine == "search":
        return [room.positions for room in rooms]
    if engine == "reference":
        from solver.placement.reference import solve_house as reference_house  # noqa: PLC0415 - cvxpy takes 0.8 s to import

        return reference_house(rooms)
    return solve_house(rooms)


def decided(draft: Draft) -> Decided:
    """Returns the draft's problem with its choices made, as the final solve takes it."""
    if draft.outcome.positions is None:
        raise ValueError(f"{draft.space.room}: an unsolved draft cannot be settled")
    return Decided(draft.problem, draft.outcome.rows, draft.outcome.positions)


def _arrangement(draft: Draft, room: Decided, positions: tuple[Floats, Floats], tidy: bool) -> Arrangement:
    p, walkable = _snapped(draft, room, positions)
    if draft.walkable and not walkable and (wider := with_margin(draft)) is not None:
        draft, room = wider, decided(wider)
        p, walkable = _snapped(draft, room, room.positions)
    p, more = tidied(draft, p) if tidy and walkable else (p, 0.0)
    bodies = {part.label: part for part in draft.problem.parts if not part.stand}
    placed: list[Placed] = []
    for c in draft.chosen:
        label = c.wanted.label
        rect = bodies[label].rect(p)
        wall = c.alternative.wall
        if wall is None and c.alternative.attach is not None and c.alternative.bottom_mm == 0:
            wall = _wall_behind(draft.space, c.alternative.attach.parent, placed, rect)
        placed.append(Placed(label, c.alternative, c.rotation, wall, rect))
    reasons = tuple((piece.label, f"{why}; {why_left_out(draft.space, piece, placed)}") for piece, why in draft.left_out)
    notes = () if walkable else ("no walkable arrangement of the required pieces was found",)
    cost = round(draft.cost + more, 6)
    return Arrangement(draft.space.room, tuple(placed), reasons, cost, draft.proven, draft.solves, notes, draft.best)


def _snapped(draft: Draft, room: Decided, positions: tuple[Floats, Floats]) -> tuple[tuple[list[int], list[int]], bool]:
    """Returns positions on the lattice and whether they are walkable, both checked in integers.

    Where the walk hangs on the last millimetre, the search's own positions are snapped instead of the final solve's.
    """
    p = _on_lattice(draft, room, positions)
    if not draft.walkable:
        return p, False
    if draft.core.walkable_at(p):
        return p, True
    own = _on_lattice(draft, room, room.positions)
    return (own, True) if draft.core.walkable_at(own) else (p, False)


def _on_lattice(draft: Draft, room: Decided, positions: tuple[Floats, Floats]) -> tuple[list[int], list[int]]:
    p = snap(room.problem, room.rows, positions)
    broken = room.problem.violations(p)
    if broken:
        raise AssertionError(f"{draft.space.room}: {broken[0]}")
    return p


def _wall_behind(space: Space, parent: str, placed: Sequence[Placed], rect: Rect) -> str | None:
    """Returns the parent's wall where the companion stands at it too."""
    wall = next((other.wall for other in placed if other.label == parent), None)
    if wall is None:
        return None
    clear = space.clear
    distance = {
        "north": rect.z0 - clear.z0,
        "south": clear.z1 - rect.z1,
        "west": rect.x0 - clear.x0,
        "east": clear.x1 - rect.x1,
    }[wall]
    return wall if distance <= NEAR_WALL_MM else None
