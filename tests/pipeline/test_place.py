"""place(): relations of every kind, obstacles, hard relations, alternatives, and the reason where it cannot be done."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from catalogs.schema import RelationSpec
from solver import place, validate
from solver.errors import RequestError
from solver.relations.held import held
from solver.requested import Answered, PieceRequest, in_order
from solver.scene import Decoration, Furniture, Level, Opening, Room
from tests.relations.test_held import finished
from tests.told_forms import has_form

CATALOGS = load_catalogs()
DOOR = Opening("door_1", "door", "south", 0.7, 0.9, connects_to="EXTERIOR")
WINDOW = Opening("window_1", "window", "north", 2.0, 1.4, 1.2, 0.9)
ROOM = Room("den_0", 0, "den", width=4.4, depth=4.0, openings=(DOOR, WINDOW))


def rule(type: str, of: str | None = None, **more: Any) -> RelationSpec:
    return RelationSpec.model_validate({"type": type, **({} if of is None else {"of": of}), **more})


def wish(name: str, *relations: RelationSpec, **more: Any) -> PieceRequest:
    return PieceRequest(more.pop("id", name), name, relations=relations, **more)


def block(name: str, *relations: RelationSpec, size: tuple[float, float, float] = (0.5, 0.5, 0.8), **more: Any) -> PieceRequest:
    return wish(name, *relations, width=size[0], depth=size[1], height=size[2], **more)


def placed(*wishes: PieceRequest, room: Room = ROOM, **more: Any) -> Answered:
    return place(room, wishes, wall_thickness=0.1, catalogs=CATALOGS, **more)


def body(answer: Answered, label: str) -> Furniture:
    return next(piece for piece in answer.best.scene.rooms[0].furniture if piece.id == label)


def errors(answer: Answered) -> list[str]:
    return [issue.message for issue in answer.best.issues if issue.severity == "error"]


TABLE = block("table", size=(1.4, 0.8, 0.75))
PAIRS = [
    rule("beside", "table"), rule("in_front_of", "table"), rule("around", "table"), rule("under", "table"),
    rule("near", "table", distance=0.4), rule("far_from", "table", distance=1.2), rule("facing", "table"),
    rule("aligned_with", "table"), rule("in_row", "table"), rule("on", "table"),
]  # fmt: skip
ALONE = [
    rule("against_wall"), rule("in_corner"), rule("centred"), rule("at_window"), rule("near_door", distance=0.8),
    rule("far_from_door", distance=2.5), rule("near", "window", distance=0.4), rule("far_from", "window", distance=2.0),
    rule("facing", "door"),
]  # fmt: skip


@pytest.mark.parametrize("relation", [*PAIRS, *ALONE], ids=lambda one: f"{one.type} {' '.join(one.of)}")
def test_every_relation_can_be_held(relation: RelationSpec) -> None:
    answer = placed(block("box", relation, size=(0.4, 0.4, 0.3)), TABLE)
    assert [(entry.piece, entry.type, entry.held) for entry in answer.best.relations] == [("box", relation.type, True)]
    assert (errors(answer), answer.best.unplaced, answer.conflicts) == ([], (), ())


def test_a_piece_stands_opposite_another() -> None:
    answer = placed(wish("tv_stand", rule("opposite", "sofa")), wish("sofa"))
    assert answer.best.relations[0].held
    assert (body(answer, "tv_stand").rotation - body(answer, "sofa").rotation) % 360 == 180


def test_the_judge_agrees_with_plain_arithmetic() -> None:
    answer = placed(block("box", rule("near", "table", distance=0.3)), replace(TABLE, relations=(rule("in_corner"),)))
    box, table = body(answer, "box"), body(answer, "table")
    wide, deep = (table.width, table.depth) if table.rotation % 180 == 0 else (table.depth, table.width)
    gaps = max(abs(box.x - table.x) - (0.5 + wide) / 2, 0), max(abs(box.z - table.z) - (0.5 + deep) / 2, 0)
    assert gaps[0] ** 2 + gaps[1] ** 2 <= 0.3**2 + 1e-9
    assert min(table.x - wide / 2 - 0.05, 4.35 - table.x - wide / 2) <= 0.1
    assert min(table.z - deep / 2 - 0.05, 3.95 - table.z - deep / 2) <= 0.1
    assert [entry.held for entry in answer.best.relations] == [True, True]


@pytest.mark.parametrize("more", [{}, {"gap": 0.4}, {"gap": (0.3, 0.5), "align": "centre"}])
@pytest.mark.parametrize("width", [4.4, 6.0])
def test_a_low_table_lies_along_the_sofa_that_it_stands_before(more: dict[str, Any], width: float) -> None:
    """Any turn holds the relation; nobody lays a table end-on to the sofa where it costs nothing to lay it along."""
    table = wish("coffee_table", rule("in_front_of", "sofa", **more))
    answer = placed(wish("sofa", rule("against_wall")), table, room=replace(ROOM, width=width))
    assert all(one.held for one in answer.best.relations)
    assert (body(answer, "coffee_table").rotation - body(answer, "sofa").rotation) % 180 == 0


def test_relations_to_pieces_that_come_later_are_held() -> None:
    answer = placed(block("lamp", rule("beside", "chair")), block("chair", rule("near", "table", distance=0.5)), TABLE)
    assert all(entry.held for entry in answer.best.relations)
    assert [one.id for one in in_order([block("a", rule("near", "b")), block("b", rule("near", "a"))])] == ["a", "b"]


def test_what_stands_stays_and_is_in_the_way() -> None:
    standing = Furniture("old", "wardrobe", x=1.0, z=0.4, width=1.6, depth=0.6, height=2.0, rotation=0, wall="north")
    room = replace(ROOM, openings=(DOOR,), furniture=(standing,))
    answer = placed(block("box", rule("beside", "old")), TABLE, room=room)
    assert answer.best.scene.rooms[0].furniture[0] == standing
    assert answer.best.relations[0].held
    assert errors(answer) == []


def test_what_stands_in_each_others_way_is_kept_clear_of() -> None:
    one = Furniture("one", "crate", x=1.0, z=1.0, width=1.0, depth=1.0, height=1.0)
    room = replace(ROOM, furniture=(one, replace(one, id="two", x=1.4)))
    answer = placed(TABLE, room=room)
    assert [set(issue.ids) for issue in answer.best.issues if issue.rule == "overlap"] == [{"one", "two"}]
    assert [piece.id for piece in answer.best.scene.rooms[0].furniture] == ["one", "two", "table"]


def test_copies_are_numbered_and_each_is_judged() -> None:
    answer = placed(wish("bed"), wish("nightstand", rule("beside", "bed"), id="stand", count=2))
    assert [(entry.piece, entry.of, entry.held) for entry in answer.best.relations] == [("stand_1", "bed", True), ("stand_2", "bed", True)]
    assert {piece.id for piece in answer.best.scene.rooms[0].furniture} == {"bed", "stand_1", "stand_2"}


def test_the_wall_that_a_piece_names_is_the_one_behind_it() -> None:
    window = replace(WINDOW, position=1.8)
    room = replace(ROOM, width=3.6, depth=3.0, openings=(replace(DOOR, position=0.8), window))
    desk = block("desk", rule("at_window"), rule("far_from_door", distance=1.2), size=(1.2, 0.6, 0.75))
    shelf = wish("bookshelf", rule("against_wall"), rule("in_row", "shelf"), rule("near", "desk", distance=1.2), id="shelf", count=2)
    answer = placed(desk, wish("office_chair", rule("under", "desk")), shelf, room=room)
    behind = {0: "north", 90: "west", 180: "south", 270: "east"}
    told = [(piece.id, piece.rotation, piece.wall) for piece in answer.best.scene.rooms[0].furniture if piece.wall]
    assert [(name, rotation, behind[int(rotation)]) for name, rotation, _ in told] == told
    assert {name for name, _, _ in told} >= {"shelf_1", "shelf_2"}


def test_sizes_may_be_left_out_where_the_name_is_a_kind() -> None:
    sofa = body(placed(wish("sofa")), "sofa")
    assert (sofa.width, sofa.depth, sofa.height) == CATALOGS.furniture["sofa"].size


@pytest.mark.parametrize("size", [(1e-12, 0.4), (0.4, 1e-12)])
def test_a_thing_without_a_footprint_is_no_fault(size: tuple[float, float]) -> None:
    vase = Decoration("vase_1", "vase", x=2.0, z=2.0, width=size[0], depth=size[1], height=0.3)
    answer = placed(wish("sofa"), room=replace(ROOM, decorations=(vase,)))
    assert (answer.best.unplaced, answer.best.scene.rooms[0].decorations) == ((), (vase,))


def test_what_cannot_stand_together_is_a_minimal_conflict() -> None:
    big = [block(name, size=(3.0, 2.4, 0.5)) for name in ("one", "two")]
    answer = placed(*big, block("small"))
    assert len(answer.best.unplaced) == 1
    (conflict,) = answer.conflicts
    assert set(conflict.ids) == {"one", "two"}
    for left in big:
        assert placed(left).conflicts == ()
    assert {repair["id"] for repair in conflict.repairs} == {"one", "two"}


def test_what_cannot_be_reached_together_is_a_minimal_conflict_with_what_would_help() -> None:
    doors = tuple(Opening(wall, "door", wall, 1.5, 0.9, connects_to="EXTERIOR") for wall in ("north", "south"))
    hall = Room("hall", width=3.0, depth=4.0, openings=doors)
    big = [block(name, size=(1.3, 1.9, 1.0)) for name in ("one", "two")]
    answer = placed(*big, room=hall)
    (conflict,) = answer.conflicts
    assert conflict.message == (
        "one 1.30 x 1.90 m and two 1.30 x 1.90 m can stand together in the 2.90 x 3.90 m of hall, clear of its doors and windows, "
        "but not with ways between all doors and to them"
    )
    assert has_form(conflict.message)
    assert {repair["id"] for repair in conflict.repairs} == set(conflict.ids) == {"one", "two"}
    for left in big:
        answer = placed(left, room=hall)
        assert (answer.conflicts, errors(answer)) == ((), [])
    bodies = [replace(body(placed(one, room=hall), one.id), x=x, z=1.95, rotation=0) for one, x in zip(big, (0.7, 2.3), strict=True)]
    both = replace(answer.best.scene, rooms=(replace(hall, furniture=tuple(bodies)),))
    assert [
        issue for issue in validate(both, CATALOGS) if issue.severity == "error"
    ] == []  # both doors lead outside: ways are place's wish


def test_what_has_its_place_at_what_has_none_is_said_to() -> None:
    beside = block("box", RelationSpec(type="near", of=("wide",), distance=0.5, required=True), size=(0.4, 0.4, 1.0))
    den = Room("den", width=3.0, depth=3.0)
    first, second = placed(block("wide", size=(3.5, 3.5, 1.0)), beside, room=den).conflicts
    assert (first.ids, second.ids) == (("wide",), ("box",))
    assert second.message == "box 0.40 x 0.40 m is asked for in relation to wide, for which there is no place"
    assert has_form(second.message)
    assert placed(replace(beside, relations=()), room=den).conflicts == ()


def test_of_what_stands_at_walls_it_is_said_that_it_is_for_there() -> None:
    """Two sofas fit in the middle of the room, one behind the other, clear of its door; a table is for the middle."""
    door = Opening("door", "door", "east", 1.0, 0.9, connects_to="EXTERIOR")
    den = Room("den", width=2.97, depth=2.87, openings=(door,))
    (conflict,) = placed(PieceRequest("a", "sofa"), PieceRequest("b", "sofa"), room=den).conflicts
    assert conflict.message.endswith("in the 2.87 x 2.77 m of den, clear of its doors and windows, with a and b at walls")
    assert has_form(conflict.message)
    (conflict,) = placed(PieceRequest("t", "dining_table", width=2.9, depth=2.9, height=0.75), room=den).conflicts
    assert conflict.message.endswith("windows")


def test_the_floor_of_a_room_with_an_outline_is_not_called_a_rectangle() -> None:
    arms = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (5.0, 2.0), (5.0, 4.0), (0.0, 4.0))
    (conflict,) = placed(block("box", size=(4.5, 2.5, 1.0)), room=Room("den", width=5.0, depth=4.0, outline=arms)).conflicts
    where = "in den, which 4.90 x 3.90 m enclose, clear of its doors and windows"
    assert conflict.message == f"box 4.50 x 2.50 m cannot stand as asked anywhere {where}"
    assert has_form(conflict.message)


@pytest.mark.parametrize("sides", [(3.6, 3.0), (3.0, 3.6)])
@pytest.mark.parametrize("wishes", [(), (rule("against_wall"),)])
def test_a_piece_larger_than_its_room_is_told_so(sides: tuple[float, float], wishes: tuple[RelationSpec, ...]) -> None:
    """Whether it asks for a wall or not, and in the room's own width and depth, however the search turned it."""
    den = Room("den", width=sides[0], depth=sides[1])
    wide = block("wide", *wishes, size=(4.0, 2.0, 1.0), required=False)
    long = block("long", *wishes, size=(2.5, 3.5, 1.0), required=False)
    unplaced = {one.id: one.reason for one in placed(wide, long, block("one"), room=den).best.unplaced}
    assert unplaced["wide"].endswith(f"; wide 4.00 x 2.00 m is larger than the room, {sides[0] - 0.1:.2f} x {sides[1] - 0.1:.2f} m clear")
    assert has_form(unplaced["wide"])
    assert "larger" not in unplaced.get("long", "")


