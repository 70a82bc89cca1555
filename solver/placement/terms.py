"""Soft wishes: each term can say its cost and add itself to a quadratic programme of one axis.

Positions are min corners in metres; `p[i]` is variable i of the term's axis. A programme is
minimise 1/2 p'Hp + f'p + constant, so that its value is the sum of the terms' costs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Anchor(NamedTuple):
    """weight * (p_i - wish)^2: a body wants to be at its anchor.

    Args:
        axis: 0 for x, 1 for z.
        i: the variable.
        wish: wished min corner, m.
        weight: m^-2, > 0.
    """

    axis: int
    i: int
    wish: float
    weight: float

    def cost(self, p: Sequence[float]) -> float:
        """Returns the term's value at positions p, m."""
        return self.weight * (p[self.i] - self.wish) ** 2

    def add_to(self, H: Floats, f: Floats) -> float:
        """Adds the term to H and f and returns its constant."""
        H[self.i, self.i] += 2 * self.weight
        f[self.i] -= 2 * self.weight * self.wish
        return self.weight * self.wish**2


class Pull(NamedTuple):
    """weight * (p_j - p_i - offset)^2: two bodies want to keep a distance along an axis."""

    axis: int
    i: int
    j: int
    offset: float
    weight: float

    def cost(self, p: Sequence[float]) -> float:
        """Returns the term's value at positions p, m."""
        return self.weight * (p[self.j] - p[self.i] - self.offset) ** 2

    def add_to(self, H: Floats, f: Floats) -> float:
        """Adds the term to H and f and returns its constant."""
        i, j, w = self.i, self.j, 2 * self.weight
        H[i, i] += w
        H[j, j] += w
        H[i, j] -= w
        H[j, i] -= w
        f[j] -= w * self.offset
        f[i] += w * self.offset
        return self.weight * self.offset**2


Term = Anchor | Pull
