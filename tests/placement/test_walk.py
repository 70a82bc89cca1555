"""The walk against a flood over every 50 mm, exact where all edges are multiples of 100 mm, and one over all edges, exact anywhere."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import pytest

from solver.free_floor import FreeFloor
from solver.geometry import LEAST_FLOOR_MM2, Rect
from solver.pieces import Candidate, Doorway, Piece, Space, Stand, Walked, Zone
from solver.placement import Budget
from solver.placement.core import Core
from solver.placement.encode import encode
from solver.placement.walkable import find_walkable
from solver.streams import Stream
from tests.every import every
from tests.oracles import sums
from tests.oracles.problem import problem_of
from tests.oracles.walk import missed, side_towards
from tests.sweeps import seeds

STEP = 50
HALF = 300
CASES = 160
SIDES = ("front", "back", "left", "right")
Point = tuple[int, int]


@dataclass(frozen=True)
class Body:
    """What stands in the room, how it is turned and which of its sides are used."""

    rect: Rect
    rotation: int = 0
    sides: tuple[str, ...] = ()
    need_all: bool = False
    bottom: int = 0

    def wanted(self, label: str) -> Piece:
        """The body as a piece that can stand in this one place only."""
        size = (self.rect.width, self.rect.depth) if self.rotation % 180 == 0 else (self.rect.depth, self.rect.width)
        way = Candidate("box", (*size, 700), self.rotation, within=self.rect, bottom_mm=self.bottom)
        return Piece(label, True, (way,), stands=tuple(Stand(side) for side in self.sides), need_all=self.need_all)


def walks(space: Space, bodies: Sequence[Body]) -> bool:
    """Asks the kernel."""
    core = Core(encode(space, [body.wanted(f"box_{k}") for k, body in enumerate(bodies)], "test"))
    decisions = core.first_decisions()
    assert decisions is not None
    core.evaluate(decisions, 1, Budget(), False)
    problem = problem_of(core)
    assert [sums.rect(part, problem.low) for part in problem.boxes] == [body.rect for body in bodies]
    return core.walkable_at(problem.low)


def touching(rect: Rect, wall: str) -> set[Point]:
    """Where the centre is, on the raster, while the person touches a side of a body."""
    if wall in ("north", "south"):
        z = rect.z0 - HALF if wall == "north" else rect.z1 + HALF
        return {(x, z) for x in range(rect.x0, rect.x1 + 1, STEP)}
    x = rect.x0 - HALF if wall == "west" else rect.x1 + HALF
    return {(x, z) for z in range(rect.z0, rect.z1 + 1, STEP)}


def through(space: Space, door: Doorway) -> set[Point]:
    """Where the centre is, on the raster, when the person has come through a door."""
    clear, square = space.clear, door.square
    if door.wall in ("north", "south"):
        z = clear.z0 + HALF if door.wall == "north" else clear.z1 - HALF
        return {(x, z) for x in range(max(square.x0, clear.x0) + HALF, min(square.x1, clear.x1) - HALF + 1, STEP)}
    x = clear.x0 + HALF if door.wall == "west" else clear.x1 - HALF
    return {(x, z) for z in range(max(square.z0, clear.z0) + HALF, min(square.z1, clear.z1) - HALF + 1, STEP)}


class Raster:
    """The centre of a 600 mm square in steps of 50 mm."""

    def __init__(self, space: Space, bodies: Sequence[Body]) -> None:
        self.clear = space.clear
        self.solids = [body.rect for body in bodies if body.bottom < 2000]
        self.solids += [zone.rect for zone in space.zones if zone.cause == "outline"]

    def free(self, x: float, z: float) -> bool:
        clear = self.clear
        inside = clear.x0 <= x - HALF and x + HALF <= clear.x1 and clear.z0 <= z - HALF and z + HALF <= clear.z1
        return inside and not any(x - HALF < r.x1 and r.x0 < x + HALF and z - HALF < r.z1 and r.z0 < z + HALF for r in self.solids)

    def flood(self, starts: Iterable[Point]) -> set[Point]:
        """All that can be come to from some points, as far as these are free."""
        seen = {start for start in starts if self.free(*start)}
        queue = deque(seen)
        while queue:
            x, z = queue.popleft()
            for step in ((x + STEP, z), (x - STEP, z), (x, z + STEP), (x, z - STEP)):
                if step not in seen and self.free(*step):
                    seen.add(step)
                    queue.append(step)
        return seen

    def area(self, points: Iterable[Point]) -> int:
        """The area of the raster's cells, mm2, that lie beside the points and are wholly free."""
        return STEP * STEP * sum(self.free(x + STEP / 2, z + STEP / 2) for x, z in points)


