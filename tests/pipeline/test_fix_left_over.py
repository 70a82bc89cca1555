"""What fix() says of what it cannot repair: the room before its furniture, nothing of rooms that are only shut; `remove`."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Scene, fix
from solver.demanded import demanding_at_most
from solver.pipeline.left_over import LEAVING_WORK, unexplained
from solver.repair import RepairSettings
from solver.scene import Dynamic, Opening, Room
from solver.validator import Checked, check
from tests.pipeline.fix_rooms import body, errors, fuzzed, pieces, room_of, untrue_repairs, with_repair
from tests.sweeps import seeds
from tests.told_forms import is_told

FRONT = Opening("front", "door", "west", 1.0, 0.9, connects_to="EXTERIOR", main_entrance=True)
NEXT = Opening("next", "door", "east", 1.0, 0.9, connects_to="back_1")
PLANT = replace(body("plant_1", 1.5, 1.0, (0.4, 0.4, 1.1)), id="back_1/plant_1")


def house(shut: bool, *openings: Opening) -> Scene:
    """A hall of 6 x 2 m and a room behind it with a plant, perhaps shut by a locked chest."""
    chest = body("chest_1", 3.0, 1.0, (0.6, 1.6, 0.8), locked=True)
    hall = Room("room_0", 0, "room", 0, 0.0, 0.0, 6.0, 2.0, openings=openings, furniture=(chest,) if shut else ())
    doors = tuple(replace(one, wall="west", connects_to="room_0") for one in openings if one is NEXT)
    return Scene(rooms=(hall, Room("back_1", 1, "room", 0, 6.0, 0.0, 3.0, 2.0, openings=doors, furniture=(PLANT,))))


def test_a_room_without_a_door_is_said_to_be_that_first() -> None:
    fixed = fix(house(True, FRONT))
    assert fixed.conflicts[0].message == "back_1 has no way in: no door or passage leads into it"
    assert not any(PLANT.id in conflict.ids for conflict in fixed.conflicts)
    assert [conflict.ids for conflict in fix(house(False, FRONT)).conflicts] == [()]


def test_rooms_that_no_doors_join_to_the_entrance_are_said_to_be_that_and_a_door_helps() -> None:
    """A garage with its outer door alone, and a store behind it."""
    gate = Opening("gate", "garage_door", "south", 3.0, 4.0, connects_to="EXTERIOR")
    inner = Opening("inner", "door", "north", 1.0, 0.9, connects_to="store_2")
    garage = Room("garage_1", 1, "garage", 0, 6.0, 0.0, 6.0, 6.0, openings=(gate, inner))
    store = Room("store_2", 2, "room", 0, 6.0, -3.0, 6.0, 3.0, openings=(replace(inner, wall="south", connects_to="garage_1"),))
    hall = Room("room_0", 0, "room", 0, 0.0, 0.0, 6.0, 6.0, openings=(FRONT,))
    told = [conflict.message for conflict in fix(Scene(rooms=(hall, garage, store))).conflicts]
    assert told == [f"{room} has no way in from room_0: no doors or passages join them" for room in ("garage_1", "store_2")]
    assert all(map(is_told, told))
    door = Opening("new", "door", "east", 3.0, 0.9, connects_to="garage_1")
    to_hall = replace(door, wall="west", connects_to="room_0")
    joined = replace(hall, openings=(FRONT, door)), replace(garage, openings=(gate, inner, to_hall))
    assert fix(Scene(rooms=(*joined, store))).conflicts == ()


def test_what_keeps_all_out_of_the_house_is_said_once() -> None:
    fixed = fix(house(False, replace(FRONT, width=0.5), NEXT))
    assert [issue.room for issue in fixed.issues if issue.severity == "error"] == ["room_0", "back_1"]
    told = "not found: no repair for this: somebody 60 cm wide cannot get in through front, so not to room_0, back_1"
    assert [(conflict.ids, conflict.message) for conflict in fixed.conflicts] == [((), told)]
    assert is_told(told)


def test_rooms_that_cannot_be_come_to_from_the_entrance_are_said_in_one() -> None:
    side = Opening("side", "door", "south", 1.0, 0.9, connects_to="side_2")
    narrow = replace(NEXT, width=0.5)
    scene = house(False, FRONT, narrow, replace(side, width=0.5))
    (hall, back) = scene.rooms
    beside = Room("side_2", 2, "room", 0, 0.0, 2.0, 3.0, 2.0, openings=(replace(side, width=0.5, wall="north", connects_to="room_0"),))
    far = replace(back, openings=(replace(narrow, wall="west", connects_to="room_0"),))
    fixed = fix(replace(scene, rooms=(hall, far, beside)))
    assert [conflict.message for conflict in fixed.conflicts] == [
        "not found: no repair for this: somebody 60 cm wide cannot get to back_1, side_2 from front"
    ]


def test_nothing_is_said_of_a_room_that_a_conflict_elsewhere_shuts() -> None:
    fixed = fix(house(True, FRONT, NEXT))
    assert errors(fixed.scene)
    assert fixed.conflicts
    assert not any(PLANT.id in conflict.ids for conflict in fixed.conflicts)


def test_what_is_wrong_with_the_empty_room_is_said_beside_its_conflicts_which_end_by_themselves() -> None:
    """A closet of 1.0 x 1.15 m: too small to stand in for somebody, and the chest is too long for it."""
    door = Opening("front", "door", "west", 0.45, 0.9, connects_to="EXTERIOR")
    chest = body("chest_1", 0.5, 0.9, (1.5, 0.5, 0.5))
    fixed = fix(room_of(chest, width=1.0, depth=1.15, openings=(door,)))
    told = "not found: no repair for this: room_0 has less than 0.25 m2 where somebody 60 cm wide can stand"
    assert [conflict.message for conflict in fixed.conflicts if not conflict.ids] == [told]
    assert is_told(told)
    (about,) = [conflict for conflict in fixed.conflicts if conflict.ids]
    assert about.ids == (chest.id,)
    assert {"action": "leave_out", "id": chest.id} in about.repairs
    for repair in about.repairs:
        assert {conflict.message for conflict in fix(with_repair(fixed.scene, repair)).conflicts} == {told}


def test_with_remove_what_shuts_the_way_goes_and_only_a_missing_door_stays() -> None:
    fixed = fix(house(True, FRONT, NEXT), on_conflict="remove")
    assert errors(fixed.scene) == []
    assert [removal["id"] for removal in fixed.removed] == ["room_0/chest_1"]
    doorless = fix(house(False, FRONT), on_conflict="remove")
    assert doorless.removed == ()
    assert {issue.rule for issue in doorless.issues if issue.severity == "error"} == {"unreachable"}


@pytest.mark.parametrize("seed", seeds(range(60), 6))
def test_with_remove_a_full_room_ends_clean_and_walkable(seed: int) -> None:
    scene = fuzzed(seed, 5, locks=seed % 2 == 1)
    fixed = fix(scene, on_conflict="remove")
    empty = replace(scene, rooms=tuple(replace(room, furniture=()) for room in scene.rooms))
    assert errors(fixed.scene) == errors(empty)
    assert {removal["id"] for removal in fixed.removed} == pieces(scene).keys() - pieces(fixed.scene).keys()
    assert all(removal["reason"] for removal in fixed.removed)


Crowded = tuple[float, float, str, float, tuple[tuple[str, float, float, int, bool], ...]]
CROWDED: dict[str, Crowded] = {
    "one locked before the door": (3.685, 2.36, "east", 0.667, (
        ("sink", 0.492, 1.557, 90, False), ("shower", 3.007, 1.727, 0, False), ("bathtub", 0.629, 0.475, 270, False),
        ("linen_cabinet", 1.874, 0.27, 270, True), ("sink", 2.957, 1.325, 90, True), ("toilet", 3.032, 2.14, 0, False),
        ("washer", 3.037, 0.515, 270, False), ("shower", 2.962, 1.309, 90, False))),
    "one locked in the wall": (2.777, 4.103, "south", 0.617, (
        ("sink", 1.305, 3.662, 90, False), ("stove", 2.369, 2.013, 270, True), ("sink", 1.418, 0.824, 180, True),
        ("dishwasher", 0.604, 3.144, 180, False), ("dining_table", 1.024, 3.845, 0, False), ("dishwasher", 1.286, 1.334, 90, False),
        ("pantry", 1.816, 2.316, 90, False), ("dining_table", 0.052, 1.174, 0, True))),
}  # fmt: skip


@pytest.mark.parametrize("name", CROWDED)
def test_with_remove_a_room_ends_clean_where_no_single_piece_opens_the_way(name: str) -> None:
    width, depth, wall, position, sent = CROWDED[name]
    sizes = {kind: load_catalogs().furniture[kind].size for kind, *_ in sent}
    furniture = [
        replace(body(f"{kind}_{k}", x, z, sizes[kind], locked=locked), rotation=turn) for k, (kind, x, z, turn, locked) in enumerate(sent)
    ]
    door = Opening("door", "door", wall, position, 1.0, connects_to="EXTERIOR")
    scene = room_of(*furniture, width=width, depth=depth, openings=(door,))
    assert errors(scene)
    fixed = fix(scene, on_conflict="remove")
    assert errors(fixed.scene) == []
    assert {removal["id"] for removal in fixed.removed} == pieces(scene).keys() - pieces(fixed.scene).keys()
    assert len(pieces(fixed.scene)) >= 2


def test_with_remove_each_body_is_tried_once_not_once_for_each_shut_room(monkeypatch: pytest.MonkeyPatch) -> None:
    rooms = [
        Room(f"shut_{k}", k, "room", 0, 4.0 * k, 0.0, 3.0, 2.0, furniture=(replace(body("box", 1.5, 1.0, (0.5, 0.5, 0.5)), id=f"box_{k}"),))
        for k in range(30)
    ]
    judged: list[Scene] = []
    after = Checked.after

    def noted(self: Checked, scene: Scene) -> Checked:
        judged.append(scene)
        return after(self, scene)

    monkeypatch.setattr(Checked, "after", noted)
    fixed = fix(Scene(rooms=tuple(rooms)), on_conflict="remove")
    assert {issue.rule for issue in fixed.issues if issue.severity == "error"} == {"unreachable"}
    assert len(judged) <= 6  # 900 where every room tried every body, 30 where what no body can end was not seen to last without any


def test_with_remove_small_pieces_that_need_not_go_stay() -> None:
    toilet = replace(body("toilet_1", 4.6, 0.6, (0.4, 0.7, 0.8)), rotation=270, wall="east", locked=True)
    chest = body("chest_1", 2.5, 0.6, (0.9, 0.9, 0.8))  # wherever it stands, nobody comes by
    boxes = tuple(body(f"box_{k}", 2.2 + 0.1 * k, 0.6, (0.08, 0.08, 0.2)) for k in range(8))
    room = Room("room_0", 0, "room", 0, 0.0, 0.0, 5.0, 1.2, openings=(replace(FRONT, position=0.6),), furniture=(toilet, chest, *boxes))
    fixed = fix(Scene(rooms=(room,)), on_conflict="remove")
    assert errors(fixed.scene) == []
    assert [removal["id"] for removal in fixed.removed] == ["room_0/chest_1"]


def test_who_stands_in_the_way_of_all_is_named_and_may_be_left_out() -> None:
    hall = replace(house(False, FRONT).rooms[0], width=6.0, depth=0.95)
    narrow = Scene(rooms=(replace(hall, openings=(replace(FRONT, position=0.475),)),))
    standing = replace(narrow, dynamic=(Dynamic("one", "person", "room_0", 3.0, 0.0, 0.5, 0, 5.9, 0.9, 1.7),))
    fixed = fix(standing)
    assert [conflict.ids for conflict in fixed.conflicts] == [("one",)]
    assert errors(fix(standing, on_conflict="remove").scene) == []


def test_each_body_of_a_heap_is_tried_once_not_once_for_each_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is wrong counts each time: forty bodies upon one another are never more than may be judged."""
    house = check(room_of(*(body(f"box_{k}", 2.0, 2.0, (0.5, 0.5, 0.5)) for k in range(40))), load_catalogs())
    judged: list[Scene] = []
    after = Checked.after

    def noted(self: Checked, scene: Scene) -> Checked:
        judged.append(scene)
        return after(self, scene)

    monkeypatch.setattr(Checked, "after", noted)
    with demanding_at_most(1.2 * LEAVING_WORK):
        told = unexplained(house, (), RepairSettings(load_catalogs()))
    assert len(told) == len(house.errors) == 40 * 39 / 2
    assert 10 < len(judged) < 40
    assert told[0].repairs == ({"action": "leave_out", "id": "room_0/box_0"}, {"action": "leave_out", "id": "room_0/box_1"})


