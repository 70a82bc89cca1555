"""How far long work is, for the person who waits for it: a bar on a terminal, elsewhere a line now and then."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Final

from tqdm import tqdm

from service.standard_streams import say

EVERY_S: Final = 30.0
"""How much time lies between two lines at the least, s."""


@contextmanager
def progress(total: int, unit: str, begun: int = 0) -> Iterator[Callable[[int], object]]:
    """Gives what is to be called with each number that is done of `total`, `begun` of which were done before; one is called `unit`."""
    if sys.stderr is not None and sys.stderr.isatty():
        with tqdm(total=total, initial=begun, unit=unit) as bar:
            yield bar.update
        return
    done, told = begun, monotonic()

    def update(more: int) -> None:
        nonlocal done, told
        done += more
        if monotonic() - told >= EVERY_S:
            say(f"{done:,} of {total:,} {unit}s")
            told = monotonic()

    yield update
