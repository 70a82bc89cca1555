"""Where a square can walk: exact free space of a house, as a grid cut at every edge that matters.

Comes in: a `World`. Goes out: for each storey its `Walk`. May import: scene.

The square's centre is free where the square meets no body and no wall: bodies and walls grown by half its side are what the
centre must stay out of. The grid's lines are the edges of those, so a cell is free or taken as a whole; cells that share a
side and are both free are one walk. See lattice.py for why gaps of exactly the square's side pass.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.scene import EXTERIOR
from solver.validate.lattice import Box, Edge, exact
from solver.validate.patches import label
from solver.validate.world import OPPOSITE, WAYS, Body, Hole, Place, World

HEADROOM: Final = exact(2.0)
"""What hangs higher than this is walked under; our choice, the height of a door."""
WALL_SLACK: Final = exact(0.25)
"""Two walls this close are one wall's two faces, and a door in one of them goes through both; our choice."""


class Grid:
    """Floor less obstacles, as cells between all their edges."""

    def __init__(self, floors: Sequence[Box], obstacles: Sequence[Box]) -> None:
        boxes = np.array([*floors, *obstacles], dtype=np.int64).reshape(-1, 4)
        self.xs: NDArray[np.int64] = np.unique(boxes[:, ::2])
        self.zs: NDArray[np.int64] = np.unique(boxes[:, 1::2])
        west, east = np.searchsorted(self.xs, boxes[:, 0]), np.searchsorted(self.xs, boxes[:, 2])
        north, south = np.searchsorted(self.zs, boxes[:, 1]), np.searchsorted(self.zs, boxes[:, 3])
        self.free: NDArray[np.bool_] = np.zeros((max(len(self.xs) - 1, 0), max(len(self.zs) - 1, 0)), dtype=bool)
        spans = list(zip(west.tolist(), east.tolist(), north.tolist(), south.tolist(), strict=True))
        for index, (x0, x1, z0, z1) in enumerate(spans):
            self.free[x0:x1, z0:z1] = index < len(floors)

    def cells(self, box: Box) -> tuple[slice, slice]:
        """Returns the cells that a box meets."""
        return _between(self.xs, box.x0, box.x1), _between(self.zs, box.z0, box.z1)

    def area(self, chosen: NDArray[np.bool_], window: tuple[slice, slice]) -> int:
        """Sums the exact area of chosen cells of a window, in square lattice steps."""
        wide = np.diff(self.xs)[window[0]].tolist()
        deep = chosen @ np.diff(self.zs)[window[1]]
        return sum(int(x) * int(z) for x, z in zip(wide, deep.tolist(), strict=True))


def _between(cuts: NDArray[np.int64], low: int, high: int) -> slice:
    start = int(np.searchsorted(cuts, low, side="right")) - 1
    return slice(max(start, 0), max(int(np.searchsorted(cuts, high, side="left")), 0))


@dataclass(frozen=True)
class Walk:
    """The walk of one storey: who lives there, the free cells' labels (0: taken), and the labels one can come to.

    `entrances` are the ways in that were tried; none where the largest free patch stood in for them.
    """

    places: tuple[Place, ...]
    grid: Grid
    labels: NDArray[np.int64]
    entered: frozenset[int]
    entrances: tuple[Hole, ...]
    reach: int

    @cached_property
    def _entered_cells(self) -> NDArray[np.bool_]:
        marks = np.zeros(int(self.labels.max(initial=0)) + 1, dtype=bool)
        marks[sorted(self.entered)] = True
        return marks[self.labels]

    def floor(self, place: Place, only_entered: bool = True) -> int:
        """Returns the area of a room's free centres: those that can be come to, or all."""
        chosen = self._entered_cells if only_entered else self.labels > 0
        boxes = (box.moved(place.x, place.z) for box in place.outline.inside)
        windows = [self.grid.cells(box) for box in boxes]
        return sum(self.grid.area(chosen[window], window) for window in windows)

    def touches(self, place: Place, body: Body, side: str) -> bool:
        """Tells whether the square can come to touch a side of a body, its centre within the side's extent."""
        box = body.box.moved(place.x, place.z)
        window = self.grid.cells(_contact(box, side, self.reach))
        return bool(self._entered_cells[window].any())


def _contact(box: Box, side: str, reach: int) -> Box:
    """Returns the step of the lattice where the centre is while the square touches that side of a box."""
    line, outwards = {"north": (box.z0, -1), "south": (box.z1, 1), "west": (box.x0, -1), "east": (box.x1, 1)}[side]
    start, end = (box.x0, box.x1) if side in ("north", "south") else (box.z0, box.z1)
    return Edge(OPPOSITE[side], line + outwards * reach, start, end).strip(start, end, 1)


