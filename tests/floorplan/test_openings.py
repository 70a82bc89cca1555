"""Doors, windows, the main entrance, garage doors; moving a door afterwards."""

from __future__ import annotations

import pytest

from catalogs import load_catalogs
from solver.floorplan import FloorPlan, door_positions, draw, with_door_at
from solver.request import Request
from solver.scene import Opening, Room
from tests.floorplan import checks, homes
from tests.sweeps import seeds

CATALOGS = load_catalogs()


def drawn(**fields: object) -> FloorPlan:
    return draw(Request(**{"seed": 7, **fields}), CATALOGS)  # type: ignore[arg-type]


def opening(plan: FloorPlan, name: str) -> tuple[Room, Opening]:
    return next((room, o) for room in plan.rooms for o in room.openings if o.id == name)


@pytest.mark.parametrize("seed", range(10))
def test_unjoined_are_the_long_shared_walls_without_a_door(seed: int) -> None:
    plan = drawn(seed=seed)
    shared = checks.shared_walls(plan.rooms, 1100)
    assert {(plan.rooms[a].id, plan.rooms[b].id) for a, b in plan.adjacency} == shared
    assert checks.joined(plan.rooms) <= shared
    assert set(plan.unjoined) == shared - checks.joined(plan.rooms)


@pytest.mark.parametrize("seed", range(10))
def test_doors_are_a_tree_but_from_kitchens_to_tables_and_leaves_open_into_rooms(seed: int) -> None:
    plan = drawn(seed=seed)
    type_of = {room.id: room.type for room in plan.rooms}
    served = [pair for pair in checks.joined(plan.rooms) if {type_of[one] for one in pair} == {"kitchen", "dining_room"}]
    assert len(served) == 1, "a kitchen and a dining room that do not touch, or no opening between them"
    assert len(checks.joined(plan.rooms)) - len(plan.rooms) in (-1, 0)
    for room in plan.rooms:
        for o in room.openings:
            if o.kind == "door" and not o.main_entrance and room.type == "hallway":
                assert o.swing == "out", o.id
            if o.kind == "passage":
                types = {room.type, str(o.connects_to).rsplit("_", 1)[0]}
                assert all(CATALOGS.rooms[name].plan.passage for name in types)


def test_main_entrance_is_a_hallway_with_a_south_wall() -> None:
    for seed in range(10):
        ((room, door),) = checks.entrances(drawn(seed=seed).rooms)
        assert (room.type, door.wall, door.swing) == ("hallway", "south", "in")


def test_main_entrance_else_is_in_a_living_room_on_the_street_else_at_the_hallways_end() -> None:
    for seed in range(20):
        plan = drawn(seed=seed, width=12.0, depth=9.0)
        ((room, door),) = checks.entrances(plan.rooms)
        south = [r for r in plan.rooms if r.exterior_walls and r.exterior_walls.south and r.type == "living_room"]
        if south:
            assert door.wall == "south" and room.width == max(r.width for r in south)
        else:
            assert room.type == "hallway" and door.wall in ("east", "west")


def test_main_entrance_at_the_hallways_end_where_the_south_is_private() -> None:
    names = {room.index: "bedroom" for room in drawn(max_depth=0).rooms[1:]}
    ((room, door),) = checks.entrances(drawn(max_depth=0, force_types=names).rooms)
    assert (room.id, door.wall in ("east", "west")) == ("hallway_0", True)


@pytest.mark.parametrize("seed", range(10))
def test_windows_suit_their_rooms(seed: int) -> None:
    for room in drawn(seed=seed, outdoor=True).rooms:
        windows = [o for o in room.openings if o.kind == "window"]
        if room.outdoor or not CATALOGS.rooms[room.type].plan.windows:
            assert windows == []
        wanted = {(0.6, 0.6, 1.4)} if room.type in ("bathroom", "laundry") else {(wide, 1.4, 0.9) for wide in (1.2, 1.8, 2.4)}
        assert {(o.width, o.height, o.sill) for o in windows} <= wanted
        for wall in ("north", "south", "east", "west"):
            here = [o for o in windows if o.wall == wall]
            assert len(here) <= 2
            outside = room.exterior_walls is not None and getattr(room.exterior_walls, wall)
            assert outside or not here
            doors = [o for o in room.openings if o.wall == wall and o.kind != "window"]
            if outside and not room.outdoor and CATALOGS.rooms[room.type].plan.windows and room.type != "hallway" and not doors:
                assert here, f"{room.id} has no window in its {wall} wall"
        walls = {o.wall for o in windows}
        if len(windows) > len(walls):
            assert CATALOGS.rooms[room.type].plan.habitable
            assert sum(o.width * o.height for o in windows) <= room.width * room.depth / 4 + 1e-9


