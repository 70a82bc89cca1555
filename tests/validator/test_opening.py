"""How far fronts open: the last place that is free and the first that is not, against geometry of our own."""

from __future__ import annotations

import math
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

import pytest

from catalogs import load_catalogs
from catalogs.shapes import Solid
from solver import Request, generate
from solver.demanded import demanding_at_most
from solver.errors import TooMuch
from solver.exports import describe
from solver.scene import Decoration, Dynamic, Furniture, Level, Opening, Room, Scene
from solver.validator import validate
from solver.validator.opening import WALL, FrontTravel
from tests.exports.opening import open_all
from tests.validator.travels import front_travels

KNOWN = load_catalogs()
STEP = 0.5
"""Fronts are turned by so much at a time, degrees."""


def piece(kind: str, x: float, z: float, rotation: float = 0.0, name: str | None = None) -> Furniture:
    spec = KNOWN.furniture[kind]
    width, depth, height = spec.size
    return Furniture(name or kind, spec.name or kind, x=x, z=z, rotation=rotation, width=width, depth=depth, height=height, kind=kind)


def block(x: float, z: float, width: float, depth: float, height: float = 2.0) -> Furniture:
    return Furniture("block", "block", x=x, z=z, width=width, depth=depth, height=height)


def room(*furniture: Furniture, decorations: tuple[Decoration, ...] = (), people: tuple[Dynamic, ...] = ()) -> Scene:
    den = Room("den", 0, "den", width=8.0, depth=6.0, furniture=furniture, decorations=decorations)
    return Scene(wall_thickness=0.1, rooms=(den,), dynamic=people)


def travel(scene: Scene, front: str, name: str | None = None) -> FrontTravel:
    (found,) = [one for one in front_travels(scene, KNOWN)["den"] if one.front == front and name in (None, one.piece)]
    return found


@pytest.mark.parametrize("rotation", [0, 90, 180, 270, 33])
def test_a_piece_alone_opens_wholly(rotation: float) -> None:
    for kind in ("wardrobe", "dresser", "stove", "refrigerator", "toilet", "shoe_cabinet", "counter"):
        travels = front_travels(room(piece(kind, 4.0, 3.0, rotation)), KNOWN)["den"]
        assert len(travels) >= 1
        assert all(one.meets is None and one.travel == one.range for one in travels)


@pytest.mark.parametrize("gap", [0.03, 0.1, 0.2, 0.299])
def test_a_drawer_comes_out_as_far_as_there_is_room(gap: float) -> None:
    chest = piece("dresser", 4.0, 2.0)
    depth = chest.depth
    handle = 0.015 * depth
    before = block(4.0, 2.0 + depth / 2 + gap + 0.5, 2.0, 1.0)
    one = travel(room(chest, before), "top_drawer")
    assert one.meets == "block"
    assert 0 <= gap + handle - one.travel <= 0.0031
    assert front_travels(room(chest, block(4.0, 2.0 + depth / 2 + 0.36 + 0.5, 2.0, 1.0)), KNOWN)["den"][0].meets is None


@pytest.mark.parametrize("gap", [0.1, 0.2, 0.3])
def test_a_door_turns_as_far_as_trigonometry_says(gap: float) -> None:
    """A wall of a block parallel to a refrigerator's front: the far edge of the door's face, or its handle, meets it first."""
    fridge = piece("refrigerator", 4.0, 2.0)
    width, depth = fridge.width, fridge.depth
    one = travel(room(fridge, block(4.0, 2.0 + depth / 2 + gap + 0.5, 3.0, 1.0)), "upper_door")
    hinge = (0.995 * width, 0.955 * depth)
    reach = gap + depth - hinge[1]
    corners = [(0.005 * width, 0.955 * depth), *((x * width, 0.995 * depth) for x in (0.07, 0.1))]
    away = [(hinge[0] - x, z - hinge[1]) for x, z in corners]
    free = next(
        k * STEP for k in range(181)
        if any(x * math.sin(math.radians((k + 1) * STEP)) + z * math.cos(math.radians((k + 1) * STEP)) > reach for x, z in away)
    )  # fmt: skip
    assert one.meets == "block"
    assert abs(one.travel - free) <= 2 * STEP


