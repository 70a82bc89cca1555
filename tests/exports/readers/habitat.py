"""Reads a scene dataset as Habitat does: templates by name, their GLBs with trimesh, rotations w first."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from tests.exports.readers import Seen


def instances_of(files: Mapping[str, bytes]) -> list[dict[str, Any]]:
    """The objects of the only scene."""
    (name,) = (name for name in files if name.endswith(".scene_instance.json"))
    scene = json.loads(files[name])
    assert scene["translation_origin"] == "asset_local"
    found: list[dict[str, Any]] = scene["object_instances"]
    return found


def bounds_of(files: Mapping[str, bytes], template: str) -> Any:
    """The least and greatest corner of a template's geometry, and what its configuration says."""
    says = json.loads(files[f"{template}.object_config.json"])
    assert (says["up"], says["front"]) == ([0, 1, 0], [0, 0, -1])
    asset = f"{template.rsplit('/', 1)[0]}/{says['render_asset']}"
    import trimesh

    scene: Any = trimesh.load(io.BytesIO(files[asset]), file_type="glb")
    return np.array(scene.bounds), says


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies; sizes from what we say beside the schema, as shapes need not fill their boxes."""
    found = {}
    for one in instances_of(files):
        says = one["user_defined"]
        if says["sort"] == "leaf":
            continue
        w, _, turn, _ = one["rotation"]
        x, y, z = one["translation"]
        width, height, depth = says["size"]
        mass = json.loads(files[f"{one['template_name']}.object_config.json"])["mass"]
        found[says["id"]] = Seen(x, y, z, math.degrees(2 * math.atan2(turn, w)) % 360, width, depth, height, mass)
    return found
