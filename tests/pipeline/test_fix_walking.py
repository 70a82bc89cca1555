"""fix() where the rule `unreachable` is an error: ways are kept free, and what cannot be used together is named."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from catalogs import load_catalogs
from solver import Scene, fix, validate
from solver.answers import Fixed
from solver.scene import Dynamic, Opening
from solver.streams import Stream
from solver.validator import RULES
from tests.pipeline.fix_rooms import BACK_TO, WALLS, body, errors, pieces, room_of, untrue_repairs, with_repair
from tests.sweeps import seeds

DOOR = Opening("door", "door", "south", 1.5, 0.8, connects_to="EXTERIOR", main_entrance=True)


@pytest.fixture(autouse=True)
def _strict(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(RULES, "unreachable", "error")


def test_a_way_to_a_wardrobe_is_made() -> None:
    wardrobe = body("wardrobe_1", 1.5, 0.33, (1.2, 0.6, 2.0), wall="north")
    fixed = fix(room_of(wardrobe, body("box_1", 1.5, 1.05, (1.6, 0.7, 0.5)), width=3.0, depth=3.0, openings=(DOOR,)))
    assert fixed.conflicts == ()
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene)["room_0/wardrobe_1"].wall is not None


def narrow() -> Scene:
    wardrobe = body("wardrobe_1", 1.0, 0.33, (1.8, 0.6, 2.0))
    return room_of(wardrobe, body("bed_1", 1.0, 1.15, (2.0, 0.9, 0.5)), width=2.0, depth=2.6)


def test_what_can_stand_but_not_be_reached_is_a_conflict_with_the_place_to_stand_in_its_chain() -> None:
    fixed = fix(narrow())
    assert {issue.rule for issue in fixed.issues if issue.severity == "error"} == {"unreachable"}
    conflict = fixed.conflicts[0]
    assert conflict.ids == ("room_0/bed_1",)
    assert "can stand but cannot be reached in room_0 as turned now" in conflict.message
    assert conflict.message.endswith("bed 2.00 + to stand 0.60 = 2.60 > 2.00 m from west to east: 60 cm short")
    assert {repair["action"] for repair in conflict.repairs} == {"shrink", "leave_out"}
    for repair in conflict.repairs:
        assert errors(fix(with_repair(narrow(), repair)).scene) == [], repair
    assert [other.message[:23] for other in fixed.conflicts[1:]] == ["not found: out of reach"]


@pytest.mark.parametrize(("size", "locked"), [((0.599, 0.632, 0.9), True), ((0.5985, 0.632, 0.9), False)])
def test_who_stands_at_a_side_that_ends_between_millimetres_stands_at_that_side(size: tuple[float, float, float], locked: bool) -> None:
    """And not half a millimetre beside it, where its rectangle ends that is rounded outwards."""
    stove = body("stove_1", 1.266, 1.391, size, locked=locked)
    for x in (0.769, 1.242, 1.471):
        fixed = fix(room_of(stove, replace(body("desk_1", x, 1.95, (1.028, 0.591, 0.75)), rotation=180), width=4.1, depth=2.72))
        assert (fixed.conflicts, errors(fixed.scene)) == ((), []), x


def test_what_cannot_be_reached_alone_is_no_matter_of_what_it_cannot_stand_with() -> None:
    """A crate beside which there is too little floor to stand on, and a desk that does not fit beside it."""
    crate, desk = body("crate_1", 1.6, 0.5, (1.5, 0.9, 0.8)), body("desk_1", 0.6, 0.5, (1.0, 0.9, 0.75))
    assert fix(room_of(desk, width=2.4, depth=1.4)).conflicts == ()
    (conflict,) = fix(room_of(crate, desk, width=2.4, depth=1.4)).conflicts
    assert conflict.ids == (crate.id,)
    assert "can stand but cannot be reached" in conflict.message


def test_of_pieces_that_cannot_stand_together_those_are_told_that_cannot_be_reached_without_the_rest_either() -> None:
    """Two sofas as wide as the room, before the door's floor, and a shelf: with it they do not fit, without it one shuts the other off."""
    near, far = body("sofa_1", 1.0, 0.5, (1.9, 1.0, 0.8)), body("sofa_2", 1.0, 1.55, (1.9, 1.0, 0.8))
    shelf, door = body("gizmo_1", 1.0, 1.0, (1.9, 0.3, 0.8)), Opening("door", "door", "south", 1.0, connects_to="EXTERIOR")
    for alone in (near, far):
        assert fix(room_of(alone, shelf, width=2.0, depth=3.0, openings=(door,))).conflicts == ()
    (conflict,) = fix(room_of(near, far, shelf, width=2.0, depth=3.0, openings=(door,))).conflicts
    assert conflict.ids == (near.id, far.id)
    assert "can stand but cannot all be reached" in conflict.message


