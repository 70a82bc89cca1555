"""Homes made for a profile of access: the judge, which shares no code with what makes them, finds nothing missing."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from catalogs import CatalogError, Catalogs, load_catalogs
from solver import generate, reroll
from solver.answers import Generated
from solver.floorplan import draw
from solver.pipeline.own_plan import furnish
from solver.request import Request
from solver.scene import Opening, Room, Scene
from solver.validator import access_of
from tests.sweeps import pairs, seeds

CATALOGS = load_catalogs()
PROFILES = sorted(CATALOGS.access)


def family(seed: int, **more: object) -> Generated:
    return generate(Request(seed=seed, program="family", **more))  # type: ignore[arg-type]


@pytest.mark.parametrize(("asked", "seed"), pairs([*product(PROFILES, [True, False])], seeds(range(90_000, 90_050), 13)))
def test_a_family_home_made_for_a_profile_is_certified(asked: tuple[str, bool], seed: int) -> None:
    profile, decorate = asked
    made = family(seed, access=profile, decorate=decorate)
    certificate: dict[str, Any] = dict(made.scene.certificate or {})
    assert access_of(made.scene, profile, CATALOGS).unmet == ()
    assert certificate["access"] == {"profile": profile, "met": True, "unmet": []}
    assert [issue for issue in made.issues if issue.severity == "error"] == []
    assert all(room["proven"] for room in certificate["rooms"].values())


def test_a_home_says_the_catalog_and_without_a_profile_is_as_it_was() -> None:
    plain, none = family(5).scene, family(5, access="none").scene
    assert replace(none, request=plain.request) == plain
    made_for = family(5, access="ada").scene
    assert [(one.generator or {})["catalog"] for one in (plain, made_for)] == [CATALOGS.fingerprint] * 2


@pytest.mark.parametrize(("profile", "deep"), [("din_18040_2", 0.9), ("din_18040_2_r", 1.5)])
def test_a_coffee_table_stands_beyond_the_floor_that_is_empty_before_the_sofa(profile: str, deep: float) -> None:
    living = [room for seed in range(70, 80) for room in family(seed, access=profile).scene.rooms if room.type == "living_room"]
    apart = list[float]()
    for pieces in ({piece.name: piece for piece in room.furniture} for room in living):
        sofa, table = pieces["sofa"], pieces.get("coffee_table")
        if table:
            off = abs(table.z - sofa.z if sofa.rotation % 180 == 0 else table.x - sofa.x)
            apart.append(off - (sofa.depth + (table.depth if (table.rotation - sofa.rotation) % 180 == 0 else table.width)) / 2)
    assert len(apart) >= 8
    assert min(apart) >= deep - 2e-3


@pytest.mark.parametrize("profile", PROFILES)
def test_most_children_have_a_desk(profile: str) -> None:
    rooms = [room for seed in range(70, 80) for room in family(seed, access=profile).scene.rooms if room.type == "kids_bedroom"]
    assert sum("desk" in {piece.name for piece in room.furniture} for room in rooms) >= 0.7 * len(rooms) >= 7


@pytest.mark.parametrize(("profile", "inner", "main"), [("din_18040_2", 0.9, 1.0), ("din_18040_2_r", 1.0, 1.0), ("ada", 0.95, 0.95)])
def test_doors_are_cut_for_their_clear_width(profile: str, inner: float, main: float) -> None:
    doors = [one for room in family(3, access=profile).scene.rooms for one in room.openings if one.kind == "door"]
    assert {one.width for one in doors if one.main_entrance} == {main}
    assert {one.width for one in doors if not one.main_entrance} == {inner}


@pytest.mark.parametrize("profile", ["din_18040_2_r", "ada"])
def test_floor_before_doors_stays_free_of_what_is_furnished_and_laid_down(profile: str) -> None:
    found = [one for seed in range(70, 78) for one in access_of(family(seed, access=profile, decorate=True).scene, profile).findings]
    asked = [one.missing for one in found if one.what == "approach"]
    assert len(asked) > 100
    assert sum(missing > 0 for missing in asked) <= 0.01 * len(asked)


def test_a_door_at_the_end_of_a_hallway_leaves_wall_beside_its_latch() -> None:
    """Measured between the walls' faces: in the middle of such an end a door of 1 m leaves 25 cm."""
    known, beside = CATALOGS.for_access("din_18040_2_r"), list[float]()
    asked = (Request(seed=seed, program="large", access="din_18040_2_r", robot_width=0.9) for seed in range(61_000, 61_050))
    for room in (room for request in asked for room in draw(request, known).rooms if room.type == "hallway"):
        for door in (one for one in room.openings if one.kind == "door"):
            length = room.width if door.wall in ("north", "south") else room.depth
            latch = door.position + door.width / 2 * (1 if door.hinge == "start" else -1)
            beside.append((length - latch if door.hinge == "start" else latch) - 0.05)
    assert len([one for one in beside if one < 0.6]) >= 4
    assert min(beside) >= 0.5 - 1e-9


