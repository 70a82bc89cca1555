"""Hard requirements: difference rows, and choices of one row out of four.

A row says p_j - p_i >= s along one axis, in integer millimetres. Variable ORIGIN stands for the constant 0, so that a
bound is a row as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

from solver.geometry import Rect

ORIGIN: Final = -1
X: Final = 0
Z: Final = 1


class Row(NamedTuple):
    """p_j - p_i >= s, along `axis`, mm."""

    axis: int
    i: int
    j: int
    s: int

    def slack(self, p: Sequence[Sequence[float]]) -> float:
        """Returns how far the row is satisfied (< 0: violated) at positions p[axis][variable], mm."""
        own = p[self.axis]
        after = 0 if self.j == ORIGIN else own[self.j]
        before = 0 if self.i == ORIGIN else own[self.i]
        return after - before - self.s


class Part(NamedTuple):
    """A box of the problem: a body, or a stand (a person's square before a use side).

    Its min corner along axis a is position[var[a]] + offset[a]; `extent` is its size along x and z; mm.
    """

    label: str
    stand: bool
    var: tuple[int, int]
    offset: tuple[int, int]
    extent: tuple[int, int]
    bottom: int
    top: int

    def rect(self, p: Sequence[Sequence[int]]) -> Rect:
        """Returns the footprint at integer positions p[axis][variable], mm."""
        x, z = p[X][self.var[X]] + self.offset[X], p[Z][self.var[Z]] + self.offset[Z]
        return Rect(x, z, x + self.extent[X], z + self.extent[Z])


class Choice(NamedTuple):
    """One of `options` must hold: `first` is left of, right of, north of or south of `second`."""

    first: str
    second: str
    options: tuple[Row, ...]


def apart(a: Part, b: Part) -> tuple[Row, ...]:
    """Returns the four rows that separate two boxes: a left of, right of, north of, south of b."""
    rows = []
    for axis in (X, Z):
        for first, second in ((a, b), (b, a)):
            s = first.extent[axis] + first.offset[axis] - second.offset[axis]
            rows.append(Row(axis, first.var[axis], second.var[axis], s))
    return tuple(rows)


def clear_of(a: Part, rect: Rect) -> tuple[Row, ...]:
    """Returns the four rows that keep a box out of a fixed rectangle."""
    rows = []
    for axis, (low, high) in ((X, (rect.x0, rect.x1)), (Z, (rect.z0, rect.z1))):
        rows.append(Row(axis, a.var[axis], ORIGIN, a.extent[axis] + a.offset[axis] - low))
        rows.append(Row(axis, ORIGIN, a.var[axis], high - a.offset[axis]))
    return tuple(rows)
