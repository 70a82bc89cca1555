"""Boxes for training, read as ATISS's cached dataset reads them."""

from __future__ import annotations

import json
import math
from functools import cache

import numpy as np
import pytest

from solver.exports import ExportSettings, written_as
from tests.exports import homes
from tests.exports.readers.boxes import rooms_of


@cache
def written(name: str) -> dict[str, bytes]:
    return written_as(homes.described(name), ExportSettings("boxes"))


def test_a_room_has_what_the_loader_asks_for() -> None:
    files = written("own")
    room = rooms_of(files)["house_living"]
    assert set(room) >= {"scene_id", "scene_uid", "scene_type", "json_path", "room_layout", "floor_plan_vertices", "floor_plan_faces"}
    assert (str(room["scene_id"]), str(room["scene_uid"]), str(room["scene_type"])) == ("living", "house_living", "living_room")
    assert float(room["room_side"]) == 6.1
    assert room["room_layout"].shape == (256, 256, 1) and room["room_layout"].dtype == np.uint8
    assert [room[key].dtype for key in ("class_labels", "translations", "sizes", "angles")] == [np.float32] * 4
    assert room["floor_plan_centroid"].tolist() == [3.0, 0.0, 2.5]
    assert all(folder.count("_") == 1 for folder in rooms_of(files))


def test_the_floor_is_the_rooms_and_looks_up() -> None:
    room = rooms_of(written("own"))["house_living"]
    a, b, c = (room["floor_plan_vertices"][room["floor_plan_faces"][:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    assert (normals[:, 1] > 0).all()
    assert normals[:, 1].sum() / 2 == pytest.approx(25.0)


def test_the_layout_shows_the_floor_from_above_north_at_the_top() -> None:
    room = rooms_of(written("own"))["house_living"]
    mask = room["room_layout"][:, :, 0]
    metres = 2 * float(room["room_side"]) / 256
    assert (mask > 0).sum() * metres**2 == pytest.approx(25.0, abs=0.3)
    for x, z, inside in ((5.9, 0.1, True), (0.1, 4.9, True), (5.9, 4.9, False), (3.6, 3.1, False), (3.4, 4.9, True), (6.1, 0.1, False)):
        row, column = (int((at + float(room["room_side"])) / metres) for at in (z - 2.5, x - 3.0))
        assert (mask[row, column] > 0) == inside, (x, z)


def test_statistics_hold_every_box() -> None:
    files = written("family")
    said = json.loads(files["dataset_stats.txt"])
    rooms = rooms_of(files).values()
    for key in ("translations", "sizes", "angles"):
        rows = np.concatenate([room[key] for room in rooms])
        assert said[f"bounds_{key}"] == pytest.approx([*rows.min(axis=0), *rows.max(axis=0)], abs=1e-5)
    assert said["class_labels"][-2:] == ["start", "end"]
    assert sum(said["count_furniture"].values()) == sum(len(room["uids"]) for room in rooms)
    assert sum(said["class_frequencies"].values()) == pytest.approx(1.0, abs=1e-4)
    assert list(said["class_order"]) == list(said["count_furniture"])
    assert -math.pi - 1e-6 <= said["bounds_angles"][0] <= said["bounds_angles"][1] < math.pi


def test_classes_are_the_same_for_every_house() -> None:
    one, other = (json.loads(written(name)["dataset_stats.txt"])["object_types"] for name in ("family", "storeys"))
    assert one == other and len(one) > 100


def test_the_same_house_is_the_same_bytes() -> None:
    assert written_as(homes.described("own"), ExportSettings("boxes")) == written("own")
    assert written("hostile").keys() == {name for name in written("hostile") if ".." not in name and not name.startswith("/")}
