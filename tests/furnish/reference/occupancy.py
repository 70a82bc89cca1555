"""Which stretches of a room's walls are free: of zones, and of what is meant to stand there already."""

from __future__ import annotations

from solver.geometry import Rect, gaps_between, strip
from solver.pieces import Space


class TakenWalls:
    """The walls of one room and what takes them up.

    Args:
        space: the room's clear rectangle, zones and doorways.
        gates: the floor before garage doors; no rule keeps it free, but it is no place for a shelf either.
    """

    def __init__(self, space: Space, gates: tuple[Rect, ...] = ()) -> None:
        self.space, self.gates = space, gates
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