def test_walls_neighbours_and_small_things_are_told_by_name() -> None:
    against = piece("wardrobe", 7.95 - 0.9, 2.0)
    assert travel(room(against), "outer_door_2").meets == WALL
    crowded = travel(room(piece("stove", 4.0, 2.0), piece("washer", 4.0, 2.75, 180)), "door", "stove")
    assert (crowded.meets, crowded.share < 0.5) == ("washer", True)
    toy = Decoration("den/toy", "toy_car", None, x=4.0, z=2.6, width=0.2, depth=0.2, height=0.2)
    assert travel(room(piece("dresser", 4.0, 2.2)), "low_drawer").meets is None
    assert travel(room(piece("dresser", 3.7, 2.2), decorations=(replace(toy, height=0.3),)), "low_drawer_2").meets == "den/toy"


def test_rugs_people_and_what_lies_on_a_lid_stop_nothing() -> None:
    chest = piece("toy_chest", 4.0, 2.0)
    rug = Decoration("den/rug", "rug", None, x=4.0, z=2.6, width=2.0, depth=1.4, height=0.01)
    bear = Decoration("den/bear", "stuffed_animal", "toy_chest", x=4.0, y=0.48, z=2.0, width=0.2, depth=0.2, height=0.3)
    person = Dynamic("p", "person", room="den", x=4.0, z=2.6, width=0.5, depth=0.3, height=1.7)
    scene = room(chest, piece("dresser", 6.0, 2.0), decorations=(rug, bear), people=(replace(person, x=6.0),))
    assert all(one.meets is None for one in front_travels(scene, KNOWN)["den"])


@pytest.mark.parametrize(("high", "meets"), [(0.03, None), (0.031, "den/rug")])
def test_what_lies_on_the_floor_and_is_no_higher_than_3_cm_is_opened_over(high: float, meets: str | None) -> None:
    low = replace(piece("dresser", 4.0, 2.0), height=0.1)
    rug = Decoration("den/rug", "rug", None, x=4.0, z=2.9, width=2.0, depth=1.2, height=high)
    assert travel(room(low, decorations=(rug,)), "low_drawer").meets == meets


def test_a_long_drawer_meets_what_is_far() -> None:
    far = block(4.0, 2.0 + 2.0 + 1.2 + 0.5, 2.0, 1.0)
    one = travel(room(replace(piece("dresser", 4.0, 2.0), depth=4.0), far), "top_drawer")
    assert (one.meets, one.travel) == ("block", pytest.approx(1.2, abs=0.07))


@pytest.mark.parametrize("high", [2.5, 3.4])
def test_walls_stop_fronts_up_to_the_ceiling(high: float) -> None:
    cupboard = replace(piece("wardrobe", 7.95 - 0.9, 2.0), y=high - 0.05, height=0.05)
    hall = room(cupboard)
    assert travel(replace(hall, levels=(Level(0, height=high),)), "outer_door_2").meets == WALL


def test_less_than_half_is_a_warning_with_both_names() -> None:
    stove = piece("stove", 4.0, 2.0)
    close = room(stove, block(4.0, 2.3 + 0.25 + 0.5, 2.0, 1.0))
    (found,) = [issue for issue in validate(close, KNOWN) if issue.rule == "front_blocked"]
    assert (found.severity, found.ids) == ("warning", ("stove", "block"))
    assert "degrees: then it meets block" in found.message
    assert travel(close, "door").share < 0.5
    roomy = room(stove, block(4.0, 2.3 + 0.62 + 0.5, 2.0, 1.0))
    assert not [issue for issue in validate(roomy, KNOWN) if issue.rule == "front_blocked"]


