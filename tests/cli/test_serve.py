"""`compose serve` in a process of its own, spoken to over the network."""

from __future__ import annotations

import http.client
import json
import socket
from collections.abc import Iterator
from urllib.parse import urlsplit

import pytest

from tests.browser.service_process import running
from tests.cli.programs import GUARD_S, compose, said


@pytest.fixture(scope="module")
def port() -> Iterator[int]:
    """Where a service listens; no test ends it."""
    with running() as service:
        yield urlsplit(service.address).port or 0


def asked(port: int, method: str, path: str, body: bytes | None = None) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=GUARD_S)
    connection.request(method, path, body)
    answer = connection.getresponse()
    content = answer.status, answer.read()
    connection.close()
    return content


def test_it_says_where_and_answers(port: int) -> None:
    assert asked(port, "GET", "/healthz") == (200, b'{"status":"ok"}\n')
    status, content = asked(port, "POST", "/generate", b'{"seed": 42, "width": 6, "depth": 5}')
    assert (status, json.loads(content)["scene"]["seed"]) == (200, 42)


def test_a_large_body_hears_its_refusal(port: int) -> None:
    status, content = asked(port, "POST", "/fix", b" " * (25 << 20))
    assert (status, json.loads(content)["status"]) == (413, 413)
    assert asked(port, "GET", "/healthz")[0] == 200


def test_what_is_no_http_does_not_hurt(port: int) -> None:
    for words in (
        b"\x00\xff\r\n\r\n",
        b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n\r\n",
        b"POST /generate HTTP/1.1\r\nContent-Length: x\r\n\r\n",
    ):
        with socket.create_connection(("127.0.0.1", port), timeout=GUARD_S) as line:
            line.sendall(words)
            assert b" 400 " in line.recv(200)
    assert asked(port, "GET", "/healthz")[0] == 200


def test_a_taken_port_is_bad_use(port: int) -> None:
    run = compose("serve", "--port", str(port))
    assert run.returncode == 2
    assert "compose: something listens at that address and port already: --port names another one" in said(run)