def desk_on_a_pit(locked: bool) -> Scene:
    """A desk on a fire pit far from the desk's wall, and a sofa that cannot be come to in so small a room."""
    pit = replace(body("fire_pit", 1.5, 0.9, (1.2, 0.8, 0.3)), rotation=90)
    desk = replace(body("desk", 1.5, 0.9, (1.2, 0.6, 0.7), on=pit.id, wall="south", locked=locked), y=0.3, rotation=180)
    return room_of(pit, desk, body("sofa", 1.9, 0.3, (2.2, 1.7, 0.8)), openings=(FRONT,), width=3.4, depth=2.1)


def test_what_is_left_beside_a_conflict_without_repairs_is_offered_none() -> None:
    """Without the desk the sofa still cannot be come to."""
    fixed = fix(desk_on_a_pit(locked=False))
    assert [(conflict.ids, conflict.repairs) for conflict in fixed.conflicts] == [(("room_0/sofa",), ()), (("room_0/desk",), ())]


def test_what_is_left_once_all_rooms_were_repaired_is_taken_out() -> None:
    """The desk keeps its place on the pit: that it is far from its wall no repair of the room sees."""
    fixed = fix(desk_on_a_pit(locked=False), on_conflict="remove")
    reasons = {gone["id"]: gone["reason"] for gone in fixed.removed}
    assert reasons.keys() == {"room_0/desk", "room_0/sofa"} and errors(fixed.scene) == []
    assert reasons["room_0/desk"] == "room_0/desk stands 90 cm from the south wall of room_0, at most 20 cm is allowed"


