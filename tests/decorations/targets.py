"""Decorated homes by the hundred: how much is in their rooms, and that nothing is wrong with them."""

from __future__ import annotations

import statistics
import sys
import time
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.decorations import BareRoom, DecorationSettings, decorated_rooms
from solver.furnish import space_of
from solver.streams import Stream
from tests.decorations.oracle import complaints

LEAST = {
    "living_room": 20, "bedroom_master": 20, "kitchen": 20, "office": 20, "bedroom": 15, "dining_room": 15, "bathroom": 7, "hallway": 7,
}  # fmt: skip
"""Furniture and decorations of a decorated room, least medians."""


@dataclass(frozen=True)
class Home:
    """What one home shows: by room its type, pieces and decorations; what is wrong; CPU of decorating it once more, ms."""

    rooms: tuple[tuple[str, int, int], ...]
    wrong: tuple[str, ...]
    cpu_ms: float


def home(seed: int, preset: str = "family") -> Home:
    """Generates one decorated home and judges it."""
    made = generate(Request(seed=seed, program=preset, decorate=True))
    scene = made.scene
    wrong = [issue.message for issue in made.issues if issue.severity == "error"]
    rooms = tuple((room.type, len(room.furniture), len(room.decorations)) for room in scene.rooms)
    start = time.process_time()
    terms = DecorationSettings(load_catalogs())
    bare = (BareRoom(room, space_of(room, scene.wall_thickness), Stream(seed, "decorations", room.index)) for room in scene.rooms)
    decorated_rooms(bare, terms)
    cpu = (time.process_time() - start) * 1000
    return Home(rooms, tuple(f"seed {seed}: {what}" for what in (*wrong, *complaints(scene))), cpu)


def homes(seeds: int, workers: int) -> bool:
    """Prints medians by room type; returns whether nothing is wrong and all targets are met."""
    with ProcessPoolExecutor(workers) as pool:
        found = list(tqdm(pool.map(home, range(seeds), chunksize=4), total=seeds, desc="homes", file=sys.stderr))
    counts: dict[str, list[tuple[int, int]]] = defaultdict(list)
    for one in found:
        for name, pieces, things in one.rooms:
            counts[name].append((pieces, things))
    wrong = [what for one in found for what in one.wrong]
    good = not wrong
    print("| room type | rooms | pieces | decorations | together (target) |\n|---|---|---|---|---|")
    for name, rooms in sorted(counts.items()):
        pieces, things = (statistics.median(values) for values in zip(*rooms, strict=True))
        together, least = statistics.median(a + b for a, b in rooms), LEAST.get(name, 0)
        good &= together >= least
        wanted = f" (>= {least})" if least else ""
        print(f"| {name.replace('_', ' ')} | {len(rooms):,} | {pieces:g} | {things:g} | {together:g}{wanted} |")
    per_home = statistics.median(sum(things for _, _, things in one.rooms) for one in found)
    cpu = statistics.median(one.cpu_ms for one in found)
    print(f"\n{seeds} homes, {per_home:.0f} decorations each, {cpu:.1f} ms CPU to decorate one, {len(wrong)} things wrong")
    for what in wrong[:20]:
        print(f"  {what}")
    return good
