"""Runs the command line as a person does: in a process of its own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).parents[2]
PROGRAM = (sys.executable, "-m", "service")
SMALL = ("--seed", "42", "--width", "7", "--depth", "5")
"""A house that is made quickly."""


GUARD_S = 600
"""A guard against a process that never ends."""


def compose(*arguments: str, given: bytes = b"", cwd: Path = ROOT) -> subprocess.CompletedProcess[bytes]:
    """Runs a command with `given` at its standard input."""
    return subprocess.run([*PROGRAM, *arguments], input=given, capture_output=True, check=False, timeout=GUARD_S, cwd=cwd)


def said(run: subprocess.CompletedProcess[bytes] | Sequence[str]) -> str:
    """What a run told its person, without a traceback."""
    assert isinstance(run, subprocess.CompletedProcess)
    words = run.stderr.decode()
    assert "Traceback" not in words
    return words


def is_gone(process: int) -> bool:
    """Tells whether a process has ended, also where nobody has asked for its status yet."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True