def test_what_is_locked_on_a_piece_where_it_cannot_stand_is_said_to_be_that() -> None:
    """Each of two conflicts ends where both bodies are left out."""
    fixed = fix(desk_on_a_pit(locked=True))
    assert [conflict.ids for conflict in fixed.conflicts] == [("room_0/desk",), ("room_0/sofa",)]
    assert fixed.conflicts[0].message.startswith("locked where it cannot stand: room_0/desk stands 90 cm from the south wall")
    assert [conflict.repairs for conflict in fixed.conflicts] == [({"action": "leave_out", "id": one.ids[0]},) for one in fixed.conflicts]


@pytest.mark.parametrize("x", [0.1, -0.1])
def test_a_lamp_locked_partly_outside_does_not_blame_the_table_under_it(x: float) -> None:
    """With its middle on the floor of the room, and outside, where it floats beside its table besides."""
    table = body("side_table", 0.4, 3.0, (0.6, 0.6, 0.5))
    lamp = replace(body("table_lamp", x, 3.0, (0.4, 0.4, 0.4), on=table.id, locked=True), y=0.5)
    (told,) = fix(room_of(table, lamp, openings=(FRONT,))).conflicts
    assert told.ids == (lamp.id,) and told.message.startswith("locked where it cannot stand: ")
    unlock, leave = told.repairs
    assert (unlock["action"], unlock["id"]) == ("unlock", lamp.id)
    assert "dx" in unlock
    assert leave == {"action": "leave_out", "id": lamp.id}


