"""Calls of the solver take the processor and may take long: they run in a few processes of their own, with a deadline, in two lanes.

So the service goes on answering, every core is used, what takes too long or is waited for no more can be ended, which a thread cannot be,
and what is quickly done never waits behind what is not: each lane keeps its own processes, and those of the heavy one give way to others.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Final, NamedTuple, TypeVar, TypeVarTuple, Unpack

from anyio import BrokenWorkerProcess, CancelScope, CapacityLimiter, create_task_group, fail_after
from starlette.requests import ClientDisconnect
from starlette.types import Receive

from service.problems import Busy, TooLong
from service.service_settings import Settings
from service.worker_processes import Raised, WorkerProcess

T = TypeVar("T")
Given = TypeVarTuple("Given")

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
    coming: set[asyncio.Task[None]]

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

    def __init__(self, settings: Settings) -> None:
        self._seconds = settings.request_seconds
        self.heavy = Lane(CapacityLimiter(settings.running()), settings.waiting, GIVES_WAY, [], set())
        self.light = Lane(CapacityLimiter(settings.light_processes), settings.waiting, 0, [], set())
        self.restarts = 0
        """Processes that died and were replaced."""
        self._first: tuple[Callable[..., object], tuple[object, ...]] | None = None

    async def run(self, work: Callable[[Unpack[Given]], T], *given: *Given, is_light: bool = False) -> T:
        """Runs a function of a module in a process and returns what it returns; once more in another where the process died.

        Where the task that waits is cancelled, the process is ended and another one started, or the call leaves the line. What is light,
        quickly done, has a lane of its own.

        Raises:
            Busy: as many calls run, and as many wait, as may.
            TooLong: it ran for request_seconds without an end, and was ended.
            BrokenWorkerProcess: two processes died of it.
        """
        lane = self.light if is_light else self.heavy
        lane.check()
        async with lane.slots:
            try:
                with fail_after(self._seconds):
                    try:
                        return await self._in_process(lane, work, *given)
                    except BrokenWorkerProcess:
                        self.restarts += 1
                        return await self._in_process(lane, work, *given)
            except TimeoutError:
                raise TooLong("body", f"takes longer than {self._seconds:g} s", TooLong.SMALLER) from None

    async def _in_process(self, lane: Lane, work: Callable[[Unpack[Given]], T], *given: *Given) -> T:
        while not self._is_ready(lane):
            if not lane.coming:
                self._begin(lane)
            await asyncio.wait(lane.coming, return_when=asyncio.FIRST_COMPLETED)
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

    async def _add(self, lane: Lane) -> None:
        """Adds a process to a lane that has done what all do first; none where it dies of that."""
        process = await asyncio.to_thread(WorkerProcess, lane.nice)  # anyio's threads would outlive a loop that is ended amid this
        try:
            if self._first is not None:
                await process.ask(*self._first)
        except BaseException as error:
            process.kill()
            if not isinstance(error, EOFError | OSError):
                raise
        else:
            lane.idle.append(process)

    async def start(self, work: Callable[[Unpack[Given]], object], *given: *Given) -> None:
        """Starts all processes, however long it takes: a first start may compile. They do this work first, as those that replace one do."""
        self._first = work, given
        async with create_task_group() as group:
            for lane in (self.heavy, self.light):
                for _ in range(int(lane.slots.total_tokens)):
                    group.start_soon(self._add, lane)


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
