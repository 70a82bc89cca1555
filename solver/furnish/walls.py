"""Which stretches of a room's walls are free: the contract's zones, and what is meant to stand there already."""

from __future__ import annotations

from solver.geometry import Rect, strip
from solver.scene import WALLS
from solver.wanted import Space

Stretch = tuple[int, int]
"""An interval along a wall, mm, from its west or north end."""


class WallOccupancy:
    """The walls of one room and what takes them up.

    Args:
        space: the room's clear rectangle, zones and doorways.
        gates: the floor before garage doors; no zones by the contract, but no place for a shelf either.
    """

    def __init__(self, space: Space, gates: tuple[Rect, ...] = ()) -> None:
        self.space, self.gates = space, gates
        self._taken: list[Rect] = []

    def stretches(self, wall: str, depth_mm: int, height_mm: int, occupied: bool = True) -> list[Stretch]:
        """Returns the clear stretches for a body of that depth and height with its back to the wall, west or north first.

        `occupied` tells whether what was marked by `occupy` counts.
        """
        clear = self.space.clear
        reach = strip(clear, wall, clear.along(wall), min(depth_mm + self.space.gap_mm, *_extents(clear)))
        blocked = [zone.rect.along(wall) for zone in self.space.zones if zone.above_mm < height_mm and zone.rect.overlaps(reach)]
        blocked += [gate.along(wall) for gate in self.gates if gate.overlaps(reach)]
        if occupied:
            blocked += [rect.along(wall) for rect in self._taken if rect.overlaps(reach)]
        return _gaps(clear.along(wall), sorted(blocked))

    def longest(self, wall: str, depth_mm: int, height_mm: int) -> int:
        """Returns the length of a wall's longest clear stretch, mm."""
        return max((b - a for a, b in self.stretches(wall, depth_mm, height_mm)), default=0)

    def has_door(self, wall: str) -> bool:
        """Tells whether a door or passage is in the wall."""
        return any(doorway.wall == wall for doorway in self.space.doorways)

    def pick_wall(self, size_mm: tuple[int, int, int], avoid: tuple[str, ...] = ()) -> str | None:
        """Returns the best wall for a body: walls without a door first, then the longest clear stretch; None if none is long enough."""
        width, depth, height = size_mm
        lengths = {wall: self.longest(wall, depth, height) for wall in WALLS if wall not in avoid}
        fitting = [wall for wall, length in lengths.items() if length >= width]
        return min(fitting, key=lambda wall: (self.has_door(wall), -lengths[wall]), default=None)

    def find_space(self, wall: str, size_mm: tuple[int, int, int], preferred_mm: int | None = None) -> int | None:
        """Returns a centre along the wall where a body fits, nearest to the preferred one (default: the wall's middle)."""
        width, depth, height = size_mm
        low, high = self.space.clear.along(wall)
        wish = (low + high) // 2 if preferred_mm is None else preferred_mm
        centres = [
            min(max(wish, a + width // 2), b - (width + 1) // 2)
            for a, b in self.stretches(wall, depth, height)
            if b - a >= width
        ]  # fmt: skip
        return min(centres, key=lambda centre: abs(centre - wish), default=None)

    def occupy(self, footprint: Rect) -> None:
        """Marks a footprint as taken; it blocks every wall whose bodies would reach into it."""
        self._taken.append(footprint)

    def occupied(self, footprint: Rect) -> bool:
        """Tells whether a footprint meets one that is taken."""
        return any(footprint.overlaps(rect) for rect in self._taken)


def _extents(rect: Rect) -> tuple[int, int]:
    return rect.width, rect.depth


def _gaps(whole: Stretch, blocked: list[Stretch]) -> list[Stretch]:
    """Returns what sorted intervals leave of a whole interval."""
    low, high = whole
    free: list[Stretch] = []
    for a, b in blocked:
        if a > low:
            free.append((low, min(a, high)))
        low = max(low, b)
    if high > low:
        free.append((low, high))
    return [(a, b) for a, b in free if b > a]
