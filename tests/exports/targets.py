"""Exports of homes by the hundred, judged by their consumers' rules: `python -m tests.targets nav2`."""

from __future__ import annotations

import sys
from concurrent.futures import ProcessPoolExecutor

from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.exports import ExportSettings, describe, written_as
from tests.exports.readers.nav2 import RADIUS, parted_rooms

PROGRAMS = (None, "family", "large")
"""The plain request and two programmes, in turn."""


def nav2_home(seed: int) -> tuple[str, int, list[str]]:
    """Maps one decorated home; returns what it is, its number of rooms, and those that a robot cannot drive to."""
    program = PROGRAMS[seed % len(PROGRAMS)]
    scene = generate(Request(seed=seed, program=program, decorate=True)).scene
    files = written_as(describe(scene, load_catalogs()), ExportSettings("nav2"))
    return f"{program or 'default'} {seed}", len(scene.rooms), parted_rooms(files)


def nav2_maps(homes: int, workers: int) -> bool:
    """Prints how many rooms Nav2's inflation of 0.28 m at 5 cm parts; returns whether it parts none."""
    with ProcessPoolExecutor(workers) as pool:
        found = list(tqdm(pool.map(nav2_home, range(homes), chunksize=4), total=homes, desc="nav2", file=sys.stderr))
    parted = [f"{name}: {room}" for name, _, rooms in found for room in rooms]
    print(f"nav2: {homes} homes, {sum(count for _, count, _ in found)} rooms, {len(parted)} parted at a radius of {RADIUS} m")
    for line in parted[:20]:
        print(f"  {line}")
    return not parted
