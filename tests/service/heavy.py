"""Work for the tests of the workers: it runs in processes of its own, so it stands in a module of its own."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from starlette.responses import Response

    from service.work import Failure, Job

PATIENCE_S = 600.0
"""A guard against a test that would never end."""


def process(folder: str) -> int:
    """Waits until the gate file is there; leaves a file that says so meanwhile; returns its process."""
    inside = Path(folder) / f"inside-{os.getpid()}"
    inside.touch()
    deadline = time.monotonic() + PATIENCE_S
    while not (Path(folder) / "gate").exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    inside.unlink()
    return os.getpid()


def niceness() -> tuple[int, int]:
    """Its process, and how nice that is."""
    return os.getpid(), os.nice(0)


def held(job: Job) -> Response | Failure:
    """A call that first waits at the gate of the folder that its body names."""
    from service.work import do_alone

    process(job.body.decode())
    return do_alone(job)


def endless(note: str) -> NoReturn:
    """Notes its process and never ends."""
    Path(note).write_text(str(os.getpid()))
    while True:
        pass


def dies(folder: str, times: int) -> int:
    """Ends its process so many times; then returns which try it is."""
    tries = len(list(Path(folder).glob("try-*"))) + 1
    (Path(folder) / f"try-{tries}").touch()
    if tries <= times:
        os._exit(9)
    return tries


def killed(*_: object) -> NoReturn:
    """Is killed amid whatever it is asked."""
    os.kill(os.getpid(), signal.SIGKILL)
    raise AssertionError


def hungry() -> str:
    """Takes more memory than a call may, after one; returns what became of it."""
    from starlette.responses import Response

    from catalogs import load_catalogs
    from service.packed_catalogs import mark_of, packed
    from service.work import Job, do_alone

    done = do_alone(Job("view", b'{"scene": {"rooms": []}}', "json", "json", mark_of(packed(load_catalogs()))))
    assert isinstance(done, Response)
    try:
        return f"{done.status_code} took {len(bytearray(3 << 30))}"
    except MemoryError:
        return f"{done.status_code} refused"


def grows(size: int) -> int:
    """Has so much memory for a moment, bytes; returns its process."""
    kept = b"x" * size
    return os.getpid() if kept else 0


def fails(_: Job) -> Failure:
    """A call that breaks."""
    from service.work import Failure

    return Failure("Traceback: secret insides")


def doubled(content: bytes) -> bytes:
    """Returns twice as much."""
    return 2 * content
