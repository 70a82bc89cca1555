"""The free floor of a room, against the tests' own flood of it and against the validator: the same verdict on random rooms."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver.free_floor import FreeFloor, Goal
from solver.furnish import space_of
from solver.geometry import Rect
from solver.pieces import Space, Walked
from solver.scene import Furniture, Opening, Room, Scene
from solver.streams import Stream
from solver.validator import validate
from tests.oracles.walk import missed
from tests.sweeps import seeds

KNOWN = load_catalogs()

WALLS = ("north", "south", "west", "east")


def cluttered(seed: int) -> tuple[Space, list[Rect], list[Goal], Rect]:
    """A room with two doors, boxes on a raster of 10 cm so that many gaps are just as wide as who walks, and one box more."""
    stream = Stream(seed, "cluttered")
    width, depth = 2.4 + stream.below(20) / 10, 2.4 + stream.below(20) / 10
    doors = tuple(
        Opening(f"door_{k}", "door", WALLS[stream.below(4)], 0.7 + stream.below(10) / 10, 0.8, connects_to=f"room_{k}") for k in (1, 2)
    )
    outline = None
    if stream.chance(0.3):
        outline = ((0.0, 0.0), (width, 0.0), (width, depth), (1.0, depth), (1.0, depth - 1.0), (0.0, depth - 1.0))
    room = Room("room_0", width=round(width, 1), depth=round(depth, 1), openings=doors, outline=outline)
    space = space_of(room, 0.1)
    boxes = [_box(space.clear, stream) for _ in range(2 + stream.below(5))]
    goals = [Goal(box, tuple(WALLS[: 1 + stream.below(4)]), stream.chance(0.3)) for box in boxes[:3]]
    return space, boxes, goals, _box(space.clear, stream)


def _box(clear: Rect, stream: Stream) -> Rect:
    wide, deep = 100 * (2 + stream.below(7)), 100 * (2 + stream.below(7))
    x, z = clear.x0 + 100 * stream.below(clear.width // 100), clear.z0 + 100 * stream.below(clear.depth // 100)
    return Rect(x, z, min(x + wide, clear.x1), min(z + deep, clear.z1))


@pytest.mark.parametrize("start", range(0, 600, 60))
def test_they_agree(start: int) -> None:
    verdicts = []
    for seed in range(start, start + 60):
        space, boxes, goals, more = cluttered(seed)
        uses = [(str(k), goal.rect, goal.sides, goal.need_all) for k, goal in enumerate(goals)]
        also = Goal(more, WALLS)
        found = FreeFloor(space, boxes, goals).connects([more], [also])
        told = missed(space, [*boxes, more], [*uses, ("more", more, WALLS, False)])
        assert found == (not told), (seed, told)
        verdicts.append(found)
    assert len(set(verdicts)) == 2


@pytest.mark.parametrize("start", range(0, 400, 100))
def test_doors_that_lead_outside_are_joined_there(start: int) -> None:
    eased = []
    for seed in range(start, start + 100):
        space, boxes, goals, _ = cluttered(seed)
        uses = [(str(k), goal.rect, goal.sides, goal.need_all) for k, goal in enumerate(goals)]
        stream = Stream(seed, "walked")
        ways: tuple[Walked, ...] = ("in", "in", "through", "not")
        outer = replace(space, doorways=tuple(door._replace(walked=stream.pick(ways)) for door in space.doorways))
        found = FreeFloor(outer, boxes, goals).connects()
        assert found == (not missed(outer, boxes, uses)), seed
        eased.append(found and not FreeFloor(space, boxes, goals).connects())
    assert set(eased) == {True, False}


def test_a_gap_just_as_wide_lets_through_and_a_millimetre_less_does_not() -> None:
    room = Room("room_0", width=3.0, depth=4.0, openings=(Opening("door", "door", "north", 1.5, 0.9, connects_to="EXTERIOR"),))
    space = space_of(room, 0.1)
    far = Goal(Rect(1200, 3500, 1800, 3950), ("north",))
    for gap, passes in ((600, True), (599, False)):
        barrier = [Rect(50, 1500, 2950 - gap, 2000), far.rect]
        assert FreeFloor(space, barrier, [far]).connects() is passes


def test_a_room_narrower_than_who_walks_is_closed() -> None:
    room = Room("room_0", width=0.6, depth=4.0, openings=(Opening("door", "door", "north", 0.3, 0.5, connects_to="EXTERIOR"),))
    assert not FreeFloor(space_of(room, 0.1), [], []).connects()


def drawn(seed: int) -> Room:
    """A small room with a door and some cupboards at millimetre places, gaps of the robot's width among them."""
    stream = Stream(seed, "boxes")
    width, depth = (2400 + stream.below(2000)) / 1000, (2200 + stream.below(2000)) / 1000
    pieces: list[Furniture] = []
    for k in range(1 + stream.below(5)):
        wide, deep = (200 + 2 * stream.below(500)) / 1000, (200 + 2 * stream.below(400)) / 1000
        low, high = 50 + round(wide * 500), round(width * 1000) - 50 - round(wide * 500)
        near, far = 50 + round(deep * 500), round(depth * 1000) - 50 - round(deep * 500)
        if low < high and near < far:
            x, z = (low + stream.below(high - low + 1)) / 1000, (near + stream.below(far - near + 1)) / 1000
            if stream.chance(0.5) and pieces:
                x = round(pieces[-1].x + pieces[-1].width / 2 + 0.6 + wide / 2, 4)
            pieces.append(Furniture(f"r/box_{k}", "dresser" if stream.chance(0.3) else "box", x=x, z=z, width=wide, depth=deep, height=1.0))
    wall = stream.pick(("north", "south"))
    door = Opening("d", wall=wall, position=0.7 + stream.unit() * (width - 1.4), connects_to="EXTERIOR", main_entrance=True)
    return Room("r", width=width, depth=depth, furniture=tuple(pieces), openings=(door,))


def rect(piece: Furniture) -> Rect:
    x, z, wide, deep = (round(value * 1000) for value in (piece.x, piece.z, piece.width / 2, piece.depth / 2))
    return Rect(x - wide, z - deep, x + wide, z + deep)


@pytest.mark.parametrize("start", range(0, 600, 100))
def test_the_validator_agrees(start: int) -> None:
    seen = {True: 0, False: 0}
    for seed in seeds(range(start, start + 100), 2):
        room = drawn(seed)
        space = space_of(room, 0.1)
        bodies = [rect(piece) for piece in room.furniture]
        square = space.doorways[0].square
        if any(body.overlaps(square) for body in bodies):
            continue
        issues = validate(Scene(wall_thickness=0.1, rooms=(room,)), KNOWN)
        told = [issue for issue in issues if issue.rule == "unreachable"]
        connected = FreeFloor.of_room(room, space, KNOWN.use_sides()).connects()
        assert connected == (not told), (seed, told)
        seen[connected] += 1
        if bodies and room.furniture[-1].name != "dresser":
            before = FreeFloor.of_room(replace(room, furniture=room.furniture[:-1]), space, KNOWN.use_sides())
            assert before.connects([bodies[-1]]) == connected
    assert min(seen.values()) > 5


def test_where_nobody_comes_in_one_walks_in_the_largest_part() -> None:
    space = space_of(Room("room_0", width=5.0, depth=2.0), 0.0)
    for wall, west, east in ((2000, False, True), (2900, True, False)):
        floor = [FreeFloor(space, [Rect(wall, 0, wall + 100, 2000)], [Goal.beside(Rect(x, 900, x + 100, 1000))]) for x in (0, 4900)]
        assert [one.connects() for one in floor] == [west, east]
