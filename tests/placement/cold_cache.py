"""The whole kernel compiled by two processes at once, some two minutes: `python -m tests.targets kernel`."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[2]
HOUSE = "import sys; from tests.pipeline.test_same_bytes import house; sys.stdout.buffer.write(house(5))"
SAID = b"compiling the placement kernel"


def started(cache: Path | None, *program: str) -> subprocess.Popen[bytes]:
    """Starts a Python program with a cache of its own for compiled code, or with everyone's."""
    own = {} if cache is None else {"NUMBA_CACHE_DIR": str(cache)}
    return subprocess.Popen([sys.executable, *program], cwd=ROOT, env={**os.environ, **own}, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def files(cache: Path) -> set[Path]:
    """Returns what a cache holds."""
    return {path.relative_to(cache) for path in cache.rglob("*") if path.is_file()}


def kernel() -> bool:
    """Compiles the kernel in two processes with one cold cache; prints and returns whether all is as it should be."""
    with TemporaryDirectory() as folder:
        cold = Path(folder)
        both = [process.communicate() for process in [started(cold, "-c", HOUSE), started(cold, "-c", HOUSE)]]
        compiled = files(cold)
        warm, everyones = started(cold, "-c", HOUSE).communicate(), started(None, "-c", HOUSE).communicate()
        good = {
            "one compiles and says so": sorted(errors.count(b"\n") for _, errors in both) == [0, 1] and SAID in both[0][1] + both[1][1],
            "the same house, cold, warm and everywhere": {everyones[0], both[0][0], both[1][0]} == {warm[0]} and len(warm[0]) > 10_000,
            "warm: nothing is said or written": warm[1] == b"" and files(cold) == compiled,
            "every function is kept": sum(path.suffix == ".nbc" for path in compiled) > 50,
            "nothing half written is left": not [path for path in compiled if ".tmp." in path.name],
        }  # fmt: skip
    for words, held in good.items():
        print(f"{'held  ' if held else 'MISSED'}  {words}")
    return all(good.values())
