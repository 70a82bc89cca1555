"""Access: what is met to the millimetre, what is missing, and by whom it could be made up for."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from random import Random

import pytest

from catalogs import CatalogError, load_catalogs
from solver import generate, reroll
from solver.errors import RequestError
from solver.request import Request
from solver.scene import Decoration, Furniture, Opening, Room, Scene
from solver.validator import access_of
from solver.validator.accessibility import AccessFinding, largest_square
from solver.validator.lattice import ExactBox

CATALOGS = load_catalogs()
DIN = "din_18040_2"


def body(name: str, x: float, z: float, size: tuple[float, float], rotation: float = 0) -> Furniture:
    return Furniture(name, name, x=x, z=z, rotation=rotation, width=size[0], depth=size[1], height=0.8)


def bath(*pieces: Furniture, **more: object) -> Scene:
    door = Opening("door", wall="south", position=0.7, width=0.9, connects_to="EXTERIOR", main_entrance=True)
    fields = {"type": "bathroom", "width": 2.4, "depth": 2.4, "openings": (door,), "furniture": pieces, **more}
    return Scene(rooms=(Room("bath", **fields),))  # type: ignore[arg-type]


def found(scene: Scene, what: str, profile: str = DIN) -> list[AccessFinding]:
    return [one for one in access_of(scene, profile, CATALOGS).findings if one.what == what]


@pytest.mark.parametrize(("wide", "missing"), [(1.2, 0.0), (1.201, 0.001), (1.3, 0.1)])
def test_the_turning_square_is_measured_to_the_millimetre(wide: float, missing: float) -> None:
    (one,) = found(bath(body("bathtub", wide / 2, 1.2, (wide, 2.4))), "turning")
    assert (one.has, one.missing, one.needs) == (round(2.4 - wide, 4), missing, 1.2)
    assert one.place == (wide, 0.0, 2.4, round(2.4 - wide, 4))


@pytest.mark.parametrize(("width", "kind", "missing"), [(0.9, "door", 0.0), (0.899, "door", 0.001), (0.8, "passage", 0.0)])
def test_a_leaf_takes_its_part_of_a_door(width: float, kind: str, missing: float) -> None:
    door = Opening("door", kind=kind, wall="south", position=0.7, width=width, connects_to="EXTERIOR")
    inner, out = found(bath(openings=(door,)), "door")
    assert (inner.id, inner.missing, out.missing) == ("door", missing, missing)
    if kind == "door":
        entrance = found(bath(openings=(replace(door, main_entrance=True),)), "door")
        assert [(one.needs, one.missing) for one in entrance] == [(0.8, missing), (0.9, round(1 - width, 4)), (0.8, missing)]


@pytest.mark.parametrize(("swing", "missing"), [("in", 0.8), ("out", 0.0), (None, 0.0)])
def test_a_leaf_that_swings_into_a_bathroom_is_told(swing: str | None, missing: float) -> None:
    door = Opening("door", wall="south", position=0.7, width=0.9, connects_to="EXTERIOR", swing=swing)
    assert [one.missing for one in found(bath(openings=(door,)), "door")] == [0.0, missing]


@pytest.mark.parametrize(("y", "depth", "free"), [(1.4, 0.1, True), (1.4, 0.101, False), (0.685, 0.05, True), (0.68, 0.05, False)])
def test_what_hangs_flat_at_a_wall_is_in_nobodys_way(y: float, depth: float, free: bool) -> None:
    towel = Decoration("bar", "towel_bar", x=1.2, z=2.4 - depth / 2, y=y, width=2.2, depth=depth, height=0.3)
    (whole,) = found(bath(decorations=(towel,)), "turning")
    assert whole.has == (2.4 if free else round(2.4 - depth, 4))


def test_strips_along_a_toilet_go_to_the_next_body_or_wall() -> None:
    toilet = body("toilet", 0.4, 0.33, (0.4, 0.66))
    wide, narrow = found(bath(toilet), "along")
    assert (wide.has, narrow.has, narrow.missing) == (1.8, 0.2, 0.0)
    wide, narrow = found(bath(toilet, body("vanity", 1.15, 0.24, (0.8, 0.48))), "along")
    assert (wide.has, narrow.has, wide.missing) == (0.2, 0.15, 0.0)
    assert narrow.missing == 0.05


@pytest.mark.parametrize("wall", ["north", "south", "east", "west"])
@pytest.mark.parametrize("hinge", ["start", "end"])
@pytest.mark.parametrize(("swing", "needs"), [("in", 1.5), ("out", 1.2)])
def test_the_floor_before_a_leaf_and_beside_its_latch_is_measured_at_each_wall(wall: str, hinge: str, swing: str, needs: float) -> None:
    """The door is 1 m wide, in the middle of a wall of 4 m; a crate of 1 m stands just off the floor asked for, or 2 cm in it."""
    door = Opening("door", wall=wall, position=2.0, width=1.0, connects_to="EXTERIOR", main_entrance=True, hinge=hinge, swing=swing)
    for near in (0.0, 0.02):
        beside = (1.5 - near) * (1 if hinge == "start" else -1)
        for aside, off, asked in ((0.0, needs - near + 0.5, needs), (beside, 0.5, 0.5)):
            along, across = 2.0 + aside, off if wall in ("north", "west") else 4 - off
            x, z = (along, across) if wall in ("north", "south") else (across, along)
            room = bath(body("crate", x, z, (1.0, 1.0)), width=4.0, depth=4.0, openings=(door,))
            short = [(one.needs, one.missing) for one in found(room, "approach", "din_18040_2_r") if one.missing]
            assert short == ([(asked, near)] if near else [])


def test_without_a_hinge_no_floor_is_asked_for_beside_a_latch() -> None:
    door = Opening("door", wall="south", position=0.6, width=1.0, connects_to="EXTERIOR", main_entrance=True, swing="in")
    assert [one.needs for one in found(bath(openings=(door,)), "approach", "din_18040_2_r")] == [1.5]
    hung = [(one.needs, one.missing) for one in found(bath(openings=(replace(door, hinge="end"),)), "approach", "din_18040_2_r")]
    assert hung == [(1.5, 0.0), (0.5, 0.4)]


@pytest.mark.parametrize("rotation", [0, 90, 180, 270])
def test_the_floor_before_a_piece_is_measured_whichever_way_it_looks(rotation: int) -> None:
    x, z = {0: (1.2, 0.24), 90: (0.24, 1.2), 180: (1.2, 2.16), 270: (2.16, 1.2)}[rotation]
    bx, bz = {0: (0.5, 2.2), 90: (2.2, 0.5), 180: (0.5, 0.2), 270: (0.2, 0.5)}[rotation]
    scene = bath(body("vanity", x, z, (0.8, 0.48), rotation), body("shelf", bx, bz, (0.4, 0.4)))
    (one,) = found(scene, "before", "ada")
    assert (one.has, one.needs) == (1.92, 1.22)
    walled = bath(body("vanity", x, z, (0.8, 0.48), rotation), body("shelf", max(bx, 0.2), max(bz, 0.2), (2.4, 0.4), rotation))
    assert [one.has for one in found(walled, "before", "ada")] == [1.52]


def test_the_widest_square_that_comes_in_is_told() -> None:
    scene = bath(body("bathtub", 1.55, 1.4, (1.7, 0.6)))
    (one,) = found(scene, "reach")
    assert (one.needs, one.has, one.missing) == (0.8, 0.7, 0.1)


def test_one_bathroom_that_is_wide_enough_makes_up_for_the_other() -> None:
    small, large = (replace(bath(body("bathtub", 1.0, 0.9, (2.0, 1.8))).rooms[0], id="small"), replace(bath().rooms[0], id="large", x=2.4))
    both = access_of(Scene(rooms=(small, large)), DIN, CATALOGS)
    assert "small" in {one.room for one in both.findings if one.what == "turning" and one.missing}
    assert not [one for one in both.unmet if one.what == "turning"]
    alone = access_of(Scene(rooms=(small,)), DIN, CATALOGS)
    assert [one.room for one in alone.unmet if one.what == "turning"] == ["small"]


def test_the_largest_square_is_that_of_a_raster() -> None:
    chance = Random(5)
    for _ in range(60):
        size = chance.randint(4, 9)
        corners = [(chance.randrange(size), chance.randrange(size)) for _ in range(chance.randint(0, 5))]
        taken = [ExactBox(x, z, x + chance.randint(1, 4), z + chance.randint(1, 4)) for x, z in corners]
        free = {(x, z) for x, z in product(range(size), repeat=2) if not any(b.x0 <= x < b.x1 and b.z0 <= z < b.z1 for b in taken)}
        sides = [
            side for side in range(1, size + 1) for x, z in free if all((x + i, z + k) in free for i, k in product(range(side), repeat=2))
        ]
        square = largest_square(ExactBox(0, 0, size, size), taken)
        assert (square.x1 - square.x0 if square else 0) == max(sides, default=0)


def test_a_home_says_in_its_certificate_what_is_met() -> None:
    scene = generate(Request(seed=2, program="one_bed", access=DIN)).scene
    certificate = scene.certificate or {}
    told = certificate["access"]
    assert isinstance(told, dict)
    report = access_of(scene, DIN, CATALOGS)
    assert told == {"profile": DIN, "met": not report.unmet, "unmet": report.document()["unmet"]}
    assert scene.request is not None
    assert scene.request["robot_width"] == 0.8
    again = reroll(scene, [scene.rooms[-1].id], seed=9).scene
    assert (again.certificate or {})["access"] == {**told, **{k: access_of(again, DIN).document()[k] for k in ("met", "unmet")}}


def test_unknown_profiles_and_rooms_are_named(tmp_path: Path) -> None:
    with pytest.raises(RequestError, match="unknown profile 'moon'"):
        access_of(bath(), "moon", CATALOGS)
    with pytest.raises(RequestError, match="unknown profile"):
        generate(Request(seed=1, program="studio", access="moon"))
    rule = "{what: turning, min: 1, rooms: [bathrom], clause: x}"
    (tmp_path / "access.yaml").write_text(f"mine: {{description: x, walker: 0.7, rules: [{rule}]}}\n")
    with pytest.raises(CatalogError, match="bathrom"):
        load_catalogs(tmp_path)


@pytest.mark.parametrize("rule", ["{what: turning, min: 1, pieces: [bed], clause: x}", "{what: before, min: 1, pieces: [bed], clause: x}"])
def test_rules_that_say_too_much_or_too_little_are_refused(rule: str, tmp_path: Path) -> None:
    (tmp_path / "access.yaml").write_text(f"mine: {{description: x, walker: 0.7, rules: [{rule}]}}\n")
    with pytest.raises(CatalogError, match=r"access\.yaml"):
        load_catalogs(tmp_path)
