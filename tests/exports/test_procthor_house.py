"""ProcTHOR's house JSON, read by its frame and by its rules for walls and holes."""

from __future__ import annotations

import json
import math
from collections import Counter
from typing import Any

import pytest

from catalogs import load_catalogs
from solver.exports import ExportSettings, describe, written_as
from tests.exports import homes
from tests.exports.readers.procthor import house_of, objects_of


def house(name: str) -> Any:
    return house_of(written_as(homes.described(name), ExportSettings("procthor")))


def test_north_is_up_and_yaw_is_clockwise() -> None:
    """A chair that faces the table to its north, and an armchair turned by 30 degrees towards the west of south."""
    objects = {one["id"]: one for one in objects_of(house("own")["objects"])}
    chair, table, armchair = (objects[f"living/{name}_1"] for name in ("dining_chair", "dining_table", "armchair"))
    assert table["position"]["z"] > chair["position"]["z"] and chair["rotation"]["y"] == 0
    assert armchair["rotation"]["y"] == 210
    facing = math.sin(math.radians(210)), math.cos(math.radians(210))
    assert facing[0] < 0 and facing[1] < 0
    assert [one["id"] for one in table["children"]] == ["living/vase_1"]


def _right_of(wall: dict[str, Any]) -> tuple[float, float]:
    """A point half a metre before a wall's middle, on the right of who walks from its first corner to its second, seen from above."""
    a, b = wall["polygon"][:2]
    length = math.dist((a["x"], a["z"]), (b["x"], b["z"]))
    east, north = (b["x"] - a["x"]) / length, (b["z"] - a["z"]) / length
    return (a["x"] + b["x"]) / 2 + 0.2 * north, (a["z"] + b["z"]) / 2 - 0.2 * east


@pytest.mark.parametrize("name", ["own", "family", "default"])
def test_walls_are_seen_from_their_rooms(name: str) -> None:
    model = homes.described(name)
    found = house(name)
    assert Counter(wall["id"] for wall in found["walls"]).most_common(1)[0][1] == 1
    rooms = {room.id: room for room in model.rooms}
    for wall in found["walls"]:
        heights = [corner["y"] for corner in wall["polygon"]]
        assert heights[0] == heights[1] < heights[2] == heights[3]
        x, north = _right_of(wall)
        room = rooms[wall["roomId"]]
        inside = _holds(room.corners, x, -north)
        assert inside != wall["id"].startswith("wall|exterior|"), wall["id"]


def _holds(corners: tuple[tuple[float, float], ...], x: float, z: float) -> bool:
    pairs = zip(corners, (*corners[1:], corners[0]), strict=True)
    return sum(a[0] == b[0] > x and min(a[1], b[1]) < z < max(a[1], b[1]) for a, b in pairs) % 2 == 1


@pytest.mark.parametrize("name", ["own", "family", "default"])
def test_a_wall_has_one_hole_where_its_opening_is(name: str) -> None:
    model = homes.described(name)
    found = house(name)
    walls = {wall["id"]: wall for wall in found["walls"]}
    holes = [*found["doors"], *found["windows"]]
    assert max(Counter(wall for hole in holes for wall in (hole["wall0"], hole["wall1"])).values()) == 1
    openings = {one.id: one for one in model.openings}
    assert {hole["id"] for hole in holes} == set(openings)
    for hole in holes:
        one = openings[hole["id"]]
        a, b = walls[hole["wall0"]]["polygon"][:2]
        length = math.dist((a["x"], a["z"]), (b["x"], b["z"]))
        low, high = hole["holePolygon"]
        assert -1e-6 <= low["x"] < high["x"] <= length + 1e-6
        share = (low["x"] + high["x"]) / 2 / length
        x, z = a["x"] + share * (b["x"] - a["x"]), -(a["z"] + share * (b["z"] - a["z"]))
        middle = (one.start + one.end) / 2
        assert (x, z) == pytest.approx((middle, one.line) if one.axis == "x" else (one.line, middle), abs=1e-3)
        assert (low["y"], high["y"]) == pytest.approx((one.sill, one.head))
        rooms = {hole["room0"], hole["room1"]}
        assert rooms == {room for room in one.rooms if room} or (one.kind == "window" and rooms <= set(one.rooms))


def test_the_agent_looks_into_the_house() -> None:
    agent = house("own")["metadata"]["agent"]
    assert agent["position"] == {"x": 0.5, "y": 0.95, "z": -1.5}
    assert agent["rotation"]["y"] == 90.0
    assert house("own")["metadata"]["schema"] == "1.0.0"


def test_warnings_are_inside() -> None:
    model = describe(homes.own(), load_catalogs(), warnings=['a "b"'])
    (content,) = written_as(model, ExportSettings("procthor")).values()
    assert json.loads(content)["metadata"]["compose"]["warnings"] == ['a "b"']
