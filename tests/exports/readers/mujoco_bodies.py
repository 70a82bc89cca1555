"""The bodies of a model that MuJoCo compiled, in the scene's frame."""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np

from tests.exports.readers import Seen


def shows(world: Any, body: int) -> bool:
    """Tells whether a body is what another looks like."""
    return str(world.body(body).name).endswith("/looks")


def seen(world: Any, state: Any, body: int, group: int) -> Seen:
    """Returns a body with the extents of its geoms of a group, and of its fronts', shut; looks are bodies in them."""
    turn = math.degrees(math.atan2(state.xmat[body][3], state.xmat[body][0]))
    inside = [one for one in range(body + 1, world.nbody) if world.body_parentid[one] == body and body > 0]
    fronts = inside + [one for one in range(body + 1, world.nbody) if world.body_parentid[one] in inside and shows(world, one)]
    corners = np.array([
        np.array(_span(world, geom)) + _offset(world, one, body)
        for one in (body, *fronts)
        for geom in range(world.body_geomadr[one], world.body_geomadr[one] + world.body_geomnum[one])
        if world.geom_group[geom] == group
    ])  # fmt: skip
    width, depth, height = (float(extent) for extent in corners[:, 1].max(axis=0) - corners[:, 0].min(axis=0))
    x, y, z = (float(value) for value in state.xpos[body])
    return Seen(x, z, -y, turn % 360, width, depth, height, float(world.body_mass[[body, *fronts]].sum()))


def _offset(world: Any, part: int, body: int) -> Any:
    """Returns where a part of a body is in it, none of them turned."""
    return 0.0 if part == body else world.body_pos[part] + _offset(world, int(world.body_parentid[part]), body)


def _span(world: Any, geom: int) -> tuple[Any, Any]:
    """Returns the corners of the box around a geom, in its body's frame."""
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, world.geom_quat[geom])
    turned, at, size = matrix.reshape(3, 3), world.geom_pos[geom], world.geom_size[geom]
    if world.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = int(world.geom_dataid[geom])
        start, count = int(world.mesh_vertadr[mesh]), int(world.mesh_vertnum[mesh])
        points = world.mesh_vert[start : start + count] @ turned.T + at
        return points.min(axis=0), points.max(axis=0)
    along = {mujoco.mjtGeom.mjGEOM_CYLINDER: 0.0, mujoco.mjtGeom.mjGEOM_CAPSULE: size[0]}.get(mujoco.mjtGeom(world.geom_type[geom]))
    half = np.abs(turned) @ (size if along is None else np.array([size[0], size[0], size[1] + along]))
    return at - half, at + half