def test_a_piece_is_said_once_with_all_that_its_fronts_meet() -> None:
    """Each half of a dresser's drawers meets a block of its own; the right one stands nearer."""
    front = 2.0 + KNOWN.furniture["dresser"].size[1] / 2
    left = replace(block(3.6, front + 0.55, 0.4, 1.0), id="far")
    right = replace(block(4.4, front + 0.52, 0.4, 1.0), id="near")
    scene = room(piece("dresser", 4.0, 2.0), left, right)
    (found,) = [issue for issue in validate(scene, KNOWN) if issue.rule == "front_blocked"]
    blocked = [one for one in front_travels(scene, KNOWN)["den"] if one.share < 0.5]
    least = min(blocked, key=lambda one: one.share)
    assert len(blocked) == 6
    assert (least.meets, set(found.ids)) == ("near", {"dresser", "far", "near"})
    words = (
        f"{len(blocked)} fronts of dresser open less than half, the {least.front} {least.travel * 100:.0f} of {least.range * 100:.0f} cm"
    )
    assert found.message == f"{words}: then it meets near"


def test_what_must_open_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "shapes").mkdir()
    (tmp_path / "shapes" / "own.yaml").write_text(
        "stove:\n  - {form: box, y: [0, top], z: [0, 0.9]}\n"
        "  - {form: box, y: [0.1, 0.9], z: [0.9, 1], name: door, opens: down, must_open: true}\n"
    )
    scene = room(piece("stove", 4.0, 2.0), block(4.0, 2.3 + 0.1 + 0.5, 2.0, 1.0))
    (found,) = [issue for issue in validate(scene, load_catalogs(tmp_path)) if issue.rule == "front_blocked"]
    assert found.severity == "error"


def test_a_homes_certificate_is_what_mujoco_finds() -> None:
    scene = generate(Request(seed=12, program="studio", decorate=True)).scene
    assert list(open_all(scene, describe(scene, KNOWN), KNOWN)) == []
    document: dict[str, Any] = dict(scene.certificate or {})
    rooms = document["rooms"].values()
    pieces = [one for entry in rooms for one in entry.get("fronts", {}).items()]
    said = [(piece, name) for piece, fronts in pieces for name in fronts]
    assert said == [(one.piece, one.front) for travels in front_travels(scene, KNOWN).values() for one in travels]


@pytest.mark.parametrize(("kind", "sooner"), [("window", True), ("door", True), ("passage", False), (None, None)])
def test_what_is_fitted_to_a_wall_stops_fronts_where_mujoco_says(kind: str | None, sooner: bool | None) -> None:
    """A wardrobe's door that turns to a wall meets a sill board or a door's handle sooner than the wall, a passage not at all."""
    bare = room(piece("wardrobe", 7.95 - 0.9, 2.0))
    sill, height = (0.9, 1.4) if kind == "window" else (0.0, 2.1)
    hole = Opening("hole", kind or "", "east", 2.8, height=height, sill=sill, hinge="end")
    scene = replace(bare, rooms=(replace(bare.rooms[0], openings=(hole,)),)) if kind else bare
    assert list(open_all(scene, describe(scene, KNOWN), KNOWN)) == []
    one, before = travel(scene, "outer_door_2"), travel(bare, "outer_door_2")
    assert before.meets == WALL
    if sooner is None:
        assert one == before
    else:
        assert one.travel < before.travel if sooner else one.travel > before.travel


def test_fronts_open_through_holes_that_overlap_as_far_as_mujoco_says() -> None:
    """Passages over each other in a wall, of chance: what opens to them is stopped where none of them leaves the wall open."""
    random, bare, wider = Random("holes"), room(piece("wardrobe", 7.95 - 0.9, 2.0)), 0
    before = travel(bare, "outer_door_2").travel
    for _ in range(12):
        sizes = [(random.uniform(1.2, 4.2), random.uniform(0.4, 2.0), random.uniform(0.3, 2.6)) for _ in range(random.randint(2, 5))]
        holes = [Opening(f"hole_{k}", "passage", "east", at, width, height=height) for k, (at, width, height) in enumerate(sizes)]
        scene = replace(bare, rooms=(replace(bare.rooms[0], openings=tuple(holes)),))
        assert list(open_all(scene, describe(scene, KNOWN), KNOWN)) == []
        wider += travel(scene, "outer_door_2").travel > before
    assert 0 < wider < 12