@pytest.mark.parametrize("x", [0.1, -0.1])
def test_what_one_locked_piece_keeps_outside_with_it_is_told_with_that_one(x: float) -> None:
    """A lamp locked on a table that is not, both partly outside: the table comes in with the lamp once that is unlocked."""
    table = body("side_table", x, 3.0, (0.6, 0.6, 0.5))
    lamp = replace(body("table_lamp", x, 3.0, (0.4, 0.4, 0.4), on=table.id, locked=True), y=0.5)
    sent = room_of(table, lamp, openings=(FRONT,))
    (told,) = fix(sent).conflicts
    assert told.ids == (table.id, lamp.id) and told.message.startswith("locked where it cannot stand: ")
    assert told.repairs[0] == {"action": "unlock", "id": lamp.id, "dx": round(0.3 - x, 4), "dz": 0.0, "rotation": 0}
    for repair in told.repairs:
        repaired = fix(with_repair(sent, repair))
        assert (errors(repaired.scene), repaired.conflicts) == ([], ())


def test_of_a_lamp_locked_on_a_locked_table_outside_each_unlocked_helps_with_the_other() -> None:
    table = body("side_table", -0.1, 3.0, (0.6, 0.6, 0.5), locked=True)
    lamp = replace(body("table_lamp", -0.1, 3.0, (0.4, 0.4, 0.4), on=table.id, locked=True), y=0.5)
    sent = room_of(table, lamp, openings=(FRONT,))
    told = {conflict.ids: [repair for repair in conflict.repairs if repair["action"] == "unlock"] for conflict in fix(sent).conflicts}
    assert [[(one["id"], one["dx"]) for one in unlocks] for unlocks in told.values()] == [[(table.id, 0.4)], [(lamp.id, 0.4)]]
    repaired = fix(with_repair(with_repair(sent, told[table.id,][0]), told[lamp.id,][0]))
    assert (errors(repaired.scene), repaired.conflicts) == ([], ())