def test_two_rooms_share_so_much_wall_that_both_have_some_beside_the_latch_of_the_door_between() -> None:
    """Measured between the walls' faces, on both sides of each leaf."""
    known, beside = CATALOGS.for_access("din_18040_2_r"), list[float]()
    for seed in range(61_000, 61_150):
        plan = draw(Request(seed=seed, program="one_bed", access="din_18040_2_r", robot_width=0.9), known)
        for room in plan.rooms:
            for door in (one for one in room.openings if one.kind == "door" and not one.main_entrance):
                length = room.width if door.wall in ("north", "south") else room.depth
                latch = door.position + door.width / 2 * (1 if door.hinge == "start" else -1)
                beside.append((length - latch if door.hinge == "start" else latch) - 0.05)
    assert len(beside) > 500
    assert min(beside) >= 0.5 - 1e-9


@pytest.mark.parametrize(("profile", "clear"), [("din_18040_2", 1.2), ("din_18040_2_r", 1.5), ("ada", 1.22)])
def test_hallways_are_as_wide_as_the_floor_before_their_doors(profile: str, clear: float) -> None:
    scenes = [family(seed, access=profile).scene for seed in range(4)]
    widths = [min(room.width, room.depth) - scene.wall_thickness for scene in scenes for room in scene.rooms if room.type == "hallway"]
    assert len(widths) >= 4
    assert clear - 1e-9 <= min(widths) < clear + 0.1


@pytest.mark.parametrize("wrong", ["what: approach, min: 1.2", "what: door, min: 0.8, pull: true", "what: door, min: 0.8, latch: 0.5"])
def test_a_rule_says_on_which_side_of_a_door_it_is_and_no_other_rule_does(wrong: str, tmp_path: Path) -> None:
    (tmp_path / "access.yaml").write_text(f"mine: {{description: x, walker: 0.7, rules: [{{{wrong}, clause: ours}}]}}\n")
    with pytest.raises(CatalogError, match="pull"):
        load_catalogs(tmp_path)


def test_a_bathrooms_leaf_swings_out_of_it_where_another_has_none_to_meet() -> None:
    rooms = [room for seed in range(6) for room in family(seed, access="din_18040_2").scene.rooms if room.type == "bathroom"]
    swings = [one.swing for room in rooms for one in room.openings if one.kind == "door"]
    assert swings.count("out") > 4 * swings.count("in")
    plain = [room for seed in range(6) for room in family(seed).scene.rooms if room.type == "bathroom"]
    assert {one.swing for room in plain for one in room.openings if one.kind == "door"} == {"in"}


def test_a_bathroom_has_a_door_however_full_of_doors_the_foyer_is() -> None:
    known = CATALOGS.for_access("din_18040_2_r")
    homes = [draw(Request(seed=seed, program="one_bed", robot_width=0.9), known) for seed in range(300, 330)]
    assert {one.kind for home in homes for room in home.rooms if room.type == "bathroom" for one in room.openings} == {"door", "window"}


def test_rooms_are_as_large_as_the_profile_says() -> None:
    sizes = CATALOGS.access["din_18040_2_r"].homes
    rooms = [room for room in family(4, access="din_18040_2_r").scene.rooms if room.type in sizes]
    assert len(rooms) > 6
    for room in rooms:
        assert min(room.width, room.depth) >= sizes[room.type].width - 1e-9
        assert room.floor_m2 >= sizes[room.type].area[0] - 1e-9


