"""Hostile requests: a slice of `make hostile`, by counts instead of seconds."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from starlette.responses import Response
from starlette.testclient import TestClient

from catalogs import load_catalogs
from service.effort import Terms
from service.packed_catalogs import mark_of, packed
from service.work import Job, do
from tests.browser.service_process import running
from tests.hostile.__main__ import Cost, found_before
from tests.hostile.requests import FAMILIES, MOST_BYTES, hostile
from tests.hostile.texts import faults
from tests.hostile.wire_cases import SHORT, wire_faults, wrong_in
from tests.service.problems import problem_of
from tests.sweeps import seeds

WORK = 20_000
SMALL = 20_000
"""Bytes of the bodies that are tried here."""
MOST_WORK = 600_000
"""What rows of a room and searches that are known to end may count beyond the limit in bodies of that size."""


@pytest.mark.parametrize("family", FAMILIES)
def test_no_hostile_request_works_long_or_is_answered_by_a_fault(family: str) -> None:
    known, first, tried = mark_of(packed(load_catalogs())), list(FAMILIES).index(family), 0
    for k in seeds(range(1000), 125):
        sent = hostile(first + k * len(FAMILIES))
        assert sent.family == family and len(sent.body) <= MOST_BYTES
        if len(sent.body) <= SMALL:
            done = do(Job(sent.call, sent.body, "json", "json", known, Terms(work=WORK)))
            assert isinstance(done, Response), f"{family} {k}: {done}"
            assert done.status_code in (200, 422)
            assert int(done.headers.get("x-work", "0")) <= WORK + MOST_WORK
            tried += 1
    assert tried


def test_costs_are_found_again_and_a_line_that_was_cut_off_is_made_anew(tmp_path: Path) -> None:
    whole, kept = Cost(1.5, 3, "fix", 100, 200, 50), tmp_path / "costs.jsonl"
    kept.write_text(f"{json.dumps(whole)}\n{json.dumps(whole._replace(seed=4))[:9]}", encoding="utf-8")
    with kept.open("a+", encoding="utf-8") as file:
        assert found_before(file) == [whole]
        print(json.dumps(whole._replace(seed=4)), file=file, flush=True)
        assert [one.seed for one in found_before(file)] == [3, 4]


@pytest.mark.parametrize("format", ["json", "yaml"])
def test_no_spoilt_text_is_answered_by_a_fault(format: str) -> None:
    assert list(faults(seeds(range(5000), 61), format)) == []


@pytest.mark.parametrize(
    "path",
    [
        "/assets/../../pyproject.toml", "/assets/%2e%2e/%2e%2e/pyproject.toml", "/assets/..%2f..%2fpyproject.toml", "/assets//etc/passwd",
        "/assets/%00", "/asset/..%2f..%2f..%2fetc%2fpasswd", "/asset/%2fetc%2fpasswd", "/export/..%2f..%2fetc", "/%2e%2e/%2e%2e/etc/passwd",
    ],
)  # fmt: skip
def test_no_path_leads_out_of_the_page(client: TestClient, path: str) -> None:
    for method in ("GET", "POST"):
        answer = client.request(method, path, content=b"{}")
        assert answer.status_code in (404, 405)
        assert "root:" not in answer.text and "build-system" not in answer.text
        problem_of(answer)


def test_no_header_of_a_request_becomes_one_of_the_answer(client: TestClient) -> None:
    answer = client.get("/healthz", headers=[(b"X-Request-ID", "a\u00a0Set-Cookie: b".encode("latin-1"))])
    assert "set-cookie" not in answer.headers
    assert len(answer.headers["x-request-id"]) == 32


def test_no_request_that_is_spoilt_on_the_wire_is_taken_for_another_or_answered_by_a_fault() -> None:
    with running(0, "--processes", "1", "--light-processes", "1", *SHORT) as service:
        assert wire_faults(service, seeds(range(6000), 53)) == []


@pytest.mark.parametrize(
    "answer",
    [
        b"HTTP/1.1 500 Internal Server Error\r\n\r\n",
        b"HTTP/1.1 400 Bad Request\r\n\r\n\nHTTP/1.1 200 OK\r\nx-request-id: hidden-request\r\n",
        b"HTTP/1.1 200 OK\r\nX-Request-ID: a\r\nX-Injected: yes\r\n\r\n",
        b"HTTP/1.1 200 OK\r\n\r\nroot:x:0:0",
        b"SSH-2.0",
        b"HTTP/1.1 400 Bad Request\r\n\r\nTraceback (most",
    ],
)
def test_what_must_not_be_answered_is_seen(answer: bytes) -> None:
    assert wrong_in(answer)
    assert not wrong_in(b'HTTP/1.1 404 Not Found\r\n\r\n{"errors": [{"problem": "There is no /a%0d%0aX-Injected: yes."}]}')


def test_a_piece_that_two_conflicts_name_is_left_out_once() -> None:
    """What ends one conflict took a member of another away, whose repairs were then looked for: KeyError."""
    sent = hostile(881374)
    assert isinstance(do(Job(sent.call, sent.body, "json", "json", mark_of(packed(load_catalogs())))), Response)
