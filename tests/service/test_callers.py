"""Who may ask: names of the service, origins of pages, framing; and HEAD."""

from __future__ import annotations

import http.client
import socket

import pytest
from starlette.testclient import TestClient

from service.app import create_app
from service.guard import host_name
from service.service_settings import Settings
from service.service_store import NONE
from tests.cli.programs import GUARD_S
from tests.service.here import served

ASKED = b'{"seed": 1, "width": 6, "depth": 5}'


@pytest.fixture(scope="module")
def named() -> TestClient:
    """A client of a service that has two names."""
    return TestClient(create_app(settings=Settings(allow_host=("localhost", "homes.example"))), base_url="http://homes.example:8000")


@pytest.mark.parametrize("host", ["localhost", "LOCALHOST:8000", "homes.example", "homes.example:443"])
def test_its_own_names_are_answered(named: TestClient, host: str) -> None:
    assert named.get("/healthz", headers={"Host": host}).status_code == 200


@pytest.mark.parametrize("host", ["evil.example", "homes.example.evil.example", "localhost@evil.example", "[", "", "127.0.0.1"])
def test_other_names_are_refused(named: TestClient, host: str) -> None:
    answer = named.get("/healthz", headers={"Host": host})
    assert answer.status_code == 421
    assert answer.json()["errors"][0]["field"] == "Host"


def test_names_are_read_without_port_and_brackets() -> None:
    assert [host_name(host) for host in ("[::1]:80", "A.b:1", "a", ":80")] == ["::1", "a.b", "a", ""]


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://homes.example:9000", "http://[", "https://evil.example:8000"])
def test_pages_of_others_make_no_houses(named: TestClient, origin: str) -> None:
    for kind in ("application/json", "text/plain", "application/x-www-form-urlencoded"):
        answer = named.post("/generate", content=ASKED, headers={"Origin": origin, "Content-Type": kind})
        assert (answer.status_code, answer.json()["errors"][0]["field"]) == (403, "Origin")


def test_its_own_page_and_callers_that_are_no_page_make_houses(named: TestClient) -> None:
    for headers in ({"Origin": "http://homes.example:8000"}, {}):
        assert named.post("/generate", content=ASKED, headers=headers).status_code == 200


@pytest.mark.parametrize("path", ["/", "/healthz", "/schema", "/nothing"])
def test_head_answers_as_get_without_the_body(named: TestClient, path: str) -> None:
    got, head = named.get(path), named.head(path)
    assert (head.status_code, head.content) == (got.status_code, b"")
    assert head.headers["content-length"] == got.headers["content-length"]
    assert head.headers["content-type"] == got.headers["content-type"]


def test_a_body_framed_twice_is_refused() -> None:
    with served(Settings(allow_host=("*",), store=NONE)) as place, socket.create_connection(place, timeout=GUARD_S) as line:
        line.sendall(b"POST /view HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n")
        line.sendall(b"Content-Length: 12\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n")
        answer = http.client.HTTPResponse(line, method="POST")
        answer.begin()
        assert answer.status == 400
