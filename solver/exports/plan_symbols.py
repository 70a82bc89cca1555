"""What bodies look like from above: the outlines of their parts, the lowest first, without what others hide; m, in the body's own frame."""

from __future__ import annotations

from functools import lru_cache
from operator import itemgetter
from typing import Final, Literal, NamedTuple

from solver.body_parts import BodyPart

SMALLEST: Final = 0.03
"""Parts that are smaller than this both ways, m, are not drawn: handles, buttons."""
HIGH: Final = 1.4
"""What hangs higher than this, m, is above the plane that plans are cut at and is drawn dashed."""
_SOFT: Final = 0.12
"""The radius of a soft corner as a share of the lesser side."""


class PlanMark(NamedTuple):
    """An outline seen from above: a rectangle with corners of a radius, or an ellipse; about its middle, m.

    `part` is the index of the part it belongs to.
    """

    form: Literal["rectangle", "ellipse"]
    x: float
    z: float
    width: float
    depth: float
    radius: float
    part: int


@lru_cache(maxsize=1 << 12)
def marks_of(parts: tuple[BodyPart, ...]) -> tuple[PlanMark, ...]:
    """Returns the outlines of a body's parts as seen from above, the lowest first; at least one."""
    ordered = sorted([(part.at[1] + part.size[1] / 2, index) for index, part in enumerate(parts)], key=itemgetter(0))
    kept: list[PlanMark] = []
    covers: list[tuple[float, float, float, float]] = []
    for _, index in reversed(ordered):
        form, (width, _, depth), (x, _, z), axis, *_ = parts[index]
        if width < SMALLEST and depth < SMALLEST and kept:
            continue
        x0, x1, z0, z1 = x - width / 2 + 1e-6, x + width / 2 - 1e-6, z - depth / 2 + 1e-6, z + depth / 2 - 1e-6
        if any(a <= x0 and x1 <= b and c <= z0 and z1 <= d for a, b, c, d in covers):
            continue
        if form == "box":
            kept.append(PlanMark("rectangle", x, z, width, depth, 0.0, index))
            covers.append((x0 - 2e-6, x1 + 2e-6, z0 - 2e-6, z1 + 2e-6))
        elif form == "ball" or (axis == "y" and form != "rounded"):
            kept.append(PlanMark("ellipse", x, z, width, depth, 0.0, index))
        else:
            share = _SOFT if form == "rounded" else 0.5 if form == "capsule" else 0.0
            kept.append(PlanMark("rectangle", x, z, width, depth, share * min(width, depth), index))
            covers.append((x0 - 2e-6, x1 + 2e-6, z0 - 2e-6, z1 + 2e-6))
    return tuple(reversed(kept))
