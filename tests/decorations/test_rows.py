"""Every row of the table of surfaces: what must be on a piece, over it, and where."""

from __future__ import annotations

import math

import pytest

from solver.scene import Furniture, Opening, Room, Scene
from tests.decorations.oracle import complaints
from tests.decorations.rooms import DOOR, SIDE, THICKNESS, WALLS, at_wall, decorate, piece, room, under
from tests.every import every

ROWS = {
    "bed": {"pillow": 2, "throw_pillow": 1, "throw_blanket": 1, "wall_frame": 1},
    "sofa": {"pillow": 2, "throw_pillow": 2, "throw_blanket": 1, "wall_art": 1},
    "armchair": {"throw_pillow": 1},
    "nightstand": {"table_lamp": 1, "alarm_clock": 1, "picture_frame": 1, "book": 1},
    "dresser": {"picture_frame": 2, "jewelry_box": 1, "perfume_bottle": 2, "candle": 1},
    "sideboard": {"vase": 1, "picture_frame": 2, "candle_holder": 2, "candle": 2, "book_stack": 1},
    "console_table": {"table_lamp": 1, "small_vase": 1, "picture_frame": 1, "tray": 1, "key_tray": 1, "wall_mirror": 1},
    "desk": {
        "laptop": 1, "monitor": 1, "keyboard": 1, "desk_lamp": 1, "pen_cup": 1, "pen": 1, "mug": 1, "figurine": 1, "notebook": 1,
        "organizer": 1,
    },
    "coffee_table": {"book_stack": 1, "magazine": 1, "coaster": 2, "small_vase": 1, "candle": 2},
    "counter": {
        "cutting_board": 1, "knife_block": 1, "coffee_maker": 1, "jar": 2, "toaster": 1, "spice_rack": 1, "utensil_holder": 1,
    },
    "kitchen_island": {"fruit_bowl": 1, "cutting_board": 1, "jar": 2, "plant_small": 1},
    "bookshelf": {"book": 12, "book_stack": 4, "picture_frame": 4, "small_vase": 2, "figurine": 2},
    "vanity": {"soap_dispenser": 1, "toiletry_kit": 1, "folded_towel": 1, "wall_mirror": 1},
    "workbench": {"organizer": 1, "pen_cup": 1, "book": 1},
}  # fmt: skip
"""By parent, at least so many of each kind."""
SEATS = {"placemat": 4, "plate": 4, "silverware": 4, "glass": 4}


def right(decorated_room: Room) -> list[str]:
    """What an independent check finds wrong with a decorated room."""
    return list(complaints(Scene(wall_thickness=THICKNESS, rooms=(decorated_room,))))


@every("wall", WALLS)
@every("name", ROWS)
def test_a_row_is_on_its_parent(name: str, wall: str) -> None:
    for seed in range(3):
        done = decorate(room(at_wall(name, wall)), seed)
        found = under(done, f"r/{name}_1")
        assert {kind: found[kind] for kind in ROWS[name]} == {kind: max(count, found[kind]) for kind, count in ROWS[name].items()}
        assert right(done) == []


HELD = {
    "wardrobe": {"folded_clothes"}, "small_wardrobe": {"folded_clothes"}, "dresser": {"folded_clothes"}, "sideboard": {"wine_glass"},
    "counter": {"plate_stack", "silverware"}, "narrow_counter": {"silverware"}, "left_corner_counter": {"plate_stack", "silverware"},
    "right_corner_counter": {"plate_stack", "silverware"}, "pantry": {"cereal_box", "food_can"}, "shoe_cabinet": {"shoe_pair"},
    "refrigerator": {"milk_carton", "food_box"}, "linen_cabinet": {"folded_towel"}, "double_vanity": {"toiletry_kit"},
    "toy_chest": {"toy_blocks"}, "dishwasher": {"bowl"}, "kitchen_island": {"pot"},
}  # fmt: skip
"""By kind of furniture, some of what it may hold inside."""


@every("wall", WALLS)
@every("name", HELD)
def test_what_is_held_lies_on_boards_within_its_piece(name: str, wall: str) -> None:
    found = under(room(), "nobody")
    for seed in range(3):
        done = decorate(room(at_wall(name, wall), type="kitchen"), seed)
        (stands,) = done.furniture
        inside = [
            one for one in done.decorations if one.parent == stands.id and one.name in HELD[name] and one.y + one.height < stands.height
        ]
        found.update(one.name for one in inside)
        assert all(math.dist((one.x, one.z), (stands.x, stands.z)) < math.hypot(stands.width, stands.depth) / 2 for one in inside)
        assert right(done) == []
    assert set(found) == HELD[name]


