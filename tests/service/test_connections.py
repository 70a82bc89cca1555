"""Connections that only wait for their client give way to new ones; by counts and with a server, not by the clock."""

from __future__ import annotations

import http.client
import socket
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any, Final, cast

import pytest

from service.connections import Connections, WatchedConnection
from service.service_settings import Settings
from service.service_store import NONE
from tests.cli.programs import GUARD_S
from tests.service.here import served

DAY_S: Final = 86_400.0
UNREAD = b"GET /core.wasm HTTP/1.1\r\nHost: localhost\r\n\r\n" * 40
"""More than the buffers on the way hold, for a client that reads none of it."""
DRIBBLE = b"GET /healthz HTTP/1.1\r\nHost: localhost\r\nX-Slow: "


class Server:
    """A service, and what is opened to it."""

    def __init__(self, place: tuple[str, int], stack: ExitStack) -> None:
        self._place, self._stack = place, stack

    def line(self, begins: bytes = DRIBBLE) -> socket.socket:
        """Opens a connection that says how it begins and no more."""
        line = self._stack.enter_context(socket.create_connection(self._place, timeout=GUARD_S))
        line.sendall(begins)
        return line

    def status(self, path: str = "/healthz") -> int:
        """Returns the status of a request on a connection of its own."""
        connection = http.client.HTTPConnection(*self._place, timeout=GUARD_S)
        try:
            connection.request("GET", path)
            return connection.getresponse().status
        finally:
            connection.close()

    def figure(self, name: str) -> float:
        """Returns a figure of /metrics."""
        connection = http.client.HTTPConnection(*self._place, timeout=GUARD_S)
        try:
            connection.request("GET", "/metrics")
            lines = connection.getresponse().read().decode().splitlines()
        finally:
            connection.close()
        return next(float(line.rpartition(" ")[2]) for line in lines if line.startswith(f"{name} "))


def is_closed(line: socket.socket) -> bool:
    """Waits for the other side to close a connection, or to answer."""
    try:
        return line.recv(100) == b""
    except ConnectionError:
        return True


@contextmanager
def served_by(**settings: Any) -> Iterator[Server]:
    """A service that waits for its clients a day, unless its settings say how long."""
    patient = {"header_seconds": DAY_S, "body_seconds": DAY_S, "idle_seconds": DAY_S}
    with served(Settings(allow_host=("*",), store=NONE, **patient | settings)) as place, ExitStack() as stack:
        yield Server(place, stack)


@pytest.fixture
def small() -> Iterator[Server]:
    """A service of four connections."""
    with served_by(connections=4) as server:
        yield server


def test_who_waits_longest_gives_way(small: Server) -> None:
    lines = [small.line() for _ in range(4)]
    assert small.status() == 200
    assert is_closed(lines[0])
    lines[3].sendall(b"done\r\n\r\n")
    assert lines[3].recv(100).startswith(b"HTTP/1.1 200")


def test_a_body_that_does_not_come_gives_way_too(small: Server) -> None:
    lines = [small.line(b"POST /view HTTP/1.1\r\nHost: localhost\r\nContent-Length: 99\r\n\r\n{") for _ in range(4)]
    assert small.status() == 200
    assert is_closed(lines[0])


def test_hundreds_that_dribble_keep_nobody_out() -> None:
    with served_by() as server:
        for _ in range(600):
            server.line()
        assert server.status() == 200
        assert server.status("/export") == 200


def test_headers_that_never_end_are_waited_for_so_long_and_no_longer() -> None:
    with served_by(header_seconds=0.05) as server:
        assert is_closed(server.line())


def test_one_address_has_so_many_connections() -> None:
    with served_by(client_connections=2) as server:
        first, second = server.line(), server.line()
        assert server.status() == 200
        assert is_closed(first)
        second.sendall(b"done\r\n\r\n")
        assert second.recv(100).startswith(b"HTTP/1.1 200")


def test_who_takes_no_answer_gives_way(small: Server) -> None:
    lines = [small.line(UNREAD) for _ in range(4)]
    while (status := small.status()) != 200:  # until the service has written all that there is room for
        assert status == 503
    assert small.status("/export") == 200
    assert len(lines) == 4


def test_who_takes_no_answer_is_waited_for_so_long_and_no_longer() -> None:
    with served_by(body_seconds=0.05) as server:
        line = server.line(UNREAD)
        while server.figure("compose_connections_closed") == 0:
            assert server.status() == 200
        assert line.recv(12) == b"HTTP/1.1 200"


class Lasting:
    """Stands in for a connection."""

    def __init__(self) -> None:
        self.transport = self
        self.is_aborted = False

    def abort(self) -> None:
        self.is_aborted = True


def test_where_none_waits_the_next_is_turned_away() -> None:
    connections = Connections(Settings(connections=2, client_connections=0))
    first, second, third = (cast(WatchedConnection, Lasting()) for _ in range(3))
    assert connections.admit(first, "a") and connections.admit(second, "b")
    for one in (first, second):
        connections.note(one, waits=False)
    assert not connections.admit(third, "c")
    connections.note(second, waits=True)
    assert connections.admit(third, "c")
    assert list(connections.open) == [first, third]
    assert cast(Lasting, second).is_aborted and not cast(Lasting, first).is_aborted


def test_an_address_pushes_out_none_but_its_own() -> None:
    connections = Connections(Settings(client_connections=1))
    mine, others, more = (cast(WatchedConnection, Lasting()) for _ in range(3))
    assert connections.admit(mine, "a") and connections.admit(others, "b")
    connections.note(mine, waits=False)
    assert not connections.admit(more, "a")
    assert list(connections.open) == [mine, others]
    connections.forget(mine)
    assert connections.admit(more, "a")
