"""OSQP's extension, called as OSQP's own interface calls it: the same answers to the bit, and nothing that others see."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable

import numpy as np
import osqp
import pytest
from scipy import sparse

from solver.placement import reference
from solver.placement.osqp_binary import OsqpAnswer, Programme, SparseColumns, solve
from solver.placement.qp import SETTINGS
from tests.cli.programs import GUARD_S

THREADS = """
import sys, threading
import numpy as np
from solver.placement.osqp_binary import SparseColumns, Programme, solve
assert not any(name in sys.modules for name in ("scipy", "scipy.sparse", "osqp"))
one = SparseColumns((1, 1), np.ones(1), np.zeros(1, np.int32), np.array([0, 1], np.int32))
def answer():
    solve(Programme(one, np.array([-1.0]), one, np.zeros(1), np.ones(1)), None, {"verbose": False})
answer()
seen, done = [], threading.Event()
def look():
    while not done.is_set():
        seen.append(sys.modules.get("scipy.sparse"))
sys.setswitchinterval(1e-6)
watch = threading.Thread(target=look)
watch.start()
solved = 0
while solved < 2000 or len(seen) <= 1000:
    answer()
    solved += 1
done.set()
watch.join()
assert set(seen) == {None}
import osqp, scipy.sparse
assert scipy.sparse.csc_matrix(np.eye(2)).nnz == 2
solver = osqp.OSQP(algebra="builtin")
eye = scipy.sparse.csc_matrix(np.eye(1))
solver.setup(eye, np.array([-1.0]), eye, np.zeros(1), np.ones(1), verbose=False)
solver.solve(raise_error=True)
"""


ENDLESS = """
import signal, sys
import numpy as np
from solver.placement.osqp_binary import SparseColumns, Programme, solve
signal.signal(signal.SIGINT, signal.default_int_handler)
many = 300
one = SparseColumns((many, many), np.ones(many), np.arange(many, dtype=np.int32), np.arange(many + 1, dtype=np.int32))
programme = Programme(one, np.linspace(-1, 1, many), one, np.full(many, 0.5), np.full(many, 2.0))
exact = {"verbose": False, "max_iter": 20000, "eps_abs": 1e-30, "eps_rel": 1e-30}
try:
    print("solving", flush=True)
    while True:
        solve(programme, None, exact)
except KeyboardInterrupt:
    print("ended")
"""


def columns(dense: np.ndarray) -> SparseColumns:
    """A matrix by columns."""
    rows, of_columns = np.nonzero(dense.T)[::-1]
    begins = np.searchsorted(of_columns, np.arange(dense.shape[1] + 1)).astype(np.int32)
    return SparseColumns((dense.shape[0], dense.shape[1]), dense[rows, of_columns], rows.astype(np.int32), begins)


def programme_of(P: np.ndarray, q: list[float], A: np.ndarray, low: list[float], high: list[float]) -> Programme:
    """A programme of dense matrices."""
    return Programme(columns(np.triu(P)), np.array(q), columns(A), np.array(low), np.array(high))


def by_interface(programme: Programme, start: tuple[np.ndarray, np.ndarray] | None) -> OsqpAnswer:
    """The same asked of OSQP's own interface."""
    P, A = (sparse.csc_matrix((one.data, one.indices, one.indptr), one.shape) for one in (programme.P, programme.A))
    solver = osqp.OSQP(algebra="builtin")
    solver.setup(P, programme.q, A, programme.low, programme.high, **SETTINGS)
    if start is not None:
        solver.warm_start(*start)
    result = solver.solve(raise_error=False)
    return OsqpAnswer(result.info.status_val == 1, result.x, result.y, result.info.iter)


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("is_warm", [False, True])
def test_answers_are_those_of_the_interface_to_the_bit(seed: int, is_warm: bool) -> None:
    random = np.random.default_rng(seed)
    count, rows = random.integers(1, 12, 2)
    half, A = random.normal(size=(count, count)), np.where(random.random((rows, count)) < 0.5, random.normal(size=(rows, count)), 0.0)
    lowest = random.normal(size=rows) - 1.0
    low = np.where(random.random(rows) < 0.3, -np.inf, lowest)
    high = np.where(random.random(rows) < 0.3, np.inf, lowest + random.random(rows))
    programme = programme_of(half @ half.T, list(random.normal(size=count)), A, list(low), list(high))
    start = (random.normal(size=count), random.normal(size=rows)) if is_warm else None
    ours, theirs = solve(programme, start, SETTINGS), by_interface(programme, start)
    assert (ours.solved, ours.iterations, ours.x.tobytes(), ours.y.tobytes()) == (
        theirs.solved, theirs.iterations, theirs.x.tobytes(), theirs.y.tobytes()
    )  # fmt: skip


@pytest.mark.parametrize("solver", [solve, reference.solve])
def test_what_cannot_be_is_said_not_to_be_solved(solver: Callable[..., OsqpAnswer]) -> None:
    assert not solver(programme_of(np.eye(1), [0.0], np.array([[1.0], [1.0]]), [1.0, -2.0], [2.0, 0.0]), None, SETTINGS).solved


def test_where_the_reference_fails_it_says_not_solved() -> None:
    assert not reference.solve(programme_of(1e300 * np.eye(1), [1.0], np.eye(1), [0.0], [1.0]), None, SETTINGS).solved


def test_wrong_settings_and_programmes_are_refused() -> None:
    programme = programme_of(np.eye(1), [-1.0], np.eye(1), [0.0], [0.5])
    with pytest.raises(AttributeError):
        solve(programme, None, {"no_such_setting": 1})
    with pytest.raises(ValueError, match=r"."):
        solve(programme._replace(low=np.array([1.0])), None, {"verbose": False})


def test_no_other_thread_sees_what_stands_in_for_scipy() -> None:
    run = subprocess.run([sys.executable, "-c", THREADS], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_ctrl_c_while_it_solves_is_heard() -> None:
    """OSQP, which hears it while it solves, kept it from everybody."""
    with subprocess.Popen([sys.executable, "-c", ENDLESS], stdout=subprocess.PIPE, text=True) as run:
        try:
            assert run.stdout is not None
            assert run.stdout.readline() == "solving\n"
            run.send_signal(signal.SIGINT)
            assert run.communicate(timeout=GUARD_S)[0].endswith("ended\n")  # OSQP may tell it, too
        finally:
            run.kill()
