"""Maps for Nav2, read as its map_server and costmap read them."""

from __future__ import annotations

import itertools
import json
import math
from functools import cache
from typing import Any

import numpy as np
import pytest

from catalogs import load_catalogs
from solver.exports import ExportSettings, describe, written_as
from solver.scene import Opening, Room, Scene
from tests.exports import homes
from tests.exports.readers.nav2 import RADIUS, parted_rooms, read_map


@cache
def written(name: str) -> dict[str, bytes]:
    return written_as(homes.described(name), ExportSettings("nav2"))


def document(name: str) -> Any:
    return json.loads(written(name)["rooms.json"])


@pytest.mark.parametrize("name", ["family", "default"])
def test_a_robot_reaches_the_middle_of_every_room(name: str) -> None:
    files = written(name)
    rooms = json.loads(files["rooms.json"])["rooms"]
    assert {room["id"] for room in rooms} == {room.id for room in homes.described(name).rooms}
    assert parted_rooms(files) == []
    assert all(room["clearance"] > RADIUS and room["reachable"] for room in rooms)
    assert parted_rooms(files, radius=0.6) != []


def test_each_cell_is_what_stands_there() -> None:
    grid = read_map(written("own"))
    for x, z in {(1.0, 3.4), (1.45, 2.95), (1.3, 3.4), (1.7, 2.85), (0.0, 0.5), (3.0, 0.0), (12.5, 1.6), (1.6, 0.0), (3.0, -3.0)}:
        assert grid.occupied[grid.cell(x, -z)], f"nothing at {x}, {z}"
    floor = {(1.7, 3.4), (0.6, 3.4), (1.45, 3.9), (0.0, 1.5), (6.0, 1.0), (10.0, 0.0), (1.2, 5.0), (3.0, -1.0), (4.7, 6.0), (2.6, 5.6)}
    for x, z in floor:
        assert grid.free[grid.cell(x, -z)], f"something at {x}, {z}"
    for x, z in {(5.9, -3.4), (8.0, 5.0), (0.4, -1.0)}:
        assert not grid.free[grid.cell(x, -z)] and not grid.occupied[grid.cell(x, -z)]


def test_a_turned_body_takes_the_cells_it_touches_and_no_more() -> None:
    """Every cell is tried at its corners and within, in the body's own frame."""
    grid = read_map(written("own"))
    thing = next(body for body in homes.described("own").bodies if body.id == "garage/thing_1")
    turn = math.radians(thing.turn)
    shares = np.linspace(0.0, 1.0, 41)
    row, column = grid.cell(thing.x, -thing.z)
    for i, j in itertools.product(range(row - 20, row + 20), range(column - 20, column + 20)):
        x = grid.origin[0] + (j + shares) * grid.resolution - thing.x
        z = -(grid.origin[1] + (i + shares[:, None]) * grid.resolution) - thing.z
        # A body's width runs along (cos, -sin) of x and z, its front looks along (sin, cos).
        aside, ahead = np.abs(math.cos(turn) * x - math.sin(turn) * z), np.abs(math.sin(turn) * x + math.cos(turn) * z)
        inside = ((aside < thing.width / 2) & (ahead < thing.depth / 2)).any()
        nearly = ((aside < thing.width / 2 + 0.002) & (ahead < thing.depth / 2 + 0.002)).any()
        assert inside == nearly == grid.occupied[i, j] or inside != nearly, (i, j)


def test_places_to_stand_face_what_they_are_for() -> None:
    model = homes.described("family")
    bodies = {body.id: body for body in model.bodies}
    poses = document("family")["poses"]
    assert len(poses) == sum(len(body.uses) for body in model.bodies) > 20
    for pose in poses:
        body, (x, y), yaw = bodies[pose["body"]], pose["position"], pose["yaw"]
        ahead = math.cos(yaw) * (body.x - x) + math.sin(yaw) * (-body.z - y)
        aside = abs(math.sin(yaw) * (body.x - x) - math.cos(yaw) * (-body.z - y))
        assert ahead > 0.4 and aside < 0.001, pose


def test_doors_say_where_they_lead_and_swing() -> None:
    doors = {door["id"]: door for door in document("own")["doors"]}
    assert len(doors) == 11
    front = doors["front"]
    assert (front["position"], front["rooms"], front["main_entrance"]) == ([0.0, -1.5], ["living", None], True)
    # Hinged at its northern end, its leaf closed points south; swung in it points east.
    assert front["hinge"][1] == pytest.approx(-1.06)
    assert (front["closed_yaw"], front["open_yaw"]) == (pytest.approx(-math.pi / 2), pytest.approx(0.0))
    assert "hinge" not in doors["passage"] and "hinge" not in doors["gate"]


def test_every_storey_has_a_map() -> None:
    files = written("storeys")
    assert sorted(files) == ["map.pgm", "map.yaml", "map_level_1.pgm", "map_level_1.yaml", "rooms.json"]
    below, above = read_map(files), read_map(files, "map_level_1.yaml")
    assert below.free.sum() < above.free.sum()
    assert below.occupied[below.cell(1.0, -1.1)] and above.occupied[above.cell(1.0, -1.1)]


def test_warnings_and_hostile_names_break_no_file() -> None:
    warning = 'out_of_bounds: a"b\n255 \u00fc # x'
    model = describe(homes.hostile(), load_catalogs(), warnings=[warning])
    files = written_as(model, ExportSettings("nav2"))
    plain = written("own")
    assert files["map.pgm"].count(b"\n# ") == 1 and files["map.yaml"].startswith(b"# out_of_bounds")
    assert np.array_equal(read_map(files).free, read_map(plain).free)
    said = json.loads(files["rooms.json"])
    assert said["warnings"] == [warning]
    assert {room["id"] for room in said["rooms"]} == {room.id for room in model.rooms}
    assert written_as(model, ExportSettings("nav2")) == files


def test_a_room_whose_lines_are_not_those_of_the_next_is_reached_through_its_door() -> None:
    """Of a foreign plan: two rooms 0.2 m apart; the map leads from one to the other, and so say the rooms."""
    door = Opening("door", wall="south", position=2.0, connects_to="porch")
    rooms = Room("hall", width=4.0, depth=3.0, openings=(door,)), Room("porch", 1, z=3.2, width=4.0, depth=2.0, outdoor=True)
    files = written_as(describe(Scene(wall_thickness=0.2, rooms=rooms), load_catalogs()), ExportSettings("nav2"))
    assert parted_rooms(files) == []
    assert [room["reachable"] for room in json.loads(files["rooms.json"])["rooms"]] == [True, True]
