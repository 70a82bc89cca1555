"""Exact arithmetic: lengths as integers, boxes, and the parts of the plane they cover.

A scene is read to the micrometre. Halving an extent gives half micrometres; one step finer, at a quarter, lies a robot that
is half a micrometre narrower than asked: it passes a gap of exactly the robot's width, and nothing narrower.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

from solver.demanded import demand

PER_METRE: Final = 4_000_000
"""Lattice steps in a metre."""
BOX_WORK: Final = 2
"""What a box of an outline counts; measured."""
MICROMETRE: Final = PER_METRE // 1_000_000


def exact(metres: float) -> int:
    """Rounds metres to the micrometre, in lattice steps."""
    return MICROMETRE * round(metres * 1_000_000)


def metres(steps: int) -> float:
    """Converts lattice steps to metres."""
    return steps / PER_METRE


def words(steps: int) -> str:
    """Says a length as a person does: `12 cm`, `0.1 cm`, `2.35 m`."""
    if steps >= PER_METRE:
        return f"{steps / PER_METRE:.2f} m"
    centimetres = f"{steps * 100 / PER_METRE:.1f}".removesuffix(".0")
    return f"{centimetres} cm" if centimetres != "0" else "less than 0.1 cm"


class ExactBox(NamedTuple):
    """An axis-aligned rectangle, x east and z south, in lattice steps."""

    x0: int
    z0: int
    x1: int
    z1: int

    def grown(self, by: int) -> ExactBox:
        """Moves every edge outwards."""
        return ExactBox(self.x0 - by, self.z0 - by, self.x1 + by, self.z1 + by)


class WallEdge(NamedTuple):
    """A straight piece of a room's wall line.

    `side` is the wall it is (the room lies to the south of its north wall); `line` its z (north, south) or x (east,
    west); [start, end] what it spans along itself.
    """

    side: str
    line: int
    start: int
    end: int

    @property
    def runs_east(self) -> bool:
        """Tells whether the edge runs along x."""
        return self.side in ("north", "south")

    def strip(self, start: int, end: int, inwards: int, outwards: int = 0) -> ExactBox:
        """Returns the box over [start, end] of the edge, reaching into the room and out of it."""
        into = inwards if self.side in ("north", "west") else outwards
        back = outwards if self.side in ("north", "west") else inwards
        across = (self.line - back, self.line + into)
        return ExactBox(start, across[0], end, across[1]) if self.runs_east else ExactBox(across[0], start, across[1], end)

    def moved(self, x: int, z: int) -> WallEdge:
        """Shifts the edge."""
        across, along = (z, x) if self.runs_east else (x, z)
        return WallEdge(self.side, self.line + across, self.start + along, self.end + along)


class Outline(NamedTuple):
    """A rectilinear floor: its bounds, boxes that cover it, boxes that cover the rest of the bounds, and its edges.

    `edges[i]` runs from corner i to the next; None where it has no length or floor on both sides.
    """

    bounds: ExactBox
    inside: tuple[ExactBox, ...]
    missing: tuple[ExactBox, ...]
    edges: tuple[WallEdge | None, ...]


def outline_of(corners: Sequence[tuple[int, int]]) -> Outline:
    """Takes a rectilinear outline apart; its corners may run either way round."""
    (x0, z0), (x1, z1) = corners[0], corners[2]
    if x0 < x1 and z0 < z1 and list(corners) == [(x0, z0), (x1, z0), (x1, z1), (x0, z1)]:  # most rooms
        sides = WallEdge("north", z0, x0, x1), WallEdge("east", x1, z0, z1), WallEdge("south", z1, x0, x1), WallEdge("west", x0, z0, z1)
        whole = ExactBox(x0, z0, x1, z1)
        return Outline(whole, (whole,), (), sides)
    xs = sorted({x for x, _ in corners})
    zs = sorted({z for _, z in corners})
    lines = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    merged: list[_Slab] = []
    for slab in _slabs(lines, xs):
        start = merged.pop().x0 if merged and merged[-1].spans == slab.spans else slab.x0
        merged.append(slab._replace(x0=start))
    inside = tuple(ExactBox(x0, a, x1, b) for x0, x1, spans in merged for a, b in _pairs(spans))
    missing = tuple(ExactBox(x0, a, x1, b) for x0, x1, spans in merged for a, b in _pairs([zs[0], *spans, zs[-1]]) if a < b)
    edges = tuple(_edge(merged, *line) for line in lines)
    return Outline(ExactBox(xs[0], zs[0], xs[-1], zs[-1]), inside, missing, edges)


class _Slab(NamedTuple):
    """A part of an outline from west to east, and where floor begins and ends in it, from north to south."""

    x0: int
    x1: int
    spans: list[int]


def _slabs(lines: Sequence[tuple[tuple[int, int], tuple[int, int]]], xs: Sequence[int]) -> Iterator[_Slab]:
    """Yields the slabs between all corners, swept from west to east."""
    flat = sorted((min(a[0], b[0]), max(a[0], b[0]), a[1]) for a, b in lines if a[0] != b[0])
    over: list[tuple[int, int, int]] = []
    begun = 0
    for x0, x1 in pairwise(xs):
        over = [line for line in over if line[1] > x0]
        while begun < len(flat) and flat[begun][0] <= x0:
            over.append(flat[begun])
            begun += 1
        demand(BOX_WORK * len(over))
        yield _Slab(x0, x1, _crossings(sorted(z for _, _, z in over)))


def _crossings(found: Sequence[int]) -> list[int]:
    """Returns where a slab enters and leaves the floor: lines that run to and fro are none."""
    crossings: list[int] = []
    for z in found:
        if crossings and crossings[-1] == z:
            crossings.pop()
        else:
            crossings.append(z)
    return crossings


def _pairs(spans: Sequence[int]) -> list[tuple[int, int]]:
    return list(zip(spans[::2], spans[1::2], strict=True))


def _edge(slabs: Sequence[_Slab], a: tuple[int, int], b: tuple[int, int]) -> WallEdge | None:
    """Finds which wall a line of the outline is, by the side its floor lies on."""
    (x0, z0), (x1, z1) = min(a, b), max(a, b)
    if z0 == z1 and x0 < x1:
        south, north = (_covered(slabs, x0 + 1, z0 + step) for step in (1, -1))
        return WallEdge("north" if south else "south", z0, x0, x1) if south != north else None
    if x0 == x1 and z0 < z1:
        east, west = (_covered(slabs, x0 + step, z0 + 1) for step in (1, -1))
        return WallEdge("west" if east else "east", x0, z0, z1) if east != west else None
    return None


def _covered(slabs: Sequence[_Slab], x: int, z: int) -> bool:
    at = bisect_left(slabs, x, key=lambda slab: slab.x0) - 1
    if at < 0 or x >= slabs[at].x1:
        return False
    spans = slabs[at].spans
    begun = bisect_left(spans, z)
    return begun % 2 == 1 and z < spans[begun]
