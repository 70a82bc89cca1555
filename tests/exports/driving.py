"""A robot's base driven through a home in MuJoCo: on planar joints, along ways of our own over the description's floor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Final

import mujoco
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

from solver.exports import HouseModel
from solver.exports.model import FloorPlate
from tests.exports.physics import mjcf

RADIUS: Final = 0.25
HEIGHT: Final = 0.4
CLEARANCE: Final = 0.28
"""How far ways stay off everything, m: in a gap of 0.6 m, with a frame 1 cm proud, on a lattice of CELL."""
CELL: Final = 0.02
HANDLE: Final = 0.06
"""How far handles stand out of a leaf, m."""
CROSSED: Final = 1.0
"""So long a way through a room is a visit, m."""
SPEED: Final = 0.6
AHEAD: Final = 0.12
"""How far ahead on its way the base aims, m."""
BASE: Final = (
    '<body name="base" pos="{x} {y} {z}"><joint name="base_x" type="slide" axis="1 0 0"/><joint name="base_y" type="slide" axis="0 1 0"/>'
    f'<geom name="base" type="cylinder" size="{RADIUS} {HEIGHT / 2}" mass="40" friction="0.1" contype="1" conaffinity="3"/></body>'
)
MOTORS: Final = '<actuator><velocity joint="base_x" kv="2000"/><velocity joint="base_y" kv="2000"/></actuator>'


@dataclass
class Driven:
    """Which rooms were reached of how many, what was touched besides leaves, which leaves were pushed; the rooms that were not."""

    rooms: int
    reached: list[str] = field(default_factory=list)
    touched: set[str] = field(default_factory=set)
    pushed: set[str] = field(default_factory=set)
    missed: set[str] = field(default_factory=set)


class Floor:
    """The floor of a house as cells, north-west first: which are farther than CLEARANCE from all that stands.

    Args:
        model: the house.
        round_leaves: whether ways go round open leaves, else through them: the base then pushes them to and fro.
    """

    def __init__(self, model: HouseModel, round_leaves: bool) -> None:
        corners = np.array([corner for floor in model.rooms for corner in floor.corners])
        self.origin = corners.min(axis=0) - 0.5
        columns, rows = np.ceil((corners.max(axis=0) + 0.5 - self.origin) / CELL).astype(int)
        self.free = np.ones((rows, columns), dtype=bool)
        for box in (*(wall.box for wall in model.walls), *(one.box for one in model.fittings if one.surface != "threshold")):
            if box.y0 < HEIGHT:
                self._block((box.middle[0], box.middle[2]), (box.size[0], box.size[2]), 0.0)
        for body in model.bodies:
            if not body.flat and body.y < HEIGHT:
                self._block((body.x, body.z), (body.width, body.depth), body.turn)
        for leaf in model.leaves:
            if leaf.motion == "swing" and round_leaves:
                turn = math.radians(leaf.closed + leaf.swing)
                middle = leaf.hinge[0] + math.cos(turn) * leaf.width / 2, leaf.hinge[2] - math.sin(turn) * leaf.width / 2
                self._block(middle, (leaf.width, leaf.thickness), math.degrees(turn), RADIUS + HANDLE)
        inside = np.zeros_like(self.free)
        for floor in model.rooms:
            inside |= self.within(floor)
        self.free &= inside

    def _block(self, at: tuple[float, float], size: tuple[float, float], turn: float, clearance: float = CLEARANCE) -> None:
        """Takes away the cells near a rectangle."""
        (x, z), (width, depth) = at, size
        reach = math.hypot(width, depth) / 2 + clearance
        low = np.maximum(((np.array((x, z)) - reach - self.origin) / CELL).astype(int), 0)
        high = ((np.array((x, z)) + reach - self.origin) / CELL).astype(int) + 2
        part = self.free[low[1] : high[1], low[0] : high[0]]
        across = self.origin[0] + (low[0] + np.arange(part.shape[1]) + 0.5) * CELL - x
        down = (self.origin[1] + (low[1] + np.arange(part.shape[0]) + 0.5) * CELL - z)[:, None]
        angle = math.radians(turn)
        along = np.abs(across * math.cos(angle) - down * math.sin(angle)) - width / 2
        aside = np.abs(across * math.sin(angle) + down * math.cos(angle)) - depth / 2
        part &= np.hypot(np.maximum(along, 0), np.maximum(aside, 0)) > clearance

    def within(self, floor: FloorPlate) -> Any:
        """Returns which cells lie in a room."""
        rows, columns = self.free.shape
        x = (self.origin[0] + (np.arange(columns) + 0.5) * CELL)[None, :]
        z = (self.origin[1] + (np.arange(rows) + 0.5) * CELL)[:, None]
        inside = np.zeros(self.free.shape, dtype=bool)
        for (x0, z0), (x1, z1) in zip(floor.corners, (*floor.corners[1:], floor.corners[0]), strict=True):
            if z0 != z1:
                inside ^= ((z0 > z) != (z1 > z)) & (x < x0 + (z - z0) / (z1 - z0) * (x1 - x0))
        return inside

    def place(self, cell: int) -> tuple[float, float]:
        """Returns the middle of a cell, m."""
        row, column = divmod(cell, self.free.shape[1])
        return float(self.origin[0] + (column + 0.5) * CELL), float(self.origin[1] + (row + 0.5) * CELL)

    def graph(self) -> Any:
        """Returns which free cells are next to each other, and how far."""
        rows, columns = self.free.shape
        number = np.arange(rows * columns).reshape(rows, columns)
        ends: list[tuple[Any, Any, float]] = []
        for down, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
            one = (slice(0, rows - down), slice(max(-across, 0), columns - max(across, 0)))
            other = (slice(down, rows), slice(max(across, 0), columns + min(across, 0)))
            both = self.free[one] & self.free[other]
            ends.append((number[one][both], number[other][both], math.hypot(down, across) * CELL))
        start, end = (np.concatenate([pair[i] for pair in ends]) for i in (0, 1))
        far = np.concatenate([np.full(len(pair[0]), pair[2]) for pair in ends])
        return coo_matrix((far, (start, end)), shape=(rows * columns, rows * columns)).tocsr()


def drive(model: HouseModel) -> Driven:
    """Drives the base from the room with the main entrance to every room that doors or passages join, the farthest first.

    All doors are closed at each start; rooms that it crosses on its way are reached, too. Things that are fixed make it fast, and
    must not be touched either way.
    """
    floors = Floor(model, round_leaves=True), Floor(model, round_leaves=False)
    joined = {room for opening in model.openings if opening.kind != "window" for room in opening.rooms}
    inside = {plate.id: floors[0].within(plate).reshape(-1) for plate in model.rooms if plate.id in joined}
    entrance = next((room for one in model.openings if one.is_main_entrance for room in one.rooms if room), next(iter(inside)))
    here = _start(floors[0], inside[entrance])
    outcome = Driven(len(inside), [entrance])
    ride = _Ride(model, floors[0].place(here), outcome)
    for floor in floors:
        far, before = dijkstra(floor.graph(), directed=False, indices=here, return_predecessors=True)
        found = {room: _goal(cells & floor.free.reshape(-1), far) for room, cells in inside.items()}
        goals = {room: cell for room, cell in found.items() if cell is not None}
        for room in sorted(goals, key=lambda name: -float(far[goals[name]])):
            if room not in outcome.reached:
                way = [goals[room]]
                while way[-1] != here:
                    way.append(int(before[way[-1]]))
                if ride.along([floor.place(step) for step in reversed(way)]):
                    crossed = {name for name, cells in inside.items() if cells[way].sum() * CELL > CROSSED}
                    outcome.reached += sorted(crossed.union({room}) - set(outcome.reached))
    outcome.missed = set(inside) - set(outcome.reached)
    return outcome


def _start(floor: Floor, inside: Any) -> int:
    """Returns the cell of a room that is nearest to its middle, of those from which most of the house is reached."""
    _, labels = connected_components(floor.graph(), directed=False)
    most = max(set(labels[floor.free.reshape(-1) & inside]), key=lambda label: int((labels == label).sum()))
    cells = np.argwhere((inside & floor.free.reshape(-1) & (labels == most)).reshape(floor.free.shape))
    middle = np.argwhere(inside.reshape(floor.free.shape)).mean(axis=0)
    row, column = cells[np.argmin(((cells - middle) ** 2).sum(axis=1))]
    return int(row * floor.free.shape[1] + column)


def _goal(cells: Any, far: Any) -> int | None:
    """Returns the cell of a room that is reached, half of the room's others being farther."""
    numbers = np.flatnonzero(cells & np.isfinite(far))
    return int(numbers[np.argsort(far[numbers])[len(numbers) // 2]]) if len(numbers) else None


class _Ride:
    """The base in its home."""

    def __init__(self, model: HouseModel, start: tuple[float, float], outcome: Driven) -> None:
        text = mjcf(model)
        head, _, _ = text.partition("<keyframe>")
        base = BASE.format(x=start[0], y=-start[1], z=HEIGHT / 2 + 0.02)
        self.world = mujoco.MjModel.from_xml_string(head.replace("</worldbody>", base + "</worldbody>") + MOTORS + "</mujoco>")
        self.state, self.outcome, self.start = mujoco.MjData(self.world), outcome, start
        self.base = self.world.geom("base").id
        self.leaves = {leaf.id for leaf in model.leaves}
        self.joints = [self.world.joint(name).qposadr[0] for name in ("base_x", "base_y")]

    def _at(self) -> tuple[float, float]:
        x, y = (float(self.state.qpos[joint]) for joint in self.joints)
        return self.start[0] + x, self.start[1] - y

    def along(self, way: Sequence[tuple[float, float]]) -> bool:
        """Drives along a way, x and z in m, all doors closed first; returns whether its end was reached in three times its time."""
        mujoco.mj_resetData(self.world, self.state)
        goal, step = 0, 2
        length = sum(math.dist(a, b) for a, b in pairwise(way))
        for _ in range(int((length / SPEED * 3 + 5) / self.world.opt.timestep / step)):
            at = self._at()
            while goal < len(way) - 1 and math.dist(at, way[goal]) < AHEAD:
                goal += 1
            away = math.dist(at, way[goal])
            if goal == len(way) - 1 and away < 0.02:
                return True
            speed = min(SPEED, away * 5)
            self.state.ctrl[:] = (way[goal][0] - at[0]) / away * speed, (at[1] - way[goal][1]) / away * speed
            mujoco.mj_step(self.world, self.state, nstep=step)
            self._touch()
        return False

    def _touch(self) -> None:
        contacts = self.state.contact.geom[: self.state.ncon]
        for pair in contacts[(contacts == self.base).any(axis=1)]:
            other = int(pair[0] if pair[1] == self.base else pair[1])
            name = self.world.body(int(self.world.geom_bodyid[other])).name
            (self.outcome.pushed if name in self.leaves else self.outcome.touched).add(name)
