"""What lies in drawers goes with them, in every format that has joints."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import mujoco
import numpy as np
import pytest
from pxr import UsdGeom

from catalogs import load_catalogs
from catalogs.insides import insides_of
from solver.exports import ExportSettings, HouseModel, describe, written_as
from solver.exports.moving_parts import held_things
from solver.scene import Decoration, Furniture, Room, Scene
from tests.exports.physics import mjcf, started
from tests.exports.readers import glb, sdf, urdf, usd

KINDS = ("dresser", "medium_wardrobe", "filing_cabinet", "nightstand", "double_vanity")
PULLED = 0.15


def scene() -> Scene:
    """A piece of each kind, turned by an odd angle, a book in each of its drawers and one on its top."""
    known, pieces, things = load_catalogs(), [], []
    for number, kind in enumerate(KINDS):
        spec = known.furniture[kind]
        piece = Furniture(
            f"den/{kind}", known.name_of(kind), kind=kind, x=1.5 + 2 * number, z=2.0, rotation=41.0 * number, width=spec.size[0],
            depth=spec.size[1], height=spec.size[2],
        )  # fmt: skip
        cosine, sine = math.cos(math.radians(piece.rotation)), math.sin(math.radians(piece.rotation))
        places = [(sum(one.x) / 2, one.height, sum(one.z) / 2) for one in insides_of(known.shapes[kind], spec.size) if one.drawer]
        for count, (x, y, z) in enumerate([*places, (0.0, spec.size[2], 0.0)]):
            things.append(
                Decoration(
                    f"den/book_{kind}_{count}", "book", x=piece.x + x * cosine + z * sine, y=y, z=piece.z - x * sine + z * cosine,
                    rotation=piece.rotation + 15, width=0.14, depth=0.2, height=0.03, parent=piece.id,
                )
            )  # fmt: skip
        pieces.append(piece)
    room = Room("den", 0, "den", width=12.0, depth=4.0, furniture=tuple(pieces), decorations=tuple(things))
    return Scene(wall_thickness=0.1, rooms=(room,))


@cache
def model(free: Any = "light") -> HouseModel:
    return describe(scene(), load_catalogs(), free=free)


def held() -> dict[str, str]:
    """Things in drawers, each with the joint of its drawer."""
    return {name: f"{one.piece}/{one.front}/slide" for name, one in held_things(model().bodies).items()}


def test_things_in_drawers_are_told_from_those_on_top() -> None:
    known = load_catalogs()
    drawers = sum(one.drawer is not None for kind in KINDS for one in insides_of(known.shapes[kind], known.furniture[kind].size))
    assert len(held()) == len(set(held().values())) == drawers
    on_top = {body.id for body in model().bodies if body.name == "book"} - set(held())
    assert len(on_top) == len(KINDS)


def pulled(world: Any, joints: dict[str, str]) -> dict[str, tuple[float, Any]]:
    """Opens all drawers at once; returns how far each thing came along its drawer's axis, and what it did besides."""
    state = mujoco.MjData(world)
    mujoco.mj_kinematics(world, state)
    before = {name: state.body(name).xpos.copy() for name in joints}
    for joint in joints.values():
        state.qpos[world.joint(joint).qposadr[0]] = math.copysign(PULLED, max(world.joint(joint).range, key=abs))
    mujoco.mj_forward(world, state)
    found = {}
    for name, joint in joints.items():
        way, axis = state.body(name).xpos - before[name], state.xaxis[world.joint(joint).id]
        along = float(way @ axis)
        found[name] = (abs(along), way - along * axis)
    return found


@pytest.mark.parametrize("format", ["mjcf", "urdf"])
def test_what_does_not_move_by_itself_is_part_of_its_drawer(format: str) -> None:
    files = written_as(model("none"), ExportSettings(format))
    world = urdf.compiled(files) if format == "urdf" else mujoco.MjModel.from_xml_string(next(iter(files.values())).decode())
    for name, (along, beside) in pulled(world, held()).items():
        assert along == pytest.approx(PULLED, abs=1e-6), name
        assert np.abs(beside).max() < 1e-6, name


