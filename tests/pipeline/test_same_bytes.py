"""The same bytes for the same question: many times over, and in new processes at once, whatever their hashes."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from collections.abc import Mapping
from contextlib import ExitStack
from dataclasses import replace
from functools import cache
from pathlib import Path

from solver import Request, Scene, fix, generate
from solver.exchange import dump_text, write_scene
from solver.placement import place
from solver.scene import Furniture
from solver.streams import Stream
from tests.placement.rooms import random_space, random_wanted
from tests.sweeps import seeds, times

ROOT = Path(__file__).parents[2]
REPEATS = times(1000, 25)
SEEDS = tuple(seeds(range(8), 2))
"""Of houses of 10 x 8 m."""
DEFAULT = 42
"""The seed of a house of the default size."""


def scene_bytes(scene: Scene) -> bytes:
    return dump_text(write_scene(scene), "json")


def house(seed: int) -> bytes:
    return scene_bytes(generate(Request(seed=seed) if seed == DEFAULT else Request(seed=seed, width=10, depth=8)).scene)


@cache
def digest(seed: int) -> str:
    """A house in short; whole scenes would only be sent about."""
    return hashlib.sha256(house(seed)).hexdigest()


def one_room() -> Scene:
    """The bedroom of a house, alone, its pieces pushed about."""
    scene = generate(Request(seed=7, width=10, depth=8)).scene
    room = next(room for room in scene.rooms if "bedroom" in room.type and len(room.furniture) > 4)
    stream = Stream(7, "pushed")

    def pushed(piece: Furniture) -> Furniture:
        return replace(piece, x=round(piece.x + stream.unit() - 0.5, 3), z=round(piece.z + stream.unit() - 0.5, 3))

    return replace(scene, rooms=(replace(room, furniture=tuple(map(pushed, room.furniture))),), adjacency=(), corridors=())


def test_repeats_of_a_room() -> None:
    stream = Stream(5, "repeats")
    space = random_space(stream)
    wanted = random_wanted(space, stream, 7)
    first = place([(space, wanted)])
    assert len(first[0].placed) > 3
    assert {repr(place([(space, wanted)])) for _ in range(REPEATS)} == {repr(first)}


def test_repeats_of_a_repair() -> None:
    scene = one_room()
    first = fix(scene)
    assert len(first.moves) > 3
    assert {(repr(again.scene), repr(again.moves), repr(again.conflicts)) for again in (fix(scene) for _ in range(REPEATS))} == {
        (repr(first.scene), repr(first.moves), repr(first.conflicts))
    }


def test_other_rooms_between_change_nothing() -> None:
    """The kernel's work space is a room's own: nothing of another room's is left in it."""
    first = [house(seed) for seed in SEEDS[:4]]
    for seed in range(30):
        stream = Stream(seed, "between")
        space = random_space(stream)
        place([(space, random_wanted(space, stream, 3 + seed % 9))])
    assert [house(seed) for seed in SEEDS[:4]][::-1] == first[::-1]


PROGRAM = """
import sys
from tests.pipeline.test_same_bytes import digest
print(*map(digest, map(int, sys.argv[1:])))
"""
ENVIRONMENTS: Mapping[str, Mapping[str, str]] = {"0": os.environ, "random": {}}
"""By the seed of the hashes, what else a new process finds in its environment."""


def asked_apart(hashes: str, share: tuple[int, ...]) -> subprocess.Popen[str]:
    """A new process, which makes some of the houses."""
    words = [sys.executable, "-c", PROGRAM, *map(str, share)]
    environment = {**ENVIRONMENTS[hashes], "PYTHONHASHSEED": hashes}
    return subprocess.Popen(words, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True)


def test_new_processes_with_other_hashes_at_once() -> None:
    """Two share the houses; the one with an empty environment makes the default house, too."""
    shares = {hashes: SEEDS[number :: len(ENVIRONMENTS)] for number, hashes in enumerate(ENVIRONMENTS)}
    shares["random"] += (DEFAULT,)
    with ExitStack() as running:
        apart = {hashes: running.enter_context(asked_apart(hashes, share)) for hashes, share in shares.items()}
        said = {hashes: process.communicate()[0].split() for hashes, process in apart.items()}
    assert said == {hashes: [digest(seed) for seed in share] for hashes, share in shares.items()}


def test_the_houses_differ() -> None:
    assert len({digest(seed) for seed in SEEDS}) == len(SEEDS)
