"""Can a square person get from the doors to every use side of a room? Exact, on the compressed grid.

Bodies are inflated by half the person and the walls moved in by as much; cuts at the inflated edges make cells that are
wholly free or wholly blocked. Lengths are doubled millimetres inside, so that halves stay integers, and the person is
1 mm smaller than asked, so that a gap of exactly its size counts.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

import numpy as np
from scipy import ndimage

from solver.geometry import Rect
from solver.wanted import Doorway, Space


def _doubled(rect: Rect, grow: int) -> Rect:
    return Rect(2 * rect.x0 - grow, 2 * rect.z0 - grow, 2 * rect.x1 + grow, 2 * rect.z1 + grow)


def _door_centres(space: Space, door: Doorway, half: int) -> Rect:
    """Returns where the person's centre is when it has just come through a door (doubled mm)."""
    square, clear = door.square, space.clear
    along = (2 * max(square.x0, clear.x0), 2 * min(square.x1, clear.x1))
    if door.wall in ("east", "west"):
        along = (2 * max(square.z0, clear.z0), 2 * min(square.z1, clear.z1))
    a, b = along[0] + half, along[1] - half
    if a > b:
        a = b = (along[0] + along[1]) // 2
    return {
        "north": Rect(a, 2 * clear.z0 + half, b, 2 * clear.z0 + half),
        "south": Rect(a, 2 * clear.z1 - half, b, 2 * clear.z1 - half),
        "west": Rect(2 * clear.x0 + half, a, 2 * clear.x0 + half, b),
        "east": Rect(2 * clear.x1 - half, a, 2 * clear.x1 - half, b),
    }[door.wall]


def connected(space: Space, solids: Sequence[Rect], stands: Sequence[Rect]) -> bool:
    """Tells whether all doors and all stands of a room lie in one walkable component.

    Args:
        space: the room; its zones with cause `outline` are walls.
        solids: footprints of everything that stands on the floor, mm.
        stands: squares of the person's size that must be reached, mm.
    """
    half = space.robot_mm - 1
    domain = _doubled(space.clear, -half)
    if domain.x0 >= domain.x1 or domain.z0 >= domain.z1:
        return not stands and len(space.doorways) <= 1
    missing = [zone.rect for zone in space.zones if zone.cause == "outline"]
    blocks = [_doubled(rect, half) for rect in (*solids, *missing)]
    targets = [_door_centres(space, door, half) for door in space.doorways]
    targets += [_doubled(stand, -half) for stand in stands]
    return len(targets) < 2 or _one_component(domain, blocks, targets)


def _cuts(low: int, high: int, edges: Sequence[int]) -> list[int]:
    return sorted({low, high, *(edge for edge in edges if low < edge < high)})


def _one_component(domain: Rect, blocks: Sequence[Rect], targets: Sequence[Rect]) -> bool:
    xs = _cuts(domain.x0, domain.x1, [e for r in (*blocks, *targets) for e in (r.x0, r.x1)])
    zs = _cuts(domain.z0, domain.z1, [e for r in (*blocks, *targets) for e in (r.z0, r.z1)])
    free = np.ones((len(xs) - 1, len(zs) - 1), dtype=bool)
    for r in blocks:
        x0, x1 = bisect_left(xs, r.x0), bisect_left(xs, r.x1)
        z0, z1 = bisect_left(zs, r.z0), bisect_left(zs, r.z1)
        if r.x0 < domain.x1 and r.z0 < domain.z1:
            free[x0:x1, z0:z1] = False
    labels, _ = ndimage.label(free)
    common: set[int] | None = None
    for r in targets:
        x0, x1 = max(bisect_left(xs, r.x0) - 1, 0), bisect_right(xs, r.x1)
        z0, z1 = max(bisect_left(zs, r.z0) - 1, 0), bisect_right(zs, r.z1)
        met = {int(label) for label in np.unique(labels[x0:x1, z0:z1])} - {0}
        common = met if common is None else common & met
        if not common:
            return False
    return True
