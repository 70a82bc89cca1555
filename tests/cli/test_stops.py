"""How a service ends: it answers what it has accepted; told twice, it ends at once; killed, it leaves nothing running."""

from __future__ import annotations

import http.client
import json
import os
import signal
import socket
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import urlsplit

import pytest
from starlette.testclient import TestClient

from service.app import EMBEDDED, create_app
from tests.browser.service_process import ServiceProcess, descendants, running
from tests.cli.programs import GUARD_S, is_gone, started, until

FEW = ("--processes", "1", "--light-processes", "1", "--grace-seconds", f"{GUARD_S}")
SOFAS = {"name": "sofa", "count": 64, "relations": [{"type": "near", "of": "sofa"}]}
WISH = {"room": {"id": "a", "width": 9, "depth": 9}, "pieces": [SOFAS], "alternatives": 16}


def asked(service: ServiceProcess, method: str, path: str, body: object = None) -> tuple[int, bytes]:
    place = urlsplit(service.address)
    connection = http.client.HTTPConnection(place.hostname or "", place.port, timeout=GUARD_S)
    try:
        connection.request(method, path, None if body is None else json.dumps(body).encode())
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()


def is_working(service: ServiceProcess) -> bool:
    return b"\ncompose_heavy_running 1.0\n" in asked(service, "GET", "/metrics")[1]


def is_listening(service: ServiceProcess) -> bool:
    place = urlsplit(service.address)
    try:
        socket.create_connection((place.hostname, place.port), timeout=GUARD_S).close()
    except ConnectionRefusedError:
        return False
    return True


def test_a_stop_answers_what_was_accepted() -> None:
    with running(0, *FEW) as service, ThreadPoolExecutor(1) as callers:
        call = callers.submit(asked, service, "POST", "/place", {**WISH, "effort": "quick"})
        until(lambda: is_working(service) or call.done())
        service.process.send_signal(signal.SIGINT)
        assert call.result()[0] == 200
        _, words = service.process.communicate(timeout=GUARD_S)
        assert service.process.returncode == 0, words
        assert "Traceback" not in words and not is_listening(service)


def test_who_listens_keeps_no_stop_waiting() -> None:
    job = {"call": "generate", "body": {"program": "studio"}, "seeds": list(range(1000))}
    with running(0, *FEW, "--grace-seconds", "36000") as service:
        path = f"/jobs/{json.loads(asked(service, 'POST', '/jobs', job)[1])['id']}/events"
        place = urlsplit(service.address)
        with closing(http.client.HTTPConnection(place.hostname or "", place.port, timeout=GUARD_S)) as connection:
            connection.request("GET", path)
            stream = connection.getresponse()
            assert b"event: progress" in stream.readline()
            service.process.send_signal(signal.SIGTERM)
            assert b"event: done" not in stream.read(), "it ends as a whole answer, with nothing said that is not so"
            assert service.process.wait(GUARD_S) == 0


@pytest.mark.parametrize("signals", [[signal.SIGINT, signal.SIGINT], [signal.SIGKILL]])
def test_told_twice_or_killed_it_leaves_nothing_running(signals: list[signal.Signals]) -> None:
    with running(0, *FEW) as service, ThreadPoolExecutor(1) as callers:
        call = callers.submit(asked, service, "POST", "/place", {**WISH, "effort": "thorough"})
        until(lambda: is_working(service))
        processes = descendants(service.process.pid)
        assert len(processes) >= 3, "one for each lane, and the one that forks them"
        service.process.send_signal(signals[0])
        for one in signals[1:]:
            until(lambda: not is_listening(service))  # two of the same that come at once are one
            service.process.send_signal(one)
        service.process.wait(GUARD_S)
        assert call.exception() is not None or call.result()[0] >= 500
        until(lambda: all(map(is_gone, processes)))
    assert service.process.returncode in (0, -signal.SIGKILL, -signal.SIGINT)
    assert not [one for one in processes if not is_gone(one) and one != os.getpid()]


def test_a_call_without_an_end_ends_with_a_service_that_is_killed(tmp_path: Path) -> None:
    note = tmp_path / "process"
    work = f"run(Workers(Settings()).run(endless, {str(note)!r}))"
    imports = "from asyncio import run; from service.workers import Settings, Workers; from tests.service.heavy import endless"
    command = (sys.executable, "-c", f"{imports}; {work}")
    with TemporaryDirectory() as left, started(*command, env={**os.environ, "TMPDIR": left}) as service:
        until(lambda: note.exists() and note.read_text() != "")
        service.kill()
    until(lambda: is_gone(int(note.read_text())))


def test_an_application_that_is_left_leaves_no_process() -> None:
    app = create_app(settings=replace(EMBEDDED, processes=1, light_processes=1))
    with TestClient(app):
        started = [*app.workers.heavy.idle, *app.workers.light.idle]
        assert len(started) == 2 and all(process.lives() for process in started)
    assert not any(process.lives() for process in started)
