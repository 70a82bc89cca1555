"""The hallway spine, and a partition that carries "which of my sides lie on a hallway" down the recursion.

A cut keeps its two crossed sides in both children and its own side in one; a cut that would take a child off the hallway is turned, becomes
a side hallway, a cell or an alcove. Not here: what is built in a column that stays on one hallway (columns.py).
"""

from typing import Final

from solver.floorplan.bsp import ASPECT, ENDS, MAX_ROOMS, OTHER, ROUND_MM, Plot, halves, span
from solver.floorplan.columns import Books, Columns, RoomBounds
from solver.floorplan.tiling import Layout, exterior_sides
from solver.geometry import Rect
from solver.streams import Stream

SLIM: Final = 1.3
"""Rooms beside a side hallway are at most this much wider than they must be. Our choice."""
DARK_SLIM: Final = 1.12
"""A room without daylight is at most this much longer than it must be: it becomes a bathroom. Our choice."""
ROOMY: Final = 2.6
"""A room with daylight is larger than so many of the smallest rooms before one without is cut off it. Our choice."""
SWAY: Final = 0.7
"""A side hallway strays from the middle by up to this part of what its rooms can spare. Our choice."""
JITTER: Final = 0.25
"""A cut strays from an equal division into rooms by up to this part of a room. Our choice."""


