"""Tasks for robots that can surely be done in a home: open a front, go from one piece to another, bring a thing; as JSON.

What opens is known from the certificate, where a robot can be from the validator's free floor: of the scene's `robot_width`, come in from
the entrance. Poses are in the house: x east, z south, m; turns in degrees, 0 facing south. Which tasks there are is drawn by the seed.
"""

from __future__ import annotations

import json
import math
from collections import defaultdict
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any, Final, NamedTuple

from solver.exports.free_paths import PER_METRE, FreePaths, LatticeSpot, steps
from solver.exports.model import HouseModel, ModelBody
from solver.exports.plan_storeys import covers, opening_box
from solver.exports.writers import ExportSettings, Files
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
    at: LatticeSpot
    turn: float


def write(model: HouseModel, settings: ExportSettings) -> Files:
    """Writes `tasks.json`."""
    tasks = _Tasks(model, settings) if model.scene.rooms else None
    found = [*tasks.opened(), *tasks.gone(), *tasks.brought()] if tasks else []
    document = {
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


def _paths_of(model: HouseModel, settings: ExportSettings, side: float) -> dict[int, FreePaths]:
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
