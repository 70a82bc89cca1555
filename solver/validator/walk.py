"""Where a square can walk: exact free space of a house, in components.

Comes in: a `World`. Goes out: for each storey its `Walk`. May import: scene.

The square's centre is free where the square meets no body and no wall: bodies and walls grown by half its side are what the
centre must stay out of. A grid's lines are the edges of those (tiled_floor.py), so a cell is free or taken as a whole; cells that
share a side and are both free are one component. See lattice.py for why gaps of exactly the square's side pass.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import NDArray

from solver.scene import EXTERIOR
from solver.validator.lattice import ExactBox, WallEdge, exact
from solver.validator.tiled_floor import TiledFloor
from solver.validator.world import OPPOSITE, WAYS, Hole, PlacedBody, PlacedRoom, World

HEADROOM: Final = exact(2.0)
"""What hangs higher than this is walked under; our choice, the height of a door."""
WALL_SLACK: Final = exact(0.25)
"""Two walls this close are one wall's two faces, and a door in one of them goes through both; our choice."""


Cuts = dict[tuple[bool, int], list[WallEdge]]
"""Ways through walls, by direction and by where their line lies, in steps of WALL_SLACK."""


@dataclass(frozen=True)
class Walk:
    """The walk of one storey: who lives there, its free floor, and the components of it that one can come to.

    `entrances` are the ways in that were tried; none where the largest component stood in for them.
    """

    places: tuple[PlacedRoom, ...]
    free: TiledFloor
    entered: frozenset[int]
    entrances: tuple[Hole, ...]
    reach: int

    def floor(self, place: PlacedRoom, only_entered: bool = True) -> int:
        """Returns the area of a room's free centres: those that can be come to, or all."""
        wanted = self._entered if only_entered else self._any
        return sum(self.free.area(box.moved(place.x, place.z), wanted) for box in place.outline.inside)

    def touches(self, place: PlacedRoom, body: PlacedBody, side: str) -> bool:
        """Tells whether the square can come to touch a side of a body, its centre within the side's extent."""
        contact = _contact(body.box.moved(place.x, place.z), side, self.reach)
        return not self.entered.isdisjoint(self.free.components(contact))

    @cached_property
    def _entered(self) -> NDArray[np.bool_]:
        wanted = np.zeros(self.free.count + 1, dtype=bool)
        wanted[sorted(self.entered)] = True
        return wanted

    @cached_property
    def _any(self) -> NDArray[np.bool_]:
        return np.arange(self.free.count + 1) > 0


def _contact(box: ExactBox, side: str, reach: int) -> ExactBox:
    """Returns the step of the lattice where the centre is while the square touches that side of a box."""
    line, outwards = {"north": (box.z0, -1), "south": (box.z1, 1), "west": (box.x0, -1), "east": (box.x1, 1)}[side]
    start, end = (box.x0, box.x1) if side in ("north", "south") else (box.z0, box.z1)
    return WallEdge(OPPOSITE[side], line + outwards * reach, start, end).strip(start, end, 1)


def walks(world: World) -> tuple[Walk, ...]:
    """Walks every storey of a house."""
    return tuple(walk_of(world, places) for places in storeys(world))


def storeys(world: World) -> list[tuple[PlacedRoom, ...]]:
    """Returns a house's rooms storey by storey, from the lowest up."""
    found: dict[int, list[PlacedRoom]] = {}
    for place in world.places:
        found.setdefault(place.room.level, []).append(place)
    return [tuple(found[level]) for level in sorted(found)]


