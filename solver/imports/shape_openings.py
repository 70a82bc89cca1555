"""Openings of a drawing of shapes: what is drawn in one place is one, and the arc of a leaf tells where its door is."""

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from statistics import median
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.geometry import bounds_of_points
from solver.imports.drawn import DrawnOpening, OpeningKind, Spot

SLIM: Final = 1.5
"""A shape that is so many times as long as it is wide lies along its longer side."""
MEET: Final = 0.1
"""Two leaves of a door, shut, are no farther from one another than this share of the wider."""
SORTS: Final[dict[str, OpeningKind]] = {
    "window": "window", "garage_door": "garage_door", "no_door": "passage", "passage": "passage", "opening": "passage", "door": "door",
}  # fmt: skip
"""What a shape is told to be -> what it is at first; those before count before those after."""
SAME: Final = 0.6
"""Openings whose middles are nearer than this share of their length are one, drawn in several lines."""
SHARP: Final = 0.002
"""Lines meet whose ends are no farther apart than this share of a leaf's width."""
NARROW: Final = 0.08
"""A leaf is no thicker than this share of its width; walls are."""
WAYS: Final = 72
"""Directions in which lines leave a corner are told apart."""


DrawnBox = tuple[float, float, float, float]
DrawnStretch = tuple[Spot, Spot]


class DrawnShape(NamedTuple):
    """A shape: its layer's name, its points, whether it is closed, its place in the file, which of WORDS it is, what it is called.

    `width` is how thick its line is drawn, 0 where that means nothing; `id` is what our own export says it is called; `filled`: an area.
    """

    names: str
    points: tuple[Spot, ...]
    closed: bool
    where: str
    sort: str | None
    label: str = ""
    width: float = 0.0
    id: str = ""
    filled: bool = False

    def round(self) -> tuple[Spot, ...]:
        """Returns its points, of a closed one the first again at the end."""
        return (*self.points, *self.points[: self.closed])


WIDEST: Final = 1.2
"""What a leaf sweeps reaches no farther from its hinge than so many times its width."""
SWUNG: Final = ("door", "opening", "passage", "window")
"""What a leaf's arc is drawn as: some layers hold all openings."""


class DrawnSwing(NamedTuple):
    """The arc that a door's leaf sweeps: its hinge, its two ends, its place in the file, what it is called; None: a quarter circle."""

    hinge: Spot
    ends: tuple[Spot, Spot]
    where: str
    sort: str | None = None


def openings_of(shapes: Sequence[DrawnShape], swings: Sequence[DrawnSwing]) -> list[DrawnOpening]:
    """Returns openings, each once: the longest of what is drawn in one place, of that which is not nearly square where there is any.

    Of lines side by side, as a window's are, the opening lies along their middle.
    What says its id is one with what says the same alone: wide passages may meet at a corner.

    A hole with a leaf in it is a door. Where leaves swing and nothing is a window, what is drawn as a door may be one.
    """
    is_mixed = bool(swings) and all(one.sort != "window" for one in shapes)
    found: list[DrawnOpening] = []
    named: dict[str, int] = {}
    places, owners, lines = Places([]), np.empty(len(shapes), dtype=np.int64), list[list[DrawnStretch]]()
    for told, kind in SORTS.items():
        drawn = [(*longer_line(one.points), one) for one in shapes if one.sort == told]
        for start, end, one in sorted(drawn, key=lambda one: (_is_stout(one[2].points), -math.dist(one[0], one[1]))):
            near = [named[one.id]] if one.id in named else [] if one.id else _in_order(owners[places.all(start, end)])
            if not near and math.dist(start, end) > 0:
                unsaid = told == "opening" or (told == "door" and is_mixed)
                near = [len(found)]
                named |= {one.id: len(found)} if one.id else {}
                found.append(DrawnOpening(kind, start, end, one.where, id=one.id, unsaid=unsaid))
                lines.append([])
            elif near and kind == "door" and found[near[0]].kind == "passage":
                found[near[0]] = replace(found[near[0]], kind="door", unsaid=False)
            same = [at for at in near if found[at].kind == kind and (not lines[at] or _are_beside(lines[at][0], (start, end)))]
            if same and same[0] == near[0]:
                owners[places.add(start, end)] = same[0]
                lines[same[0]].append((start, end))
                for other in same[1:]:
                    owners[owners == other] = same[0]
                    lines[same[0]] += lines[other]
                    lines[other].clear()
    return [_in_the_middle(one, beside) for one, beside in zip(found, lines, strict=True) if beside]


