"""Runs the application under uvicorn."""

from __future__ import annotations

import socket
import sys
from collections.abc import Collection
from typing import Final

from uvicorn import Config, Server

from catalogs import Catalogs
from service.app import create_app
from service.callers import LOOPBACK

CONNECTIONS: Final = 512
"""Open connections; a further one is turned away. Our choice."""
GRACE_S: Final = 5
"""How long running calls may go on when the service is told to stop, s. Our choice."""


def serve(host: str, port: int, catalogs: Catalogs, hosts: Collection[str] = ()) -> None:
    """Answers until the process is told to stop, and says on standard error where.

    Args:
        host: the address to listen at.
        port: the port; 0 for any free one.
        catalogs: the data to serve.
        hosts: the names it answers to, beside the address and those of this machine's own loop.

    Raises:
        OSError: the address cannot be listened at.
    """
    app = create_app(catalogs, {*hosts, host, *LOOPBACK})
    with listening(host, port) as listener:
        config = Config(
            app, http="h11", ws="none", lifespan="on", log_level="warning", server_header=False,
            limit_concurrency=CONNECTIONS, timeout_graceful_shutdown=GRACE_S,
        )  # fmt: skip
        shown = f"[{host}]" if listener.family == socket.AF_INET6 else host
        print(f"Compose answers at http://{shown}:{listener.getsockname()[1]}/ (Ctrl+C stops it)", file=sys.stderr, flush=True)
        try:
            Server(config).run(sockets=[listener])
        except KeyboardInterrupt:
            print("Compose has stopped.", file=sys.stderr)


def listening(host: str, port: int) -> socket.socket:
    """Returns a socket that listens, whose connections send what is written at once.

    An answer is written in two parts; the second would wait for the caller to confirm the first, which takes 40 ms.

    Raises:
        OSError: the address cannot be listened at.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listener = socket.create_server((host, port), family=family, backlog=CONNECTIONS)
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)  # connections take it over
    return listener
