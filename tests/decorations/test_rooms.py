"""What stands and lies on the floors, room by room; and that nobody is kept from walking by it."""

from __future__ import annotations

from itertools import pairwise, product

import pytest

from catalogs import load_catalogs
from solver.scene import Decoration, Furniture, Opening, Room, Scene
from solver.validator import validate
from tests.decorations.oracle import complaints
from tests.decorations.rooms import DOOR, SIDE, THICKNESS, at_wall, decorate, on_floor, piece, room

KNOWN = load_catalogs()
INDOORS = sorted(name for name, kind in KNOWN.rooms.items() if not kind.outdoor)


def rugs(done: Room) -> list[Decoration]:
    return [thing for thing in done.decorations if thing.name in ("rug", "runner")]


def errors(done: Room) -> list[str]:
    scene = Scene(wall_thickness=THICKNESS, rooms=(done,))
    told = [issue.message for issue in validate(scene, KNOWN) if issue.severity == "error"]
    return [*told, *complaints(scene)]


@pytest.mark.parametrize("name", [name for name in INDOORS if name != "hallway"])
@pytest.mark.parametrize("size", [(4.0, 3.0), (3.0, 5.2), (1.5, 1.5)])
def test_every_indoor_room_has_a_rug_of_four_fifths_of_its_size(name: str, size: tuple[float, float]) -> None:
    done = decorate(room(type=name, width=size[0], depth=size[1]))
    (rug,) = rugs(done)
    extents = [rug.width, rug.depth] if rug.rotation % 180 == 0 else [rug.depth, rug.width]
    assert extents == pytest.approx([0.8 * side for side in size], abs=0.01)
    assert [rug.x, rug.z] == pytest.approx([side / 2 for side in size], abs=0.01)
    assert rug.height <= 0.02 and rug.color == "#123456"
    assert errors(done) == []


GROUPS = {"living_room": ("coffee_table", 0.7, 0), "dining_room": ("dining_table", 0.7, 0), "bedroom": ("bed", 0.5, 0.35)}


@pytest.mark.parametrize(("length", "count"), [(3.0, 1), (5.0, 1), (5.2, 2), (12.0, 3), (21.0, 4)])
@pytest.mark.parametrize("turned", [False, True])
def test_with_a_style_long_halls_have_several_runners_one_behind_another(length: float, count: int, turned: bool) -> None:
    wide, deep = (1.2, length) if turned else (length, 1.2)
    laid = rugs(decorate(room(type="hallway", width=wide, depth=deep, openings=()), style=KNOWN.styles["scandi"], style_name="scandi"))
    ends = sorted((at - rug.width / 2, at + rug.width / 2) for rug in laid for at in ((rug.z if turned else rug.x),))
    assert len(laid) == count and all(rug.width <= 4.0 and rug.rotation % 180 == (90 if turned else 0) for rug in laid)
    assert ends[0][0] + ends[-1][1] == pytest.approx(length, abs=0.02)
    assert ends[-1][1] - ends[0][0] == pytest.approx(0.8 * length, abs=0.06)
    assert all(0.6 <= after[0] - before[1] + 1e-9 < 0.62 for before, after in pairwise(ends))


@pytest.mark.parametrize("name", sorted(GROUPS))
@pytest.mark.parametrize("at", [(2.5, 2.0), (0.8, 2.0), (4.3, 3.2)])
@pytest.mark.parametrize("turn", [0, 90, 180, 270])
def test_with_a_style_a_rug_is_as_large_as_what_it_lies_under_and_a_little_more(name: str, at: tuple[float, float], turn: int) -> None:
    kind, beyond, begins = GROUPS[name]
    holder = piece(kind, *at, turn)
    bare = room(holder, type=name, width=5.0, depth=4.0)
    (rug,) = rugs(decorate(bare, style=KNOWN.styles["scandi"], style_name="scandi"))
    wide, deep = (rug.width, rug.depth) if rug.rotation % 180 == 0 else (rug.depth, rug.width)
    least, gap = THICKNESS / 2 + 0.1, 0.011
    across, along = (holder.width, holder.depth) if turn % 180 == 0 else (holder.depth, holder.width)
    backs = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}[turn]  # in the west or north, in the east or south
    for middle, extent, own, side, back in ((rug.x, wide, (at[0], across), 5.0, backs[0]), (rug.z, deep, (at[1], along), 4.0, backs[1])):
        low, high = own[0] - own[1] / 2 - beyond, own[0] + own[1] / 2 + beyond
        if begins and back:
            low, high = (low + beyond + begins * own[1], high) if back > 0 else (low, high - beyond - begins * own[1])
        low, high = max(low, least), min(high, side - least)
        lesser = min(own[0] - own[1] / 2 - low, high - own[0] - own[1] / 2)
        if lesser > beyond / 4:  # as far beyond one side as beyond the other
            low, high = own[0] - own[1] / 2 - lesser, own[0] + own[1] / 2 + lesser
        assert (middle - extent / 2, middle + extent / 2) == pytest.approx((low, high), abs=gap)
    assert rug.color in KNOWN.styles["scandi"].palette["rug"]
    assert [one.name for one in rugs(decorate(bare))] == ["rug"]


