"""`tasks`: every path is free at steps of 5 cm, held against bodies and walls by sums of this file alone; goals are as they are said."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import replace
from heapq import heappop, heappush
from itertools import pairwise
from typing import Any, NamedTuple

import pytest

from catalogs import load_catalogs
from solver import Request, generate, validator
from solver.exports import ExportSettings, describe, written_as
from solver.exports.formats.robot_tasks import PER_METRE, FreePaths
from solver.pipeline.export import export
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene
from tests.sweeps import seeds

STEP = 0.05
SLACK = 1e-6
TASKS_OF_A_HOME = 12
HOMES = seeds(range(84), 13)
"""A thousand tasks in `make targets`."""
TURNED = {"north": 180, "south": 0, "east": 90, "west": 270}


class Rectangle(NamedTuple):
    """On the floor, in the house, m."""

    x0: float
    z0: float
    x1: float
    z1: float

    def meets(self, other: Rectangle) -> bool:
        return self.x0 < other.x1 - SLACK and other.x0 < self.x1 - SLACK and self.z0 < other.z1 - SLACK and other.z0 < self.z1 - SLACK


def footprint(room: Room, body: Furniture | Decoration | Dynamic) -> Rectangle:
    turn = math.radians(body.rotation)
    across, along = abs(math.cos(turn)), abs(math.sin(turn))
    dx, dz = (body.width * across + body.depth * along) / 2, (body.width * along + body.depth * across) / 2
    x, z = room.x + body.x, room.z + body.z
    return Rectangle(x - dx, z - dz, x + dx, z + dz)


def in_the_way(scene: Scene) -> list[Rectangle]:
    """Everything that stands on the floor and is higher than a rug."""
    rooms = {room.id: room for room in scene.rooms}
    found = [footprint(room, piece) for room in scene.rooms for piece in room.furniture if piece.height > 0.02 and piece.y < 2.0]
    for room in scene.rooms:
        loose = [item for item in room.decorations if item.parent is None and item.mounted_on_wall is None and item.y == 0]
        found += [footprint(room, item) for item in loose if item.height > 0.02]
    return found + [footprint(rooms[one.room], one) for one in scene.dynamic if one.on is None and one.room in rooms]


def floors(scene: Scene) -> list[Rectangle]:
    """Clear floors of rectangular rooms, and what of the walls doors take away."""
    half, found = scene.wall_thickness / 2, []
    for room in scene.rooms:
        found.append(Rectangle(room.x + half, room.z + half, room.x + room.width - half, room.z + room.depth - half))
        for one in room.openings:
            if one.kind != "window" and one.wall:
                a, b = one.position - one.width / 2, one.position + one.width / 2
                if one.wall in ("north", "south"):
                    line = room.z + (room.depth if one.wall == "south" else 0.0)
                    found.append(Rectangle(room.x + a, line - half, room.x + b, line + half))
                else:
                    line = room.x + (room.width if one.wall == "east" else 0.0)
                    found.append(Rectangle(line - half, room.z + a, line + half, room.z + b))
    return found


def area_within(square: Rectangle, boxes: list[Rectangle]) -> float:
    """How much of a square boxes cover that do not overlap each other."""
    sides = [
        (min(square.x1, box.x1) - max(square.x0, box.x0), min(square.z1, box.z1) - max(square.z0, box.z0))
        for box in boxes
        if square.meets(box)
    ]
    return sum(a * b for a, b in sides)


class Floor:
    """Where a robot's square can be, by the sums of this file."""

    def __init__(self, scene: Scene, width: float) -> None:
        self.taken, self.floors, self.half = in_the_way(scene), list(dict.fromkeys(floors(scene))), width / 2

    def is_free(self, x: float, z: float) -> bool:
        square = Rectangle(x - self.half, z - self.half, x + self.half, z + self.half)
        inside = area_within(square, self.floors) > (2 * self.half) ** 2 - 1e-5
        return inside and not any(square.meets(box) for box in self.taken)


def walked(path: list[list[float]]) -> Iterator[tuple[float, float]]:
    """The points of a path, at most STEP apart."""
    for (x0, z0), (x1, z1) in pairwise(path):
        count = math.ceil(math.dist((x0, z0), (x1, z1)) / STEP) or 1
        yield from ((x0 + (x1 - x0) * k / count, z0 + (z1 - z0) * k / count) for k in range(count + 1))


def made(seed: int, **keys: Any) -> tuple[Scene, list[dict[str, Any]]]:
    request = Request(seed=seed, **{"program": "family", "outline": "rectangle", "decorate": True, **keys})
    scene = generate(request).scene
    document = json.loads(export(scene, "tasks")["tasks.json"])
    assert document["seed"] == seed and document["robot_width"] == request.robot_width
    return scene, document["tasks"]


@pytest.mark.parametrize("seed", HOMES)
def test_every_path_is_free_and_every_goal_is_as_it_is_said(seed: int) -> None:
    scene, tasks = made(seed, robot_width=(0.6, 0.5)[seed % 2])
    assert len(tasks) == TASKS_OF_A_HOME
    floor = Floor(scene, (0.6, 0.5)[seed % 2])
    bodies = {body.id: (room, body) for room in scene.rooms for body in room.furniture}
    parents = {item.id: item.parent for room in scene.rooms for item in room.decorations}
    reports: Any = (scene.certificate or {})["rooms"]
    for task in tasks:
        assert all(floor.is_free(x, z) for x, z in walked(task["path"])), task["goal"]
        assert task["length"] == pytest.approx(sum(math.dist(a, b) for a, b in pairwise(task["path"])), abs=1e-3)
        for end, pose in ((task["path"][0], task["from"]), (task["path"][-1], task["to"])):
            assert end == [pose["x"], pose["z"]]
        _touches(bodies[task["body"]], task["to"], floor.half)
        if task["kind"] == "open":
            assert reports[bodies[task["body"]][0].id]["fronts"][task["body"]][task["front"]] == 1
        else:
            _touches(bodies[task["start_body"]], task["from"], floor.half)
        if task["kind"] == "bring":
            assert parents[task["thing"]] == task["start_body"]