def test_a_row_holds_no_more_than_it_says() -> None:
    for seed in range(20):
        held = [one for one in decorate(room(at_wall("pantry")), seed).decorations if one.name == "cereal_box"]
        assert len(held) <= 2


SMALL = [
    ("small_bed", "bed"), ("king_bed", "bed"), ("medium_sofa", "sofa"), ("loveseat", "sofa"), ("small_nightstand", "nightstand"),
    ("small_dresser", "dresser"), ("small_sideboard", "sideboard"), ("small_console_table", "console_table"), ("medium_desk", "desk"),
    ("small_coffee_table", "coffee_table"), ("small_kitchen_island", "kitchen_island"), ("narrow_bookshelf", "bookshelf"),
    ("short_workbench", "workbench"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "name"), SMALL)
def test_the_smaller_kinds_bear_their_rows_too(kind: str, name: str) -> None:
    done = decorate(room(at_wall(kind)))
    found = under(done, f"r/{name}_1")
    assert {thing: count for thing, count in ROWS[name].items() if found[thing] < count} == {}
    assert right(done) == []


def test_a_single_bed_has_its_pillow_blanket_and_picture() -> None:
    found = under(decorate(room(at_wall("single_bed"))), "r/single_bed_1")
    assert found["pillow"] == found["throw_pillow"] == found["throw_blanket"] == 1
    assert found["wall_frame"] + found["poster"] == 1


def test_the_sink_of_a_bathroom_and_not_of_a_kitchen() -> None:
    bath = under(decorate(room(at_wall("wash_basin"), type="bathroom")), "r/sink_1")
    assert dict(bath) == {"soap_dispenser": 1, "toiletry_kit": 1, "folded_towel": 1, "wall_mirror": 1}
    kitchen = under(decorate(room(at_wall("sink"), type="kitchen")), "r/sink_1")
    assert dict(kitchen) in ({"soap_dispenser": 1}, {"soap_dispenser": 1, "laundry_detergent": 1})


def table_with_chairs(kind: str, chairs: int) -> list[Furniture]:
    table = piece(kind)
    found = [table]
    across = table.width / 4 if chairs > 2 else 0.0
    for k in range(chairs):
        side = 1 if k % 2 else -1
        x, z = table.x + (across if k >= 2 else -across), table.z + side * (table.depth / 2 + 0.1)
        found.append(piece("dining_chair", x, z, 180 if side > 0 else 0, under=table.id, number=k + 1))
    return found


@pytest.mark.parametrize("kind", ["dining_table", "large_dining_table", "small_dining_table"])
def test_a_dining_table_has_a_setting_for_each_of_four_seats(kind: str) -> None:
    done = decorate(room(*table_with_chairs(kind, 4)))
    found = under(done, "r/dining_table_1")
    assert {name: found[name] for name in SEATS} == SEATS
    assert found["table_runner"] == found["centerpiece"] == 1 and found["candle"] == 2
    assert right(done) == []


@pytest.mark.parametrize("chairs", [0, 1, 2, 4])
def test_a_dining_table_has_as_many_settings_as_seats(chairs: int) -> None:
    found = under(decorate(room(*table_with_chairs("dining_table", chairs))), "r/dining_table_1")
    assert {name: found[name] for name in SEATS} == dict.fromkeys(SEATS, chairs)


def test_a_setting_lies_before_its_chair() -> None:
    pieces = table_with_chairs("dining_table", 4)
    done = decorate(room(*pieces))
    mats = [thing for thing in done.decorations if thing.name == "placemat"]
    for chair in pieces[1:]:
        nearest = min(mats, key=lambda mat: (mat.x - chair.x) ** 2 + (mat.z - chair.z) ** 2)
        assert abs(nearest.x - chair.x) <= 0.2 and abs(nearest.z - chair.z) < 0.45
        assert (nearest.rotation - chair.rotation) % 360 == 180


def test_a_run_of_counters_has_the_row_once() -> None:
    run = [
        at_wall("medium_counter", along=2.0, number=1),
        at_wall("short_counter", along=3.0, number=2),
        at_wall("counter", "west", 3.0, number=3),
    ]
    done = decorate(room(*run, type="kitchen"))
    found = sum((under(done, counter.id) for counter in run), start=under(done, "nobody"))
    assert {kind: found[kind] for kind in ROWS["counter"]} == ROWS["counter"]
    assert right(done) == []


