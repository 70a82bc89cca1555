"""The hallway spine, and a partition that carries "which of my sides lie on a hallway" down the recursion.

Comes in: an outline, the smallest side, a depth, a seed, the largest bathroom. Goes out: a `Layout` in which every room
touches a hallway or is `behind` a room planned for that; None where the spine does not fit.
May import: the ground floor. The scheme is floorplan.md's: a cut keeps its two crossed sides in both children and its
own side in one; a cut that would take a child off the hallway is turned, becomes a side hallway, a cell or an alcove.
"""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heappop, heappush
from typing import Final

from solver.floorplan.bsp import MAX_ROOMS, cut_at, halves
from solver.floorplan.layout import HALLWAY_MM, Layout, exterior_sides
from solver.geometry import Rect
from solver.streams import Stream

HALLWAY_SHARE: Final = 0.15
"""Side hallways and alcoves are added up to this part of the floor (floorplan.md)."""
ASPECT: Final = 2.0
"""Longest side over shortest that a cut may leave (floorplan.md: p95 <= 2.0)."""
SUITES: Final = 2
"""Cells of a bedroom with its own bathroom behind it (floorplan.md)."""
PUBLIC_CELLS: Final = 2
"""Cells of a living or dining room with a room behind it: a house has one of each."""
_ENDS: Final = {"x": ("west", "east"), "z": ("north", "south")}
_ACROSS: Final = {"x": ("north", "south"), "z": ("west", "east")}


@dataclass(frozen=True)
class _Plot:
    """A rectangle still to be cut; `halls` are its sides that lie on a hallway over their whole length."""

    rect: Rect
    halls: frozenset[str]
    path: str
    cuts_left: int

    def length(self, axis: str) -> int:
        """Extent along an axis, mm."""
        return self.rect.width if axis == "x" else self.rect.depth

    def keeps(self, axis: str) -> bool:
        """Tells whether both children of a cut across the axis still touch a hallway."""
        return any(side in self.halls for side in _ACROSS[axis]) or all(side in self.halls for side in _ENDS[axis])


def _other(axis: str) -> str:
    return "z" if axis == "x" else "x"


def _span(rect: Rect, axis: str) -> tuple[int, int]:
    return (rect.x0, rect.x1) if axis == "x" else (rect.z0, rect.z1)


