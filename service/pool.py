"""Work spread over processes of this machine: the number of processes changes neither its order nor what it makes.

Few jobs are under way at a time, so that memory does not grow with their number. What a killed process was at is done again.
"""

import multiprocessing
import os
import signal
import sys
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, contextmanager
from itertools import islice
from multiprocessing.connection import wait
from threading import Thread, current_thread, main_thread
from typing import Any, ClassVar, Final, TypeVar

from solver.errors import FieldError
from solver.interrupts import interrupts_waiting

Asked = TypeVar("Asked")
Made = TypeVar("Made")
Pending = tuple[Sequence[Any], "Future[list[Any]] | None"]

AHEAD: Final = 2
"""Batches under way for each process: one that it works at and one that waits, so that it never does."""
_ENDING: Final = (signal.SIGINT, signal.SIGTERM)
MOST_LOST: Final = 3
"""How often in a row processes may end before anything is done: a job that takes all memory would end them for ever."""


def spread(make: Callable[[Asked], Made], jobs: Iterable[Asked], workers: int, start: Callable[[], None], batch: int = 1) -> Iterator[Made]:
    """Yields what a function, which can be sent to a process, makes of each job, in their order.

    Jobs are taken as they are needed, `batch` at a time, so that there may be any number of them. A process does `start` first; with one
    worker all is done in this one.

    Raises:
        FieldError: processes end again and again before anything is done, as for want of memory.
        KeyboardInterrupt: Ctrl-C or SIGTERM; it ends the processes too.
    """
    if workers <= 1:
        start()
        with ending_as_interrupted():
            yield from map(make, jobs)
        return
    left = iter(jobs)
    batches = iter(lambda: list(islice(left, batch)), [])
    pending: deque[Pending] = deque()
    with _interrupts_noted() as noted, ExitStack() as pools:
        pool, lost = _opened(pools, noted, workers, make, start), 0
        while True:
            try:
                first = _fill(pool, pending, batches, AHEAD * workers)
                if first is None:
                    return
                made = first.result()
            except BrokenProcessPool:
                if noted:
                    raise KeyboardInterrupt from None
                lost += 1
                if lost > MOST_LOST:
                    problem = "the processes ended again and again before anything was done, as for want of memory"
                    raise FieldError("--workers", problem, "fewer processes; what is done is kept") from None
                pools.close()
                pool = _opened(pools, noted, workers, make, start)
                pending = deque((part, future if _is_done(future) else None) for part, future in pending)
                continue
            lost = 0
            pending.popleft()
            yield from made
            if noted:
                raise KeyboardInterrupt


def _opened(
    pools: ExitStack, noted: Sequence[int], workers: int, make: Callable[[Any], Any], start: Callable[[], None]
) -> ProcessPoolExecutor:
    # Processes start empty: one that is a copy of this one would share whatever its threads hold.
    pool = ProcessPoolExecutor(workers, multiprocessing.get_context("spawn"), _begin, (make, start))
    pools.callback(_close, pool, noted)
    return pool


def _close(pool: ProcessPoolExecutor, noted: Sequence[int]) -> None:
    """Ends a pool; a process that was just being started when others were told to end, it would wait for."""
    if noted or pool._broken:
        for process in list(pool._processes.values()):
            process.terminate()
    pool.shutdown(cancel_futures=True)


def _fill(pool: ProcessPoolExecutor, pending: deque[Pending], batches: Iterator[Sequence[Any]], most: int) -> Future[list[Any]] | None:
    """Hands over batches until so many are under way, those that were lost first; returns the first one's outcome to be."""
    pending.extend((part, None) for part in islice(batches, most - len(pending)))
    with interrupts_waiting():  # a process that starts inherits it
        for at, (part, future) in enumerate(pending):
            if future is None:
                pending[at] = (part, pool.submit(_each, part))
    return pending[0][1] if pending else None


def _is_done(future: Future[list[Any]] | None) -> bool:
    return future is not None and future.done() and not isinstance(future.exception(), BrokenProcessPool)


@contextmanager
def _interrupts_noted() -> Iterator[list[int]]:
    """Has the first Ctrl-C be noted and no more: raised amid the pool's own work it may leave a lock held, or be lost in a callback.

    So it is with SIGTERM, which this process alone is told: it tells those of the pool.
    """
    noted: list[int] = []
    here = current_thread() is main_thread()
    before = {number: signal.getsignal(number) for number in _ENDING if here and signal.getsignal(number) is not signal.SIG_IGN}

    def give_back() -> None:
        for number, action in before.items():
            signal.signal(number, action)

    def note(number: int, _: object) -> None:
        noted.append(number)
        give_back()
        if number == signal.SIGTERM:
            for process in multiprocessing.active_children():
                process.terminate()

    for number in before:
        signal.signal(number, note)
    try:
        yield noted
    finally:
        give_back()


@contextmanager
def ending_as_interrupted() -> Iterator[None]:
    """Has SIGTERM be what Ctrl-C is, where nobody else hears it: what is half-written is taken away."""
    is_unheard = current_thread() is main_thread() and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    if is_unheard:
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        if is_unheard:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)


class _Work:
    """What a process of the pool does, and whether it is at it."""

    make: ClassVar[Callable[[Any], Any]]
    under_way = False


def _hear(*_: object) -> None:
    """Ends a process of the pool at Ctrl-C, which a terminal tells to all, or SIGTERM; work under way leaves nothing half-written."""
    if _Work.under_way:
        raise KeyboardInterrupt
    os._exit(1)


def _end_if_interrupted(swallowed: "sys.UnraisableHookArgs") -> None:
    """Ends a process of the pool whose Ctrl-C was raised where Python goes on after any error, as in a `__del__`."""
    if swallowed.exc_type is KeyboardInterrupt:
        os._exit(1)
    sys.__unraisablehook__(swallowed)


def _begin(make: Callable[[Any], Any], start: Callable[[], None]) -> None:
    _Work.make = staticmethod(make)
    sys.unraisablehook = _end_if_interrupted
    Thread(target=end_with_parent, daemon=True).start()
    start()
    for number in _ENDING:
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _hear)
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def end_with_parent() -> None:
    """Ends this process when the one that started it has ended, however it did."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


def _each(part: Sequence[Any]) -> list[Any]:
    try:
        return _made(part)
    except KeyboardInterrupt:
        os._exit(1)


def _made(part: Sequence[Any]) -> list[Any]:
    _Work.under_way = True
    try:
        return [_Work.make(job) for job in part]
    finally:
        _Work.under_way = False  # an interrupt at this very line is an error of the job to the pool, which would wait for ever
