"""A robot's base driven through a home in MuJoCo: on planar joints, along ways of our own over the description's floor."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby, pairwise
from typing import Any, Final, NamedTuple

import mujoco
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

from solver.exports import HouseModel
from solver.exports.model import DoorLeaf, FloorPlate
from tests.exports.physics import mjcf

RADIUS: Final = 0.25
HEIGHT: Final = 0.4
WAYS: Final = ((0.28, 0.12), (0.26, 0.06))
"""How far ways stay off everything and how far ahead on them the base aims, m: in a gap of 0.6 m, with a frame 1 cm proud, on a lattice
of CELL; where that does not lead on, closer and more slowly."""
CELL: Final = 0.02
HANDLE: Final = 0.06
"""How far ways round an open leaf stay off it besides: its handle is less, m."""
BEHIND: Final = 2.0
"""So near the hinge of a leaf that was closed behind the base its ways may begin and end, m."""
STOP: Final = 1.0
"""As many metres as closing or opening a leaf is worth."""
TORQUE: Final = 5.0
"""What turns a leaf then, Nm: 6 N at its handle."""
TURNED: Final = 2.0
"""So near its end a leaf has been turned, degrees."""
CROSSED: Final = 1.0
"""So long a way through a room is a visit, m."""
SPEED: Final = 0.6
STEPS: Final = 2
"""After so many steps of the simulation the base is steered anew."""
BASE: Final = (
    '<body name="base" pos="{x} {y} {z}"><joint name="base_x" type="slide" axis="1 0 0"/><joint name="base_y" type="slide" axis="0 1 0"/>'
    f'<geom name="base" type="cylinder" size="{RADIUS} {HEIGHT / 2}" mass="40" friction="0.1" contype="1" conaffinity="3"/></body>'
)
MOTORS: Final = '<actuator><velocity joint="base_x" kv="2000"/><velocity joint="base_y" kv="2000"/></actuator>'


@dataclass
class Driven:
    """Which rooms were reached of how many; what was touched besides leaves; leaves pushed, and closed behind it; rooms not reached."""

    rooms: int
    reached: list[str] = field(default_factory=list)
    touched: set[str] = field(default_factory=set)
    pushed: set[str] = field(default_factory=set)
    closed: set[str] = field(default_factory=set)
    missed: set[str] = field(default_factory=set)


class Stand(NamedTuple):
    """Where a way leads, x and z in m, and the leaf that is closed then, if one is."""

    x: float
    z: float
    closed: str | None


class Floor:
    """The floor of a house as cells, north-west first: which are farther than a clearance, m, from all that stands.

    `free` is so with all leaves open. A layer a leaf, about its hinge, says what is free with that leaf closed. Between the two the base
    stands where no leaf can hit it. A node of the graph is a cell, or a cell of a layer.
    """

    def __init__(self, model: HouseModel, clearance: float) -> None:
        corners = np.array([corner for floor in model.rooms for corner in floor.corners])
        self.origin = corners.min(axis=0) - 0.5
        columns, rows = np.ceil((corners.max(axis=0) + 0.5 - self.origin) / CELL).astype(int)
        bare = np.zeros((rows, columns), dtype=bool)
        self.free = bare
        for floor in model.rooms:
            bare |= self.within(floor)
        for box in (*(wall.box for wall in model.walls), *(one.box for one in model.fittings if one.surface != "threshold")):
            if box.y0 < HEIGHT:
                self._block(bare, (box.middle[0], box.middle[2]), (box.size[0], box.size[2]), 0.0, clearance)
        for body in model.bodies:
            if not body.flat and body.y < HEIGHT:
                self._block(bare, (body.x, body.z), (body.width, body.depth), body.turn, clearance)
        for leaf in model.leaves:
            if leaf.motion == "roll":
                self._block(bare, *_footprint(leaf, 0.0), clearance)
        leaves = [leaf for leaf in model.leaves if leaf.motion == "swing"]
        self.free = self._with(bare, leaves, None)
        self.layers = [(leaf, *self._behind(bare, leaves, leaf)) for leaf in leaves]

    def _with(self, bare: Any, leaves: Sequence[DoorLeaf], closed: DoorLeaf | None) -> Any:
        """Returns which cells are free with all leaves open but one."""
        free = bare.copy()
        for leaf in leaves:
            self._block(free, *_footprint(leaf, 0.0 if leaf is closed else leaf.swing), RADIUS + HANDLE)
        return free

    def _behind(self, bare: Any, leaves: Sequence[DoorLeaf], leaf: DoorLeaf) -> tuple[Any, Any, Any]:
        """Returns the cells about a leaf's hinge, which are free with it closed, and from which of them it can be turned."""
        rows, columns = np.indices(bare.shape, sparse=True)
        at = (columns + 0.5) * CELL + self.origin[0] - leaf.hinge[0], (rows + 0.5) * CELL + self.origin[1] - leaf.hinge[2]
        away = np.hypot(*at)
        numbers = np.arange(bare.size).reshape(bare.shape)
        low, high = (np.argwhere(away < BEHIND).min(axis=0), np.argwhere(away < BEHIND).max(axis=0) + 1)
        near = slice(low[0], high[0]), slice(low[1], high[1])
        free = self._with(bare, leaves, leaf) & (away < BEHIND)
        return numbers[near], free[near], (free & self.free & (away > leaf.width + RADIUS + HANDLE))[near]

    def _block(self, free: Any, at: tuple[float, float], size: tuple[float, float], turn: float, clearance: float) -> None:
        """Takes away the cells near a rectangle."""
        (x, z), (width, depth) = at, size
        reach = math.hypot(width, depth) / 2 + clearance
        low = np.maximum(((np.array((x, z)) - reach - self.origin) / CELL).astype(int), 0)
        high = ((np.array((x, z)) + reach - self.origin) / CELL).astype(int) + 2
        part = free[low[1] : high[1], low[0] : high[0]]
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

    def stand(self, node: int) -> Stand:
        """Returns the middle of a node's cell, and which leaf is closed."""
        cell, closed, first = node, None, self.free.size
        for leaf, numbers, _, _ in self.layers:
            if first <= node < first + numbers.size:
                cell, closed = int(numbers.reshape(-1)[node - first]), leaf.id
            first += numbers.size
        row, column = divmod(cell, self.free.shape[1])
        return Stand(float(self.origin[0] + (column + 0.5) * CELL), float(self.origin[1] + (row + 0.5) * CELL), closed)

    def graph(self) -> Any:
        """Returns which nodes are next to each other, and how far."""
        numbers = np.arange(self.free.size).reshape(self.free.shape)
        edges, first = list(_steps(numbers, self.free)), self.free.size
        for _, below, free, turns in self.layers:
            here = first + np.arange(below.size).reshape(below.shape)
            edges += [*_steps(here, free), (below[turns], here[turns], STOP)]
            first += below.size
        start, end = (np.concatenate([edge[i] for edge in edges]) for i in (0, 1))
        far = np.concatenate([np.full(len(edge[0]), edge[2]) for edge in edges])
        return coo_matrix((far, (start, end)), shape=(first, first)).tocsr()