def test_what_could_not_be_reached_without_a_piece_locked_outside_either_has_a_conflict_of_its_own() -> None:
    chest = body("chest_1", 4.0, 1.3, (0.6, 0.6, 0.8), locked=True)
    bed = body("bed_1", 1.0, 0.5, (2.0, 0.9, 0.5))
    conflicts = fix(room_of(chest, bed, width=2.0, depth=2.6)).conflicts
    assert [conflict.ids for conflict in conflicts] == [(chest.id,), (bed.id,)]
    assert conflicts[1].message.startswith("bed 2.00 x 0.90 m can stand but cannot be reached in room_0")


@pytest.mark.parametrize("main", [False, True])
@pytest.mark.parametrize("behind", [False, True])
def test_only_what_the_way_in_needs_is_joined(main: bool, behind: bool) -> None:
    """A bar parts a room with doors outside at both ends, the near one perhaps the main entrance; a chest leaves it on one side."""
    bar = body("wardrobe_1", 1.5, 2.5, (3.0, 0.6, 2.0))
    chest = body("chest_1", 0.3, 0.5 if behind else 3.2, (0.8, 0.4, 0.8))
    ends = [replace(DOOR, id=wall, wall=wall, main_entrance=main and wall == "south") for wall in ("south", "north")]
    scene = room_of(bar, chest, width=3.0, depth=5.0, openings=tuple(ends))
    fixed = fix(scene)
    assert errors(fixed.scene) == [] or fixed.conflicts
    if not (main and behind):
        assert fixed.conflicts == ()
        assert [(move.id, move.dx, move.dz) for move in fixed.moves] == [(chest.id, 0.1, 0.0)]


def thronged(seed: int) -> Scene:
    """A room of 1.6-2.3 m with a wardrobe at its north wall and 3 to 9 people anywhere; a door leads outside, or two."""
    stream = Stream(seed, "thronged rooms")
    width, depth = 1.6 + stream.below(700) / 1000, 1.6 + stream.below(700) / 1000
    wardrobe = body("wardrobe_1", width - 0.5, 0.25, (1.0, 0.5, 2.0), wall="north")
    folk = [
        Dynamic(f"person_{k}", "person", "room_0", stream.unit() * width, 0.0, stream.unit() * depth, 90 * stream.below(4), 0.5, 0.3, 1.7)
        for k in range(3 + stream.below(7))
    ]
    doors = [replace(DOOR, position=width / 2, main_entrance=False)]
    if stream.chance(0.5):
        doors.append(replace(doors[0], id="back_door", wall="west", position=depth - 0.5))
    return replace(room_of(wardrobe, width=round(width, 3), depth=round(depth, 3), openings=tuple(doors)), dynamic=tuple(folk))


@pytest.mark.parametrize("seed", range(24))
def test_without_those_who_are_named_all_others_have_their_places(seed: int) -> None:
    scene = thronged(seed)
    fixed = fix(scene)
    named = {label for conflict in fixed.conflicts for label in conflict.ids}
    assert named <= {person.id for person in scene.dynamic}
    assert bool(named) is (errors(fixed.scene) != [])
    for base in (scene, fixed.scene):
        again = fix(replace(base, dynamic=tuple(person for person in base.dynamic if person.id not in named)))
        assert (again.conflicts, errors(again.scene)) == ((), [])


def test_some_are_named_above_and_some_rooms_hold_all() -> None:
    counts = [len(fix(thronged(seed)).conflicts) for seed in range(24)]
    assert 0 in counts
    assert max(counts) > 1


def test_who_is_in_the_way_steps_aside_though_the_room_is_parted() -> None:
    """Behind the bar one comes in by the other door: before it somebody stands where nobody gets past."""
    bar = replace(body("wardrobe_1", 1.5, 2.5, (3.0, 0.6, 2.0)), rotation=180)
    ends = tuple(replace(DOOR, id=wall, wall=wall, main_entrance=False) for wall in ("south", "north"))
    walker = Dynamic("person_1", "person", "room_0", 1.5, 0.0, 1.2, 0, 2.4, 0.3, 1.7)
    scene = replace(room_of(bar, width=3.0, depth=5.0, openings=ends), dynamic=(walker,))
    assert [issue.rule for issue in validate(scene, load_catalogs()) if issue.severity == "error"] == ["unreachable"]
    fixed = fix(scene)
    assert (fixed.conflicts, errors(fixed.scene)) == ((), [])
    assert [move.id for move in fixed.moves] == [walker.id]


