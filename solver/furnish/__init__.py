"""Furnish: a typed room -> its space, and every wanted piece with all the ways it may stand.

Comes in: a `scene.Room` with openings, the catalogs, the room's stream. Goes out: `wanted.Space` and `wanted.Wanted`.
May import: catalogs and the ground floor. Not here: choosing among the ways to stand and exact places (placement).
"""

from solver.furnish.anchors import wanted_pieces
from solver.furnish.asked import Asked, asked_pieces
from solver.furnish.comfort import with_comfort
from solver.furnish.walls import WallOccupancy
from solver.furnish.zones import space_of

__all__ = ["Asked", "WallOccupancy", "asked_pieces", "space_of", "wanted_pieces", "with_comfort"]
