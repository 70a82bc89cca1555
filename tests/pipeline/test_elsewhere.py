"""A piece that a room wants only where none stands elsewhere: a table to eat at."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Request, generate, reroll
from solver.pipeline.generate import wanted_in
from solver.pipeline.insisted import insisted_in
from solver.scene import Room, Scene

CATALOGS = load_catalogs()
HOMES = [(program, seed) for program in ("studio", "one_bed") for seed in range(7_490_000, 7_490_008)]


def room_of(scene: Scene, kind: str) -> Room:
    return next(room for room in scene.rooms if room.type == kind)


def tables(room: Room) -> int:
    return sum(piece.name == "dining_table" for piece in room.furniture)


def asks_for_a_table(scene: Scene) -> bool:
    return any(piece.label == "dining_table_1" for piece in wanted_in(scene, room_of(scene, "kitchen"), CATALOGS)[1])


@pytest.fixture(scope="module", params=HOMES, ids=str)
def home(request: pytest.FixtureRequest) -> Scene:
    program, seed = request.param
    return generate(Request(seed=seed, program=program)).scene


def test_a_kitchen_has_a_table_only_where_no_other_room_has_one(home: Scene) -> None:
    assert tables(room_of(home, "kitchen")) + tables(room_of(home, "living_room")) <= 1


def test_what_a_kitchen_wanted_is_told_by_the_home(home: Scene) -> None:
    assert asks_for_a_table(home) == (not tables(room_of(home, "living_room")))


def test_a_kitchen_furnished_anew_looks_at_what_stands_elsewhere() -> None:
    home = next(
        made for program, seed in HOMES if tables(room_of(made := generate(Request(seed=seed, program=program)).scene, "living_room"))
    )
    kitchen = room_of(home, "kitchen").id
    assert tables(room_of(reroll(home, [kitchen], seed=1).scene, "kitchen")) == 0
    bare = replace(home, rooms=tuple(replace(room, furniture=()) if room.type == "living_room" else room for room in home.rooms))
    assert asks_for_a_table(bare)
    assert not asks_for_a_table(home)


def test_rooms_furnished_anew_together_are_furnished_as_at_first(home: Scene) -> None:
    both = [room_of(home, kind).id for kind in ("kitchen", "living_room")]
    again = reroll(home, both, seed=home.seed).scene
    assert [room.furniture for room in again.rooms] == [room.furniture for room in home.rooms]


def test_a_kitchen_insists_on_its_table_alone(home: Scene) -> None:
    assert insisted_in(home.certificate, room_of(home, "kitchen").id) in (None, "dining_table_1")


@pytest.mark.parametrize(
    ("program", "seed"), [("studio", 88_120_028), ("studio", 88_120_064), ("one_bed", 88_120_007), ("one_bed", 88_120_024)]
)
def test_the_only_table_stands_even_where_it_costs_a_counter(program: str, seed: int) -> None:
    home = generate(Request(seed=seed, program=program))
    assert sum(tables(room) for room in home.scene.rooms) == 1
    assert not [issue.message for issue in home.issues]
