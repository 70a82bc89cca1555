"""Prints what a designer would count in whole homes: `python -m tests.density.homes [--seeds N] [--first N] [--presets ...]`.

Per preset, decorated: the share of each line of `living_ruler.py` and `wet_ruler.py`. Exit status 1 where one is not as wanted (`!`).
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from tqdm import tqdm

from solver import Request, generate
from solver.scene import Scene
from tests.density import living_ruler, wet_ruler
from tests.density.living_ruler import Count, Line

LINES = (*living_ruler.LINES, *wet_ruler.LINES)
PRESETS: Mapping[str, str | None] = {"default": None, "one_bed": "one_bed", "studio": "studio", "family": "family", "large": "large"}
"""The program of each column."""


def home(preset: str, seed: int) -> Scene:
    """Returns the decorated home of a seed."""
    return generate(Request(seed=seed, program=PRESETS[preset], decorate=True)).scene


def counted(preset: str, seed: int) -> list[Count]:
    """Returns what each line counts in the home of a seed."""
    scene = home(preset, seed)
    return [line.count(scene) for line in LINES]


def total(counts: Iterable[Sequence[Count]]) -> list[Count]:
    """Adds the counts of many homes, line by line."""
    return [(sum(held for held, _ in of), sum(all_ for _, all_ in of)) for of in zip(*counts, strict=True)]


def is_wanted(line: Line, preset: str, count: Count) -> bool:
    """Tells whether a line's share is as wanted; of no cases it is."""
    held, cases = count
    wanted = line.wanted.get(preset, line.wanted["*"])
    return not cases or (held <= wanted * cases + 1e-9 if line.most else held >= wanted * cases - 1e-9)


def main() -> int:
    """Prints the table; returns 1 where a share is not as wanted."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--first", type=int, default=70_000)
    parser.add_argument("--presets", nargs="*", default=list(PRESETS), choices=list(PRESETS))
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    seeds, good = range(asked.first, asked.first + asked.seeds), True
    found: dict[str, list[Count]] = {}
    with ProcessPoolExecutor(asked.workers) as pool:
        for preset in asked.presets:
            work = pool.map(partial(counted, preset), seeds, chunksize=4)
            found[preset] = total(tqdm(work, total=len(seeds), desc=preset, file=sys.stderr))
    print("| share, % of cases | wanted | " + " | ".join(found) + " |")
    print("|---|---|" + "---|" * len(found))
    for k, line in enumerate(LINES):
        cells = []
        for preset, counts in found.items():
            kept, (held, cases) = is_wanted(line, preset, counts[k]), counts[k]
            good &= kept
            cells.append(f"{100 * held / cases:.0f} of {cases}{'' if kept else ' !'}" if cases else "-")
        sign = "<=" if line.most else ">="
        print(f"| {line.says} | {sign} {100 * line.wanted['*']:.0f} | " + " | ".join(cells) + " |")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
