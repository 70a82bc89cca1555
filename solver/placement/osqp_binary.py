"""OSQP's compiled solver, called without its Python interface: that one imports scipy and jinja2, most of a command's start.

The extension is that of the pinned version of `osqp`; what its interface does before it calls it is done here.
"""

import signal
import sys
from collections import deque
from collections.abc import Callable, Mapping
from functools import cache, partial
from importlib.machinery import PathFinder
from importlib.util import find_spec, module_from_spec
from operator import call, itemgetter, truth
from types import ModuleType, SimpleNamespace
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from solver.interrupts import interrupts_waiting
from solver.placement.layout import Floats

Indices = NDArray[np.int32]

_PACKAGE: Final = "osqp"
_EXTENSION: Final = "osqp.ext_builtin"
_SOLVED: Final = 1


class SparseColumns(NamedTuple):
    """A sparse matrix by columns, its parts under the names that scipy gives them.

    `indices` are the rows of `data`, ascending in a column; `indptr` is where each column begins and the last ends.
    """

    shape: tuple[int, int]
    data: Floats
    indices: Indices
    indptr: Indices


class Programme(NamedTuple):
    """The least of x P x / 2 + q x where low <= A x <= high; of P the upper triangle."""

    P: SparseColumns
    q: Floats
    A: SparseColumns
    low: Floats
    high: Floats


class OsqpAnswer(NamedTuple):
    """OSQP's answer: whether it reports success, by column, by row, and how many iterations it took."""

    solved: bool
    x: Floats
    y: Floats
    iterations: int


def solve(programme: Programme, begun_at: tuple[Floats, Floats] | None, settings: Mapping[str, float]) -> OsqpAnswer:
    """Solves a programme, from where x and y begin (None: at nought), with settings by name; the others are OSQP's defaults.

    Raises:
        AttributeError: there is no setting of that name.
        ValueError: OSQP refuses the programme.
    """
    P, q, A, low, high = programme
    osqp = _extension()
    chosen = osqp.OSQPSettings()
    osqp.osqp_set_default_settings(chosen)
    for name, value in settings.items():
        setattr(chosen, name, value)
    most = osqp.OSQP_INFTY
    matrices = _taken(osqp, P, A)
    solver = osqp.OSQPSolver(matrices[0], q, matrices[1], np.maximum(low, -most), np.minimum(high, most), *A.shape, chosen)
    if begun_at is not None:
        solver.warm_start(*begun_at)
    with interrupts_waiting():  # OSQP hears Ctrl-C itself while it solves, and tells nobody
        solver.solve()
    if solver.info.status_val == osqp.osqp_status_type.OSQP_SIGINT.value:  # that came by another thread
        signal.raise_signal(signal.SIGINT)
        return solve(programme, begun_at, settings)
    return OsqpAnswer(solver.info.status_val == _SOLVED, solver.solution.x, solver.solution.y, solver.info.iter)


@cache
def _extension() -> Any:
    """Loads OSQP's extension, if it is installed, under its own name, so that whoever imports `osqp` later finds it loaded."""
    if _EXTENSION in sys.modules:
        return sys.modules[_EXTENSION]
    package = find_spec(_PACKAGE)
    found = PathFinder.find_spec(_EXTENSION, package.submodule_search_locations) if package else None
    if found is None or found.loader is None:
        raise ModuleNotFoundError(f"{_EXTENSION} is not installed", name=_PACKAGE)
    module = module_from_spec(found)
    found.loader.exec_module(module)
    return sys.modules.setdefault(_EXTENSION, module)


def _taken(osqp: Any, *matrices: SparseColumns) -> list[Any]:
    """Returns matrices as OSQP takes them.

    OSQP asks `scipy.sparse` whether they are of scipy's class, and then reads their arrays. A module that says yes stands in for scipy
    for that moment. The moment runs no bytecode, so that no other thread sees it, but for the first one of a process: there the extension
    looks for numpy.
    """
    instead, loaded, made = _instead(), dict[str, ModuleType](), list[Any]()
    sent = [SimpleNamespace(shape=one.shape, data=one.data, indices=one.indices, indptr=one.indptr, nnz=one.data.size) for one in matrices]
    take = partial(made.extend, map(osqp.CSC, sent))
    end: list[Callable[[], object]] = [partial(sys.modules.pop, name, None) for name in instead]
    end.append(partial(sys.modules.update, loaded))
    try:
        there = filter(itemgetter(1), zip(instead, map(sys.modules.get, instead), strict=True))
        _at_once(partial(loaded.update, there), partial(sys.modules.update, instead), take, *end)
    except BaseException:
        _at_once(*end)
        raise
    return made


@cache
def _instead() -> Mapping[str, ModuleType]:
    """Returns the modules that stand in for scipy, which says of all that it is of its class."""
    asked = ModuleType("scipy.sparse")
    asked.isspmatrix_csc = truth  # type: ignore[attr-defined]
    return {"scipy": ModuleType("scipy"), "scipy.sparse": asked}


def _at_once(*steps: Callable[[], object]) -> None:
    """Takes steps of compiled code without a chance for another thread between them."""
    deque(map(call, steps), maxlen=0)
