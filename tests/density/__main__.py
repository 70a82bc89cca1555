"""Prints how furnished rooms measure up: `python -m tests.density [--rooms N] [--equal N]`.

Per type: cover, pieces, slivers, windows blocked, armchairs turned away, free sight lines, working triangles; and how many
arrangements of one room differ.
"""

from __future__ import annotations

import argparse
import statistics
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from solver.scene import Room
from tests.density import ruler
from tests.density.rooms import EQUAL, KINDS, drawn, equal


def report(name: str, rooms: Sequence[Room]) -> str:
    """Returns one line about the rooms of a type."""
    covers = sorted(ruler.cover(room) for room in rooms)
    counts = [ruler.slivers(room) for room in rooms]
    parts = [
        f"cover {statistics.median(covers):.2f} ({covers[len(covers) // 20]:.2f}-{covers[-1 - len(covers) // 20]:.2f})",
        f"pieces {statistics.median(len(room.furniture) for room in rooms):.0f}",
        f"slivers {100 * sum(n for n, _ in counts) / max(sum(k for _, k in counts), 1):.1f} %",
        f"rooms with one {100 * statistics.fmean(n > 0 for n, _ in counts):.0f} %",
        f"under windows {100 * statistics.fmean(bool(ruler.under_windows(room)) for room in rooms):.0f} %",
    ]
    kept = [ruler.comfort(room) for room in rooms]
    if any(total for _, total in kept):
        parts.append(f"comfort {100 * sum(n for n, _ in kept) / sum(n for _, n in kept):.0f} %")
    away = [ruler.turned_away(room) for room in rooms]
    if any(total for _, total in away):
        parts.append(f"armchairs away {sum(n for n, _ in away)}/{sum(n for _, n in away)}")
    sights = [free for room in rooms if (free := ruler.sight_free(room)) is not None]
    if sights:
        parts.append(f"sight free {100 * statistics.fmean(sights):.0f} % of {len(sights)}")
    legs = [found for room in rooms if (found := ruler.triangle(room)) is not None]
    if legs:
        parts.append(f"triangle {100 * statistics.fmean(ruler.works(found) for found in legs):.0f} %")
    return f"{name:15} " + "  ".join(parts)


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rooms", type=int, default=200)
    parser.add_argument("--equal", type=int, default=100)
    parser.add_argument("--types", nargs="*", default=list(KINDS))
    given = parser.parse_args()
    with ProcessPoolExecutor(2) as pool:
        for name in given.types if given.rooms else ():
            print(report(name, list(pool.map(partial(drawn, name), range(given.rooms), chunksize=10))), flush=True)
        for of in EQUAL if given.equal else ():
            if of.room_type in given.types:
                found = list(pool.map(partial(equal, of), range(given.equal), chunksize=10))
                print(f"{of}: {len({ruler.signature(room) for room in found})} of {given.equal} differ", flush=True)


if __name__ == "__main__":
    main()