def _in_order(owners: NDArray[np.int64]) -> list[int]:
    """Returns each of some numbers once, in the order in which they come first."""
    found, first = np.unique(owners, return_index=True)
    in_order: list[int] = found[np.argsort(first)].tolist()
    return in_order


def _are_beside(a: DrawnStretch, b: DrawnStretch) -> bool:
    """Tells whether two lines are two opposite sides of a box, or nearly."""
    (x, z), length = a[0], math.dist(*a)
    east, south = (a[1][0] - x) / length, (a[1][1] - z) / length
    (low, left), (high, right) = sorted(((u - x) * east + (w - z) * south, (w - z) * east - (u - x) * south) for u, w in b)
    return max(abs(low), abs(high - length), abs(left - right)) < MEET * length


def _in_the_middle(opening: DrawnOpening, lines: Sequence[DrawnStretch]) -> DrawnOpening:
    """Returns an opening along the middle of lines side by side, as long as the middle one of them by length."""
    start, end = sorted(lines, key=lambda one: math.dist(*one))[(len(lines) - 1) // 2]
    east, south = ((end[axis] - start[axis]) / math.dist(start, end) for axis in (0, 1))
    away = [(z - start[1]) * east - (x - start[0]) * south for x, z in itertools.starmap(between, lines)]
    by = (min(away) + max(away)) / 2
    return replace(opening, start=(start[0] - south * by, start[1] + east * by), end=(end[0] - south * by, end[1] + east * by))


def _is_stout(points: Sequence[Spot]) -> bool:
    """Tells whether a shape does not say along which of its sides it lies: a small window through a thick wall."""
    x0, z0, x1, z1 = bounds_of_points(points)
    return max(x1 - x0, z1 - z0) < SLIM * min(x1 - x0, z1 - z0)


class Places:
    """Where lines are drawn, to find which of them are one with another."""

    def __init__(self, lines: Sequence[tuple[Spot, Spot]]) -> None:
        self._rows, self._count = np.empty((max(len(lines), 16), 3)), 0
        for start, end in lines:
            self.add(start, end)

    def add(self, start: Spot, end: Spot) -> int:
        """Takes in one more line; returns which it is."""
        if self._count == len(self._rows):
            self._rows = np.concatenate((self._rows, np.empty_like(self._rows)))
        self._rows[self._count] = (*between(start, end), math.dist(start, end))
        self._count += 1
        return self._count - 1

    def all(self, start: Spot, end: Spot, alike: bool = False) -> NDArray[np.int64]:
        """Returns which are one with a line, or where it lies is `alike` and as long."""
        (x, z), rows = between(start, end), self._rows[: self._count]
        length = math.dist(start, end)
        longer = np.maximum(rows[:, 2], length)
        away, other = np.hypot(rows[:, 0] - x, rows[:, 1] - z), np.abs(rows[:, 2] - length)
        return np.flatnonzero((away < MEET * longer) & (other < MEET * longer) if alike else away < SAME * longer)

    def holds(self, start: Spot, end: Spot, alike: bool = False) -> bool:
        """Tells whether any is one with a line."""
        return bool(self.all(start, end, alike).size)


class MeetingLines:
    """Lines that end at some spots, of each the longest on each way from there: of many that lie on one another one is kept."""

    def __init__(self, lines: Sequence[DrawnStretch], spots: Iterable[Spot], near: float) -> None:
        self._near = near
        self._lines: dict[Spot, dict[int, float]] = {cell: {} for spot in spots for cell in self._around(spot)}
        for line in lines:
            for spot, other in (line, line[::-1]):
                if (there := self._lines.get(self._cell(*spot))) is not None:
                    way = _way(spot, other)
                    there[way] = max(there.get(way, 0.0), math.dist(*line))

    def met(self, spot: Spot, other: Spot) -> tuple[bool, bool]:
        """Tells whether a line that comes from elsewhere to a spot meets others there than narrow ones, and whether one goes on."""
        own, least = _way(spot, other), NARROW * math.dist(spot, other)
        ways = {way for cell in self._around(spot) for way, long in self._lines[cell].items() if long > least}
        turns = {min((way - own) % WAYS, (own - way) % WAYS) for way in ways}
        return max(turns, default=0) > 1, bool(turns & {WAYS // 2, WAYS // 2 - 1})

    def _cell(self, x: float, z: float) -> Spot:
        return x // (2 * self._near), z // (2 * self._near)

    def _around(self, spot: Spot) -> set[Spot]:
        """Returns the cells in which lines end that meet at a spot."""
        return {self._cell(spot[0] + east, spot[1] + south) for east in (-self._near, self._near) for south in (-self._near, self._near)}


def _way(spot: Spot, other: Spot) -> int:
    """Returns which of the directions from a spot leads to another."""
    return round(math.atan2(other[1] - spot[1], other[0] - spot[0]) / math.tau * WAYS) % WAYS


def without_leaves(shapes: Sequence[DrawnShape], swings: Sequence[DrawnSwing]) -> list[DrawnShape]:
    """Returns shapes, of which those of no sort that lie along a leaf are doors, as it is.

    A face of a wall does where a corner shower is as wide: its line meets others at both ends, a leaf's no more than its own narrow ones,
    and goes on at one at most, a threshold's at both.
    """
    leaves = Places([(one.hinge, end) for one in swings for end in one.ends])
    is_along = [one.sort is None and len(one.points) > 1 and leaves.holds(*longer_line(one.points), alike=True) for one in shapes]
    lines = [one.points for one in itertools.compress(shapes, is_along) if len(one.points) == 2]
    near = SHARP * median([math.dist(*line) for line in lines] or [0.0]) or 1.0
    corners = MeetingLines([(one.points[0], one.points[1]) for one in shapes if len(one.points) == 2], itertools.chain(*lines), near)

    def is_face(spots: Sequence[Spot]) -> bool:
        met = [corners.met(a, b) for a, b in (spots, spots[::-1])]
        return all(meets for meets, _ in met) and not all(goes_on for _, goes_on in met)

    return [
        one._replace(sort="door") if along and not (len(one.points) == 2 and is_face(one.points)) else one
        for one, along in zip(shapes, is_along, strict=True)
    ]


def doors_of_swings(swings: Sequence[DrawnSwing], faces: Sequence[Sequence[Spot]]) -> list[DrawnOpening]:
    """Returns the doors of arcs: shut, a leaf lies at a wall, or meets another that hangs opposite."""
    lines = np.array([(*a, *b) for points in faces for a, b in pairwise(points)]).reshape(-1, 4)
    hinges, tips = np.array([one.hinge for one in swings]).reshape(-1, 2), np.array([one.ends for one in swings]).reshape(-1, 2, 2)
    shut = [swing._replace(ends=_shut_first(swing, lines, hinges, tips)) for swing in swings]
    return [_door_of(swing) for swing in _both_leaves(shut)]


def _shut_first(swing: DrawnSwing, lines: NDArray[np.float64], hinges: NDArray[np.float64], tips: NDArray[np.float64]) -> tuple[Spot, Spot]:
    """Returns the ends of an arc, first the one that another leaf meets, which hangs opposite, else the one nearer to a wall."""
    width = math.dist(swing.hinge, swing.ends[0])
    opposite = tips[np.hypot(*(hinges - swing.hinge).T) > (2 - MEET) * width]

    def away(end: Spot) -> tuple[bool, float, Spot]:
        meets = bool((np.hypot(opposite[..., 0] - end[0], opposite[..., 1] - end[1]) < MEET * width).any())
        return not meets, to_lines(end, lines), end

    shut, opened = sorted(swing.ends, key=away)
    return shut, opened


def _both_leaves(swings: Sequence[DrawnSwing]) -> list[DrawnSwing]:
    """Returns arcs of shut leaves of which two that meet, as a door's two do, are one: of the wider, from its hinge to the other's."""
    hinges = np.array([one.hinge for one in swings]).reshape(-1, 2)
    tips = np.array([one.ends[0] for one in swings]).reshape(-1, 2)
    widths = np.hypot(*(tips - hinges).T)
    is_left = np.full(len(swings), fill_value=True)
    found = []
    for at in sorted(range(len(swings)), key=lambda at: (-widths[at], at)):
        if not is_left[at]:
            continue
        is_left[at] = False
        meet = np.hypot(*(tips - tips[at]).T) < MEET * widths[at]
        opposite = np.hypot(*(hinges - hinges[at]).T) > widths[at] + (1 - MEET) * widths
        others = np.flatnonzero(is_left & meet & opposite)
        one = swings[at]
        if len(others):
            is_left[others[0]] = False
            one = one._replace(ends=(swings[others[0]].hinge, one.ends[1]))
        found.append((at, one))
    return [one for _, one in sorted(found, key=lambda one: one[0])]


def _door_of(swing: DrawnSwing) -> DrawnOpening:
    (low, high), opened = sorted((swing.hinge, swing.ends[0])), swing.ends[1]
    if abs(high[0] - low[0]) >= abs(high[1] - low[1]):
        low, high = (low[0], (low[1] + high[1]) / 2), (high[0], (low[1] + high[1]) / 2)
        is_first = swing.hinge[0] < swing.ends[0][0]
    else:
        (low, high), x = sorted((low, high), key=lambda spot: spot[1]), (low[0] + high[0]) / 2
        low, high, is_first = (x, low[1]), (x, high[1]), swing.hinge[1] < swing.ends[0][1]
    return DrawnOpening("door", low, high, swing.where, hinge="start" if is_first else "end", towards=opened)


def to_lines(spot: Spot, lines: NDArray[np.float64]) -> float:
    """Returns how far a point is from the nearest of some lines."""
    if not len(lines):
        return 0.0
    starts, ways = lines[:, :2], lines[:, 2:] - lines[:, :2]
    lengths = (ways**2).sum(axis=1)
    shares = ((np.array(spot) - starts) * ways).sum(axis=1) / np.where(lengths > 0, lengths, 1.0)
    away = starts + np.clip(shares, 0.0, 1.0)[:, None] * ways - spot
    return float(np.hypot(away[:, 0], away[:, 1]).min())


def between(a: Spot, b: Spot) -> Spot:
    """Returns the middle of two points."""
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def sides_of(a: Spot, b: Spot, by: float) -> tuple[Spot, Spot]:
    """Returns the points so far from the middle of a line, on both sides."""
    (x, z), long = between(a, b), math.dist(a, b)
    east, south = (a[1] - b[1]) / long * by, (b[0] - a[0]) / long * by
    return (x - east, z - south), (x + east, z + south)


def longer_line(points: Sequence[Spot]) -> tuple[Spot, Spot]:
    """Returns a line itself; of a four-cornered shape its middle line; of others that of the box around them, along its longer side."""
    if len(points) == 2:
        return points[0], points[1]
    corners = points[:-1] if points[0] == points[-1] else points
    if len(corners) == 4:
        a, b, c, d = corners if math.dist(corners[0], corners[1]) <= math.dist(corners[1], corners[2]) else (*corners[1:], corners[0])
        return between(a, b), between(c, d)
    xs, zs = [x for x, _ in points], [z for _, z in points]
    x0, x1, z0, z1 = min(xs), max(xs), min(zs), max(zs)
    if x1 - x0 >= z1 - z0:
        return (x0, (z0 + z1) / 2), (x1, (z0 + z1) / 2)
    return ((x0 + x1) / 2, z0), ((x0 + x1) / 2, z1)