@pytest.mark.parametrize("on_conflict", ["report", "remove"])
def test_of_a_piece_locked_with_its_front_at_a_wall_others_do_not_pay_for(on_conflict: str) -> None:
    """In front of the sink there are 0.52 m; the table shuts the door, so nobody can say yet what is out of reach."""
    sink = replace(body("sink_1", 1.418, 0.824, (0.6, 0.6, 0.9), locked=True), rotation=180)
    stove = replace(body("stove_1", 2.369, 2.013, (0.6, 0.6, 0.9), locked=True), rotation=270)
    table = body("dining_table_1", 1.024, 3.845, (1.63, 1.1, 0.8))
    door = Opening("door", "door", "south", 0.617, 1.0, connects_to="EXTERIOR", main_entrance=True)
    loose = [body("dishwasher_1", 0.604, 3.144, (0.6, 0.6, 0.9)), body("dishwasher_2", 1.286, 1.334, (0.6, 0.6, 0.9))]
    scene = room_of(sink, stove, table, *loose, width=2.777, depth=4.103, openings=(door,))
    fixed = fix(scene, on_conflict=on_conflict)
    (conflict,) = fixed.conflicts
    assert conflict.ids == (sink.id,)
    assert conflict.message == f"locked where it cannot stand: nobody can get to {sink.id} where it stands"
    assert {repair["action"] for repair in conflict.repairs} == {"leave_out", "unlock"}
    assert [gone["id"] for gone in fixed.removed] == ([sink.id] if on_conflict == "remove" else [])


