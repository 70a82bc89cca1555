"""Columns of a strip that has one hallway along it and room for two rooms behind each other.

Cells stand at corners of the house only, so that front and back have daylight.
"""

from collections import defaultdict
from collections.abc import Iterator
from heapq import heappop, heappush
from math import sqrt
from typing import Final, NamedTuple

from solver.floorplan.bsp import ASPECT, ENDS, MAX_ROOMS, OTHER, ROUND_MM, Plot, halves, span
from solver.floorplan.tiling import exterior_sides
from solver.geometry import Rect
from solver.streams import Stream

HALLWAY_SHARE: Final = 0.15
"""Side hallways and alcoves are added up to this part of the floor."""
SUITES: Final = 2
"""Cells of a bedroom with its own bathroom behind it."""
PUBLIC: Final = 2
"""Cells of a living or dining room with rooms behind it: a house has one of each."""
BLOCK: Final = (1.02, 1.2, 1.3)
"""Rooms beside a side hallway: drawn between the first two, at most the third times the least width. Our choice."""
FRONT: Final = 1.1
"""The front room of a cell is at least this much deeper than the back: the smallest room is never walked through."""
FAIR: Final = 0.7
"""A room's side is at least this part of that of a square of its fair share of the floor. Our choice."""


class RoomBounds(NamedTuple):
    """What rooms along a spine keep to: least side, mm, most of them on each side, the largest bathroom, m2, hallways' width, mm."""

    least: int
    most: int
    bath_m2: float
    hallway: int