def _touches(placed: tuple[Room, Any], pose: dict[str, float], half: float) -> None:
    """Whoever stands there touches the body's side and faces it."""
    box = footprint(*placed)
    x, z = pose["x"], pose["z"]
    gaps = {180: z - half - box.z1, 0: box.z0 - half - z, 270: x - half - box.x1, 90: box.x0 - half - x}
    assert abs(gaps[round(pose["turn"]) % 360]) < 1e-5
    assert box.x0 - SLACK <= x <= box.x1 + SLACK or box.z0 - SLACK <= z <= box.z1 + SLACK


def test_what_is_not_free_would_be_seen() -> None:
    scene, tasks = made(0)
    floor = Floor(scene, 0.6)
    shifted = [[[x + 0.2, z] for x, z in task["path"]] for task in tasks]
    assert sum(not all(floor.is_free(x, z) for x, z in walked(path)) for path in shifted) > len(tasks) / 2


def test_no_way_in_eight_directions_is_much_shorter() -> None:
    """By a few hundredths one may be that goes through a gap just as wide as the robot."""
    scene, tasks = made(1)
    floor = Floor(scene, 0.6)
    for task in tasks[:3]:
        assert task["length"] <= 1.03 * _over_grid(floor, task["path"][0], task["path"][-1]) + 4 * STEP


def _over_grid(floor: Floor, start: list[float], goal: list[float]) -> float:
    """The length of a shortest way over points 5 cm apart, neighbours of eight sides."""
    first, last = ((round(x / STEP), round(z / STEP)) for x, z in (start, goal))
    free: dict[tuple[int, int], bool] = {}
    ahead, seen = [(0.0, 0.0, first)], set[tuple[int, int]]()
    while ahead:
        _, gone, (x, z) = heappop(ahead)
        if math.dist((x, z), last) <= 2:
            return gone * STEP
        if (x, z) in seen:
            continue
        seen.add((x, z))
        for dx, dz in ((a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b):
            there = (x + dx, z + dz)
            if there not in free:
                free[there] = floor.is_free(there[0] * STEP, there[1] * STEP)
            if there not in seen and (free[there] or math.dist(there, first) <= 2):
                length = gone + math.hypot(dx, dz)
                heappush(ahead, (length + math.dist(there, last), length, there))
    return math.inf


def test_a_square_passes_a_gap_of_its_own_width_and_no_other() -> None:
    metre = PER_METRE
    rooms = [(0.0, 0.0, 2.0, 2.0), (4.0, 0.0, 6.0, 2.0)]
    start, goal = (metre, metre), (5 * metre, metre)
    for gap, passes in ((0.6, True), (0.599, False)):
        way = FreePaths([*rooms, (2.0, 0.7, 4.0, 0.7 + gap)], 0.6).path(start, goal)
        assert (way is not None) is passes
    assert FreePaths(rooms, 0.6).path(start, goal) is None
    assert FreePaths([], 0.6).path(start, goal) is None


def test_a_way_round_a_corner_is_as_long_as_it_is_by_hand() -> None:
    metre = PER_METRE
    corner = FreePaths([(0.0, 0.0, 1.0, 4.0), (0.0, 3.0, 5.0, 4.0)], 0.5)
    way = corner.path((metre // 2, metre // 2), (4 * metre, 7 * metre // 2)) or []
    assert len(way) == 3
    x, z = (one / metre for one in way[1])
    assert (x, z) == pytest.approx((0.75, 3.25), abs=1e-5)


def test_scenes_without_a_certificate_or_rooms_have_few_tasks_or_none() -> None:
    assert json.loads(export(Scene(), "tasks")["tasks.json"])["tasks"] == []
    scene, _ = made(2)
    bare = Scene(rooms=scene.rooms, wall_thickness=scene.wall_thickness)
    kinds = {task["kind"] for task in json.loads(export(bare, "tasks")["tasks.json"])["tasks"]}
    assert kinds == {"go", "bring"}


def test_what_is_brought_weighs_2_kg_at_most_and_is_within_reach() -> None:
    scene, tasks = made(2)
    settings = ExportSettings("tasks", floors=lambda: validator.floors(scene))
    house = describe(scene, load_catalogs())
    lying = {one.parent: one for one in house.bodies if one.sort == "decoration" and not one.fixed}
    ways = ((task["start_body"], task["body"]) for task in tasks if task["kind"] == "bring")
    start, goal = next(way for way in ways if lying.keys() >= {*way})
    furniture = tuple(one._replace(fronts=()) for one in house.bodies if one.sort == "furniture")  # nothing lies inside any
    for weighs, y, is_brought in ((2.0, 0.3, True), (2.0, 1.5, True), (2.001, 1.0, False), (1.0, 0.299, False), (1.0, 1.501, False)):
        things = lying[goal]._replace(mass=1.0, y=1.0), lying[start]._replace(mass=weighs, y=y)
        changed = written_as(replace(house, bodies=(*furniture, *things)), settings)
        found = {task.get("thing") for task in json.loads(changed["tasks.json"])["tasks"]}
        assert (things[1].id in found) == is_brought, (weighs, y)
