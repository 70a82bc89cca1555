"""People in the way of others in fix(): where they go is where they stay, whatever they were kept from on the way."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from solver import fix
from solver.scene import Decoration, Dynamic, Opening
from tests.pipeline.fix_rooms import body, errors, room_of

WAY_IN = Opening("door", "door", "west", 1.55, connects_to="EXTERIOR")
LAUNDRY = (
    replace(body("washer_1", 0.38, 0.35, (0.6, 0.6, 0.86), wall="west"), rotation=45),
    replace(body("dryer_1", 1.32, 2.75, (0.6, 0.6, 0.86), wall="east"), rotation=270),
    replace(body("counter_1", 1.32, 1.85, (1.2, 0.6, 0.9), wall="east"), rotation=270),
)
SHELF = Decoration("shelf", "wall_shelf", "room_0/washer_1", "west", 0.16, 1.4, 0.5, 90, 0.8, 0.22, 0.04)
CAN = Decoration("can", "paint_can", "gone", None, 0.25, 0.52, 2.584, 90, 0.18, 0.18, 0.2)
BASKET = Decoration("basket", "basket", None, None, 1.47, 0.0, 0.72, 270, 0.36, 0.3, 0.3)


def test_who_is_in_the_way_goes_to_what_is_free_once_all_else_is_at_rest() -> None:
    """The shelf turns with the washer that it hangs over, and floats across the room until it is hung again."""
    room = room_of(*LAUNDRY, width=1.7, depth=3.1, openings=(WAY_IN,), decorations=(CAN, SHELF, BASKET))
    fixed = fix(replace(room, wall_thickness=0.1, dynamic=(Dynamic("me", "person", "room_0", 1.32, 0.0, 2.75),)))
    assert (errors(fixed.scene), fixed.conflicts) == ([], ())
    assert fix(fixed.scene).scene == fixed.scene


KITCHEN = (
    ("counter_1", 3.081, 0.107, 0, (1.8, 0.6, 0.9), "north"),
    ("sink_1", 3.76, 2.32, 180, (0.8, 0.6, 0.9), "south"),
    ("stove_1", 2.185, 0.38, 0, (0.6, 0.6, 0.9), "north"),
    ("refrigerator_1", 3.435, 0.43, 0, (0.7, 0.7, 1.8), "north"),
    ("counter_2", 2.785, 0.38, 0, (0.6, 0.6, 0.9), "north"),
    ("dining_table_1", 1.1, 1.57, 0, (0.8, 0.8, 0.75), None),
    ("dining_chair_1", 4.344, 0.801, 270, (0.46, 0.5, 0.9), None),
    ("dining_chair_2", 0.6, 1.57, 90, (0.46, 0.5, 0.9), None),
    ("dishwasher_1", 3.06, 2.32, 180, (0.6, 0.6, 0.9), "south"),
    ("sideboard_1", 0.703, 1.712, 270, (1.0, 0.4, 0.84), "east"),
)


def test_who_finds_no_place_from_where_he_is_finds_it_from_where_he_came_to() -> None:
    pieces = [
        replace(
            body(name, x, z, size, wall=wall, under="room_0/dining_table_1" if "chair" in name else None),
            rotation=rotation,
        )
        for name, x, z, rotation, size, wall in KITCHEN
    ]
    doors = Opening("way", "passage", "south", 2.05, connects_to="EXTERIOR"), Opening("window", "window", "east", 1.35, 1.2, 1.4, 0.9)
    people = Dynamic("you", "person", "room_0", 3.92, 0.0, 0.937), Dynamic("me", "person", "room_0", 2.185, 0.0, 0.38)
    room = room_of(*pieces, width=4.65, depth=2.7, openings=doors)
    fixed = fix(replace(room, wall_thickness=0.1, dynamic=people))
    assert (errors(fixed.scene), fixed.conflicts) == ([], ())
    assert fix(fixed.scene).scene == fixed.scene


def test_who_stands_in_an_aisle_with_countless_places_a_millimetre_apart_leaves_it() -> None:
    """Between two rows of locked crates, each of another depth, whoever stands shuts off those behind; before them the floor is free."""
    rows = []
    for side, x in (("left", 0.42), ("right", 1.98)):
        fronts = [1.2 + 0.3 * k + 0.001 * ((7 * k + len(side)) % 11) for k in range(13)]
        for k, (front, back) in enumerate(pairwise(fronts)):
            depth = round(back - front - 0.002 * (k % 4 + 1), 3)
            crate = body(f"{side}_crate_{k}", x, round(front + depth / 2, 4), (round(0.8 + 0.003 * (k % 5), 3), depth, 1.0), locked=True)
            rows.append(crate)
    wardrobe = body("wardrobe_1", 1.2, 0.3, (1.2, 0.6, 2.0), wall="north", locked=True)
    door = Opening("door", "door", "south", 1.2, 0.9, connects_to="EXTERIOR", main_entrance=True)
    room = room_of(wardrobe, *rows, width=2.4, depth=6.8, openings=(door,))
    assert errors(room) == []
    fixed = fix(replace(room, dynamic=(Dynamic("me", "person", "room_0", 1.2, 0.0, 3.0, 0, 0.5, 0.3, 1.7),)))
    assert (errors(fixed.scene), fixed.conflicts) == ([], ())