def test_what_is_free_comes_along_as_its_drawer_is_pulled() -> None:
    """Each drawer is drawn out within a second; nothing slips by more than 2 cm or leaves its tray."""
    world, state = started(mjcf(model()))
    assert not any(body.fixed for body in model().bodies if body.name == "book")
    joints = held()
    start = {name: state.body(name).xpos.copy() for name in joints}
    for step in range(250):
        for joint in joints.values():
            end = max(world.joint(joint).range, key=abs)
            state.qpos[world.joint(joint).qposadr[0]] = math.copysign(PULLED * step / 250, end)
            state.qvel[world.joint(joint).dofadr[0]] = math.copysign(PULLED, end)
        mujoco.mj_step(world, state)
    for name, joint in joints.items():
        way = state.body(name).xpos - start[name]
        assert abs(abs(float(way @ state.xaxis[world.joint(joint).id])) - PULLED) < 0.02, name
        assert abs(way[2]) < 0.005, name


def test_glb_has_them_below_the_nodes_of_their_drawers() -> None:
    (content,) = written_as(model(), ExportSettings("glb")).values()
    nodes = glb.document(content)["nodes"]
    parents = {nodes[child]["name"]: node["name"] for node in nodes for child in node.get("children", ())}
    graph = glb.scene_of(content).graph
    bodies = {body.id: body for body in model().bodies}
    for name, joint in held().items():
        assert parents[name] == joint.removesuffix("/slide")
        at = graph.get(name)[0]
        body = bodies[name]
        assert at[:3, 3] == pytest.approx([body.x, body.y, body.z], abs=1e-5)
        turn = math.radians(body.turn)
        width = at[:3, 0] / np.linalg.norm(at[:3, 0])
        assert width == pytest.approx([math.cos(turn), 0.0, -math.sin(turn)], abs=1e-5)


@pytest.mark.parametrize("free", ["none", "light"])
def test_usd_joins_those_to_their_drawers_that_are_not_free(free: str) -> None:
    stage = usd.stage_of(written_as(model(free), ExportSettings("usd")))
    found, poses = {}, UsdGeom.XformCache()
    for prim in stage.Traverse():
        if prim.GetTypeName() == "PhysicsFixedJoint":
            front, body = (stage.GetPrimAtPath(prim.GetRelationship(f"physics:body{end}").GetTargets()[0]) for end in (0, 1))
            frames = [poses.GetLocalToWorldTransform(one) for one in (front, body)]
            points = [frame.Transform(prim.GetAttribute(f"physics:localPos{end}").Get()) for end, frame in enumerate(frames)]
            assert np.allclose(points[0], points[1], atol=1e-4)
            assert body.HasAPI("PhysicsRigidBodyAPI")
            found[body.GetCustomDataByKey("id")] = f"{front.GetCustomDataByKey('id')}/slide"
    assert found == (held() if free == "none" else {})


@pytest.mark.parametrize("free", ["none", "light"])
def test_sdf_has_those_in_the_models_of_their_pieces_that_are_not_free(free: str) -> None:
    files = written_as(model(free), ExportSettings("sdf"))
    (text,) = (content for name, content in files.items() if name.endswith(".sdf"))
    found = {}
    for piece in sdf.models(text):
        for inner in piece.findall("model"):
            (joint,) = (one for one in piece.findall("joint") if one.findtext("child") == f"{inner.get('name')}::link")
            found[inner.findtext(sdf.ID, "")] = f"{piece.findtext(sdf.ID)}/{joint.findtext('parent')}/slide"
            assert joint.get("type") == "fixed"
    assert found == (held() if free == "none" else {})
    seen = sdf.read(files)
    for body in model(free).bodies:
        if body.id in held():
            one = seen[body.id]
            assert (one.x, one.y, one.z) == pytest.approx((body.x, body.y, body.z), abs=1e-4)
            assert (one.turn - body.turn + 180) % 360 - 180 == pytest.approx(0, abs=0.01)
