"""The basic binary space partition: rectangles cut along their longer axis, with L-shaped corridors between siblings.

Axes: "x" runs west to east, "z" north to south; a cut across an axis divides the rectangle's extent along it.

Not here: access (access.py), the spine (spine.py).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from itertools import takewhile
from typing import Any, Final, NamedTuple

from solver.floorplan.given import GivenPart
from solver.floorplan.tiling import CLEAR_HALLWAY_MM, Layout, touching
from solver.geometry import Rect, half_m, to_m
from solver.streams import Stream

SHARES: Final = (0.4, 0.6)
"""A cut falls in this part of a side; chosen for the number of rooms that plain requests come to."""
MAX_ROOMS: Final = 2048
"""Cutting stops here, the largest rectangles having been cut first. Our choice: two seconds of work, as a call of normal effort may do."""
ROUND_MM: Final = 50
"""Cuts fall on multiples of 5 cm from the house's edge: dimensions a person would draw."""


def cut_at(stream: Stream, low: int, high: int, margins: tuple[int, int]) -> int:
    """Draws where to cut the interval [low, high], mm; `margins` are least lengths of the two parts, together at most the interval."""
    length = high - low
    first = max(margins[0], round(length * SHARES[0]))
    last = min(length - margins[1], round(length * SHARES[1]))
    if last < first:
        first, last = (margins[0], margins[0]) if last < margins[0] else (last, last)
    drawn = round(stream.uniform(first, last) / ROUND_MM) * ROUND_MM
    return low + min(max(drawn, margins[0]), length - margins[1])


@dataclass(frozen=True)
class _Node:
    """A rectangle of the tree; its path is 0 for the west or north child, 1 for the other."""

    rect: Rect
    path: str
    cuts_left: int


def partition(outline: Rect, least: int, max_depth: int, seed: int, parts: Sequence[GivenPart] = ()) -> Layout:
    """Cuts the house, or the least rectangle around it, mm, into rooms without a hallway; returns them in the tree's order.

    No side is shorter than `least` mm; each cut has one corridor. `parts` are the rectangles of a house that is no rectangle itself; cuts
    between them are levels, too.
    """
    leaves: dict[str, Rect] = {}
    nodes = [_Node(rect, path, max(max_depth - len(path), 0)) for rect, path in parts] or [_Node(outline, "", max_depth)]
    queue = [(-node.rect.width * node.rect.depth, node.path, node) for node in nodes]
    heapify(queue)
    capped = False
    while queue:
        node = heappop(queue)[2]
        full = len(queue) + len(leaves) + 2 > MAX_ROOMS
        if node.cuts_left == 0 or max(node.rect.width, node.rect.depth) < 2 * least or full:
            capped = capped or (full and node.cuts_left > 0 and max(node.rect.width, node.rect.depth) >= 2 * least)
            leaves[node.path] = node.rect
            continue
        for child in _children(node, least, seed):
            heappush(queue, (-child.rect.width * child.rect.depth, child.path, child))
    paths = sorted(leaves)
    rooms = tuple(leaves[path] for path in paths)
    notes = (f"cutting stopped at {MAX_ROOMS} rooms",) if capped else ()
    return Layout(outline, rooms, corridors=_corridors(paths, rooms), notes=notes)


def _children(node: _Node, least: int, seed: int) -> tuple[_Node, _Node]:
    rect = node.rect
    axis = "x" if rect.width >= rect.depth else "z"
    low, high = (rect.x0, rect.x1) if axis == "x" else (rect.z0, rect.z1)
    at = cut_at(Stream(seed, "floorplan.bsp", node.path), low, high, (least, least))
    first, second = halves(rect, axis, at)
    return _Node(first, node.path + "0", node.cuts_left - 1), _Node(second, node.path + "1", node.cuts_left - 1)


