"""Reads MJCF with MuJoCo, in its key `home`."""

from __future__ import annotations

from collections.abc import Mapping

import mujoco

from tests.exports.readers import Seen
from tests.exports.readers.mujoco_bodies import seen, shows


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    (content,) = files.values()
    world = mujoco.MjModel.from_xml_string(content.decode())
    state = mujoco.MjData(world)
    mujoco.mj_resetDataKeyframe(world, state, world.key("home").id)
    mujoco.mj_kinematics(world, state)
    hinged = {int(world.jnt_bodyid[i]) for i in range(world.njnt) if world.jnt_type[i] != mujoco.mjtJoint.mjJNT_FREE}
    things = [i for i in range(1, world.nbody) if i not in hinged and not shows(world, i)]
    return {world.body(i).name: seen(world, state, i, 2) for i in things}
