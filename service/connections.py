"""Connections: bounded in number, in all and for each client; those that only wait for their client give way to new ones.

A connection **waits for its client** while a request has not arrived whole, and while the client does not take the answer. Where there are
too many, the one that has waited longest is closed: who opens many and says little keeps nobody out.
"""

from __future__ import annotations

import asyncio
from collections.abc import Container
from dataclasses import dataclass, field
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

from service.problems import RETRY_AFTER_S, problem
from service.service_settings import Settings


@dataclass
class Connections:
    """All connections of a service, as many and as patient as its settings say."""

    settings: Settings
    open: dict[WatchedConnection, str] = field(default_factory=dict)
    """The address of each one's client."""
    waiting: dict[WatchedConnection, None] = field(default_factory=dict)
    """Those that wait for their client, the longest first."""
    closed: int = 0
    """Those that gave way, or waited too long."""
    refused: int = 0
    """Those that were turned away."""

    def protocol(self, *given: Any, **named: Any) -> WatchedConnection:
        """Returns the protocol of a new connection, as uvicorn asks for it."""
        return WatchedConnection(self, *given, **named)

    def admit(self, new: WatchedConnection, client: str) -> bool:
        """Lets a connection in, and closes others for it where there are too many; tells whether there was room."""
        own = [one for one in self.open if self.open[one] == client]
        if 0 < self.settings.client_connections <= len(own) and not self._close_one(own):
            return False
        if len(self.open) >= self.settings.connections and not self._close_one(self.open):
            return False
        self.open[new] = client
        self.waiting[new] = None
        return True

    def _close_one(self, some: Container[WatchedConnection]) -> bool:
        """Closes the one of some connections that has waited longest for its client; tells whether there was one."""
        oldest = next((one for one in self.waiting if one in some), None)
        if oldest is not None:
            self.close(oldest)
        return oldest is not None

    def close(self, one: WatchedConnection) -> None:
        """Closes a connection that waits for its client."""
        self.closed += 1
        self.forget(one)
        one.transport.abort()

    def forget(self, one: WatchedConnection) -> None:
        """Counts a connection no more."""
        self.open.pop(one, None)
        self.waiting.pop(one, None)

    def note(self, one: WatchedConnection, waits: bool) -> None:
        """Notes whether a connection waits for its client."""
        if not waits:
            self.waiting.pop(one, None)
        elif one in self.open:
            self.waiting.setdefault(one)


class WatchedConnection(H11Protocol):
    """A connection that gives way while it waits for its client; `given` and `named` are what uvicorn gives its protocols."""

    def __init__(self, connections: Connections, *given: Any, **named: Any) -> None:
        super().__init__(*given, **named)
        self._all = connections
        self._timer: asyncio.TimerHandle | None = None
        self._is_stuck = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Lets it in, or turns it away."""
        super().connection_made(transport)
        if self._all.admit(self, self.client[0] if self.client else ""):
            self._note()
            return
        self._all.refused += 1
        transport.write(_refusal())
        transport.close()

    def connection_lost(self, exc: Exception | None) -> None:
        """Counts it no more."""
        self._all.forget(self)
        self._stop()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Reads what the client sent."""
        if self.transport.is_closing():
            return
        super().data_received(data)
        self._note()

    def on_response_complete(self) -> None:
        """Begins to wait for the next request."""
        super().on_response_complete()
        self._note()

    def pause_writing(self) -> None:
        """The client does not take the answer."""
        super().pause_writing()
        self._is_stuck = True
        self._note()

    def resume_writing(self) -> None:
        """The client takes the answer."""
        super().resume_writing()
        self._is_stuck = False
        self._note()

    def _note(self) -> None:
        waits = self._is_stuck or self.cycle is None or self.cycle.response_complete or self.cycle.more_body
        self._all.note(self, waits)
        if not waits:
            self._stop()
        elif self._timer is None and not self.transport.is_closing():
            settings = self._all.settings
            seconds = settings.body_seconds if self._is_stuck else settings.header_seconds + (settings.idle_seconds if self.cycle else 0)
            self._timer = self.loop.call_later(seconds, self._too_late)

    def _stop(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _too_late(self) -> None:
        """Ends a connection whose client sends no headers or takes no answer; a body that does not come is answered by the route."""
        self._timer = None
        is_body = self.cycle is not None and not self.cycle.response_complete and self.cycle.more_body
        if is_body and not self._is_stuck:
            return
        if self in self._all.waiting:
            self._all.close(self)


def _refusal() -> bytes:
    """Returns the answer to one connection too many."""
    entry = {"field": "service", "problem": "as many connections as may be are busy", "allowed": "another try in a moment"}
    answer = problem(503, "The service is busy", "As many connections as may be are busy.", [entry])
    head = f"HTTP/1.1 503 Service Unavailable\r\nContent-Type: {answer.media_type}\r\nContent-Length: {len(answer.body)}\r\n"
    return f"{head}Retry-After: {RETRY_AFTER_S}\r\nConnection: close\r\n\r\n".encode() + bytes(answer.body)
