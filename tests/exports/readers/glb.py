"""Reads a .glb as trimesh does; ids and masses are in the nodes' extras, which trimesh leaves out: those by the standard's JSON."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from tests.exports.readers import Seen


def document(content: bytes) -> dict[str, Any]:
    """The JSON of a .glb."""
    length = int.from_bytes(content[12:16], "little")
    read: dict[str, Any] = json.loads(content[20 : 20 + length])
    return read


def scene_of(content: bytes) -> Any:
    """The scene as trimesh has it."""
    import trimesh

    return trimesh.load_scene(io.BytesIO(content), file_type="glb")


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    """The bodies of a house, by their ids; the scale of its node, or of the shape below it, is a body's size."""
    (content,) = files.values()
    nodes = document(content)["nodes"]
    graph = scene_of(content).graph
    found: dict[str, Seen] = {}
    for node in nodes:
        if "sort" not in node.get("extras", {}):
            continue
        at = np.asarray(graph.get(node["name"])[0])
        shown = next((nodes[child]["name"] for child in node.get("children", ()) if "mesh" in nodes[child]), node["name"])
        width, height, depth = np.linalg.norm(np.asarray(graph.get(shown)[0])[:3, :3], axis=0)
        turn = math.degrees(math.atan2(at[0, 2], at[2, 2]))
        x, y, z = at[:3, 3].tolist()
        found[node["extras"]["id"]] = Seen(x, y, z, turn % 360, width, depth, height, node["extras"]["mass"])
    return found