def walks(world: World) -> tuple[Walk, ...]:
    """Walks every storey of a house."""
    levels = sorted({place.room.level for place in world.places})
    return tuple(_walk(world, tuple(place for place in world.places if place.room.level == level)) for level in levels)


def _walk(world: World, places: tuple[Place, ...]) -> Walk:
    reach = world.robot // 2 - 1
    floors = [box.moved(place.x, place.z) for place in places for box in place.outline.inside]
    bridges, cuts = _doorways(world, places)
    standing = [(place, body) for place in places for body in place.bodies if body.low < HEADROOM]
    bodies = [body.box.moved(place.x, place.z).grown(reach) for place, body in standing]
    edges = [edge.moved(place.x, place.z) for place in places for edge in place.edges]
    walls = [wall for edge in edges for wall in _walls(edge, cuts, world.half_wall, reach)]
    grid = Grid([*floors, *bridges], [*bodies, *walls])
    labels = label(grid.free)
    entrances = _entrances(places)
    entered = _entered(grid, labels, entrances) if entrances else _largest(grid, labels)
    return Walk(places, grid, labels, entered, tuple(hole for _, hole in entrances), reach)


def _doorways(world: World, places: Sequence[Place]) -> tuple[list[Box], list[Edge]]:
    """Returns the floor inside doorways between walls that lie apart, and every way through as a piece of wall line."""
    bridges: list[Box] = []
    cuts: list[Edge] = []
    for place in places:
        for hole in place.holes:
            if hole.opening.kind in WAYS:
                cut = Edge(hole.edge.side, hole.edge.line, hole.start, hole.end).moved(place.x, place.z)
                cuts.append(cut)
                beyond = world.by_id.get(hole.opening.connects_to or "")
                bridges += _bridges(cut, beyond) if beyond else []
    return bridges, cuts


def _bridges(cut: Edge, beyond: Place) -> Iterator[Box]:
    for edge in beyond.edges:
        wall = edge.moved(beyond.x, beyond.z)
        gap = (cut.line - wall.line) * (1 if cut.side in ("north", "west") else -1)
        start, end = max(cut.start, wall.start), min(cut.end, wall.end)
        if edge.side == OPPOSITE[cut.side] and 0 < gap <= WALL_SLACK and start < end:
            yield cut.strip(start, end, 0, outwards=gap)


def _walls(edge: Edge, cuts: Iterable[Edge], half_wall: int, reach: int) -> Iterator[Box]:
    """Returns what the centre must stay out of along a piece of wall line: all of it but its ways through.

    At a corner the wall goes on by half its thickness, at a jamb it ends.
    """
    inside = sorted(
        (max(cut.start, edge.start), min(cut.end, edge.end))
        for cut in cuts
        if cut.runs_east == edge.runs_east and abs(cut.line - edge.line) <= WALL_SLACK and cut.start < edge.end and edge.start < cut.end
    )
    deep = half_wall + reach
    start, before = edge.start, deep
    for jamb, far_jamb in inside:
        if jamb > start:
            yield edge.strip(start - before, jamb + reach, deep, deep)
        if far_jamb >= start:
            start, before = far_jamb, reach
    if start < edge.end:
        yield edge.strip(start - before, edge.end + deep, deep, deep)


def _entrances(places: Sequence[Place]) -> list[tuple[Place, Hole]]:
    """Returns the main entrance; else all doors to the outside."""
    ways = [(place, hole) for place in places for hole in place.holes if hole.opening.kind in WAYS]
    main = [way for way in ways if way[1].opening.main_entrance]
    return main or [way for way in ways if way[1].opening.connects_to == EXTERIOR]


def _entered(grid: Grid, labels: NDArray[np.int64], entrances: Sequence[tuple[Place, Hole]]) -> frozenset[int]:
    """Returns the labels of the free cells that lie along an entrance's wall line, inside."""
    found: set[int] = set()
    for place, hole in entrances:
        line = Edge(hole.edge.side, hole.edge.line, hole.start, hole.end).moved(place.x, place.z)
        found.update(labels[grid.cells(line.strip(line.start, line.end, 1))].ravel().tolist())
    return frozenset(found - {0})


def _largest(grid: Grid, labels: NDArray[np.int64]) -> frozenset[int]:
    areas = np.outer(np.diff(grid.xs).astype(float), np.diff(grid.zs).astype(float))
    sums = np.bincount(labels.ravel(), weights=areas.ravel(), minlength=1)
    sums[0] = 0.0
    return frozenset({int(np.argmax(sums))} - {0})
