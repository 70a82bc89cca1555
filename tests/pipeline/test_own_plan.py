"""furnish() of somebody's own plan: its empty rooms are furnished and clean, the rest stays, what was guessed is said."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from solver import generate, reroll, validate
from solver.errors import RequestError, SceneError
from solver.pipeline.insisted import insisted_in
from solver.pipeline.own_plan import furnish
from solver.request import Request
from solver.scene import Furniture, Opening, Room, Scene
from solver.version import VERSION
from tests.guessing.plans import as_plan
from tests.sweeps import seeds

KNOWN = load_catalogs()
DOOR = Opening("door", wall="south", position=3.2, connects_to="EXTERIOR")
BEDROOM = Room("a", type="Schlafzimmer", width=4.0, depth=3.5, openings=(DOOR,))
BED = Furniture("mine", "bed", x=1.6, z=1.03, width=1.6, depth=2.0, height=0.9, wall="north")


def left_out(home: Scene, room: str) -> set[str]:
    rooms: Any = (home.certificate or {})["rooms"]
    return {one["piece"] for one in rooms[room]["left_out"]}


@pytest.mark.parametrize("seed", seeds(range(6), 3))
def test_an_empty_home_is_furnished_as_a_generated_one_is(seed: int) -> None:
    home = generate(Request(seed=seed, program="family", style="modern")).scene
    bare = tuple(replace(room, furniture=(), decorations=()) for room in home.rooms)
    made = furnish(replace(home, rooms=bare, dynamic=(), certificate=None))
    assert (made.guesses, made.entrance, made.left) == ((), None, {})
    again = reroll(home, [room.id for room in home.rooms]).scene
    insisted = {room.id: label for room in home.rooms if (label := insisted_in(made.scene.certificate, room.id))}
    assert len(insisted) < len(home.rooms) / 2
    for room, like in zip(made.scene.rooms, again.rooms, strict=True):
        assert room.furniture == like.furniture or room.id in insisted
    for name, label in insisted.items():
        assert label in left_out(again, name)
        assert label not in left_out(made.scene, name)
    assert [issue.message for issue in made.issues if issue.severity == "error" or issue.rule == "missing_required"] == []


@pytest.mark.parametrize("seed", seeds(range(6), 3))
def test_a_plan_without_types_becomes_a_clean_home(seed: int) -> None:
    plan = as_plan(generate(Request(seed=seed, program="one_bed")).scene)
    made = furnish(plan, seed=seed, decorate=True)
    assert len(made.guesses) == len(plan.rooms)
    assert [issue.message for issue in made.issues if issue.severity == "error"] == []
    assert all(room.furniture for room in made.scene.rooms if room.type in ("bedroom", "kitchen", "living_room", "bathroom"))
    assert any(room.decorations for room in made.scene.rooms)
    assert made.scene.seed == seed
    assert validate(made.scene, KNOWN) == made.issues
    assert furnish(plan, seed=seed, decorate=True) == made


def test_rooms_with_furniture_keep_it() -> None:
    plan = Scene(rooms=(replace(BEDROOM, furniture=(BED,)), replace(BEDROOM, id="b", x=4.0, openings=(replace(DOOR, id="other"),))))
    made = furnish(plan, seed=1)
    assert made.scene.rooms[0].furniture == (BED,)
    assert len(made.scene.rooms[1].furniture) > 3


def test_a_named_room_is_furnished_around_what_stands_there() -> None:
    made = furnish(Scene(rooms=(replace(BEDROOM, furniture=(BED,)),)), ["a"], seed=1)
    (room,) = made.scene.rooms
    assert room.furniture[0] == BED
    assert [piece.name for piece in room.furniture].count("bed") == 1
    assert {"wardrobe", "nightstand"} <= {piece.name for piece in room.furniture}
    assert made.left == {}


@pytest.mark.parametrize(("keep", "stays"), [("locked", ["mine"]), ("none", [])])
def test_what_stays_is_said_by_keep(keep: str, stays: list[str]) -> None:
    shelf = Furniture("shelf", "bookshelf", x=0.5, z=3.3, rotation=180, width=0.8, depth=0.3, height=1.8)
    plan = Scene(rooms=(replace(BEDROOM, furniture=(replace(BED, locked=True), shelf)),))
    (room,) = furnish(plan, keep=keep, seed=3).scene.rooms
    assert [piece.id for piece in room.furniture if piece.id in ("mine", "shelf")] == stays
    assert [piece.name for piece in room.furniture].count("bed") == 1


def test_a_room_that_cannot_be_furnished_around_what_stays_is_left_and_named() -> None:
    blocking = replace(BED, z=2.4, x=3.0, locked=True, rotation=0, wall=None, height=2.0)
    plan = Scene(rooms=(replace(BEDROOM, furniture=(blocking, replace(blocking, id="other", x=1.0))), replace(BEDROOM, id="b", x=9.0)))
    made = furnish(plan, keep="locked", seed=2)
    assert set(made.left) <= {"a"}
    if made.left:
        assert made.scene.rooms[0].furniture == plan.rooms[0].furniture
    assert made.scene.rooms[1].furniture


def test_a_room_that_no_furniture_is_known_for_is_named_and_its_certificate_says_so() -> None:
    cellar = Room("k", type="room", x=9.0, width=4.0, depth=4.0, openings=(DOOR,), name="Keller")
    made = furnish(Scene(rooms=(BEDROOM, cellar)), seed=1)
    said = "there is no furniture for what is called 'Keller': say which type the room has, if it has one"
    assert made.left == {"k": said}
    rooms: Any = (made.scene.certificate or {})["rooms"]
    assert {name: entry["notes"] for name, entry in rooms.items()} == {"a": [], "k": [said]}
    again = furnish(made.scene, types={"k": "workshop"}, seed=1)
    rooms = (again.scene.certificate or {})["rooms"]
    assert (again.left, rooms["k"]["notes"]) == ({}, [])


def test_rooms_that_share_floor_are_left_and_named() -> None:
    rooms = (BEDROOM, replace(BEDROOM, id="b", x=3.5), replace(BEDROOM, id="c", x=7.5), replace(BEDROOM, id="upstairs", level=1))
    made = furnish(Scene(rooms=rooms), seed=1)
    words = "shares floor with {}: what stands in one would stand in the other"
    assert made.left == {"a": words.format("b"), "b": words.format("a")}
    assert [bool(room.furniture) for room in made.scene.rooms] == [False, False, True, True]
    moved = tuple(replace(room, x=room.x + 0.3 * (room.id in "bc")) for room in made.scene.rooms)
    apart = furnish(replace(made.scene, rooms=moved), seed=1)
    assert apart.left == {} and all(room.furniture for room in apart.scene.rooms)
    unplaced = furnish(Scene(rooms=(BEDROOM, replace(BEDROOM, id="b"))), seed=1)
    assert unplaced.left == {} and all(room.furniture for room in unplaced.scene.rooms)


@pytest.mark.parametrize(("width", "called", "thickness", "stays"), [
    (0.5, None, 0.0, True), (0.69, None, 0.1, True), (0.71, None, 0.1, False), (0.69, None, 0.0, False), (0.5, "WC", 0.1, False),
])  # fmt: skip
def test_a_shaft_is_no_bathroom(width: float, called: str | None, thickness: float, stays: bool) -> None:
    shaft = Room("s", type="room", x=4.0, width=width, depth=1.5, name=called)
    made = furnish(Scene(rooms=(BEDROOM, shaft), wall_thickness=thickness), seed=1)
    assert ("s" in made.left) == stays and ("s" in {guess.room for guess in made.guesses}) != stays
    if stays:
        assert "nobody can stand in it" in made.left["s"] and made.scene.rooms[1].furniture == ()
    beside = Furniture("shelf", "bookshelf", x=0.2, z=0.5, width=0.3, depth=0.3, height=1.0)
    kept = furnish(Scene(rooms=(BEDROOM, replace(shaft, furniture=(beside,))), wall_thickness=thickness), seed=1)
    assert kept.left == {}


def test_a_home_says_what_it_was_furnished_as_and_by_what_unless_it_said_so() -> None:
    kitchen = Room("k", type="kitchen", x=5.0, width=3.0, depth=3.5, openings=(replace(DOOR, id="k_door", position=1.5),))
    bathroom = Room("c", type="bathroom", x=9.0, width=2.5, depth=3.0, openings=(replace(DOOR, id="c_door", position=1.2),))
    ours = {"version": VERSION, "catalog": KNOWN.fingerprint}
    home = furnish(Scene(rooms=(BEDROOM, kitchen, bathroom)), style="modern", seed=5).scene
    assert (home.seed, home.generator) == (5, ours)
    assert home.request == {"program": {"bathrooms": 1, "bedrooms": 1, "kitchen": 1}, "style": "modern"}
    for rooms in ((BEDROOM,), (BEDROOM, kitchen)):
        assert furnish(Scene(rooms=rooms), style="modern", seed=5).scene.request == {"style": "modern"}, "no home"
    theirs = {"version": "0.1.0", "catalog": "of others"}
    again = furnish(Scene(rooms=(kitchen, bathroom), seed=3, generator=theirs, request={"style": "rustic"}), seed=5).scene
    assert (again.seed, again.generator, again.request) == (3, theirs, {"style": "rustic"})


def test_a_told_type_wins_over_name_and_guess() -> None:
    made = furnish(Scene(rooms=(BEDROOM,)), types={"a": "office"}, seed=1)
    assert made.guesses == ()
    assert "desk" in {piece.name for piece in made.scene.rooms[0].furniture}


@pytest.mark.parametrize(
    ("room_type", "name", "outdoor", "told", "lies"),
    [
        ("room", "Garten", False, {}, True),
        ("room", None, False, {"plot": "backyard"}, True),
        ("patio", None, False, {}, True),
        ("room", "Garten", True, {"plot": "office"}, False),
        ("office", None, True, {}, True),
    ],
)
def test_a_room_lies_outdoors_by_its_type(room_type: str, name: str | None, outdoor: bool, told: dict[str, str], lies: bool) -> None:
    """What the call tells counts before the scene, and that before what its other rooms are guessed by."""
    plot = Room("plot", type=room_type, name=name, width=2.5, depth=2.5, outdoor=outdoor)
    rooms = (plot, Room("inside", type="office", x=5.0, width=2.5, depth=2.5))
    assert [room.outdoor for room in furnish(Scene(rooms=rooms), types=told).scene.rooms] == [lies, False]


def test_foreign_names_stay_foreign() -> None:
    piece = replace(BED, name="Doppelbett")
    (room,) = furnish(Scene(rooms=(replace(BEDROOM, type="", furniture=(piece,)),)), ["a"], seed=1).scene.rooms
    assert room.type.startswith("bedroom")
    assert replace(room.furniture[0], color=None) == piece


@pytest.mark.parametrize(
    ("asked", "error", "words"),
    [
        ({"rooms": ["x"]}, SceneError, r"rooms\[0\]"),
        ({"types": {"a": "castle"}}, RequestError, r"types\.a.*castle"),
        ({"types": {"x": "office"}}, SceneError, r"types\.x: nothing"),
        ({"keep": "some"}, RequestError, "keep"),
        ({"program": "castle"}, RequestError, "castle"),
        ({"style": "castle"}, RequestError, "castle"),
    ],
)
def test_what_is_wrong_is_refused(asked: dict[str, object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        furnish(Scene(rooms=(BEDROOM,)), **asked)  # type: ignore[arg-type]


def test_a_door_that_only_one_room_lists_stays_free_on_both_sides() -> None:
    """The rooms of a plan list each door once, in the room where it was drawn."""
    door = Opening("inner", wall="east", position=1.7, connects_to="b")
    for seed in range(8):
        rooms = (replace(BEDROOM, openings=(DOOR, door)), Room("b", type="office", x=4.0, width=3.0, depth=3.5))
        made = furnish(Scene(wall_thickness=0.1, rooms=rooms), seed=seed)
        assert [issue.message for issue in made.issues if issue.severity == "error"] == []
        assert all(room.furniture for room in made.scene.rooms)


def test_what_stays_and_has_no_colour_gets_one_of_the_style() -> None:
    bed = replace(BED, kind="bed")
    desk = Furniture("desk", "desk", x=3.3, z=1.2, rotation=270, width=1.2, depth=0.6, height=0.75, kind="desk", color="#ff00ff")
    strange = Furniture("strange", "gizmo", x=3.5, z=3.0, width=0.4, depth=0.4, height=0.4)
    plan = Scene(rooms=(replace(BEDROOM, furniture=(bed, desk, strange)),))
    for style in ("modern", "rustic"):
        (room,) = furnish(plan, style=style, seed=1).scene.rooms
        colours = {piece.id: piece.color for piece in room.furniture}
        palettes = KNOWN.styles[style].palette
        allowed = next(palettes[key] for key in ("bed", KNOWN.furniture["bed"].category) if key in palettes)
        assert colours["mine"] in allowed
        assert (colours["desk"], colours["strange"]) == ("#ff00ff", None)
