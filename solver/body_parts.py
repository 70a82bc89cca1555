"""The parts that a body is made of, in metres, in the body's own frame.

Comes in: a kind's solids (shares of its box) and a body's size. Goes out: `BodyPart`s. May import: catalogs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from catalogs.shapes import Axis, Form, Solid


class BodyPart(NamedTuple):
    """One part of a body, turned with it.

    `size` is width, height and depth, m (x, y, z); `at` its middle relative to the middle of the body's footprint at its underside,
    front towards +z. `taper` is the radius at the axis' higher end by that at its lower one, the larger of them filling the box.
    `material` is a slot of materials.yaml.
    """

    form: Form
    size: tuple[float, float, float]
    at: tuple[float, float, float]
    axis: Axis
    taper: float
    material: str


def parts_of(solids: Sequence[Solid], width: float, depth: float, height: float) -> tuple[BodyPart, ...]:
    """Returns the parts of a body with these extents, m; the whole box as one rounded block where its kind has no shape."""
    if not solids:
        return (BodyPart("rounded", (width, height, depth), (0.0, height / 2, 0.0), "y", 1.0, "body"),)
    return tuple(
        BodyPart(
            solid.form,
            ((solid.x[1] - solid.x[0]) * width, (solid.y[1] - solid.y[0]) * height, (solid.z[1] - solid.z[0]) * depth),
            (
                ((solid.x[0] + solid.x[1]) / 2 - 0.5) * width,
                (solid.y[0] + solid.y[1]) / 2 * height,
                ((solid.z[0] + solid.z[1]) / 2 - 0.5) * depth,
            ),
            solid.axis,
            solid.taper,
            solid.material,
        )
        for solid in solids
    )
