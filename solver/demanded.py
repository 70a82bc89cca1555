"""Work that must be done whole or not at all, such as judging a scene: counted before it is done, and refused where it is too much.

Searches, which can end early, count theirs in placement.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from solver.errors import TooMuch

_left: ContextVar[list[float] | None] = ContextVar("work that may still be demanded", default=None)


@contextmanager
def demanding_at_most(most: float) -> Iterator[None]:
    """Bounds what the block may demand, in QPs of a small room, a microsecond or two each. Without such a block nothing is bounded."""
    token = _left.set([most])
    try:
        yield
    finally:
        _left.reset(token)


def still_allowed() -> float:
    """Returns how much the call may still demand; infinite where nothing is bounded."""
    left = _left.get()
    return math.inf if left is None else max(left[0], 0.0)


def demand(work: float) -> None:
    """Counts work that is about to be done.

    Raises:
        TooMuch: the call may not have so much.
    """
    left = _left.get()
    if left is None:
        return
    left[0] -= work
    if left[0] < 0:
        raise TooMuch("scene", "takes more work than a call may have", TooMuch.SMALLER)
