"""MJCF as MuJoCo reads it: bodies, masses, joints, names; things stay, doors swing, a base drives."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import mujoco
import pytest

from catalogs import load_catalogs
from solver.exports import describe
from solver.exports.model import HouseModel
from solver.scene import Furniture, Opening, Room, Scene
from tests.exports.driving import drive
from tests.exports.homes import SCENES, default, described, own
from tests.exports.physics import mjcf, settle, started, swung

HOMES = [*SCENES, "hostile", "storeys"]


def free(model: HouseModel) -> list[str]:
    return [body.id for body in model.bodies if not body.fixed]


@pytest.mark.parametrize("home", HOMES)
def test_a_home_compiles_with_all_bodies_masses_and_joints(home: str) -> None:
    model = described(home)
    world, state = started(mjcf(model))
    for body in model.bodies:
        made = world.body(body.id)
        assert made.subtreemass[0] == pytest.approx(body.mass, rel=1e-6)
        assert state.body(body.id).xpos == pytest.approx((body.x, -body.z, body.y), abs=1e-5)
        assert made.jntnum[0] == (0 if body.fixed else 1)
    assert world.njnt == len(free(model)) + len(model.leaves) + sum(len(body.fronts) for body in model.bodies)
    for leaf in model.leaves:
        joint = world.joint(world.body(leaf.id).jntadr[0])
        ends = sorted((0.0, math.radians(leaf.swing))) if leaf.motion == "swing" else [0.0, leaf.height]
        assert joint.range == pytest.approx(ends)
        assert world.body(leaf.id).mass[0] == pytest.approx(leaf.mass, rel=1e-6)


@pytest.mark.parametrize("home", HOMES)
def test_rugs_and_looks_touch_nothing(home: str) -> None:
    model = described(home)
    world, _ = started(mjcf(model))
    flat = {world.body(body.id).id for body in model.bodies if body.flat}
    for geom in range(world.ngeom):
        touches = bool(world.geom_contype[geom] or world.geom_conaffinity[geom])
        assert touches == (world.geom_group[geom] == 3 and int(world.geom_bodyid[geom]) not in flat)


def test_what_touches_has_its_looks_in_a_body_that_does_not() -> None:
    """In every step MuJoCo bounds all geoms of the bodies that touch anything."""
    world, _ = started(mjcf(described("family")))
    looks = [geom for geom in range(world.ngeom) if world.geom_group[geom] == 2 and world.geom_bodyid[geom]]
    assert len(looks) > 1000
    for geom in looks:
        body = int(world.geom_bodyid[geom])
        own = world.body(int(world.body_parentid[body])).name
        assert world.body(body).name == f"{own}/looks"
        assert not world.body_contype[body] and not world.body_conaffinity[body]


def test_the_key_home_is_where_things_stand() -> None:
    world, state = started(mjcf(described("own")))
    assert abs(state.qpos - world.qpos0).max() < 1e-5


def test_a_site_stands_where_a_piece_is_used_and_looks_at_it() -> None:
    model = described("own")
    _, state = started(mjcf(model))
    used = [body for body in model.bodies if body.uses]
    assert used
    for body in used:
        first = state.site(f"{body.id}/use")
        x, z, turn = body.uses[0]
        assert first.xpos == pytest.approx((x, -z, 0.0), abs=1e-5)
        ahead = first.xpos + first.xmat.reshape(3, 3)[:, 0]
        assert ahead[:2] == pytest.approx((x + math.sin(math.radians(turn)), -z - math.cos(math.radians(turn))), abs=1e-5)


def test_it_says_where_it_is_from_and_what_things_are() -> None:
    scene = replace(own(), seed=7, generator={"version": "1", "catalog": "abc"})
    model = describe(scene, load_catalogs(), warnings=["two -- hyphens & <tags>"])
    world, _ = started(mjcf(model))

    def said(name: str) -> str:
        text = mujoco.mj_name2id(world, mujoco.mjtObj.mjOBJ_TEXT, name)
        first = int(world.text_adr[text])
        return bytes(world.text_data[first : first + int(world.text_size[text])]).decode().rstrip("\0")

    assert (said("seed"), said("catalog"), said("warnings")) == ("7", "abc", "two -- hyphens & <tags>")
    assert json.loads(said("labels")) == {body.id: list(body.labels) for body in model.bodies}


def test_freedom_is_as_asked_for() -> None:
    counts = {}
    for freedom in ("none", "light", "standing"):
        world, _ = started(mjcf(describe(own(), load_catalogs(), free=freedom)))
        counts[freedom] = sum(kind == mujoco.mjtJoint.mjJNT_FREE for kind in world.jnt_type)
    assert 0 == counts["none"] < counts["light"] < counts["standing"]


def test_ids_that_are_given_twice_compile() -> None:
    scene = own()
    room = scene.rooms[1]
    twice = replace(room, furniture=(*room.furniture, replace(room.furniture[1], z=3.5)))
    world, _ = started(mjcf(describe(replace(scene, rooms=(scene.rooms[0], twice, *scene.rooms[2:])), load_catalogs())))
    assert world.body(f"{room.furniture[1].id}_2").mass[0] > 0


def _with(piece: Furniture) -> HouseModel:
    scene = own()
    rooms = tuple(replace(room, furniture=(*room.furniture, piece)) if room.id == "bed" else room for room in scene.rooms)
    return describe(Scene(wall_thickness=0.1, rooms=rooms), load_catalogs())


def test_things_of_a_home_stay_where_they_are() -> None:
    done = settle(mjcf(described("family")))
    assert done.free > 200
    assert done.moved == []


def test_a_home_comes_to_rest_and_what_is_lifted_then_falls() -> None:
    world, state = started(mjcf(described("family")))
    mujoco.mj_step(world, state, nstep=1250)
    asleep = [body for body in range(world.nbody) if world.body_treeid[body] >= 0 and not state.tree_awake[world.body_treeid[body]]]
    assert len(asleep) > 200
    assert not state.tree_awake.any()
    lifted = next(number for number in range(world.njnt) if world.jnt_type[number] == mujoco.mjtJoint.mjJNT_FREE)
    height = world.jnt_qposadr[lifted] + 2
    lies = float(state.qpos[height])
    state.qpos[height] += 0.02
    mujoco.mj_step(world, state, nstep=250)
    assert abs(float(state.qpos[height]) - lies) < 0.005


def test_a_thing_that_stands_in_another_is_seen_to_move() -> None:
    done = settle(mjcf(_with(Furniture("bed/stool_2", "stool", x=0.95, z=1.65, width=0.4, depth=0.4, height=0.45))), seconds=1.0)
    assert any("bed/stool_2" in line for line in done.moved)


def test_doors_swing_free_and_what_is_in_their_way_is_seen() -> None:
    assert list(swung(mjcf(described("family")))) == []
    met = list(swung(mjcf(_with(Furniture("bed/chest", "chest", x=1.0, z=3.4, width=0.5, depth=0.3, height=0.5)))))
    assert any("door_back meets bed/chest" in line for line in met)


def test_a_base_drives_to_every_room() -> None:
    """Of a small home: one of five of `make targets` is driven through, large ones too."""
    done = drive(describe(default(), load_catalogs(), free="none"))
    assert len(done.reached) == done.rooms == 4
    assert done.touched == set()
    assert done.pushed


def _behind_a_leaf(*more: Furniture) -> HouseModel:
    """Three rooms in a row; in the middle one an open leaf stands between its door and the way on, round a block as high as a man."""
    door = Opening("door", wall="south", position=2.0, width=0.9, connects_to="middle", hinge="start", swing="out")
    front = Opening("front", wall="north", position=2.0, width=0.9, connects_to="EXTERIOR", hinge="start", swing="in", main_entrance=True)
    way_on = Opening("way_on", wall="south", position=0.6, width=0.9, connects_to="last", kind="passage")
    block = Furniture("block", "block", x=2.5, z=2.5, width=2.9, depth=2.9, height=1.8)
    rooms = (
        Room("first", 0, "hallway", z=0.0, width=4.0, depth=2.0, openings=(front, door)),
        Room("middle", 1, "bedroom", z=2.0, width=4.0, depth=4.0, openings=(way_on,), furniture=(block, *more)),
        Room("last", 2, "bathroom", z=6.0, width=4.0, depth=2.0),
    )
    return describe(Scene(wall_thickness=0.1, rooms=rooms), load_catalogs(), free="none")


def test_a_base_closes_a_leaf_behind_it_that_is_in_its_way() -> None:
    done = drive(_behind_a_leaf())
    assert (done.missed, done.touched, done.closed) == (set(), set(), {"door"})


def test_a_base_that_has_no_floor_to_stand_beside_a_leaf_does_not_pass_it() -> None:
    done = drive(_behind_a_leaf(Furniture("chest", "chest", x=3.2, z=0.55, width=1.4, depth=0.9, height=0.5)))
    assert done.missed == {"last"}
    assert done.touched == set()


def test_a_piece_may_be_called_as_mujoco_calls_what_all_hang_on() -> None:
    piece = Furniture("world", "dining_table", x=2.0, z=2.0, width=1.6, depth=0.9, height=0.75)
    model = describe(Scene(rooms=(Room("r", 0, "office", width=4.0, depth=4.0, furniture=(piece,)),)), load_catalogs())
    world, state = started(mjcf(model))
    assert list(state.body("world_2").xpos) == [2.0, -2.0, 0.0]
    assert world.body("world_2").subtreemass[0] == pytest.approx(model.bodies[0].mass)
