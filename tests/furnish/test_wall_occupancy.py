"""WallOccupancy: clear stretches, worked out by hand and against a scan of the wall."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.furnish import WallOccupancy, space_of
from solver.geometry import Rect
from solver.scene import WALLS, Opening
from tests.furnish.worlds import DOOR, WINDOW, den


def occupancy(*openings: Opening) -> WallOccupancy:
    return WallOccupancy(space_of(den(*openings), 0.1))


def test_an_empty_wall_is_one_stretch() -> None:
    walls = occupancy()
    assert walls.stretches("north", 600, 2000) == [(50, 4950)]
    assert walls.stretches("east", 600, 2000) == [(50, 3950)]


def test_a_door_parts_its_own_wall_for_everything() -> None:
    assert occupancy(DOOR).stretches("south", 300, 200) == [(50, 2050), (2950, 4950)]


def test_a_window_parts_its_wall_for_tall_things_only() -> None:
    walls = occupancy(WINDOW)
    assert walls.stretches("north", 300, 1800) == [(50, 800), (2200, 4950)]
    assert walls.stretches("north", 300, 900) == [(50, 4950)]


def test_a_door_near_a_corner_blocks_the_wall_beside_it() -> None:
    walls = occupancy(Opening("d", "door", "south", 0.6, 0.9))
    assert walls.stretches("west", 600, 2000) == [(50, 3100)]
    assert walls.stretches("west", 60, 2000) == [(50, 3950)]


def test_what_is_occupied_parts_the_wall_and_the_walls_it_reaches() -> None:
    walls = occupancy()
    walls.occupy(Rect(80, 80, 1080, 680))
    assert walls.stretches("north", 300, 1800) == [(50, 80), (1080, 4950)]
    assert walls.stretches("west", 300, 1800) == [(50, 80), (680, 3950)]
    assert walls.stretches("south", 300, 1800) == [(50, 4950)]
    assert walls.stretches("north", 300, 1800, occupied=False) == [(50, 4950)]
    assert walls.occupied(Rect(1000, 600, 1200, 700)) and not walls.occupied(Rect(1080, 80, 1200, 700))


def test_a_gate_is_no_place_along_its_wall() -> None:
    walls = WallOccupancy(space_of(den(), 0.1), (Rect(1000, 50, 3400, 1050),))
    assert walls.stretches("north", 300, 800) == [(50, 1000), (3400, 4950)]


@pytest.mark.parametrize("wall", WALLS)
@given(
    doors=st.lists(st.tuples(st.sampled_from(WALLS), st.integers(5, 35), st.sampled_from(["door", "window", "passage"])), max_size=4),
    depth=st.integers(1, 20),
    height=st.sampled_from([500, 1800]),
)
def test_stretches_are_what_a_scan_finds(wall: str, doors: list[tuple[str, int, str]], depth: int, height: int) -> None:
    openings = [Opening(f"o{i}", kind, at, place / 10, 0.8, 2.0, 0.9 * (kind == "window")) for i, (at, place, kind) in enumerate(doors)]
    space = space_of(den(*openings), 0.1)
    stretches = WallOccupancy(space).stretches(wall, depth * 50, height)
    low, high = (50, 4950) if wall in ("north", "south") else (50, 3950)
    for middle in range(low + 25, high, 50):
        far = 50 + 30 + depth * 50
        x0, z0, x1, z1 = {
            "north": (middle - 1, 50, middle + 1, far),
            "south": (middle - 1, 4000 - far, middle + 1, 3950),
            "west": (50, middle - 1, far, middle + 1),
            "east": (5000 - far, middle - 1, 4950, middle + 1),
        }[wall]
        free = not any(z.above_mm < height and x0 < z.rect.x1 and z.rect.x0 < x1 and z0 < z.rect.z1 and z.rect.z0 < z1 for z in space.zones)
        assert free == any(a <= middle <= b for a, b in stretches)
