"""Rectangles and walls: distances, strips and turns agree with one another."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.geometry import (
    OPPOSITE,
    ROTATION_AT_WALL,
    Rect,
    extents,
    gaps_between,
    rotate,
    strip,
    strip_at,
    wall_faced,
    wall_turned,
    walls_beside,
    walls_round,
)
from solver.scene import WALLS

ROOM = Rect(50, 50, 4050, 3050)
BODY = Rect(1000, 500, 2000, 900)


def test_distances_to_the_walls_of_a_room() -> None:
    assert {wall: BODY.wall_distance(wall, ROOM) for wall in WALLS} == {"north": 450, "south": 2150, "west": 950, "east": 2050}
    assert Rect(0, 100, 10, 200).wall_distance("west", ROOM) == -50, "beyond the wall"


@pytest.mark.parametrize("wall", WALLS)
def test_a_strip_lies_at_its_wall_and_is_as_deep_as_asked(wall: str) -> None:
    made = strip(ROOM, wall, (700, 900), 300)
    assert made.along(wall) == (700, 900)
    assert made.line(wall) == ROOM.line(wall)
    assert made.wall_distance(OPPOSITE[wall], ROOM) == ROOM.wall_distance(OPPOSITE[wall], strip(ROOM, wall, (0, 0), 300)) * -1
    assert made == strip_at(wall, ROOM.line(wall), (700, 900), 300)


def test_distances_of_points_and_rectangles() -> None:
    assert BODY.distance_to(Rect(1500, 700, 1500, 700)) == 0
    assert BODY.distance_to(Rect(997, 496, 997, 496)) == 5
    assert BODY.distance_to(Rect(2003, 904, 2100, 1000)) == 5
    assert BODY.distance_to(Rect(2000, 500, 2100, 1000)) == 0, "touching"


def test_rectangles_shifted_and_shared() -> None:
    assert BODY.moved(10, -20) == Rect(1010, 480, 2010, 880)
    assert BODY.common(ROOM) == BODY
    assert BODY.common(Rect(3000, 0, 3100, 100)).width < 0
    assert BODY.centre == (1500, 700)
    assert Rect.around(BODY.centre, (BODY.width, BODY.depth)) == BODY


@pytest.mark.parametrize("wall", WALLS)
def test_walls_turn_as_bodies_do(wall: str) -> None:
    faced = wall_faced("front", ROTATION_AT_WALL[wall])
    assert faced == OPPOSITE[wall]
    assert wall_turned(wall, 180) == OPPOSITE[wall]
    assert wall_turned(wall_turned(wall, 90), 270) == wall
    assert set(walls_beside(wall)) == set(WALLS) - {wall, OPPOSITE[wall]}
    across, along = rotate(0, 1, ROTATION_AT_WALL[wall])
    assert BODY.moved(across, along).wall_distance(wall, ROOM) == BODY.wall_distance(wall, ROOM) + 1, "its front leads away"


def test_extents_are_exact_at_right_angles_and_the_bounds_elsewhere() -> None:
    assert [extents(3, 1, turn) for turn in (0, 90, 180, 270, -90)] == [(3, 1), (1, 3), (3, 1), (1, 3), (1, 3)]
    assert extents(1, 1, 45) == pytest.approx((2**0.5, 2**0.5))
    assert extents(3, 1, -30) == pytest.approx(extents(3, 1, 150))


@given(
    st.tuples(st.integers(-20, 20), st.integers(-20, 20)).map(sorted),
    st.lists(st.tuples(st.integers(-25, 25), st.integers(-25, 25)).map(sorted)),
)
def test_gaps_are_what_no_interval_covers(whole: list[int], blocked: list[list[int]]) -> None:
    found = gaps_between((whole[0], whole[1]), [(a, b) for a, b in blocked])
    free = [at for at in range(*whole) if not any(a <= at < b for a, b in blocked)]
    assert [at for start, end in found for at in range(start, end)] == free
    assert all(start < end for start, end in found)
    assert all(end <= start for (_, end), (start, _) in pairwise(found))


def test_the_walls_round_a_floor_are_the_same_whichever_way_its_corners_go() -> None:
    corners = [(0, 0), (5, 0), (5, 2), (3, 2), (3, 4), (0, 4)]
    walls = {("north", 0, 0, 5), ("east", 5, 0, 2), ("south", 2, 3, 5), ("east", 3, 2, 4), ("south", 4, 0, 3), ("west", 0, 0, 4)}
    assert set(walls_round(corners)) == set(walls_round(corners[::-1])) == walls
    assert [wall for wall, *_ in walls_round(corners)] == ["north", "east", "south", "east", "south", "west"]
