"""What a home costs from request to JSON, stage by stage, beside the least that any such solver must do, in one run.

    python -m tests.bench.flow [--seeds 100]

Prints Markdown; CPU ms, in a process like those of the service and of data sets. The limit is what nobody can leave out: OSQP on the home's
final problem, from nothing ("cold") or begun at its optimum ("warm"), and the home's JSON. Growth is over plain houses of more and more
rooms. Starting and memory are of new processes.
"""

from __future__ import annotations

import argparse
import gc
import math
import os
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple
from unittest import mock

from tqdm import tqdm

from catalogs import load_catalogs
from service.packed_catalogs import packed, warm
from solver import Request, generate
from solver.exchange import dump_scene
from solver.pipeline.generate import wanted_in
from solver.placement import place, qp
from solver.placement.osqp_binary import OsqpAnswer, solve
from solver.scene import Scene
from tests.bench.__main__ import percentile

SETS: Mapping[str, dict[str, Any]] = {
    "plain default": {}, "family, decorated": {"program": "family", "decorate": True},
    "large, decorated": {"program": "large", "decorate": True},
}  # fmt: skip
STAGES = ("floorplan", "furniture", "decorations", "people", "validate", "json", "total")
LIMIT_HOMES = 20
"""Homes a set whose final problem is solved again, for the limit."""
GROWTH = ((46, 43), (72, 66), (125, 116), (186, 173), (280, 260))
"""Sizes, m, of the plain houses of growing numbers of rooms: some 100, 200, 500, 1,000 and 2,000."""
GROWTH_SEEDS, GROWTH_DEPTH = (1, 2, 3), 12


class Home(NamedTuple):
    """A home and what it cost, ms by stage."""

    scene: Scene
    ms: Mapping[str, float]


def made(request: Request) -> Home:
    """Makes a home and its JSON."""
    answer = generate(request, clock=time.process_time)
    begun = time.process_time()
    dump_scene(answer.scene, "json")
    taken = 1000 * (time.process_time() - begun)
    return Home(answer.scene, {**answer.timing_ms, "json": taken, "total": answer.timing_ms["total"] + taken})


def homes(name: str, seeds: range) -> list[Home]:
    """Makes the homes of a set."""
    return [made(Request(seed=seed, **SETS[name])) for seed in tqdm(seeds, desc=name, disable=None)]


def cpu_ms(do: Callable[[], object], rounds: int = 5) -> float:
    """The least CPU time of some rounds, ms."""
    found = []
    for _ in range(rounds):
        begun = time.process_time()
        do()
        found.append(1000 * (time.process_time() - begun))
    return min(found)


def limit(scene: Scene) -> tuple[float, float, int]:
    """What OSQP takes for a home's final problem, cold and warm, set up each time, and its iterations begun at the optimum."""
    known = load_catalogs()
    with mock.patch.object(qp, "solve", wraps=solve) as asked:
        place([wanted_in(scene, room, known) for room in scene.rooms])
    programme, begun_at, settings = asked.call_args.args

    def again(warm: bool) -> OsqpAnswer:
        return solve(programme, begun_at if warm else None, {**settings, "check_termination": 1 if warm else 25})

    return cpu_ms(lambda: again(False)), cpu_ms(lambda: again(True)), again(True).iterations


def stage_lines(found: Mapping[str, Sequence[Home]]) -> Iterator[str]:
    """The table of stages."""
    yield "| CPU ms a home | rooms | " + " | ".join(STAGES) + " | ms a room | p99 |"
    yield "|:--|" + "--:|" * (len(STAGES) + 3)
    for name, made_homes in found.items():
        rooms = statistics.mean(len(home.scene.rooms) for home in made_homes)
        medians = [statistics.median(home.ms.get(stage, 0.0) for home in made_homes) for stage in STAGES]
        solved = [(home.ms["total"] - home.ms["floorplan"]) / len(home.scene.rooms) for home in made_homes]
        cells = [f"{value:.1f}" for value in medians]
        yield f"| {name} | {rooms:.1f} | {' | '.join(cells)} | {statistics.median(solved):.2f} | {percentile(solved, 0.99):.2f} |"


