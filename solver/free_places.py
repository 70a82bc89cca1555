"""Footprints of a scene's bodies, and the free place nearest to a wished one, exactly.

Comes in: bodies in metres, rectangles in integer millimetres. Goes out: rectangles. May import: scene, geometry.

The free places of a box are what is left of a rectangle after the obstacles, grown by the box; the nearest of them to a wish
has both coordinates among the wish's own and the edges of those, so that these are all that need to be tried.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from solver.geometry import Rect
from solver.scene import Decoration, Dynamic, Furniture


@dataclass(frozen=True)
class Solid:
    """What nobody can be in: a rectangle from `bottom` to `top`, mm."""

    rect: Rect
    bottom: float
    top: float

    def beside(self, other: Solid) -> bool:
        """Tells whether two are at different heights, so that they may share floor."""
        return self.bottom >= other.top or other.bottom >= self.top


def footprint(body: Furniture | Decoration | Dynamic) -> Rect:
    """Returns the bounding rectangle of a body, mm, rounded outwards by less than a millimetre."""
    angle = math.radians(body.rotation % 360)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    if body.rotation % 90 == 0:
        c, s = round(c), round(s)
    width, depth = body.width * c + body.depth * s, body.width * s + body.depth * c
    sides = (body.x - width / 2, body.z - depth / 2, body.x + width / 2, body.z + depth / 2)
    low, high = [math.floor(v * 1000 + 1e-6) for v in sides[:2]], [math.ceil(v * 1000 - 1e-6) for v in sides[2:]]
    return Rect(low[0], low[1], high[0], high[1])


def solid_of(body: Furniture | Decoration | Dynamic) -> Solid:
    """Returns the space a body takes up."""
    return Solid(footprint(body), body.y * 1000, (body.y + body.height) * 1000)


def nearest_place(own: Rect, clear: Rect, blocks: Sequence[Rect]) -> Rect | None:
    """Returns the free place nearest to a box, or None where there is none.

    Args:
        own: the box where it is wished.
        clear: where it has to stay.
        blocks: what it must not overlap.

    Ties go to the lesser step along x, then along z.
    """
    xs = _steps(own.x0, own.width, (clear.x0, clear.x1), [(rect.x0, rect.x1) for rect in blocks])
    zs = _steps(own.z0, own.depth, (clear.z0, clear.z1), [(rect.z0, rect.z1) for rect in blocks])
    best: tuple[int, Rect] | None = None
    for x in xs:
        if best is not None and (x - own.x0) ** 2 >= best[0]:
            break
        beside = [(rect.z0 - own.depth, rect.z1) for rect in blocks if rect.x0 < x + own.width and x < rect.x1]
        for z in zs:
            distance = (x - own.x0) ** 2 + (z - own.z0) ** 2
            if best is not None and distance >= best[0]:
                break
            if not any(before < z < behind for before, behind in beside):
                best = distance, Rect(x, z, x + own.width, z + own.depth)
                break
    return best[1] if best else None


def free_places(own: Rect, clear: Rect, blocks: Sequence[Rect], apart: int) -> Iterator[Rect]:
    """Yields free places of a box, nearest first: those that `nearest_place` tries, and those `apart` mm from obstacles and walls."""
    inner = clear.shrunk(apart)
    edges = [*blocks, *(rect.shrunk(-apart) for rect in blocks), Rect(inner.x1, inner.z1, inner.x0, inner.z0)]
    xs = _steps(own.x0, own.width, (clear.x0, clear.x1), [(rect.x0, rect.x1) for rect in edges])
    zs = _steps(own.z0, own.depth, (clear.z0, clear.z1), [(rect.z0, rect.z1) for rect in edges])
    for x, z in sorted(((x, z) for x in xs for z in zs), key=lambda at: (at[0] - own.x0) ** 2 + (at[1] - own.z0) ** 2):
        place = Rect(x, z, x + own.width, z + own.depth)
        if not any(place.overlaps(rect) for rect in blocks):
            yield place


def _steps(at: int, extent: int, bounds: tuple[int, int], blocks: Sequence[tuple[int, int]]) -> list[int]:
    """Returns the min coordinates worth trying along an axis, nearest first."""
    low, high = bounds[0], bounds[1] - extent
    tried = {at, low, high, *(b for _, b in blocks), *(a - extent for a, _ in blocks)}
    return sorted((v for v in tried if low <= v <= high), key=lambda v: (abs(v - at), v))
