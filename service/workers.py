"""Calls of the solver take the processor and may take long: they run in a few processes of their own, with a deadline, in two lanes.

So the service goes on answering, every core is used, what takes too long or is waited for no more can be ended, which a thread cannot be,
and what is quickly done never waits behind what is not.
"""

from __future__ import annotations

import math
from collections.abc import Awaitable, Callable
from typing import NamedTuple, TypeVar, TypeVarTuple, Unpack

from anyio import BrokenWorkerProcess, CapacityLimiter, create_task_group, fail_after, to_process
from starlette.requests import ClientDisconnect
from starlette.types import Receive

from service.refusals import Busy, TooLong
from service.service_settings import Settings

T = TypeVar("T")
Given = TypeVarTuple("Given")


class Lane(NamedTuple):
    """A bounded number of processes with a bounded line before them."""

    slots: CapacityLimiter
    waiting: int

    def check(self) -> None:
        """Lets a call in.

        Raises:
            Busy: as many calls run, and as many wait, as may.
        """
        line = self.slots.statistics()
        if line.borrowed_tokens >= line.total_tokens and line.tasks_waiting >= self.waiting:
            raise Busy("service", f"{line.total_tokens:g} calls run and {self.waiting} wait", "another try in a moment")


class Workers:
    """The processes of a service.

    Args:
        settings: how many, and how long each may take.
    """

    def __init__(self, settings: Settings) -> None:
        self._seconds = settings.request_seconds
        self.heavy = Lane(CapacityLimiter(settings.running()), settings.waiting)
        self.light = Lane(CapacityLimiter(settings.light_processes), settings.waiting)
        self.restarts = 0
        """Processes that died and were replaced."""
        self._unbounded = CapacityLimiter(math.inf)

    async def run(self, work: Callable[[Unpack[Given]], T], *given: *Given, is_light: bool = False) -> T:
        """Runs a function of a module in a process and returns what it returns; once more in another where the process died.

        Where the task that waits is cancelled, the process is ended, or the call leaves the line.

        Args:
            work: the function.
            given: what it is given.
            is_light: whether it is quickly done, so that it has a lane of its own.

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
                        return await self._in_process(work, *given)
                    except BrokenWorkerProcess:
                        self.restarts += 1
                        return await self._in_process(work, *given)
            except TimeoutError:
                raise TooLong("body", f"takes longer than {self._seconds:g} s", TooLong.SMALLER) from None

    async def _in_process(self, work: Callable[[Unpack[Given]], T], *given: *Given) -> T:
        return await to_process.run_sync(work, *given, cancellable=True, limiter=self._unbounded)

    async def start(self, work: Callable[[Unpack[Given]], object], *given: *Given) -> None:
        """Starts all processes by running something in each, however long it takes: a first start may compile."""
        async with create_task_group() as group:
            for _ in range(int(self.heavy.slots.total_tokens + self.light.slots.total_tokens)):
                group.start_soon(self._in_process, work, *given)


async def unless_left(receive: Receive, work: Awaitable[T]) -> T:
    """Waits for what a caller asked for, and ends it when the caller leaves.

    Args:
        receive: of the caller's request, whose body has been read.
        work: what it asked for.

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
