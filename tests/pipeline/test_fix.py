"""fix(): least movement, locks, conflicts; judged by the validator, which shares no code with the solver."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from compose_homes import dump, furnish
from solver import Request, Scene, explain, export, fix, fix_frame, generate, reroll, validate
from solver.errors import SceneError
from solver.exchange import dump_text, write_scene
from solver.scene import Decoration, Level, Opening, Room, Size
from solver.streams import Stream
from tests.pipeline.fix_rooms import body, errors, pieces, room_of


def stirred(scene: Scene, seed: int, share: float = 0.5) -> Scene:
    """Moves a share of the pieces by up to 0.6 m and turns a few by odd angles."""
    stream = Stream(seed, "stir")
    rooms = []
    for room in scene.rooms:
        moved = []
        for piece in room.furniture:
            if piece.on is None and stream.chance(share):
                dx, dz = round(stream.uniform(-0.6, 0.6), 3), round(stream.uniform(-0.6, 0.6), 3)
                turn = round(stream.uniform(-30, 30), 1) if stream.chance(0.2) else 0
                x, z = round(piece.x + dx, 4), round(piece.z + dz, 4)
                moved.append(replace(piece, x=x, z=z, rotation=(piece.rotation + turn) % 360))
            else:
                moved.append(piece)
        rooms.append(replace(room, furniture=tuple(moved)))
    return replace(scene, rooms=tuple(rooms))


@pytest.mark.parametrize("seed", range(4))
def test_a_clean_scene_comes_back_identical(seed: int) -> None:
    scene = generate(Request(seed=seed)).scene
    fixed = fix(scene)
    assert fixed.scene == scene
    assert fixed.moves == ()
    assert dump_text(write_scene(fixed.scene), "json") == dump_text(write_scene(scene), "json")


@pytest.mark.parametrize("seed", range(8))
def test_a_stirred_house_is_repaired_or_the_reason_given(seed: int) -> None:
    scene = stirred(generate(Request(seed=seed, width=12, depth=9)).scene, seed)
    assert errors(scene)
    fixed = fix(scene)
    named = {member for conflict in fixed.conflicts for member in conflict.ids}
    for issue in fixed.issues:
        told = named & set(issue.ids) or (not issue.ids and fixed.conflicts)
        assert issue.severity == "warning" or told, issue.message
    again = fix(fixed.scene)
    assert again.scene == fixed.scene
    assert again.moves == ()


def test_least_movement_of_two_overlapping_pieces() -> None:
    scene = room_of(body("a_1", 1.5, 2.0, (1.0, 1.0, 1.0)), body("b_1", 2.3, 2.0, (1.0, 1.0, 1.0)))
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert {move.id: (move.dx, move.dz) for move in fixed.moves} == {
        "room_0/a_1": (pytest.approx(-0.1, abs=1e-3), 0.0),
        "room_0/b_1": (pytest.approx(0.1, abs=1e-3), 0.0),
    }


def test_what_the_user_moved_stays_and_the_other_gives_way() -> None:
    scene = room_of(body("a_1", 1.5, 2.0, (1.0, 1.0, 1.0)), body("b_1", 2.3, 2.0, (1.0, 1.0, 1.0)))
    moves = {move.id: move.dx for move in fix(scene, moved=["room_0/a_1"]).moves}
    assert abs(moves.get("room_0/a_1", 0.0)) < 0.02
    assert moves["room_0/b_1"] > 0.18


@pytest.mark.parametrize("by_flag", [True, False])
def test_locked_pieces_stay_to_the_millimetre(by_flag: bool) -> None:
    still = body("a_1", 1.5005, 2.0, (1.001, 1.0, 1.0), locked=by_flag)
    scene = room_of(still, body("b_1", 2.3, 2.0, (1.0, 1.0, 1.0)))
    fixed = fix(scene, locked=() if by_flag else ["room_0/a_1"])
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene)["room_0/a_1"] == still


def test_a_locked_piece_at_an_odd_angle_keeps_it() -> None:
    still = replace(body("a_1", 2.0, 2.0, (1.0, 1.0, 1.0)), rotation=30.0, locked=True)
    fixed = fix(room_of(still, body("b_1", 2.9, 2.0, (1.0, 1.0, 1.0))))
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene)["room_0/a_1"] == still


def test_odd_angles_are_squared_up() -> None:
    askew = replace(body("a_1", 0.4, 2.0, (1.0, 0.5, 1.0)), rotation=97.5)
    fixed = fix(room_of(askew, body("b_1", 2.0, 2.0, (3.0, 1.0, 1.0))))
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene)["room_0/a_1"].rotation == 90


def test_a_piece_at_a_wall_that_cannot_hold_it_goes_to_another() -> None:
    shelf = body("shelf_1", 2.0, 0.2, (2.0, 0.4, 2.0), wall="north")
    locked = body("chest_1", 2.0, 0.6, (3.9, 1.0, 1.0), locked=True)
    fixed = fix(room_of(shelf, locked))
    assert errors(fixed.scene) == []
    assert pieces(fixed.scene)["room_0/shelf_1"].wall in ("east", "west", "south")


def test_things_follow_what_carries_them() -> None:
    table = body("table_1", 2.0, 2.0, (1.0, 1.0, 0.7))
    lamp = replace(body("lamp_1", 2.3, 1.8, (0.2, 0.2, 0.4)), y=0.7, on="room_0/table_1")
    vase = Decoration("room_0/vase_1", "vase", "room_0/table_1", None, 1.8, 0.7, 2.2, 15.0, 0.1, 0.1, 0.3)
    locked = body("chest_1", 2.2, 2.0, (1.0, 1.0, 1.0), locked=True)
    fixed = fix(room_of(table, lamp, locked, decorations=(vase,)))
    assert errors(fixed.scene) == []
    moved = pieces(fixed.scene)
    dx = moved["room_0/table_1"].x - table.x
    dz = moved["room_0/table_1"].z - table.z
    assert (dx, dz) != (0, 0)
    assert moved["room_0/lamp_1"].x == pytest.approx(2.3 + dx)
    carried = fixed.scene.rooms[0].decorations[0]
    assert (carried.x, carried.z) == (pytest.approx(1.8 + dx), pytest.approx(2.2 + dz))


def test_what_hangs_over_a_piece_goes_to_its_new_wall_with_it() -> None:
    shelf = body("shelf_1", 2.0, 0.2, (2.0, 0.4, 1.0), wall="north")
    art = Decoration("room_0/art_1", "art", "room_0/shelf_1", "north", 2.0, 1.5, 0.02, 0, 0.6, 0.04, 0.5)
    locked = body("chest_1", 2.0, 0.6, (3.9, 1.0, 1.0), locked=True)
    fixed = fix(room_of(shelf, locked, decorations=(art,)))
    moved, hung = pieces(fixed.scene)["room_0/shelf_1"], fixed.scene.rooms[0].decorations[0]
    assert hung.mounted_on_wall == moved.wall != "north"
    assert hung.rotation == moved.rotation
    aside, away = sorted((abs(hung.x - moved.x), abs(hung.z - moved.z)))
    assert aside == 0 and away < 0.5
    assert [issue for issue in fixed.issues if "room_0/art_1" in issue.ids] == []


def too_much() -> Scene:
    return room_of(
        body("bed_1", 1.0, 1.0, (1.8, 1.8, 0.5)),
        body("wardrobe_1", 1.0, 1.5, (1.9, 0.6, 2.0)),
        body("stool_1", 1.8, 1.8, (0.3, 0.2, 0.4)),
        width=2.0,
        depth=2.0,
    )


def test_an_impossible_room_names_a_minimal_conflict_and_keeps_the_pieces() -> None:
    fixed = fix(too_much())
    assert [set(conflict.ids) for conflict in fixed.conflicts] == [{"room_0/bed_1"}]  # beside it nobody can walk, whatever else goes
    assert {repair["id"] for repair in fixed.conflicts[0].repairs} == {"room_0/bed_1"}
    assert len(pieces(fixed.scene)) == 3
    assert fix(fixed.scene).scene == fixed.scene


@pytest.mark.usefixtures("geometry_alone")
def test_with_remove_the_least_important_goes_and_the_room_is_clean() -> None:
    fixed = fix(too_much(), on_conflict="remove")
    assert [removal["id"] for removal in fixed.removed] == ["room_0/wardrobe_1"]
    assert "cannot stand together" in fixed.removed[0]["reason"]
    assert errors(fixed.scene) == []
    assert set(pieces(fixed.scene)) == {"room_0/bed_1", "room_0/stool_1"}


def test_a_piece_is_taken_out_of_a_doorway_and_from_a_window() -> None:
    openings = (
        Opening("d", "door", "south", 2.0, connects_to="EXTERIOR", main_entrance=True),
        Opening("w", "window", "north", 2.0, 1.2, 1.4, 0.9, "EXTERIOR"),
    )
    wardrobe, box = body("wardrobe_1", 2.0, 0.3, (1.0, 0.6, 2.0)), body("box_1", 2.0, 3.5, (0.5, 0.5, 0.5))
    fixed = fix(room_of(wardrobe, box, openings=openings))
    assert errors(fixed.scene) == []
    assert len(fixed.moves) == 2


@pytest.mark.parametrize("field", ["locked", "moved"])
def test_an_unknown_id_is_refused_by_name(field: str) -> None:
    with pytest.raises(SceneError, match=rf"{field}\[0\].*nothing in the scene has the id 'ghost'"):
        fix(room_of(), **{field: ["ghost"]})  # type: ignore[arg-type]
    with pytest.raises(SceneError, match=rf"^{field}: is 'ghost' \(allowed: a list\)"):
        fix(room_of(), **{field: "ghost"})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("field", "given", "words"),
    [
        ("moved", None, r"moved: is null \(allowed: a list\)"),
        ("locked", 3, r"locked: is 3 \(allowed: a list\)"),
        ("moved", [3], r"moved\[0\]: is 3 \(allowed: a text\)"),
        ("previous", "x", r"previous: is 'x' \(allowed: a list\)"),
        ("previous", [3], r"previous\[0\]: is 3 \(allowed: a Pose\)"),
    ],
)
def test_what_is_no_list_of_such_things_is_refused(field: str, given: Any, words: str) -> None:
    for flow in (fix, fix_frame):
        with pytest.raises(SceneError, match=rf"^{words}"):
            flow(room_of(), **{"moved": [], field: given})


def test_an_unknown_id_is_told_the_likeliest_first() -> None:
    """Of a home's hundreds only some are named: the one of another room, then those of the room meant."""
    names = [f"kitchen_1/chair_{k}" for k in range(20)] + ["den_2/lamp_1", "hall_3/sofa_1"]
    known = [replace(body(name, 1.0, 1.0, (0.3, 0.3, 0.5)), id=name) for name in names]
    with pytest.raises(SceneError) as refused:
        fix(room_of(*known), moved=["den_2/sofa_1"])
    assert (refused.value.allowed or "").startswith("one of hall_3/sofa_1, den_2/lamp_1, kitchen_1/chair_0, ")


