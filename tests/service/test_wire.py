"""How a body arrives: spoken to the application directly, message by message."""

from __future__ import annotations

import json
from collections.abc import Awaitable, Callable, MutableMapping
from dataclasses import replace
from typing import Any

import anyio
import pytest
from starlette.requests import Request

from service import wire
from service.app import EMBEDDED, create_app
from service.service_settings import Settings
from tests.service import apart

Message = MutableMapping[str, Any]


def spoken(receive: Callable[[], Awaitable[Message]], settings: Settings = EMBEDDED, **headers: str) -> tuple[list[Message], list[Message]]:
    """Posts to /validate; returns what was received and what was answered."""
    received: list[Message] = []
    answered: list[Message] = []

    async def counted() -> Message:
        received.append(await receive())
        return received[-1]

    async def send(message: Message) -> None:
        answered.append(message)

    lines = [(name.replace("_", "-").encode(), value.encode()) for name, value in headers.items()]
    scope = {"type": "http", "method": "POST", "path": "/validate", "raw_path": b"/validate", "query_string": b"", "headers": lines}
    scope |= {"http_version": "1.1", "scheme": "http", "server": ("127.0.0.1", 80), "client": ("127.0.0.1", 9), "root_path": ""}

    async def call() -> None:
        await create_app(settings=settings)(scope, counted, send)

    apart.run(call)
    return received, answered


def status_and_document(answered: list[Message]) -> tuple[int, dict[str, Any]]:
    content = b"".join(message.get("body", b"") for message in answered[1:])
    return answered[0]["status"], json.loads(content)


async def million() -> Message:
    return {"type": "http.request", "body": b" " * 1_000_000, "more_body": True}


def test_an_endless_body_is_dropped_and_refused() -> None:
    received, answered = spoken(million)
    status, document = status_and_document(answered)
    assert (status, document["errors"][0]["field"]) == (413, "body")
    assert len(received) == wire.DRAIN_LIMIT // 1_000_000 + 1


def test_a_body_that_is_announced_too_large_is_not_waited_for() -> None:
    received, answered = spoken(million, content_length=str(10 * wire.DRAIN_LIMIT))
    assert (status_and_document(answered)[0], received) == (413, [])


def test_a_caller_that_asks_first_is_told_at_once() -> None:
    received, answered = spoken(million, content_length=str(25 << 20), expect="100-continue")
    assert (status_and_document(answered)[0], received) == (413, [])


def test_a_body_that_never_comes_is_refused() -> None:
    async def never() -> Message:
        await anyio.sleep_forever()
        return await million()

    _, answered = spoken(never, replace(EMBEDDED, body_seconds=0.05))
    status, document = status_and_document(answered)
    assert (status, document["errors"][0]["field"]) == (408, "body")


def test_a_caller_that_leaves_gets_nothing_and_breaks_nothing(caplog: pytest.LogCaptureFixture) -> None:
    async def leave() -> Message:
        return {"type": "http.disconnect"}

    _, answered = spoken(leave)
    assert answered == []
    assert [record for record in caplog.records if record.levelname in ("ERROR", "WARNING")] == []


@pytest.mark.parametrize("length", ["nonsense", "-1", "²", ""])
def test_a_length_that_is_no_number_is_let_be(length: str) -> None:
    async def small() -> Message:
        return {"type": "http.request", "body": b"{}", "more_body": False}

    lines = [(b"content-length", length.encode("latin-1"))]
    assert apart.run(wire.body_of, Request({"type": "http", "headers": lines}, small), EMBEDDED.body_seconds) == b"{}"
