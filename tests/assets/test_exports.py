"""Exports that show assets: what is in them, where, how large; and who is named for it."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np
import pytest
import trimesh

from catalogs import Catalogs, add_assets, load_catalogs
from compose_homes import Decoration, Flooring, Furniture, RequestError, Room, Scene, export
from solver.export_formats import EXPORTERS
from tests.architecture.tree import ROOT
from tests.assets.makers import folder, shape, textured, under
from tests.exports.readers.glb import document, scene_of

MM = 0.001
SIZE = (2.0, 0.95, 0.8)
FRONTS = {"+z": [0, 0, 0, 1], "+x": [0, 0.5**0.5, 0, 0.5**0.5], "-z": [0, 1, 0, 0], "-x": [0, -(0.5**0.5), 0, 0.5**0.5]}
"""The turns that bring a front from +z to where it shall look in the file."""


@cache
def house() -> tuple[Scene, Catalogs]:
    """A room with an asset of each front, one of them twice and in centimetres, and a vase on a table of our own shape."""
    files = {
        f"sofa{front}.glb": under(shape("sofa"), rotation=turn, translation=[3, 1, -2], scale=[100] * 3) for front, turn in FRONTS.items()
    }
    entries: dict[str, dict[str, object]] = {
        f"sofa_{number}": {
            "file": f"sofa{front}.glb",
            "kinds": ["sofa"],
            "front": front,
            "license": "CC-BY-4.0",
            "author": "Ann",
            "source": "a shop",
        }
        for number, front in enumerate(FRONTS)
    }
    files["vase.glb"] = shape("vase")
    entries["vase"] = {"file": "vase.glb", "kinds": ["vase"], "license": "CC0-1.0", "mass": 3.0}
    known = add_assets(load_catalogs(), folder(Path(mkdtemp()), files, entries))
    width, depth, height = SIZE
    sofas = tuple(
        Furniture(
            f"sofa/{n}",
            "sofa",
            x=1.5 + 2.5 * n,
            z=2,
            rotation=30 * n,
            width=width,
            depth=depth,
            height=height,
            kind="sofa",
            asset=f"sofa_{n % 4}",
        )
        for n in range(5)
    )
    table = Furniture("table", "dining_table", x=2, z=5, width=1.6, depth=0.9, height=0.75, kind="dining_table")
    size = load_catalogs().decorations["vase"].size
    vase = Decoration("vase", "vase", "table", x=2, y=0.75, z=5, width=size[0], depth=size[1], height=size[2], kind="vase", asset="vase")
    room = Room("den", type="living_room", width=14, depth=7, flooring=Flooring(), furniture=(*sofas, table), decorations=(vase,))
    return Scene(seed=3, rooms=(room,)), known


@cache
def files(format: str) -> dict[str, bytes]:
    scene, known = house()
    return export(scene, format, catalogs=known)


def corners(scene: trimesh.Scene, name: str) -> Any:
    """The points of all that hangs below a node, in the house."""
    below = {name} | {child for child in scene.graph.nodes if name in scene.graph.transforms.shortest_path("world", child)}
    found = []
    for child in below & set(scene.graph.nodes_geometry):
        place, mesh = scene.graph[child]
        found.append(trimesh.transform_points(scene.geometry[mesh].vertices, place))
    return np.concatenate(found)


def test_assets_fill_the_boxes_of_their_bodies_in_glb() -> None:
    """As our own shapes do, whatever the asset's unit, front and place in its file were."""
    scene, _ = house()
    bare = replace(
        scene, rooms=tuple(replace(room, furniture=tuple(replace(piece, asset=None) for piece in room.furniture)) for room in scene.rooms)
    )
    shown, plain = scene_of(files("glb")["house_3.glb"]), scene_of(export(bare, "glb")["house_3.glb"])
    for number in range(5):
        ours, theirs = corners(plain, f"sofa/{number}"), corners(shown, f"sofa/{number}")
        assert len(ours) == len(theirs)
        ours, theirs = (points[np.lexsort(np.round(points, 3).T)] for points in (ours, theirs))
        assert np.allclose([ours.min(0), ours.max(0)], [theirs.min(0), theirs.max(0)], atol=3 * MM)


def test_a_mesh_is_copied_once() -> None:
    text = document(files("glb")["house_3.glb"])
    nodes = {node.get("name"): node for node in text["nodes"]}

    def mesh(number: int) -> int:
        node = nodes[f"sofa/{number}"]
        while "mesh" not in node:
            (child,) = node["children"]
            node = text["nodes"][child]
        return int(node["mesh"])

    assert mesh(0) == mesh(4)
    assert len({mesh(number) for number in range(4)}) == 4
    scene, known = house()
    (vase,) = scene.rooms[0].decorations
    share = vase.width * vase.depth * vase.height / math.prod(known.assets["vase"].size)
    assert nodes["vase"]["extras"]["mass"] == pytest.approx(3.0 * share, rel=0.001)


def test_khronos_validator_finds_nothing(tmp_path: Path) -> None:
    _, known = house()
    at = folder(tmp_path / "own", {"a.glb": textured(shape("sofa"))}, {"a": {"file": "a.glb", "kinds": ["sofa"], "license": "MIT"}})
    sofa = Furniture("s", "sofa", x=2, z=2, width=2.2, depth=0.9, height=0.85)
    one = export(Scene(rooms=(Room("den", width=5, depth=5, furniture=(sofa,)),)), "glb", catalogs=add_assets(known, at))
    assert "textures" in document(one["house.glb"])
    paths = [tmp_path / "many.glb", tmp_path / "one.glb"]
    for path, content in zip(paths, (files("glb")["house_3.glb"], one["house.glb"]), strict=True):
        path.write_bytes(content)
    report = tmp_path / "report.json"
    command = [sys.executable, str(ROOT / "scripts" / "page.py"), "validate-glb", str(report), *map(str, paths)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    found = [message for judged in json.loads(report.read_text()) for message in judged["issues"]["messages"]]
    assert found == []


@pytest.mark.parametrize("format", EXPORTERS)
def test_who_made_what_is_shown_is_named(format: str) -> None:
    shows = EXPORTERS[format].shows_assets
    assert ("CREDITS.txt" in files(format)) is shows
    if shows:
        words = files(format)["CREDITS.txt"].decode()
        assert "sofa_2 by Ann: CC-BY-4.0, a shop\n" in words
        assert "vase: CC0-1.0\n" in words
        assert export(house()[0], format, catalogs=house()[1]) == files(format)


def test_a_file_that_changed_since_is_refused(tmp_path: Path) -> None:
    known = add_assets(
        load_catalogs(), folder(tmp_path, {"a.glb": shape("sofa")}, {"a": {"file": "a.glb", "kinds": ["sofa"], "license": "MIT"}})
    )
    sofa = Furniture("s", "sofa", x=2, z=2, width=2.2, depth=0.9, height=0.85)
    scene = Scene(rooms=(Room("den", width=5, depth=5, furniture=(sofa,)),))
    assert "CREDITS.txt" in export(scene, "glb", catalogs=known)
    for content in (shape("armchair"), b"", None):
        (tmp_path / "a.glb").unlink()
        if content is not None:
            (tmp_path / "a.glb").write_bytes(content)
        with pytest.raises(RequestError, match="assets"):
            export(scene, "glb", catalogs=known)