def limit_lines(found: Mapping[str, Sequence[Home]]) -> Iterator[str]:
    """The table of the whole flow beside its limit."""
    yield "| of a home, ms | OSQP cold | OSQP warm | iterations, most | JSON | whole flow: times the warm limit | times the cold one |"
    yield "|:--|--:|--:|--:|--:|--:|--:|"
    for name, made_homes in found.items():
        few = made_homes[:LIMIT_HOMES]
        cold, warm, steps = zip(*(limit(home.scene) for home in few), strict=True)
        text = statistics.median(home.ms["json"] for home in few)
        whole = statistics.median(home.ms["total"] for home in few)
        nothing, begun = statistics.median(cold), statistics.median(warm)
        cells = [f"{nothing:.2f}", f"{begun:.3f}", str(max(steps)), f"{text:.2f}"]
        yield f"| {name} | {' | '.join(cells)} | {whole / (begun + text):.0f} | {whole / (nothing + text):.0f} |"


def growth_lines() -> Iterator[str]:
    """How a house's time and memory grow with its rooms; the exponent is that of the line through all homes that errs least."""
    yield "| plain houses, m | rooms | CPU ms | ms a room | memory of a process, MB |"
    yield "|:--|--:|--:|--:|--:|"
    points = []
    for width, depth in GROWTH:
        of_size = []
        for seed in GROWTH_SEEDS:
            gc.collect()
            request = Request(seed=seed, width=width, depth=depth, max_depth=GROWTH_DEPTH)
            twice = [made(request) for _ in range(2)]
            of_size.append((len(twice[0].scene.rooms), min(home.ms["total"] for home in twice)))
        points += of_size
        rooms, ms = (statistics.mean(column) for column in zip(*of_size, strict=True))
        words = f"-m compose_homes generate --seed 1 --width {width} --depth {depth} --max-depth {GROWTH_DEPTH}".split()
        memory = peak_mb([sys.executable, *words], dict(os.environ))
        yield f"| {width} x {depth} | {rooms:.0f} | {ms:.0f} | {ms / rooms:.2f} | {memory:.0f} |"
    sizes, times = ([math.log(value) for value in column] for column in zip(*points, strict=True))
    yield f"\nGrowth exponent from {min(points)[0]} to {max(points)[0]} rooms: {statistics.linear_regression(sizes, times).slope:.2f}."


def start_lines() -> Iterator[str]:
    """What new processes cost, their modules compiled before as in any second one: CPU s and memory."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    yield "| new process | CPU s | memory, MB |"
    yield "|:--|--:|--:|"
    commands = {
        "import compose_homes": ["-c", "import compose_homes"],
        "compose schema": ["-m", "compose_homes", "schema"],
        "compose generate, family": ["-m", "compose_homes", "generate", "--seed", "1", "--program", "family"],
        "a worker, ready": [
            "-c",
            "from catalogs import load_catalogs; from service.packed_catalogs import packed, warm; warm(packed(load_catalogs()))",
        ],
    }
    for name, words in commands.items():
        child = [sys.executable, *words]
        peak = peak_mb(child, environment)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(child, stdout=subprocess.PIPE, env=environment, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        yield f"| {name} | {seconds:.2f} | {peak:.0f} |"


def peak_mb(command: Sequence[str], environment: Mapping[str, str]) -> float:
    """The most memory that a command takes, MB, as told by a process that does nothing but run it."""
    ask = "import resource, subprocess, sys; subprocess.run(sys.argv[1:], stdout=subprocess.PIPE, check=True); "
    tell = "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    told = [sys.executable, "-S", "-c", ask + tell, *command]
    done = subprocess.run(told, capture_output=True, env=environment, text=True, check=True)
    return int(done.stdout) / 1024


def main() -> int:
    """Prints the tables."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--seeds", type=int, default=100, help="homes a set (100)")
    seeds = range(arguments.parse_args().seeds)
    made(Request(seed=seeds.stop, program="family", decorate=True))
    warm(packed(load_catalogs()))
    found = {name: homes(name, seeds) for name in SETS}
    for lines in (stage_lines(found), limit_lines(found), growth_lines(), start_lines()):
        print("\n".join(lines), end="\n\n", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
