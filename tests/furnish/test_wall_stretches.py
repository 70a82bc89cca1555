"""Clear stretches of walls, worked out by hand and against a scan of the wall."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.furnish import space_of
from solver.pieces import Candidate, Piece, Space
from solver.placement import arrange
from solver.scene import WALLS, Opening
from tests.furnish.worlds import DOOR, WINDOW, ask, box_of, den, piece


def longest(wall: str, space: Space, depth_mm: int, height_mm: int) -> int:
    """How long the longest free stretch of a wall is said to be, cm, for what is too wide for any."""
    way = Candidate("shelf", (9000, depth_mm, height_mm), 0, "north", (0, 0))
    ((_, why),) = arrange(space, [Piece("shelf_1", True, (way,))]).arrangement.left_out
    told = re.search(rf"{wall} (\d+)\.(\d\d) m", why)
    assert told is not None
    return int(told[1] + told[2])


def stretch(wall: str, depth_mm: int, height_mm: int, *openings: Opening) -> int:
    return longest(wall, space_of(den(*openings), 0.1), depth_mm, height_mm)


def test_an_empty_wall_is_one_stretch() -> None:
    assert stretch("north", 600, 2000) == 490
    assert stretch("east", 600, 2000) == 390


def test_a_door_parts_its_own_wall_for_everything() -> None:
    assert stretch("south", 300, 200, DOOR) == 200


def test_a_window_parts_its_wall_for_tall_things_only() -> None:
    assert stretch("north", 300, 1800, WINDOW) == 275
    assert stretch("north", 300, 900, WINDOW) == 490


def test_a_door_near_a_corner_blocks_the_wall_beside_it() -> None:
    door = Opening("d", "door", "south", 0.6, 0.9)
    assert stretch("west", 600, 2000, door) == 305
    assert stretch("west", 60, 2000, door) == 390


def test_a_second_piece_is_wished_clear_of_where_the_first_is_meant_to_stand() -> None:
    first, second = ask(den(), piece("shelf"), piece("couch"))
    west, north, east, south = box_of(min(first.candidates, key=lambda one: one.cost))
    boxes = [box_of(one) for one in second.candidates]
    assert boxes
    assert not any(box[0] < east and west < box[2] and box[1] < south and north < box[3] for box in boxes)


def test_a_gate_is_no_place_along_its_wall() -> None:
    gate = Opening("g", "garage_door", "north", 2.2, 2.4)
    (shelf,) = ask(den(gate), piece("shelf"))
    at_gate = [box_of(one) for one in shelf.candidates if one.wall == "north"]
    assert at_gate
    assert all(box[2] <= 1000 or box[0] >= 3400 for box in at_gate)


@pytest.mark.parametrize("wall", WALLS)
@given(
    doors=st.lists(st.tuples(st.sampled_from(WALLS), st.integers(5, 35), st.sampled_from(["door", "window", "passage"])), max_size=4),
    depth=st.integers(1, 20),
    height=st.sampled_from([500, 1800]),
)
def test_stretches_are_what_a_scan_finds(wall: str, doors: list[tuple[str, int, str]], depth: int, height: int) -> None:
    openings = [Opening(f"o{i}", kind, at, place / 10, 0.8, 2.0, 0.9 * (kind == "window")) for i, (at, place, kind) in enumerate(doors)]
    space = space_of(den(*openings), 0.1)
    low, high = (50, 4950) if wall in ("north", "south") else (50, 3950)
    most = run = 0
    for middle in range(low + 25, high, 50):
        far = 50 + 30 + depth * 50
        x0, z0, x1, z1 = {
            "north": (middle - 1, 50, middle + 1, far),
            "south": (middle - 1, 4000 - far, middle + 1, 3950),
            "west": (50, middle - 1, far, middle + 1),
            "east": (5000 - far, middle - 1, 4950, middle + 1),
        }[wall]
        free = not any(z.above_mm < height and x0 < z.rect.x1 and z.rect.x0 < x1 and z0 < z.rect.z1 and z.rect.z0 < z1 for z in space.zones)
        run = run + 5 if free else 0
        most = max(most, run)
    assert longest(wall, space, depth * 50, height) == most
