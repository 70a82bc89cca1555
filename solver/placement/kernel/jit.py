"""Compiled by numba with explicit signatures and an on-disk cache, or run as it stands: the same source.

`COMPOSE_KERNEL=plain` in the environment runs the kernel uncompiled, some hundred times slower and to the same bytes:
floats are added in the order written, nothing is fused. Where the cache lies is cache.py's.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, Final, TypeVar

from solver.placement.kernel.cache import folder

PLAIN: Final = os.environ.get("COMPOSE_KERNEL") == "plain"
"""Whether the kernel runs uncompiled."""
Function = TypeVar("Function", bound=Callable[..., Any])
Signature = Callable[[Any], Any]
"""Takes the namespace of types (i8, f8, vectors, matrices, the layout's tuples) and returns a numba signature."""


def machine() -> tuple[str, ...]:
    """Returns what compiled code is for: the compiler and the processor."""
    import llvmlite.binding
    import numba

    return numba.__version__, llvmlite.binding.get_host_cpu_name(), llvmlite.binding.get_host_cpu_features().flatten()


def _namespace() -> SimpleNamespace:
    from numba import typeof, types

    from solver.placement.kernel.space import example_engine

    engine = example_engine()
    return SimpleNamespace(
        Engine=typeof(engine),
        RoomArrays=typeof(engine.room),
        Work=typeof(engine.work),
        Programs=typeof(engine.programs),
        Nodes=typeof(engine.nodes),
        WalkGrid=typeof(engine.grid),
        Tree=typeof(engine.tree),
        b1=types.boolean,
        i8=types.int64,
        f8=types.float64,
        none=types.void,
        ints=types.int64[::1],
        floats=types.float64[::1],
        int_rows=types.int64[:, ::1],
        float_rows=types.float64[:, ::1],
        int_cubes=types.int64[:, :, ::1],
        float_cubes=types.float64[:, :, ::1],
        tuple=types.Tuple,
    )


def compiled(signature: Signature, inlined: bool = False) -> Callable[[Function], Function]:
    """Compiles a function for one signature, or leaves it alone where the kernel runs plain.

    Args:
        signature: of the function.
        inlined: whether to compile it into its callers: a call hands over every array's eight numbers, which costs more than
            what a small function does.
    """
    if PLAIN:
        return lambda function: function

    import numba

    how = {"nogil": True, "error_model": "numpy", "_nrt": False, "forceinline": inlined}

    def compile_it(function: Function) -> Function:
        before = numba.config.CACHE_DIR
        numba.config.CACHE_DIR = str(FOLDER or "")
        try:
            jitted = numba.njit(signature(_TYPES), cache=FOLDER is not None, **how)(function)
        finally:
            numba.config.CACHE_DIR = before
        result: Function = jitted
        return result

    return compile_it


FOLDER: Final = None if PLAIN else folder()
"""Where compiled code is kept; None: nowhere."""
_TYPES: Final = None if PLAIN else _namespace()