BESIDE = {
    "hallway": (3.0, (("console_table", "west", 2.0), ("shoe_cabinet", "west", 4.0), ("coat_rack", "north", 1.5))),
    "bathroom": (2.2, (("bathtub", "west", 3.0), ("vanity", "north", 1.4))),
    "living_room": (SIDE, (("coffee_table", None, 3.0), ("bed", "west", 2.4), ("bookshelf", "north", 3.2))),
    "bedroom": (SIDE, (("bed", "north", 3.0), ("wardrobe", "west", 1.2), ("dresser", "east", 1.4))),
    "dining_room": (SIDE, (("dining_table", None, 1.9), ("sideboard", "north", 3.0))),
}
"""By type: its width, and what stands there, at which wall and where along it; or free, so far from the north."""


@pytest.mark.parametrize("name", sorted(BESIDE))
def test_with_a_style_rugs_lie_beside_what_stands_at_the_walls_not_under_it(name: str) -> None:
    width, pieces = BESIDE[name]
    there = [at_wall(kind, wall, along) if wall else piece(kind, width / 2, along) for kind, wall, along in pieces]
    done = decorate(room(*there, type=name, width=width, openings=()), style=KNOWN.styles["scandi"], style_name="scandi")
    laid = [thing for thing in done.decorations if thing.name in ("rug", "runner", "floor_rug_small")]
    assert laid
    for rug, one in product(laid, there):
        if not (name == "bedroom" and one.name == "bed") and one.wall:
            assert not overlap(rug, one), (rug, one)
    if not there[0].wall:
        assert any(overlap(rug, there[0]) for rug in laid)


@pytest.mark.parametrize("name", ["hallway", "living_room"])
def test_with_a_style_rugs_lie_where_no_door_opens_over_them(name: str) -> None:
    width, pieces = BESIDE[name]
    there = [at_wall(kind, wall, along) if wall else piece(kind, width / 2, along) for kind, wall, along in pieces]
    over = {"in": 0, "out": 0}
    for swing, at in product(over, (0.6, 1.5, 2.2)):
        door = Opening("d", "door", "south", at, 0.9, connects_to="EXTERIOR", swing=swing)
        home = room(*there, type=name, width=width, depth=4.6, openings=(door,))
        done = decorate(home, style=KNOWN.styles["scandi"], style_name="scandi")
        before = Furniture("before", "box", x=at, z=home.depth - 0.45, width=0.9, depth=0.9, height=0.01)
        laid = [thing for thing in done.decorations if thing.name in ("rug", "runner", "floor_rug_small")]
        assert laid
        over[swing] += sum(overlap(rug, before) for rug in laid)
    assert over["in"] == 0 < over["out"]


def overlap(one: Decoration | Furniture, other: Decoration | Furniture) -> bool:
    (x, width), (z, depth) = ((abs(getattr(one, axis) - getattr(other, axis)), _extent(one, axis) + _extent(other, axis)) for axis in "xz")
    return x < width / 2 - 1e-6 and z < depth / 2 - 1e-6


def _extent(one: Decoration | Furniture, axis: str) -> float:
    return one.width if (axis == "x") == (one.rotation % 180 == 0) else one.depth


def test_a_mat_in_the_middle_stays_under_what_stands_free() -> None:
    done = decorate(room(piece("bistro_table"), type="balcony", outdoor=True))
    (mat,) = [thing for thing in done.decorations if thing.name == "floor_rug_small"]
    assert (mat.x, mat.z, mat.width) == (SIDE / 2, SIDE / 2, KNOWN.decorations["floor_rug_small"].size[0])


@pytest.mark.parametrize("name", ["garage", "kitchen", "living_room"])
def test_with_a_style_a_room_without_a_group_has_no_rug(name: str) -> None:
    assert rugs(decorate(room(type=name), style=KNOWN.styles["scandi"], style_name="scandi")) == []


def test_a_room_narrower_than_a_metre_and_a_half_has_no_rug() -> None:
    assert rugs(decorate(room(type="bathroom", width=1.49, depth=3.0))) == []


def test_outdoors_no_rug() -> None:
    for name in sorted(set(KNOWN.rooms) - set(INDOORS)):
        assert rugs(decorate(room(type=name, outdoor=True))) == []


@pytest.mark.parametrize("size", [(8.0, 1.3), (1.2, 6.0), (3.0, 5.0)])
def test_a_hallway_has_a_long_thin_runner(size: tuple[float, float]) -> None:
    done = decorate(room(type="hallway", width=size[0], depth=size[1]))
    (runner,) = rugs(done)
    assert runner.name == "runner"
    assert runner.width == pytest.approx(0.8 * max(size), abs=0.01)
    assert runner.depth == pytest.approx(min(0.8 * min(size), 0.8), abs=0.01)
    assert runner.rotation == (0 if size[0] > size[1] else 90)


