"""The real service in a process of its own, on a free port of this machine, with the built page."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.service.heavy import PATIENCE_S

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "service" / "static" / "index.html"
ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/")


@dataclass
class ServiceProcess:
    """A running service and the address it answers at."""

    process: subprocess.Popen[str]
    address: str


@contextmanager
def running(port: int = 0, *more: str) -> Iterator[ServiceProcess]:
    """Run the service until the block ends; what it leaves where it keeps what is temporary, unless it was killed, fails.

    Args:
        port: the port to listen at; 0 for a free one.
        more: further words of the command.

    Raises:
        RuntimeError: it ended instead of saying where it answers.
    """
    if not PAGE.exists():
        subprocess.run([sys.executable, str(ROOT / "scripts" / "page.py"), "build"], check=True)
    command = [sys.executable, "-m", "compose_homes", "serve", "--port", str(port), *more]
    environment = {"COMPOSE_HOMES_STORE": "temporary", "COMPOSE_HOMES_REQUEST_SECONDS": str(PATIENCE_S), **os.environ}
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        environment["TMPDIR"] = folder
        with subprocess.Popen(command, cwd=ROOT, env=environment, stderr=subprocess.PIPE, text=True) as process:
            try:
                yield ServiceProcess(process, _said_address(process))
                process.terminate()
                process.wait(PATIENCE_S)
            except BaseException:  # a service that is told to stop first answers what it has accepted, however long that takes
                process.kill()
                raise
        assert process.returncode == -signal.SIGKILL or os.listdir(folder) == []


def _said_address(process: subprocess.Popen[str]) -> str:
    assert process.stderr is not None
    said = []
    for line in process.stderr:
        said.append(line)
        if found := ADDRESS.search(line):
            return found.group()
    raise RuntimeError("the service ended: " + "".join(said))


def descendants(process: int) -> list[int]:
    """The processes that a process and those that it started have started, by whichever thread."""
    found: list[int] = []
    for task in Path(f"/proc/{process}/task").glob("*/children"):
        with suppress(OSError):  # a thread that has ended since has handed its children to another one, which is looked at later
            found += map(int, task.read_text().split())
    return [*found, *(other for one in found for other in descendants(one))]
