"""Gaps in walls, as doors, windows and passages leave them: an opening that is drawn at one is as wide as it, and a leaf hangs in it.

Comes in: the lines of walls, openings. Goes out: gaps, openings. May import: drawn, wall_faces.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.imports.drawn import DrawnOpening, Spot
from solver.imports.rectilinear import DrawnLine
from solver.imports.shape_openings import DrawnStretch, between, longer_line
from solver.imports.wall_faces import CRACK, RowGap, WallRows, gathered, line_between

BESIDE: Final = 450
"""How far from an opening's line the faces of its wall may lie, mm."""
WIDEST: Final = 1.4
"""The gap at an opening is at most so many times as wide as the opening is drawn."""
WIDTHS: Final = (400, 6000)
"""How wide openings are that nothing tells but their form, mm."""
PASSAGES: Final = (550, 2000)
"""A gap in which nothing is drawn may be a passage if it is as wide, mm."""
THINNEST: Final = 20
"""Of a wall, mm: our own drawings have none thinner."""
THICKEST: Final = 750
"""Of a wall, mm: what is no wider is no room with doors on both sides."""
ALIKE: Final = 60
"""The gaps in the two faces of a wall begin and end no farther from one another, mm."""
LEAVES: Final = ((0.4, 0.6), (0.75, 1.15))
"""A leaf, of two or alone, is between so many times as wide as its gap."""
SLOPED: Final = 0.2
"""An opening along a gap leaves its way by no more than this share of its width."""
FILLING: Final = 0.9
"""Openings that fill a gap together are as wide as this share of it, each with this share of its own in it."""
AT_JAMB: Final = 0.25
"""A leaf hangs no farther from the corner of a gap than this share of its own width: others lie in a wall across the way."""
AT_CORNER: Final = 0.03
"""So it is where nothing says that it is a leaf."""
SLIM: Final = 0.1
"""A leaf is no thicker than this share of its width."""


class WallGap(NamedTuple):
    """A gap along the middle of a wall, in the drawing's unit."""

    start: Spot
    end: Spot
    thickness: float
    in_line: bool
    """Whether its wall goes on behind it; else it leads up to a wall across the way."""
    faces: tuple[DrawnStretch, ...] = ()
    """It in the faces of its wall."""
    is_whole: bool = True
    """Whether it is in both faces of its wall; else nothing hangs in it, but what is drawn at it closes it."""

    @property
    def width(self) -> float:
        """From one piece of wall to the other."""
        return math.dist(self.start, self.end)

    def sides(self, by: float) -> tuple[Spot, Spot]:
        """Returns the points so far before both faces of the wall, before the gap's middle."""
        (x0, z0), (x1, z1) = self.start, self.end
        x, z, away = (x0 + x1) / 2, (z0 + z1) / 2, self.thickness / 2 + by
        across = (0.0, away) if z0 == z1 else (away, 0.0)
        return (x + across[0], z + across[1]), (x - across[0], z - across[1])


