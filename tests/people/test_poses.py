"""Where people and pets are: on free floor or seated, within reach, in nobody's way, looking at something."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import lru_cache

import pytest

from catalogs import load_catalogs
from solver import Scene, validate
from tests.people.homes import REQUESTS, crossed, household, meets, out_of_reach, seen

SEEDS = 40
KNOWN = load_catalogs()
numbers = pytest.mark.parametrize("number", range(len(REQUESTS)))


@lru_cache(maxsize=8)
def households(number: int) -> tuple[Scene, ...]:
    return tuple(household(number, seed) for seed in range(SEEDS))


@numbers
def test_nobody_shares_space_leaves_the_room_or_stands_in_a_door(number: int) -> None:
    for scene in households(number):
        assert {one.id: list(crossed(one, scene)) for one in scene.dynamic if list(crossed(one, scene))} == {}


@numbers
def test_everything_stays_within_reach_and_so_do_they(number: int) -> None:
    for scene in households(number):
        for room in scene.rooms:
            if any(one.room == room.id for one in scene.dynamic):
                assert out_of_reach(scene, room) == []


@numbers
def test_the_validator_has_nothing_to_say(number: int) -> None:
    for scene in households(number)[:12]:
        assert [issue.message for issue in validate(scene, KNOWN) if issue.severity == "error"] == []


@numbers
def test_who_stands_looks_at_something(number: int) -> None:
    for scene in households(number):
        rooms = {room.id: room for room in scene.rooms}
        standing = [one for one in scene.dynamic if one.kind == "person" and one.on is None]
        assert [one.id for one in standing if not list(seen(one, rooms[one.room or ""]))] == []


@numbers
def test_who_sits_sits_on_a_seat_and_looks_as_it_does(number: int) -> None:
    for scene in households(number):
        pieces = {piece.id: piece for room in scene.rooms for piece in room.furniture}
        for one in (one for one in scene.dynamic if one.on is not None):
            seat = pieces[one.on or ""]
            assert one.kind == "person" and seat.category in ("seating", "bed") and seat.under is None
            assert one.rotation == seat.rotation
            entries = [entry for kind, entry in load_catalogs().furniture.items() if load_catalogs().name_of(kind) == seat.name]
            heights = {
                surface.height for entry in entries if entry.size == (seat.width, seat.depth, seat.height) for surface in entry.surfaces
            }
            below = [
                thing.y + thing.height for room in scene.rooms for thing in room.decorations if room.id == one.room and meets(one, thing)
            ]
            seated_at = [height for height in heights if 0.35 <= height <= 0.6 and height <= one.y <= height + 0.06]
            assert seated_at and (one.y in heights if not below else one.y == pytest.approx(max(below)))
            turned = seat.rotation % 180 != 0
            width, depth = (seat.depth, seat.width) if turned else (seat.width, seat.depth)
            own = (one.depth, one.width) if turned else (one.width, one.depth)
            assert abs(one.x - seat.x) <= (width - own[0]) / 2 + 1e-6
            assert abs(one.z - seat.z) <= (depth - own[1]) / 2 + 1e-6


def test_some_sit_and_some_stand() -> None:
    found = Counter(
        (one.kind, one.on is not None) for number in range(len(REQUESTS)) for scene in households(number) for one in scene.dynamic
    )
    assert min(found["person", True], found["person", False], found["dog", False], found["cat", False]) > 40
    assert set(found) == {("person", True), ("person", False), ("dog", False), ("cat", False)}


def test_one_sits_before_the_pillows_of_a_sofa_and_of_an_armchair() -> None:
    seats = {(one.on or "").rpartition("/")[2].rstrip("_123") for number in range(len(REQUESTS)) for scene in households(number)
             if any(room.decorations for room in scene.rooms) for one in scene.dynamic if one.on is not None}  # fmt: skip
    assert {"sofa", "armchair"} <= seats


def test_the_oracle_sees_who_blocks_the_way() -> None:
    """Put before a door, everybody is in the way: of the door, or of somebody."""
    scene = next(scene for scene in households(0) if scene.dynamic)
    one = scene.dynamic[0]
    room = next(room for room in scene.rooms if room.id == one.room)
    door = next(opening for opening in room.openings if opening.kind != "window")
    x, z = {
        "north": (door.position, 0.3), "south": (door.position, room.depth - 0.3),
        "west": (0.3, door.position), "east": (room.width - 0.3, door.position),
    }[door.wall or ""]  # fmt: skip
    moved = replace(scene, dynamic=(replace(one, x=x, z=z, y=0.0, on=None, width=0.5, depth=0.5, rotation=0),))
    assert any("square" in fault for fault in crossed(moved.dynamic[0], moved))
    assert door.id in out_of_reach(moved, room)
