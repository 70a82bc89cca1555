"""A scene dataset for Habitat: every file that is named is there, and things are where the description has them."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from solver.exports import ExportSettings, written_as
from solver.exports.model import HouseModel
from tests.exports import homes
from tests.exports.readers.habitat import bounds_of, instances_of


def written(model: HouseModel) -> dict[str, bytes]:
    return written_as(model, ExportSettings("habitat"))


@pytest.mark.parametrize("name", ["own", "hostile", "storeys"])
def test_every_named_file_is_there(name: str) -> None:
    files = written(homes.described(name))
    (main,) = (file for file in files if file.endswith(".scene_dataset_config.json"))
    (folder,) = json.loads(files[main])["stages"]["paths"][".json"]
    (stage,) = (file for file in files if file.startswith(f"{folder}/") and file.endswith(".stage_config.json"))
    assert f"{folder}/{json.loads(files[stage])['render_asset']}" in files
    for one in instances_of(files):
        assert f"{one['template_name']}.object_config.json" in files
    assert all(part not in ("", ".", "..") for file in files for part in file.split("/"))
    numbers = {one["id"] for one in json.loads(files["semantic_lexicon.json"])["classes"]}
    assert numbers == {json.loads(text)["semantic_id"] for file, text in files.items() if file.endswith(".object_config.json")}


def test_geometry_stands_in_its_box() -> None:
    """Around the middle of the footprint, from the underside up; furniture that the catalogs do not know fills its box."""
    model = homes.described("own")
    files = written(model)
    bodies = {body.id: body for body in model.bodies}
    for one in instances_of(files):
        if body := bodies.get(one["user_defined"]["id"]):
            (low, high), _ = bounds_of(files, one["template_name"])
            limit = np.array([body.width / 2, body.height, body.depth / 2])
            assert (high <= limit + 1e-6).all() and (low >= np.array([-body.width / 2, 0.0, -body.depth / 2]) - 1e-6).all()
            assert body.kind or high == pytest.approx(limit, abs=1e-6)


def test_doors_stand_open_at_their_hinges() -> None:
    model = homes.described("own")
    leaves = {one["user_defined"]["id"]: one for one in instances_of(written(model)) if one["user_defined"]["sort"] == "leaf"}
    assert set(leaves) == {leaf.id for leaf in model.leaves}
    front = leaves["front"]
    # Hinged at its northern end, opened in, to the east: its middle is half a leaf east of the hinge.
    assert front["translation"] == pytest.approx([0.44 + 0.03, 0.01, 1.06], abs=0.01)
    w, _, turn, _ = front["rotation"]
    assert math.degrees(2 * math.atan2(turn, w)) % 360 == pytest.approx(0.0, abs=1e-6)


def test_what_is_free_may_move() -> None:
    motions = {one["user_defined"]["id"]: one["motion_type"] for one in instances_of(written(homes.described("own")))}
    assert (motions["bed/bed_1"], motions["living/vase_1"], motions["cat_1"], motions["front"]) == (
        "STATIC",
        "DYNAMIC",
        "KINEMATIC",
        "KINEMATIC",
    )
