"""Reads URDF with MuJoCo, which keeps visual geoms in group 1."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any

import mujoco

from tests.exports.readers import Seen
from tests.exports.readers.mujoco_bodies import seen

WHOLE = '<mujoco><compiler fusestatic="false" discardvisual="false"/></mujoco>'
"""What keeps MuJoCo from joining fixed links and from dropping looks."""


def compiled(files: Mapping[str, bytes]) -> Any:
    """Returns the robot as MuJoCo compiles it, every link a body."""
    (text,) = (content.decode() for name, content in files.items() if name.endswith(".urdf"))
    meshes = {PurePosixPath(name).name: content for name, content in files.items() if name.endswith(".obj")}
    return mujoco.MjModel.from_xml_string(text.replace("</robot>", WHOLE + "</robot>"), meshes)


def read(files: Mapping[str, bytes]) -> dict[str, Seen]:
    world = compiled(files)
    state = mujoco.MjData(world)
    mujoco.mj_kinematics(world, state)
    still = [i for i in range(2, world.nbody) if not world.body_jntnum[i]]
    return {world.body(i).name: seen(world, state, i, 1) for i in still}