def _corridors(paths: list[str], rooms: tuple[Rect, ...]) -> tuple[Mapping[str, Any], ...]:
    """Joins the two children of every cut through the rooms that share the longest wall across it."""
    best: dict[str, tuple[int, int, int]] = {}
    for a, b, _, low, high in touching(rooms):
        shared = takewhile(lambda pair: pair[0] == pair[1], zip(paths[a], paths[b], strict=False))
        node = "".join(step for step, _ in shared)
        candidate = (low - high, a, b)
        best[node] = min(best.get(node, candidate), candidate)
    return tuple(_corridor(rooms, a, b) for _, (_, a, b) in sorted(best.items()))


def _corridor(rooms: tuple[Rect, ...], a: int, b: int) -> Mapping[str, Any]:
    """An L from one room's centre along x, then along z, to the other's; m."""
    ax, az, bx, bz = (half_m(v) for r in (rooms[a], rooms[b]) for v in (r.x0 + r.x1, r.z0 + r.z1))
    return {"from": a, "to": b, "points": [[ax, az], [bx, az], [bx, bz]], "width": to_m(CLEAR_HALLWAY_MM)}


ENDS: Final = {"x": ("west", "east"), "z": ("north", "south")}
"""The two sides at the ends of an axis: a cut across it gives one to each child."""
ACROSS: Final = {"x": ("north", "south"), "z": ("west", "east")}
"""The two sides that a cut across an axis crosses: both children keep a part of each."""
ASPECT: Final = 2
"""Longest side over shortest that a cut may leave."""
OTHER: Final = {"x": "z", "z": "x"}


def span(rect: Rect, axis: str) -> tuple[int, int]:
    """Returns a rectangle's extent along an axis, mm."""
    return (rect.x0, rect.x1) if axis == "x" else (rect.z0, rect.z1)


def halves(rect: Rect, axis: str, at: int) -> tuple[Rect, Rect]:
    """Cuts a rectangle across an axis ("x": into west and east, "z": into north and south) at a coordinate, mm."""
    if axis == "x":
        return Rect(rect.x0, rect.z0, at, rect.z1), Rect(at, rect.z0, rect.x1, rect.z1)
    return Rect(rect.x0, rect.z0, rect.x1, at), Rect(rect.x0, at, rect.x1, rect.z1)


class Plot(NamedTuple):
    """A rectangle still to be cut.

    `halls` are its sides that lie on a hallway over their whole length; `path` is 0 or 1 for every cut that led to it;
    `role` says what a column was cut off for: "suite", "public", "alcove" or nothing yet.
    """

    rect: Rect
    halls: frozenset[str]
    path: str
    role: str = ""

    @property
    def half(self) -> str:
        """Which side of the spine it lies on."""
        return self.path[0]

    @property
    def order(self) -> tuple[bool, int, str]:
        """What is cut first: what others rely on being cut (a role, a slim plot), then the largest."""
        short, long = sorted((self.rect.width, self.rect.depth))
        return not self.role and long <= ASPECT * short, -short * long, self.path

    @property
    def run(self) -> str:
        """The axis along its hallway (along x where it has one on either kind of side)."""
        return "x" if "north" in self.halls or "south" in self.halls else "z"

    def length(self, axis: str) -> int:
        """Extent along an axis, mm."""
        return self.rect.width if axis == "x" else self.rect.depth

    def keeps(self, axis: str) -> bool:
        """Tells whether both children of a cut across the axis still touch a hallway."""
        return not self.halls.isdisjoint(ACROSS[axis]) or self.halls.issuperset(ENDS[axis])

    def child(self, rect: Rect, axis: str, end: int, role: str = "") -> "Plot":
        """Returns the child at one end (0: west or north) of a cut across the axis."""
        return Plot(rect, self.halls - {ENDS[axis][1 - end]}, self.path + str(end), role)

    def beside_hallway(self, rect: Rect, axis: str, end: int) -> "Plot":
        """Returns the child at one end of a cut whose line becomes a hallway."""
        return Plot(rect, self.halls | {ENDS[axis][1 - end]}, self.path + str(end))
