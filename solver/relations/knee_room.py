"""The boxes around the parts of a piece, which tell where it can reach under another one (solver/core/furnish/relations/knee_room.cpp).

Kinds without a shape have no parts: nothing is known of what is free under them.
"""

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

from catalogs.shapes import Solid
from solver.body_parts import BodyPart, sized, unit_parts
from solver.geometry import Rect

TINY: Final = 1e-6
"""What sums of shares may be off by, mm."""


class PartBox(NamedTuple):
    """The box around a part: its rectangle from the middle of the piece's footprint, from `low` to `high` above its underside, mm."""

    rect: Rect
    low: int
    high: int


def boxes_of(solids: Sequence[Solid], size: tuple[float, float, float]) -> tuple[PartBox, ...]:
    """Returns the boxes around the parts of a piece of some width, depth and height, m; rounded outwards.

    What is hollow counts as whole: nothing reaches under a piece into its drawers.
    """
    return tuple(_box(part) for part in sized(unit_parts(_wholes(solids)), *size)) if solids else ()


def _wholes(solids: Sequence[Solid]) -> list[Solid]:
    """Returns solids, those that are boards of one hollow part as the box around them."""
    found: dict[int | str, list[Solid]] = {}
    for number, solid in enumerate(solids):
        found.setdefault(f"alone {number}" if solid.board is None else solid.board, []).append(solid)
    return [several[0] if len(several) == 1 else _around(several) for several in found.values()]


def _around(solids: Sequence[Solid]) -> Solid:
    ends = {axis: [getattr(solid, axis) for solid in solids] for axis in "xyz"}
    spans = {axis: (min(low for low, _ in several), max(high for _, high in several)) for axis, several in ends.items()}
    return solids[0].model_copy(update=spans)


def _box(part: BodyPart) -> PartBox:
    (low_x, low_y, low_z), (high_x, high_y, high_z) = (
        [1000 * (at + side * length) for at, length in zip(part.at, part.size, strict=True)] for side in (-0.5, 0.5)
    )
    rect = Rect(math.floor(low_x + TINY), math.floor(low_z + TINY), math.ceil(high_x - TINY), math.ceil(high_z - TINY))
    return PartBox(rect, round(low_y), round(high_y))