def test_what_is_taken_out_is_no_more_than_must() -> None:
    """A hall 0.74 m wide between its walls: its bench is too long for it, and was all that the mirror and the table had no place for."""
    bench = body("hall_bench_1", 0.53, 0.26, (0.9, 0.36, 0.46), wall="north")
    table = replace(body("console_table_1", 0.25, 1.95, (1.2, 0.34, 0.8), wall="west"), rotation=90)
    other = replace(body("console_table_2", 0.216, 8.058, (0.8, 0.28, 0.8), wall="west"), rotation=90)
    mirror = replace(body("standing_mirror_1", 0.23, 2.85, (0.6, 0.3, 1.7), wall="west"), rotation=90)
    places = [("south", 0.45), ("west", 0.9), ("east", 1.675), ("east", 5.1), ("east", 7.4)]
    doors = [Opening(f"door_{k}", "door", wall, at, 0.9, connects_to=f"other_{k}") for k, (wall, at) in enumerate(places)]
    scene = replace(room_of(bench, table, other, mirror, width=0.84, depth=11.4, openings=tuple(doors)), wall_thickness=0.1)
    fixed = fix(scene, on_conflict="remove")
    assert [gone["id"] for gone in fixed.removed] == [bench.id]
    assert errors(fixed.scene) == []


def test_what_waits_for_the_same_conflicts_is_named_in_one_sentence_and_no_conflict_twice() -> None:
    """Two locked crates that share floor shut the back of a room off."""
    door = Opening("front", "door", "south", 2.0, 0.9, connects_to="EXTERIOR", main_entrance=True)
    crates = [body(f"crate_{k}", 2.0, z, (width, 0.5, 0.8), locked=True) for k, z, width in ((1, 2.3, 4.0), (2, 2.4, 1.0))]
    back = [body("bookshelf_1", 0.5, 0.2, (0.8, 0.3, 1.8), wall="north"), body("sofa_1", 2.2, 0.5, (1.8, 0.9, 0.8)),
            body("wardrobe_1", 3.6, 0.5, (0.6, 0.6, 2.0))]  # fmt: skip
    fixed = fix(room_of(*crates, *back, width=4.0, depth=4.0, openings=(door,)))
    told = [(conflict.ids, conflict.message) for conflict in fixed.conflicts]
    assert len(told) == len(set(told))
    (waiting,) = [conflict for conflict in fixed.conflicts if "as long as other conflicts last" in conflict.message]
    assert waiting.message == "not found: out of reach as long as other conflicts last: room_0/bookshelf_1, room_0/wardrobe_1"
    assert is_told(waiting.message)
    assert waiting.ids == ("room_0/bookshelf_1", "room_0/wardrobe_1")


def test_what_comes_back_has_its_place_found_step_by_step_as_in_a_repair() -> None:
    """A dining room made 1.67 m narrow: with the sideboard out, a chair found its way only from where the others had gone."""
    size = (0.46, 0.5, 0.9)
    table = replace(body("dining_table_1", 1.48, 1.8, (1.6, 0.9, 0.75)), rotation=90)
    places = [(2.03, 2.2, 270), (0.93, 2.2, 90), (2.03, 1.4, 270), (0.35, 0.22, 90), (1.48, 0.9, 0), (1.48, 2.7, 180)]
    chairs = [replace(body(f"dining_chair_{k}", x, z, size, under=table.id), rotation=turn) for k, (x, z, turn) in enumerate(places)]
    side = body("sideboard_1", 2.21, 0.28, (1.0, 0.4, 0.84), wall="north")
    shelf = body("bookshelf_1", 0.35, 0.22, (0.6, 0.28, 1.8), wall="north")
    ways = tuple(Opening(f"way_{wall}", "passage", wall, 3.2, 1.2, connects_to=f"{wall}_room") for wall in ("east", "west"))
    window = Opening("window", "window", "south", 1.07, 1.2, 1.2, 0.9, "EXTERIOR")
    scene = replace(room_of(table, *chairs, side, shelf, width=1.77, depth=3.9, openings=(*ways, window)), wall_thickness=0.1)
    fixed = fix(scene, on_conflict="remove")
    assert [gone["id"] for gone in fixed.removed] == [side.id]
    assert errors(fixed.scene) == []