def test_holes_over_each_other_by_the_thousand_are_refused_before_walls_are_cut() -> None:
    bare = room(piece("wardrobe", 4.0, 2.0))
    for count, refused in ((20, False), (3000, True)):
        holes = (Opening(f"hole_{k}", "passage", "east", 3.0, 1.0 + k / 4000, height=1.0 + k / 4000) for k in range(count))
        scene = replace(bare, rooms=(replace(bare.rooms[0], openings=tuple(holes)),))
        with demanding_at_most(100_000), pytest.raises(TooMuch) if refused else nullcontext():
            front_travels(scene, KNOWN)


def test_a_door_stops_fronts_alike_in_both_its_rooms() -> None:
    """It is listed by one room or by both, and its leaf is where the room that draws it says."""
    den = room(piece("wardrobe", 7.95 - 0.9, 2.0)).rooms[0]
    hall = Room("hall", 0, "hall", x=8.0, width=3.0, depth=6.0, furniture=(piece("wardrobe", 0.05 + 0.9, 3.2, 180, "other"),))
    there = Opening("hole", "door", "west", 2.8, connects_to="den", hinge="end", swing="in")
    here = replace(there, wall="east", connects_to="hall", swing="out", render_panel=False)
    for listed in ((), (here,)):
        rooms = (replace(den, openings=listed), replace(hall, openings=(there,)))
        scene = Scene(wall_thickness=0.1, rooms=rooms)
        assert list(open_all(scene, describe(scene, KNOWN), KNOWN)) == []


def test_a_wrong_certificate_would_be_seen() -> None:
    scene = room(piece("stove", 4.0, 2.0), block(4.0, 2.3 + 0.25 + 0.5, 2.0, 1.0))
    model = describe(replace(scene, rooms=(replace(scene.rooms[0], furniture=scene.rooms[0].furniture[:1]),)), KNOWN)
    moved = replace(scene.rooms[0], furniture=(scene.rooms[0].furniture[0], replace(scene.rooms[0].furniture[1], z=2.9)))
    assert any("does not meet" in line for line in open_all(scene, model, KNOWN))
    assert any("the certificate says" in line for line in open_all(scene, describe(replace(scene, rooms=(moved,)), KNOWN), KNOWN))


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_round_parts_are_met_where_they_are_and_not_at_the_box_around_them(share: float) -> None:
    """A drawer comes out beside the middle of an upright cylinder until its edge meets the circle."""
    chest, barrel = piece("dresser", 4.0, 2.0), KNOWN.furniture["plant"]
    (drawer,) = [one for one in KNOWN.shapes["dresser"] if one.opens and one.front == "low_drawer"]
    radius = 0.25
    edge, face = chest.x + (drawer.x[0] - 0.5) * chest.width, chest.z + (drawer.z[1] - 0.5) * chest.depth
    aside = share * radius
    x, z = edge - aside, face + radius + 0.1
    post = Furniture("post", "post", x=x, z=z, width=2 * radius, depth=2 * radius, height=1.0, kind="post")
    known = KNOWN.model_copy(
        update={
            "furniture": KNOWN.furniture | {"post": barrel.model_copy(update={"size": (2 * radius, 2 * radius, 1.0), "name": None})},
            "shapes": KNOWN.shapes
            | {"post": (Solid(form="cylinder", axis="y", taper=1.0, x=(0, 1), y=(0, 1), z=(0, 1), material="body"),)},
        }
    )
    (one,) = [one for one in front_travels(room(chest, post), known)["den"] if one.front == "low_drawer"]
    assert one.meets == "post"
    assert one.travel == pytest.approx(z - math.sqrt(radius**2 - aside**2) - face, abs=0.005)


@pytest.mark.parametrize("depth", [1e-9, 1e-7])
def test_a_drawer_in_what_is_a_hair_deep_is_open(depth: float) -> None:
    """Scenes of others may hold anything above nothing."""
    chest = replace(piece("dresser", 4.0, 2.0), depth=depth)
    scene = room(chest, block(4.0, 2.0 + depth / 2 + 0.25, 2.0, 0.5))
    assert all(one.share == 1.0 for one in front_travels(scene, KNOWN)["den"] if one.range == 0)
    assert "front_blocked" not in {issue.rule for issue in validate(scene)}
