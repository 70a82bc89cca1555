"""Exports that show assets: what is in them, where, how large; and who is named for it."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
from pxr import Usd, UsdGeom, UsdPhysics

from catalogs import Catalogs, add_assets, load_catalogs
from compose_homes import Decoration, Flooring, Furniture, RequestError, Room, Scene, export
from solver.export_formats import EXPORTERS
from tests.architecture.tree import ROOT
from tests.assets.makers import folder, kept_folder, shape, textured, under
from tests.exports.readers.glb import document, scene_of
from tests.exports.readers.mujoco_bodies import seen
from tests.exports.readers.usd import findings

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
    known = add_assets(load_catalogs(), kept_folder(files, entries))
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


def corners(scene: Any, name: str) -> Any:
    """The points of all that hangs below a node, in the house."""
    import trimesh

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


def plain(format: str) -> dict[str, bytes]:
    """The same house, shown as our shapes."""
    scene, _ = house()
    return export(scene, format)


def extents(text: bytes, stretch: list[float]) -> Any:
    """The least and the greatest point of an OBJ file that is stretched."""
    points = np.array([line.split()[1:] for line in text.decode().splitlines() if line.startswith("v ")], dtype=float)
    return np.array([points.min(0), points.max(0)]) * stretch


def test_mujoco_shows_assets_in_their_boxes_and_collides_as_before() -> None:
    names = {name: content for name, content in files("mjcf").items() if name != "CREDITS.txt"}
    shown = mujoco.MjModel.from_xml_string(names.pop("house_3.xml").decode(), names)
    ours = mujoco.MjModel.from_xml_string(plain("mjcf")["house_3.xml"].decode())
    colliding = [
        [
            (world.geom_bodyid[geom], *world.geom_size[geom], *world.geom_pos[geom])
            for geom in range(world.ngeom)
            if world.geom_group[geom] == 3
        ]
        for world in (shown, ours)
    ]
    assert np.allclose(colliding[0], colliding[1])
    states = [mujoco.MjData(world) for world in (shown, ours)]
    for world, state in zip((shown, ours), states, strict=True):
        mujoco.mj_forward(world, state)
    for number in range(5):
        bodies = [mujoco.mj_name2id(world, mujoco.mjtObj.mjOBJ_BODY, f"sofa/{number}") for world in (shown, ours)]
        one, other = (seen(world, state, body, 2) for world, state, body in zip((shown, ours), states, bodies, strict=True))
        assert (one.width, one.depth, one.height) == pytest.approx((other.width, other.depth, other.height), abs=2 * MM)
        assert (one.x, one.y, one.z, one.turn, one.mass) == pytest.approx((other.x, other.y, other.z, other.turn, other.mass))


def test_sdf_shows_assets_in_their_boxes_and_collides_as_before() -> None:
    written = files("sdf")
    worlds = [ElementTree.fromstring(one["house_3.sdf"]) for one in (written, plain("sdf"))]
    models = [{model.get("name"): model for model in world.iter("model")} for world in worlds]
    for number in range(5):
        shown, ours = (one[f"sofa/{number}"] for one in models)
        assert [ElementTree.tostring(one) for one in shown.iter("collision")] == [
            ElementTree.tostring(one) for one in ours.iter("collision")
        ]
        meshes = [mesh for visual in shown.iter("visual") for mesh in visual.iter("mesh")]
        spans = [
            extents(written[mesh.findtext("uri", "")], [float(word) for word in mesh.findtext("scale", "").split()]) for mesh in meshes
        ]
        low, high = np.min([one for one, _ in spans], axis=0), np.max([one for _, one in spans], axis=0)
        assert np.allclose([low, high], [(-SIZE[0] / 2, -SIZE[1] / 2, 0), (SIZE[0] / 2, SIZE[1] / 2, SIZE[2])], atol=2 * MM)


@pytest.mark.parametrize("format", ["usd", "usdc", "usdz", "arena"])
def test_usd_refers_to_assets_in_their_boxes(format: str, tmp_path: Path) -> None:
    """usd-core opens it from where it lies, its validators find nothing, and what is seen of a body fills its box."""
    for name, content in files(format).items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    (path,) = (path for path in tmp_path.iterdir() if path.suffix.startswith(".usd"))
    stage = Usd.Stage.Open(str(path))
    assert (findings(stage), stage.GetCompositionErrors()) == ([], [])
    seen_alone = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default", "render"])
    bodies = {prim.GetCustomDataByKey("id"): prim for prim in stage.GetPrimAtPath("/House/Furniture").GetChildren()}
    for number in range(5):
        span = seen_alone.ComputeUntransformedBound(bodies[f"sofa/{number}"]).ComputeAlignedRange()
        assert np.allclose(
            [span.GetMin(), span.GetMax()], [(-SIZE[0] / 2, -SIZE[1] / 2, 0), (SIZE[0] / 2, SIZE[1] / 2, SIZE[2])], atol=2 * MM
        )
        solids = [prim for prim in Usd.PrimRange(bodies[f"sofa/{number}"]) if prim.HasAPI(UsdPhysics.CollisionAPI)]
        assert len(solids) > 3
        assert all(UsdGeom.Imageable(prim).ComputePurpose() == "guide" for prim in solids)


@pytest.mark.parametrize("format", ["mjcf", "sdf"])
def test_a_front_looks_where_the_kind_s_does(format: str) -> None:
    """A sofa's back is high: what is above its seat is behind its middle (+y, as the front is -y), whatever its front was in the file."""
    written = files(format)
    for number in range(4):
        texts = [
            content.decode() for name, content in written.items() if name.startswith(f"assets/sofa_{number}_") and name.endswith(".obj")
        ]
        points = np.concatenate(
            [np.array([line.split()[1:] for line in text.splitlines() if line.startswith("v ")], dtype=float) for text in texts]
        )
        high = points[points[:, 2] > 0.9 * points[:, 2].max()]
        assert high[:, 1].mean() > 0.5 * points[:, 1].max(), number


def test_pictures_go_along(tmp_path: Path) -> None:
    at = folder(tmp_path, {"a.glb": textured(shape("sofa"))}, {"a": {"file": "a.glb", "kinds": ["sofa"], "license": "MIT"}})
    sofa = Furniture("s", "sofa", x=2, z=2, width=2.2, depth=0.9, height=0.85)
    scene, known = Scene(rooms=(Room("den", width=5, depth=5, furniture=(sofa,)),)), add_assets(load_catalogs(), at)
    written = export(scene, "mjcf", catalogs=known)
    world = mujoco.MjModel.from_xml_string(
        written["house.xml"].decode(), {name: one for name, one in written.items() if name.startswith("assets/")}
    )
    assert world.ntex == 1
    gazebo = export(scene, "sdf", catalogs=known)
    pictures = [name for name in gazebo if name.endswith(".png")]
    assert len(pictures) == 1
    for name, content in export(scene, "usd", catalogs=known).items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    stage = Usd.Stage.Open(str(tmp_path / "house.usda"))
    assert findings(stage) == []
    assert [path.read_bytes() for path in (tmp_path / "assets").glob("*.png")] == [gazebo[pictures[0]]]
    assert any(f"map_Kd {pictures[0].removeprefix('assets/')}".encode() in one for name, one in gazebo.items() if name.endswith(".mtl"))


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