def test_a_hard_relation_that_cannot_be_held_leaves_its_piece_out() -> None:
    answer = placed(block("tall", rule("at_window", required=True), size=(0.6, 0.4, 2.0)), block("box"))
    assert [entry.id for entry in answer.best.unplaced] == ["tall"]
    assert [conflict.ids for conflict in answer.conflicts] == [("tall",)]
    assert errors(answer) == []


def test_a_hard_relation_to_what_the_room_lacks_leaves_its_piece_out() -> None:
    answer = placed(block("box", rule("at_window", required=True)), room=replace(ROOM, openings=(DOOR,)))
    assert [entry.id for entry in answer.best.unplaced] == ["box"]
    assert [conflict.ids for conflict in answer.conflicts] == [("box",)]


def test_an_optional_piece_gives_way() -> None:
    answer = placed(block("one", size=(3.0, 2.4, 0.5), required=False), block("two", size=(3.0, 2.4, 0.5)))
    assert [entry.id for entry in answer.best.unplaced] == ["one"]
    assert answer.conflicts == ()


def test_a_required_piece_may_stand_at_an_optional_one() -> None:
    answer = placed(wish("desk", rule("around", "chair")), block("chair", size=(1.0, 1.0, 1.0), required=False))
    assert {body(answer, "desk").name, body(answer, "chair").name} == {"desk", "chair"}
    assert errors(answer) == []


