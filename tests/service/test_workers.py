"""Solver calls run beside the service, a bounded number at once; the rest waits or is turned away."""

from __future__ import annotations

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from starlette.testclient import TestClient

from service import calls, workers
from tests.service.problems import entry_of

PATIENCE_S = 10.0


class Gate:
    """Stands in for the solver: every call waits until the gate opens; counts those inside."""

    def __init__(self) -> None:
        self.opened = threading.Event()
        self.inside = self.most = 0
        self._lock = threading.Lock()

    def __call__(self, *_: object) -> tuple[str, tuple[str, ...]]:
        with self._lock:
            self.inside += 1
            self.most = max(self.most, self.inside)
        assert self.opened.wait(PATIENCE_S)
        with self._lock:
            self.inside -= 1
        return "", ()


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Gate:
    gate = Gate()
    monkeypatch.setattr(calls, "view", gate)
    return gate


def wait_until(condition: object) -> None:
    assert callable(condition)
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.005)


def test_the_service_answers_while_all_threads_are_busy(client: TestClient, gate: Gate) -> None:
    body = {"scene": {"rooms": []}}
    with ThreadPoolExecutor(16) as callers:
        running = [callers.submit(client.post, "/view", json=body) for _ in range(workers.RUNNING + 3)]
        wait_until(lambda: gate.inside == workers.RUNNING)
        assert client.get("/healthz").status_code == 200
        assert client.get("/docs").status_code == 200
        gate.opened.set()
        assert [call.result().status_code for call in running] == [200] * len(running)
    assert gate.most == workers.RUNNING


def test_a_long_line_turns_the_next_away(client: TestClient, gate: Gate, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "WAITING", 0)
    body = {"scene": {"rooms": []}}
    with ThreadPoolExecutor(16) as callers:
        running = [callers.submit(client.post, "/view", json=body) for _ in range(workers.RUNNING)]
        wait_until(lambda: gate.inside == workers.RUNNING)
        refused = client.post("/view", json=body)
        gate.opened.set()
        assert [call.result().status_code for call in running] == [200] * len(running)
    entry_of(refused, 503)
    assert int(refused.headers["retry-after"]) >= 1
    assert client.post("/view", json=body).status_code == 200
