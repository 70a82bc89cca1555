"""Fronts driven one by one in MuJoCo, to be held against what a home's certificate says of them."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Any, Final, NamedTuple

import mujoco
import numpy as np

from catalogs import Catalogs
from solver.exports import HouseModel
from solver.scene import Scene
from solver.validator.opening import WALL, FrontTravel
from tests.exports.physics import mjcf, started
from tests.validator.travels import front_travels

DEEP: Final = 0.0006
"""Solids that overlap by less touch, m."""
EARLIER: Final = {False: 2.0, True: 0.005}
"""How much sooner than the certificate says a front may meet something: degrees, of a drawer m; and as much later."""
LOOKS: Final = 24
"""At how many places of its way a front is looked at."""


class Near(NamedTuple):
    """What a front may meet: geoms, whose they are, and the upright boxes around them, one row each."""

    geoms: list[int]
    names: list[str]
    low: Any
    high: Any


class Solids(NamedTuple):
    """What touches others in a house: geoms, and whose they are."""

    world: Any
    geoms: list[int]
    names: list[str]

    def without(self, passed: Collection[str], state: Any) -> Near:
        """Returns all but some bodies', where they stand now."""
        kept = [(geom, name) for geom, name in zip(self.geoms, self.names, strict=True) if name not in passed]
        geoms = [geom for geom, _ in kept]
        return Near(geoms, [name for _, name in kept], *_spans(self.world, state, geoms))


def open_all(scene: Scene, model: HouseModel, catalogs: Catalogs) -> Iterator[str]:
    """Yields in words what a front meets that the certificate does not say, and what it does not meet that it does."""
    world, state = started(mjcf(model))
    geoms = _solids(world)
    carried = {body.id: {one.id for one in model.bodies if one.parent == body.id} for body in model.bodies if body.fronts}
    leaves = {leaf.id for leaf in model.leaves}
    people = {body.id for body in model.bodies if body.sort == "dynamic"}
    for travels in front_travels(scene, catalogs).values():
        for one in travels:
            yield from _driven(world, state, one, geoms.without(carried[one.piece] | people | {one.piece}, state), leaves)


def _driven(world: Any, state: Any, one: FrontTravel, near: Near, leaves: Collection[str]) -> Iterator[str]:
    name = f"{one.piece}/{one.front}"
    joint = world.joint(f"{name}/{'slide' if one.slides else 'hinge'}")
    end = max(joint.range, key=abs)
    unit = 1.0 if one.slides else math.pi / 180
    own = np.flatnonzero((world.geom_bodyid == world.jnt_bodyid[joint.id]) & (world.geom_group == 3))
    slack = EARLIER[one.slides]

    def met_at(way: float) -> set[str]:
        state.qpos[joint.qposadr[0]] = math.copysign(way * unit, end)
        return _touched(world, state, own, near)

    for way in np.linspace(0, max(one.travel - slack, 0.0), LOOKS):
        met = met_at(way)
        if met:
            yield f"{name} meets {', '.join(sorted(met))} at {way:.3f}, the certificate says {one.travel:.3f} ({one.meets})"
            break
    if one.meets is not None:
        past = [min(one.travel + share * slack, one.range) for share in (0.25, 0.5, 0.75, 1.0, 1.25, 1.5)]
        found: set[str] = set().union(*map(met_at, past))
        nearly_whole = not found and one.range - one.travel <= slack
        if one.meets not in found and not nearly_whole and not (one.meets == WALL and found & set(leaves)):
            yield f"{name} does not meet {one.meets} at {past[-1]:.3f} of {one.range:.3f}, but {sorted(found)}"
    state.qpos[joint.qposadr[0]] = 0.0
    mujoco.mj_kinematics(world, state)


def _solids(world: Any) -> Solids:
    """Returns all geoms that touch others, but for the ground, and whose they are: `wall` where they are the house's."""
    touching = (world.geom_group == 3) & ((world.geom_contype | world.geom_conaffinity) != 0)
    names = [WALL, *(world.body(int(root)).name for root in world.body_rootid[1:])]
    geoms = [int(geom) for geom in np.flatnonzero(touching) if world.geom(int(geom)).name != "ground"]
    return Solids(world, geoms, [names[world.geom_bodyid[geom]] for geom in geoms])


def _spans(world: Any, state: Any, geoms: Any) -> tuple[Any, Any]:
    """Returns the lowest and highest corners of the upright boxes around geoms."""
    turns = state.geom_xmat[geoms].reshape(-1, 3, 3)
    middles = state.geom_xpos[geoms] + np.einsum("nij,nj->ni", turns, world.geom_aabb[geoms, :3])
    halves = np.einsum("nij,nj->ni", np.abs(turns), world.geom_aabb[geoms, 3:])
    return middles - halves, middles + halves


def _touched(world: Any, state: Any, own: Any, near: Near) -> set[str]:
    """Returns what a front's own geoms touch where its joint stands now."""
    mujoco.mj_kinematics(world, state)
    low, high = _spans(world, state, own)
    together = ((low[:, None] < near.high) & (near.low < high[:, None])).all(axis=2)
    met: set[str] = set()
    for mine, other in np.argwhere(together):
        name = near.names[other]
        if name not in met and mujoco.mj_geomDistance(world, state, own[mine], near.geoms[other], 0.01, None) < -DEEP:
            met.add(name)
    return met
