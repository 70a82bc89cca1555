"""Work spread over a Ray cluster: the same tasks as on one machine, and so the same bytes.

Ray's store holds the function and small records, never a scene. What a lost node was at is done again.
"""

import ctypes
import logging
import signal
import socket
import sys
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final, TypeVar

import ray
from ray.exceptions import RayError

from solver.errors import FieldError

Asked = TypeVar("Asked")
Made = TypeVar("Made")

LOCAL: Final = "local"
"""The address of a cluster of this machine alone, started for this run."""
AHEAD: Final = 2
"""Jobs under way for each processor."""
CONNECTING_S: Final = 10.0
RETRIES: Final = 5
"""How often a job is begun again whose node or process was lost."""
TAKEN: Final = ("SIGILL", "SIGTRAP", "SIGABRT", "SIGBUS", "SIGFPE", "SIGSEGV")
"""The signals of faults: Ray takes them for its reports and gives them up when it ends; some tell the core of its own faults."""
_ACTION_BYTES: Final = 512
"""More than a `struct sigaction` has anywhere."""


def on_cluster(make: Callable[[Asked], Made], jobs: Sequence[Asked], workers: int, address: str) -> Iterator[Made]:
    """Yields what a function makes of each job, in their order; every node has its module.

    `workers` are processors of a local cluster, a real one has what it has; `address` is as `ray.init` takes it, or LOCAL.

    Raises:
        FieldError: nothing answers at the address, the cluster does not start, or it loses a job again and again.
    """
    if not jobs:
        return
    is_local = address == LOCAL
    _check(address)
    here: dict[str, Any] = {"num_cpus": workers, "include_dashboard": False} if is_local else {}
    threads = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMEXPR")}
    try:
        with _own_signals():
            _start(address, {"runtime_env": {"env_vars": threads}, **here})
        task = ray.remote(max_retries=RETRIES, retry_exceptions=False)(_do)
        held, ahead = ray.put(make), deque(jobs)
        pending: deque[Any] = deque()
        resources: dict[str, float] = ray.cluster_resources()  # type: ignore[no-untyped-call]
        most = AHEAD * max(1, int(resources.get("CPU", 1)))
        while ahead or pending:
            while ahead and len(pending) < most:
                pending.append(task.remote(held, ahead.popleft()))
            yield ray.get(pending.popleft())
    except (RuntimeError, ConnectionError, RayError) as error:
        problem = f"the cluster does not do its work: {str(error).strip().splitlines()[-1]:.200}"
        raise FieldError("--ray", problem, "what is done is kept: the same command goes on, with --ray or without") from None
    finally:
        with _own_signals():
            ray.shutdown()


def _start(address: str, how: dict[str, Any]) -> None:
    """Starts or joins a cluster. Ray waits half a minute for a node of this machine and then raises a bare `Exception`."""
    try:
        ray.init(address, log_to_driver=False, logging_level=logging.ERROR, **how)
    except (RuntimeError, ConnectionError, RayError):
        raise
    except Exception as error:
        raise RuntimeError(str(error)) from None


@contextmanager
def _own_signals() -> Iterator[None]:
    """Leaves the signals of faults to whom they were left before the block.

    Where the core was used before, a fault in it would else end the process. In Ray's own processes the core begins later.
    """
    if sys.platform == "win32":
        yield
        return
    libc = ctypes.CDLL(None)
    before = {name: ctypes.create_string_buffer(_ACTION_BYTES) for name in TAKEN}
    for name, action in before.items():
        libc.sigaction(signal.Signals[name], None, action)
    try:
        yield
    finally:
        for name, action in before.items():
            libc.sigaction(signal.Signals[name], action, None)


def _check(address: str) -> None:
    """Refuses an address where nobody listens: Ray would wait for minutes."""
    host, colon, port = address.removeprefix("ray://").rpartition(":")
    if not (colon and port.isdecimal()):
        return
    try:
        socket.create_connection((host.strip("[]"), int(port)), timeout=CONNECTING_S).close()
    except OSError as error:
        raise FieldError("--ray", f"nothing answers at {address}: {error.strerror or error}", "the address of a Ray cluster") from None


def _do(make: Callable[[Any], Any], job: Any) -> Any:
    return make(job)