def _footprint(leaf: DoorLeaf, opened: float) -> tuple[tuple[float, float], tuple[float, float], float]:
    """Returns where a leaf stands that has turned by some degrees: its middle, its width and thickness, m, and its turn, degrees."""
    turn = math.radians(leaf.closed + opened)
    middle = leaf.hinge[0] + math.cos(turn) * leaf.width / 2, leaf.hinge[2] - math.sin(turn) * leaf.width / 2
    return middle, (leaf.width, leaf.thickness), leaf.closed + opened


def _steps(numbers: Any, free: Any) -> Iterator[tuple[Any, Any, float]]:
    """Yields the free cells that are next to each other: their numbers, and how far apart they are."""
    rows, columns = free.shape
    for down, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
        one = (slice(0, rows - down), slice(max(-across, 0), columns - max(across, 0)))
        other = (slice(down, rows), slice(max(across, 0), columns + min(across, 0)))
        both = free[one] & free[other]
        yield numbers[one][both], numbers[other][both], math.hypot(down, across) * CELL


def drive(model: HouseModel) -> Driven:
    """Drives the base from the room with the main entrance to every room that doors or passages join, the farthest first.

    All doors are closed at each start. The base pushes them open; where an open leaf is in its way, the leaf is closed behind it, by a
    torque such as an arm has, while it stands still. Rooms that it crosses on its way are reached, too. Things that are fixed make it
    fast, and must not be touched either way.
    """
    floor = Floor(model, WAYS[0][0])
    joined = {room for opening in model.openings if opening.kind != "window" for room in opening.rooms}
    inside = {plate.id: floor.within(plate).reshape(-1) for plate in model.rooms if plate.id in joined}
    entrance = next((room for one in model.openings if one.is_main_entrance for room in one.rooms if room), next(iter(inside)))
    here = _start(floor, inside[entrance])
    outcome = Driven(len(inside), [entrance])
    ride = _Ride(model, floor.stand(here), outcome)
    for clearance, ride.ahead in WAYS:
        if set(inside) - set(outcome.reached):
            _visit(Floor(model, clearance), here, inside, ride)
    outcome.missed = set(inside) - set(outcome.reached)
    return outcome


def _visit(floor: Floor, here: int, inside: Mapping[str, Any], ride: _Ride) -> None:
    """Drives to the rooms that were not reached, each from the start."""
    reached = ride.outcome.reached
    far, before = dijkstra(floor.graph(), directed=False, indices=here, return_predecessors=True)
    found = {room: _goal(cells & floor.free.reshape(-1), far) for room, cells in inside.items()}
    goals = {room: cell for room, cell in found.items() if cell is not None}
    for room in sorted(goals, key=lambda name: -float(far[goals[name]])):
        if room not in reached:
            way = [goals[room]]
            while way[-1] != here:
                way.append(int(before[way[-1]]))
            if ride.along([floor.stand(node) for node in reversed(way)]):
                steps = [node for node in way if node < floor.free.size]
                crossed = {name for name, cells in inside.items() if cells[steps].sum() * CELL > CROSSED}
                reached += sorted(crossed.union({room}) - set(reached))