class Books:
    """What has been built and what may still be: rooms, hallways, plots in the queue, cells left, hallway floor left."""

    def __init__(self, outline: Rect, bounds: RoomBounds, seed: int) -> None:
        self.outline, self.seed = outline, seed
        self.least, self.most, bath_m2, self.hallway = bounds
        self.bath_mm2 = round(bath_m2 * 1e6)
        """The largest bathroom."""
        self.suite_mm = self.bath_mm2 // self.least
        """Widest column whose back room, as shallow as may be, is still a bathroom, mm."""
        self.hallways: list[Rect] = []
        self.beside = defaultdict[tuple[str, int], list[tuple[int, int]]](list)
        """By the axis and line of a hallway's sides: from where to where they go."""
        self.rooms: dict[str, Rect] = {}
        self.behind: dict[str, str] = {}
        self.left = {"suite": SUITES, "public": PUBLIC}
        self.floor = outline.width * outline.depth * HALLWAY_SHARE
        self.capped = False
        self._count = {"0": 0, "1": 0}
        """Plots in the queue and rooms, by the side of the spine on which they lie."""
        self._queue: list[tuple[tuple[bool, int, str], Plot]] = []

    def push(self, plot: Plot) -> None:
        """Puts a plot in the queue."""
        self._count[plot.half] += 1
        heappush(self._queue, (plot.order, plot))

    def plots(self) -> Iterator[Plot]:
        """Yields the plots, the most urgent first, until the queue is empty."""
        while self._queue:
            plot = heappop(self._queue)[1]
            self._count[plot.half] -= 1
            yield plot

    def keep(self, path: str, rect: Rect) -> None:
        """Makes a room."""
        self._count[path[0]] += 1
        self.rooms[path] = rect

    def spare(self, plot: Plot) -> int:
        """Returns how many rooms a plot that has been taken from the queue may become."""
        total = MAX_ROOMS - len(self.hallways) - self._count["0"] - self._count["1"] - 1
        self.capped = self.capped or (total <= 1 and self.most >= MAX_ROOMS // 2)
        return min(total, self.most - self._count[plot.half])

    def side(self, plot: Plot) -> int:
        """Returns the least side a room of a plot should have, mm: more than the least where few rooms may be made."""
        fair = plot.rect.width * plot.rect.depth / max(1, self.spare(plot))
        return max(self.least, round(FAIR * sqrt(fair)))

    def unit(self, plot: Plot, run: str) -> int:
        """Returns the least width of what stands on one side of a side hallway, mm.

        Where three rooms follow each other along it, two stand side by side at its head: they cost no more hallway.
        """
        side = self.side(plot)
        return 2 * side if plot.length(OTHER[run]) >= 3 * side else side

    def add_hallway(self, rect: Rect) -> None:
        """Books a hallway."""
        self.hallways.append(rect)
        for axis, across in OTHER.items():
            for line in span(rect, axis):
                self.beside[axis, line].append(span(rect, across))
        self.floor -= rect.width * rect.depth

    def corner(self, plot: Plot, end: int) -> bool:
        """Tells whether that end of a plot along its hallway lies on the house's outline."""
        return ENDS[plot.run][end] in exterior_sides(plot.rect, self.outline)


class Columns:
    """Cuts columns off strips and builds what they were cut off for."""

    def __init__(self, books: Books) -> None:
        self.books, self.least = books, books.least

    def slim(self, length: int) -> int:
        """Returns the least side of a room whose other side is `length`, mm."""
        return max(self.least, -(-length // ASPECT))

    def cut_off(self, plot: Plot) -> bool:
        """Cuts off an end of a strip: a cell's column at a corner, an alcove's, or a side hallway's with its rooms."""
        stream = Stream(self.books.seed, "floorplan.column", plot.path)
        corners = [end for end in (0, 1) if self.books.corner(plot, end)]
        end = stream.pick(corners) if corners else stream.below(2)
        for role in self._roles(plot, bool(corners), stream):
            widths = self._widths(plot, role, stream)
            rest = plot.length(plot.run) - widths[0]
            if widths[0] <= widths[1] and rest >= self.slim(plot.length(OTHER[plot.run])):
                self._cut(plot, self._evened(plot, widths), end, role)
                return True
        return False

    def _roles(self, plot: Plot, corner: bool, stream: Stream) -> list[str]:
        """The uses of a column that are still to be had, in the order in which they are tried."""
        cells = [role for role in ("suite", "public") if corner and self.books.left[role]]
        stream.shuffle(cells)
        more = ["block", "alcove"]
        stream.shuffle(more)
        return [*cells, *more]

    def _widths(self, plot: Plot, role: str, stream: Stream) -> tuple[int, int]:
        """Returns a width drawn for a role and the greatest it may have, mm; the first is greater where it cannot be."""
        deep, least, never = plot.length(OTHER[plot.run]), self.least, (1, 0)
        if role in self.books.left and deep < (1 + FRONT) * least:
            return never
        if role == "suite":
            low, high = max(least, -(-(deep - least) // ASPECT)), min(self.books.suite_mm, ASPECT * least)
            return (round(stream.uniform(low, min(high, low * 1.1))), high) if low <= high else never
        if role == "public":
            twice = self.books.left["public"] == PUBLIC
            low = max(2 * least, self.slim(deep - least)) if twice else self.slim(deep * 3 // 5)
            return round(low * stream.uniform(1.0, 1.1)), min(round(low * 1.3), ASPECT * (deep - max(least, deep * 2 // 5)))
        if role == "alcove":
            low = max(least + self.books.hallway, -(-(deep - least) // ASPECT))
            return (round(low * stream.uniform(1.0, 1.1)), round(low * 1.25)) if self.books.hallway * least <= self.books.floor else never
        unit = self.books.unit(plot, plot.run)
        drawn, most = round(2 * unit * stream.uniform(*BLOCK[:2])), round(2 * unit * BLOCK[2])
        return (drawn + self.books.hallway, most + self.books.hallway) if self.books.hallway * deep <= self.books.floor else never

    def _evened(self, plot: Plot, widths: tuple[int, int]) -> int:
        """Widens a column by what would be too little for one more column in the rest of the strip."""
        length, column = plot.length(plot.run), self.slim(plot.length(OTHER[plot.run])) * 21 // 20
        spare = (length - widths[0]) % column if length - widths[0] >= column else 0
        return min(widths[0] + spare, widths[1]) // ROUND_MM * ROUND_MM if spare else widths[0]

    def _cut(self, plot: Plot, wide: int, end: int, role: str) -> None:
        if role in self.books.left:
            self.books.left[role] -= 1
        low, high = span(plot.rect, plot.run)
        for k, rect in enumerate(halves(plot.rect, plot.run, high - wide if end else low + wide)):
            self.books.push(plot.child(rect, plot.run, k, role if k == end and role != "block" else ""))

    def build(self, plot: Plot) -> bool:
        """Builds a column's role, or in a column without one the first that fits; False where it stays whole."""
        if plot.role == "suite":
            return self._suite(plot)
        if plot.role == "public":
            return self._public(plot)
        corner = self.books.corner(plot, 0) or self.books.corner(plot, 1)
        if not plot.role and corner and self.books.left["public"] and self._public(plot):
            self.books.left["public"] -= 1
            return True
        return self._alcove(plot)

    def _suite(self, plot: Plot) -> bool:
        """A bedroom with a bathroom behind it."""
        back = self.slim(plot.length(plot.run))
        if plot.length(OTHER[plot.run]) < (1 + FRONT) * back:
            return False
        front, rear = self._front_and_back(plot, back)
        self._cell(plot, front, [rear])
        return True

    def _public(self, plot: Plot) -> bool:
        """A living or dining room with one room behind it, or two where it is wide."""
        wide, deep = plot.length(plot.run), plot.length(OTHER[plot.run])
        twice = wide >= 2 * self.least and self.books.spare(plot) >= 3
        back = max(self.slim(-(-wide // 2) if twice else wide), deep * 2 // 5)
        if deep - back < max(self.slim(wide), FRONT * back) or (twice and back > ASPECT * (wide // 2)):
            return False
        front, rear = self._front_and_back(plot, back)
        at = span(rear, plot.run)[0] + max(wide // 2 // ROUND_MM * ROUND_MM, self.least)
        self._cell(plot, front, list(halves(rear, plot.run, at)) if twice else [rear])
        return True

    def _cell(self, plot: Plot, front: Rect, rears: list[Rect]) -> None:
        """Makes a room on the hallway and the rooms behind it."""
        self.books.keep(plot.path + "0", front)
        for k, rear in enumerate(rears):
            self.books.keep(f"{plot.path}1{k}", rear)
            self.books.behind[f"{plot.path}1{k}"] = plot.path + "0"

    def _front_and_back(self, plot: Plot, back: int) -> tuple[Rect, Rect]:
        """Divides a column into the part on its hallway and the `back` mm behind it."""
        across = OTHER[plot.run]
        low, high = span(plot.rect, across)
        near_low = "north" in plot.halls or "west" in plot.halls
        one, two = halves(plot.rect, across, high - back if near_low else low + back)
        return (one, two) if near_low else (two, one)

    def _alcove(self, plot: Plot) -> bool:
        """Leads 1.3 m of hallway past a small front room up to the back room."""
        run = plot.run
        wide, deep = plot.length(run), plot.length(OTHER[run])
        front = self.slim(wide - self.books.hallway)
        slim = wide - self.books.hallway < self.slim(front) or deep - front < self.slim(wide) or deep - front > ASPECT * wide
        end = self._free_end(plot)
        if slim or self.books.hallway * front > self.books.floor or end < 0:
            return False
        near, rear = self._front_and_back(plot, deep - front)
        low, high = span(near, run)
        parts = halves(near, run, high - self.books.hallway if end else low + self.books.hallway)
        self.books.add_hallway(parts[end])
        self.books.keep(plot.path + "0", parts[1 - end])
        self.books.keep(plot.path + "1", rear)
        return True

    def _free_end(self, plot: Plot) -> int:
        """Returns the end of a column where an alcove meets neither the outside nor another hallway, or -1."""
        across = span(plot.rect, OTHER[plot.run])
        for end, line in enumerate(span(plot.rect, plot.run)):
            met = any(max(across[0], low) < min(across[1], high) for low, high in self.books.beside[plot.run, line])
            if not met and not self.books.corner(plot, end):
                return end
        return -1
