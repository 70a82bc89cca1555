"""Runs the application under uvicorn."""

import gc
import math
import socket
import sys
from dataclasses import replace
from typing import Final

from uvicorn import Config, Server

from catalogs import Catalogs
from service.app import ComposeApp, create_app
from service.guard import LOOPBACK
from service.measures import log_access
from service.pool import ending_as_interrupted
from service.service_settings import Settings
from service.service_store import NONE
from solver.errors import ComposeError

SWITCH_S: Final = 0.0005
"""How long a thread that asks the store may keep the loop waiting, s; Python's own 5 ms would pass several times a request."""


def serve(settings: Settings, catalogs: Catalogs) -> None:
    """Answers until the process is told to stop, and says on standard error where.

    Raises:
        OSError: the address cannot be listened at.
    """
    if settings.access_log == "json":
        log_access()
    sys.setswitchinterval(SWITCH_S)
    app = create_app(catalogs, replace(settings, allow_host=(*settings.allow_host, settings.host, *LOOPBACK)))
    try:
        with ending_as_interrupted():  # uvicorn dies of SIGTERM in the end: what Python clears away at its exit would stay
            _open_store(app, settings)
            gc.freeze()  # what is there by now stays: looking through it all would keep everybody waiting for 80 ms, now and then
            with listening(settings.host, settings.port, settings.connections) as listener:
                StoppingServer(app).run(sockets=[listener])
    except KeyboardInterrupt:
        print("Compose has stopped.", file=sys.stderr)


class StoppingServer(Server):
    """Runs an application by its settings; told to stop, it tells the application: uvicorn would first wait for every answer to end."""

    def __init__(self, app: ComposeApp) -> None:
        idle, grace = math.ceil(app.settings.idle_seconds), math.ceil(app.settings.grace_seconds)
        config = Config(
            app, http=app.connections.protocol, ws="none", lifespan="on", log_level="warning", server_header=False,  # type: ignore[arg-type]
            timeout_keep_alive=idle, timeout_graceful_shutdown=grace,
        )  # fmt: skip
        super().__init__(config)
        self._app = app

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Says where it answers, by now that it hears when it is told to stop: whoever reads that may tell it so at once."""
        for listener in sockets or ():
            host, port = listener.getsockname()[:2]
            shown = f"[{host}]" if listener.family == socket.AF_INET6 else host
            print(f"Compose answers at http://{shown}:{port}/ (Ctrl+C stops it)", file=sys.stderr, flush=True)
        await super().startup(sockets)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Ends answers that have no end of their own, and waits for the others."""
        self._app.stopping.set()
        await super().shutdown(sockets)


def _open_store(app: ComposeApp, settings: Settings) -> None:
    """Opens the store, so that a wrong one ends the start; without the default one the service runs, and says so."""
    if settings.store == NONE:
        return
    try:
        app.store.open()
    except ComposeError as error:
        if settings.store is not None:
            raise
        print(f"Compose keeps no homes: {error} (--store names another place)", file=sys.stderr)


def listening(host: str, port: int, backlog: int = 512) -> socket.socket:
    """Returns a socket that listens, whose connections send what is written at once.

    An answer is written in two parts; the second would wait for the caller to confirm the first, which takes 40 ms.

    Raises:
        OSError: the address cannot be listened at.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listener = socket.create_server((host, port), family=family, backlog=backlog)
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)  # connections take it over
    return listener
