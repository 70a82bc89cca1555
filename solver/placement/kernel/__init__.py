"""The compiled core of placement. To import any part of it compiles all of it, once, or loads it from the cache.

Comes in: arrays (layout.py). Goes out: arrays. May import: itself, numpy; jit.py the compiler. Not here: Python's objects.
"""

from solver.placement.kernel import cache, jit

if jit.PLAIN:
    from solver.placement.kernel import fill, prove, pull, widen
else:
    with cache.one_compiles(jit.FOLDER, jit.machine()):
        from solver.placement.kernel import fill, prove, pull, widen

__all__ = ["cache", "fill", "jit", "prove", "pull", "widen"]
