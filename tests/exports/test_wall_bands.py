"""Walls of different thickness: rooms' floors are clear of them, and all that lies right behind a face is wall."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from catalogs import load_catalogs
from compose_homes import load, validate
from solver.errors import FieldError
from solver.exports import HouseModel, describe
from solver.scene import Room, Scene
from tests.exports.test_page_agrees import THICK_WALLS

SLIGHT = 0.001


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load(THICK_WALLS)


@pytest.fixture(scope="module")
def model(scene: Scene) -> HouseModel:
    return describe(scene, load_catalogs())


def in_wall(model: HouseModel, x: float, z: float) -> bool:
    for panel in model.panels:
        along, across = (x, z) if panel.axis == "x" else (z, x)
        if panel.start <= along <= panel.end and abs(across - panel.line) <= panel.thickness / 2:
            return True
    return False


def around(room: Room, half: float, away: float) -> Iterator[tuple[float, float]]:
    """Yields points along a room's faces, `away` behind them, m."""
    corners = room.outline or ((0.0, 0.0), (room.width, 0.0), (room.width, room.depth), (0.0, room.depth))
    for (x0, z0), (x1, z1) in zip(corners, (*corners[1:], corners[0]), strict=True):
        length = abs(x1 - x0) + abs(z1 - z0)
        ex, ez = (x1 - x0) / length, (z1 - z0) / length
        steps = int((length - 2 * half) / 0.02) - 1
        for step in range(steps + 1):
            at = half + 0.01 + step * 0.02
            yield room.x + x0 + ex * at - ez * (half - away), room.z + z0 + ez * at + ex * (half - away)


def test_all_behind_a_face_is_wall_and_all_before_it_is_clear(scene: Scene, model: HouseModel) -> None:
    assert validate(scene) == ()
    for room in scene.rooms:
        assert all(in_wall(model, x, z) for x, z in around(room, scene.wall_thickness / 2, SLIGHT))
        assert not any(in_wall(model, x, z) for x, z in around(room, scene.wall_thickness / 2, -SLIGHT))


def test_a_wall_is_as_thick_as_it_says_or_as_the_faces_lie_apart(model: HouseModel) -> None:
    drawn = {(panel.axis, round(panel.line, 4)): panel.thickness for panel in model.panels}
    assert drawn == {
        ("x", -0.15): 0.4, ("z", 6.4): 0.4, ("x", 8.29): 0.4, ("z", 8.4): 0.4, ("x", 4.99): 0.4,  # outer walls that say so
        ("z", -0.13): 0.36, ("z", -0.05): 0.2,
        ("z", 3.125): 0.35, ("x", 4.07): 0.24,  # between rooms
    }  # fmt: skip


def test_both_rooms_of_a_door_see_it_in_the_middle_of_their_wall(model: HouseModel) -> None:
    openings = {one.id: one for one in model.openings}
    assert (openings["ab"].line, openings["ab"].thickness, set(openings["ab"].rooms)) == (3.125, 0.35, {"a", "b"})
    assert (openings["bc"].line, openings["bc"].thickness, set(openings["bc"].rooms)) == (4.07, 0.24, {"b", "c"})
    assert (openings["front"].line, openings["front"].thickness, openings["front"].rooms) == (-0.15, 0.4, ("a", None))


def test_corners_of_outer_walls_are_filled(model: HouseModel) -> None:
    assert all(in_wall(model, x, z) for x, z in ((-0.3, -0.34), (6.59, -0.34), (8.59, 8.48), (6.21, 5.18), (8.59, 4.8)))


def test_more_numbers_than_lines_are_refused() -> None:
    with pytest.raises(FieldError, match="wall_thickness"):
        load("rooms: [{width: 4, depth: 4, wall_thickness: [0.4, 0.4, 0.4, 0.4, 0.4]}]\n")
