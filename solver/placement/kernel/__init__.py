"""The compiled core of placement: `compiled_kernel()` returns its functions; nothing is compiled or loaded before that is called.

Comes in: arrays (layout.py). Goes out: arrays. May import: itself, numpy; jit.py the compiler. Not here: Python's objects.
"""

import functools
from collections.abc import Callable
from typing import NamedTuple

from solver.placement.kernel.layout import Engine, Floats, Ints, RoomArrays, WalkGrid, Work


class Kernel(NamedTuple):
    """All that is called from outside; each function's module says what it takes and returns."""

    assemble: Callable[[RoomArrays, Work, Ints], bool]
    arrange_room: Callable[[Engine, Ints, Floats, Ints, Ints, Ints, bool], None]
    best_first: Callable[[Engine, Ints, Floats, Ints, Ints, bool], bool]
    evaluate: Callable[[Engine, Ints, int, float, bool], bool]
    holds: Callable[[Work, Ints], bool]
    open_decisions: Callable[[RoomArrays, Ints, int, Ints, Floats], int]
    prove: Callable[[RoomArrays, Work, WalkGrid, Ints, Ints, Ints, Ints, Ints], int]
    pull_back: Callable[[Engine], bool]
    search: Callable[[Engine, int, float, bool], None]
    total_preference: Callable[[RoomArrays, Ints], float]
    walkable: Callable[[RoomArrays, Work, WalkGrid, Ints], bool]


@functools.cache
def compiled_kernel() -> Kernel:
    """Compiles the kernel where that was not done yet, else loads it, and returns its functions."""
    from solver.placement.kernel import jit

    if jit.PLAIN:
        return _functions()
    from solver.placement.kernel.cache import one_compiles

    with one_compiles(jit.FOLDER, jit.machine()):
        return _functions()


def _functions() -> Kernel:
    from solver.placement.kernel.assembly import assemble
    from solver.placement.kernel.fill import arrange_room
    from solver.placement.kernel.grid import walkable
    from solver.placement.kernel.grow import best_first, evaluate
    from solver.placement.kernel.options import open_decisions, total_preference
    from solver.placement.kernel.prove import prove
    from solver.placement.kernel.pull import holds, pull_back
    from solver.placement.kernel.search import search

    return Kernel(assemble, arrange_room, best_first, evaluate, holds, open_decisions, prove, pull_back, search, total_preference, walkable)
