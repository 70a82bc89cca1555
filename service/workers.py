"""Calls of the solver take the processor and may take long: they run in a few processes of their own, with a deadline, in two lanes.

So the service goes on answering, every core is used, what takes too long or is waited for no more can be ended, which a thread cannot be,
and what is quickly done never waits behind what is not: each lane keeps its own processes, and those of the heavy one give way to others.

The service's loop speaks to its processes itself: a thread for each call would be two more hand-overs between it and the caller who waits.
"""

import asyncio
import multiprocessing
import os
import pickle
import signal
import socket
import sys
from collections.abc import Awaitable, Callable
from contextlib import suppress
from threading import Thread
from typing import Any, Final, NamedTuple, TypeVar, TypeVarTuple, Unpack
from weakref import finalize

from anyio import BrokenWorkerProcess, CancelScope, CapacityLimiter, create_task_group, fail_after
from starlette.requests import ClientDisconnect
from starlette.types import Receive

from service.pool import end_with_parent
from service.problems import Busy, ProcessLost, TooLong
from service.service_settings import Settings
from solver import pipeline

if sys.platform != "win32":
    import resource

T = TypeVar("T")

SIZE_BYTES: Final = 8
"""Before each answer stands how long it is."""
GROWN: Final = 1 << 29
"""Memory that a process had at its most when another takes its place, bytes: libraries that read files of others do not give all back."""
_CAN_FORK: Final = "forkserver" in multiprocessing.get_all_start_methods()
_PROCESSES: Final[Any] = multiprocessing.get_context("forkserver" if _CAN_FORK else "spawn")
_FLOWS: Final = ("drag", "explain", "export", "fix", "generate", "import_plan", "own_plan", "place", "restyle")
PRELOADED: Final = (f"{__package__}.work", __name__, *(f"{pipeline.__name__}.{flow}" for flow in _FLOWS))
"""What calls load when they are made: a process that has loaded all of it is copied within milliseconds."""
if _CAN_FORK:
    _PROCESSES.set_forkserver_preload(list(PRELOADED))


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
        self.has_grown = False
        """Whether it ends after the call that it has made."""

    async def ask(self, work: Callable[..., T], given: tuple[object, ...]) -> T | Raised:
        """Has it run a function of a module; returns what that returns or raises. Who is cancelled meanwhile has to kill it.

        Raises:
            EOFError, OSError: the process has ended.
        """
        await asyncio.get_running_loop().sock_sendall(self._line, pickle.dumps((work, given)))
        size = int.from_bytes(await self._received(SIZE_BYTES), "big")
        found: T | Raised
        found, self.has_grown = pickle.loads(await self._received(size))
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
    """Makes calls until the service has gone, however that ends, or this process has grown; a call that runs then ends with it.

    Its parent does not: the server of forks lives on while one of its forks does. Ctrl-C is for the service, which ends its processes
    itself.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=end_with_parent, daemon=True).start()
    if sys.platform != "win32":
        os.nice(nice)
    has_grown = False
    with suppress(EOFError, OSError), called.makefile("rb") as asked:
        while not has_grown:
            work, given = pickle.load(asked)
            try:
                found = work(*given)
            except Exception as error:
                found = Raised(error)
            has_grown = _most_memory() >= GROWN
            written = pickle.dumps((found, has_grown))
            called.sendall(len(written).to_bytes(SIZE_BYTES, "big"))
            called.sendall(written)


def _most_memory() -> int:
    """Returns how much memory this process had at its most, bytes."""
    if sys.platform == "win32":
        return 0
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most << 10


Given = TypeVarTuple("Given")

TRIES: Final = 2
"""How many processes may die of a call, or before they can make it."""
GIVES_WAY: Final = 10
"""How much nicer than the service the processes of the heavy lane are."""


class Lane(NamedTuple):
    """A bounded number of processes, so nice, with a bounded line before them.

    `slots` are for the calls that run, `waiting` is how many more may wait; `idle` are the processes that do nothing now, `coming` those
    that are being started.
    """

    slots: CapacityLimiter
    waiting: int
    nice: int
    idle: list[WorkerProcess]
    coming: set[asyncio.Task[bool]]

    def check(self) -> None:
        """Lets a call in.

        Raises:
            Busy: as many calls run, and as many wait, as may.
        """
        line = self.slots.statistics()
        if line.borrowed_tokens >= line.total_tokens and line.tasks_waiting >= self.waiting:
            raise Busy("service", f"{line.total_tokens:g} calls run and {self.waiting} wait", "another try in a moment")


class Workers:
    """The processes of a service, as many as its settings say."""

    def __init__(self, settings: Settings, first: Callable[[Unpack[Given]], object] | None = None, *given: *Given) -> None:
        """Begins nothing; `first` is what every process does before its first call, with what is `given`."""
        self._first = None if first is None else (first, given)
        self._seconds = settings.request_seconds
        self.heavy = Lane(CapacityLimiter(settings.running()), settings.waiting, GIVES_WAY, [], set())
        self.light = Lane(CapacityLimiter(settings.light_processes), settings.waiting, 0, [], set())
        self.restarts = 0
        """Processes that ended and were replaced."""

    def check(self) -> None:
        """Tells whether there are processes; a lane without one begins to start another.

        Raises:
            Busy: the heavy lane lets no call in, or a lane has no process.
        """
        self.heavy.check()
        for lane in (self.heavy, self.light):
            if not self._is_ready(lane) and not lane.slots.borrowed_tokens:
                if not lane.coming:
                    self._begin(lane)
                raise Busy("service", "is starting", "another try in a moment")

    async def run(self, work: Callable[[Unpack[Given]], T], *given: *Given, is_light: bool = False) -> T:
        """Runs a function of a module in a process and returns what it returns; once more in another where the process died.

        Where the task that waits is cancelled, the process is ended and another one started, or the call leaves the line. What is light,
        quickly done, has a lane of its own.

        Raises:
            Busy: as many calls run, and as many wait, as may.
            TooLong: it ran for request_seconds without an end, and was ended.
            ProcessLost: TRIES processes died of it, or while they were started for it.
        """
        lane = self.light if is_light else self.heavy
        lane.check()
        async with lane.slots:
            try:
                with fail_after(self._seconds):
                    for _ in range(TRIES):
                        with suppress(BrokenWorkerProcess):
                            return await self._in_process(lane, work, *given)
                        self.restarts += 1
                    raise ProcessLost("service", "lost the process of this call, and another one", "another try in a moment")
            except TimeoutError:
                raise TooLong("body", f"takes longer than {self._seconds:g} s", TooLong.SMALLER) from None

    async def _in_process(self, lane: Lane, work: Callable[[Unpack[Given]], T], *given: *Given) -> T:
        while not self._is_ready(lane):
            if not lane.coming:
                self._begin(lane)
            begun, _ = await asyncio.wait(lane.coming, return_when=asyncio.FIRST_COMPLETED)
            if not any(one.result() for one in begun):
                raise BrokenWorkerProcess
        process = lane.idle.pop()
        try:
            found = await process.ask(work, given)
        except BaseException as error:
            self._begin(lane)
            with CancelScope(shield=True):
                await asyncio.to_thread(process.kill)
            if isinstance(error, EOFError | OSError):
                raise BrokenWorkerProcess from error
            raise
        if process.has_grown:  # it ends by itself: a call that came meanwhile would take it for one that died of that
            self.restarts += 1
            self._begin(lane)
        else:
            lane.idle.append(process)
        if isinstance(found, Raised):
            raise found.error
        return found

    def _is_ready(self, lane: Lane) -> bool:
        """Tells whether a process of a lane is idle; those that died while they were are replaced."""
        while lane.idle and not lane.idle[-1].lives():
            lane.idle.pop().kill()
            self.restarts += 1
            self._begin(lane)
        return bool(lane.idle)

    def _begin(self, lane: Lane) -> None:
        """Begins to start a process for a lane."""
        task = asyncio.create_task(self._add(lane))
        lane.coming.add(task)
        task.add_done_callback(lane.coming.discard)

    async def _add(self, lane: Lane) -> bool:
        """Adds a process to a lane that has done what all do first; tells whether there is one, and it did not die of that."""
        process: WorkerProcess | None = None
        try:
            process = await asyncio.to_thread(WorkerProcess, lane.nice)  # anyio's threads would outlive a loop that is ended amid this
            if self._first is not None:
                await process.ask(*self._first)
        except BaseException as error:
            if process is not None:
                process.kill()
            if not isinstance(error, EOFError | OSError):
                raise
            return False
        lane.idle.append(process)
        return True

    async def start(self) -> None:
        """Starts all processes, however long it takes: a first start may compile."""
        async with create_task_group() as group:
            for lane in (self.heavy, self.light):
                for _ in range(int(lane.slots.total_tokens)):
                    group.start_soon(self._add, lane)

    def stop(self) -> None:
        """Ends the processes that do nothing; the others end with their calls."""
        for lane in (self.heavy, self.light):
            while lane.idle:
                lane.idle.pop().kill()


async def unless_left(receive: Receive, work: Awaitable[T]) -> T:
    """Waits for what a caller asked for, whose body has been read, and ends it when the caller leaves.

    Raises:
        ClientDisconnect: the caller left.
        Exception: what `work` raises.
    """
    done: list[T] = []
    failed: list[Exception] = []
    async with create_task_group() as group:

        async def watch() -> None:
            while (await receive())["type"] != "http.disconnect":
                pass
            group.cancel_scope.cancel()

        group.start_soon(watch)
        try:
            done.append(await work)
        except Exception as error:
            failed.append(error)
        group.cancel_scope.cancel()
    if failed:
        raise failed[0]
    if not done:
        raise ClientDisconnect
    return done[0]
