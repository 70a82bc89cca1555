"""Processes that make calls for the service, one after another, and end with it."""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any, Final, NamedTuple, TypeVar

T = TypeVar("T")

PR_SET_PDEATHSIG: Final = 1
"""Of Linux: a process chooses the signal it gets when its parent ends."""
_CAN_FORK: Final = "forkserver" in multiprocessing.get_all_start_methods()
_PROCESSES: Final[Any] = multiprocessing.get_context("forkserver" if _CAN_FORK else "spawn")
if _CAN_FORK:  # a process that has imported all is copied within milliseconds
    _PROCESSES.set_forkserver_preload(["service.work"])


class Raised(NamedTuple):
    """What a call raised."""

    error: Exception


class WorkerProcess:
    """A process that makes one call after another, until nobody can ask it any more.

    Args:
        nice: how much nicer than the service it is.
    """

    def __init__(self, nice: int) -> None:
        self._caller, called = _PROCESSES.Pipe()
        self._process = _PROCESSES.Process(target=_make_calls, args=(called, nice), daemon=True)
        self._process.start()
        called.close()

    def ask(self, work: Callable[..., T], given: tuple[object, ...]) -> T | Raised:
        """Has it run a function of a module; returns what that returns or raises.

        Raises:
            EOFError, OSError: the process has ended.
        """
        self._caller.send((work, given))
        found: T | Raised = self._caller.recv()
        return found

    def kill(self) -> None:
        """Ends it, whatever it does. Who waits for its answer is told that it has ended."""
        self._process.kill()
        self._process.join()


def _make_calls(called: Connection, nice: int) -> None:
    """Makes calls until the service has gone, however that ends: then the pipe ends, and so does the parent, the server of forks.

    Ctrl-C is for the service, which ends its processes itself. Elsewhere than on Linux a call that runs comes to its end first.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if sys.platform != "win32":
        os.nice(nice)
    with suppress(EOFError, OSError):
        while True:
            work, given = called.recv()
            try:
                found = work(*given)
            except Exception as error:
                found = Raised(error)
            called.send(found)
