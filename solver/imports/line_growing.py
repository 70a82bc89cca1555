"""Fourth step: rooms' inner faces -> rooms along the lines of their walls: half the thinnest wall outside of their faces.

Two faces of different rooms that look at each other across at most 0.75 m, or what the usual wall measures, are one wall. Where it is
as thin as any its line runs in its middle; of a thicker one each room has a line of its own.
"""

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Final

from solver.imports.rectilinear import FloorCorners, PlanEdge, edges_of_corners, tidied, weighted_median

THICKEST: Final = 750
"""Of a wall between two rooms, mm, where the usual one is no thicker."""
FACING: Final = 100
"""Faces of one wall overlap by at least so much, mm."""
NEAR_LINES: Final = 10
"""Wall lines no farther apart, mm, are one; and walls are as thin as any that are thicker by no more."""
ALIKE: Final = 25
"""The thinnest wall is the usual one of those that are thicker than the thinnest by no more, mm: plans are not drawn to the millimetre."""
THINNEST: Final = 40
"""What is thinner, mm, is no wall."""


@dataclass(frozen=True)
class Grown:
    """Rooms along wall lines: corners by room, the thinnest wall (mm), and for each room how far outside of the face each line is."""

    corners: list[FloorCorners]
    thickness: int
    moved: list[list[int]]


