"""Which stretches of a room's walls are free: of zones, and of what is meant to stand there already."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from solver.geometry import Rect, gaps_between, strip
from solver.pieces import Piece, Space
from solver.relations.subject import Scope
from tests.furnish.reference.openings import opened

SILL_PROUD_MM = 30
"""How far sill boards stand out into a room."""


def off_boards(scope: Scope, space: Space, height_mm: int) -> Rect:
    """Returns where fronts of a piece so high open and meet no sill board: off the walls with windows, where it reaches above a sill."""
    if not any(0 <= zone.above_mm < height_mm for zone in space.zones):
        return scope.clear
    x0, z0, x1, z1 = scope.clear
    walls = {one.wall for one in opened(scope, "window")}
    west, north, east, south = (SILL_PROUD_MM * (wall in walls) for wall in ("west", "north", "east", "south"))
    return Rect(x0 + west, z0 + north, x1 - east, z1 - south)


def opened_off_boards(piece: Piece, within: Callable[[str], Rect | None]) -> Piece:
    """Returns a wanted piece; if it is floor that fronts open over, within what is so for the kind that it is about."""
    if not piece.label.startswith("floor opened over"):
        return piece
    ways = [one if one.under or not one.attach else replace(one, within=within(one.attach.parent_kind)) for one in piece.candidates]
    return replace(piece, candidates=tuple(ways))


class TakenWalls:
    """The walls of one room and what takes them up.

    Args:
        space: the room's clear rectangle, zones and doorways.
        gates: the floor before garage doors; no rule keeps it free, but it is no place for a shelf either.
        opened: where the fronts of a kind open; None for one without doors that go along a side of it.
    """

    def __init__(self, space: Space, gates: tuple[Rect, ...], opened: Callable[[str], Rect | None]) -> None:
        self.space, self.gates, self.opened = space, gates, opened
        self._taken: list[Rect] = []

    def stretches(self, wall: str, depth_mm: int, height_mm: int, occupied: bool = True) -> list[tuple[int, int]]:
        """Returns the clear stretches for a body of that depth and height with its back to the wall, west or north first.

        `occupied` tells whether what was marked by `occupy` counts.
        """
        clear = self.space.clear
        reach = strip(clear, wall, clear.along(wall), min(depth_mm + self.space.gap_mm, clear.width, clear.depth))
        blocked = [zone.rect.along(wall) for zone in self.space.zones if zone.above_mm < height_mm and zone.rect.overlaps(reach)]
        blocked += [gate.along(wall) for gate in self.gates if gate.overlaps(reach)]
        if occupied:
            blocked += [rect.along(wall) for rect in self._taken if rect.overlaps(reach)]
        return gaps_between(clear.along(wall), blocked)

    def occupy(self, footprint: Rect) -> None:
        """Marks a footprint as taken; it blocks every wall whose bodies would reach into it."""
        self._taken.append(footprint)

    def occupied(self, footprint: Rect) -> bool:
        """Tells whether a footprint meets one that is taken."""
        return any(footprint.overlaps(rect) for rect in self._taken)
