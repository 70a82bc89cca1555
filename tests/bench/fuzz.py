"""100,000 random rooms through place(), every answer checked in exact integers by code of its own: `make fuzz`.

    python -m tests.bench.fuzz [--rooms 100000] [--first 0] [--oracle 500] [--workers 2]

Counts faults of what stands, doors and use sides that cannot be walked to, rooms that differ alone and in company, and
whether every conflict reported for a required piece left out is minimal. In the first rooms, by default 500, the oracle
judges the conflicts and says what could have been walkable; in the rest the engine's own verdicts do. Exit status 1 where
anything is wrong.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field

from tqdm import tqdm

from solver.pieces import Arrangement, Piece, Space
from solver.placement import feasible, minimal_conflict, place
from tests.bench.fuzz_rooms import fuzz_room
from tests.oracles.paths import stand_and_walk
from tests.oracles.room import stand_together
from tests.oracles.rules import faults, unreached

Judge = tuple[bool, Counter[str]]
"""Whether the oracle is asked, and where to count."""
CHUNK = 20
"""Rooms placed in one call, as those of a house."""


@dataclass
class Tally:
    """What some rooms show: counts by word, and what is wrong in words."""

    counts: Counter[str] = field(default_factory=Counter)
    wrong: list[str] = field(default_factory=list)
    cpu: float = 0.0

    def add(self, other: Tally) -> None:
        """Adds another tally to this one."""
        self.counts += other.counts
        self.wrong += other.wrong
        self.cpu += other.cpu


def chunk(job: tuple[int, int, bool]) -> Tally:
    """Places the rooms of the seeds [first, last) in one call and judges each; `oracle` says who judges conflicts."""
    first, last, oracle = job
    tally = Tally()
    rooms = [fuzz_room(seed) for seed in range(first, last)]
    start = time.process_time()
    arrangements = place(rooms)
    tally.cpu = time.process_time() - start
    if place([rooms[0]]) != arrangements[:1]:
        tally.wrong.append(f"seed {first}: alone it is another arrangement than in company")
    for seed, (space, wanted), arrangement in zip(range(first, last), rooms, arrangements, strict=True):
        wrong = judged(space, wanted, arrangement, (oracle, tally.counts))
        wrong += conflicts(space, wanted, arrangement, (oracle, tally.counts))
        tally.wrong += [f"seed {seed}: {fault}" for fault in wrong]
    return tally


def judged(space: Space, wanted: Sequence[Piece], arrangement: Arrangement, judge: Judge) -> list[str]:
    """Lists what is wrong with an arrangement, and counts.

    An optional piece that cannot be walked to must not stand; a required one may, and counts as blocked.
    """
    oracle, counts = judge
    required = [piece for piece in wanted if piece.required]
    labels = {piece.label for piece in required}
    wrong = faults(space, wanted, arrangement)
    short = unreached(space, wanted, arrangement)
    counts.update(rooms=1, pieces=len(wanted), placed=len(arrangement.placed), proven=arrangement.proven)
    counts["rooms that say they are not walkable"] += bool(arrangement.notes)
    if short and not arrangement.notes:
        counts["rooms with a blocked required piece"] += 1
        wrong += [f"{label} cannot be walked to" for label in short if label not in labels]
    if short and oracle and space.doorways:
        counts[f"not walkable; the oracle's verdict on the required pieces: {stand_and_walk(space, required).verdict}"] += 1
    return wrong


def conflicts(space: Space, wanted: Sequence[Piece], arrangement: Arrangement, judge: Judge) -> list[str]:
    """Asks why required pieces were left out; lists the conflicts that are none or not minimal, and what need not be left out."""
    oracle, counts = judge
    there = {piece.label for piece in arrangement.placed}
    required = {piece.label for piece in wanted if piece.required}
    wrong: list[str] = []
    for label in (label for label, _ in arrangement.left_out if label in required):
        group = [piece for piece in wanted if piece.required and (piece.label in there or piece.label == label)]
        members = minimal_conflict(space, group, label)
        counts["required pieces left out"] += 1
        counts["conflicts" if members else "left out without a conflict"] += 1
        if members:
            counts["conflicts of several pieces"] += len(members) > 1
            wrong += not_minimal(space, [piece for piece in group if piece.label in members], oracle)
        elif oracle and arrangement.proven and space.doorways and stand_and_walk(space, group).verdict:
            wrong.append(f"{label} is left out, as if proven, although it can stand and be walked to")
    return wrong


def not_minimal(space: Space, members: Sequence[Piece], oracle: bool) -> list[str]:
    """Lists what speaks against a conflict: its members can stand, or without one of them the rest cannot.

    Who leaves a member out leaves out with it what can only stand attached to it.
    """

    def verdict(pieces: Sequence[Piece]) -> bool | None:
        return stand_together(space, pieces).verdict if oracle else feasible(space, pieces)

    names = ", ".join(piece.label for piece in members)
    wrong = [f"the conflict {names} can stand"] if verdict(members) is True else []
    for piece in members:
        if verdict(without(members, piece)) is False:
            wrong.append(f"the conflict {names} is one without {piece.label}")
    return wrong


def without(members: Sequence[Piece], gone: Piece) -> list[Piece]:
    """Returns the members but one and all that then have nothing left to be attached to."""
    kept: list[Piece] = []
    for piece in members:  # parents come first
        there = {other.label for other in kept}
        hangs = bool(piece.candidates) and all(a.attach is not None and a.attach.parent not in there for a in piece.candidates)
        if piece.label != gone.label and not hangs:
            kept.append(piece)
    return kept


def fuzz(first: int, rooms: int, oracle: int, workers: int = 1) -> Tally:
    """Runs the fuzz over seeds [first, first + rooms); conflicts of the first `oracle` rooms are the oracle's to judge."""
    last = first + rooms
    jobs = [(at, min(at + CHUNK, last), at - first < oracle) for at in range(first, last, CHUNK)]
    total = Tally()
    if workers == 1:
        for job in jobs:
            total.add(chunk(job))
        return total
    with ProcessPoolExecutor(workers) as pool:
        for tally in tqdm(pool.map(chunk, jobs, chunksize=2), "fuzz", len(jobs), unit=f" x {CHUNK} rooms", file=sys.stderr):
            total.add(tally)
    return total


def main() -> int:
    """Runs the fuzz and prints what it saw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", type=int, default=100_000)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--oracle", type=int, default=500, help="rooms whose conflicts the oracle judges")
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    total = fuzz(asked.first, asked.rooms, asked.oracle, asked.workers)
    print("| what | figure |\n|---|---|")
    for word, count in {**total.counts, "wrong": len(total.wrong)}.items():
        print(f"| {word} | {count:,} |")
    print(f"| CPU ms a room | {1000 * total.cpu / max(asked.rooms, 1):.2f} |")
    for fault in total.wrong[:40]:
        print(f"  {fault}")
    return int(bool(total.wrong))


if __name__ == "__main__":
    sys.exit(main())
