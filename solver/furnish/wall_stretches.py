"""Which stretches of a room's walls are free of zones."""

from __future__ import annotations

from solver.geometry import gaps_between, strip
from solver.pieces import Space

Stretch = tuple[int, int]
"""An interval along a wall, mm, from its west or north end."""


def clear_stretches(space: Space, wall: str, depth_mm: int, height_mm: int) -> list[Stretch]:
    """Returns the clear stretches for a body of that depth and height with its back to the wall, west or north first."""
    clear = space.clear
    reach = strip(clear, wall, clear.along(wall), min(depth_mm + space.gap_mm, clear.width, clear.depth))
    blocked = [zone.rect.along(wall) for zone in space.zones if zone.above_mm < height_mm and zone.rect.overlaps(reach)]
    return gaps_between(clear.along(wall), blocked)