def _start(floor: Floor, inside: Any) -> int:
    """Returns the cell of a room that is nearest to its middle, of those from which most of the house is reached."""
    _, labels = connected_components(floor.graph(), directed=False)
    labels = labels[: floor.free.size]
    most = max(set(labels[floor.free.reshape(-1) & inside]), key=lambda label: int((labels == label).sum()))
    cells = np.argwhere((inside & floor.free.reshape(-1) & (labels == most)).reshape(floor.free.shape))
    middle = np.argwhere(inside.reshape(floor.free.shape)).mean(axis=0)
    row, column = cells[np.argmin(((cells - middle) ** 2).sum(axis=1))]
    return int(row * floor.free.shape[1] + column)


def _goal(cells: Any, far: Any) -> int | None:
    """Returns the cell of a room that is reached, half of the room's others being farther."""
    numbers = np.flatnonzero(cells & np.isfinite(far[: cells.size]))
    return int(numbers[np.argsort(far[numbers])[len(numbers) // 2]]) if len(numbers) else None


class _Ride:
    """The base in its home."""

    def __init__(self, model: HouseModel, start: Stand, outcome: Driven) -> None:
        text = mjcf(model)
        head, _, _ = text.partition("<keyframe>")
        base = BASE.format(x=start.x, y=-start.z, z=HEIGHT / 2 + 0.02)
        self.world = mujoco.MjModel.from_xml_string(head.replace("</worldbody>", base + "</worldbody>") + MOTORS + "</mujoco>")
        self.state, self.outcome, self.start, self.ahead = mujoco.MjData(self.world), outcome, start, WAYS[0][1]
        self.base = self.world.geom("base").id
        self.leaves = {leaf.id: leaf for leaf in model.leaves}
        self.joints = [self.world.joint(name).qposadr[0] for name in ("base_x", "base_y")]

    def _at(self) -> tuple[float, float]:
        x, y = (float(self.state.qpos[joint]) for joint in self.joints)
        return self.start.x + x, self.start.z - y

    def along(self, way: Sequence[Stand]) -> bool:
        """Drives along a way, all doors closed first; returns whether its end was reached."""
        mujoco.mj_resetData(self.world, self.state)
        shut: str | None = None
        for closed, stretch in groupby(way, key=lambda stand: stand.closed):
            if closed != shut and not (self._turned(closed or shut, closed is not None)):
                return False
            shut = closed
            if not self._drove([(stand.x, stand.z) for stand in stretch]):
                return False
        return True

    def _turned(self, name: str | None, closing: bool) -> bool:
        """Closes or opens a leaf, the base standing still; returns whether it is so within 20 s. It is held closed, left open."""
        leaf = self.leaves[name or ""]
        joint = self.world.joint(int(self.world.body(leaf.id).jntadr[0]))
        wanted, sign = (0.0 if closing else leaf.swing), math.copysign(1.0, leaf.swing)
        self.state.ctrl[:] = 0.0
        self.state.qfrc_applied[joint.dofadr[0]] = -sign * TORQUE if closing else sign * TORQUE
        for _ in range(int(20 / self.world.opt.timestep / STEPS)):
            mujoco.mj_step(self.world, self.state, nstep=STEPS)
            self._touch()
            if abs(math.degrees(float(self.state.qpos[joint.qposadr[0]])) - wanted) < TURNED:
                self.outcome.closed.add(leaf.id)
                self.state.qfrc_applied[joint.dofadr[0]] *= closing
                return True
        return False

    def _drove(self, way: Sequence[tuple[float, float]]) -> bool:
        """Drives along a stretch, x and z in m; returns whether its end was reached in three times its time."""
        goal = 0
        length = sum(math.dist(a, b) for a, b in pairwise(way))
        for _ in range(int((length / SPEED * 3 + 5) / self.world.opt.timestep / STEPS)):
            at = self._at()
            while goal < len(way) - 1 and math.dist(at, way[goal]) < self.ahead:
                goal += 1
            away = math.dist(at, way[goal])
            if goal == len(way) - 1 and away < 0.02:
                return True
            speed = min(SPEED, away * 5)
            self.state.ctrl[:] = (way[goal][0] - at[0]) / away * speed, (at[1] - way[goal][1]) / away * speed
            mujoco.mj_step(self.world, self.state, nstep=STEPS)
            self._touch()
        return False

    def _touch(self) -> None:
        contacts = self.state.contact.geom[: self.state.ncon]
        for pair in contacts[(contacts == self.base).any(axis=1)]:
            other = int(pair[0] if pair[1] == self.base else pair[1])
            name = self.world.body(int(self.world.geom_bodyid[other])).name
            (self.outcome.pushed if name in self.leaves else self.outcome.touched).add(name)
