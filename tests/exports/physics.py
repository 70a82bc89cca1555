"""What a home does in MuJoCo: whether things stay, whether doors swing freely, how fast it runs."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from copy import copy
from functools import lru_cache
from typing import Any, Final, NamedTuple

import mujoco
import numpy as np

from solver.exports import ExportSettings, HouseModel, written_as

STEP: Final = 0.004
FURTHEST: Final = 0.005
"""How far a thing that is free may move of its own, m."""
MOST_TURN: Final = 1.0
"""How far it may turn, degrees."""
DEEP: Final = 0.0005
"""Solids that overlap by less touch, m."""
SWEEP: Final = tuple(range(0, 91, 3))
"""Where a door is looked at on its way, degrees."""
LONGEST: Final = 1.5
"""No leaf is wider, m."""
AT_HINGE: Final = 0.1
"""So near the hinge a leaf is in its own frame, m."""


class Settled(NamedTuple):
    """What a home did in some seconds: its free things, those that moved (words), steps a second of processor time."""

    free: int
    moved: list[str]
    speed: float


def mjcf(model: HouseModel) -> str:
    """Returns a house as MJCF."""
    (content,) = written_as(model, ExportSettings("mjcf")).values()
    return content.decode()


@lru_cache(8)
def _compiled(text: str) -> Any:
    """What MuJoCo makes of a house: to compile one of many bodies takes as long as seconds in it."""
    return mujoco.MjModel.from_xml_string(text)


def started(text: str) -> tuple[Any, Any]:
    """Returns a model, the caller's own, and its state at its key `home`."""
    world = copy(_compiled(text))
    state = mujoco.MjData(world)
    mujoco.mj_resetDataKeyframe(world, state, world.key("home").id)
    mujoco.mj_forward(world, state)
    return world, state


def settle(text: str, seconds: float = 5.0) -> Settled:
    """Lets a house be; nothing is kept from touching anything."""
    world, state = started(text)
    assert world.opt.timestep == STEP
    assert world.nexclude == sum(world.body(int(world.jnt_bodyid[i])).parentid[0] != 0 for i in range(world.njnt)), (
        "a front and its body, none else"
    )
    places, turns = state.xpos.copy(), state.xquat.copy()
    begin = time.process_time()
    mujoco.mj_step(world, state, nstep=round(seconds / STEP))
    spent = time.process_time() - begin
    free = [int(world.jnt_bodyid[i]) for i in range(world.njnt) if world.jnt_type[i] == mujoco.mjtJoint.mjJNT_FREE]
    moved = []
    for body in free:
        way = float(np.linalg.norm(state.xpos[body] - places[body]))
        turn = math.degrees(2 * math.acos(min(1.0, abs(float(state.xquat[body] @ turns[body])))))
        if way > FURTHEST or turn > MOST_TURN:
            moved.append(f"{world.body(body).name}: {way * 1000:.1f} mm, {turn:.1f} degrees")
    return Settled(len(free), moved, round(seconds / STEP) / spent)


def swung(text: str) -> Iterator[str]:
    """Swings every door through 90 degrees, the others closed; yields what it meets on its way, walls too."""
    world, state = started(text)
    for joint in range(world.njnt):
        if world.jnt_type[joint] == mujoco.mjtJoint.mjJNT_HINGE and not world.body_parentid[world.jnt_bodyid[joint]]:
            yield from _swung(world, state, joint)


def _swung(world: Any, state: Any, joint: int) -> Iterator[str]:
    leaf, address = int(world.jnt_bodyid[joint]), world.jnt_qposadr[joint]
    geoms = range(world.body_geomadr[leaf], world.body_geomadr[leaf] + world.body_geomnum[leaf])
    own = [one for one in geoms if world.geom_group[one] == 3]
    hinge, end = state.xanchor[joint].copy(), max(world.jnt_range[joint], key=abs)
    near = [one for one in range(world.ngeom) if world.geom_bodyid[one] != leaf and _is_near(world, state, one, hinge)]
    met: dict[str, int] = {}
    for degrees in SWEEP:
        state.qpos[address] = math.copysign(math.radians(degrees), end)
        mujoco.mj_kinematics(world, state)
        for mine in own:
            for other in near:
                ends = np.zeros(6)
                gap = mujoco.mj_geomDistance(world, state, mine, other, 0.01, ends)
                if gap < -DEEP and np.linalg.norm(ends[:2] - hinge[:2]) > AT_HINGE:
                    name = world.body(int(world.geom_bodyid[other])).name
                    met.setdefault(name, degrees)
    state.qpos[address] = 0.0
    mujoco.mj_kinematics(world, state)
    yield from (f"{world.body(leaf).name} meets {name} at {degrees} degrees" for name, degrees in met.items())


def _is_near(world: Any, state: Any, geom: int, hinge: Any) -> bool:
    """Tells whether a leaf may reach a geom that others can touch."""
    solid = world.geom_contype[geom] and world.geom_type[geom] != mujoco.mjtGeom.mjGEOM_PLANE
    return bool(solid and np.linalg.norm(state.geom_xpos[geom][:2] - hinge[:2]) < LONGEST + world.geom_rbound[geom])