def raster_walks(space: Space, bodies: Sequence[Body], least_mm2: int = LEAST_FLOOR_MM2) -> bool:
    """Moves the square from all doors that one comes into the house by at once; without one from the first door."""
    raster = Raster(space, bodies)
    outer = [through(space, door) for door in space.doorways if door.walked == "in"]
    goals = [([through(space, door)], True) for door in space.doorways if door.walked == "through"]
    goals += [([touching(b.rect, side_towards(side, b.rotation)) for side in b.sides], b.need_all) for b in bodies if b.sides]
    starts = [[point for door in outer for point in door]] if outer else [[point] for point in sorted(goals[0][0][0])]
    come_to: set[Point] = set()
    for start in starts:
        if come_to.issuperset(start):
            continue  # all of the same floor have been where this one would go
        seen = raster.flood(start)
        come_to |= seen
        met = [[bool(seen & side) for side in sides] for sides, _ in goals]
        if all(all(m) if need_all else any(m) for m, (_, need_all) in zip(met, goals, strict=True)) and raster.area(seen) >= least_mm2:
            return True
    return False


def square_at(wall: str, clear: Rect, at: int) -> Rect:
    """The 900 mm square inside a door that begins `at` mm along its wall."""
    return {
        "south": Rect(clear.x0 + at, clear.z1 - 900, clear.x0 + at + 900, clear.z1),
        "north": Rect(clear.x0 + at, clear.z0, clear.x0 + at + 900, clear.z0 + 900),
        "west": Rect(clear.x0, clear.z0 + at, clear.x0 + 900, clear.z0 + at + 900),
        "east": Rect(clear.x1 - 900, clear.z0 + at, clear.x1, clear.z0 + at + 900),
    }[wall]


def random_case(seed: int, unit: int) -> tuple[Space, list[Body]]:
    """A room of 2.4-4.4 m with 1-3 doors, often a corner missing, and 3-7 boxes whose sides are used, all on multiples of `unit`."""
    stream = Stream(seed, "walk", unit)

    def length(low: int, high: int) -> int:
        return low // unit * unit + unit * stream.below((high - low) // unit + 1)

    clear = Rect(0, 0, length(2400, 4400), length(2400, 4400))
    doors = []
    for k, wall in enumerate(("south", "north", "east")[: 1 + stream.below(3)]):
        span = clear.width if wall in ("south", "north") else clear.depth
        doors.append(Doorway(f"door_{k}", wall, square_at(wall, clear, length(0, span - 900)), "hall"))
    zones = []
    if stream.chance(0.4):
        corner = Rect(0, 0, length(300, 1200), length(300, 1200))
        if not any(corner.overlaps(door.square) for door in doors):
            zones.append(Zone(corner, -1, "outline"))
    bodies: list[Body] = []
    for _ in range(3 + stream.below(5)):
        x, z = length(0, clear.x1 - 300), length(0, clear.z1 - 300)
        rect = Rect(x, z, min(x + length(300, 1400), clear.x1), min(z + length(300, 1100), clear.z1))
        if any(rect.overlaps(door.square) for door in doors) or any(rect.overlaps(zone.rect) for zone in zones):
            continue
        sides = tuple(side for side in SIDES if stream.chance(0.3)) if stream.chance(0.4) else ()
        bodies.append(Body(rect, 90 * stream.below(4), sides, stream.chance(0.5)))
    return Space("room", clear, tuple(zones), tuple(doors)), bodies