@pytest.mark.parametrize("given", ["x", None, {"rooms": []}, Room("den", width=3, depth=3)], ids=["text", "null", "mapping", "room"])
def test_what_is_no_scene_is_refused(given: Any) -> None:
    for flow in (fix, validate, furnish, dump, lambda scene: export(scene, "glb")):
        with pytest.raises(SceneError, match=r"^scene: is .*\(allowed: a Scene"):
            flow(given)


def changed(scene: Scene, field: str, value: Any) -> Scene:
    """A scene with one field of its size, its first storey, its only room, or of that room's first opening or piece, changed."""
    if field.startswith("size."):
        return replace(scene, size=replace(scene.size or Size(4.0, 4.0), **{field[5:]: value}))
    *path, key = field.replace("[0]", "").split(".")
    wrong: dict[str, Any] = {key: value}
    for depth in range(len(path), 0, -1):
        owner: Any = scene
        for name in path[:depth]:
            owner = getattr(owner, name)[0]
        wrong = {path[depth - 1]: (replace(owner, **wrong),)}
    return replace(scene, **wrong)


@pytest.mark.parametrize("given", [float("nan"), float("inf"), 1e308, 10**310, 0, -2.0, 1001.0, "1.0", None], ids=str)
def test_numbers_that_readers_refuse_are_refused_by_the_same_words(given: Any) -> None:
    door = Opening("door", wall="south", position=1.0, connects_to="EXTERIOR")
    sound = room_of(body("sofa", 1.5, 1.5, (2.0, 0.9, 0.8)), openings=(door,))
    flows = (fix, validate, furnish, dump, lambda one: reroll(one, ["room_0"]), lambda one: explain(one, "room_0/sofa"))
    sound = replace(sound, size=Size(4.0, 4.0), levels=(Level(),))
    sizes = [*(f"rooms[0].{of}" for of in ("width", "openings[0].height", "furniture[0].depth")), "levels[0].height", "size.height"]
    places = [*(f"rooms[0].{of}" for of in ("z", "openings[0].position", "furniture[0].x")), "levels[0].elevation"]
    allowed = dict.fromkeys(sizes, "a number above 0, up to 1000") | dict.fromkeys(places, "a number from -1000000 to 1000000")
    allowed["wall_thickness"] = "a number from 0 to 1"
    for field, words in allowed.items():
        wrong = changed(sound, field, given)
        if given in ((0, -2.0, 1001.0) if field in places else (0,) if field == "wall_thickness" else ()):
            assert validate(wrong) is not None
            continue
        for flow in (*flows, lambda one: export(one, "glb")):
            with pytest.raises(SceneError) as refused:
                flow(wrong)
            assert (refused.value.field, refused.value.allowed) == (field, words)


def test_two_bodies_of_one_id_are_refused() -> None:
    chair = body("chair", 1.0, 1.0, (0.5, 0.5, 0.9))
    with pytest.raises(SceneError, match=r"^scene: 'room_0/chair' is given twice"):
        fix(room_of(chair, replace(chair, x=3.0)))