def gaps_of(walls: Sequence[Sequence[Spot]], metres: float | None) -> list[WallGap]:
    """Returns the gaps in walls, whose outlines or single lines are given; `metres` is the length of the unit, None: nothing tells."""
    if metres is None or not walls:
        return []
    scale, (west, north) = metres * 1000, walls[0][0]
    moved = [[((x - west) * scale, (z - north) * scale) for x, z in points] for points in walls]
    lines = gathered([line for points in moved for a, b in pairwise(points) if (line := line_between(a, b))])

    def back(one: DrawnLine) -> DrawnStretch:
        ends = ((one.low, one.at), (one.high, one.at)) if one.axis == "x" else ((one.at, one.low), (one.at, one.high))
        start, end = ((x / scale + west, z / scale + north) for x, z in ends)
        return start, end

    found = []
    for gaps, is_whole in _gaps(lines):
        faces = [gap.line for gap in gaps]
        first, last = faces[0], faces[-1]
        middle = DrawnLine(first.axis, (first.at + last.at) // 2, max(first.low, last.low), min(first.high, last.high))
        is_in_line = all(gap.in_line for gap in gaps)
        found.append(WallGap(*back(middle), (last.at - first.at) / scale, is_in_line, tuple(map(back, faces)), is_whole))
    return found


def _gaps(lines: Sequence[DrawnLine]) -> Iterator[tuple[tuple[RowGap, ...], bool]]:
    """Yields each gap that both faces of a wall have, as it is in either, of a single line its own; and what one face alone has."""
    rows = WallRows(lines)
    ends = {(one.axis, one.at, end): one for one in rows.whole() for end in (one.low, one.high)}
    of_faces = {place for place, one in ends.items() if rows.is_face(one, place[2], THINNEST, THICKEST)}
    is_free: dict[RowGap, bool] = {}
    for (axis, at, end), one in ends.items():
        if (gap := rows.gap_at(one, end)) and CRACK < gap.line.high - gap.line.low <= WIDTHS[1]:
            has_faces = any((axis, at, side) in of_faces for side in gap.line[2:])
            is_free[gap] = is_free.get(gap, True) and not (has_faces or rows.is_met(one, end))
    for axis in ("x", "z"):
        yield from _of_both_faces(sorted(gap for gap in is_free if gap.line.axis == axis), is_free)


def _of_both_faces(gaps: Sequence[RowGap], is_free: Mapping[RowGap, bool]) -> Iterator[tuple[tuple[RowGap, ...], bool]]:
    ats, lows, highs = np.array([gap.line[1:] for gap in gaps]).reshape(-1, 3).T
    is_left = np.full(len(gaps), fill_value=True)
    for place, gap in enumerate(gaps):
        if not is_left[place]:
            continue
        _, at, low, high = gap.line
        is_alike = (np.abs(lows - low) <= ALIKE) & (np.abs(highs - high) <= ALIKE) & is_left
        others = np.flatnonzero(is_alike & (ats - at >= THINNEST) & (ats - at <= THICKEST))
        if len(others):
            is_left[[place, others[0]]] = False
            yield (gap, gaps[others[0]]), True
        else:
            yield (gap,), is_free[gap]


class Fitted(NamedTuple):
    """Openings, the gaps that they fill, and those that are left."""

    openings: list[DrawnOpening]
    filled: list[WallGap]
    left: list[WallGap]


def fitted(openings: Sequence[DrawnOpening], gaps: Sequence[WallGap], metres: float | None) -> Fitted:
    """Returns openings, of which those that are drawn in a gap and say no id are as wide as it.

    A door that is drawn as no more than its open leaf hangs at the corner of a gap that is as wide, the first of two leaves for both.
    """
    all_gaps, gaps = gaps, [gap for gap in gaps if gap.is_whole]
    left, filled, found = dict.fromkeys(gaps), [], []
    middles = np.array([between(gap.start, gap.end) for gap in gaps]).reshape(-1, 2)
    widths, beside = np.array([gap.width for gap in gaps]), BESIDE / 1000 / (metres or 1.0)
    for one in _of_parts(openings, gaps, beside):
        away = np.hypot(*(middles - between(one.start, one.end)).T)
        near = np.flatnonzero(away < widths + math.dist(one.start, one.end))
        nearest = [gaps[at] for at in near[np.argsort(away[near], kind="stable")]]
        ways = [(gap, new) for gap in nearest if (new := _in_gap(one, gap, gap.thickness / 2))]
        if not ways and one.kind == "door" and not one.hinge:
            ways = [(gap, new) for gap in nearest if (new := _hung(one, gap))]
        ways = ways or [(gap, new) for gap in nearest if (new := _in_gap(one, gap, beside))]
        if one.id or not ways:
            found.append(one)
        elif ways[0][0] in left:
            found.append(ways[0][1])
        if ways:
            left.pop(ways[0][0], None)
        else:
            filled += [gap for gap in all_gaps if _fills(one, gap, beside)]
    return Fitted(found, [*filled, *(gap for gap in gaps if gap not in left)], list(left))


def _of_parts(openings: Sequence[DrawnOpening], gaps: Sequence[WallGap], beside: float) -> list[DrawnOpening]:
    """Returns openings, of which those of one kind that fill a gap side by side, as leaves that slide or a window's, are one."""
    middles, found = np.array([between(one.start, one.end) for one in openings]).reshape(-1, 2), dict(enumerate(openings))
    for gap in gaps:
        near = map(int, np.flatnonzero(np.hypot(*(middles - between(gap.start, gap.end)).T) < gap.width / 2))
        spans = {at: _along(found[at], gap, beside) for at in near if at in found and not (found[at].hinge or found[at].id)}
        parts = [at for at, (wide, common) in spans.items() if common >= FILLING * wide > 0 and wide * WIDEST < gap.width]
        if len({found[at].kind for at in parts}) == 1 and sum(spans[at][0] for at in parts) >= FILLING * gap.width:
            found[parts[0]] = replace(found[parts[0]], start=gap.start, end=gap.end)
            for at in parts[1:]:
                del found[at]
    return list(found.values())


def _along(one: DrawnOpening, gap: WallGap, beside: float) -> tuple[float, float]:
    """Returns how wide an opening is along a gap, and how much of that lies in it; nothing of one that does not lie along it."""
    along = 0 if gap.start[1] == gap.end[1] else 1
    (low, high), ends = (gap.start[along], gap.end[along]), (one.start[along], one.end[along])
    across = (one.start[1 - along] + one.end[1 - along]) / 2 - gap.start[1 - along]
    wide, common = abs(ends[1] - ends[0]), min(high, max(ends)) - max(low, min(ends))
    is_along = abs(one.end[1 - along] - one.start[1 - along]) <= SLOPED * wide and abs(across) <= beside
    return (wide, common) if is_along else (0.0, 0.0)


def _fills(one: DrawnOpening, gap: WallGap, beside: float) -> bool:
    """Tells whether an opening lies along a gap, and over most of it."""
    wide, common = _along(one, gap, beside)
    return common >= gap.width / 2 and gap.width <= WIDEST * wide


def _in_gap(one: DrawnOpening, gap: WallGap, beside: float) -> DrawnOpening | None:
    """Returns an opening that fills a gap, and is not much wider, as wide as that; None for any other."""
    if not _fills(one, gap, beside) or math.dist(one.start, one.end) > gap.width * WIDEST:
        return None
    along = 0 if gap.start[1] == gap.end[1] else 1
    return replace(one, start=gap.start, end=gap.end) if one.start[along] <= one.end[along] else replace(one, start=gap.end, end=gap.start)


def with_leaves(passages: Sequence[DrawnOpening], gaps: Sequence[WallGap], shapes: Sequence[Sequence[Spot]]) -> list[DrawnOpening]:
    """Returns passages through gaps, of which those are doors at whose corners one of some shapes hangs alone, as an open leaf does."""
    lines = [longer_line(points) for points in shapes]
    middles, by_ends = np.array([between(*line) for line in lines]).reshape(-1, 2), {(gap.start, gap.end): gap for gap in gaps}
    sides = np.array([(*a, *b, at) for at, points in enumerate(shapes) for a, b in pairwise(points)]).reshape(-1, 5)
    found = []
    for one in passages:
        gap = by_ends[one.start, one.end]
        near = map(int, np.flatnonzero(np.hypot(*(middles - between(one.start, one.end)).T) < gap.width + gap.thickness))
        hung = ((at, _hung(replace(one, kind="door", start=lines[at][0], end=lines[at][1], unsaid=False), gap, AT_CORNER)) for at in near)
        found.append(next((door for at, door in hung if door and _is_leaf(lines[at], door.towards, sides[:, :4], sides[:, 4] == at)), one))
    return found


def _is_leaf(line: tuple[Spot, Spot], tip: Spot | None, sides: NDArray[np.float64], is_own: NDArray[np.bool_]) -> bool:
    """Tells whether a shape is as thin as a leaf, and no other one ends at its tip or is as long beside it, as in a hatch."""
    (x, z), long = line[0], math.dist(*line)
    way = np.array(((line[1][0] - x, line[1][1] - z), (z - line[1][1], line[1][0] - x))) / long**2
    along, across = np.moveaxis((sides.reshape(-1, 2, 2) - (x, z)) @ way.T, 2, 0)  # of both ends of each side, in lengths of the line
    lengths = np.hypot(np.ptp(along, axis=1), np.ptp(across, axis=1))
    at_tip = np.hypot(along - (line[1] == tip), across) <= AT_CORNER
    is_beside = (np.abs(across).max(axis=1) < 1) & (np.ptp(across, axis=1) <= SLOPED) & (np.abs(along.mean(axis=1) - 0.5) < 0.5)
    is_like = at_tip.any(axis=1) | (is_beside & (np.abs(lengths - 1) <= SLOPED))
    return bool((np.abs(across[is_own]) <= SLIM / 2).all() and not is_like[~is_own].any())


def _hung(one: DrawnOpening, gap: WallGap, off: float = AT_JAMB) -> DrawnOpening | None:
    """Returns the door whose leaf is drawn open at a corner of a gap; None where it is too far, too short or too long."""
    leaf, along = math.dist(one.start, one.end), 0 if gap.start[1] == gap.end[1] else 1
    if not any(low <= leaf / gap.width <= high for low, high in LEAVES):
        return None
    for foot, tip in ((one.start, one.end), (one.end, one.start)):
        away = abs(tip[1 - along] - gap.start[1 - along])
        for hinge, jamb in (("start", gap.start), ("end", gap.end)):
            at_jamb = abs(foot[along] - jamb[along]) <= off * leaf
            if at_jamb and abs(foot[1 - along] - jamb[1 - along]) <= gap.thickness / 2 + off * leaf < away:
                return replace(one, start=gap.start, end=gap.end, hinge="start" if hinge == "start" else "end", towards=tip)
    return None
