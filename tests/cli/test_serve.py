"""`compose serve` in a process of its own, spoken to over the network."""

from __future__ import annotations

import http.client
import json
import re
import signal
import socket
import subprocess
from collections.abc import Iterator

import pytest

from tests.cli.programs import GUARD_S, PROGRAM, ROOT, compose, said


@pytest.fixture(scope="module")
def server() -> Iterator[tuple[subprocess.Popen[str], int]]:
    """A running service and its port."""
    with subprocess.Popen([*PROGRAM, "serve", "--port", "0"], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=ROOT) as run:
        assert run.stderr
        told = re.search(r"http://127\.0\.0\.1:(\d+)/", run.stderr.readline())
        assert told
        yield run, int(told.group(1))
        run.kill()


def asked(port: int, method: str, path: str, body: bytes | None = None) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=GUARD_S)
    connection.request(method, path, body)
    answer = connection.getresponse()
    content = answer.status, answer.read()
    connection.close()
    return content


def test_it_says_where_and_answers(server: tuple[subprocess.Popen[str], int]) -> None:
    _, port = server
    assert asked(port, "GET", "/healthz") == (200, b'{"status":"ok"}\n')
    status, content = asked(port, "POST", "/generate", b'{"seed": 42, "width": 6, "depth": 5}')
    assert (status, json.loads(content)["scene"]["seed"]) == (200, 42)


def test_a_large_body_hears_its_refusal(server: tuple[subprocess.Popen[str], int]) -> None:
    _, port = server
    status, content = asked(port, "POST", "/fix", b" " * (25 << 20))
    assert (status, json.loads(content)["status"]) == (413, 413)
    assert asked(port, "GET", "/healthz")[0] == 200


def test_what_is_no_http_does_not_hurt(server: tuple[subprocess.Popen[str], int]) -> None:
    _, port = server
    for words in (
        b"\x00\xff\r\n\r\n",
        b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n\r\n",
        b"POST /generate HTTP/1.1\r\nContent-Length: x\r\n\r\n",
    ):
        with socket.create_connection(("127.0.0.1", port), timeout=GUARD_S) as line:
            line.sendall(words)
            assert b" 400 " in line.recv(200)
    assert asked(port, "GET", "/healthz")[0] == 200


def test_a_taken_port_is_bad_use(server: tuple[subprocess.Popen[str], int]) -> None:
    run = compose("serve", "--port", str(server[1]))
    assert run.returncode == 2
    assert "compose: " in said(run)


def test_it_stops_when_told(server: tuple[subprocess.Popen[str], int]) -> None:
    run, port = server
    run.send_signal(signal.SIGINT)
    _, words = run.communicate(timeout=GUARD_S)
    assert run.returncode == 0
    assert "Traceback" not in words
    with pytest.raises(OSError):
        asked(port, "GET", "/healthz")