def test_short_counters_share_the_row() -> None:
    run = [at_wall("short_counter", along=2.0, number=1), at_wall("short_counter", along=2.6, number=2)]
    done = decorate(room(*run, type="kitchen"))
    found = under(done, run[0].id) + under(done, run[1].id)
    assert all(found[name] <= count for name, count in ROWS["counter"].items())
    assert found.total() >= 6
    assert right(done) == []


def test_what_stands_on_a_piece_takes_its_place() -> None:
    counter = at_wall("medium_counter")
    microwave = piece("microwave", counter.x, 0.3, y=0.9, on=counter.id)
    stand = at_wall("tv_stand", "south", 4.0)
    tv = piece("tv", 4.0, SIDE - 0.2, 180, y=0.5, on=stand.id)
    done = decorate(room(counter, microwave, stand, tv))
    assert under(done, counter.id).total() >= 3
    assert under(done, stand.id)["remote_control"] == 1
    assert right(done) == []


def test_a_tucked_chair_takes_no_place() -> None:
    desk = at_wall("desk")
    chair = piece("office_chair", desk.x, desk.z + 0.5, 180, under=desk.id)
    with_chair, without = under(decorate(room(desk, chair)), desk.id), under(decorate(room(desk)), desk.id)
    assert with_chair == without


def test_pillows_lie_at_the_head_and_the_blanket_at_the_foot() -> None:
    done = decorate(room(at_wall("bed", "west")))
    by_name = {thing.name: thing for thing in done.decorations}
    assert by_name["pillow"].x < by_name["throw_pillow"].x < by_name["throw_blanket"].x
    assert by_name["wall_frame"].mounted_on_wall == "west" and by_name["wall_frame"].rotation == 90
    assert {by_name[name].y for name in ("pillow", "throw_pillow", "throw_blanket")} == {0.5}
    assert by_name["wall_frame"].y > 0.9


def test_a_mounted_shelf_is_a_parent_like_any_other() -> None:
    for seed in range(8):
        done = decorate(room(at_wall("desk")), seed)
        shelf = next((thing for thing in done.decorations if thing.name == "wall_shelf"), None)
        if shelf is not None:
            break
    assert shelf is not None and shelf.mounted_on_wall == "north" and shelf.parent == "r/desk_1"
    on_it = [thing for thing in done.decorations if thing.parent == shelf.id]
    assert {thing.name for thing in on_it} >= {"book", "picture_frame"}
    assert {thing.y for thing in on_it} == {round(shelf.y + 0.04, 4)}
    assert right(done) == []


def test_glass_on_coaster_and_candle_in_holder() -> None:
    done = decorate(room(at_wall("sideboard")))
    by_id = {thing.id: thing for thing in done.decorations}
    candles = [thing for thing in done.decorations if thing.name == "candle"]
    assert [by_id[candle.parent or ""].name for candle in candles] == ["candle_holder", "candle_holder"]
    assert all(candle.y == round(by_id[candle.parent or ""].y + 0.06, 4) for candle in candles)


@pytest.mark.parametrize("wall", WALLS)
def test_pictures_keep_clear_of_windows(wall: str) -> None:
    window = Opening("window_1", "window", wall, SIDE / 2, 1.2, 1.4, 0.9)
    hung = 0
    for kind in ("bed", "sofa", "sideboard", "console_table", "dresser"):
        done = decorate(room(at_wall(kind, wall), openings=(DOOR, window)))
        hung += sum(thing.mounted_on_wall == wall for thing in done.decorations)
        assert right(done) == []
    assert hung >= 1


def test_nothing_hangs_behind_a_wardrobe() -> None:
    bed = at_wall("single_bed", along=1.5)
    wardrobe = at_wall("wardrobe", along=1.5 + 0.45 + 0.9)
    done = decorate(room(bed, wardrobe))
    assert right(done) == []
    (art,) = [thing for thing in done.decorations if thing.mounted_on_wall == "north"]
    assert art.x + art.width / 2 <= wardrobe.x - wardrobe.width / 2


def test_nothing_hangs_outdoors() -> None:
    done = decorate(room(at_wall("outdoor_sofa"), at_wall("sideboard", "west"), outdoor=True, type="patio"))
    assert done.decorations
    assert not any(thing.mounted_on_wall for thing in done.decorations)
