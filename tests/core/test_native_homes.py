"""Homes found by the core as it is built, and by a native build that checks every index and traps at undefined behaviour."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from solver.floorplan.programme.home_search import GIVEN, ask, home_rows, rows_within
from tests.architecture.tree import ROOT
from tests.floorplan.searches import HomeQuestion, home_question
from tests.sweeps import seeds

SOURCE = Path(__file__).with_name("native_homes.cpp")


def rows_of(question: HomeQuestion) -> bytes:
    """What the core is asked."""
    if question.outline == GIVEN:
        return rows_within(question.planned, question.tilings, question.seed.seed, question.walls)
    return home_rows(question.planned, lambda _: question.frame, question.seed, question.walls, question.outline)


def test_checked_and_as_built_agree_to_the_last_bit(tmp_path: Path) -> None:
    program = tmp_path / "native"
    subprocess.run([sys.executable, "scripts/core.py", "check", SOURCE, program], cwd=ROOT, check=True)
    asked = [rows_of(home_question(number)) for number in seeds(range(1200), 4)]
    (tmp_path / "homes").write_bytes(b"".join(len(rows).to_bytes(8, "little") + rows for rows in asked))
    run = subprocess.run([program, tmp_path / "homes"], capture_output=True, check=False)
    assert run.returncode == 0, "a negative status is the signal of a trap: run it in a debugger"
    assert run.stdout == b"".join(ask(rows) for rows in asked)
