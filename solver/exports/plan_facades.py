"""Dimensions outside a plan: for each side of the house a chain over its openings, one over its rooms, and the whole."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, Literal

from solver.exports.model import FloorPlate, PlacedOpening
from solver.exports.plan_rooms import Dimension, PlanBox, number_box
from solver.geometry import INWARDS, walls_round

NEAREST: Final = 0.05
"""Marks of a chain that are closer than this, m, are one."""
Facade = Literal["north", "west", "south", "east"]
SIDES: Final[tuple[Facade, ...]] = ("north", "west", "south", "east")


@dataclass(frozen=True)
class Facades:
    """A storey seen from outside: its floors, its openings, half the usual thickness of its walls and the boxes of those, m."""

    plates: Sequence[FloorPlate]
    openings: Sequence[PlacedOpening]
    half: float
    walls: Sequence[PlanBox] = ()

    def bounds(self) -> PlanBox:
        """Returns what the storey covers, outer walls included."""
        xs = [x for plate in self.plates for x, _ in plate.corners]
        zs = [z for plate in self.plates for _, z in plate.corners]
        lines = min(xs) - self.half, min(zs) - self.half, max(xs) + self.half, max(zs) + self.half
        x0, z0, x1, z1 = zip(lines, *self.walls, strict=True)
        return min(x0), min(z0), max(x1), max(z1)


def chains_of(facades: Facades, gap: float) -> list[Dimension]:
    """Returns the chains of all four sides, `gap` metres apart, the first twice as far from the walls; the whole is north and west."""
    x0, z0, x1, z1 = facades.bounds()
    found = []
    for side in SIDES:
        axis: Literal["x", "z"] = "x" if side in ("north", "south") else "z"
        low, high = (x0, x1) if axis == "x" else (z0, z1)
        rows = [stops for stops in (_openings(facades, side, low, high), _rooms(facades, side, low, high)) if len(stops) > 2]
        if side in ("north", "west"):
            rows.append((low, high))
        edge, away = {"north": (z0, -1), "south": (z1, 1), "west": (x0, -1), "east": (x1, 1)}[side]
        found += [chain(axis, edge + away * gap * (index + 1.6), stops) for index, stops in enumerate(dict.fromkeys(rows))]
    return found


def chain(axis: Literal["x", "z"], at: float, stops: tuple[float, ...]) -> Dimension:
    """Returns a chain with its numbers in the middle of their lengths."""
    return Dimension(axis, at, stops, tuple((a + b) / 2 for a, b in pairwise(stops)))


def too_short(metres: float, size: float) -> bool:
    """Tells whether a number does not fit over its own length."""
    return number_box(metres, size)[0] > metres * 0.96


def _openings(facades: Facades, side: Facade, low: float, high: float) -> tuple[float, ...]:
    axis = "x" if side in ("north", "south") else "z"
    indoors = {plate.id for plate in facades.plates if not plate.outdoor}
    stops = [low, high]
    for opening in facades.openings:
        greater, smaller = opening.rooms
        inside, outside = (greater, smaller) if side in ("north", "west") else (smaller, greater)
        if opening.axis == axis and inside in indoors and outside not in indoors:
            stops += [opening.start, opening.end]
    return _apart(stops)


def _rooms(facades: Facades, side: Facade, low: float, high: float) -> tuple[float, ...]:
    """Returns where the rooms end that one sees from a side: the lines of the walls between them, outer faces at the ends."""
    walls = ((plate.id, *wall) for plate in facades.plates for wall in walls_round(plate.corners))
    edges = [(start, end, line * INWARDS[side], room) for room, wall, line, start, end in walls if wall == side]
    cuts = sorted({end for edge in edges for end in edge[:2]})
    stops, last = [low, high], None
    for start, end in pairwise(cuts):
        seen = min(((line, room) for a, b, line, room in edges if a <= start and end <= b), default=None)
        if seen != last and last is not None:
            stops.append(start)
        last = seen
    return _apart(stops)


def _apart(stops: Sequence[float]) -> tuple[float, ...]:
    """Returns marks in order, those that nearly meet as one; the outermost stay."""
    low, *middle, high = sorted(stops)
    kept = [low]
    for stop in middle:
        if stop - kept[-1] > NEAREST and high - stop > NEAREST:
            kept.append(stop)
    return (*kept, high)
