"""Processes that make calls for the service, one after another, and end with it.

The service's loop speaks to them itself: a thread for each call would be two more hand-overs between it and the caller who waits.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import os
import pickle
import signal
import socket
import sys
from collections.abc import Callable
from contextlib import suppress
from threading import Thread
from typing import Any, Final, NamedTuple, TypeVar
from weakref import finalize

from service.pool import end_with_parent

T = TypeVar("T")

SIZE_BYTES: Final = 8
"""Before each answer stands how long it is."""
_CAN_FORK: Final = "forkserver" in multiprocessing.get_all_start_methods()
_PROCESSES: Final[Any] = multiprocessing.get_context("forkserver" if _CAN_FORK else "spawn")
if _CAN_FORK:  # a process that has imported all is copied within milliseconds
    _PROCESSES.set_forkserver_preload([f"{__package__}.work"])


class Raised(NamedTuple):
    """What a call raised."""

    error: Exception


class WorkerProcess:
    """A process, so much nicer than the service, that makes one call after another, until nobody can ask it any more."""

    def __init__(self, nice: int) -> None:
        self._line, called = socket.socketpair()
        self._process = _PROCESSES.Process(target=_make_calls, args=(called, nice), daemon=True)
        self._process.start()
        called.close()
        self._line.setblocking(False)
        finalize(self, self._line.close)

    async def ask(self, work: Callable[..., T], given: tuple[object, ...]) -> T | Raised:
        """Has it run a function of a module; returns what that returns or raises. Who is cancelled meanwhile has to kill it.

        Raises:
            EOFError, OSError: the process has ended.
        """
        await asyncio.get_running_loop().sock_sendall(self._line, pickle.dumps((work, given)))
        size = int.from_bytes(await self._received(SIZE_BYTES), "big")
        found: T | Raised = pickle.loads(await self._received(size))
        return found

    async def _received(self, size: int) -> bytearray:
        received = bytearray(size)
        left = memoryview(received)
        while left:
            taken = await asyncio.get_running_loop().sock_recv_into(self._line, left)
            if taken == 0:
                raise EOFError
            left = left[taken:]
        return received

    def lives(self) -> bool:
        """Tells whether it has not ended."""
        return bool(self._process.is_alive())

    def kill(self) -> None:
        """Ends it, whatever it does, and waits until it has ended."""
        self._process.kill()
        self._process.join()
        self._line.close()


def _make_calls(called: socket.socket, nice: int) -> None:
    """Makes calls until the service has gone, however that ends; a call that runs then ends with it.

    Its parent does not: the server of forks lives on while one of its forks does. Ctrl-C is for the service, which ends its processes
    itself.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=end_with_parent, daemon=True).start()
    if sys.platform != "win32":
        os.nice(nice)
    with suppress(EOFError, OSError), called.makefile("rb") as asked:
        while True:
            work, given = pickle.load(asked)
            try:
                found = work(*given)
            except Exception as error:
                found = Raised(error)
            written = pickle.dumps(found)
            called.sendall(len(written).to_bytes(SIZE_BYTES, "big"))
            called.sendall(written)