def in_corner(thing: Decoration, done: Room) -> bool:
    return min(thing.x, done.width - thing.x) < 0.9 and min(thing.z, done.depth - thing.z) < 0.9


def test_a_living_room_has_plants_in_its_corners() -> None:
    done = decorate(room(at_wall("sofa"), type="living_room"))
    plants = [thing for thing in done.decorations if thing.name in ("potted_plant", "slim_plant") and in_corner(thing, done)]
    assert len(plants) >= 2
    assert errors(done) == []


def test_a_master_bedroom_has_a_plant_in_a_corner() -> None:
    done = decorate(room(at_wall("bed"), type="bedroom_master"))
    assert any(thing.name in ("potted_plant", "slim_plant") and in_corner(thing, done) for thing in done.decorations)
    assert errors(done) == []


def test_a_kids_bedroom_has_its_toys() -> None:
    for seed in range(5):
        done = decorate(room(at_wall("single_bed"), at_wall("toy_chest", "west"), type="kids_bedroom"), seed)
        found = on_floor(done)
        assert {name: found[name] for name in ("toy_blocks", "toy_car", "stuffed_animal", "basket")} == {
            "toy_blocks": 1, "toy_car": 1, "stuffed_animal": 2, "basket": 1,
        }  # fmt: skip
        assert errors(done) == []


@pytest.mark.parametrize(("name", "piece"), [("hallway", "shoe_cabinet"), ("foyer", "console_table")])
def test_an_entrance_has_its_things_beside_what_stands_there(name: str, piece: str) -> None:
    for seed in range(5):
        done = decorate(room(at_wall(piece), type=name), seed)
        found = on_floor(done)
        assert (found["shoe_pair"], found["umbrella_stand"], found["basket"]) == (2, 1, 1)
        near = [thing for thing in done.decorations if thing.name in ("shoe_pair", "umbrella_stand", "basket") and thing.parent is None]
        assert all(abs(thing.x - SIDE / 2) < 2.2 and thing.z < 0.5 for thing in near)
        assert errors(done) == []


def test_no_shoes_stand_in_a_hallway_that_nobody_enters_the_home_by() -> None:
    found = on_floor(decorate(room(at_wall("console_table"), type="hallway")))
    assert (found["shoe_pair"], found["umbrella_stand"], found["basket"]) == (0, 0, 1)


def test_a_laundry_has_a_basket() -> None:
    done = decorate(room(at_wall("washer"), type="laundry"))
    assert on_floor(done)["basket"] == 1
    assert errors(done) == []


@pytest.mark.parametrize("name", sorted(KNOWN.rooms))
def test_every_type_of_room_is_decorated_without_an_error(name: str) -> None:
    outdoor = KNOWN.rooms[name].outdoor
    for size in ((3.0, 2.6), (5.0, 4.0), (1.2, 4.0)):
        bare = room(
            type=name,
            outdoor=outdoor,
            width=size[0],
            depth=size[1],
            openings=(Opening("d", wall="north", position=0.6, connects_to="EXTERIOR"),),
        )
        done = decorate(bare)
        assert done.decorations or min(size) < 1.5
        assert errors(done) == []


def test_a_body_never_closes_the_only_way() -> None:
    """Two halves of a room joined by a gap of exactly the robot's width stay joined, whatever is drawn."""
    wardrobe, other = at_wall("wardrobe", "west", 3.0, number=1), at_wall("wardrobe", "east", 3.0, number=2)
    for gap in (0.6, 0.65, 0.8):
        width = 2 * (0.6 + 0.08) + gap
        moved = [wardrobe, type(other)(**{**vars(other), "x": round(width - 0.38, 4)})]
        for seed in range(10):
            done = decorate(room(*moved, type="kids_bedroom", width=width, depth=6.0), seed)
            assert errors(done) == []


def test_without_a_way_in_nothing_stands_on_the_floor() -> None:
    done = decorate(room(at_wall("single_bed"), type="kids_bedroom", openings=()))
    assert set(on_floor(done)) == {"rug"}


def test_tall_things_keep_clear_of_windows_and_doors() -> None:
    windows = tuple(
        Opening(f"w{k}", "window", wall, at, 1.2, 1.4, 0.9) for k, (wall, at) in enumerate((("north", 1.0), ("north", 5.0), ("east", 1.0)))
    )
    for seed in range(5):
        done = decorate(room(type="living_room", openings=(DOOR, *windows)), seed)
        for thing in done.decorations:
            if thing.parent is None and thing.mounted_on_wall is None and thing.height > 0.9:
                assert not (thing.z < 0.5 and (0.3 < thing.x < 1.7 or 4.3 < thing.x < 5.7))
                assert not (thing.x > SIDE - 0.5 and 0.3 < thing.z < 1.7)
        assert errors(done) == []
