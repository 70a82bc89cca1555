"""The long measurements behind the README's and BENCHMARKS.md's figures: `make targets`.

    python -m tests.targets [houses|homes|floorplan|programme|rooms|imports|calls|nav2|physics|glb|usd|agree|plans|sh3d|engines|drags|
        thrown|access|files|sweeps]
        [--seeds N] [--workers 2]

Prints tables; exit status 1 where a target is missed. The suite runs slices of the same cases.
"""

from __future__ import annotations

import argparse
import os
import re
import statistics
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from tqdm import tqdm

from catalogs import load_catalogs
from solver import Request, generate
from solver.answers import Generated
from solver.scene import Room
from tests.core.engines import engines
from tests.dataset.targets import datasets
from tests.decorations.targets import homes
from tests.exports.agreement_targets import formats_agree
from tests.exports.drawing_targets import drawings, sweet_homes
from tests.exports.front_targets import fronts_of_homes
from tests.exports.model_targets import glb_homes, usd_homes
from tests.exports.physics_targets import physics
from tests.exports.targets import nav2_maps
from tests.fix_sweep.ruler import thrown_about
from tests.floorplan.homes import programme_table
from tests.floorplan.targets import floorplan_table
from tests.imports.hostile_reading import hostile_files
from tests.library.targets import imports
from tests.pipeline.access_targets import accessible_homes
from tests.pipeline.drag_targets import drags
from tests.pipeline.forced import Case, cases

SETS: Mapping[str, tuple[dict[str, object], int]] = {
    "defaults": ({}, 1),
    "12x9": ({"width": 12.0, "depth": 9.0}, 5),
    "30x20": ({"width": 30.0, "depth": 20.0}, 5),
    "spine off": ({"use_spine": False}, 5),
    "outdoor on": ({"outdoor": True}, 5),
    "min_room_size 2.4": ({"min_room_size": 2.4}, 5),
}
"""Request by name, and by how much fewer seeds than the defaults it gets."""
UNASKED = (
    "imports", "floorplan", "rooms", "houses", "calls", "nav2", "physics", "glb", "usd", "agree", "plans", "sh3d", "engines", "drags",
    "thrown", "access", "files", "sweeps",
)  # fmt: skip
"""What is measured where nothing is asked for."""
PRESET_SETS: Mapping[str, dict[str, object]] = {name: {"program": name} for name in ("studio", "one_bed", "family", "large")}
TESTS = Path(__file__).parent
SLICED = re.compile(r"^from (tests\.sweeps|hypothesis|tests\.browser\.acts) import", re.MULTILINE)
"""What a file of tests imports of which the suite runs a slice."""
In = TypeVar("In")
Out = TypeVar("Out")
MISSING_TARGET = 0.01
"""Share of rooms of their type's minimum area in which a required piece may be missing (defaults)."""


@dataclass
class Tally:
    """What a set of houses shows."""

    rules: Counter[str] = field(default_factory=Counter)
    rooms: int = 0
    large_enough: int = 0
    missing: list[str] = field(default_factory=list)
    furniture: int = 0
    unproven: int = 0
    cpu_ms: list[float] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        """Adds another tally to this one."""
        self.rules += other.rules
        self.rooms += other.rooms
        self.large_enough += other.large_enough
        self.missing += other.missing
        self.furniture += other.furniture
        self.unproven += other.unproven
        self.cpu_ms += other.cpu_ms


def doors_of(room: Room) -> int:
    """Returns the number of doors and passages of a room."""
    return sum(opening.kind in ("door", "passage") for opening in room.openings)


def has_minimum_area(room: Room) -> bool:
    """Tells whether a room has its type's minimum area for its number of doors."""
    area = load_catalogs().rooms[room.type].area
    return room.width * room.depth >= area.min[min(doors_of(room), 2) - 1]


def house(job: tuple[str, int]) -> Tally:
    """Generates one house of a set and counts."""
    name, seed = job
    start = time.process_time()
    fields = PRESET_SETS[name] if name in PRESET_SETS else SETS[name][0]
    made = generate(Request(seed=seed, **fields))  # type: ignore[arg-type]
    cpu = (time.process_time() - start) * 1000
    return tally(made, seed, cpu)


def tally(made: Generated, seed: int, cpu_ms: float) -> Tally:
    """Counts issues and pieces of one house."""
    found = Tally(cpu_ms=[cpu_ms])
    for issue in made.issues:
        found.rules[f"{issue.severity} {issue.rule}"] += 1
    certificate: Any = made.scene.certificate
    reports = certificate["rooms"]
    short = {issue.room: issue.message for issue in made.issues if issue.rule == "missing_required"}
    for room in made.scene.rooms:
        found.rooms += 1
        found.furniture += len(room.furniture)
        found.unproven += not reports[room.id]["proven"]
        if has_minimum_area(room):
            found.large_enough += 1
            if room.id in short:
                found.missing.append(f"seed {seed}: {short[room.id]}")
    return found


