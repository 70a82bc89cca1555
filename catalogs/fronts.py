"""The fronts of a shape: what opens, about which line, how far, and which of its solids move with it.

Axes are the body's own, x to its right, y up, z to its front; a turn is positive from y to z, z to x and x to y. A front turns about an
edge of its panel's outer face, so that nothing of it goes behind the panel or beside it.
"""

from collections.abc import Sequence
from functools import lru_cache
from math import atan2, cos, radians, sin
from typing import Final, Literal, NamedTuple

from catalogs.shapes import Axis, Opens, Solid

TOWARDS: Final[dict[Opens, tuple[Axis, Literal[-1, 1]]]] = {
    "left": ("y", -1), "right": ("y", 1), "up": ("x", -1), "down": ("x", 1), "lid": ("x", -1), "drawer": ("z", 1),
}  # fmt: skip
"""The axis of each way to open, and to which side of it opening goes."""


class BodyFront(NamedTuple):
    """A front of a body: a door, a flap, a lid, a drawer.

    `hinge` is a point of its axis when closed, from the middle of its body's footprint at its underside. Open it is at `end`: degrees, of a
    drawer along its axis. Lengths are shares of the body's box (`fronts_of`), or m (`sized_front`). `parts` are the numbers of its solids,
    its panel first. `must_open`: it is an error where it is blocked.
    """

    name: str
    opens: Opens
    axis: Axis
    hinge: tuple[float, float, float]
    end: float
    parts: tuple[int, ...]
    must_open: bool = False

    @property
    def slides(self) -> bool:
        """Whether it is a drawer."""
        return self.opens == "drawer"


class FrontFloor(NamedTuple):
    """The space before a piece that its fronts come into as they open, m.

    `depth` from its front edge where they open wholly, `half` where they open little more than half of their way; from `left` to `right`
    of its middle, and from `above` its underside on. Whether an edge of a door goes `along_side`s of it, where a wall may be.
    """

    depth: float
    half: float
    left: float
    right: float
    above: float
    along_side: bool = False


_HALF: Final = 0.55
"""A little more than half of a front's way: half of it is then reached for certain."""
_BESIDE: Final = 0.02
"""The free edge of a door that is at most so far from a side of its piece goes along it, m."""
_LEAST: Final = 0.003
"""Fronts that come out less than this need no floor, m; a chest's lid comes out by its thickness."""


def floor_before(solids: Sequence[Solid], size: tuple[float, float, float]) -> FrontFloor | None:
    """Returns the space before a piece of a width, depth and height, m, that its fronts come into; None where they come into none."""
    fronts = [one for one in fronts_of(solids) if _comes_out(one, solids, size, 1.0) >= _LEAST]
    if not fronts:
        return None
    depth, half = (max(_comes_out(one, solids, size, share) for one in fronts) for share in (1.0, _HALF))
    moved = [solids[part] for one in fronts for part in one.parts]
    left, right = max(min(one.x[0] for one in moved), 0.0), min(max(one.x[1] for one in moved), 1.0)
    above = max(min(one.y[0] for one in moved), 0.0) * size[2]
    along_side = any(_goes_along_side(one, solids[one.parts[0]], size[0]) for one in fronts)
    return FrontFloor(depth, half, (left - 0.5) * size[0], (right - 0.5) * size[0], above, along_side)


def _goes_along_side(front: BodyFront, panel: Solid, width: float) -> bool:
    """Tells whether the edge of a door across from its hinge goes along a side of its piece, so wide, m."""
    aside = {"left": 1.0 - panel.x[1], "right": panel.x[0]}.get(front.opens)
    return aside is not None and aside * width <= _BESIDE


def _comes_out(front: BodyFront, solids: Sequence[Solid], size: tuple[float, float, float], share: float) -> float:
    """Returns how far any of a front comes out before its piece as it opens a share of its way, m."""
    (width, depth, height), parts = size, [solids[part] for part in front.parts]
    if front.slides:
        return max((part.z[1] - 1.0 + front.end * share) * depth for part in parts)
    hinge_x, hinge_y, hinge_z = front.hinge
    turn, farthest = radians(abs(front.end) * share), 0.0
    for part in parts:
        if front.axis == "y":
            away = (part.x[1] - 0.5 - hinge_x if front.end < 0 else hinge_x - part.x[0] + 0.5) * width
        else:
            away = (part.y[1] - hinge_y if front.end > 0 else hinge_y - part.y[0]) * height
        ahead = (part.z[1] - 0.5 - hinge_z) * depth
        most = min(max(atan2(away, ahead), 0.0), turn)
        farthest = max(farthest, ahead * cos(most) + away * sin(most))
    return farthest + (hinge_z - 0.5) * depth


@lru_cache(maxsize=4096)
def fronts_of(solids: Sequence[Solid]) -> tuple[BodyFront, ...]:
    """Returns the fronts of a shape, a tuple, in the order of their panels."""
    return tuple(_front(number, solid, solids) for number, solid in enumerate(solids) if solid.opens and solid.front)


def sized_front(front: BodyFront, size: tuple[float, float, float]) -> BodyFront:
    """Returns a front in a box of this width, depth and height, m, its lengths in m."""
    (width, depth, height), (x, y, z) = size, front.hinge
    return front._replace(hinge=(x * width, y * height, z * depth), end=front.end * depth if front.slides else front.end)


def _front(number: int, panel: Solid, solids: Sequence[Solid]) -> BodyFront:
    assert panel.opens is not None
    assert panel.front is not None
    axis, side = TOWARDS[panel.opens]
    others = (i for i, solid in enumerate(solids) if solid.front == panel.front and i != number)
    return BodyFront(panel.front, panel.opens, axis, _hinge(panel), side * panel.range, (number, *others), panel.must_open)


def _hinge(panel: Solid) -> tuple[float, float, float]:
    (x0, x1), (y0, y1), (z0, z1) = panel.x, panel.y, panel.z
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    at = {"left": (x0, y0, z1), "right": (x1, y0, z1), "up": (x, y1, z1), "down": (x, y0, z1), "lid": (x, y1, z0), "drawer": (x, y, z1)}
    across, up, along = at[panel.opens or "drawer"]
    return across - 0.5, up, along - 0.5
