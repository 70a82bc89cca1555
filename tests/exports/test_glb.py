"""glTF files, judged by Khronos' validator, opened by trimesh, and read back."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from starlette.testclient import TestClient

from catalogs import load_catalogs
from compose_homes import dump, export, load
from solver.body_parts import BodyPart
from solver.errors import SyntaxFault
from solver.exports import ExportSettings, describe, written_as
from solver.exports.solid_meshes import BoxFace, SolidSurface, box_faces, surface_of
from solver.named_assets import with_kinds
from solver.scene import Scene
from tests.architecture.tree import ROOT
from tests.exports import homes
from tests.exports.readers.glb import document, read, scene_of

MADE = ("own", "family", "default", "hostile", "storeys")
MM = 0.001
FORMS = [
    ("box", "y", 1.0), ("rounded", "y", 1.0), ("cylinder", "y", 1.0), ("cylinder", "x", 0.5), ("cylinder", "z", 2.0), ("cone", "y", 0.0),
    ("cone", "x", 0.0), ("ball", "y", 1.0), ("capsule", "x", 1.0), ("capsule", "y", 1.0), ("capsule", "z", 1.0),
]  # fmt: skip


@cache
def glb(name: str) -> bytes:
    model = homes.described(name)
    files = written_as(model, ExportSettings("glb", lambda: dump(model.scene, format="json").rstrip()))
    assert list(files) == [f"{model.name}.glb"]
    return files[f"{model.name}.glb"]


@cache
def nodes(name: str) -> dict[str, Any]:
    return {node["name"]: node for node in document(glb(name))["nodes"]}


def test_khronos_validator_finds_nothing(tmp_path: Path) -> None:
    """Not an error, a warning, a note or a hint; and it does find what is wrong."""
    contents = [*map(glb, MADE), export(Scene(rooms=()), "glb")["house.glb"], glb("own").replace(b'"scale":[', b'"scalf":[', 1)]
    paths = [tmp_path / f"{number}.glb" for number in range(len(contents))]
    for path, content in zip(paths, contents, strict=True):
        path.write_bytes(content)
    report = tmp_path / "report.json"
    command = [sys.executable, str(ROOT / "scripts" / "page.py"), "validate-glb", str(report), *map(str, paths)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
    *right, wrong = (one["issues"] for one in json.loads(report.read_text()))
    assert [issues["messages"] for issues in right] == [[]] * (len(MADE) + 1)
    assert wrong["messages"]


@pytest.mark.parametrize("name", ["family", "default"])
def test_no_name_of_a_node_comes_twice_and_meshes_have_normals_alone(name: str) -> None:
    told = document(glb(name))
    assert len({node["name"] for node in told["nodes"]}) == len(told["nodes"]) > 300
    assert {key for mesh in told["meshes"] for one in mesh["primitives"] for key in one["attributes"]} == {"POSITION", "NORMAL"}


@pytest.mark.parametrize("name", MADE)
def test_bodies_are_where_the_description_says(name: str) -> None:
    seen = read({"house.glb": glb(name)})
    bodies = homes.described(name).bodies
    assert sorted(seen) == sorted(body.id for body in bodies)
    for body in bodies:
        one = seen[body.id]
        ours = (body.x, body.y, body.z, body.width, body.depth, body.height, body.mass)
        assert (one.x, one.y, one.z, one.width, one.depth, one.height, one.mass) == pytest.approx(ours, abs=MM)
        assert abs((one.turn - body.turn + 180) % 360 - 180) < 0.1


def test_shapes_fill_what_their_parts_fill() -> None:
    """What trimesh draws below each node reaches as far as the body's parts do."""
    scene, bodies = scene_of(glb("family")), homes.described("family").bodies
    ends: dict[str, list[Any]] = {}
    owners = {body.id for body in bodies}
    for node in scene.graph.nodes_geometry:
        at, mesh = scene.graph[node]
        owner = node
        while owner not in owners and owner in scene.graph.transforms.parents:
            owner = scene.graph.transforms.parents[owner]
        ends.setdefault(owner, []).append(np.asarray(scene.geometry[mesh].vertices) @ at[:3, :3].T + at[:3, 3])
    for body in bodies:
        points = np.concatenate(ends[body.id]) - (body.x, body.y, body.z)
        sine, cosine = math.sin(math.radians(body.turn)), math.cos(math.radians(body.turn))
        own = np.stack([points[:, 0] * cosine - points[:, 2] * sine, points[:, 1], points[:, 0] * sine + points[:, 2] * cosine], axis=1)
        low = np.min([np.subtract(part.at, np.divide(part.size, 2)) for part in body.parts], axis=0)
        high = np.max([np.add(part.at, np.divide(part.size, 2)) for part in body.parts], axis=0)
        assert np.allclose(own.min(axis=0), low, atol=MM) and np.allclose(own.max(axis=0), high, atol=MM), body.id


