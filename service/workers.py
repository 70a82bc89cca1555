"""Calls of the solver take the processor and may take long: they run in a few processes of their own, with a deadline.

So the service goes on answering, every core is used, and what takes too long can be ended, which a thread cannot be.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import Final, TypeVar, TypeVarTuple, Unpack

from anyio import CapacityLimiter, create_task_group, fail_after, to_process

from service.refusals import Busy, TooMuch

T = TypeVar("T")
Given = TypeVarTuple("Given")

RUNNING: Final = max(2, os.cpu_count() or 1)
"""Calls that run at once: one a core, and two at least, so that a long one does not stop the short ones."""
WAITING: Final = 32
"""Calls that wait for a process; the next is turned away. Our choice."""
SECONDS: Final = 60.0
"""How long a call may run, s. Our choice: a house of 20 x 15 m takes about one."""


class Workers:
    """A bounded number of processes with a bounded line before them."""

    def __init__(self) -> None:
        self._slots = CapacityLimiter(RUNNING)
        self._unbounded = CapacityLimiter(math.inf)

    async def run(self, work: Callable[[Unpack[Given]], T], *given: *Given) -> T:
        """Runs a function of a module in a process and returns what it returns.

        Raises:
            Busy: RUNNING calls run and WAITING calls wait already.
            TooMuch: it ran SECONDS without an end, and was ended.
        """
        line = self._slots.statistics()
        if line.borrowed_tokens >= RUNNING and line.tasks_waiting >= WAITING:
            raise Busy("service", f"{RUNNING} calls run and {WAITING} wait", "another try in a moment")
        async with self._slots:
            try:
                with fail_after(SECONDS):
                    return await to_process.run_sync(work, *given, cancellable=True, limiter=self._unbounded)
            except TimeoutError:
                raise TooMuch("body", f"takes longer than {SECONDS:g} s", TooMuch.SMALLER) from None

    async def start(self, work: Callable[[Unpack[Given]], object], *given: *Given) -> None:
        """Starts all processes by running something in each, however long it takes: a first start may compile."""

        async def run() -> None:
            await to_process.run_sync(work, *given, cancellable=True, limiter=self._unbounded)

        async with create_task_group() as group:
            for _ in range(RUNNING):
                group.start_soon(run)
