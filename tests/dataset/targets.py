"""What `make targets` asks of datasets: one digest whoever makes them, however often they are ended; CPU and memory a home.

python -m tests.dataset.targets [--homes 500]
"""

from __future__ import annotations

import argparse
import os
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

SHARD = 25
KILLS = 5


class Run(NamedTuple):
    """A run of `compose dataset`: a digest of its files, ms of CPU a home made, wall seconds, MB of its largest process but Ray's."""

    digest: str
    cpu_ms: str
    wall: float
    megabytes: int


def command(folder: Path, homes: int, *more: str) -> list[str]:
    """Returns the words of a run."""
    words = [sys.executable, "-m", "compose_homes", "dataset", "--program", "family", "--shard-size", str(SHARD)]
    return [*words, "--seeds", f"0-{homes - 1}", "--out", str(folder), *more]


def digest(folder: Path) -> str:
    """Returns a digest of every file of a folder."""
    from hashlib import sha256

    found = sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            found.update(f"{path.relative_to(folder)}\n".encode() + path.read_bytes())
    return found.hexdigest()[:16]


def run(folder: Path, homes: int, *more: str) -> Run:
    """Makes a dataset in processes of its own."""
    start = time.perf_counter()
    said = subprocess.run(command(folder, homes, *more), check=True, capture_output=True, text=True).stderr
    wall, largest = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss >> 10
    return Run(digest(folder), "".join(re.findall(r"([\d.]+) ms of CPU each", said)), wall, largest)


def killed(folder: Path, homes: int) -> Run:
    """Makes a dataset, ended by SIGKILL at KILLS random moments."""
    draw = random.Random(7)
    for _ in range(KILLS):
        with subprocess.Popen(command(folder, homes, "--workers", "2"), stderr=subprocess.DEVNULL) as going:
            try:
                going.wait(draw.uniform(3.0, 12.0))
            except subprocess.TimeoutExpired:
                os.kill(going.pid, signal.SIGKILL)
    return run(folder, homes, "--workers", "2")


def datasets(homes: int) -> bool:
    """Prints a table of runs; returns whether all made the same files."""
    print(f"| {homes} homes | files' digest | CPU ms a home | wall s | largest process, MB |\n|---|---|---|---|---|")
    found = []
    ways = {"1 process": ("--workers", "1"), "2 processes": ("--workers", "2"), "4 processes": ("--workers", "4")}
    with tempfile.TemporaryDirectory() as name:
        for words, more in {**ways, "Ray, 2 processors": ("--workers", "2", "--ray")}.items():
            found.append(_told(words, run(Path(name, words), homes, *more)))
        found.append(_told(f"2 processes, killed {KILLS} times", killed(Path(name, "killed"), homes)))
    return len({one.digest for one in found}) == 1


def _told(words: str, one: Run) -> Run:
    print(f"| {words} | {one.digest} | {one.cpu_ms} | {one.wall:.0f} | {one.megabytes} |", flush=True)
    return one


def main() -> int:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--homes", type=int, default=500)
    return int(not datasets(parser.parse_args().homes))


if __name__ == "__main__":
    sys.exit(main())
