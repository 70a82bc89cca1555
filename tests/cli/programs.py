"""Runs the command line as a person does: in a process of its own."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
PROGRAM = (sys.executable, "-m", "compose_homes")
SMALL = ("--seed", "42", "--width", "7", "--depth", "5")
"""A house that is made quickly."""


GUARD_S = 600
"""A guard against a process that never ends."""


def compose(*arguments: str, given: bytes = b"", cwd: Path = ROOT) -> subprocess.CompletedProcess[bytes]:
    """Runs a command with `given` at its standard input."""
    return subprocess.run([*PROGRAM, *arguments], input=given, capture_output=True, check=False, timeout=GUARD_S, cwd=cwd)


@contextmanager
def started(*command: str, cwd: Path = ROOT, **more: Any) -> Iterator[subprocess.Popen[str]]:
    """Starts a program with processes of its own: whatever ends the block before its end, none of them goes on, or is waited for."""
    with subprocess.Popen(command, cwd=cwd, text=True, start_new_session=True, **more) as run:
        try:
            yield run
        except BaseException:
            with suppress(ProcessLookupError):
                os.killpg(run.pid, signal.SIGKILL)
            raise


def until(condition: Callable[[], bool]) -> None:
    """Waits for what is sure to come, unless a test fails."""
    deadline = time.monotonic() + GUARD_S
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.01)


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