def test_no_piece_of_a_crowded_l_shaped_room_can_go_back_a_centimetre_by_itself() -> None:
    crowd = [
        (180, body("sofa_1", 1.118, 4.171, (2.159, 0.982, 0.85))), (270, body("bookshelf_1", 2.727, 2.331, (0.708, 0.394, 1.9))),
        (90, body("crate_1", 3.404, 2.437, (0.519, 0.513, 0.5))), (180, body("dining_table_1", 3.086, 0.79, (1.299, 0.751, 0.75))),
        (0, body("wardrobe_1", 2.863, 2.296, (1.365, 0.558, 2.2))), (270, body("bookshelf_2", 3.113, 0.912, (0.974, 0.377, 1.9))),
    ]  # fmt: skip
    outline = ((0.0, 0.0), (4.4, 0.0), (4.4, 2.58), (1.77, 2.58), (1.77, 4.4), (0.0, 4.4))
    door = Opening("door", "door", position=0.9, width=0.8, connects_to="EXTERIOR", edge=1)
    sent = replace(
        room_of(*(replace(one, rotation=turn) for turn, one in crowd), width=4.4, depth=4.4, outline=outline, openings=(door,)),
        wall_thickness=0.1,
    )
    room, wished = fix(sent).scene.rooms[0], pieces(sent)
    assert errors(replace(sent, rooms=(room,))) == []
    for piece in room.furniture:
        for axis in ("x", "z"):
            away = getattr(wished[piece.id], axis) - getattr(piece, axis)
            back = replace(piece, **{axis: round(getattr(piece, axis) + (0.01 if away > 0 else -0.01), 4)})
            trial = replace(room, furniture=tuple(back if one is piece else one for one in room.furniture))
            assert abs(away) < 0.01 or errors(replace(sent, rooms=(trial,))), (piece.id, axis)


def furnished(seed: int) -> Scene:
    """A bedroom of 2.8-3.6 m with pieces thrown in at its walls."""
    stream = Stream(seed, "walked bedrooms")
    width, depth = 2.8 + stream.below(800) / 1000, 2.8 + stream.below(800) / 1000
    kinds = (("bed_1", (1.6, 2.0, 0.5)), ("wardrobe_1", (1.2, 0.6, 2.0)), ("desk_1", (1.0, 0.5, 0.75)), ("chest_1", (0.8, 0.4, 0.8)))
    found = []
    for name, size in kinds:
        wall = WALLS[stream.below(4)]
        x, z = round(stream.unit() * width, 3), round(stream.unit() * depth, 3)
        piece = body(name, x, z, size, wall=wall)
        found.append(type(piece)(**{**vars(piece), "rotation": BACK_TO[wall]}))
    return room_of(*found, width=round(width, 3), depth=round(depth, 3), openings=(DOOR,))


@pytest.mark.parametrize("seed", range(16))
def test_an_answer_is_clean_or_explained_and_repaired_to_itself(seed: int) -> None:
    fixed = fix(furnished(seed))
    named = {label for conflict in fixed.conflicts for label in conflict.ids}
    broken = [issue for issue in validate(fixed.scene, load_catalogs()) if issue.severity == "error"]
    assert bool(broken) == bool(fixed.conflicts)
    assert all(named & set(issue.ids) or not issue.ids for issue in broken)
    assert fix(fixed.scene).scene == fixed.scene


def test_most_of_the_rooms_above_are_repaired() -> None:
    assert sum(not fix(furnished(seed)).conflicts for seed in range(16)) >= 12


def crowded(seed: int) -> Scene:
    """A laundry of 1.5-2.4 m with more appliances and shelves than it holds, all at walls."""
    stream = Stream(seed, "crowded laundries")
    width, depth = 1.5 + stream.below(900) / 1000, 1.9 + stream.below(500) / 1000
    kinds = (
        ("washer_1", (0.6, 0.6, 0.85)),
        ("dryer_1", (0.6, 0.6, 0.85)),
        ("sink_1", (0.6, 0.6, 0.9)),
        ("storage_shelf_1", (1.0, 0.4, 1.8)),
    )
    more = (("storage_shelf_2", (1.0, 0.4, 1.8)), ("drying_rack_1", (1.0, 0.56, 1.0)), ("laundry_basket_1", (0.46, 0.36, 0.6)))
    found = []
    for name, size in (*kinds, *more[: 1 + stream.below(3)]):
        wall = WALLS[stream.below(4)]
        piece = body(name, round(stream.unit() * width, 3), round(stream.unit() * depth, 3), size, wall=wall)
        found.append(
            replace(piece, rotation=BACK_TO[wall], name={"shelf": "storage_shelf", "rack": "drying_rack"}.get(piece.name, piece.name))
        )
    door = replace(DOOR, position=round(width / 2, 3))
    return room_of(*found, width=round(width, 3), depth=round(depth, 3), openings=(door,))