def test_a_studio_has_room_about_its_bed_and_a_bathroom_one_can_get_out_of() -> None:
    """Seven square metres are a bed of 1.5 x 2 m and strips of 1.2 and 0.9 m along it."""
    least = CATALOGS.access["din_18040_2"].homes["living_room"].area[0] + 7.0
    for seed in range(60_000, 60_006):
        scene = generate(Request(seed=seed, program="studio", access="din_18040_2")).scene
        living, bath = (next(room for room in scene.rooms if room.type == name) for name in ("living_room", "bathroom"))
        assert living.width * living.depth >= least
        assert [one.swing for one in bath.openings if one.kind == "door"] == ["out"]
    family_living = [room for room in family(4, access="din_18040_2").scene.rooms if room.type == "living_room"]
    assert family_living[0].width * family_living[0].depth <= CATALOGS.access["din_18040_2"].homes["living_room"].area[2]


@pytest.mark.parametrize(("preset", "profile"), pairs(["studio", "one_bed"], PROFILES))
def test_small_homes_made_for_a_profile_are_certified(preset: str, profile: str) -> None:
    scenes = [generate(Request(seed=seed, program=preset, access=profile)).scene for seed in range(60_000, 60_010)]
    assert sum(not access_of(scene, profile, CATALOGS).unmet for scene in scenes) >= 9


def test_what_is_furnished_anew_keeps_what_is_asked_for() -> None:
    made = family(90_000, access="din_18040_2_r", decorate=True).scene
    again = reroll(made, [room.id for room in made.rooms], seed=77).scene
    assert access_of(again, "din_18040_2_r", CATALOGS).unmet == ()


def plan() -> Scene:
    door = Opening("door", wall="south", position=0.7, width=1.0, connects_to="EXTERIOR", main_entrance=True)
    return Scene(rooms=(Room("bath", type="bathroom", width=2.6, depth=3.0, openings=(door,)),))


def test_a_plan_of_ones_own_is_furnished_for_a_profile() -> None:
    short = {one.what for seed in range(8) for one in access_of(furnish(plan(), seed=seed).scene, "din_18040_2_r").unmet}
    assert {"turning", "along"} <= short
    for seed in range(8):
        made = furnish(plan(), seed=seed, access="din_18040_2_r").scene
        assert (made.certificate or {})["access"] == {"profile": "din_18040_2_r", "met": True, "unmet": []}
        assert (made.request or {})["robot_width"] == 0.9


def test_a_square_that_a_room_has_no_space_for_costs_it_nothing_else() -> None:
    small = replace(plan(), rooms=(replace(plan().rooms[0], width=1.8, depth=2.2),))
    made = furnish(small, seed=1, access="din_18040_2_r")
    assert {piece.name for piece in made.scene.rooms[0].furniture} >= {"toilet"}
    assert [issue for issue in made.issues if issue.severity == "error"] == []
    assert not (made.scene.certificate or {})["access"]["met"]  # type: ignore[index]


@pytest.mark.parametrize("wrong", ["{bathrom: {area: [5, 6, 9], width: 2}}", "{bathroom: {area: [5, 6], width: 2}}"])
def test_sizes_of_no_room_are_refused(wrong: str, tmp_path: Path) -> None:
    (tmp_path / "access.yaml").write_text(f"mine: {{description: x, walker: 0.7, rules: [], homes: {wrong}}}\n")
    with pytest.raises(CatalogError, match=r"access\.yaml"):
        load_catalogs(tmp_path)


def test_a_profile_of_ones_own_makes_homes(tmp_path: Path) -> None:
    rule = "{what: turning, min: 1.4, rooms: [bathroom], clause: ours}"
    homes = "{bathroom: {area: [6, 7, 10], width: 2.3}}"
    (tmp_path / "access.yaml").write_text(f"mine: {{description: x, walker: 0.7, rules: [{rule}], homes: {homes}}}\n")
    own: Catalogs = load_catalogs(tmp_path)
    scene = generate(Request(seed=1, program="one_bed", access="mine"), catalogs=own).scene
    (found,) = [one for one in access_of(scene, "mine", own).findings if one.what == "turning"]
    assert found.missing == 0
