"""The fronts of a shape: what opens, about which line, how far, and which of its solids move with it.

Comes in: a kind's solids. Goes out: `UnitFront`s, in shares of the body's box. May import: shapes.

Axes are the body's own, x to its right, y up, z to its front; a turn is positive from y to z, z to x and x to y. A front turns about an
edge of its panel's outer face, so that nothing of it goes behind the panel or beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Final, Literal, NamedTuple

from catalogs.shapes import Axis, Opens, Solid

TOWARDS: Final[dict[Opens, tuple[Axis, Literal[-1, 1]]]] = {
    "left": ("y", -1), "right": ("y", 1), "up": ("x", -1), "down": ("x", 1), "lid": ("x", -1), "drawer": ("z", 1),
}  # fmt: skip
"""The axis of each way to open, and to which side of it opening goes."""


class UnitFront(NamedTuple):
    """A front in its body's box.

    `hinge` is a point of its axis when closed: shares of the box from the middle of its footprint at its underside. Open it is at `end`:
    degrees, of a drawer the share of the body's depth. `parts` are the numbers of its solids, its panel first. `must_open`: it is an error
    where it is blocked.
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


@lru_cache(maxsize=4096)
def fronts_of(solids: Sequence[Solid]) -> tuple[UnitFront, ...]:
    """Returns the fronts of a shape, a tuple, in the order of their panels."""
    return tuple(_front(number, solid, solids) for number, solid in enumerate(solids) if solid.opens and solid.front)


def _front(number: int, panel: Solid, solids: Sequence[Solid]) -> UnitFront:
    assert panel.opens is not None
    assert panel.front is not None
    axis, side = TOWARDS[panel.opens]
    others = (i for i, solid in enumerate(solids) if solid.front == panel.front and i != number)
    return UnitFront(panel.front, panel.opens, axis, _hinge(panel), side * panel.range, (number, *others), panel.must_open)


def _hinge(panel: Solid) -> tuple[float, float, float]:
    (x0, x1), (y0, y1), (z0, z1) = panel.x, panel.y, panel.z
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    at = {"left": (x0, y0, z1), "right": (x1, y0, z1), "up": (x, y1, z1), "down": (x, y0, z1), "lid": (x, y1, z0), "drawer": (x, y, z1)}
    across, up, along = at[panel.opens or "drawer"]
    return across - 0.5, up, along - 0.5