@every("seed", range(CASES))
def test_the_walk_agrees_with_the_raster(seed: int) -> None:
    space, bodies = random_case(seed, 100)
    assert walks(space, bodies) == raster_walks(space, bodies)


def with_outer_doors(seed: int) -> tuple[Space, list[Body]]:
    """The same with one to all of its doors leading out of the house, and some that need not be come to."""
    space, bodies = random_case(seed, 100)
    stream = Stream(seed, "outer doors")
    ways: tuple[Walked, ...] = ("in", "in", "through", "not")
    uses = ["in" if k == 0 else stream.pick(ways) for k in range(len(space.doorways))]
    return replace(space, doorways=tuple(door._replace(walked=use) for door, use in zip(space.doorways, uses, strict=True))), bodies


@pytest.mark.parametrize("block", range(4))
def test_outer_doors_are_joined_outside(block: int) -> None:
    verdicts, eased = [], []
    for seed in seeds(range(block, 400, 4), 2):
        space, bodies = with_outer_doors(seed)
        verdicts.append(walks(space, bodies))
        assert verdicts[-1] == raster_walks(space, bodies), seed
        joined = replace(space, doorways=tuple(door._replace(walked="through") for door in space.doorways))
        eased.append(verdicts[-1] and not walks(joined, bodies))
    assert set(verdicts) == set(eased) == {True, False}


def test_no_body_bars_the_way_where_one_can_come_in_on_both_sides() -> None:
    """A bar from wall to wall: what is used on its far side can be come to by the other door."""
    other = Doorway("door_2", "north", Rect(2100, 0, 3000, 900), "EXTERIOR", "in")
    bar = Body(Rect(0, 1400, 3000, 1500), 0, ("front",)).wanted("bar")
    chest = CHEST.wanted("chest")
    for doors, verdict in ((DOOR, other), False), ((DOOR._replace(walked="in"), other), True), ((DOOR._replace(walked="in"),), False):
        assert find_walkable(replace(ROOM, doorways=doors), (bar, chest), Budget())[0] is verdict, doors


def test_the_cases_ask_for_what_they_should() -> None:
    cases = [random_case(seed, 100) for seed in range(CASES)]
    verdicts = [walks(*case) for case in cases]
    assert min(verdicts.count(True), verdicts.count(False)) > CASES // 6
    used = [body for _, bodies in cases for body in bodies if len(body.sides) > 1]
    assert {body.need_all for body in used} == {True, False}
    assert sum(bool(space.zones) for space, _ in cases) > 20
    assert {len(space.doorways) for space, _ in cases} == {1, 2, 3}


@pytest.mark.parametrize("block", range(4))
def test_the_walk_agrees_with_the_flood_over_all_edges(block: int) -> None:
    verdicts = []
    for seed in range(block, 600, 4):
        space, bodies = random_case(seed, 1)
        uses = [(f"box_{k}", b.rect, [side_towards(s, b.rotation) for s in b.sides], b.need_all) for k, b in enumerate(bodies) if b.sides]
        expected = not missed(space, [body.rect for body in bodies], uses)
        assert walks(space, bodies) == expected, seed
        verdicts.append(expected)
    assert set(verdicts) == {True, False}


DOOR = Doorway("door_1", "south", Rect(0, 2100, 900, 3000), "hall")
ROOM = Space("room", Rect(0, 0, 3000, 3000), (), (DOOR,))
CHEST = Body(Rect(0, 0, 600, 500), 0, ("front",))


@pytest.mark.parametrize(("gap", "passes"), [(600, True), (599, False)])
def test_a_gap_of_exactly_the_width_is_enough(gap: int, passes: bool) -> None:
    assert walks(ROOM, [Body(Rect(0, 1400, 3000 - gap, 1500)), CHEST]) is passes


@pytest.mark.parametrize(("gap", "passes"), [(600, True), (599, False)])
def test_a_gap_between_two_bodies_is_enough_too(gap: int, passes: bool) -> None:
    assert walks(ROOM, [Body(Rect(0, 1400, 1300, 1500)), Body(Rect(1300 + gap, 1400, 3000, 1500)), CHEST]) is passes


