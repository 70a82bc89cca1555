"""Tasks for robots that can surely be done in a home: open a front, go from one piece to another, bring a thing; as JSON.

What opens is known from the certificate, where a robot can be from the validator's free floor: of the scene's `robot_width`, come in from
the entrance. Poses are in the house: x east, z south, m; turns in degrees, 0 facing south. Which tasks there are is drawn by the seed.

Ways are exact: the robot's centre goes straight from corner to corner of what is in its way. It may be wherever its square lies within
the union of the floor's rectangles: nowhere strictly inside what is left of the plane, grown by half the square. A shortest way bends at
corners of that alone (Lozano-Pérez and Wesley, 1979). All is calculated in quarter micrometres, in integers.
"""

import json
import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from heapq import heappop, heappush
from itertools import pairwise
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from solver.exports.model import HouseModel, ModelBody
from solver.exports.plan_storeys import covers, opening_box
from solver.exports.writers import ExportSettings, Files
from solver.geometry import tiles_between
from solver.scene import robot_width_of
from solver.streams import Stream

EACH: Final = 4
"""Tasks of each kind in a home, at most."""
HEAVIEST: Final = 2.0
"""What is brought weighs at most so much, kg: what a small arm lifts."""
WITHIN_REACH: Final = (0.3, 1.5)
"""What is brought, and where to, lies so high above the floor, m."""
CATCHING: Final = frozenset({"sink", "vanity", "counter"})
"""Names of pieces that things are brought to though nothing may lie there yet."""


class UsePose(NamedTuple):
    """Where the robot stands to use a body, facing it."""

    body: ModelBody
    level: int
    at: "LatticeSpot"
    turn: float


