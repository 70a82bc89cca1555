"""One room of a scene, to be repaired: what was sent, where it may stand, and on what terms."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from solver.answers import Issue
from solver.geometry import INWARDS, Rect, strip_at
from solver.pieces import Space
from solver.repair.settings import RepairSettings
from solver.scene import Room

Edge = tuple[str, int, int, int]
"""A stretch of wall line: the wall it is part of, its coordinate across, and its ends along, mm."""


@dataclass(frozen=True)
class Walls:
    """The walls of a room, mm: half their thickness, the wall lines, and the rectangle around these, half a wall in (`clear`)."""

    clear: Rect
    half_mm: int
    edges: tuple[Edge, ...]

    @property
    def inner(self) -> list[Edge]:
        """The wall lines of an outline that are not on its bounding rectangle."""
        bounds = self.clear.shrunk(-self.half_mm)
        return [edge for edge in self.edges if edge[1] != bounds.line(edge[0]) and edge[2] < edge[3]]

    def before(self, edge: Edge, deep: int) -> Rect:
        """Returns the rectangle before a stretch of wall, from its face on, `deep` mm into the room."""
        wall, line, start, end = edge
        return strip_at(wall, line + INWARDS[wall] * self.half_mm, (start, end), deep)


@dataclass(frozen=True)
class RoomProblem:
    """A room to be repaired, as sent: where its furniture may stand, at which walls, and what the validator says of it.

    `settings` say what stays, what was moved, where all was in the last answer, and what the repair may cost. `ceiling` is how high it is,
    m; without end where nothing says it, and outdoors.
    """

    room: Room
    space: Space
    walls: Walls
    settings: RepairSettings
    errors: tuple[Issue, ...] = ()
    ceiling: float = inf
