"""draw(): any request gives a sound plan; options and forced types do what they say; bad requests name their field."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from catalogs import load_catalogs
from solver.errors import RequestError
from solver.floorplan import FloorPlan, draw
from solver.request import Request
from solver.scene import EXTERIOR, Room
from tests.floorplan import checks

CATALOGS = load_catalogs()


def drawn(**fields: object) -> FloorPlan:
    return draw(Request(**{"seed": 7, **fields}), CATALOGS)  # type: ignore[arg-type]


def indoor(plan: FloorPlan) -> list[Room]:
    return [room for room in plan.rooms if room.type != "hallway"]


def area(room: Room) -> float:
    return room.width * room.depth


requests = st.builds(
    Request,
    seed=st.integers(0, 2**53 - 1),
    width=st.integers(2000, 26000).map(lambda v: v / 1000),
    depth=st.integers(2000, 26000).map(lambda v: v / 1000),
    min_room_size=st.integers(150, 600).map(lambda v: v / 100),
    max_depth=st.integers(0, 6),
    use_spine=st.booleans(),
    outdoor=st.booleans(),
    force_types=st.dictionaries(st.integers(0, 4), st.sampled_from(sorted(CATALOGS.rooms)), max_size=3),
)


@settings(max_examples=3 * settings().max_examples)
@given(requests)
def test_any_request_gives_a_sound_plan(request: Request) -> None:
    request = replace(request, min_room_size=min(request.min_room_size, *request.extents))
    count = len(draw(replace(request, force_types={}), CATALOGS).rooms)
    request = replace(request, force_types={i: name for i, name in request.force_types.items() if i < count})
    plan = draw(request, CATALOGS)
    assert checks.sound(plan.rooms, *request.extents) == []
    for index, name in request.force_types.items():
        assert plan.rooms[index].type == name
    if not request.force_types:
        assert checks.gardens(plan.rooms) == []
        said = any("can only be entered through" in note for note in plan.notes)
        assert said or checks.walked_through(plan.rooms) == []
        assert not plan.spine or checks.violations(plan.rooms) == []


@pytest.mark.parametrize(
    "fields",
    [
        {"width": 1000.0, "depth": 1000.0, "max_depth": 16},
        {"width": 1000.0, "depth": 1000.0, "max_depth": 16, "use_spine": False},
    ],
    ids=str,
)
def test_huge_houses_are_capped_and_whole(fields: dict[str, float]) -> None:
    plan = drawn(**fields)
    assert 2000 < len(plan.rooms) <= 2048
    assert checks.tiling(plan.rooms, fields["width"], fields["depth"]) == []
    assert len(checks.reached(plan.rooms)) == len(plan.rooms)
    assert any("2048 rooms" in note for note in plan.notes)


def test_a_tiny_house_is_a_living_room_with_a_front_door() -> None:
    plan = drawn(width=2.0, depth=2.0, min_room_size=2.0)
    (room,) = plan.rooms
    assert (room.id, plan.spine) == ("living_room_0", False)
    assert [(o.kind, o.connects_to) for o in room.openings if o.main_entrance] == [("door", EXTERIOR)]
    assert checks.sound(plan.rooms, 2.0, 2.0) == []


def test_rooms_come_from_the_request_alone() -> None:
    again = [drawn(seed=seed) for seed in (1, 2, 1)]
    assert again[0] == again[2]
    assert [room.x for room in again[0].rooms] != [room.x for room in again[1].rooms]


def test_options_leave_the_rectangles_alone() -> None:
    def rectangles(plan: FloorPlan) -> list[tuple[float, ...]]:
        return [(room.x, room.z, room.width, room.depth) for room in plan.rooms]

    plain = drawn()
    for fields in ({"outdoor": True}, {"decorate": True}, {"robot_width": 0.4}, {"force_types": {5: "office"}}):
        assert rectangles(drawn(**fields)) == rectangles(plain)


def test_hallway_spine_runs_along_the_longer_axis() -> None:
    wide, deep = drawn(width=20.0, depth=15.0), drawn(width=15.0, depth=20.0)
    assert (wide.rooms[0].type, wide.rooms[0].width, wide.rooms[0].depth) == ("hallway", 20.0, 1.3)
    assert (deep.rooms[0].type, deep.rooms[0].width, deep.rooms[0].depth) == ("hallway", 1.3, 20.0)
    assert wide.spine and deep.spine


def test_no_spine_where_a_half_would_be_too_narrow_and_it_is_said() -> None:
    assert drawn(width=9.0, depth=7.3, min_room_size=3.0).spine
    narrow = drawn(width=9.0, depth=7.29, min_room_size=3.0)
    assert not narrow.spine
    assert any("no hallway spine" in note for note in narrow.notes)
    off = drawn(use_spine=False)
    assert not off.spine and not any("spine" in note for note in off.notes)


def test_the_plain_partition_has_corridors_between_rooms() -> None:
    plan = drawn(use_spine=False)
    assert len(plan.corridors) == len(plan.rooms) - 1
    for corridor in plan.corridors:
        one, other = plan.rooms[corridor["from"]], plan.rooms[corridor["to"]]
        (ax, az), middle, (bx, bz) = corridor["points"]
        assert (ax, az) == pytest.approx((one.x + one.width / 2, one.z + one.depth / 2))
        assert (bx, bz) == pytest.approx((other.x + other.width / 2, other.z + other.depth / 2))
        assert middle == [bx, az]
    assert drawn().corridors == ()


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("spine", [True, False])
def test_the_classifier_keeps_its_words(seed: int, spine: bool) -> None:
    plan = drawn(seed=seed, use_spine=spine)
    assert checks.walked_through(plan.rooms) == []
    rooms = sorted(indoor(plan) if spine else plan.rooms, key=area)
    assert rooms[0].type == "bathroom"
    types = [room.type for room in rooms]
    kitchen = rooms[types.index("kitchen")]
    lit = [room for room in rooms[1:-1] if any(vars(room.exterior_walls).values())]
    assert 11.0 <= area(kitchen) <= 16.0 or not any(11.0 <= area(room) <= 16.0 for room in lit)
    assert kitchen in lit
    assert 1 <= types.count("living_room") <= 2
    assert types.count("bedroom_master") <= 1 and types.count("dining_room") == (len(rooms) >= 6)
    assert all(area(room) >= 12.0 for room in rooms if room.type == "bedroom_master")
    kids = [room for room in rooms if room.type == "kids_bedroom"]
    assert all(area(kid) <= area(room) for kid in kids for room in rooms if room.type == "bedroom")


def test_small_houses() -> None:
    wanted = {1: ["living_room"], 2: ["bathroom", "kitchen"], 3: ["bathroom", "kitchen", "living_room"]}
    seen = set()
    for seed in range(20):
        for width in (4.0, 6.5, 10.5):
            rooms = drawn(seed=seed, width=width, depth=3.0, use_spine=False).rooms
            assert sorted(room.type for room in rooms) == wanted[len(rooms)]
            seen.add(len(rooms))
    assert seen == {1, 2, 3}


@pytest.mark.parametrize("spine", [False, True])
def test_nobody_walks_through_a_bedroom_or_bathroom_of_a_small_house(spine: bool) -> None:
    for seed in range(60):
        sides = {"width": 6.0 + seed % 9, "depth": 6.0 + seed % 7}
        assert checks.walked_through(drawn(seed=seed, use_spine=spine, **sides).rooms) == [], seed


def test_master_bedroom_from_four_rooms() -> None:
    big, small = drawn(width=8.0, depth=6.6, use_spine=False), drawn(width=6.2, depth=6.2, use_spine=False)
    assert sorted(room.type for room in big.rooms) == ["bathroom", "bedroom_master", "kitchen", "living_room"]
    assert sorted(room.type for room in small.rooms) == ["bathroom", "bedroom", "kitchen", "living_room"]


@pytest.mark.parametrize("seed", range(8))
def test_outdoor_rooms_are_the_largest_to_spare(seed: int) -> None:
    plain, out = drawn(seed=seed), drawn(seed=seed, outdoor=True)
    types = [room.type for room in out.rooms]
    assert types.count("backyard") == 1 and types.count("patio") == 1
    for room in out.rooms:
        if room.outdoor:
            assert not any(o.kind == "window" for o in room.openings)
            sides = room.exterior_walls
            assert sides is not None and (sides.north or sides.south or sides.east or sides.west)
    yard, terrace = (next(room for room in out.rooms if room.type == name) for name in ("backyard", "patio"))
    assert area(yard) >= area(terrace)
    assert sum(a.type != b.type for a, b in zip(plain.rooms, out.rooms, strict=True)) <= 4


def test_forced_types_win() -> None:
    plan = drawn(force_types={4: "garage", 6: "backyard", 7: "kitchen"})
    assert [plan.rooms[i].id for i in (4, 6, 7)] == ["garage_4", "backyard_6", "kitchen_7"]
    assert sum(room.type == "kitchen" for room in plan.rooms) == 1


def test_a_forced_spine_is_walked_through_and_said() -> None:
    plan = drawn(force_types={0: "bedroom"})
    assert checks.sound(plan.rooms, 20.0, 15.0) == []
    assert any("can only be entered through bedroom_0" in note for note in plan.notes)


@pytest.mark.parametrize(
    ("fields", "field", "allowed"),
    [
        ({"force_types": {99: "office"}}, "force_types[99]", "0 to "),
        ({"force_types": {-1: "office"}}, "force_types[-1]", "0 to "),
        ({"force_types": {3: "dungeon"}}, "force_types[3]", "workshop"),
        ({"width": 4.0, "depth": 30.0, "min_room_size": 4.01}, "min_room_size", "at most 4.0"),
    ],
)
def test_bad_requests_name_the_field(fields: dict[str, object], field: str, allowed: str) -> None:
    with pytest.raises(RequestError) as caught:
        drawn(**fields)
    assert caught.value.field == field
    assert allowed in caught.value.allowed


def test_the_bathroom_behind_a_master_bedroom_is_no_larger_than_others() -> None:
    large = []
    for seed in range(8_700, 8_730):
        home = draw(Request(seed=seed), CATALOGS)
        rooms = {room.id: room for room in home.rooms}
        beside = (door.connects_to or "" for room in home.rooms if room.type == "bedroom_master" for door in room.openings)
        large += [area(room) > 10.0 + 1e-6 for name in beside if (room := rooms.get(name)) and room.type == "bathroom"]
    assert len(large) >= 25
    assert sum(large) <= 0.15 * len(large)  # 0.6 where any room behind it would do


def test_nobody_sleeps_without_a_window_in_large_houses() -> None:
    for seed in range(8_765, 8_785):
        for room in draw(Request(seed=seed, width=30.0, depth=20.0), CATALOGS).rooms:
            lit = any(opening.kind == "window" for opening in room.openings)
            assert lit or room.type not in ("bedroom", "bedroom_master", "kids_bedroom"), (seed, room.id)  # in 4 of 60 homes


BEDS = ("bedroom", "bedroom_master", "kids_bedroom")


def test_a_house_of_six_rooms_has_two_bedrooms() -> None:
    for seed in range(7_330_000, 7_330_012):
        types = Counter(room.type for room in drawn(seed=seed, width=12.0, depth=9.0).rooms)
        assert sum(types[name] for name in BEDS) >= types["living_room"] + 1, seed


def test_bedrooms_are_not_entered_through_rooms_one_lives_in() -> None:
    for seed in range(7_330_000, 7_330_012):
        rooms = {room.id: room for room in drawn(seed=seed).rooms}
        for room in rooms.values():
            through = {rooms[o.connects_to].type for o in room.openings if o.connects_to in rooms}
            assert room.type not in BEDS or not through - {"bathroom"} <= {"living_room", "dining_room", "kitchen"}, room.id
