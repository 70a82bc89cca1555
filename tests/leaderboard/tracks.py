"""The tasks of the published benchmark: rooms with relations, dense rooms, rooms of others to repair. docs/benchmark.md says what they are.

Comes in: a track's name; for repair a folder of scenes. Goes out: tasks, a document each, that any system can read; and our answers.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from time import process_time
from typing import Any, Final

from catalogs import load_catalogs
from service.contract import PlaceBody
from solver import fix, place
from solver.answers import ImportSettings
from solver.errors import ComposeError, FieldError
from solver.exchange import read, read_scene, write_scene
from solver.furnished import furnished
from solver.imports import READERS, PlanFile, format_of_plan, imported
from solver.placement import place as place_wanted
from solver.scene import FORMAT, Scene
from solver.streams import Stream
from solver.understanding import with_understood_kinds
from tests.dense.furnishing import WALL_M, catalogs, wishes
from tests.dense.rooms import KINDS, cover_wish
from tests.place_rooms import place_request

Task = dict[str, Any]
TRACKS: Final = ("relations", "dense", "repair")
RELATION_ROOMS: Final = 20
DENSE_ROOMS: Final = 100
REPAIR_ROOMS: Final = 1000
FIRST_SEED: Final = 9000
"""Of the rooms with relations: no test or figure of ours uses the seeds from here on."""


def relation_tasks(count: int = RELATION_ROOMS) -> Iterator[Task]:
    """Yields rooms with lists of pieces and relations, as POST /place takes them."""
    for seed in range(FIRST_SEED, FIRST_SEED + count):
        yield {"id": f"relations_{seed}", **place_request(seed)}


def dense_tasks(count: int = DENSE_ROOMS) -> Iterator[Task]:
    """Yields rooms with the pieces that have to stand, those that may, and how much of the floor is to be covered."""
    for number in range(count):
        name, seed = list(KINDS)[number % len(KINDS)], FIRST_SEED + number // len(KINDS)
        room, _, wanted = wishes(name, seed)
        pieces = []
        for piece in wanted:
            kinds = sorted({(catalogs().name_of(one.kind), *(length / 1000 for length in one.size_mm)) for one in piece.candidates})
            pieces.append({"id": piece.label, "kinds": [list(kind) for kind in kinds], "required": piece.required})
        sent = write_scene(Scene(wall_thickness=WALL_M, rooms=(room,)))
        yield {"id": f"dense_{name}_{seed}", "type": name, "scene": sent, "pieces": pieces, "cover": round(cover_wish(name, seed), 4)}


def repair_tasks(folder: Path, count: int = REPAIR_ROOMS) -> Iterator[Task]:
    """Yields the first scenes of a folder's .jsonl and .json files, by the files' names: a line each, a scene or what `import` reads."""
    left = count
    for path in sorted([*folder.glob("*.jsonl"), *folder.glob("*.json")]):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines()):
            if left and line.strip():
                try:
                    scene = _as_sent(json.loads(line))
                except ComposeError as error:
                    print(f"{path.name}, line {number + 1} is left out: {error}", file=sys.stderr)
                    continue
                left -= 1
                yield {"id": f"repair_{path.stem}_{number}", "scene": write_scene(scene)}


def _as_sent(document: Mapping[str, Any]) -> Scene:
    """Reads a scene, or a plan of another program with its furniture where it was drawn: `import` itself would repair it.

    Raises:
        ComposeError: it is none.
    """
    if document.get("format") == FORMAT:
        return read_scene(document)
    file = PlanFile("", b"{}", document)
    format = format_of_plan(file)
    if format is None:
        raise FieldError("file", "is no plan that is read here", ", ".join(READERS))
    return with_understood_kinds(imported(file, format, ImportSettings(), load_catalogs())[0], load_catalogs())


def digest_of(tasks: list[Task]) -> str:
    """Returns a digest by which two systems know that they had the same tasks."""
    return sha256("\n".join(json.dumps(task, sort_keys=True) for task in tasks).encode()).hexdigest()


def ours(track: str, tasks: list[Task]) -> Iterator[dict[str, Any]]:
    """Yields Compose's answers: the scene, and the CPU seconds it took; the first task is done twice, for what is loaded once."""
    answer: Callable[[Task], Scene] = {"relations": _placed, "dense": _dense, "repair": _repaired}[track]
    for task in tasks[:1]:
        answer(task)
    for task in tasks:
        start = process_time()
        scene = answer(task)
        yield {"id": task["id"], "scene": write_scene(scene), "seconds": round(process_time() - start, 5)}


def _placed(task: Task) -> Scene:
    body = read(PlaceBody, {key: value for key, value in task.items() if key != "id"})
    return place(body.room, body.pieces, wall_thickness=body.wall_thickness).best.scene


def _dense(task: Task) -> Scene:
    name, seed = task["type"], int(task["id"].rpartition("_")[2])
    room, space, wanted = wishes(name, seed)
    (arrangement,) = place_wanted([(space, wanted)])
    done = furnished(room, arrangement, catalogs(), Stream(seed, "colour", name)).furniture
    asked = {piece.id: placed.label for piece, placed in zip(done, arrangement.placed, strict=True)}
    called = tuple(replace(piece, id=asked[piece.id], under=asked.get(piece.under or ""), on=asked.get(piece.on or "")) for piece in done)
    return Scene(wall_thickness=WALL_M, rooms=(replace(room, furniture=called),))


def _repaired(task: Task) -> Scene:
    return fix(read_scene(task["scene"])).scene
