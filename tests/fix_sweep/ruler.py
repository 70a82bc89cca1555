"""How well `/fix` repairs one home with thrown pieces, in counts.

Comes in: a way to throw, a preset, a seed. Goes out: a `Tally`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from math import inf

from tqdm import tqdm

from catalogs import load_catalogs
from solver import fix
from solver.answers import Fixed
from solver.placement import work_of_call
from solver.scene import WALLS
from tests.fix_sweep.judge import faults, off_wall, shapes
from tests.fix_sweep.thrown import PRESETS, WAYS, Thrown, thrown

HEAD = "| thrown | homes | clean % | impossible | without a tried repair | conflicts | most | wall pieces far off | QPs a home | most |"
WANTED = {"1": 0.995, "3": 0.98, "30 %": 0.97, "30 %, one locked": 0.95}
"""Least share of homes that must be clean again, where pieces keep their rotation."""
FAR_M = 0.195
"""A wall piece this far from every wall is just inside what the rule allows, and nowhere a person would put it."""
Job = tuple[str, str, int, bool]


@dataclass
class Tally:
    """What some homes show."""

    homes: int = 0
    clean: int = 0
    impossible: int = 0
    """Conflicts that say that what was possible is not."""
    hopeless: int = 0
    """Conflicts without a repair that was tried."""
    conflicts: list[int] = field(default_factory=list)
    wall_pieces: int = 0
    far: int = 0
    qps: list[float] = field(default_factory=list)
    wrong: int = 0
    """Rooms that are called clean and are not by the judge."""
    lines: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        """Adds another tally to this one."""
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)

    def row(self, name: str) -> str:
        """Returns a row of the table."""
        share = f"{100 * self.clean / max(self.homes, 1):.1f}"
        qps = sorted(self.qps) or [0.0]
        counts = f"{sum(self.conflicts)} | {max(self.conflicts, default=0)} | {self.far} of {self.wall_pieces}"
        work = f"{sum(qps) / len(qps):,.0f} | {qps[-1]:,.0f}"
        return f"| {name} | {self.homes} | {share} | {self.impossible} | {self.hopeless} | {counts} | {work} |"


def thrown_about(  # noqa: PLR0913 - the command's options
    homes: int, workers: int, ways: Sequence[str] = WAYS, *, first: int = 5000, turn: bool = False, remove: bool = False
) -> bool:
    """Prints the table, a row for each way to throw; returns whether no verdict is false and the share of clean homes is as wanted."""
    presets, good = list(PRESETS), True
    print(HEAD, "|---" * HEAD.count("| ") + "|", sep="\n")
    with ProcessPoolExecutor(workers) as pool:
        for way in ways:
            jobs = [(way, presets[seed % len(presets)], seed, turn) for seed in range(first, first + homes)]
            own, run = Tally(), partial(measured, "remove" if remove else "report")
            for tally in tqdm(pool.map(run, jobs, chunksize=2), total=len(jobs), desc=way, disable=None):
                own.add(tally)
            print(own.row(way), flush=True)
            print(*own.lines, sep="\n", file=sys.stderr)
            good &= not own.impossible and not own.wrong and (turn or own.clean >= WANTED[way] * own.homes)
    return good


def measured(on_conflict: str, job: Job) -> Tally:
    """Repairs one home and counts."""
    case = thrown(*job)
    with work_of_call(inf) as work:
        fixed = fix(case.scene, locked=case.locked, on_conflict=on_conflict)
    found = Tally(1, qps=[work.done])
    name = f"{job[1]} {job[2]}, {job[0]}, {case.room}"
    errors = [issue.message for issue in fixed.issues if issue.severity == "error"]
    found.clean = int(not errors)
    found.conflicts = [len(fixed.conflicts)]
    for conflict in fixed.conflicts:
        found.impossible += not conflict.message.startswith("not found")
        found.hopeless += not conflict.repairs
        found.lines.append(f"{name}: {conflict.message} {[dict(repair) for repair in conflict.repairs]}")
    if not errors:
        judged = list(_judged(fixed, case))
        found.wrong = len(judged)
        found.lines += [f"{name}: JUDGED {fault}" for fault in judged]
        _at_walls(fixed, case, found)
    return found


def _judged(fixed: Fixed, case: Thrown) -> Iterator[str]:
    room = next(room for room in fixed.scene.rooms if room.id == case.room)
    if shapes(room):
        yield from faults(fixed.scene, room, load_catalogs().use_sides())


def _at_walls(fixed: Fixed, case: Thrown, found: Tally) -> None:
    """Counts the thrown pieces that stood at a wall and now stand off every wall."""
    room = next(room for room in fixed.scene.rooms if room.id == case.room)
    for piece in room.furniture:
        if piece.id in case.ids and piece.wall is not None and shapes(room):
            found.wall_pieces += 1
            if min(off_wall(room, piece, wall) for wall in WALLS) >= FAR_M:
                found.far += 1
