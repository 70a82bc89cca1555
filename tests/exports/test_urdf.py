"""URDF as MuJoCo reads it, and what its XML holds."""

from __future__ import annotations

import math
import re
from xml.etree import ElementTree

import pytest

from compose_homes import export
from solver.errors import SceneError
from solver.exports import ExportSettings, written_as
from solver.scene import Furniture, Room, Scene
from tests.exports.homes import SCENES, described
from tests.exports.readers import urdf

HOMES = [*SCENES, "hostile", "storeys"]


@pytest.mark.parametrize("home", HOMES)
def test_mujoco_reads_it_with_all_links_and_doors(home: str) -> None:
    model = described(home)
    world = urdf.compiled(written_as(model, ExportSettings("urdf")))
    fronts = sum(len(body.fronts) for body in model.bodies)
    assert world.nbody == 2 + len(model.bodies) + len(model.leaves) + fronts
    assert world.njnt == len(model.leaves) + fronts
    for leaf in model.leaves:
        assert world.body(leaf.id).mass[0] == pytest.approx(leaf.mass, rel=1e-6)


@pytest.mark.parametrize("home", HOMES)
def test_links_form_one_tree_with_inertias_that_can_be(home: str) -> None:
    files = written_as(described(home), ExportSettings("urdf"))
    robot = ElementTree.fromstring(next(content for name, content in files.items() if name.endswith(".urdf")))
    links = [link.get("name") for link in robot.iter("link")]
    children = [child.get("link") for child in robot.iter("child")]
    assert sorted(children, key=str) == sorted(links[1:], key=str)
    assert len(set(links)) == len(links)
    for inertia in robot.iter("inertia"):
        xx, yy, zz = (float(inertia.get(key, "")) for key in ("ixx", "iyy", "izz"))
        assert min(xx + yy - zz, xx + zz - yy, yy + zz - xx) > 0
    assert {mesh.get("filename") for mesh in robot.iter("mesh")} == {name for name in files if name.endswith(".obj")}


@pytest.mark.parametrize("format", ["urdf", "sdf"])
def test_names_are_free_and_short_enough_for_simulators(format: str) -> None:
    """Drake puts the link `world` of any robot where its own is; PyBullet reads no name that is long, libsdformat ends at one."""
    ids = ("world", "é" * 50_000, '"' * 900, "<&" * 900, "_", "__", "___", "_::_", "::", "a___", "a::_", "world_")
    pieces = (Furniture(name, "wardrobe", x=2, z=k + 1, width=1.2, depth=0.6, height=2) for k, name in enumerate(ids))
    content = export(Scene(rooms=(Room("den", width=4.0, depth=15.0, furniture=tuple(pieces)),)), format)[f"house.{format}"]
    names = [one.get("name", "") for one in ElementTree.fromstring(content).iter() if one.tag in ("link", "joint", "model")]
    written = [max(map(len, re.findall(rb'<(?:link|joint|model) name="([^"]*)"', line)), default=0) for line in content.splitlines()]
    assert "world" not in names
    assert 300 < max(len(name.encode()) for name in names) < 500
    assert 390 < max(written) < 410
    if format == "sdf":
        assert [name for name in names if name.startswith("__") or name.endswith("__") or "::" in name] == []


@pytest.mark.parametrize("format", ["urdf", "sdf"])
def test_lines_are_short_enough_for_readers_that_take_a_line_at_a_time(format: str) -> None:
    """Bullet's readers lose what stands behind some thousands of characters."""
    files = written_as(described("family"), ExportSettings(format))
    world = next(content for name, content in files.items() if name.endswith(f".{format}")).decode()
    assert max(map(len, world.splitlines())) < 2000


def test_a_door_opens_as_the_scene_says() -> None:
    model = described("own")
    files = written_as(model, ExportSettings("urdf"))
    robot = ElementTree.fromstring(files["house.urdf"])
    joints = {joint.get("name"): joint for joint in robot.iter("joint")}
    for leaf in model.leaves:
        joint = joints[f"{leaf.id}/{'hinge' if leaf.motion == 'swing' else 'slide'}"]
        limit = joint.find("limit")
        assert limit is not None
        opened = math.radians(leaf.swing) if leaf.motion == "swing" else leaf.height
        assert max((float(limit.get(end, "")) for end in ("lower", "upper")), key=abs) == pytest.approx(opened)


@pytest.mark.parametrize("side", ["width", "depth"])
def test_a_room_thinner_than_the_lattice_is_refused_by_its_side(side: str) -> None:
    room = Room("den", **{"width": 4.0, "depth": 3.0, side: 1e-300})  # type: ignore[arg-type]
    with pytest.raises(SceneError, match=rf"rooms\[0\]\.{side}: is under a millimetre"):
        export(Scene(rooms=(room,)), "urdf")
