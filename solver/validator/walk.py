"""Where a square can walk: the free space of a storey.

The work is the core's (solver/core/validate/walk.hpp): the square's centre is free where the square meets no body and no wall. See
lattice.py for why gaps of exactly the square's side pass.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from struct import Struct
from typing import Final

from solver.core import ask
from solver.scene import EXTERIOR, WALLS
from solver.validator.lattice import ExactBox, WallEdge, exact
from solver.validator.sent_rooms import room_bytes, storey_bytes
from solver.validator.world import OPPOSITE, WAYS, Hole, PlacedRoom, World

DEEPEST_WALL: Final = exact(0.6)
"""As far as two rooms' wall lines may lie apart at a door between them: it goes through both. Our choice."""
MOST: Final = 400
"""How many boxes a tile of the floor holds before it is halved: houses of 30 rooms stay one tile. Our choice."""
_WALLS_OF: Final = [frozenset(wall for i, wall in enumerate(WALLS) if bits >> i & 1) for bits in range(1 << len(WALLS))]
"""The walls that the bits of a number mean."""
_AREAS: Final = Struct("<4Q")
_TAIL: Final = Struct("<3q")


@dataclass(frozen=True)
class Walk:
    """The walk of one storey: who lives there, and what of its free floor one can come to.

    `entrances` are the ways in that were tried; none where the largest free floor stood in for them. `comes_in`: there is floor that
    one can come to. `tiles`, `cells`: into how many the floor was cut. `areas`: of each room the free centres that can be come to, and all,
    in square lattice steps. `sides`: of each room a byte a body. `rows`: the storey as the core reads it.
    """

    places: tuple[PlacedRoom, ...]
    entrances: tuple[Hole, ...]
    comes_in: bool
    tiles: int
    cells: int
    areas: Mapping[str, tuple[int, int]]
    sides: Mapping[str, bytes]
    rows: bytes

    def floor(self, place: PlacedRoom, only_entered: bool = True) -> int:
        """Returns the area of a room's free centres: those that can be come to, or all."""
        entered, free = self.areas[place.room.id]
        return entered if only_entered else free

    def touched(self, place: PlacedRoom, number: int) -> frozenset[str]:
        """Returns which walls the sides of a piece look to that the square can come to touch, its centre within their extent."""
        return _WALLS_OF[self.sides[place.room.id][number]]


def walks(world: World) -> tuple[Walk, ...]:
    """Walks every storey of a house."""
    return tuple(walk_of(world, [(place, room_bytes(world, place, None)) for place in places]) for places in storeys(world))


def storeys(world: World) -> list[tuple[PlacedRoom, ...]]:
    """Returns a house's rooms storey by storey, from the lowest up."""
    found: dict[int, list[PlacedRoom]] = {}
    for place in world.places:
        found.setdefault(place.room.level, []).append(place)
    return [tuple(found[level]) for level in sorted(found)]


def walk_of(world: World, placed: Sequence[tuple[PlacedRoom, bytes]]) -> Walk:
    """Walks the rooms of one storey, each with its bytes."""
    places = tuple(place for place, _ in placed)
    entrances = _entrances(places)
    steps = [line.strip(line.start, line.end, 1) for line in (_line(place, hole) for place, hole in entrances)]
    rows = storey_bytes(world, placed, list(_bridges(world, places)), steps, MOST)
    told = ask("walk_storey", rows)
    at = _AREAS.size * len(places)
    areas, sides = {}, {}
    for place, (high, low, free_high, free_low) in zip(places, _AREAS.iter_unpack(told[:at]), strict=True):
        areas[place.room.id] = (high << 64 | low, free_high << 64 | free_low)
    for place in places:
        end = at + place.count_bodies()
        sides[place.room.id] = told[at:end]
        at = end
    tiles, cells, comes_in = _TAIL.unpack_from(told, at)
    return Walk(places, tuple(hole for _, hole in entrances), bool(comes_in), tiles, cells, areas, sides, rows)


def _line(place: PlacedRoom, hole: Hole) -> WallEdge:
    """Returns the piece of wall line that a hole is in, in the house."""
    return hole.edge.moved(place.x, place.z)


def _bridges(world: World, places: Iterable[PlacedRoom]) -> Iterator[ExactBox]:
    """Yields the floor inside doorways between walls that lie apart."""
    for place in places:
        for hole in place.holes:
            beyond = world.by_id.get(hole.opening.connects_to or "") if hole.opening.kind in WAYS else None
            if beyond is not None:
                yield from _bridges_to(_line(place, hole), beyond)


def _bridges_to(cut: WallEdge, beyond: PlacedRoom) -> Iterator[ExactBox]:
    for edge in beyond.edges:
        if edge.side != OPPOSITE[cut.side]:
            continue
        wall = edge.moved(beyond.x, beyond.z)
        gap = (cut.line - wall.line) * (1 if cut.side in ("north", "west") else -1)
        start, end = max(cut.start, wall.start), min(cut.end, wall.end)
        if 0 < gap <= DEEPEST_WALL and start < end:
            yield cut.strip(start, end, 0, outwards=gap)


def _entrances(places: Sequence[PlacedRoom]) -> list[tuple[PlacedRoom, Hole]]:
    """Returns the main entrance; else all doors to the outside."""
    ways = [(place, hole) for place in places for hole in place.holes if hole.opening.kind in WAYS]
    main = [way for way in ways if way[1].opening.main_entrance]
    return main or [way for way in ways if way[1].opening.connects_to == EXTERIOR]
