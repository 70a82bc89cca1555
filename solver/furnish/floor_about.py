"""The floor about a kind of furniture that is better kept free: what its catalog says, and what its fronts open over.

Comes in: a kind of furniture and its shape. Goes out: rows of whole millimetres.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor
from typing import Final, NamedTuple

from catalogs.entries import Side
from catalogs.fronts import floor_before
from catalogs.schema import FurnitureSpec
from catalogs.shapes import Solid
from solver.geometry import to_mm

WEIGHED: Final = 1.0
"""Floor that is worth so much is weighed together with the piece's place."""
HALF_OPEN: Final = 1.0
"""What it costs a piece that its fronts open no more than half of their way."""


class FloorAbout(NamedTuple):
    """Floor at a side of a kind, as `Comfort` of solver/core/furnish/room_type.hpp: lengths in mm.

    Where fronts `open` over it, they open wholly where it is as deep as `depth`, half of their way where it is `half`; it reaches from
    `left` to `right` of the kind's middle, and from `above` its underside on.
    """

    side: Side
    opens: bool
    depth: int
    behind: int
    cost: float
    half: int = 0
    left: int = 0
    right: int = 0
    above: int = 0


def floors_about(spec: FurnitureSpec, solids: Sequence[Solid]) -> tuple[FloorAbout, ...]:
    """Returns the floor that is better kept free about a kind, what its fronts open over last.

    Floor at its front that is worth much and as deep as its fronts need takes their place.

    Args:
        spec: the kind.
        solids: its shape, a tuple.
    """
    wished = [FloorAbout(side, False, to_mm(one.depth), to_mm(one.behind), one.cost) for side, one in spec.comfort.items()]
    fronts = floor_before(solids, spec.size)
    if fronts is None:
        return tuple(wished)
    depth, half = ceil(fronts.depth * 1000), ceil(fronts.half * 1000)
    for one in wished:
        if one.side == "front" and one.cost >= WEIGHED and one.depth >= depth:
            aside = to_mm(spec.size[0]) // 2
            wished.remove(one)
            return (*wished, FloorAbout("front", True, one.depth, 0, one.cost, half, -aside, aside))
    left, right = floor(fronts.left * 1000), ceil(fronts.right * 1000)
    return (*wished, FloorAbout("front", True, depth, 0, HALF_OPEN, half, left, right, floor(fronts.above * 1000)))
