"""Work that a room, and a whole call, may cost; counted, never timed, so that equal requests give equal bytes."""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from math import inf

ROOM_WORK = 400_000.0
"""Work one room may cost, in QPs of a small room."""


class CallWork:
    """The work of one call, in QPs of a small room, and how much it may be at most."""

    def __init__(self, most: float) -> None:
        self.most, self.done = most, 0.0

    @property
    def left(self) -> float:
        """How much is left; below nothing where the last that was done cost more than there was."""
        return self.most - self.done

    @property
    def spent(self) -> bool:
        """Tells whether nothing is left: searches ended here, and might have found more."""
        return self.done >= self.most


_call: ContextVar[CallWork | None] = ContextVar("work of the call", default=None)


@contextmanager
def work_of_call(most: float) -> Iterator[CallWork]:
    """Has all searches within a block share one limit, the work that they may do in all; infinite to count only."""
    work = CallWork(most)
    before = _call.set(work)
    try:
        yield work
    finally:
        _call.reset(before)


def charge(work: float) -> None:
    """Counts work of the call that is no search."""
    call = _call.get()
    if call is not None:
        call.done += work


def is_call_spent() -> bool:
    """Tells whether a call's work is spent, so that nothing more is to be tried."""
    call = _call.get()
    return call is not None and call.spent


class Budget:
    """Work that may still be done, in QPs of a small room.

    A problem of n variables an axis counts 1 + (n / 20)^2 a QP; beyond a hundred, n / 100 times as much. It ends with that of the
    call, if there is such a limit.

    Args:
        left: how much.
        is_known: whether what is asked for is known to be there: it is then found even where the call's work is spent.
        of: another one of which this is a part: what is done here is done there, too; by default the call alone.
    """

    def __init__(self, left: float = ROOM_WORK, *, is_known: bool = False, of: "Budget | None" = None) -> None:
        self._left, self._of = left, of
        self._call = _call.get() if of is None else None
        self._most = inf if is_known else 0.0

    @property
    def left(self) -> float:
        """How much is left."""
        if self._of is not None:
            return min(self._left, self._of.left)
        return self._left if self._call is None else min(self._left, max(self._call.left, self._most))

    @left.setter
    def left(self, work: float) -> None:
        done = self.left - work
        self._left -= done
        if self._of is not None:
            self._of.left -= done
        if self._call is not None:
            self._call.done += done

    @property
    def spent(self) -> bool:
        """Tells whether nothing is left."""
        return self.left <= 0
