"""Fronts driven one by one in MuJoCo, to be held against what a home's certificate says of them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from typing import Any, Final

import mujoco
import numpy as np

from catalogs import Catalogs
from solver.exports import HouseModel
from solver.scene import Scene
from solver.validator.opening import WALL, FrontTravel, front_travels
from tests.exports.physics import mjcf, started

DEEP: Final = 0.0006
"""Solids that overlap by less touch, m."""
EARLIER: Final = {False: 2.0, True: 0.005}
"""How much sooner than the certificate says a front may meet something: degrees, of a drawer m; and as much later."""
LOOKS: Final = 24
"""At how many places of its way a front is looked at."""


def open_all(scene: Scene, model: HouseModel, catalogs: Catalogs) -> Iterator[str]:
    """Yields in words what a front meets that the certificate does not say, and what it does not meet that it does."""
    world, state = started(mjcf(model))
    carried = {body.id: {one.id for one in model.bodies if one.parent == body.id} for body in model.bodies if body.fronts}
    leaves = {leaf.id for leaf in model.leaves}
    people = {body.id for body in model.bodies if body.sort == "dynamic"}
    for travels in front_travels(scene, catalogs).values():
        for one in travels:
            yield from _driven(world, state, one, carried[one.piece] | people | {one.piece}, leaves)


def _driven(world: Any, state: Any, one: FrontTravel, passed: Collection[str], leaves: Collection[str]) -> Iterator[str]:
    name = f"{one.piece}/{one.front}"
    joint = world.joint(f"{name}/{'slide' if one.slides else 'hinge'}")
    end = max(joint.range, key=abs)
    unit = 1.0 if one.slides else math.pi / 180
    near = _near(world, state, world.body(name).id, passed)
    slack = EARLIER[one.slides]
    for way in np.linspace(0, max(one.travel - slack, 0.0), LOOKS):
        met = _touched(world, state, joint, math.copysign(way * unit, end), near)
        if met:
            yield f"{name} meets {', '.join(sorted(met))} at {way:.3f}, the certificate says {one.travel:.3f} ({one.meets})"
            break
    if one.meets is not None:
        past = [min(one.travel + share * slack, one.range) for share in (0.25, 0.5, 0.75, 1.0, 1.25, 1.5)]
        found: set[str] = set().union(*(_touched(world, state, joint, math.copysign(way * unit, end), near) for way in past))
        if one.meets not in found and not (one.meets == WALL and found & set(leaves)):
            yield f"{name} does not meet {one.meets} at {past[-1]:.3f} of {one.range:.3f}, but {sorted(found)}"
    _touched(world, state, joint, 0.0, {})


def _near(world: Any, state: Any, body: int, passed: Collection[str]) -> Mapping[int, str]:
    """Returns what a front may meet, by geom: walls too."""
    own = [geom for geom in range(world.ngeom) if world.geom_bodyid[geom] == body]
    reach = 2 * max(float(world.geom_rbound[geom] + np.linalg.norm(world.geom_pos[geom])) for geom in own)
    found = {}
    for geom in range(world.ngeom):
        other = int(world.geom_bodyid[geom])
        top = other
        while world.body_parentid[top]:
            top = int(world.body_parentid[top])
        name = world.body(top).name
        solid = world.geom_group[geom] == 3 and (world.geom_contype[geom] or world.geom_conaffinity[geom])
        if other == body or not solid or name in passed or world.geom(geom).name == "ground":
            continue
        if np.linalg.norm(state.geom_xpos[geom] - state.xpos[body]) < reach + world.geom_rbound[geom]:
            found[geom] = name if other else WALL
    return found


def _touched(world: Any, state: Any, joint: Any, at: float, near: Mapping[int, str]) -> set[str]:
    state.qpos[joint.qposadr[0]] = at
    mujoco.mj_kinematics(world, state)
    body = int(world.jnt_bodyid[joint.id])
    own = [geom for geom in range(world.ngeom) if world.geom_bodyid[geom] == body and world.geom_group[geom] == 3]
    met = set()
    for other, name in near.items():
        if name not in met and any(mujoco.mj_geomDistance(world, state, mine, other, 0.01, None) < -DEEP for mine in own):
            met.add(name)
    return met