@cache
def repaired(seed: int) -> Fixed:
    return fix(crowded(seed))


@pytest.mark.parametrize("seed", seeds(range(24), 5))
def test_every_repair_leaves_a_crowded_room_clean_with_the_first_of_each_other_conflict(seed: int) -> None:
    assert untrue_repairs(crowded(seed), repaired(seed)) == []


def test_the_crowded_rooms_have_one_conflict_or_several_and_something_is_offered() -> None:
    answers = [repaired(seed).conflicts for seed in range(0, 24, 3)]
    assert {1, 2} <= {min(len(conflicts), 2) for conflicts in answers}
    assert sum(len(conflict.repairs) for conflicts in answers for conflict in conflicts) > 20


ODD = [
    ((2.04, 1.74), 1.3, 0.801, [("toilet_1", 0.85, 0.62, (0.4, 0.66, 0.8), 180), ("sink_1", 0.42, 0.67, (0.5, 0.42, 0.86), 270)]),
    ((2.41, 1.89), 1.14, 0.601, [("toilet_1", 1.71, 1.33, (0.4, 0.66, 0.8), 180), ("laundry_basket_1", 1.74, 1.11, (0.46, 0.36, 0.6), 0)]),
    ((2.95, 1.62), 0.63, 0.801, [("laundry_basket_1", 2.22, 0.94, (0.46, 0.36, 0.6), 0), ("bookshelf_1", 2.36, 0.69, (0.8, 0.3, 1.8), 0)]),
]
"""Room, where its door is, who walks, and pieces where they are sent: the way to one is as wide as who walks, half a millimetre counts."""


@pytest.mark.parametrize(("extents", "door_at", "robot", "sent"), ODD)
def test_who_is_an_odd_number_of_millimetres_wide_gets_a_way_as_all_others_do(
    extents: tuple[float, float], door_at: float, robot: float, sent: list[tuple[str, float, float, tuple[float, float, float], int]]
) -> None:
    door = Opening("door", "door", "south", door_at, 0.9, connects_to="EXTERIOR", main_entrance=True)
    furniture = [replace(body(*one[:4]), rotation=one[4]) for one in sent]
    scene = room_of(*furniture, width=extents[0], depth=extents[1], openings=(door,))
    for who in (robot, robot + 0.001):
        fixed = fix(replace(scene, request={"robot_width": round(who, 3)}))
        assert not fixed.conflicts
        assert not errors(fixed.scene)


def test_of_a_piece_for_which_no_place_was_found_it_is_not_said_that_it_can_stand() -> None:
    """Whether the shelf can stand beside the seven others is open when the search ends; so is whether it can be reached."""
    furniture = (
        replace(body("bookshelf", 1.412, 2.888, (0.6, 0.28, 1.8), wall="west"), rotation=180),
        body("bed", 2.362, 1.09, (1.4, 2.0, 0.9), wall="north"),
        replace(body("tv_stand", 1.677, 2.93, (1.1, 0.38, 0.5), wall="east"), rotation=270),
        body("toilet", 0.647, 1.743, (0.4, 0.66, 0.8), wall="south"),
        replace(body("coffee_table", 1.719, 0.097, (1.1, 0.6, 0.42), wall="east"), rotation=105),
        body("sideboard", 0.135, 2.386, (1.6, 0.44, 0.84), wall="south"),
        replace(body("storage_shelf", 1.896, 2.307, (1.0, 0.4, 1.8)), rotation=270),
        replace(body("counter", 0.298, 1.063, (0.6, 0.6, 0.9), wall="north"), rotation=270),
    )
    door = Opening("door", "door", "south", 1.2, 0.9, connects_to="EXTERIOR")
    window = Opening("window", "window", "east", 1.2, 1.0, 1.2, 0.9, "EXTERIOR")
    fixed = fix(room_of(*furniture, openings=(door, window), width=2.827, depth=3.047), repairs=False)
    assert fixed.conflicts[0].ids == ("room_0/bookshelf",)
    assert fixed.conflicts[0].message.startswith("not found: a place for bookshelf 0.60 x 0.28 m in room_0 beside all else")
