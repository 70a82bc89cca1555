"""Where a square can walk: the free space of a storey.

The work is the core's (solver/core/validate/walk.hpp): the square's centre is free where the square meets no body and no wall. See
lattice.py for why gaps of exactly the square's side pass.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.core import ask
from solver.demanded import demand, still_allowed
from solver.scene import EXTERIOR
from solver.validator.kinds import Kinds
from solver.validator.lattice import WallEdge, exact
from solver.validator.sent_rooms import Floors, NumberedKinds, room_bytes, storey_bytes
from solver.validator.world import WAYS, Hole, PlacedRoom, World

DEEPEST_WALL: Final = exact(0.6)
"""As far as two rooms' wall lines may lie apart at a door between them: it goes through both. Our choice."""
ANY_NUMBER: Final = 1 << 60
MOST: Final = 80
"""How many boxes a tile of the floor holds before it is halved. Measured: of fewer there are more tiles, of more each has more cells."""
_FLOOR: Final = Struct("<5q")
_AREAS: Final = Struct("<4Q")
_JUDGED: Final = Struct("<3q")
_FINDING: Final = Struct("<8q")
_OPENED_BYTES: Final = 24
"""Of what is told of a front."""
LOOK_WORK: Final = 0.005
"""What the core counts as one: looking at two walls, rooms or openings [see demanded.py]. Measured."""


@dataclass(frozen=True)
class Walk:
    """The walk of one storey: who lives there, and what of its free floor one can come to.

    `entrances` are the ways in that were tried; none where the largest free floor stood in for them. `comes_in`: there is floor that
    one can come to. `tiles`, `cells`: into how many the floor was cut. `areas`: of each room the free centres that can be come to, and all,
    in square lattice steps. `missed`: of each room a byte a body, 0 but where it is used from sides that cannot be come to: then the sides
    that can be, as bits 1 << wall. `rows`: the storey as the core reads it.
    """

    places: tuple[PlacedRoom, ...]
    entrances: tuple[Hole, ...]
    comes_in: bool
    tiles: int
    cells: int
    areas: Mapping[str, tuple[int, int]]
    missed: Mapping[str, bytes]
    rows: bytes

    def floor(self, place: PlacedRoom, only_entered: bool = True) -> int:
        """Returns the area of a room's free centres: those that can be come to, or all."""
        entered, free = self.areas[place.room.id]
        return entered if only_entered else free


class JudgedRows(NamedTuple):
    """What the core tells of a room that was judged: what breaks a rule, of bodies and of the plan, and how far its fronts open.

    None where that was too much.
    """

    findings: Sequence[tuple[int, ...]] = ()
    of_plan: Sequence[tuple[int, ...]] = ()
    opened: bytes = b""


def walks(world: World, kinds: Kinds | None = None) -> tuple[Walk, ...]:
    """Walks every storey of a house; without kinds nothing is said of what is used."""
    table = NumberedKinds(kinds)
    sent = ([(place, room_bytes(world, place, table)) for place in places] for places in storeys(world))
    return tuple(judged_storey(world, rows, table)[0] for rows in sent)


def storeys(world: World) -> list[tuple[PlacedRoom, ...]]:
    """Returns a house's rooms storey by storey, from the lowest up."""
    found: dict[int, list[PlacedRoom]] = {}
    for place in world.places:
        found.setdefault(place.room.level, []).append(place)
    return [tuple(found[level]) for level in sorted(found)]


def judged_storey(
    world: World, placed: Sequence[tuple[PlacedRoom, bytes]], kinds: NumberedKinds, asked: Sequence[int] = (), most: int = 0
) -> tuple[Walk, Sequence[JudgedRows]]:
    """Walks the rooms of one storey, each with its bytes, and judges those asked for by their numbers.

    Where more than `most` breaks a rule in them, the rooms behind are not judged.

    Raises:
        TooMuch: the call may not have so much work.
    """
    places = tuple(place for place, _ in placed)
    entrances = _entrances(places)
    steps = [line.strip(line.start, line.end, 1) for line in (_line(place, hole) for place, hole in entrances)]
    rows = storey_bytes(world, placed, kinds, Floors(steps, MOST, DEEPEST_WALL))
    most_looks = int(min(still_allowed() / LOOK_WORK, ANY_NUMBER))
    told = ask("judge_storey", rows, pack(f"<{len(asked)}q", *asked), numbers=[most, most_looks])
    tiles, cells, comes_in, count, looks = _FLOOR.unpack_from(told)
    demand(LOOK_WORK * looks)
    at = _FLOOR.size + _AREAS.size * len(places)
    walked = zip(places, _AREAS.iter_unpack(told[_FLOOR.size : at]), strict=True)
    areas = {place.room.id: (high << 64 | low, free_high << 64 | free_low) for place, (high, low, free_high, free_low) in walked}
    judged, at = _judged_rows(told, at, count)
    missed = {}
    for place in places:
        end = at + place.count_bodies()
        missed[place.room.id] = told[at:end]
        at = end
    return Walk(places, tuple(hole for _, hole in entrances), bool(comes_in), tiles, cells, areas, missed, rows), judged


def _judged_rows(told: bytes, at: int, count: int) -> tuple[Sequence[JudgedRows], int]:
    """Returns from a place on what is told of the rooms that were judged, and where that ends."""
    found = list[JudgedRows]()
    counts = list(_JUDGED.iter_unpack(told[at : at + _JUDGED.size * count]))
    at += _JUDGED.size * count
    plan_at = at + _FINDING.size * sum(findings for findings, _, _ in counts)
    opened_at = plan_at + _FINDING.size * sum(of_plan for _, of_plan, _ in counts)
    for findings, of_plan, fronts in counts:
        end, plan_end, opened_end = at + _FINDING.size * findings, plan_at + _FINDING.size * of_plan, opened_at + _OPENED_BYTES * fronts
        broken, wrong = [*_FINDING.iter_unpack(told[at:end])], [*_FINDING.iter_unpack(told[plan_at:plan_end])]
        found.append(JudgedRows(broken, wrong, told[opened_at:opened_end]))
        at, plan_at, opened_at = end, plan_end, opened_end
    return found, opened_at


def _line(place: PlacedRoom, hole: Hole) -> WallEdge:
    """Returns the piece of wall line that a hole is in, in the house."""
    return hole.edge.moved(place.x, place.z)


def _entrances(places: Sequence[PlacedRoom]) -> list[tuple[PlacedRoom, Hole]]:
    """Returns the main entrance; else all doors to the outside."""
    ways = [(place, hole) for place in places for hole in place.holes if hole.opening.kind in WAYS]
    main = [way for way in ways if way[1].opening.main_entrance]
    return main or [way for way in ways if way[1].opening.connects_to == EXTERIOR]