def write(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes `tasks.json`."""
    tasks = _Tasks(model, settings) if model.scene.rooms else None
    found = [*tasks.opened(), *tasks.gone(), *tasks.brought()] if tasks else []
    document = {
        "export": "tasks",
        "frame": "x east, z south, m; turns in degrees about +y, 0 facing south; paths are of the middle of the robot's square",
        "seed": model.scene.seed,
        "robot_width": robot_width_of(model.scene),
        "tasks": [{"id": f"task_{number}", **task} for number, task in enumerate(found)],
    }
    lines = json.dumps(document, separators=(",", ":")).replace('{"id"', '\n{"id"')
    return {"tasks.json": f"{lines}\n".encode()}


class _Tasks:
    """What can be done in a house."""

    def __init__(self, model: HouseModel, settings: ExportSettings) -> None:
        self.model, self.side = model, robot_width_of(model.scene)
        self.ways = _paths_of(model, settings, self.side)
        levels = {room.id: room.level for room in model.rooms}
        self.stands = {body.id: stand for body in model.bodies if (stand := self._stand(body, levels.get(body.room or "", 0)))}
        self.bodies = {body.id: body for body in model.bodies}

    def opened(self) -> Iterator[dict[str, Any]]:
        """Yields fronts to open that the certificate says open wholly, each from the way into the house or from another piece."""
        certificate: Mapping[str, Any] = self.model.scene.certificate or {}
        reports = certificate.get("rooms", {}).values()
        whole = [
            (piece, front)
            for report in reports
            for piece, ways in report.get("fronts", {}).items()
            for front, opens in ways.items()
            if opens == 1 and piece in self.stands and any(one.name == front for one in self.bodies[piece].fronts)
        ]
        for piece, front in self._drawn("open", whole):
            stand = self.stands[piece]
            if way := self._way(self._first(stand), stand):
                yield {"kind": "open", "goal": f"open {piece}'s {front.replace('_', ' ')}", "body": piece, "front": front, **way}

    def gone(self) -> Iterator[dict[str, Any]]:
        """Yields pieces to go to, each from another one."""
        for start, goal in self._drawn("go", self._pairs(list(self.stands.values()))):
            if way := self._way(start, goal):
                said = f"go from {start.body.id} to {goal.body.id}"
                yield {"kind": "go", "goal": said, "start_body": start.body.id, "body": goal.body.id, **way}

    def brought(self) -> Iterator[dict[str, Any]]:
        """Yields light things within reach to bring from what carries them to another piece that carries things."""
        low, high = WITHIN_REACH
        things = [
            body
            for body in self.model.bodies
            if body.sort == "decoration"
            and not body.fixed
            and body.mass <= HEAVIEST
            and low <= body.y <= high
            and body.parent in self.stands
            and not self._is_shut_in(body)
        ]
        carrying = {body.parent for body in things} | {stand.body.id for stand in self.stands.values() if stand.body.name in CATCHING}
        goals = [stand for name, stand in self.stands.items() if name in carrying]
        pairs = [(thing, goal) for thing in things for goal in goals if goal.body.id != thing.parent]
        for thing, goal in self._drawn("bring", pairs):
            start = self.stands[thing.parent or ""]
            if way := self._way(start, goal):
                said = f"bring {thing.id} from {start.body.id} to {goal.body.id}"
                yield {"kind": "bring", "goal": said, "thing": thing.id, "start_body": start.body.id, "body": goal.body.id, **way}

    def _is_shut_in(self, thing: ModelBody) -> bool:
        """Tells whether a thing lies inside a piece whose fronts are shut."""
        piece = self.bodies[thing.parent or ""]
        return bool(piece.fronts) and covers(piece, thing)

    def _drawn(self, kind: str, options: list[tuple[Any, Any]]) -> list[tuple[Any, Any]]:
        chosen = list(options)
        Stream(self.model.scene.seed or 0, "tasks", kind).shuffle(chosen)
        return chosen[:EACH]

    def _pairs(self, stands: list[UsePose]) -> list[tuple[UsePose, UsePose]]:
        return [(a, b) for a in stands for b in stands if a is not b and a.level == b.level]

    def _first(self, goal: UsePose) -> UsePose:
        """Returns the farthest stand of the goal's storey: to come from there is most of a task."""
        same = [stand for stand in self.stands.values() if stand.level == goal.level]
        return max(same, key=lambda stand: (math.dist(stand.at, goal.at), stand.body.id))

    def _way(self, start: UsePose, goal: UsePose) -> dict[str, Any] | None:
        corners = self.ways[goal.level].path(start.at, goal.at) if start.level == goal.level else None
        if corners is None:
            return None
        path = [[x / PER_METRE, z / PER_METRE] for x, z in corners]
        length = sum(math.dist(a, b) for a, b in pairwise(path))
        return {"level": goal.level, "from": _pose(start), "to": _pose(goal), "path": path, "length": round(length, 4)}

    def _stand(self, body: ModelBody, level: int) -> UsePose | None:
        """Returns where the robot's square touches a use side of a body, as near to that side's middle as it can."""
        for _, _, turn in body.uses if level in self.ways else ():
            if turn % 90:
                continue
            east, south = round(math.sin(math.radians(turn))), round(math.cos(math.radians(turn)))
            sideways = (body.turn % 180 == 0) == (east == 0)
            deep, wide = (body.depth, body.width) if sideways else (body.width, body.depth)
            away = steps(deep) // 2 + steps(self.side) // 2
            middle = (steps(body.x) - east * away, steps(body.z) - south * away)
            end = (middle[0] + abs(south) * steps(wide) // 2, middle[1] + abs(east) * steps(wide) // 2)
            if spot := self.ways[level].nearest(middle, end):
                return UsePose(body, level, spot, turn)
        return None


def _pose(stand: UsePose) -> dict[str, float]:
    return {"x": stand.at[0] / PER_METRE, "z": stand.at[1] / PER_METRE, "turn": stand.turn}


def _paths_of(model: HouseModel, settings: ExportSettings, side: float) -> "dict[int, FreePaths]":
    """Returns the ways over the free floor of each storey: of its rooms, and through its doors and passages."""
    boxes: dict[int, list[tuple[float, ...]]] = defaultdict(list)
    rooms = {room.id: room for room in model.scene.rooms}
    for floor in settings.floors():
        room = rooms[floor["room"]]
        boxes[room.level] += [(room.x + x0, room.z + z0, room.x + x1, room.z + z1) for x0, z0, x1, z1 in floor["free"]]
    for one in model.openings:
        if one.kind != "window" and one.level in boxes:
            boxes[one.level].append(opening_box(one))
    return {level: FreePaths(found, side) for level, found in boxes.items()}


PER_METRE: Final = 4_000_000
"""Steps of the lattice in a metre: quarter micrometres, as the validator's."""
LatticeSpot = tuple[int, int]
"""A point: x and z, in steps."""
Boxes = npt.NDArray[np.int64]
"""Rows of x0, z0, x1, z1, in steps."""


class FreePaths:
    """The ways of a square, its side in m, over a floor: rectangles (x0, z0, x1, z1), m, that it may cover; they may overlap."""

    def __init__(self, floor: Iterable[Sequence[float]], side: float) -> None:
        inside = np.array([[steps(one) for one in box] for box in floor], dtype=np.int64).reshape(-1, 4)
        self._half = max(steps(side) // 2 - 1, 0)
        self.taken = _rest(inside) + np.array([-1, -1, 1, 1]) * self._half if len(inside) else inside
        self._corners = _corners(self.taken)
        self._seen: dict[LatticeSpot, list[tuple[float, LatticeSpot]]] = {}

    def is_free(self, spot: LatticeSpot) -> bool:
        """Tells whether the square's centre may be at a point."""
        return len(self.taken) > 0 and not _inside(self.taken, np.array([spot], dtype=np.int64))[0]

    def nearest(self, middle: LatticeSpot, end: LatticeSpot) -> LatticeSpot | None:
        """Returns the free point of a segment along an axis, and of its mirror image about its first point, nearest to that point."""
        other = (2 * middle[0] - end[0], 2 * middle[1] - end[1])
        axis = 0 if middle[0] != end[0] else 1
        edges = [int(edge) for edge in {*self.taken[:, axis].tolist(), *self.taken[:, axis + 2].tolist()}] if len(self.taken) else []
        low, high = min(end[axis], other[axis]), max(end[axis], other[axis])
        tried = sorted({middle[axis], *(edge for edge in edges if low <= edge <= high)}, key=lambda at: (abs(at - middle[axis]), at))
        spots = [(at, middle[1]) if axis == 0 else (middle[0], at) for at in tried]
        return next((spot for spot in spots if self.is_free(spot)), None)

    def path(self, start: LatticeSpot, goal: LatticeSpot) -> list[LatticeSpot] | None:
        """Returns the corners of a shortest way from a free point to another, both included; None where there is none."""
        if not (self.is_free(start) and self.is_free(goal)):
            return None
        ahead: list[tuple[float, float, LatticeSpot, LatticeSpot | None]] = [(math.dist(start, goal), 0.0, start, None)]
        came: dict[LatticeSpot, LatticeSpot | None] = {}
        while ahead:
            _, gone, at, before = heappop(ahead)
            if at in came:
                continue
            came[at] = before
            if at == goal:
                return _back(came, goal)
            ways = [*self._ways(at), *self._straight(at, goal)]
            for length, there in ways:
                if there not in came:
                    heappush(ahead, (gone + length + math.dist(there, goal), gone + length, there, at))
        return None

    def _ways(self, at: LatticeSpot) -> list[tuple[float, LatticeSpot]]:
        if at not in self._seen:
            clear = _clear(at, self._corners, self.taken)
            self._seen[at] = [(math.dist(at, (x, z)), (x, z)) for x, z in self._corners[clear].tolist()]
        return self._seen[at]

    def _straight(self, at: LatticeSpot, goal: LatticeSpot) -> list[tuple[float, LatticeSpot]]:
        return [(math.dist(at, goal), goal)] if _clear(at, np.array([goal], dtype=np.int64), self.taken)[0] else []


def steps(metres: float) -> int:
    """Returns a length in steps, rounded."""
    return round(metres * PER_METRE)


def _back(came: dict[LatticeSpot, LatticeSpot | None], goal: LatticeSpot) -> list[LatticeSpot]:
    found, at = [], goal
    while True:
        found.append(at)
        before = came[at]
        if before is None:
            return found[::-1]
        at = before


def _rest(inside: Boxes) -> Boxes:
    """Returns rectangles that cover what boxes leave of the rectangle around them, and a rim around that."""
    rim = 4 * PER_METRE
    xs, zs = (np.unique([*inside[:, k], *inside[:, k + 2], inside[:, k].min() - rim, inside[:, k + 2].max() + rim]) for k in (0, 1))
    taken = np.ones((len(zs) - 1, len(xs) + 1), dtype=np.bool_)
    taken[:, [0, -1]] = False
    for x0, z0, x1, z1 in inside.tolist():
        taken[np.searchsorted(zs, z0) : np.searchsorted(zs, z1), np.searchsorted(xs, x0) + 1 : np.searchsorted(xs, x1) + 1] = False
    turns = np.argwhere(taken[:, 1:] != taken[:, :-1]).tolist()
    lines = ((int(xs[column]), int(zs[row]), int(zs[row + 1])) for row, column in turns)
    return np.array(tiles_between(lines), dtype=np.int64).reshape(-1, 4)


def _inside(boxes: Boxes, spots: npt.NDArray[np.int64]) -> npt.NDArray[np.bool_]:
    """Tells of each point whether it lies strictly inside a box."""
    x, z = spots[:, 0, None], spots[:, 1, None]
    return _any((boxes[:, 0] < x) & (x < boxes[:, 2]) & (boxes[:, 1] < z) & (z < boxes[:, 3]))


def _corners(boxes: Boxes) -> npt.NDArray[np.int64]:
    """Returns the free points about which exactly one quarter of the plane is taken: where a shortest way may bend."""
    spots = np.unique(np.concatenate([boxes[:, [a, b]] for a in (0, 2) for b in (1, 3)]), axis=0)
    spots = spots[~_inside(boxes, spots)]
    quarters = [_quarter(boxes, spots, east, south) for east in (False, True) for south in (False, True)]
    found: npt.NDArray[np.int64] = spots[np.sum(quarters, axis=0) == 1]
    return found


def _quarter(boxes: Boxes, spots: npt.NDArray[np.int64], east: bool, south: bool) -> npt.NDArray[np.bool_]:
    """Tells of each point whether the quarter of the plane right beside it is taken."""
    x, z = spots[:, 0, None], spots[:, 1, None]
    along = (boxes[:, 0] <= x) & (x < boxes[:, 2]) if east else (boxes[:, 0] < x) & (x <= boxes[:, 2])
    across = (boxes[:, 1] <= z) & (z < boxes[:, 3]) if south else (boxes[:, 1] < z) & (z <= boxes[:, 3])
    return _any(along & across)


def _clear(start: LatticeSpot, ends: npt.NDArray[np.int64], boxes: Boxes) -> npt.NDArray[np.bool_]:
    """Tells of each end whether the segment to it meets no box's inside: a line along an axis or along itself parts them."""
    x, z = ends[:, 0, None], ends[:, 1, None]
    apart = (np.maximum(x, start[0]) <= boxes[:, 0]) | (np.minimum(x, start[0]) >= boxes[:, 2])
    apart |= (np.maximum(z, start[1]) <= boxes[:, 1]) | (np.minimum(z, start[1]) >= boxes[:, 3])
    dx, dz = x - start[0], z - start[1]
    sides = [dx * (boxes[:, k] - start[1]) - dz * (boxes[:, j] - start[0]) for j in (0, 2) for k in (1, 3)]
    apart |= np.minimum.reduce(sides) >= 0
    apart |= np.maximum.reduce(sides) <= 0
    return ~_any(~apart)


def _any(table: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Tells of each row whether it holds a yes."""
    return np.asarray(np.any(table, axis=1), dtype=np.bool_)