def grown(edges: Sequence[Sequence[PlanEdge]], thickness: int | None) -> Grown:
    """Returns rooms, given by their edges along inner faces, clockwise, grown to the lines of their walls.

    `thickness` is that of the walls, mm, where the file says it.
    """
    pairs = _pairs(edges, max(THICKEST, thickness or 0))
    gaps = [one for one in _gaps(pairs) if one[0] >= THINNEST]
    usual = int(weighted_median(one for one in gaps if one[0] <= gaps[0][0] + ALIKE)) if gaps else thickness or 0
    lines = _lines([pair for pair in pairs if pair[1].at - pair[0].at <= usual + NEAR_LINES])
    for room in edges:
        for edge in room:
            lines.setdefault((edge.room, edge.side), edge.at + edge.out * (usual // 2))
    _gather(edges, lines)
    moved = [[(lines[edge.room, edge.side] - edge.at) * edge.out for edge in room] for room in edges]
    corners = [_rebuilt(room, [lines[edge.room, edge.side] for edge in room], usual) for room in edges]
    return Grown(corners, usual, moved)


def usual_gap(rooms: Sequence[FloorCorners]) -> int:
    """Returns how far apart rooms that are neighbours lie, mm: 0 where they are drawn along lines, or where there are none."""
    return int(weighted_median(_gaps(_pairs([edges_of_corners(number, corners) for number, corners in enumerate(rooms)], THICKEST))))


def _gaps(pairs: Sequence[tuple[PlanEdge, PlanEdge, int]]) -> list[tuple[int, int]]:
    """Returns how far apart pairs lie, and over how much of their length, the nearest first."""
    return sorted((b.at - a.at, overlap) for a, b, overlap in pairs)


def _pairs(rooms: Sequence[Sequence[PlanEdge]], thickest: int) -> list[tuple[PlanEdge, PlanEdge, int]]:
    """Returns the edges that see each other across a wall, the nearer first, and over how much of their length."""
    found, edges = [], [edge for room in rooms for edge in room]
    for axis in ("x", "z"):
        facing = sorted((one for one in edges if one.axis == axis and one.out < 0), key=lambda one: one.at)
        starts = [one.at for one in facing]
        for edge in (one for one in edges if one.axis == axis and one.out > 0):
            seen = [(edge.low, edge.high)]
            for other in facing[bisect_left(starts, edge.at) :]:
                if other.at - edge.at > thickest or not seen:
                    break
                overlap = sum(max(0, min(high, other.high) - max(low, other.low)) for low, high in seen)
                if overlap >= FACING:
                    seen = [left for part in seen for left in _without(part, (other.low, other.high))]
                    if other.room != edge.room:
                        found.append((edge, other, overlap))
    return found


def _without(part: tuple[int, int], taken: tuple[int, int]) -> list[tuple[int, int]]:
    ends = ((part[0], min(part[1], taken[0])), (max(part[0], taken[1]), part[1]))
    return [(low, high) for low, high in ends if low < high]


def _lines(pairs: Sequence[tuple[PlanEdge, PlanEdge, int]]) -> dict[tuple[int, int], int]:
    """Returns the line of every edge that faces another room: edges joined by walls have one in common.

    Where a wall goes on as a border between two rooms without one, the wall tells.
    """
    heads: dict[tuple[int, int], tuple[int, int]] = {}

    def head(key: tuple[int, int]) -> tuple[int, int]:
        while heads.setdefault(key, key) != key:
            heads[key] = heads[heads[key]]
            key = heads[key]
        return key

    for a, b, _ in pairs:
        heads[head((a.room, a.side))] = head((b.room, b.side))
    walls: dict[tuple[int, int], list[tuple[PlanEdge, PlanEdge, int]]] = defaultdict(list)
    for pair in pairs:
        walls[head((pair[0].room, pair[0].side))].append(pair)
    lines = {}
    for wall in walls.values():
        drawn = [pair for pair in wall if pair[1].at - pair[0].at >= THINNEST] or wall
        weight = sum(overlap for *_, overlap in drawn)
        line = round(sum((a.at + b.at) / 2 * overlap for a, b, overlap in drawn) / weight)
        line = min(max(line, *(a.at for a, *_ in drawn)), *(b.at for _, b, _ in drawn))
        for a, b, _ in wall:
            lines[a.room, a.side] = lines[b.room, b.side] = line
    return lines


def _gather(edges: Sequence[Sequence[PlanEdge]], lines: dict[tuple[int, int], int]) -> None:
    """Gives wall lines that nearly meet one coordinate."""
    for axis in ("x", "z"):
        ordered = sorted((edge for room in edges for edge in room if edge.axis == axis), key=lambda edge: lines[edge.room, edge.side])
        values = [lines[edge.room, edge.side] for edge in ordered]
        start = 0
        for at in range(1, len(ordered) + 1):
            if at < len(ordered) and values[at] - values[start] <= NEAR_LINES:
                continue
            line = int(weighted_median((value, edge.length) for value, edge in zip(values[start:at], ordered[start:at], strict=True)))
            for edge in ordered[start:at]:
                lines[edge.room, edge.side] = line
            start = at


def _rebuilt(edges: Sequence[PlanEdge], lines: Sequence[int], usual: int) -> FloorCorners:
    """Returns a room's corners along its lines; where those would fold it, parted ones; else along lines half a usual wall away."""
    for moved in (lines, _parted(edges, lines), [edge.at + edge.out * (usual // 2) for edge in edges], [edge.at for edge in edges]):
        placed = [edge._replace(at=at) for edge, at in zip(edges, moved, strict=True)]
        corners = [_corner(edge, placed[at - 1]) for at, edge in enumerate(placed)]
        following = [*corners[1:], *corners[:1]]
        ways = [_way(a, b) for a, b in zip(corners, following, strict=True)]
        if all(way in (0, _forwards(edge)) for way, edge in zip(ways, edges, strict=True)):
            return tidied(corners)
    return tidied([_corner(edge, edges[at - 1]) for at, edge in enumerate(edges)])


def _parted(edges: Sequence[PlanEdge], lines: Sequence[int]) -> list[int]:
    """Returns lines of which those on both sides of a stub of wall within one room do not pass each other: they lie in its middle."""
    found = list(lines)
    for a, b in product((one for one in edges if one.out > 0), (one for one in edges if one.out < 0)):
        is_stub = a.axis == b.axis and a.at < b.at and min(a.high, b.high) > max(a.low, b.low)
        if is_stub and lines[a.side] >= lines[b.side]:
            middle = (a.at + b.at) // 2
            found[a.side], found[b.side] = min(found[a.side], middle), max(found[b.side], middle + 1)
    return found


def _corner(edge: PlanEdge, before: PlanEdge) -> tuple[int, int]:
    return (before.at, edge.at) if edge.axis == "x" else (edge.at, before.at)


def _way(a: tuple[int, int], b: tuple[int, int]) -> int:
    along = (b[0] - a[0]) + (b[1] - a[1])
    return (along > 0) - (along < 0)


def _forwards(edge: PlanEdge) -> int:
    """Returns which way along its axis an edge is walked clockwise."""
    return -edge.out if edge.axis == "x" else edge.out
