"""Rooms with holes, such as around a core: outlines that are cut open from each hole to a wall, as a scene's rooms have none."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from solver.geometry import doubled_area, edges_round
from solver.imports.drawn import DrawnOpening, DrawnRoom, PlanNotes, Spot

Slit = tuple[Spot, Spot]
CUT: Final = 100.0
"""How wide the cut is, mm."""
SMALLEST: Final = 500_000.0
"""A hole that is smaller, mm2, is a column."""
LEVEL: Final = 0.02
"""A side runs along an axis that leaves it by no more than this share of its length."""


def cut_open(room: DrawnRoom, openings: Sequence[DrawnOpening], notes: PlanNotes) -> DrawnRoom:
    """Returns a room in mm without holes, cut where no opening is, if it can be; notes what was done about each.

    Of a room that is cut nothing says how thick its outer walls are: its sides are others.
    """
    points, holes = room.points, list(room.holes)
    doors = [(one.start, one.end) for one in openings]
    while holes:
        cuts = [
            (_is_at(cut, doors), math.dist(*cut), at, cut, made)
            for at, hole in enumerate(holes)
            for cut, made in _cuts(points, hole, [*holes[:at], *holes[at + 1 :]])
        ]
        if not cuts:
            break
        _, length, at, _, points = min(cuts, key=lambda cut: cut[:3])
        del holes[at]
        notes.change("read", room.where, length / 1000, "a hole in a room: it is cut open from there to the nearest wall")
    for _ in holes:
        notes.leave(room.where, "a hole in a room that is smaller than 0.5 m2, or has no straight side: it is floor")
    outer = room.outer if points is room.points else ()
    return replace(room, points=tuple(points), holes=(), outer=outer)


def _is_at(cut: Slit, doors: Sequence[Slit]) -> bool:
    """Tells whether a cut begins or ends in a door."""
    return any(math.dist(a, spot) + math.dist(spot, b) <= math.dist(a, b) + 2 * CUT for a, b in doors for spot in cut)


def _cuts(points: Sequence[Spot], hole: Sequence[Spot], others: Sequence[Sequence[Spot]]) -> Iterator[tuple[Slit, tuple[Spot, ...]]]:
    """Yields the cuts from a hole's sides to sides of an outline, and the outline that each makes."""
    area = doubled_area(hole)
    if abs(area) < 2 * SMALLEST:
        return
    ring = tuple(hole) if (area > 0) != (doubled_area(points) > 0) else tuple(reversed(hole))
    for at, (a, b) in enumerate(edges_round(ring)):
        along = 0 if abs(b[0] - a[0]) >= abs(b[1] - a[1]) else 1
        middle, run = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), b[along] - a[along]
        if abs(run) < 2 * CUT or abs(b[1 - along] - a[1 - along]) > LEVEL * abs(run):
            continue
        way = (1 if along else -1) * (1 if run > 0 else -1) * (1 if doubled_area(ring) > 0 else -1)
        hits = [(way * (line - middle[1 - along]), place) for place, line in _crossed(points, along, middle[along])]
        ahead = min((hit for hit in hits if hit[0] > 0), default=None)
        between = [way * (line - middle[1 - along]) for other in (*others, ring) for _, line in _crossed(other, along, middle[along])]
        if ahead and not any(0 < one < ahead[0] for one in between):
            made = _joined(points, ahead[1], (*ring[at:], *ring[:at]), along, middle[along])
            if made:
                far = middle[1 - along] + way * ahead[0]
                yield (middle, (middle[0], far) if along == 0 else (far, middle[1])), made


def _crossed(points: Sequence[Spot], along: int, at: float) -> Iterator[tuple[int, float]]:
    """Yields the sides that a line across an axis meets there, and where."""
    for place, (a, b) in enumerate(edges_round(points)):
        if min(a[along], b[along]) <= at < max(a[along], b[along]):
            yield place, a[1 - along] + (b[1 - along] - a[1 - along]) * (at - a[along]) / (b[along] - a[along])


def _joined(points: Sequence[Spot], place: int, ring: Sequence[Spot], along: int, middle: float) -> tuple[Spot, ...] | None:
    """Returns an outline that goes on round a hole behind a cut to its first side; None where the side is too short for it, or slanted."""
    a, b = points[place], points[(place + 1) % len(points)]
    low, high = sorted((a[along], b[along]))
    if not low + CUT <= middle <= high - CUT or abs(b[1 - along] - a[1 - along]) > LEVEL * (high - low):
        return None
    ahead = CUT / 2 if b[along] > a[along] else -CUT / 2
    c = ring[0]

    def spot(by: float, line: float) -> Spot:
        return (middle + by, line) if along == 0 else (line, middle + by)

    cut = (spot(-ahead, a[1 - along]), spot(-ahead, c[1 - along]), *ring[1:], c, spot(ahead, c[1 - along]), spot(ahead, a[1 - along]))
    return (*points[: place + 1], *cut, *points[place + 1 :])
