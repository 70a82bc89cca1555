"""The rulers of the published benchmark: what an answer to a task is worth, whoever gave it. docs/benchmark.md defines each.

Comes in: tasks and answers by id. Goes out: figures of a track.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from statistics import fmean, median
from typing import Any

from catalogs import load_catalogs
from service.contract import PlaceBody
from solver.exchange import read, read_scene
from solver.furnish import scope_of, space_of
from solver.relations.held import FinishedRoom, held, standing
from solver.requested import checked, labels_by_name, relations_of
from solver.scene import Furniture, Room, Scene
from solver.validator import validate
from tests.dense.furnishing import catalogs as dense_catalogs

Figures = dict[str, float]
Answers = Mapping[str, Mapping[str, Any]]
JUDGED_APART = ("missing_required", "front_blocked", "shapes_cross")
"""Rules that are no part of `valid`: what must be there is counted by itself, and warnings are none."""


def figures(track: str, tasks: Sequence[Mapping[str, Any]], answers: Answers) -> Figures:
    """Returns a track's figures; a task without an answer counts as one that holds nothing."""
    rows = [{"relations": _relations, "dense": _dense, "repair": _repair}[track](task, answers.get(task["id"])) for task in tasks]
    sums: defaultdict[str, float] = defaultdict(float)
    for row in rows:
        for key, value in row.items():
            sums[key] += value
    count = len(tasks)
    times = [float(one["seconds"]) for one in answers.values() if "seconds" in one]
    found = {"tasks": count, "answered": sum(task["id"] in answers for task in tasks), "valid": sums["valid"] / count}
    if track == "relations":
        found |= {"held": sums["held"] / sums["asked"], "placed": sums["placed"] / sums["wanted"]}
    elif track == "dense":
        found |= {"required": sums["required"] / count, "cover": median(row.get("cover", 0.0) for row in rows)}
    else:
        moved = [row["moved"] for row in rows if row.get("valid") and row.get("moves")]
        found |= {"kept": sums["kept"] / sums["sent"], "moved_m": median(moved) if moved else 0.0}
    return {**found, "cpu_ms": 1000 * fmean(times) if times else math.nan}


def _relations(task: Mapping[str, Any], answer: Mapping[str, Any] | None) -> Figures:
    body = read(PlaceBody, {key: value for key, value in task.items() if key != "id"})
    asked = list(relations_of(body.pieces))
    wanted = [label for piece in body.pieces for label in piece.labels]
    if answer is None:
        return {"asked": len(asked), "wanted": len(wanted)}
    scene = read_scene(answer["scene"])
    room = scene.rooms[0]
    space = space_of(body.room, body.wall_thickness)
    bodies = {one.id: standing(one, space.clear, _surfaces(one)) for one in room.furniture}
    judged = FinishedRoom(scope_of(body.room, space), bodies, labels_by_name(body.room, body.pieces))
    sizes = {label: piece.size for piece in checked(body.room, body.pieces, load_catalogs()) for label in piece.labels}
    same = _same_shell(room, body.room) and all(_size(one) == sizes[one.id] for one in room.furniture if one.id in sizes)
    return {
        "asked": len(asked),
        "wanted": len(wanted),
        "held": sum(held(judged, label, spec)[0] for label, spec in asked) if same else 0,
        "placed": len(bodies.keys() & set(wanted)) if same else 0,
        "valid": same and _is_valid(Scene(wall_thickness=body.wall_thickness, rooms=(room,))),
    }


def _surfaces(piece: Furniture) -> list[float]:
    kind = load_catalogs().furniture.get(piece.kind or piece.name)
    return [piece.height] if kind else []


def _same_shell(room: Room, sent: Room) -> bool:
    """Tells whether a room has the walls and openings that it was sent with."""
    return (room.width, room.depth, room.openings) == (sent.width, sent.depth, sent.openings)


def _is_valid(scene: Scene) -> bool:
    issues = validate(scene, load_catalogs())
    return not any(issue.severity == "error" and issue.rule not in JUDGED_APART for issue in issues)


def _dense(task: Mapping[str, Any], answer: Mapping[str, Any] | None) -> Figures:
    if answer is None:
        return {}
    room, sent = read_scene(answer["scene"]).rooms[0], read_scene(task["scene"]).rooms[0]
    scene = Scene(wall_thickness=task["scene"]["wall_thickness"], rooms=(room,))
    kinds = {piece["id"]: {tuple(kind) for kind in piece["kinds"]} for piece in task["pieces"]}
    there = {one.id.rpartition("/")[2]: (one.name, *_size(one)) for one in room.furniture}
    known = len(there) == len(room.furniture) and all(kind in kinds.get(name, ()) for name, kind in there.items())
    errors = [issue for issue in validate(scene, dense_catalogs()) if issue.severity == "error" and issue.rule not in JUDGED_APART]
    valid = known and _same_shell(room, sent) and not errors
    return {
        "valid": valid,
        "required": valid and all(piece["id"] in there for piece in task["pieces"] if piece["required"]),
        "cover": _covered(room) / (room.width * room.depth) if valid else 0.0,
    }


def _covered(room: Room) -> float:
    """The floor under pieces that stand on it, m2, no spot counted twice: by cells of 1 cm."""
    cells: set[tuple[int, int]] = set()
    for piece in room.furniture:
        if piece.y == 0:
            wide, deep = (piece.depth, piece.width) if piece.rotation % 180 else (piece.width, piece.depth)
            xs = range(round(100 * (piece.x - wide / 2)), round(100 * (piece.x + wide / 2)))
            cells.update((x, z) for x in xs for z in range(round(100 * (piece.z - deep / 2)), round(100 * (piece.z + deep / 2))))
    return len(cells) / 1e4


def _repair(task: Mapping[str, Any], answer: Mapping[str, Any] | None) -> Figures:
    sent = read_scene(task["scene"])
    before = {piece.id: piece for room in sent.rooms for piece in room.furniture}
    if answer is None:
        return {"sent": len(before)}
    scene = read_scene(answer["scene"])
    after = {piece.id: piece for room in scene.rooms for piece in room.furniture}
    same = len(scene.rooms) == len(sent.rooms) and all(map(_same_shell, scene.rooms, sent.rooms))
    same = same and all(name in before and _size(piece) == _size(before[name]) for name, piece in after.items())
    moves = [math.dist((one.x, one.z), (before[name].x, before[name].z)) for name, one in after.items() if name in before]
    moved = [length for length in moves if length > 0.001]
    whole = same and len(after) == len(before)
    return {
        "sent": len(before),
        "kept": len(after.keys() & before.keys()) if same else 0,
        "valid": whole and _is_valid(scene),
        "moves": len(moved),
        "moved": fmean(moved) if moved else 0.0,
    }


def _size(piece: Furniture) -> tuple[float, float, float]:
    return piece.width, piece.depth, piece.height