def walk_of(world: World, places: tuple[PlacedRoom, ...]) -> Walk:
    """Walks the rooms of one storey."""
    reach = world.robot // 2 - 1
    floors = [box.moved(place.x, place.z) for place in places for box in place.outline.inside]
    bridges, cuts = _doorways(world, places)
    standing = [(place, body) for place in places for body in place.bodies if body.low < HEADROOM]
    bodies = [body.box.moved(place.x, place.z).grown(reach) for place, body in standing]
    edges = [edge.moved(place.x, place.z) for place in places for edge in place.edges]
    walls = [wall for edge in edges for wall in _walls(edge, _near(cuts, edge), world.half_wall, reach)]
    free = TiledFloor([*floors, *bridges], [*bodies, *walls])
    entrances = _entrances(places)
    entered = _entered(free, entrances) if entrances else {free.largest()} - {0}
    return Walk(places, free, frozenset(entered), tuple(hole for _, hole in entrances), reach)


def _doorways(world: World, places: Sequence[PlacedRoom]) -> tuple[list[ExactBox], Cuts]:
    """Returns the floor inside doorways between walls that lie apart, and every way through as a piece of wall line."""
    bridges: list[ExactBox] = []
    cuts: Cuts = defaultdict(list)
    for place in places:
        for hole in place.holes:
            if hole.opening.kind in WAYS:
                cut = WallEdge(hole.edge.side, hole.edge.line, hole.start, hole.end).moved(place.x, place.z)
                cuts[cut.runs_east, cut.line // WALL_SLACK].append(cut)
                beyond = world.by_id.get(hole.opening.connects_to or "")
                bridges += _bridges(cut, beyond) if beyond else []
    return bridges, cuts


def _bridges(cut: WallEdge, beyond: PlacedRoom) -> Iterator[ExactBox]:
    for edge in beyond.edges:
        wall = edge.moved(beyond.x, beyond.z)
        gap = (cut.line - wall.line) * (1 if cut.side in ("north", "west") else -1)
        start, end = max(cut.start, wall.start), min(cut.end, wall.end)
        if edge.side == OPPOSITE[cut.side] and 0 < gap <= WALL_SLACK and start < end:
            yield cut.strip(start, end, 0, outwards=gap)


def _near(cuts: Cuts, edge: WallEdge) -> list[WallEdge]:
    """Returns the ways through a piece of wall line: those that run along it, no farther than a wall is thick."""
    shelf = edge.line // WALL_SLACK
    near = [cut for step in (-1, 0, 1) for cut in cuts.get((edge.runs_east, shelf + step), ())]
    return [cut for cut in near if abs(cut.line - edge.line) <= WALL_SLACK and cut.start < edge.end and edge.start < cut.end]


def _walls(edge: WallEdge, cuts: Iterable[WallEdge], half_wall: int, reach: int) -> Iterator[ExactBox]:
    """Returns what the centre must stay out of along a piece of wall line: all of it but its ways through.

    At a corner the wall goes on by half its thickness, at a jamb it ends.
    """
    inside = sorted((max(cut.start, edge.start), min(cut.end, edge.end)) for cut in cuts)
    deep = half_wall + reach
    start, before = edge.start, deep
    for jamb, far_jamb in inside:
        if jamb > start:
            yield edge.strip(start - before, jamb + reach, deep, deep)
        if far_jamb >= start:
            start, before = far_jamb, reach
    if start < edge.end:
        yield edge.strip(start - before, edge.end + deep, deep, deep)


def _entrances(places: Sequence[PlacedRoom]) -> list[tuple[PlacedRoom, Hole]]:
    """Returns the main entrance; else all doors to the outside."""
    ways = [(place, hole) for place in places for hole in place.holes if hole.opening.kind in WAYS]
    main = [way for way in ways if way[1].opening.main_entrance]
    return main or [way for way in ways if way[1].opening.connects_to == EXTERIOR]


def _entered(free: TiledFloor, entrances: Sequence[tuple[PlacedRoom, Hole]]) -> set[int]:
    """Returns the components that lie along an entrance's wall line, inside."""
    found: set[int] = set()
    for place, hole in entrances:
        line = WallEdge(hole.edge.side, hole.edge.line, hole.start, hole.end).moved(place.x, place.z)
        found |= free.components(line.strip(line.start, line.end, 1))
    return found