class _Carver:
    """Cuts plots, largest first, and keeps the books: hallway floor, cells, rooms."""

    def __init__(self, outline: Rect, least: int, seed: int, bath_m2: float) -> None:
        self.outline, self.least, self.seed, self.bath_m2 = outline, least, seed, bath_m2
        self.hallways: list[Rect] = []
        self.rooms: dict[str, Rect] = {}
        self.behind: dict[str, str] = {}
        self.queue: list[tuple[int, str, _Plot]] = []
        self.suites, self.public = 0, 0
        self.floor = outline.width * outline.depth * HALLWAY_SHARE
        self.capped = False

    def push(self, plot: _Plot) -> None:
        heappush(self.queue, (-plot.rect.width * plot.rect.depth, plot.path, plot))

    def add_hallway(self, rect: Rect) -> None:
        self.hallways.append(rect)
        self.floor -= rect.width * rect.depth

    def run(self) -> None:
        while self.queue:
            plot = heappop(self.queue)[2]
            full = len(self.queue) + len(self.rooms) + len(self.hallways) + 3 > MAX_ROOMS
            self.capped = self.capped or (full and plot.cuts_left > 0)
            if plot.cuts_left == 0 or full or not self.cut(plot):
                self.rooms[plot.path] = plot.rect

    def cut(self, plot: _Plot) -> bool:
        """Cuts a plot in the first way that fits; False where it stays whole."""
        axes = ("x", "z") if plot.rect.width >= plot.rect.depth else ("z", "x")
        single = len(plot.halls) == 1
        run = "x" if plot.halls & {"north", "south"} else "z"
        if single and plot.length(_other(run)) >= 2 * self.least and self.short_run(plot, run) and self.side_hallway(plot, run):
            return True
        if any(plot.keeps(axis) and self.plain(plot, axis) for axis in axes):
            return True
        if not single:
            return False
        return self.side_hallway(plot, run) or self.cell(plot, run) or self.alcove(plot, run)

    def short_run(self, plot: _Plot, run: str) -> bool:
        """Tells whether a side hallway now leaves columns of at most five thirds of the least side."""
        return plot.length(run) <= 2 * self.least * 5 // 3 + HALLWAY_MM

    def margin(self, plot: _Plot, axis: str, halls: frozenset[str]) -> int:
        """Least length of a child along the axis: so that it is not too slim, unless it will be cut the other way."""
        across = plot.length(_other(axis))
        child = _Plot(plot.rect, halls, plot.path, plot.cuts_left - 1)
        if child.cuts_left > 0 and across >= 2 * self.least and child.keeps(_other(axis)):
            return self.least
        return max(self.least, -(-across // int(ASPECT)))

    def plain(self, plot: _Plot, axis: str) -> bool:
        """Cuts in two where both children stay on a hallway and fit."""
        first, second = (plot.halls - {_ENDS[axis][1]}, plot.halls - {_ENDS[axis][0]})
        margins = self.margin(plot, axis, first), self.margin(plot, axis, second)
        if plot.length(axis) < sum(margins):
            return False
        at = cut_at(Stream(self.seed, "floorplan.cut", plot.path), *_span(plot.rect, axis), margins)
        one, two = halves(plot.rect, axis, at)
        self.push(_Plot(one, first, plot.path + "0", plot.cuts_left - 1))
        self.push(_Plot(two, second, plot.path + "1", plot.cuts_left - 1))
        return True

    def side_hallway(self, plot: _Plot, axis: str) -> bool:
        """Cuts with a hallway of its own between the children, from the hallway the plot lies on."""
        cost = HALLWAY_MM * plot.length(_other(axis))
        if plot.length(axis) < 2 * self.least + HALLWAY_MM or cost > self.floor:
            return False
        low, high = _span(plot.rect, axis)
        at = cut_at(Stream(self.seed, "floorplan.side", plot.path), low, high - HALLWAY_MM, (self.least, self.least))
        one, rest = halves(plot.rect, axis, at)
        hallway, two = halves(rest, axis, at + HALLWAY_MM)
        self.add_hallway(hallway)
        self.push(_Plot(one, plot.halls | {_ENDS[axis][1]}, plot.path + "0", plot.cuts_left - 1))
        self.push(_Plot(two, plot.halls | {_ENDS[axis][0]}, plot.path + "1", plot.cuts_left - 1))
        return True

    def cell(self, plot: _Plot, run: str) -> bool:
        """Makes a front room with a room behind it, at a corner of the house so that both have daylight."""
        deep = plot.length(_other(run))
        corner = any(side in exterior_sides(plot.rect, self.outline) for side in _ENDS[run])
        if not corner or deep < 2 * self.least or plot.length(run) > ASPECT * self.least:
            return False
        suite = self.suites < SUITES and plot.length(run) * self.least / 1e6 <= self.bath_m2
        if not suite and self.public >= PUBLIC_CELLS:
            return False
        self.suites, self.public = self.suites + suite, self.public + (not suite)
        slim = -(-plot.length(run) // int(ASPECT))
        back = max(self.least, slim) if suite else min(max(self.least, slim, deep * 2 // 5), deep - self.least)
        self.front_and_back(plot, run, back)
        return True

    def front_and_back(self, plot: _Plot, run: str, back: int) -> tuple[Rect, Rect]:
        """Cuts off the `back` mm that lie away from the plot's hallway."""
        low, high = _span(plot.rect, _other(run))
        near_low = bool(plot.halls & {"north", "west"})
        one, two = halves(plot.rect, _other(run), high - back if near_low else low + back)
        front, rear = (one, two) if near_low else (two, one)
        self.rooms[plot.path + "0"], self.rooms[plot.path + "1"] = front, rear
        self.behind[plot.path + "1"] = plot.path + "0"
        return front, rear

    def alcove(self, plot: _Plot, run: str) -> bool:
        """Leads 1.3 m of hallway past a front room up to the back room."""
        wide, deep = plot.length(run), plot.length(_other(run))
        front = max(self.least, -(-(wide - HALLWAY_MM) // int(ASPECT)))
        back = deep - front
        fits = wide - HALLWAY_MM >= self.least and back >= max(self.least, -(-wide // int(ASPECT)))
        if not fits or HALLWAY_MM * front > self.floor or front > ASPECT * (wide - HALLWAY_MM):
            return False
        room, _ = self.front_and_back(plot, run, back)
        low, high = _span(room, run)
        passage, rest = halves(room, run, low + HALLWAY_MM)
        if "west" in exterior_sides(plot.rect, self.outline) and run == "x":
            rest, passage = halves(room, run, high - HALLWAY_MM)
        self.add_hallway(passage)
        self.rooms[plot.path + "0"] = rest
        del self.behind[plot.path + "1"]
        return True


def carve(outline: Rect, least: int, max_depth: int, seed: int, bath_m2: float) -> Layout | None:
    """Cuts the house into rooms along a hallway spine.

    Args:
        outline: the house, mm.
        least: smallest side of a room, mm.
        max_depth: levels of cuts on each side of the spine.
        seed: the house's seed.
        bath_m2: the largest bathroom, for a bedroom with its own bathroom behind it.

    Returns:
        The layout; None where a half would be narrower than `least`.
    """
    axis = "z" if outline.width >= outline.depth else "x"
    low, high = _span(outline, axis)
    at = low + (high - low - HALLWAY_MM) // 2
    if at - low < least:
        return None
    carver = _Carver(outline, least, seed, bath_m2)
    first, rest = halves(outline, axis, at)
    spine, second = halves(rest, axis, at + HALLWAY_MM)
    carver.add_hallway(spine)
    carver.push(_Plot(first, frozenset({_ENDS[axis][1]}), "0", max_depth))
    south = _Plot(second, frozenset({_ENDS[axis][0]}), "1", max_depth)
    if axis == "x" or max_depth == 0 or not carver.side_hallway(south, "x"):
        carver.push(south)
    carver.run()
    return _layout(carver)


def _layout(carver: _Carver) -> Layout:
    paths = sorted(carver.rooms)
    first = len(carver.hallways)
    index = {path: first + k for k, path in enumerate(paths)}
    return Layout(
        carver.outline,
        (*carver.hallways, *(carver.rooms[path] for path in paths)),
        hallways=first,
        behind={index[back]: index[front] for back, front in sorted(carver.behind.items())},
        notes=(f"cutting stopped at {MAX_ROOMS} rooms",) if carver.capped else (),
    )
