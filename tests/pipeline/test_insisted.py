"""Rooms of somebody's own plan: the most important piece that the search left out is searched for again."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import product
from typing import Any

import pytest

from compose_homes import explain, furnish, generate, reroll, validate
from solver.pipeline.explain import CHANGED
from solver.pipeline.insisted import insisted_in
from solver.request import Request
from solver.scene import EXTERIOR, Level, Opening, Room, Scene

ROOMS = [*product((2.0, 2.2, 2.4, 2.6), (1.9, 2.0, 2.1, 2.3), (0.5, 0.9))]
"""Widths, depths, and how far from the corner the middle of the door is, m."""
BATHS = {"bathtub", "short_bathtub", "shower", "small_shower"}


def bathroom(width: float, depth: float, door_at: float) -> Scene:
    door = Opening("d", "door", "west", depth - door_at, 0.8, 2.0, connects_to=EXTERIOR, main_entrance=True)
    return Scene(wall_thickness=0.16, rooms=(Room("a", type="bathroom", width=width, depth=depth, openings=(door,)),))


@cache
def both(width: float, depth: float, door_at: float) -> tuple[Scene, Scene]:
    """A bathroom as it is furnished where nothing is insisted on, and as a plan's."""
    plan = bathroom(width, depth, door_at)
    return reroll(plan, ["a"], seed=3).scene, furnish(plan, seed=3).scene


def kinds(home: Scene) -> set[str]:
    return {piece.kind or "" for piece in home.rooms[0].furniture}


def insisted(home: Scene) -> str | None:
    return insisted_in(home.certificate, "a")


def poses(home: Scene) -> list[tuple[str, float, float, float]]:
    return [(piece.id, piece.x, piece.z, piece.rotation) for piece in home.rooms[0].furniture]


def test_more_bathrooms_of_plans_have_a_tub_or_a_shower_and_none_loses_a_required_piece() -> None:
    plain, made = zip(*(both(*room) for room in ROOMS), strict=True)
    gained = [bool(kinds(home) & BATHS) - bool(kinds(before) & BATHS) for before, home in zip(plain, made, strict=True)]
    assert min(gained) == 0
    assert sum(gained) >= 3
    for home in made:
        assert {"toilet"} < kinds(home)
        assert not {issue.rule for issue in validate(home) if issue.severity == "error"} - {"no_entrance"}


def test_what_was_insisted_on_opens_and_the_certificate_names_it() -> None:
    for before, home in (both(*room) for room in ROOMS):
        assert insisted(before) is None
        if kinds(home) & BATHS and not kinds(before) & BATHS:
            assert insisted(home) == "bath_1"
            assert not [issue for issue in validate(home) if issue.rule == "front_blocked" and "shower" in issue.message]
        if insisted(home) is None:
            assert poses(home) == poses(before)


@pytest.mark.parametrize("part", range(3))
def test_a_room_in_which_it_was_insisted_is_explained_as_it_was_made(part: int) -> None:
    homes = [home for _, home in (both(*room) for room in ROOMS) if insisted(home)]
    for home in homes[part::3]:
        for piece in home.rooms[0].furniture:
            assert CHANGED not in explain(home, piece.id).notes


def test_it_is_as_it_was_where_an_edit_took_the_certificate() -> None:
    home = next(home for _, home in (both(*room) for room in ROOMS) if insisted(home))
    again = furnish(replace(home, certificate=None), keep="none", seed=3).scene
    assert poses(again) == poses(home)


def test_what_is_too_high_for_a_low_room_is_told_where_it_was_insisted_too() -> None:
    plan = replace(bathroom(2.2, 2.1, 0.5), levels=(Level(0, 0.0, 1.9),))
    home = furnish(plan, seed=3).scene
    assert insisted(home) == "bath_1"
    certificate: Any = home.certificate
    assert "shower_1" in {one["piece"] for one in certificate["rooms"]["a"]["left_out"]}


STUDIOS: list[dict[str, Any]] = [
    {"seed": 510924279406, "outline": "L", "robot_width": 0.8},
    {"seed": 556607721296, "outline": "L", "robot_width": 0.8},
    {"seed": 49372682363, "outline": "U", "robot_width": 0.5, "outer_wall_thickness": 0.36},
    {"seed": 716142411305, "outline": "U", "access": "ada", "robot_width": 0.8, "wall_thickness": 0.2},
    {"seed": 881007897515, "outline": "rectangle", "robot_width": 0.6, "wall_thickness": 0.08, "outer_wall_thickness": 0.6},
]
"""Homes in which one eats in the kitchen alone, and whose table is insisted on or stood before counters when it was."""


@pytest.mark.parametrize("asked", STUDIOS)
def test_a_table_that_is_insisted_on_stands_before_no_front_of_the_kitchen(asked: dict[str, Any]) -> None:
    home = generate(Request(program="studio", **asked))
    assert not [issue.message for issue in home.issues if issue.rule == "front_blocked"]
    kitchen = next(room for room in home.scene.rooms if room.type == "kitchen")
    assert any(piece.name == "dining_table" for piece in kitchen.furniture)
    assert CHANGED not in explain(home.scene, kitchen.furniture[0].id).notes


WALLS_OF_MASTERS = [
    (4.9, 4.2, {"east": (3.625,), "south": (2.45,)}, {"north": (1.225, 3.675), "west": (2.1,)}),
    (4.35, 4.65, {"south": (0.575,), "west": (2.325,)}, {"north": (1.087, 3.262), "east": (1.15,)}),
]
"""Width, depth, and where the doors and windows are along their walls, m."""


def bedroom(width: float, depth: float, doors: dict[str, tuple[float, ...]], windows: dict[str, tuple[float, ...]]) -> Scene:
    kinds = (("door", doors, 0.95, 0.0), ("window", windows, 1.2, 0.9))
    openings = (
        Opening(f"{kind}_{wall}_{at}", kind, wall, at, wide, 2.1 - sill, sill=sill, connects_to=EXTERIOR)
        for kind, walls, wide, sill in kinds
        for wall, places in walls.items()
        for at in places
    )
    return Scene(rooms=(Room("a", type="bedroom_master", width=width, depth=depth, openings=tuple(openings)),))


@pytest.mark.parametrize("room", WALLS_OF_MASTERS)
def test_what_is_needed_by_what_is_insisted_on_opens_too(room: Any) -> None:
    made = [furnish(bedroom(*room), seed=seed) for seed in range(6)]
    assert "second_wardrobe_1" in {insisted(one.scene) for one in made}
    assert not [issue.message for one in made for issue in one.issues if issue.rule == "front_blocked"]