class _Carver:
    """Cuts plots, largest first."""

    def __init__(self, books: Books) -> None:
        self.books, self.columns = books, Columns(books)
        self.outline, self.least = books.outline, books.least

    def run(self) -> None:
        """Cuts until every plot is a room."""
        for plot in self.books.plots():
            if self.books.spare(plot) < 2 or not self.cut(plot):
                self.books.keep(plot.path, plot.rect)

    def cut(self, plot: Plot) -> bool:
        """Cuts a plot in the first way that fits; False where it stays whole."""
        run = plot.run
        if len(plot.halls) > 1 or plot.length(OTHER[run]) < 2 * self.least:
            axes = ("x", "z") if plot.rect.width >= plot.rect.depth else ("z", "x")
            return any(plot.keeps(axis) and self.plain(plot, axis) for axis in axes)
        if plot.role:
            return self.columns.build(plot)
        unit = self.books.unit(plot, run)
        narrow = 2 * unit <= plot.length(run) - self.books.hallway <= round(2 * SLIM * unit)
        return (
            (narrow and self.side_hallway(plot, run))
            or self.columns.cut_off(plot)
            or self.plain(plot, run)
            or self.side_hallway(plot, run)
            or self.columns.build(plot)
        )

    def margins(self, plot: Plot, axis: str) -> tuple[int, int]:
        """Least lengths of both children along the axis: so that none is too slim, unless it can be cut the other way."""
        across, side = plot.length(OTHER[axis]), self.books.side(plot)
        slim = max(self.least, -(-across // ASPECT))
        if self.books.spare(plot) <= 2 or across < 2 * side:
            return slim, slim
        first, second = (side if plot.child(plot.rect, axis, end).keeps(OTHER[axis]) else slim for end in (0, 1))
        return first, second

    def part(self, plot: Plot, axis: str, first: int, margins: tuple[int, int]) -> tuple[Rect, Rect]:
        """Cuts `first` mm off the west or north end, rounded to where a person would draw the line."""
        low, high = span(plot.rect, axis)
        rounded = round(first / ROUND_MM) * ROUND_MM
        return halves(plot.rect, axis, low + min(max(rounded, margins[0]), high - low - margins[1]))

    def plain(self, plot: Plot, axis: str) -> bool:
        """Cuts in two where both children stay on a hallway and fit."""
        margins, length = self.margins(plot, axis), plot.length(axis)
        if length < sum(margins):
            return False
        dark = [not exterior_sides(rect, self.outline) for rect in self.part(plot, axis, length // 2, margins)]
        shapely = length <= ASPECT * plot.length(OTHER[axis])
        if dark[0] != dark[1] and plot.rect.width * plot.rect.depth < ROOMY * self.least**2 and shapely:
            return False
        rects = self.part(plot, axis, self.first_length(plot, axis, margins, dark), margins)
        for end, rect in enumerate(rects):
            self.books.push(plot.child(rect, axis, end))
        return True

    def first_length(self, plot: Plot, axis: str, margins: tuple[int, int], dark: list[bool]) -> int:
        """Draws the length of the west or north child, mm.

        A child without daylight is short, one that keeps more hallways than its sibling is slim; else the length is
        near a multiple of an equal division.
        """
        stream = Stream(self.books.seed, "floorplan.cut", plot.path)
        length = plot.length(axis)
        halls = [len(plot.child(plot.rect, axis, end).halls) for end in (0, 1)]
        if dark[0] != dark[1]:
            end, stretch = dark.index(True), DARK_SLIM
        elif halls[0] != halls[1] and min(halls) == 1 and plot.length(OTHER[axis]) >= 2 * self.least:
            end, stretch = halls.index(max(halls)), SLIM
        else:
            rooms = max(2, int(length / (1.15 * max(margins))))
            first = rooms // 2 + (rooms % 2 and stream.below(2))
            return round(length * (first + stream.uniform(-JITTER, JITTER)) / rooms)
        wide = self.books.unit(plot, axis) if stretch == SLIM else 0
        base = wide if length - wide >= margins[1 - end] else margins[end]
        short = round(max(base, margins[end]) * stream.uniform(1.0, stretch))
        if stretch == DARK_SLIM:
            short = max(min(short, self.books.bath_mm2 // plot.length(OTHER[axis]) // ROUND_MM * ROUND_MM), margins[end])
        return short if end == 0 else length - short

    def side_hallway(self, plot: Plot, axis: str) -> bool:
        """Cuts with a hallway of its own between the children, from the hallway the plot lies on."""
        room = plot.length(axis) - self.books.hallway
        if room < 2 * self.least or self.books.hallway * plot.length(OTHER[axis]) > self.books.floor:
            return False
        stream = Stream(self.books.seed, "floorplan.side", plot.path)
        unit = self.books.unit(plot, axis)
        spare = room // 2 - (unit if room >= 2 * unit else self.least)
        first = round((room / 2 + stream.uniform(-SWAY, SWAY) * spare) / ROUND_MM) * ROUND_MM
        at = span(plot.rect, axis)[0] + min(max(first, self.least), room - self.least)
        one, rest = halves(plot.rect, axis, at)
        hallway, two = halves(rest, axis, at + self.books.hallway)
        self.books.add_hallway(hallway)
        self.books.push(plot.beside_hallway(one, axis, 0))
        self.books.push(plot.beside_hallway(two, axis, 1))
        return True


def carve(outline: Rect, bounds: RoomBounds, seed: int) -> Layout | None:
    """Cuts the house, mm, into rooms along a hallway spine; None where a half would be narrower than the least side."""
    axis = "z" if outline.width >= outline.depth else "x"
    low, high = span(outline, axis)
    at = low + (high - low - bounds.hallway) // 2
    if at - low < bounds.least:
        return None
    carver = _Carver(Books(outline, bounds, seed))
    first, rest = halves(outline, axis, at)
    spine, second = halves(rest, axis, at + bounds.hallway)
    carver.books.add_hallway(spine)
    carver.books.push(Plot(first, frozenset({ENDS[axis][1]}), "0"))
    south = Plot(second, frozenset({ENDS[axis][0]}), "1")
    if axis == "x" or bounds.most == 1 or not carver.side_hallway(south, "x"):
        carver.books.push(south)
    carver.run()
    return _layout(carver.books)


def _layout(books: Books) -> Layout:
    paths = sorted(books.rooms)
    first = len(books.hallways)
    index = {path: first + k for k, path in enumerate(paths)}
    return Layout(
        books.outline,
        (*books.hallways, *(books.rooms[path] for path in paths)),
        hallways=first,
        behind={index[back]: index[front] for back, front in sorted(books.behind.items())},
        notes=(f"cutting stopped at {MAX_ROOMS} rooms",) if books.capped else (),
    )
