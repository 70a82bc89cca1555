"""The floor about a kind of furniture that is better kept free: what its catalog says, and what its fronts open over."""

from collections.abc import Callable, Mapping, Sequence
from math import ceil, floor
from typing import Final, NamedTuple

from catalogs.access_profiles import AccessProfile, AccessRule
from catalogs.entries import Comfort, Side
from catalogs.fronts import FrontFloor, floor_before
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
    `left` to `right` of the kind's middle, and from `above` its underside on; `along_side` tells that the edge of a door goes along one of
    the kind's sides. What a standard asks for is numbered by `asked`; at the `other` side it will do as well; it begins `off` the side.
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
    asked: int = 0
    other: Side | None = None
    off: int = 0
    along_side: bool = False


def floors_about(spec: FurnitureSpec, solids: Sequence[Solid]) -> tuple[FloorAbout, ...]:
    """Returns the floor that is better kept free about a kind with this shape, what its fronts open over last.

    Floor at its front that is worth much and as deep as its fronts need takes their place.
    """
    width, own = (to_mm(length) for length in spec.size[:2])
    wished = [_wished(side, one, width if side in _LONG else own) for side, one in spec.comfort.items()]
    fronts = floor_before(solids, spec.size)
    if fronts is None:
        return tuple(wished)
    depth, half = (_beside(own, ceil(length * 1000)) for length in (fronts.depth, fronts.half))
    for one in wished:
        if one.side == "front" and not one.off and one.cost >= WEIGHED and one.depth >= depth:
            aside = width // 2
            wished.remove(one)
            return (*wished, FloorAbout("front", True, one.depth, 0, one.cost, half, -aside, aside, along_side=fronts.along_side))
    left, right = _aside(fronts)
    over = FloorAbout("front", True, depth, 0, HALF_OPEN, half, left, right, floor(fronts.above * 1000), along_side=fronts.along_side)
    return (*wished, over)


def _wished(side: Side, wish: Comfort, own: int) -> FloorAbout:
    """Returns the floor that a kind, so long across that side, wishes for there."""
    depth, behind = _beside(own, to_mm(wish.depth)), to_mm(wish.behind)
    return FloorAbout(side, False, depth, behind, wish.cost) if side in _LONG else FloorAbout(side, False, depth, 0, wish.cost, off=behind)


def _beside(own: int, depth: int) -> int:
    """Returns a depth with which floor that touches a piece so long has its middle on a whole millimetre, and not within the piece."""
    return depth + (own + depth) % 2


def _aside(fronts: FrontFloor) -> tuple[int, int]:
    """Returns from where to where fronts open over the floor before them; its middle is a whole millimetre."""
    left, right = floor(fronts.left * 1000), ceil(fronts.right * 1000)
    odd = (right - left) % 2
    return (left, right + odd) if right < -left else (left - odd, right)


def asked_about(profile: AccessProfile, room: str, name: str) -> tuple[FloorAbout, ...]:
    """Returns the strips of floor that a profile asks for about a piece of a name in a room of a type, numbered from 1."""
    rules = [rule for rule in profile.rules if name in rule.pieces and rule.is_about(room)]
    strips = [strip for rule in rules for strip in _STRIPS[rule.what](rule)]
    return tuple(strip._replace(asked=number) for number, strip in enumerate(strips, start=1))


def _along(rule: AccessRule) -> tuple[FloorAbout, ...]:
    least, other = to_mm(rule.min), to_mm(rule.other or 0.0)
    each = [FloorAbout(side, False, other, 0, 0.0) for side in _LONG]
    wide = [FloorAbout(_LONG[0], False, least, 0, 0.0, other=_LONG[1])] if least > other else []
    if not rule.beside:
        return (*each, *wide)
    behind, off = (to_mm(length) for length in BESIDE)
    return tuple(part for one in (*each, *wide) for part in (one._replace(behind=behind), one._replace(off=min(off, one.depth))))


def _before(rule: AccessRule) -> tuple[FloorAbout, ...]:
    half = to_mm(rule.min) // 2 + to_mm(rule.min) % 2
    return (FloorAbout("front", False, to_mm(rule.deep or 0.0), 0, 0.0, left=-half, right=half),)


def _deep(rule: AccessRule) -> tuple[FloorAbout, ...]:
    return (FloorAbout("front", False, to_mm(rule.min), 0, 0.0),)


_LONG: Final[tuple[Side, Side]] = ("left", "right")
BESIDE: Final = (0.6, 0.55)
"""What may stand beside a piece takes so much of the strips along it: from the piece's back on, and from its side, m."""
_STRIPS: Final[Mapping[str, Callable[[AccessRule], tuple[FloorAbout, ...]]]] = {
    "along": _along,
    "before": _before,
    "deep": _deep,
}