@pytest.mark.parametrize(("form", "axis", "taper"), FORMS)
def test_surfaces_are_closed_and_look_outwards(form: Any, axis: Any, taper: float) -> None:
    size, at = ((0.5, 1.2, 0.7) if axis == "y" else (1.2, 0.5, 0.6)), (1.0, 2.0, 3.0)
    surface = surface_of(BodyPart(form, size, at, axis, taper, "body"))
    assert np.allclose(surface.points.min(axis=0), np.subtract(at, np.divide(size, 2)))
    assert np.allclose(surface.points.max(axis=0), np.add(at, np.divide(size, 2)))
    assert np.allclose(np.linalg.norm(surface.normals, axis=1), 1)
    check_closed(surface, at)


def check_closed(surface: SolidSurface, middle: tuple[float, float, float]) -> None:
    """Every edge is met from both sides; triangles and normals look away from the middle, and the same way."""
    keys = np.unique(surface.points.round(9), axis=0, return_inverse=True)[1].reshape(-1)[surface.triangles]
    edges = [edge for a, b, c in keys.tolist() for edge in ((a, b), (b, c), (c, a)) if edge[0] != edge[1]]
    assert sorted(edges) == sorted((b, a) for a, b in edges)
    corners = surface.points[surface.triangles] - middle
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ij,ij->i", faces, corners.sum(axis=1)) > 0).all()
    assert (np.einsum("ij,ikj->ik", faces, surface.normals[surface.triangles]) > 0).all()


def test_faces_of_a_box_are_those_asked_for() -> None:
    faces: list[BoxFace] = [("y", -1), ("x", 1)]
    surface = box_faces((2.0, 4.0, 6.0), (1.0, 2.0, 3.0), faces)
    assert len(surface.points) == 8 and len(surface.triangles) == 4
    assert np.allclose(surface.points[:4, 1], 0) and np.allclose(surface.points[4:, 0], 2)
    assert surface.normals.tolist() == [[0, -1, 0]] * 4 + [[1, 0, 0]] * 4


def test_a_letter_on_the_floor_is_not_mirrored() -> None:
    """Seen from above with north (-z) at the top the arms of the F point east, the upper one is the longer."""
    stem, arm, bar = (nodes("own")[f"living/f_{part}"]["translation"] for part in ("stem", "arm", "bar"))
    assert stem[0] < bar[0] < arm[0] and arm[2] < bar[2]


def test_doors_hang_on_hinges() -> None:
    """Turned about their hinge by their range, leaves end where the room they open into is."""
    leaves = {leaf.id: leaf for leaf in homes.described("own").leaves}
    assert len(leaves) == 10
    for door in (nodes("own")[name] for name in leaves):
        leaf, joint = leaves[door["extras"]["id"]], door["extras"]["joint"]
        (child,) = (document(glb("own"))["nodes"][number] for number in door["children"])
        assert child["translation"] == pytest.approx([leaf.width / 2, 0, 0])
        assert door["translation"] == pytest.approx(leaf.hinge) and joint["axis"] == [0, 1, 0]
        half = math.radians(leaf.closed) / 2
        assert door["rotation"] == pytest.approx([0, math.sin(half), 0, math.cos(half)])
        if leaf.motion == "swing":
            assert (joint["type"], joint["unit"], joint["range"]) == ("revolute", "degree", sorted([0, leaf.swing]))
        else:
            assert (joint["type"], joint["unit"], joint["range"]) == ("prismatic", "m", [0, pytest.approx(leaf.height)])


def test_what_is_hidden_at_once_is_under_one_node() -> None:
    document_of = document(glb("family"))
    groups = {node["name"]: len(node["children"]) for node in document_of["nodes"] if node["name"].startswith("house/")}
    model = homes.described("family")
    assert groups["house/ceilings"] == groups["house/floors"] == len(model.rooms)
    assert groups["house/people"] == len([body for body in model.bodies if body.sort == "dynamic"]) > 0
    names = "ceilings", "floors", "walls", "fittings", "doors", "furniture", "decorations", "people"
    assert set(groups) == {f"house/{name}" for name in names}


