"""USD stages, judged by usd-core's validators and read back by usd-core."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics, UsdSemantics, UsdShade

from catalogs import load_catalogs
from compose_homes import export
from solver.exports import ExportSettings, describe, written_as
from solver.exports.moving_parts import still_part
from solver.exports.usd_text import text
from solver.scene import Scene
from tests.exports import homes
from tests.exports.readers.usd import findings, read, read_stage, stage_of

MADE = ("own", "family", "hostile", "storeys")
MM = 0.001


def files(name: str) -> dict[str, bytes]:
    return written_as(homes.described(name), ExportSettings("usd"))


@cache
def stage(name: str) -> Usd.Stage:
    return stage_of(files(name))


def drawn(of: Usd.Stage, under: str = "/") -> list[Usd.Prim]:
    """All prims of a stage, those of instances included."""
    root = of.GetPseudoRoot() if under == "/" else of.GetPrimAtPath(under)
    return list(Usd.PrimRange(root, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)))


@pytest.mark.parametrize("name", MADE)
def test_no_validator_finds_anything(name: str) -> None:
    assert findings(stage(name)) == [] and stage(name).GetCompositionErrors() == []


def test_the_validators_do_find_what_is_wrong() -> None:
    (content,) = files("own").values()
    wrong = content.replace(b'upAxis = "Z"', b"").replace(b"double size = 1\nfloat3 xformOp:scale", b"float3 xformOp:scale")
    assert findings(stage_of({"house.usda": wrong}))


def test_a_house_without_rooms_is_a_stage_too() -> None:
    empty = stage_of(export(Scene(rooms=()), "usd"))
    assert findings(empty) == [] and read_stage(empty) == {}


@pytest.mark.parametrize("name", MADE)
def test_bodies_are_where_the_description_says(name: str) -> None:
    seen, bodies = read(files(name)), homes.described(name).bodies
    assert sorted(seen) == sorted(body.id for body in bodies)
    for body in bodies:
        one = seen[body.id]
        ours = (body.x, body.y, body.z, body.width, body.depth, body.height, body.mass)
        assert (one.x, one.y, one.z, one.width, one.depth, one.height, one.mass) == pytest.approx(ours, abs=MM)
        assert abs((one.turn - body.turn + 180) % 360 - 180) < 0.1


@pytest.mark.parametrize("format", ["usdc", "usdz"])
def test_packed_stages_hold_the_same(format: str, tmp_path: Path) -> None:
    ((name, content),) = written_as(homes.described("own"), ExportSettings(format)).items()
    path = tmp_path / name
    path.write_bytes(content)
    packed = Usd.Stage.Open(str(path))
    assert findings(packed) == []
    assert read_stage(packed) == read_stage(stage("own"))
    again = written_as(homes.described("own"), ExportSettings(format))
    assert again == {name: content} and name.endswith(f".{format}")


def test_shapes_fill_what_their_parts_fill() -> None:
    cache_of = UsdGeom.BBoxCache(0, ["default"])
    for body in homes.described("family").bodies:
        prim = next(one for one in bodies_of("family") if one.GetCustomDataByKey("id") == body.id)
        box = cache_of.ComputeUntransformedBound(prim).ComputeAlignedRange()
        parts = still_part(body, ()).parts
        low = np.min([np.subtract(part.at, np.divide(part.size, 2)) for part in parts], axis=0)
        high = np.max([np.add(part.at, np.divide(part.size, 2)) for part in parts], axis=0)
        assert np.allclose(box.GetMin(), (low[0], -high[2], low[1]), atol=MM), body.id
        assert np.allclose(box.GetMax(), (high[0], -low[2], high[1]), atol=MM), body.id


@cache
def bodies_of(name: str) -> list[Usd.Prim]:
    house = stage(name).GetDefaultPrim()
    return [prim for sort in ("Furniture", "Decorations", "People") for prim in house.GetChild(sort).GetChildren()]


def test_what_moves_is_a_rigid_body_and_what_is_flat_does_not_collide() -> None:
    bodies = {body.id: body for body in homes.described("family").bodies}
    moving = {prim.GetCustomDataByKey("id") for prim in bodies_of("family") if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    assert moving == {body.id for body in bodies.values() if not body.fixed} and 0 < len(moving) < len(bodies)
    for prim in bodies_of("family"):
        body = bodies[prim.GetCustomDataByKey("id")]
        colliders = [one for one in Usd.PrimRange(prim, Usd.TraverseInstanceProxies()) if one.HasAPI(UsdPhysics.CollisionAPI)]
        assert (not colliders) == body.flat, body.id
        friction = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")[0].GetPrim()
        assert UsdPhysics.MaterialAPI(friction).GetDynamicFrictionAttr().Get() == pytest.approx(body.friction)


def test_colliders_are_solids_that_engines_have() -> None:
    """Round ones are not stretched; what stands in for one that is stretched is not seen."""
    cache_of = UsdGeom.XformCache()
    colliders = [prim for prim in drawn(stage("family")) if prim.HasAPI(UsdPhysics.CollisionAPI)]
    assert {prim.GetTypeName() for prim in colliders} >= {"Cube", "Cylinder", "Mesh"}
    for prim in colliders:
        rows = [Gf.Vec3d(*cache_of.GetLocalToWorldTransform(prim).GetRow3(i)).GetLength() for i in range(3)]
        if prim.GetTypeName() in ("Cylinder", "Capsule", "Sphere", "Cone"):
            assert rows == pytest.approx([1, 1, 1]), prim.GetPath()
        if prim.GetTypeName() == "Mesh":
            assert UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get() == "boundingCube"
        bound = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0]
        assert bool(bound) != (UsdGeom.Imageable(prim).ComputePurpose() == "guide")


def test_doors_turn_on_joints_that_hang_on_the_house() -> None:
    leaves = {leaf.id: leaf for leaf in homes.described("own").leaves}
    doors = stage("own").GetPrimAtPath("/House/Doors").GetChildren()
    assert {prim.GetCustomDataByKey("id") for prim in doors} == set(leaves)
    for prim in doors:
        leaf = leaves[prim.GetCustomDataByKey("id")]
        assert prim.HasAPI(UsdPhysics.RigidBodyAPI)
        assert UsdPhysics.MassAPI(prim).GetMassAttr().Get() == pytest.approx(leaf.mass, rel=1e-5)
        joint = UsdPhysics.Joint(prim.GetChild("hinge"))
        assert joint.GetBody0Rel().GetTargets() == ["/House"] and joint.GetBody1Rel().GetTargets() == [prim.GetPath()]
        x, y, z = leaf.hinge
        assert tuple(joint.GetLocalPos0Attr().Get()) == pytest.approx((x, -z, y), abs=1e-4)
        at = UsdGeom.XformCache().GetLocalToWorldTransform(prim).ExtractTranslation()
        assert tuple(at) == pytest.approx(tuple(joint.GetLocalPos0Attr().Get()))
        assert joint.GetLocalRot0Attr().Get().GetImaginary()[2] == pytest.approx(math.sin(math.radians(leaf.closed) / 2), abs=1e-6)
        check_limits(prim.GetChild("hinge"), leaf.motion, leaf.swing, leaf.height)


def check_limits(prim: Usd.Prim, motion: str, swing: float, height: float) -> None:
    joint: Any = UsdPhysics.RevoluteJoint(prim) if motion == "swing" else UsdPhysics.PrismaticJoint(prim)
    assert joint.GetAxisAttr().Get() == "Z"
    limits = (joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get())
    assert limits == pytest.approx(tuple(sorted((0.0, swing if motion == "swing" else height))), abs=1e-4)
    drive = UsdPhysics.DriveAPI(prim, "angular" if motion == "swing" else "linear")
    assert drive.GetDampingAttr().Get() > 0 and drive.GetStiffnessAttr().Get() == 0


def test_leaves_and_what_they_hang_in_do_not_touch() -> None:
    leaves = UsdPhysics.CollisionGroup.Get(stage("own"), "/House/Leaves")
    assert leaves.GetFilteredGroupsRel().GetTargets() == ["/House/Building"]
    building = UsdPhysics.CollisionGroup.Get(stage("own"), "/House/Building").GetCollidersCollectionAPI()
    held = {str(path) for path in building.GetIncludesRel().GetTargets()}
    assert held == {"/House/Floors", "/House/Walls", "/House/Fittings"} and all(stage("own").GetPrimAtPath(path) for path in held)


def test_every_seen_thing_has_its_paint_and_walls_that_of_each_side() -> None:
    for prim in drawn(stage("own")):
        seen = prim.IsA(UsdGeom.Gprim) and UsdGeom.Imageable(prim).ComputePurpose() == "default"
        subsets = [one for one in prim.GetChildren() if one.IsA(UsdGeom.Subset)]
        for one in (subsets or [prim]) if seen else []:
            assert UsdShade.MaterialBindingAPI(one).ComputeBoundMaterial()[0], one.GetPath()
    sides = {side_colors(prim) for prim in drawn(stage("own"), "/House/Walls") if prim.IsA(UsdGeom.Mesh)}
    assert ("plaster_dde6e0", "wood_c9b79c") in sides


def side_colors(mesh: Usd.Prim) -> tuple[str, ...]:
    """The paints of a wall's faces to the north and the south."""
    found: dict[int, str] = {}
    for subset in mesh.GetChildren():
        name = UsdShade.MaterialBindingAPI(subset).ComputeBoundMaterial()[0].GetPrim().GetName()
        found |= dict.fromkeys(UsdGeom.Subset(subset).GetIndicesAttr().Get(), name.rsplit("_", 4)[0])
    return found[3], found[2]