def houses(seeds: int, workers: int) -> bool:
    """Prints the table of houses; returns whether the targets are met."""
    good = True
    print("| set | seeds | rooms | pieces | errors | warnings | missing / rooms large enough | CPU ms a house | rooms not proven |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, (_, fewer) in SETS.items():
        count = max(seeds // fewer, 1)
        total = Tally()
        for part in _spread(house, [(name, seed) for seed in range(count)], workers, name):
            total.add(part)
        errors, warnings = (sum(n for rule, n in total.rules.items() if rule.startswith(word)) for word in ("error", "warning"))
        good &= errors == 0 and (name != "defaults" or len(total.missing) <= MISSING_TARGET * max(total.large_enough, 1))
        print(
            f"| {name} | {count:,} | {total.rooms:,} | {total.furniture:,} | {errors} | {warnings} "
            f"| {len(total.missing)} / {total.large_enough:,} | {statistics.median(total.cpu_ms):.0f} | {total.unproven} |"
        )
        for line in (*sorted(f"{rule}: {n}" for rule, n in total.rules.items()), *total.missing[:5]):
            print(f"{name}: {line}", file=sys.stderr)
    return good


def programme(seeds: int, workers: int) -> bool:
    """Prints the table of planned homes, and what a tenth of them show when furnished; returns whether targets are met."""
    table, missed = programme_table(seeds)
    print(table, *missed, sep="\n")
    good, count = not missed, max(seeds // 10, 1)
    for name in PRESET_SETS:
        total = Tally()
        for part in _spread(house, [(name, seed) for seed in range(count)], workers, name):
            total.add(part)
        errors = sum(n for rule, n in total.rules.items() if rule.startswith("error"))
        good &= errors == 0 and len(total.missing) <= MISSING_TARGET * total.rooms
        print(f"{name}: {count} homes furnished, {total.rooms} rooms, {errors} errors, {len(total.missing)} lack a required piece")
    return good


def forced(case: Case) -> list[str]:
    """Furnishes one forced room; returns what is wrong with it."""
    made = case.furnished()
    return [f"{case}: {issue.message}" for issue in made.issues if issue.severity == "error" or _missing(issue.rule)]


def _missing(rule: str) -> bool:
    return rule == "missing_required"


def rooms(workers: int) -> bool:
    """Prints what is wrong with the forced rooms; returns whether nothing is."""
    everything = list(cases())
    wrong = [line for lines in _spread(forced, everything, workers, "forced rooms") for line in lines]
    print(f"forced rooms: {len(everything)} of {len({c.room_type for c in everything})} types, {len(wrong)} complaints")
    for line in wrong[:40]:
        print(f"  {line}")
    return not wrong


def generated_calls() -> bool:
    """Makes five thousand generated calls; returns whether the service kept to its OpenAPI document."""
    words = [sys.executable, "-m", "pytest", "-q", "tests/service/test_openapi_cases.py"]
    return subprocess.run(words, env={**os.environ, "CASES": "500"}, check=False).returncode == 0


def sweeps(workers: int) -> bool:
    """Runs all of the tests of which the suite runs a slice, the page's among them; returns whether all passed."""
    files = [str(path) for path in sorted(TESTS.rglob("test_*.py")) if SLICED.search(path.read_text(encoding="utf-8"))]
    python = ["-m", "pytest", "-q", "-n", str(workers), "--dist", "loadgroup", *files]
    page = [str(TESTS.parent / "scripts" / "page.py"), "test"]
    ended = [subprocess.run([sys.executable, *one], env={**os.environ, "SWEEPS": "all"}, check=False) for one in (python, page)]
    return all(one.returncode == 0 for one in ended)


def _spread(work: Callable[[In], Out], jobs: list[In], workers: int, name: str) -> Iterable[Out]:
    with ProcessPoolExecutor(workers) as pool:
        yield from tqdm(pool.map(work, jobs, chunksize=4), total=len(jobs), desc=name, file=sys.stderr)


def floorplan(seeds: int) -> bool:
    """Prints what floor plans are like."""
    print(floorplan_table(seeds))
    return True


def main() -> int:
    """Runs the measurements asked for, in the order of the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", nargs="*", default=UNASKED)
    parser.add_argument("--seeds", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    measurements: Mapping[str, Callable[[], bool]] = {
        "imports": imports,
        "floorplan": lambda: floorplan(asked.seeds),
        "programme": lambda: programme(asked.seeds, asked.workers),
        "rooms": lambda: rooms(asked.workers),
        "houses": lambda: houses(asked.seeds, asked.workers),
        "calls": generated_calls,
        "sweeps": lambda: sweeps(asked.workers),
        "homes": lambda: homes(asked.seeds, asked.workers),
        "glb": lambda: glb_homes(min(asked.seeds, 100), asked.workers),
        "usd": lambda: usd_homes(min(asked.seeds, 100), asked.workers),
        "drags": lambda: drags(min(asked.seeds, 60), asked.workers),
        "nav2": lambda: nav2_maps(min(asked.seeds, 100), asked.workers),
        "physics": lambda: physics(min(asked.seeds, 100), asked.workers) & fronts_of_homes(min(asked.seeds, 100), asked.workers),
        "agree": lambda: formats_agree(min(asked.seeds, 100), asked.workers),
        "plans": lambda: drawings(min(asked.seeds, 100), asked.workers),
        "sh3d": sweet_homes,
        "datasets": lambda: datasets(min(asked.seeds, 500)),
        "engines": lambda: engines(min(asked.seeds, 300)),
        "access": lambda: accessible_homes(min(asked.seeds, 120), asked.workers),
        "files": hostile_files,
        "thrown": lambda: thrown_about(min(asked.seeds, 200), asked.workers),
    }
    if unknown := set(asked.what) - set(measurements):
        parser.error(f"unknown: {', '.join(sorted(unknown))}; choose from {', '.join(measurements)}")
    kept = [measure() for name, measure in measurements.items() if name in asked.what]
    return 0 if all(kept) else 1


if __name__ == "__main__":
    sys.exit(main())
