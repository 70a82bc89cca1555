"""Prints how furnished rooms measure up: `python -m tests.density [--rooms N] [--equal N]`.

Per type: cover, pieces, slivers, windows blocked, armchairs turned away, free sight lines, working triangles; and how many
arrangements of one room differ.
"""

from __future__ import annotations

import argparse
import statistics
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from solver.scene import Room
from tests.density import ruler
from tests.density.rooms import EQUAL, KINDS, drawn, equal

HEAD = "| type | m2 | floor covered, median (5-95 %) | pieces | slivers | tall or soft centred at a window | comfort | other |"


def report(name: str, rooms: Sequence[Room]) -> str:
    """Returns the row of a type."""
    covers = sorted(ruler.cover(room) for room in rooms)
    counts = [ruler.slivers(room) for room in rooms]
    kept = [ruler.comfort(room) for room in rooms]
    cells = [
        name.replace("_", " "),
        "-".join(f"{area:g}" for area in KINDS[name].dense),
        f"{statistics.median(covers):.2f} ({covers[len(covers) // 20]:.2f}-{covers[-1 - len(covers) // 20]:.2f})",
        f"{statistics.median(len(room.furniture) for room in rooms):.0f}",
        _share(counts),
        f"{100 * statistics.fmean(bool(ruler.under_windows(room)) for room in rooms):.0f} %",
        _share(kept),
        ", ".join(_others(rooms)),
    ]
    return f"| {' | '.join(cells)} |"


def _share(counts: Iterable[tuple[int, int]]) -> str:
    """Writes which share of all counts; nothing where there are none."""
    pairs = list(counts)
    held, of = sum(n for n, _ in pairs), sum(n for _, n in pairs)
    return f"{100 * held / of:.0f} %" if of else ""


def _others(rooms: Sequence[Room]) -> Iterator[str]:
    """Yields what is measured in some types alone."""
    if share := _share(ruler.turned_away(room) for room in rooms):
        yield f"armchairs turned away {share}"
    if share := _share((free, 1) for room in rooms if (free := ruler.sight_free(room)) is not None):
        yield f"sight free {share}"
    if share := _share((ruler.works(found), 1) for room in rooms if (found := ruler.triangle(room)) is not None):
        yield f"working triangle {share}"


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rooms", type=int, default=200)
    parser.add_argument("--equal", type=int, default=100)
    parser.add_argument("--types", nargs="*", default=list(KINDS))
    given = parser.parse_args()
    if given.rooms:
        print(HEAD, "|---" * (HEAD.count("|") - 1) + "|", sep="\n")
    with ProcessPoolExecutor(2) as pool:
        for name in given.types if given.rooms else ():
            print(report(name, list(pool.map(partial(drawn, name), range(given.rooms), chunksize=10))), flush=True)
        for of in EQUAL if given.equal else ():
            if of.room_type in given.types:
                found = list(pool.map(partial(equal, of), range(given.equal), chunksize=10))
                print(f"{of}: {len({ruler.signature(room) for room in found})} of {given.equal} differ", flush=True)


if __name__ == "__main__":
    main()
