"""Who is let in: keys, how often each may ask, how much work each may have a day, and pages of other places."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from service.admission import COOKIE, KNOWN, Admitted, Allowance, Quotas, Rates
from service.admitting import admitted_of
from service.app import create_app
from service.keys import KeyRing, listed_keys, read_keys
from service.service_settings import Settings, settings_of
from solver.errors import ComposeError, FieldError
from tests.every import every
from tests.service.problems import entry_of, problem_of

ANN, BEN = "ann-has-this-key-of-hers", "ben-has-another-key"
RING = KeyRing([("ann", ANN), ("ben", f"sha256:{sha256(BEN.encode()).hexdigest()}")])
TINY = {"scene": {"rooms": [{"width": 3.0, "depth": 3.0}]}}


class Clock:
    """A clock that goes where it is told."""

    def __init__(self) -> None:
        self.now = 1_000_000.0

    def __call__(self) -> float:
        return self.now


def asked(admitted: Admitted) -> TestClient:
    return TestClient(create_app(admitted=admitted), base_url="http://homes.example", raise_server_exceptions=False)


@pytest.fixture(scope="module")
def locked() -> TestClient:
    """A client of a service that wants keys."""
    return asked(Admitted(RING))


@pytest.mark.parametrize("headers", [{"X-API-Key": ANN}, {"Cookie": f"{COOKIE}={BEN}"}, {"Cookie": f"a=b; {COOKIE}={ANN}; c=d"}])
def test_a_key_lets_in(locked: TestClient, headers: Mapping[str, str]) -> None:
    assert locked.get("/schema", headers=headers).status_code == 200


def test_a_key_in_the_address_lets_in(locked: TestClient) -> None:
    assert locked.get(f"/schema?a=b&key={ANN}").status_code == 200


@every(
    "headers",
    [{}, {"X-API-Key": ANN[:-1]}, {"X-API-Key": ""}, {"X-API-Key": f"sha256:{'0' * 64}"}, {"Cookie": f"{COOKIE}=ä"}, {"Cookie": "=;=;"}],
)
@every("path", ["/schema", "/catalog", "/nothing", "/asset/a", "/metrics"])
def test_without_one_nothing_is_told(locked: TestClient, headers: Mapping[str, str], path: str) -> None:
    answer = locked.get(path, headers={name.encode(): value.encode("latin-1") for name, value in headers.items()})
    assert entry_of(answer, 401)["field"] == "key"
    assert answer.headers["www-authenticate"].startswith("ApiKey")


def test_every_call_wants_a_key_but_those_that_tell_nothing(locked: TestClient) -> None:
    paths = create_app().openapi()["paths"]
    calls = {(path, method) for path, methods in paths.items() for method in methods}
    found = {(path, method): locked.request(method, path.replace("{format}", "json")).status_code for path, method in calls}
    assert len(found) > 10
    assert {call for call, status in found.items() if status != 401} == {("/healthz", "get")}
    assert [locked.get(path).status_code for path in ("/docs", "/openapi.json", "/core.wasm")] == [200, 200, 200]


def test_the_page_keeps_a_key_of_its_address_in_a_cookie(locked: TestClient) -> None:
    answer = locked.get(f"/?seed=3&key={ANN}&style=rustic", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "./?seed=3&style=rustic")
    words = {word.strip().lower() for word in answer.headers["set-cookie"].split(";")}
    assert {f"{COOKIE}={ANN}", "httponly", "samesite=lax"} <= words and "secure" not in words
    locked.cookies.clear()
    assert "set-cookie" not in locked.get("/?key=wrong", follow_redirects=False).headers
    over_tls = TestClient(create_app(admitted=Admitted(RING)), base_url="https://homes.example")
    assert "secure" in over_tls.get(f"/?key={ANN}", follow_redirects=False).headers["set-cookie"].lower()


def test_without_keys_everybody_is_let_in() -> None:
    client = asked(Admitted())
    assert client.get("/schema").status_code == client.get("/schema", headers={"X-API-Key": "any"}).status_code == 200


def test_no_key_is_logged_or_said(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.DEBUG)
    client = asked(Admitted(RING))
    answers = [client.get(f"/{path}?key={key}") for path in ("schema", "nothing") for key in (ANN, "a-wrong-key-of-nobody")]
    assert [answer.status_code for answer in answers] == [200, 401, 404, 401]
    said = "".join(answer.text for answer in answers)
    ours = "".join(record.getMessage() for record in caplog.records if not record.name.startswith(("httpx", "httpcore")))
    assert ANN not in said + ours and "a-wrong-key-of-nobody" not in said + ours


def test_a_key_may_ask_so_often_a_minute() -> None:
    clock = Clock()
    client = asked(Admitted(RING, each_key=Allowance(calls=3), clock=clock, date=clock))
    ann, ben = {"X-API-Key": ANN}, {"X-API-Key": BEN}
    assert [client.get("/schema", headers=ann).status_code for _ in range(5)] == [200, 200, 200, 429, 429]
    refused = client.get("/schema", headers=ann)
    assert (entry_of(refused, 429)["field"], refused.headers["retry-after"]) == ("key", "20")
    assert client.get("/schema", headers=ben).status_code == 200
    clock.now += 19.9
    assert client.get("/schema", headers=ann).status_code == 429
    clock.now += 0.2
    assert [client.get("/schema", headers=ann).status_code for _ in range(2)] == [200, 429]


def test_an_address_may_ask_so_often_with_keys_or_without() -> None:
    clock = Clock()
    for ring in (RING, KeyRing()):
        client = asked(Admitted(ring, each_address=Allowance(calls=2), clock=clock, date=clock))
        statuses = [client.get("/schema", headers={"X-API-Key": key}).status_code for key in ("guess-of-a-key-1", "guess-of-a-key-2", ANN)]
        assert statuses == ([401, 401, 429] if ring else [200, 200, 429])
        assert client.get("/healthz").status_code == 200


class Working(Clock):
    """A clock that a call moves on by some seconds: each look at it is the last one and so much more."""

    def __call__(self) -> float:
        self.now += 2.0
        return self.now


def test_a_key_has_so_much_work_a_day() -> None:
    days = Clock()
    client = asked(Admitted(RING, each_key=Allowance(work_s=5.0), clock=Working(), date=days))
    ann = {"X-API-Key": ANN}
    assert [client.post("/view", json=TINY, headers=ann).status_code for _ in range(4)] == [200, 200, 200, 429]
    refused = client.post("/view", json=TINY, headers=ann)
    assert int(refused.headers["retry-after"]) == 86_400 - days.now % 86_400
    assert problem_of(refused)["title"] == "Too many requests"
    assert client.post("/view", json=TINY, headers={"X-API-Key": BEN}).status_code == 200
    days.now += int(refused.headers["retry-after"])
    assert client.post("/view", json=TINY, headers=ann).status_code == 200


def test_a_clock_that_is_put_back_gives_no_second_day() -> None:
    quotas = Quotas(10.0)
    quotas.spend("ann", 10.0, 5 * 86_400.0)
    assert quotas.wait("ann", 4 * 86_400.0) > 0 == quotas.wait("ben", 4 * 86_400.0)
    assert quotas.wait("ann", 6 * 86_400.0) == 0
    quotas.spend("ann", 10.0, 9_000 * 86_400.0)
    assert quotas.wait("ann", 8_999 * 86_400.0) > 0 == quotas.wait("ann", 6 * 86_400.0), "what was ahead by years does not last for years"
    rates = Rates(1)
    assert [rates.wait("ann", 100.0), rates.wait("ann", 50.0), rates.wait("ann", 200.0)] == [0, 60, 0]


def test_callers_without_number_take_no_memory_without_bound() -> None:
    rates, quotas = Rates(1), Quotas(1.0)
    for number in range(KNOWN + 50):
        rates.wait(str(number), 0.0)
        quotas.spend(str(number), 2.0, 0.0)
    assert len(rates._left) == len(quotas._used) == KNOWN
    assert rates.wait(str(KNOWN + 49), 0.0) == 60


def test_a_network_of_ipv6_is_one_address() -> None:
    app = create_app(admitted=Admitted(each_address=Allowance(calls=1)))
    statuses = [
        TestClient(app, client=(host, 1)).get("/schema").status_code
        for host in ("2001:db8::1", "2001:db8::ffff:2", "2001:db8:0:1::1", "10.0.0.1")
    ]
    assert statuses == [200, 429, 200, 200]


def test_pages_of_other_places_ask_only_where_they_are_allowed() -> None:
    origin = {"Origin": "https://editor.example"}
    ours, closed = asked(Admitted(origins=("https://editor.example",))), asked(Admitted())
    asks = {**origin, "Access-Control-Request-Method": "POST", "Access-Control-Request-Headers": "content-type,x-api-key"}
    allowed = ours.options("/view", headers=asks)
    assert (allowed.status_code, allowed.headers["access-control-allow-origin"]) == (200, "https://editor.example")
    answer = ours.post("/view", json=TINY, headers=origin)
    assert (answer.status_code, answer.headers["access-control-allow-origin"]) == (200, "https://editor.example")
    assert "access-control-allow-credentials" not in answer.headers
    other = {"Origin": "https://evil.example"}
    refused = [client.post("/view", json=TINY, headers=headers) for client, headers in ((ours, other), (closed, origin), (closed, other))]
    assert [answer.status_code for answer in refused] == [403, 403, 403]
    assert not any("access-control-allow-origin" in answer.headers for answer in refused)
    assert "access-control-allow-origin" not in closed.options("/view", headers=asks).headers


def test_a_file_of_keys_is_read() -> None:
    ring = KeyRing(read_keys(f"ann: {ANN}\nben: [{BEN}, sha256:{sha256(b'second').hexdigest()}]\n".encode()))
    assert [ring.owner_of(key) for key in (ANN, BEN, "second", "third", "")] == ["ann", "ben", "ben", None, None]
    assert KeyRing(listed_keys([f"ann={ANN}", f"ben={BEN}="])).owner_of(f"{BEN}=") == "ben"
    assert not KeyRing(listed_keys([]))


@pytest.mark.parametrize(
    "text",
    [
        "- a",
        "ann: 123456789012345678",
        "ann: short",
        "ann: key with spaces in it",
        "a b: 0123456789abcdefg",
        f"ann: {ANN}\nben: {ANN}",
        "ann: {}",
    ],
)
def test_what_is_no_key_is_refused_and_not_repeated(text: str) -> None:
    with pytest.raises(FieldError) as refused:
        KeyRing(read_keys(text.encode()))
    assert ANN not in str(refused.value) and "0123456789abcdefg" not in str(refused.value)
    with pytest.raises(FieldError):
        listed_keys(["ann"])


def test_what_is_set_is_taken(tmp_path: Path) -> None:
    file = tmp_path / "keys.yaml"
    file.write_text(f"ann: {ANN}\n")
    options = {"keys_file": str(file), "allow_origin": ["https://a.example"], "key_calls": "3", "address_work": "9"}
    found = admitted_of(settings_of(options, {"COMPOSE_HOMES_KEYS": f"ben={BEN}"}))
    assert (found.keys.owner_of(ANN), found.keys.owner_of(BEN), found.keys.owner_of("carla")) == ("ann", "ben", None)
    assert (found.each_key, found.each_address, found.origins) == (Allowance(3, 0), Allowance(0, 9), ("https://a.example",))
    assert not admitted_of(Settings()).keys


@pytest.mark.parametrize("origin", ["homes.example", "ftp://homes.example", "https://homes.example/", "*", "https://"])
def test_what_is_no_origin_is_refused(origin: str) -> None:
    with pytest.raises(FieldError):
        create_app(settings=Settings(allow_origin=(origin,)))


def test_a_file_for_keys_without_any_is_refused(tmp_path: Path) -> None:
    for text in ("{}", "", "# nobody yet"):
        (tmp_path / "keys.yaml").write_text(text)
        with pytest.raises(ComposeError):
            admitted_of(Settings(keys_file=str(tmp_path / "keys.yaml")))
