"""The stores that tests keep homes in: an SQLite file, and a PostgreSQL server of their own, in a temporary folder."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from urllib.parse import quote

from starlette.testclient import TestClient

from service.app import ComposeApp
from tests.service.heavy import PATIENCE_S

KEYS = {"ann": "a-key-that-ann-has", "ben": "a-key-that-ben-has"}
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
DEBIAN = Path("/usr/lib/postgresql")
ORDINARY = "nobody"
"""Who runs the server where the tests are root's, which PostgreSQL refuses."""


@cache
def programs() -> Path:
    """Returns the folder of PostgreSQL's programs, installing Debian's package where there is none.

    Raises:
        RuntimeError: it is not there and could not be had.
    """
    if found := _installed():
        return found
    sys.path.insert(0, str(SCRIPTS))
    import debian  # type: ignore[import-not-found]

    debian.install("postgresql")
    if found := _installed():
        return found
    raise RuntimeError("PostgreSQL is missing and could not be fetched: install postgresql, and try again")


def _installed() -> Path | None:
    on_path = shutil.which("initdb")
    folders = [path / "bin" for path in sorted(DEBIAN.glob("*"), reverse=True)] + ([Path(on_path).parent] if on_path else [])
    return next((folder for folder in folders if (folder / "initdb").exists() and (folder / "postgres").exists()), None)


class PostgresqlServer:
    """A server that listens at a socket in its folder and nowhere else."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._user = ORDINARY if os.geteuid() == 0 else None
        if self._user:
            shutil.chown(folder, self._user)
        self._run("initdb", "--username=compose", "--auth=trust", "--encoding=UTF8", "--no-sync", "--pgdata", str(folder / "data"))

    @property
    def url(self) -> str:
        """Its database's."""
        return f"postgresql://compose@/postgres?host={quote(str(self.folder))}"

    def start(self) -> None:
        """Starts it, and waits until it answers."""
        socket = shlex.quote(f"unix_socket_directories={self.folder}")
        options = f"-c listen_addresses= -c {socket} -c max_connections=30"
        self._run(
            "pg_ctl", "start", "--wait", "--silent", "--pgdata", str(self.folder / "data"), "--log", str(self.folder / "log"), "-o", options
        )

    def stop(self) -> None:
        """Stops it, whoever is connected."""
        self._run("pg_ctl", "stop", "--wait", "--silent", "--mode=immediate", "--pgdata", str(self.folder / "data"))

    def _run(self, program: str, *words: str) -> None:
        environment = {"PATH": os.environ.get("PATH", os.defpath), "LC_ALL": "C.UTF-8", "TZ": "UTC", "PGCTLTIMEOUT": f"{PATIENCE_S:.0f}"}
        subprocess.run(
            [str(programs() / program), *words], user=self._user, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, check=True,
        )  # fmt: skip


@contextmanager
def postgresql() -> Iterator[PostgresqlServer]:
    """Runs a server until the block ends."""
    with tempfile.TemporaryDirectory(prefix="compose-pg-") as folder:
        server = PostgresqlServer(Path(folder))
        server.start()
        try:
            yield server
        finally:
            with suppress(subprocess.CalledProcessError):
                server.stop()


def client_of(app: ComposeApp, name: str = "ann") -> TestClient:
    """A client with a key; all of them share the application's loop."""
    client = TestClient(app, headers={"X-API-Key": KEYS[name]}, raise_server_exceptions=False)
    client.portal = app.state.portal
    return client
