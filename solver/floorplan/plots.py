"""A rectangle still to be cut, and which of its sides lie on a hallway.

Axes: "x" runs west to east, "z" north to south; a cut across an axis divides the rectangle's extent along it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from solver.geometry import Rect

ENDS: Final = {"x": ("west", "east"), "z": ("north", "south")}
"""The two sides at the ends of an axis: a cut across it gives one to each child."""
ACROSS: Final = {"x": ("north", "south"), "z": ("west", "east")}
"""The two sides that a cut across an axis crosses: both children keep a part of each."""
ASPECT: Final = 2
"""Longest side over shortest that a cut may leave."""
OTHER: Final = {"x": "z", "z": "x"}


def span(rect: Rect, axis: str) -> tuple[int, int]:
    """Returns a rectangle's extent along an axis, mm."""
    return (rect.x0, rect.x1) if axis == "x" else (rect.z0, rect.z1)


def halves(rect: Rect, axis: str, at: int) -> tuple[Rect, Rect]:
    """Cuts a rectangle across an axis ("x": into west and east, "z": into north and south) at a coordinate, mm."""
    if axis == "x":
        return Rect(rect.x0, rect.z0, at, rect.z1), Rect(at, rect.z0, rect.x1, rect.z1)
    return Rect(rect.x0, rect.z0, rect.x1, at), Rect(rect.x0, at, rect.x1, rect.z1)


@dataclass(frozen=True)
class Plot:
    """A rectangle still to be cut.

    `halls` are its sides that lie on a hallway over their whole length; `path` is 0 or 1 for every cut that led to it;
    `role` says what a column was cut off for: "suite", "public", "alcove" or nothing yet.
    """

    rect: Rect
    halls: frozenset[str]
    path: str
    role: str = ""

    @property
    def half(self) -> str:
        """Which side of the spine it lies on."""
        return self.path[0]

    @property
    def order(self) -> tuple[bool, int, str]:
        """What is cut first: what others rely on being cut (a role, a slim plot), then the largest."""
        short, long = sorted((self.rect.width, self.rect.depth))
        return not self.role and long <= ASPECT * short, -short * long, self.path

    @property
    def run(self) -> str:
        """The axis along its hallway (along x where it has one on either kind of side)."""
        return "x" if "north" in self.halls or "south" in self.halls else "z"

    def length(self, axis: str) -> int:
        """Extent along an axis, mm."""
        return self.rect.width if axis == "x" else self.rect.depth

    def keeps(self, axis: str) -> bool:
        """Tells whether both children of a cut across the axis still touch a hallway."""
        halls = self.halls
        return any(side in halls for side in ACROSS[axis]) or all(side in halls for side in ENDS[axis])

    def child(self, rect: Rect, axis: str, end: int, role: str = "") -> Plot:
        """Returns the child at one end (0: west or north) of a cut across the axis."""
        return Plot(rect, self.halls - {ENDS[axis][1 - end]}, self.path + str(end), role)

    def beside_hallway(self, rect: Rect, axis: str, end: int) -> Plot:
        """Returns the child at one end of a cut whose line becomes a hallway."""
        return Plot(rect, self.halls | {ENDS[axis][1 - end]}, self.path + str(end))