@pytest.mark.parametrize("program", [None, "family", "large"])
def test_windows_of_living_spaces_are_as_wide_as_daylight_asks(program: str | None) -> None:
    """Glass for 8 % of the floor (IRC, R303.1) everywhere; windows wider than others only where these leave less than an eighth."""
    wide = 0
    for seed in range(12):
        for room in drawn(seed=seed, program=program).rooms:
            panes = [o.width for o in room.openings if o.kind == "window"]
            if not CATALOGS.rooms[room.type].plan.habitable or not panes:
                continue
            floor = room.width * room.depth
            assert sum(panes) * 1.4 >= 0.08 * floor, (seed, room.id)
            assert max(panes) == 1.2 or len(panes) * (max(panes) - 0.6) * 1.4 < floor / 8, (seed, room.id)
            wide += max(panes) > 1.2
    assert wide > 0


@pytest.mark.parametrize("fields", [{}, {"use_spine": False}, {"outdoor": True}], ids=str)
def test_plain_houses_have_light_wherever_one_lives(fields: dict[str, object]) -> None:
    """Kitchens were the smallest room of their size: of default houses 44 % of them lay inside, while rooms at the outside were baths."""
    for seed in range(930_000, 930_020):
        for room in drawn(seed=seed, **fields).rooms:
            lit = any(o.kind == "window" for o in room.openings)
            assert lit or not CATALOGS.rooms[room.type].plan.habitable, (seed, room.id)


def test_no_front_door_takes_a_rooms_only_window() -> None:
    """Rooms that are lived in and lie at the outside have a window; of one such programme in thirty the door stood in the way."""
    every = homes.Homes()
    for number in seeds(range(450), 5):
        every.add(drawn(seed=number, program=homes.random_programme(number)), number)
    assert every.rooms > 500
    assert every.unlit == every.dark
    assert every.faults == []


@pytest.mark.parametrize(("name", "cars"), [("garage", 1), ("garage_2car", 2), ("garage_3car", 3)])
def test_garages_have_a_door_for_every_car(name: str, cars: int) -> None:
    plan = drawn(max_depth=1, use_spine=False, force_types={0: name})
    (door,) = [o for o in plan.rooms[0].openings if o.kind == "garage_door"]
    assert door.width == pytest.approx(2.4 * cars)
    assert (door.connects_to, door.hinge) == ("EXTERIOR", None)
    assert checks.sound(plan.rooms, 20.0, 15.0) == []


def test_a_garage_without_an_outside_wall_is_said() -> None:
    plan = drawn(width=30.0, depth=20.0)
    inner = next(r.index for r in plan.rooms if r.type != "hallway" and not any(vars(r.exterior_walls).values()))
    forced = drawn(width=30.0, depth=20.0, force_types={inner: "garage"})
    assert any(note.startswith(f"garage_{inner}:") for note in forced.notes)


@pytest.mark.parametrize("fields", [{}, {"use_spine": False}, {"width": 9.0, "depth": 7.0, "min_room_size": 2.0}], ids=str)
def test_doors_can_be_moved_wherever_they_say(fields: dict[str, object]) -> None:
    plan = drawn(**fields)
    width, depth = plan.drawing.layout.outline.x1 / 1000, plan.drawing.layout.outline.z1 / 1000
    movable, before = 0, checks.crowded(plan.rooms)
    for name in {o.id for room in plan.rooms for o in room.openings if o.kind in ("door", "passage")}:
        room, old = opening(plan, name)
        start = room.x if old.wall in ("north", "south") else room.z
        positions = door_positions(plan, name)
        movable += bool(positions)
        assert round(1000 * (start + old.position)) not in positions
        for position in positions[:4]:
            moved = with_door_at(plan, name, position)
            assert checks.sound(moved.rooms, width, depth) == []
            assert checks.crowded(moved.rooms) <= before
            _, new = opening(moved, name)
            assert 1000 * (start + new.position) == pytest.approx(position)
            assert moved.adjacency == plan.adjacency and moved.unjoined == plan.unjoined
    assert movable >= len(plan.rooms) // 2


def test_moving_an_unknown_door_is_an_error() -> None:
    with pytest.raises(KeyError):
        door_positions(drawn(), "door_999")