def test_labels_say_what_a_body_is() -> None:
    bodies = {body.id: body for body in homes.described("family").bodies}
    for prim in bodies_of("family"):
        assert tuple(prim.GetAttribute("semantics:labels:class").Get()) == bodies[prim.GetCustomDataByKey("id")].labels


def test_kinds_are_written_once() -> None:
    shapes = [prim.GetChild("shape") for prim in bodies_of("family")]
    assert all(shape.IsInstance() for shape in shapes)
    assert len({shape.GetPrototype() for shape in shapes}) < 0.7 * len(shapes)


def test_any_text_is_told_as_it_is() -> None:
    words = [*homes.HOSTILE, "\x00\x01\x1f\x7fab", "\nab\t0\r\\x41", '"""', "'", "a\\", "\u2028\ufeff"]
    layer = Sdf.Layer.CreateAnonymous(".usda")
    lines = "".join(f"string s{number} = {text(word)}\n" for number, word in enumerate(words))
    assert layer.ImportFromString(f'#usda 1.0\ndef "a" (\ncustomData = {{\n{lines}}}\n)\n{{\n}}\n')
    said = layer.GetPrimAtPath("/a").customData
    assert [said[f"s{number}"] for number in range(len(words))] == words


def test_warnings_stand_in_the_layer() -> None:
    model = describe(homes.own(), load_catalogs(), warnings=['out_of_bounds: a"b\n<c>'])
    layer = stage_of(written_as(model, ExportSettings("usd"))).GetRootLayer()
    assert list(layer.customLayerData["warnings"]) == list(model.warnings)