def test_who_cannot_stand_keeps_nobody_less_important_from_being_put_right() -> None:
    """A passage 1.795 m wide: the counter and the wardrobe are 5 mm too long as they are turned, and all others have a place."""
    size = {name: load_catalogs().furniture[name].size for name in ("counter", "wardrobe", "vanity", "sink", "bookshelf")}
    long = [replace(body(name, 2.0 * k, 1.0, size[name]), rotation=90) for k, name in ((1, "counter"), (2, "wardrobe"))]
    places = (("vanity", 6.3, 1.655), ("sink", 6.5, 1.8), ("bookshelf", 0.06, 0.36))
    loose = [body(name, x, z, size[name]) for name, x, z in places]
    doors = [Opening(f"{wall}_door", "door", wall, at, 0.9, connects_to="EXTERIOR") for wall, at in (("north", 6.8), ("west", 0.65))]
    fixed = fix(room_of(*long, *loose, width=7.8, depth=1.795, openings=tuple(doors)))
    assert {label for conflict in fixed.conflicts for label in conflict.ids} == {piece.id for piece in long}


@pytest.mark.parametrize("seed", [18, 23, 35, 36, 43, *seeds(range(60, 100), 20)])
def test_none_of_several_taken_out_has_a_place_beside_those_that_stay(seed: int) -> None:
    scene = fuzzed(seed, count=6)
    gone = [removal["id"] for removal in fix(scene, on_conflict="remove").removed]
    (room,) = scene.rooms
    for label in gone if len(gone) > 1 else ():
        there = tuple(piece for piece in room.furniture if piece.id not in gone or piece.id == label)
        assert fix(replace(scene, rooms=(replace(room, furniture=there),)), repairs=False).conflicts, label


def test_what_a_repair_comes_to_step_by_step_is_offered_too() -> None:
    """Seed 7100962 of a judge of its own: without the locked chair /fix found places for all only from those it had come to before."""
    door = Opening("door", wall="west", position=1.303, width=0.8, connects_to="EXTERIOR")
    furniture = (
        replace(body("bookshelf_0", 2.579, 1.34, (1.0, 0.3, 1.8)), rotation=270),
        replace(body("treadmill_1", 2.934, 0.323, (0.8, 1.7, 1.3)), rotation=90),
        replace(body("filing_cabinet_2", 2.345, 0.987, (0.46, 0.6, 0.72), wall="south"), rotation=180),
        replace(body("armchair_3", 4.1, 0.664, (0.8, 0.82, 0.85)), rotation=90),
        replace(body("office_chair_4", 0.397, 1.591, (0.64, 0.61, 0.84), wall="south", locked=True), rotation=180),
        replace(body("bookshelf_5", 0.711, 1.337, (1.0, 0.3, 1.8)), rotation=270),
        body("desk_6", 1.509, 0.442, (1.4, 0.7, 0.75), wall="north", locked=True),
        replace(body("armchair_7", 0.23, 1.097, (0.8, 0.82, 0.94)), rotation=270),
    )
    sent = room_of(*furniture, width=5.396, depth=2.0, openings=(door,))
    fixed = fix(sent)
    assert [conflict.ids for conflict in fixed.conflicts] == [("room_0/office_chair_4",)]
    assert fixed.conflicts[0].repairs == ({"action": "leave_out", "id": "room_0/office_chair_4"},) and untrue_repairs(sent, fixed) == []