def test_paints_are_linear_and_glass_lets_light_through() -> None:
    materials = document(glb("family"))["materials"]
    colors = {one["name"]: one["pbrMetallicRoughness"]["baseColorFactor"] for one in materials}
    assert colors["#f1ede4"][0] == pytest.approx(((0xF1 / 255 + 0.055) / 1.055) ** 2.4, abs=1e-5)
    clear = [one for one in materials if one["pbrMetallicRoughness"]["baseColorFactor"][3] < 1]
    assert clear and {one.get("alphaMode") for one in clear} == {"BLEND"}
    assert [one for one in materials if "alphaMode" in one] == clear


def test_walls_have_the_paint_of_the_room_they_face() -> None:
    """The bedroom of our own house is panelled, the living room plastered in green; one wall is between them."""
    said = document(glb("own"))
    by_name = {number: material["name"] for number, material in enumerate(said["materials"])}
    pairs = {frozenset(by_name[one["material"]] for one in mesh["primitives"]) for mesh in said["meshes"] if mesh["name"] == "wall"}
    assert any({"wood #c9b79c", "plaster #dde6e0"} <= pair for pair in pairs)


def test_geometry_is_written_once_a_shape() -> None:
    said = document(glb("default"))
    assert len(said["accessors"]) < 3 * sum(len(mesh["primitives"]) for mesh in said["meshes"]) * 0.8
    assert len(said["meshes"]) < len(said["nodes"]) / 2


@pytest.mark.parametrize("name", MADE)
def test_the_same_scene_reads_back(name: str, tmp_path: Path) -> None:
    scene = homes.described(name).scene
    path = tmp_path / "home.GLB"
    path.write_bytes(glb(name))
    for back in (load(path), load(glb(name)), load(glb(name), "glb")):
        assert back == scene and dump(back, format="json") == dump(scene, format="json")


def test_exporting_again_gives_the_same_bytes() -> None:
    (content,) = export(homes.own(), "glb").values()
    (again,) = export(load(content), "glb").values()
    assert content == again


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"glTF", "does not begin"),
        (b"PK\x03\x04 a zip", "does not begin"),
        (b"{}", "does not begin"),
        (b"glTF\x01\0\0\0\x14\0\0\0\0\0\0\0JSON", "version 1"),
        (b"glTF\x02\0\0\0\x14\0\0\0\0\0\0\0BIN\0", "its JSON"),
        (b"glTF\x02\0\0\0\xff\0\0\0\x02\0\0\0JSON{}", "not a whole"),
        (b"glTF\x02\0\0\0\x16\0\0\0\x03\0\0\0JSON{}", "not a whole"),
        (b"glTF\x02\0\0\0\x16\0\0\0\x02\0\0\0JSON{}", "only one that Compose exported"),
        (b"glTF\x02\0\0\0\x16\0\0\0\x02\0\0\0JSON{]", "not JSON"),
        (b"glTF\x02\0\0\0\x16\0\0\0\x02\0\0\0JSON\xff\xff", "not UTF-8"),
        (b'glTF\x02\0\0\0\x39\0\0\0\x25\0\0\0JSON{"scenes":[{"extras":{"scene":[1]}}]}', "only one that Compose exported"),
    ],
)
def test_what_is_no_glb_of_ours_is_refused(content: bytes, says: str) -> None:
    with pytest.raises(SyntaxFault, match=says):
        load(content, "glb")


def test_the_service_reads_one(client: TestClient) -> None:
    content, headers = glb("own"), {"content-type": "model/gltf-binary"}
    assert client.post("/export/yaml", content=content, headers=headers).text == dump(with_kinds(homes.own(), load_catalogs()))
    judged = client.post("/validate", content=content, headers=headers).json()["issues"]
    assert judged and judged == client.post("/validate", json={"scene": json_of("own")}).json()["issues"]
    answer = client.post("/view", content=b"glTF", headers=headers)
    assert answer.status_code == 400 and "not a .glb" in answer.text


def json_of(name: str) -> Any:
    return json.loads(dump(homes.described(name).scene, format="json"))


def test_warnings_stand_in_the_asset() -> None:
    model = describe(homes.own(), load_catalogs(), warnings=['out_of_bounds: a"b\n<c>'])
    (content,) = written_as(model, ExportSettings("glb")).values()
    assert document(content)["asset"]["extras"]["warnings"] == list(model.warnings)