@pytest.mark.parametrize("name", ["own", "hostile"])
def test_arena_names_a_prim_for_each_body(name: str) -> None:
    model = describe(homes.described(name).scene, load_catalogs(), warnings=["a\nb: [c"])
    files = written_as(model, ExportSettings("arena"))
    said = yaml.load(files["house_arena.yaml"], yaml.CSafeLoader)
    assert b'# "a\\nb: [c"' in files["house_arena.yaml"]
    house = stage_of({"house.usda": files["house.usda"]})
    assert findings(house) == [] and not [prim for prim in drawn(house) if prim.GetTypeName() == "DomeLight"]
    bodies = {body.id: body for body in model.bodies}
    found = {}
    for reference in said["object_references"]:
        prim = house.GetDefaultPrim().GetPrimAtPath(reference["prim_path"])
        found[prim.GetCustomDataByKey("id")] = reference["object_type"]
        assert reference["parent_id"] == said["background"]["id"] == "house" and reference["id"].isidentifier()
    assert found == {key: "base" if body.fixed else "rigid" for key, body in bodies.items()}
    assert len({reference["id"] for reference in said["object_references"]}) == len(bodies)


def test_nothing_that_is_seen_is_without_a_label() -> None:
    """As whoever colours pictures by labels asks: a prim's own, or those of what it is in."""
    seen, words = 0, set[str]()
    for prim in drawn(stage("family"), "/House"):
        if prim.IsA(UsdGeom.Gprim) and UsdGeom.Imageable(prim).ComputePurpose() != "guide":
            found = UsdSemantics.LabelsQuery("class", Usd.TimeCode.Default()).ComputeUniqueInheritedLabels(prim)
            assert found, prim.GetPath()
            seen, words = seen + 1, words | set(found)
    assert seen > 100
    assert {"floor", "wall", "ceiling", "door", "frame", "glass", "threshold"} <= words