@pytest.mark.parametrize("relation", ["near", "facing", "aligned_with"])
def test_a_required_piece_may_refer_to_optional_ones(relation: str) -> None:
    chairs = block("chair", size=(0.6, 0.6, 0.8), count=3, required=False)
    shelves = [block(f"shelf_{k}", rule(relation, "chair"), size=(0.8, 0.3, 1.6), required=True) for k in range(2)]
    answer = placed(chairs, *shelves, alternatives=2)
    assert errors(answer) == []
    assert len(answer.best.scene.rooms[0].furniture) == 5
    assert [one.held for one in answer.best.relations] == [True, True]


def test_alternatives_differ_truly_and_are_ranked() -> None:
    answer = placed(wish("sofa", rule("against_wall")), wish("bookshelf"), block("box", rule("in_corner")), alternatives=5)
    every = [answer.best, *answer.alternatives]
    assert len(every) == 5
    assert [one.cost for one in every] == sorted(one.cost for one in every)
    poses = [{p.id: (p.rotation, p.wall, p.x, p.z) for p in one.scene.rooms[0].furniture} for one in every]
    for k, one in enumerate(poses):
        for other in poses[:k]:
            assert any(
                one[name][:2] != other[name][:2] or max(abs(one[name][2] - other[name][2]), abs(one[name][3] - other[name][3])) > 0.5
                for name in one
            )
    for answer_of in every:
        assert [issue for issue in validate(answer_of.scene, CATALOGS) if issue.severity == "error"] == []
        assert len(answer_of.relations) == 2


