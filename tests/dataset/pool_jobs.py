"""Jobs of pools in tests: a module of its own, as each process of a pool imports it."""

from __future__ import annotations

import os
import signal
from pathlib import Path


def ends_once(folder: Path, by: signal.Signals, job: int) -> int:
    """A job at which its process is sent a signal the first time it is done."""
    mark = folder / str(job)
    if job in (3, 11) and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), by)
    return job * job


def ends_always(job: int) -> int:
    """A job that no process outlives."""
    os.kill(os.getpid(), signal.SIGKILL)
    return job


def nothing() -> None:
    """What a process does first."""


class _Interrupted:
    """What is told Ctrl-C as it goes, where Python says an error and goes on."""

    def __del__(self) -> None:
        os.kill(os.getpid(), signal.SIGINT)
        for _ in range(1000):  # the signal's handler runs between two steps of Python
            pass


def ends_as_a_thing_goes(job: int) -> int:
    """A job whose process is told Ctrl-C within a `__del__`."""
    thing = _Interrupted()
    del thing
    return job
