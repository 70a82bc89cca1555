"""What formats cost: `python -m tests.exports.sizes` prints a table of sizes and of the processor's time for two homes.

Times are the least of several runs in one process, without what is done once: importing libraries, reading the catalogs.
"""

from __future__ import annotations

import time
import zlib
from collections.abc import Callable
from functools import partial
from typing import Final

from catalogs import load_catalogs
from solver import Request, generate
from solver.export_formats import EXPORTERS
from solver.exports import Files, describe
from solver.pipeline.export import export_each
from solver.scene import Scene
from solver.validator import validate

HOMES: Final = {
    "family": Request(seed=2024, program="family", decorate=True),
    "default": Request(seed=2024, decorate=True),
}
RUNS: Final = 9
SLOW: Final = 0.3
"""What takes longer than this, s, is run three times only."""


def least(work: Callable[[], object]) -> float:
    """Returns the least of several times of some work, CPU ms."""
    times: list[float] = []
    while len(times) < (3 if times and min(times) > SLOW else RUNS):
        begun = time.process_time()
        work()
        times.append(time.process_time() - begun)
    return 1000 * min(times)


def row(scene: Scene, format: str) -> list[str]:
    """Returns a format's cells for one home: files, KB, KB compressed, ms described and written."""
    catalogs = load_catalogs()
    issues = validate(scene, catalogs)

    def work() -> Files:
        return export_each(scene, (format,), catalogs, issues, "light")[format]

    files = work()
    size, packed = sum(map(len, files.values())), sum(len(zlib.compress(content)) for content in files.values())
    return [str(len(files)), f"{size / 1000:,.0f}", f"{packed / 1000:,.0f}", f"{least(work):,.0f}"]


def main() -> None:
    """Prints the table."""
    print("Written by `python -m tests.exports.sizes`: decorated homes of seed 2024; times include the description.\n")
    names = " | ".join(f"{name}: files | KB | KB packed | CPU ms" for name in HOMES)
    print(f"| format | {names} |\n|---|{'---|' * 4 * len(HOMES)}")
    scenes = {name: generate(request).scene for name, request in HOMES.items()}
    times = [least(partial(describe, scene, load_catalogs())) for scene in scenes.values()]
    described = [cell for taken in times for cell in ("", "", "", f"{taken:,.0f}")]
    print(f"| the description | {' | '.join(described)} |")
    for format in EXPORTERS:
        print(f"| `{format}` | {' | '.join(cell for scene in scenes.values() for cell in row(scene, format))} |")


if __name__ == "__main__":
    main()