def test_the_same_request_gives_the_same_scene() -> None:
    wishes = [wish("bed", rule("centred")), wish("desk", rule("at_window")), block("box", rule("beside", "desk"))]
    assert placed(*wishes).best == placed(*wishes).best


@pytest.mark.parametrize(
    ("wishes", "more", "field"),
    [
        ([block("a"), block("a")], {}, "pieces[1].id"),
        ([block("a", rule("near", "b"))], {}, "pieces[0].relations[0].of"),
        ([block("a", rule("near"))], {}, "pieces[0].relations[0].of"),
        ([block("a", rule("in_corner", "b")), block("b")], {}, "pieces[0].relations[0].of"),
        ([block("a", rule("on", "a"))], {}, "pieces[0].relations[0].of"),
        ([block("door")], {}, "pieces[0].id"),
        ([wish("gizmo")], {}, "pieces[0].width"),
        ([block("a", size=(0.5, 0.0, 1.0))], {}, "pieces[0].depth"),
        ([block("a", count=0)], {}, "pieces[0].count"),
        ([block("a", count=40), block("b", count=40)], {}, "pieces"),
        ([block("a")], {"alternatives": 17}, "alternatives"),
    ],
)
def test_bad_requests_name_the_field(wishes: list[PieceRequest], more: dict[str, Any], field: str) -> None:
    with pytest.raises(RequestError) as caught:
        placed(*wishes, **more)
    assert caught.value.field == field
    assert caught.value.allowed


