"""Openings cut by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from solver.floorplan.openings import ask, open_walls, rows_of
from tests.architecture.tree import ROOT
from tests.floorplan.opened import opened_question
from tests.sweeps import seeds

SOURCE = Path(__file__).with_name("native_openings.cpp")


def rows_asked(number: int) -> tuple[tuple[str, bytes], tuple[str, bytes]]:
    """Returns what the core is asked of a house: to cut all openings, then where else the last door could stand."""
    house, tree, entrance, _ = opened_question(number)
    cuts = open_walls(house, tree, entrance)[0]
    moved = next(cut for cut in reversed(cuts) if cut.kind in ("door", "passage"))
    joint = [one for one in tree if (one[0].a, one[0].b) == tuple(sorted(moved.sides))]
    others = [*(cut for cut in cuts if cut is not moved), moved]
    return ("open_walls", rows_of(house, tree, entrance)), ("door_places", rows_of(house, joint, entrance, others))


def test_checked_and_as_built_agree_to_the_last_bit(tmp_path: Path) -> None:
    program = tmp_path / "native"
    subprocess.run([sys.executable, "scripts/core.py", "check", SOURCE, program], cwd=ROOT, check=True)
    asked = [one for number in seeds(range(2400), 40) for one in rows_asked(number)]
    (tmp_path / "houses").write_bytes(b"".join(len(rows).to_bytes(8, "little") + rows for _, rows in asked))
    run = subprocess.run([program, tmp_path / "houses"], capture_output=True, check=False)
    assert run.returncode == 0, "a negative status is the signal of a trap: run it in a debugger"
    assert run.stdout == b"".join(ask(name, rows) for name, rows in asked)
