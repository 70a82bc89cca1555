"""The sides of another piece, for the oracle of `place_oracle`: what stands at which of them, how far off."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from tests.programme import Expr, Programme

GAP = 0.02
ROTATIONS = (0, 90, 180, 270)
FRONT = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
GAPS = {"beside": (0.0, 0.3), "in_front_of": (0.0, 0.7), "around": (-9.0, 0.3), "under": (-9.0, -0.01), "in_row": (0.0, 0.02)}
"""Free space between the footprints where no gap is given, m."""


@dataclass
class Placed:
    """A piece's expressions: min corner, extents, rotation binaries."""

    name: str
    low: tuple[Expr, Expr]
    extent: tuple[Expr, Expr]
    turn: dict[int, Expr]
    height: float
    at_wall: bool

    def high(self, axis: int) -> Expr:
        return self.low[axis] + self.extent[axis]

    def middle(self, axis: int) -> Expr:
        return self.low[axis] + self.extent[axis].times(0.5)


def between(p: Programme, expr: Expr, least: float, most: float, *when: Expr) -> None:
    p.at_least(expr, least, *when)
    p.at_least(-expr, -most, *when)


def at_sides(p: Programme, pair: tuple[Placed, Placed], relation: dict[str, Any], sides: Sequence[str], turned: bool) -> list[Expr]:
    own, other = pair
    low, high = GAPS[relation["type"]]
    if "gap" in relation:
        low, high = relation["gap"][0] - GAP, relation["gap"][1] + GAP
    options = []
    for r, (fx, fz) in FRONT.items():
        for side in sides:
            dx, dz = {"front": (fx, fz), "back": (-fx, -fz), "left": (-fz, fx), "right": (fz, -fx)}[side]
            axis, sign = (0, dx) if dx else (1, dz)
            gap = own.low[axis] - other.high(axis) if sign > 0 else other.low[axis] - own.high(axis)
            for longer in (own, other):
                option = p.binary()
                options.append(option)
                p.at_least(other.turn[r], 1.0, option)
                between(p, gap, low, high, option)
                aside = own.middle(1 - axis) - other.middle(1 - axis)
                half = longer.extent[1 - axis].times(0.5)
                p.at_least(half - aside, 0.0, option)
                p.at_least(half + aside, 0.0, option)
                if turned:
                    p.at_least(own.turn[next(q for q in ROTATIONS if FRONT[q] == (-dx, -dz))], 1.0, option)
                    p.at_least(gap + 0.0, -_depth(own, axis), option)
    return options


def _depth(own: Placed, axis: int) -> float:
    return min(value for key, value in own.extent[axis].items() if key >= 0) - 0.15