@pytest.mark.parametrize(
    ("x", "z", "rotation", "holds"),
    [
        (2.0, 1.38, 0, True),
        (2.0, 1.5, 0, True),
        (2.0, 2.62, 0, False),
        (2.0, 1.38, 180, False),
        (2.9, 2.0, 270, True),
        (2.9, 2.0, 90, False),
    ],
)
def test_around_means_at_a_side_and_turned_to_it(x: float, z: float, rotation: int, holds: bool) -> None:
    """A table of 1.4 x 0.8 m about (2, 2), a box of 0.4 m: from its north, tucked a little, from its south with its back, ..."""
    table = Furniture("table", "table", x=2.0, z=2.0, width=1.4, depth=0.8, height=0.75, rotation=0)
    box = Furniture("box", "box", x=x, z=z, width=0.4, depth=0.4, height=0.5, rotation=rotation)
    room = finished(replace(ROOM, furniture=(table, box)), {"table": ("table",), "box": ("box",)})
    assert held(room, "box", rule("around", "table")) == (holds, "table")


@pytest.mark.parametrize(("width", "depth"), [(3.0, 1.5), (1.5, 3.0), (3.0, 0.05), (3.0, 5e-324), (5e-324, 5e-324)])
@pytest.mark.parametrize("thickness", [0.0, 0.1])
def test_nothing_is_placed_beyond_the_walls_of_a_room_that_is_too_small(width: float, depth: float, thickness: float) -> None:
    wanted = [PieceRequest("bed", "bed"), PieceRequest("table", "coffee_table")]
    answer = place(Room("r", width=width, depth=depth), wanted, wall_thickness=thickness)
    there = [piece.id for piece in answer.best.scene.rooms[0].furniture]
    assert there == (["table"] if min(width, depth) > 1 else [])
    assert {one.id for one in answer.best.unplaced} == {"bed", "table"} - set(there)
    assert {label for conflict in answer.conflicts for label in conflict.ids} == {"bed", "table"} - set(there)
    assert {issue.rule for issue in answer.best.issues} <= {"unreachable"}


