"""The joints of fronts as each format's files hold them, in the scene's frame, to be held against the description."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final, NamedTuple
from xml.etree import ElementTree

import mujoco
import numpy as np
from pxr import UsdGeom, UsdPhysics

from solver.exports import HouseModel
from tests.exports.readers import glb, sdf, urdf, usd

AXES: Final = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


class SeenJoint(NamedTuple):
    """A front's joint in the house: whether it slides, a point of its axis, m, the axis' direction, its limits, m or degrees."""

    slides: bool
    point: tuple[float, ...]
    axis: tuple[float, ...]
    low: float
    high: float


def described_joints(model: HouseModel) -> dict[str, SeenJoint]:
    """What the description says, by body and front."""
    found = {}
    for body in model.bodies:
        cosine, sine = math.cos(math.radians(body.turn)), math.sin(math.radians(body.turn))
        for front in body.fronts:
            x, y, z = front.hinge
            point = body.x + x * cosine + z * sine, body.y + y, body.z - x * sine + z * cosine
            axis = {"x": (cosine, 0.0, -sine), "y": (0.0, 1.0, 0.0), "z": (sine, 0.0, cosine)}[front.axis]
            found[f"{body.id}/{front.name}"] = SeenJoint(front.slides, point, axis, *sorted((0.0, front.end)))
    return found


def _from_z_up(vector: Any) -> tuple[float, ...]:
    x, y, z = (float(value) for value in vector)
    return x, z, -y


def _compiled(world: Any) -> Iterator[tuple[str, SeenJoint]]:
    state = mujoco.MjData(world)
    mujoco.mj_forward(world, state)
    for joint in range(world.njnt):
        name = world.joint(joint).name
        kind = world.jnt_type[joint]
        if kind == mujoco.mjtJoint.mjJNT_HINGE or kind == mujoco.mjtJoint.mjJNT_SLIDE:  # noqa: PLR1714 (numpy's equality)
            low, high = world.jnt_range[joint].tolist()
            slides = kind == mujoco.mjtJoint.mjJNT_SLIDE
            ends = (low, high) if slides else (math.degrees(low), math.degrees(high))
            at, axis = _from_z_up(state.xanchor[joint]), _from_z_up(state.xaxis[joint])
            yield name.rpartition("/")[0], SeenJoint(slides, at, axis, *ends)


def _mjcf(files: Mapping[str, bytes]) -> dict[str, SeenJoint]:
    (content,) = files.values()
    return dict(_compiled(mujoco.MjModel.from_xml_string(content.decode())))


def _urdf(files: Mapping[str, bytes]) -> dict[str, SeenJoint]:
    return dict(_compiled(urdf.compiled(files)))


def _sdf(files: Mapping[str, bytes]) -> dict[str, SeenJoint]:
    (text,) = (content for name, content in files.items() if name.endswith(".sdf"))
    found = {}
    for model in ElementTree.fromstring(text).iter("model"):
        if model.find(sdf.ID) is None or sdf.is_leaf(model):
            continue
        x, y, z, _, _, turn = (float(word) for word in model.findtext("pose", "").split())
        turned = np.array([[math.cos(turn), -math.sin(turn), 0], [math.sin(turn), math.cos(turn), 0], [0, 0, 1]])
        links = {link.get("name"): link for link in model.iter("link")}
        for joint in model.iter("joint"):
            if joint.get("type") == "fixed":
                continue
            child = joint.findtext("child", "")
            at = [float(word) for word in links[child].findtext("pose", "").split()][:3]
            axis = [float(word) for word in joint.findtext("axis/xyz", "").split()]
            slides = joint.get("type") == "prismatic"
            low, high = (float(joint.findtext(f"axis/limit/{end}", "")) for end in ("lower", "upper"))
            ends = (low, high) if slides else (math.degrees(low), math.degrees(high))
            point = _from_z_up(turned @ at + (x, y, z))
            found[f"{model.findtext(sdf.ID)}/{child}"] = SeenJoint(slides, point, _from_z_up(turned @ axis), *ends)
    return found


def _usd(files: Mapping[str, bytes]) -> dict[str, SeenJoint]:
    """Reads both frames of every joint, which must be one place."""
    stage = usd.stage_of(files)
    cache = UsdGeom.XformCache()
    found = {}
    for prim in stage.GetDefaultPrim().GetChild("Fronts").GetChildren():
        child = prim.GetChild("hinge")
        slides = child.IsA(UsdPhysics.PrismaticJoint)
        joint = UsdPhysics.PrismaticJoint(child) if slides else UsdPhysics.RevoluteJoint(child)
        ends = [stage.GetPrimAtPath(rel.GetTargets()[0]) for rel in (joint.GetBody0Rel(), joint.GetBody1Rel())]
        frames = [cache.GetLocalToWorldTransform(one) for one in ends]
        points = [frame.Transform(at.Get()) for frame, at in zip(frames, (joint.GetLocalPos0Attr(), joint.GetLocalPos1Attr()), strict=True)]
        directions = [frame.TransformDir(AXES[joint.GetAxisAttr().Get()]) for frame in frames]
        assert np.allclose(points[0], points[1], atol=1e-4)
        assert np.allclose(directions[0], directions[1], atol=1e-6)
        low, high = joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()
        found[prim.GetCustomDataByKey("id")] = SeenJoint(slides, _from_z_up(points[1]), _from_z_up(directions[1]), low, high)
    return found


def _glb(files: Mapping[str, bytes]) -> dict[str, SeenJoint]:
    (content,) = files.values()
    graph = glb.scene_of(content).graph
    found = {}
    for node in glb.document(content)["nodes"]:
        extras = node.get("extras", {})
        if "front" in extras:
            at = np.asarray(graph.get(node["name"])[0])
            joint = extras["joint"]
            axis = tuple((at[:3, :3] @ joint["axis"]).tolist())
            found[extras["id"]] = SeenJoint(joint["type"] == "prismatic", tuple(at[:3, 3].tolist()), axis, *joint["range"])
    return found


READERS: Final[Mapping[str, Callable[[Mapping[str, bytes]], dict[str, SeenJoint]]]] = {
    "mjcf": _mjcf, "urdf": _urdf, "sdf": _sdf, "usd": _usd, "glb": _glb,
}  # fmt: skip


def joint_differences(model: HouseModel, format: str, seen: Mapping[str, SeenJoint]) -> list[str]:
    """Returns in words where a format's joints are other than the description's; an axis may point the other way, its limits with it."""
    found = []
    for name, ours in described_joints(model).items():
        theirs = seen.get(name)
        if theirs is None:
            found.append(f"{format}: {name} is missing")
            continue
        if sum(a * b for a, b in zip(ours.axis, theirs.axis, strict=True)) < 0:
            theirs = theirs._replace(axis=tuple(-value for value in theirs.axis), low=-theirs.high, high=-theirs.low)
        close = [
            ours.slides == theirs.slides,
            np.allclose(ours.point, theirs.point, atol=1e-3),
            np.allclose(ours.axis, theirs.axis, atol=1e-4),
            np.allclose((ours.low, ours.high), (theirs.low, theirs.high), atol=1e-3),
        ]
        if not all(close):
            found.append(f"{format}: {name} is {theirs}, not {ours}")
    return found
