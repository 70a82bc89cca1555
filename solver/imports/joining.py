"""Fifth step: openings as they are drawn -> openings in the walls of the rooms that they join.

An opening belongs to the two faces that lie within one wall of it. It is shifted or shortened where it would leave its wall; one that
has no wall is left out, and said.
"""

import math
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass
from typing import Final, Literal

from solver.imports.drawn import DrawnOpening, PlanNotes
from solver.imports.rectilinear import PlanEdge

REACH: Final = 300
"""How far from its wall's line an opening may be drawn, mm, beside half the wall."""
THICKEST_JOINED: Final = 750
"""How far apart the lines of two rooms may be that a door joins, mm."""
CROSSED: Final = 10
"""How far the lines of two rooms may lie beyond each other, mm, where a room with a stub of wall keeps its own."""
NARROWEST: Final = {"door": 500, "garage_door": 1500, "passage": 400, "window": 200}
"""An opening that is left with less, mm, is none."""
TOLD: Final = 10
"""An opening that is shifted or shortened by more, mm, is told of."""
HEIGHTS: Final = {"door": 2.1, "garage_door": 2.2, "passage": 2.2, "window": 1.2}
"""How high openings are, m, where the file does not say."""
THINNEST: Final = 100
"""What is drawn narrower, mm, is no opening."""
SILLS: Final = {"door": 0.0, "garage_door": 0.0, "passage": 0.0, "window": 0.9}


@dataclass(frozen=True)
class Joined:
    """An opening in its wall: `low` to `high` along it, in the edges of one room, or of two; mm."""

    drawn: DrawnOpening
    low: int
    high: int
    edges: tuple[PlanEdge, ...]
    hinge: Literal["start", "end"] | None
    towards: int | None


def joined(
    openings: Sequence[DrawnOpening], edges: Sequence[Sequence[PlanEdge]], ids: Sequence[str], half: int, notes: PlanNotes
) -> list[Joined]:
    """Returns openings in mm in the walls of rooms, whose edges and ids in the file are given; `half` is half the usual wall, mm.

    What was shifted, shortened and left out is noted.
    """
    by_axis = {axis: [edge for room in edges for edge in room if edge.axis == axis] for axis in ("x", "z")}
    found = []
    for opening in openings:
        kind, width = opening.kind.replace("_", " "), math.dist(opening.start, opening.end)
        if width < THINNEST:
            notes.leave(opening.where, f"a {kind} {width / 1000:.2f} m wide: a part of one, such as its frame")
            continue
        named = {number for number, id in enumerate(ids) if id and id in opening.rooms}
        one = _joined(opening, by_axis, named, half)
        if isinstance(one, str):
            notes.leave(opening.where, f"a {kind} without a wall: {one}")
            continue
        _tell(opening, one, notes)
        found.append(one)
    return found


def _joined(opening: DrawnOpening, by_axis: Mapping[str, Sequence[PlanEdge]], named: Set[int], half: int) -> Joined | str:
    """Returns an opening in its walls, of the rooms that it names if any, or why it has none."""
    (x0, z0), (x1, z1) = opening.start, opening.end
    axis = "x" if abs(x1 - x0) >= abs(z1 - z0) else "z"
    along = 0 if axis == "x" else 1
    line = (opening.start[1 - along] + opening.end[1 - along]) / 2
    low, high = sorted((round(opening.start[along]), round(opening.end[along])))
    here = [edge for edge in by_axis[axis] if not named or edge.room in named]
    here = [edge for edge in here if _common(edge, low, high) >= min(high - low, NARROWEST[opening.kind]) / 2]
    if not here:
        return "no room has a wall along it"
    first = min(here, key=lambda edge: (abs(edge.at - line), -_common(edge, low, high), edge.room, edge.side))
    if abs(first.at - line) > REACH + half:
        return f"the nearest is {abs(first.at - line) / 1000:.2f} m away"
    others = [
        edge for edge in here
        if edge.out == -first.out and edge.room != first.room and -CROSSED <= (edge.at - first.at) * first.out <= THICKEST_JOINED
    ]  # fmt: skip
    other = min(others, key=lambda edge: (abs(edge.at - first.at), -_common(edge, low, high), edge.room, edge.side), default=None)
    walls = (first,) if other is None else (first, other)
    least, most = max(edge.low for edge in walls), min(edge.high for edge in walls)
    width = min(high - low, most - least)
    if width < min(NARROWEST[opening.kind], high - low):
        if other is None or _common(first, low, high) < NARROWEST[opening.kind]:
            return f"its wall is {max(width, 0) / 1000:.2f} m long"
        walls, least, most = (first,), first.low, first.high
        width = min(high - low, most - least)
    start = min(max(low, least), most - width)
    hinge = opening.hinge
    if hinge is not None and opening.start[along] > opening.end[along]:
        hinge = "end" if hinge == "start" else "start"
    towards = None if opening.towards is None else (1 if opening.towards[1 - along] > line else -1)
    return Joined(opening, start, start + width, tuple(sorted(walls, key=lambda edge: edge.room)), hinge, towards)


def _common(edge: PlanEdge, low: int, high: int) -> int:
    return min(edge.high, high) - max(edge.low, low)


def _tell(opening: DrawnOpening, one: Joined, notes: PlanNotes) -> None:
    along = 0 if one.edges[0].axis == "x" else 1
    low, high = sorted((round(opening.start[along]), round(opening.end[along])))
    shift, less = abs((one.low + one.high) - (low + high)) / 2, (high - low) - (one.high - one.low)
    words = one.drawn.kind.replace("_", " ")
    if less > TOLD:
        notes.change("join", one.drawn.where, less / 1000, f"a {words} is {less} mm narrower than drawn, as its wall is no longer")
    elif shift > TOLD:
        notes.change("join", one.drawn.where, shift / 1000, f"a {words} is shifted by {shift:.0f} mm along its wall, so that it lies in it")
