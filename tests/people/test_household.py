"""Who is in a house: the odds, the limits, and the same people for the same seed."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from solver import generate
from solver.furnish import space_of
from solver.people import Household, peopled
from solver.scene import Scene
from tests.people.homes import MAJOR, REQUESTS, house, household

SEEDS = 1000
SIGMAS = 4.5


def within(found: int, tries: int, odds: float) -> bool:
    """Whether a count is one that a binomial law gives but for one time in 100,000."""
    return abs(found - tries * odds) <= SIGMAS * math.sqrt(tries * odds * (1 - odds))


def least_major(scene: Scene, number: int) -> Scene:
    """The house with its first few major rooms alone: not so many that the limit of four people is met."""
    major = [room for room in scene.rooms if room.type in MAJOR][:number]
    return replace(scene, rooms=tuple(major))


def drawn(scene: Scene, seed: int) -> Scene:
    home = Household(seed, load_catalogs(), lambda room: space_of(room, scene.wall_thickness, 0.6, scene.rooms))
    return replace(scene, dynamic=peopled(scene.rooms, home))


def test_three_in_ten_major_rooms_have_a_person_and_seven_in_ten_houses_a_pet() -> None:
    scene = least_major(house(0), 4)
    people, kinds = Counter[str](), Counter[str]()
    for seed in range(SEEDS):
        here = drawn(scene, seed).dynamic
        people.update(one.room for one in here if one.kind == "person" and one.room)
        kinds.update(one.kind for one in here if one.kind != "person")
    for room in scene.rooms:
        assert within(people[room.id], SEEDS, 0.3), people
    assert within(kinds["dog"] + kinds["cat"], SEEDS, 0.7)
    assert within(kinds["dog"], kinds["dog"] + kinds["cat"], 0.5)
    assert set(kinds) == {"dog", "cat"}


def test_at_most_four_people_and_one_pet_and_people_in_major_rooms() -> None:
    assert sum(room.type in MAJOR for room in house(4).rooms) > 8
    counts = Counter[int]()
    for seed in range(120):
        scene = household(4, seed)
        types = {room.id: room.type for room in scene.rooms}
        people = [one for one in scene.dynamic if one.kind == "person"]
        counts[len(people)] += 1
        assert all(types[one.room or ""] in MAJOR for one in people)
        assert len({one.room for one in people}) == len(people) <= 4
        assert len(scene.dynamic) - len(people) <= 1
        assert [one.id for one in people] == [f"person_{k + 1}" for k in range(len(people))]
    assert counts[4] > 20


def test_pets_are_in_living_rooms_backyards_and_kitchens_where_there_are_any() -> None:
    for number in (0, 1):
        types = {room.id: room.type for room in house(number).rooms}
        pets = [one for seed in range(100) for one in household(number, seed).dynamic if one.kind != "person"]
        found = Counter(types[pet.room or ""] for pet in pets)
        assert set(found) == {"living_room", "backyard", "kitchen"} & set(types.values())
        assert min(found.values()) > 5


def test_a_pet_without_such_rooms_is_somewhere_else() -> None:
    scene = house(0)
    bare = replace(scene, rooms=tuple(room for room in scene.rooms if room.type in ("bedroom_master", "hallway", "bathroom")))
    rooms = {room.id: room.type for room in bare.rooms}
    pets = [one for seed in range(60) for one in drawn(bare, seed).dynamic if one.kind != "person"]
    assert within(len(pets), 60, 0.7)
    assert {rooms[pet.room or ""] for pet in pets} == {"bedroom_master", "hallway"}


def test_sizes_are_those_of_people_dogs_and_cats() -> None:
    sizes = {(one.kind, one.width, one.depth, one.height) for seed in range(60) for one in household(0, seed).dynamic if one.on is None}
    assert sizes == {("person", 0.5, 0.3, 1.7), ("dog", 0.3, 0.7, 0.5), ("cat", 0.2, 0.45, 0.25)}


@pytest.mark.parametrize("number", range(3))
def test_the_same_seed_brings_the_same_people(number: int) -> None:
    assert household(number, 7) == household(number, 7)
    assert len({str(household(number, seed).dynamic) for seed in range(20)}) > 15
    made = generate(REQUESTS[number]).scene
    assert made.dynamic == household(number, made.seed or 0).dynamic


def test_a_room_draws_its_own_people() -> None:
    """Leaving rooms out of a house changes nobody in those that are left (the limit aside)."""
    scene = least_major(house(0), 4)
    for seed in range(60):
        whole = drawn(scene, seed).dynamic
        alone = [drawn(replace(scene, rooms=(room,)), seed).dynamic for room in scene.rooms]
        poses = [(one.room, one.x, one.z, one.rotation) for one in whole if one.kind == "person"]
        assert poses == [(one.room, one.x, one.z, one.rotation) for few in alone for one in few if one.kind == "person"]


def test_certificate_and_view_count_them() -> None:
    scene = next(made for seed in range(20) if (made := generate(replace(REQUESTS[3], seed=seed)).scene).dynamic)
    certificate: Any = scene.certificate
    assert certificate["counts"]["dynamic"] == len(scene.dynamic)