def test_a_thing_on_the_floor_that_is_in_the_way_is_named_with_its_size() -> None:
    spots = [(0.5 + 0.85 * (k % 5), 0.5 + 0.8 * (k // 5)) for k in range(25)]
    plant = Decoration("plant", "plant", None, None, x=0.0, y=0.0, z=0.0, width=0.4, depth=0.4, height=1.0)
    things = tuple(replace(plant, id=f"plant_{k}", x=x, z=z) for k, (x, z) in enumerate(spots))
    answer = place(replace(ROOM, decorations=things), [block("piano", size=(1.6, 0.7, 1.2))])
    said = " ".join(conflict.message for conflict in answer.conflicts)
    assert answer.conflicts
    assert "0.40 x 0.40 m" in said or "plant" not in said


def test_a_room_that_is_said_to_be_low_takes_nothing_higher() -> None:
    """The room's height is judged with what stands there already, and written into the answer."""
    low = placed(wish("wardrobe"), block("rack", size=(0.5, 0.5, 2.1)), height=2.1)
    assert low.best.scene.levels == (Level(0, 0.0, 2.1),) and low.best.unplaced == ()
    assert errors(low) == []
    assert placed(wish("wardrobe")).best.scene.levels == ()
    with pytest.raises(RequestError) as refused:
        placed(wish("bed"), wish("wardrobe"), block("rack", size=(0.5, 0.5, 2.0)), height=1.9)
    told = [(refused.value.field, refused.value.problem), *((field, problem) for field, problem, _ in refused.value.more)]
    high = "is {} m, and the room 1.90 m high"
    assert told == [("pieces[1].height", high.format("2.10")), ("pieces[2].height", high.format("2.00"))]
    stands = replace(ROOM, furniture=(Furniture("old", "rack", x=2.2, z=0.5, width=0.5, depth=0.5, height=2.0),))
    assert any("ceiling" in message for message in errors(placed(wish("desk"), room=stands, height=1.9)))
    assert placed(wish("wardrobe"), room=replace(ROOM, outdoor=True), height=1.9).best.unplaced == ()


def test_nothing_is_put_on_what_is_too_near_the_ceiling() -> None:
    """It is on the first of two where that may be, in a lower room on the lower one; where only the high one is named, on none."""
    pieces = (block("high", size=(0.8, 0.5, 1.2)), block("low", size=(0.8, 0.5, 0.6)))
    upon = block("crate", RelationSpec(type="on", of=("high", "low")), size=(0.4, 0.4, 0.5))
    for height, bottom in ((None, 1.2), (1.7, 1.2), (1.69, 0.6)):
        made = placed(*pieces, upon, height=height)
        assert [piece.y for piece in made.best.scene.rooms[0].furniture if piece.id == "crate"] == [bottom]
        assert errors(made) == []
    with_high = placed(pieces[0], block("crate", rule("on", "high"), size=(0.4, 0.4, 0.5)), height=1.6)
    assert [piece.y for piece in with_high.best.scene.rooms[0].furniture if piece.id == "crate"] in ([], [0.0])
    assert errors(with_high) == []


@pytest.mark.parametrize("required", [True, False])
def test_to_keep_far_from_what_has_no_place_is_held(required: bool) -> None:
    """Neither a pool that is larger than the room, nor what may only stand at it, keeps a desk from standing."""
    pool = block("pool", size=(5.0, 5.0, 0.5), required=False)
    deck = block("deck", rule("on", "pool", required=True), size=(0.4, 0.4, 0.4), required=False)
    for other in ("pool", "deck"):
        made = placed(wish("desk", rule("far_from", other, required=required)), pool, deck)
        assert [one.held for one in made.best.relations if one.piece == "desk"] == [True]
        assert {one.id for one in made.best.unplaced} == {"pool", "deck"}
        assert made.conflicts == ()


@pytest.mark.parametrize("required", [True, False])
@pytest.mark.parametrize("distance", [1.0, 2.6])
def test_to_keep_far_from_what_is_crowded_out_is_held(distance: float, required: bool) -> None:
    """A crate for which a slab leaves no place neither keeps the lamp from standing nor, for its sake, takes the place of the slab."""
    slab, crate = block("slab", size=(2.6, 1.4, 0.5)), block("crate", size=(2.0, 1.0, 0.6), required=False)
    lamp = block("lamp", rule("far_from", "crate", required=True, distance=distance), size=(0.3, 0.3, 0.5), required=required)
    for order in ((slab, crate, lamp), (slab, lamp, crate)):
        made = placed(*order, room=Room("den", width=3.1, depth=2.7))
        assert [one.id for one in made.best.unplaced] == ["crate"]
        assert [one.held for one in made.best.relations] == [True]
        assert (errors(made), made.conflicts) == ([], ())
