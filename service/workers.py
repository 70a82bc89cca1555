"""Solver calls take the processor: they run in a few threads, so that the service goes on answering."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeVar

from anyio import CapacityLimiter, to_thread

from service.refusals import Busy

T = TypeVar("T")

RUNNING: Final = 4
"""Calls that run at once. Our choice: they share the interpreter, more would only make each slower."""
WAITING: Final = 32
"""Calls that wait for a thread; the next is turned away. Our choice."""


class Workers:
    """A bounded number of threads with a bounded line before them."""

    def __init__(self) -> None:
        self._limiter = CapacityLimiter(RUNNING)

    async def run(self, work: Callable[[], T]) -> T:
        """Runs work in a thread and returns what it returns.

        Raises:
            Busy: RUNNING calls run and WAITING calls wait already.
        """
        line = self._limiter.statistics()
        if line.borrowed_tokens >= RUNNING and line.tasks_waiting >= WAITING:
            raise Busy("service", f"{RUNNING} calls run and {WAITING} wait", "another try in a moment")
        return await to_thread.run_sync(work, limiter=self._limiter)
