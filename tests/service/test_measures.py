"""What operators see: figures, request ids, the access log, whether more calls are welcome."""

from __future__ import annotations

import json
import logging
from dataclasses import replace
from typing import Any

import pytest
from starlette.testclient import TestClient

from catalogs import load_catalogs
from service import calls
from service.app import EMBEDDED, create_app
from service.packed_catalogs import mark_of, packed
from service.work import Job, do
from solver.core import CoreFailed
from tests.service.problems import entry_of

EMPTY: dict[str, Any] = {"scene": {"rooms": []}}


def figure(client: TestClient, name: str) -> float:
    """Returns a figure of /metrics; 0 where it is not there yet."""
    lines = client.get("/metrics").text.splitlines()
    return sum(float(line.rpartition(" ")[2]) for line in lines if line.startswith(name))


def test_requests_are_counted_by_path_and_status(client: TestClient) -> None:
    name = 'compose_requests_total{path="/view",status="200"}'
    before = figure(client, name)
    client.post("/view", json=EMPTY)
    assert figure(client, name) == before + 1
    client.get("/nowhere/at/all")
    assert figure(client, 'compose_requests_total{path="other",status="404"}') >= 1
    assert "nowhere" not in client.get("/metrics").text


def test_work_and_issues_are_counted(client: TestClient) -> None:
    sofa = {"name": "sofa", "x": -1.0, "z": 1.0, "width": 2.0, "depth": 0.9, "height": 0.8}
    scene = {"rooms": [{"id": "a", "width": 4, "depth": 4, "furniture": [sofa]}]}
    before = figure(client, 'compose_work_total{path="/fix"}'), figure(client, 'compose_issues_total{severity="error"}')
    fixed = client.post("/fix", json={"scene": scene})
    judged = client.post("/validate", json={"scene": scene})
    assert int(fixed.headers["x-work"]) > 0
    assert judged.headers["x-issues"].startswith("error=")
    after = figure(client, 'compose_work_total{path="/fix"}'), figure(client, 'compose_issues_total{severity="error"}')
    assert after[0] == before[0] + int(fixed.headers["x-work"])
    assert after[1] > before[1]


def test_a_caller_may_name_his_request(client: TestClient) -> None:
    assert client.get("/healthz", headers={"X-Request-ID": "mine-1"}).headers["x-request-id"] == "mine-1"
    drawn = [client.get("/healthz", headers={"X-Request-ID": "a b\t"}).headers["x-request-id"] for _ in range(2)]
    assert drawn[0] != drawn[1]
    assert all(len(one) == 32 for one in drawn)


def test_the_access_log_says_what_was_asked_but_no_key(client: TestClient, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, "compose.access"):
        client.get("/healthz?key=secret", headers={"X-Request-ID": "mine-2"})
    (line,) = [json.loads(record.getMessage()) for record in caplog.records if record.name == "compose.access"]
    assert (line["id"], line["method"], line["path"], line["status"]) == ("mine-2", "GET", "/healthz", 200)
    assert "secret" not in json.dumps(line)


def test_it_is_ready_once_it_is_started() -> None:
    app = create_app()
    assert entry_of(TestClient(app).get("/readyz"), 503)["problem"] == "is starting"
    with TestClient(app) as entered:
        assert entered.get("/readyz").json() == {"status": "ready"}


def test_figures_can_be_kept_from_all() -> None:
    assert TestClient(create_app(settings=replace(EMBEDDED, metrics=False))).get("/metrics").status_code == 404


def test_a_trap_of_the_core_is_tried_once_more(monkeypatch: pytest.MonkeyPatch) -> None:
    tries: list[int] = []

    def traps(*_: object) -> dict[str, object]:
        tries.append(len(tries))
        if len(tries) % 3 == 1 or len(tries) > 3:
            raise CoreFailed("ended in a trap")
        return {"issues": ()}

    monkeypatch.setattr(calls, "CALLS", {"view": traps})
    job = Job("view", b"{}", "json", "json", mark_of(packed(load_catalogs())))
    answer = do(job)
    assert getattr(answer, "status_code", None) == 200
    assert answer.headers["x-retried"] == "1"  # type: ignore[union-attr]
    tries.extend([0, 0])
    assert "ended in a trap" in do(job).trace  # type: ignore[union-attr]
