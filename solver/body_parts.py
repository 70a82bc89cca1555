"""The parts that a body is made of, in metres, in the body's own frame."""

from collections.abc import Sequence
from typing import Final, NamedTuple

from catalogs.shapes import LONG, Axis, Form, Solid

ROUND: Final = 0.12
"""A cylinder whose two diameters differ by a lesser share touches others as one, else as a box."""


class BodyPart(NamedTuple):
    """One part of a body, turned with it.

    `size` is width, height and depth, m (x, y, z); `at` its middle relative to the middle of the body's footprint at its underside,
    front towards +z. `taper` is the radius at the axis' higher end by that at its lower one, the larger of them filling the box.
    `material` is a slot of materials.yaml. `front` names the front of the body that it moves with.
    """

    form: Form
    size: tuple[float, float, float]
    at: tuple[float, float, float]
    axis: Axis
    taper: float
    material: str
    front: str | None = None


WHOLE: Final = (BodyPart("rounded", (1.0, 1.0, 1.0), (0.0, 0.5, 0.0), "y", 1.0, "body"),)
"""The shape of a kind that has none: its whole box as one rounded block."""


def unit_parts(solids: Sequence[Solid]) -> tuple[BodyPart, ...]:
    """Returns a shape's parts in a box of width, depth and height 1."""
    return tuple(map(_unit_part, solids)) or WHOLE


def _unit_part(solid: Solid) -> BodyPart:
    (x0, x1), (y0, y1), (z0, z1) = solid.x, solid.y, solid.z
    at = ((x0 + x1) / 2 - 0.5, (y0 + y1) / 2, (z0 + z1) / 2 - 0.5)
    return BodyPart(solid.form, (x1 - x0, y1 - y0, z1 - z0), at, solid.axis, solid.taper, solid.material, solid.front)


def sized(parts: Sequence[BodyPart], width: float, depth: float, height: float) -> tuple[BodyPart, ...]:
    """Returns the parts of a unit box in a box with these extents, m."""
    return tuple(
        BodyPart(form, (size_x * width, size_y * height, size_z * depth), (x * width, y * height, z * depth), axis, taper, material, front)
        for form, (size_x, size_y, size_z), (x, y, z), axis, taper, material, front in parts
    )


def is_round(form: Form, axis: Axis, size: tuple[float, float, float]) -> bool:
    """Tells whether a part with an axis touches others as what is round: its extents across that, of `size` (x, y, z), are nearly one."""
    if form not in LONG:
        return False
    one, other = (extent for name, extent in zip("xyz", size, strict=True) if name != axis)
    return abs(one - other) < ROUND * max(one, other)