@pytest.mark.parametrize(("gap", "passes"), [(600, True), (599, False)])
def test_a_gap_beside_a_missing_part_is_enough_too(gap: int, passes: bool) -> None:
    room = Space("room", ROOM.clear, (Zone(Rect(1300 + gap, 0, 3000, 1800), -1, "outline"),), (DOOR,))
    assert walks(room, [Body(Rect(0, 1400, 1300, 1500)), CHEST]) is passes


@pytest.mark.parametrize(("depth", "passes"), [(600, True), (599, False)])
def test_there_must_be_room_before_a_side(depth: int, passes: bool) -> None:
    """Its front looks at another body; the person comes from the side."""
    assert walks(ROOM, [CHEST, Body(Rect(0, 500 + depth, 600, 1300))]) is passes


def test_any_side_or_all_sides() -> None:
    both = partial(Body, Rect(1000, 0, 1600, 500), sides=("left", "front"))
    shut = Body(Rect(500, 0, 1000, 500))
    assert walks(ROOM, [both(need_all=True)])
    assert walks(ROOM, [both(need_all=False), shut])
    assert not walks(ROOM, [both(need_all=True), shut])


@pytest.mark.parametrize("rotation", [0, 90, 180, 270])
def test_sides_turn_with_their_body(rotation: int) -> None:
    """In the middle of the north wall only what looks away from the wall can be got to, once both flanks are shut."""
    bodies = [Body(Rect(700, 0, 1200, 500)), Body(Rect(1700, 0, 2200, 500))]
    looks_south = {0: "front", 90: "left", 180: "back", 270: "right"}[rotation]
    for side in SIDES:
        assert walks(ROOM, [*bodies, Body(Rect(1200, 0, 1700, 500), rotation, (side,))]) is (side == looks_south)


@pytest.mark.parametrize("blocked", [False, True])
def test_doors_are_joined_with_each_other(blocked: bool) -> None:
    other = Doorway("door_2", "north", Rect(2100, 0, 3000, 900), "hall")
    room = Space("room", ROOM.clear, (), (DOOR, other))
    wall = [Body(Rect(0, 1400, 2401 if blocked else 2400, 1500))]
    assert walks(room, wall) is not blocked


@pytest.mark.parametrize(("bottom", "passes"), [(2000, True), (1999, False)])
def test_what_hangs_higher_than_two_metres_is_walked_under(bottom: int, passes: bool) -> None:
    assert walks(ROOM, [Body(Rect(0, 1400, 3000, 1500), bottom=bottom), CHEST]) is passes


@pytest.mark.parametrize(("width", "passes"), [(1100, True), (1099, False)])
def test_a_room_needs_a_quarter_of_a_square_metre(width: int, passes: bool) -> None:
    """1.10 x 1.10 m leave the centre 0.50 x 0.50 m: the limit itself."""
    door = Doorway("door_1", "south", Rect(0, 200, 900, 1100), "hall")
    space = Space("room", Rect(0, 0, width, 1100), (), (door,))
    assert walks(space, []) is FreeFloor(space, [], []).connects() is passes


def test_an_island_of_free_floor_does_not_count() -> None:
    """The area is that of the part one comes in to: here 0.5 x 0.4 m, however large the other."""
    island = Space("room", Rect(0, 0, 1100, 4000), (), (Doorway("d", "south", Rect(0, 3100, 900, 4000), "hall"),))
    assert walks(island, [Body(Rect(0, 2300, 1100, 2800))])
    assert not walks(island, [Body(Rect(0, 2400, 1100, 3000))])


def test_without_doors_one_is_in_the_largest_part() -> None:
    space = Space("room", ROOM.clear, (), ())
    wall = Body(Rect(0, 1000, 3000, 1100))
    assert walks(space, [wall, Body(Rect(0, 2700, 600, 3000), 180, ("front",))])
    assert not walks(space, [wall, Body(Rect(0, 0, 600, 300), 0, ("front",))])
