"""What it costs to say what a room wants: the core against the same stage in Python, in one run.

    python -m tests.bench.furnish_cost [--homes 8]

Prints Markdown: CPU us a room, no garbage collection. Ends with 1 where the two differ in any bit.
"""

from __future__ import annotations

import argparse
import gc
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from catalogs import Catalogs, load_catalogs
from solver.core import CoreInstance
from solver.floorplan import draw
from solver.furnish import space_of, wanted_pieces
from solver.furnish.compiled_types import compiled_type
from solver.furnish.core_rows import answer_of, room_rows
from solver.pieces import Space
from solver.request import Request
from solver.scene import Room
from solver.streams import Stream
from tests.core.test_furnish import bits
from tests.furnish.reference import stage

ROUNDS, WALL_M = 9, 0.1


class Case(NamedTuple):
    """A room to be furnished."""

    room: Room
    space: Space
    catalogs: Catalogs
    seed: int

    @property
    def stream(self) -> Stream:
        """The room's stream, new."""
        return Stream(self.seed, "furnish", self.room.index)

    def rows(self) -> bytes:
        """Returns the room as the core reads it."""
        return room_rows(self.room, self.space, self.room.width * self.room.depth, self.stream.state)


def cases(homes: int, program: str | None) -> list[Case]:
    """Returns the rooms of some homes."""
    found = []
    for seed in range(homes):
        plan = draw(Request(seed=seed, program=program), load_catalogs())
        known = load_catalogs().of_home([room.type for room in plan.rooms]) if program else load_catalogs()
        found += [Case(room, space_of(room, WALL_M), known, seed) for room in plan.rooms]
    return found


def micros(rooms: Sequence[Case], do: Callable[[int], Any]) -> float:
    """Returns CPU us a room, the least of some rounds."""
    least = float("inf")
    for _ in range(ROUNDS):
        start = time.process_time()
        for i in range(len(rooms)):
            do(i)
        least = min(least, time.process_time() - start)
    return 1e6 * least / len(rooms)


def measured(rooms: Sequence[Case]) -> list[tuple[str, float]]:
    """Returns what each way costs, the Python first."""
    core = CoreInstance()
    known = [compiled_type(one.catalogs.rooms[one.room.type], one.catalogs).data for one in rooms]
    asked = [one.rows() for one in rooms]
    there = [(core.write(types), len(types), core.write(rows), len(rows)) for types, rows in zip(known, asked, strict=True)]
    mark = core.mark()

    def alone(i: int) -> None:
        core.call("furnish", *there[i])
        core.release(mark)

    def copied(i: int, rows: bytes | None = None) -> bytes:
        rows = rows or asked[i]
        packed = core.call("furnish", core.write(known[i]), len(known[i]), core.write(rows), len(rows))
        found = core.read(packed & 0xFFFFFFFF, packed >> 32)
        core.release(mark)
        return found

    def python(i: int) -> None:
        stage.wanted_pieces(rooms[i].room, rooms[i].space, rooms[i].catalogs, rooms[i].stream)

    def objects(i: int) -> None:
        wanted_pieces(rooms[i].room, rooms[i].space, rooms[i].catalogs, rooms[i].stream)

    ways: dict[str, Callable[[int], Any]] = {
        "the same stage in Python": python,
        "core alone": alone,
        "core, bytes copied in and out": copied,
        "the same, and the room encoded in Python": lambda i: copied(i, rooms[i].rows()),
        "the same, and the answer unpacked to numbers": lambda i: answer_of(copied(i, rooms[i].rows())),
        "`wanted_pieces`: the same, and Python's objects made of it": objects,
    }
    return [(name, micros(rooms, do)) for name, do in ways.items()]


def main() -> int:
    """Prints the table."""
    parser = argparse.ArgumentParser(prog="python -m tests.bench.furnish_cost", description=__doc__)
    parser.add_argument("--homes", type=int, default=8)
    arguments = parser.parse_args()
    sets = {"default": cases(arguments.homes, None), "family": cases(arguments.homes, "family")}
    differ = 0
    for one in (one for rooms in sets.values() for one in rooms):
        asked = one.room, one.space, one.catalogs
        differ += bits(wanted_pieces(*asked, one.stream)) != bits(stage.wanted_pieces(*asked, one.stream))
    gc.disable()
    found = {name: measured(rooms) for name, rooms in sets.items()}
    print(f"| us a room | {' | '.join(f'{name}, {len(sets[name])} rooms' for name in found)} | quicker |\n|---|{'---|' * (len(found) + 1)}")
    for i, (way, _) in enumerate(found["default"]):
        times = [rows[i][1] for rows in found.values()]
        print(
            f"| {way} | {' | '.join(f'{spent:.0f}' for spent in times)} | {sum(rows[0][1] for rows in found.values()) / sum(times):.1f} |"
        )
    print(f"\nRooms in which the two differ: {differ}.")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
