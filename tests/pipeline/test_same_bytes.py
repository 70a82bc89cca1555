"""The same bytes for the same question: a thousand times over, in new processes, in one, two or four of them at once."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import pytest

from solver import Request, Scene, fix, generate
from solver.exchange import dump_text, write_scene
from solver.placement import place
from solver.scene import Furniture
from solver.streams import Stream
from tests.placement.rooms import random_space, random_wanted

ROOT = Path(__file__).parents[2]
REPEATS = 1000
SEEDS = tuple(range(8))


def scene_bytes(scene: Scene) -> bytes:
    return dump_text(write_scene(scene), "json")


def house(seed: int) -> bytes:
    return scene_bytes(generate(Request(seed=seed, width=10, depth=8)).scene)


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


def test_a_thousand_repeats_of_a_room() -> None:
    stream = Stream(5, "repeats")
    space = random_space(stream)
    wanted = random_wanted(space, stream, 7)
    first = place([(space, wanted)])
    assert len(first[0].placed) > 3
    assert {repr(place([(space, wanted)])) for _ in range(REPEATS)} == {repr(first)}


def test_a_thousand_repeats_of_a_repair() -> None:
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


@pytest.mark.parametrize("hash_seed", ["0", "31415"])
def test_new_processes_with_other_hashes(hash_seed: str) -> None:
    program = "import sys; from tests.pipeline.test_same_bytes import house; sys.stdout.buffer.write(house(3))"
    environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, check=False, env=environment)
    assert run.returncode == 0, run.stderr.decode()
    assert run.stdout == house(3)


WORKERS = 3


def test_any_number_of_worker_processes() -> None:
    """Three share eight houses as unevenly as any number does."""
    with ProcessPoolExecutor(WORKERS, mp_context=get_context("spawn")) as pool:
        assert list(pool.map(digest, SEEDS)) == [digest(seed) for seed in SEEDS]


def test_the_houses_differ() -> None:
    assert len({digest(seed) for seed in SEEDS}) == len(SEEDS)
