"""What is acknowledged is kept: the service killed amid saves, a full disk, a database that is gone and comes back."""

from __future__ import annotations

import json
import random
import zlib
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path
from threading import Event, Thread

import httpx2
import pytest
from sqlalchemy import event, text
from starlette.testclient import TestClient

from service.app import create_app
from service.kept_contract import HomeHead, HomeQuery
from service.problems import NoSuchThing
from service.service_settings import Settings
from service.store.database import Database
from service.store.saved_homes import SavedHomes
from service.store.saved_jobs import SavedJobs
from tests.browser.service_process import running
from tests.service.heavy import PATIENCE_S
from tests.service.problems import entry_of
from tests.service.stores import PostgresqlServer, postgresql
from tests.service.test_homes import SCENE
from tests.sweeps import times

ROUNDS = times(20, 1)
"""Each round is a service that is killed amid saves and jobs; `make targets` runs all, more than 1,000 saves."""
SAVES = 60
MOST_BEFORE = 50
"""Saves of each of two, at most, after which the service is killed; 27 as a mean."""


def body(number: int) -> dict[str, object]:
    rooms = [
        {"id": f"r{index}", "type": "office", "width": 3.0 + number / 1000, "depth": 3.0, "x": 4.0 * index}
        for index in range(1 + number % 5)
    ]
    return {"name": f"home {number}", "notes": str(number), "scene": {"rooms": rooms}}


SEEDS = list(range(6))
STUDIO = {"width": 4.0, "depth": 4.0}
FEW = ("--processes", "1", "--light-processes", "1", "--homes-each", "10000")


class Working(Thread):
    """Asks for jobs, and removes those before, until the service is gone; what was acknowledged, and what may be gone, is written down."""

    def __init__(self, address: str) -> None:
        super().__init__(daemon=True)
        self._address, self._gone = address, Event()
        self.accepted: list[str] = []
        self.removed = set[str]()
        """Of some the service may have been killed before it said so."""

    def run(self) -> None:
        with httpx2.Client(base_url=self._address, timeout=PATIENCE_S) as client, suppress(httpx2.TransportError):
            while True:
                answer = client.post("/jobs", json={"call": "generate", "body": STUDIO, "seeds": SEEDS})
                assert answer.status_code == 202, answer.text
                self.accepted.append(answer.json()["id"])
                while (job := client.get(f"/jobs/{self.accepted[-1]}").json())["done"] < 2:
                    assert job["count"] == len(SEEDS)
                    self._gone.wait(0.02)
                if len(self.accepted) > 1:
                    self.removed.add(self.accepted[-2])
                    assert client.delete(f"/jobs/{self.accepted[-2]}").status_code == 204


class Saving(Thread):
    """Saves homes, one after another, and renames each, until the service is gone; what was acknowledged is written down."""

    def __init__(self, address: str, first: int, before: int) -> None:
        super().__init__(daemon=True)
        self._address, self._first, self._before = address, first, before
        self.begun = Event()
        self.saved: dict[str, int] = {}
        self.renamed: set[str] = set()

    def run(self) -> None:
        with httpx2.Client(base_url=self._address, timeout=PATIENCE_S) as client, suppress(httpx2.TransportError):
            for number in range(self._first, self._first + SAVES):
                answer = client.post("/homes", json=body(number))
                assert answer.status_code == 201, answer.text
                home = answer.json()["id"]
                self.saved[home] = number
                changed = client.patch(f"/homes/{home}", json={"name": f"renamed {number}"}, headers={"If-Match": '"1"'})
                assert changed.status_code == 200
                self.renamed.add(home)
                if len(self.saved) > self._before:
                    self.begun.set()
        self.begun.set()


def test_killed_amid_saves_it_has_all_that_it_acknowledged(place: str) -> None:
    draw, acknowledged, renamed = random.Random(18), dict[str, int](), set[str]()
    accepted, done = list[str](), 0
    for number in range(ROUNDS):
        with running(0, "--store", place, *FEW) as service:
            before = draw.randint(4, MOST_BEFORE)
            savers = [Saving(service.address, (2 * number + one) * SAVES, before) for one in range(2)]
            worker = Working(service.address)
            for thread in (worker, *savers):
                thread.start()
            for saver in savers:
                saver.begun.wait(PATIENCE_S)
            Event().wait(draw.random() / 50)
            service.process.kill()
            service.process.wait()
            for saver in savers:
                saver.join(PATIENCE_S)
                acknowledged |= saver.saved
                renamed |= saver.renamed
            worker.join(PATIENCE_S)
            accepted += worker.accepted
        done += checked_jobs(place, worker)
    words = f"{len(acknowledged)} saves and {len(accepted)} jobs acknowledged, {len(renamed)} renamed, {done} results"
    print(f"{words}, {ROUNDS} kills")  # `pytest -s` tells
    assert accepted
    assert len(acknowledged) >= (1000 if ROUNDS > 1 else 10)
    check(place, acknowledged, renamed)


def checked_jobs(place: str, worker: Working) -> int:
    """Every job that was acknowledged and not removed is there, with a whole result for each call that is said to be done and no other.

    Removes them, so that the next round may have as many; returns how many results there were.
    """
    counted = 0
    with closing(Database(place)) as database:
        jobs = SavedJobs(database)
        there = {job.id: job for job in jobs.list("")}
        assert set(worker.accepted) - worker.removed <= there.keys()
        for job in there.values():
            results = [jobs.result("", job.id, number) for number in range(job.done)]
            scenes = [json.loads(zlib.decompress(one.content))["scene"] for one in results]
            assert ([one.status for one in results], [scene["seed"] for scene in scenes]) == ([200] * job.done, SEEDS[: job.done])
            with pytest.raises(NoSuchThing):
                jobs.result("", job.id, job.done)
            jobs.remove("", job.id)
            counted += job.done
        with database.reading() as connection:
            assert connection.scalar(text("SELECT COUNT(*) FROM results")) == 0
    return counted


def check(place: str, acknowledged: dict[str, int], renamed: set[str]) -> None:
    """Every home that was acknowledged is there and whole, as last renamed; those that were not acknowledged are whole or not there."""
    with closing(Database(place)) as database:
        homes = SavedHomes(database)
        found, after = dict[str, HomeHead](), ""
        while True:
            page = homes.list("", HomeQuery(limit=100, after=after))
            found |= {home.id: home for home in page.homes}
            if page.after is None:
                break
            after = page.after
        assert acknowledged.keys() <= found.keys()
        for home, head in found.items():
            number = int(head.notes)
            assert head.name in ({f"renamed {number}"} if home in renamed else {f"home {number}", f"renamed {number}"})
            whole, scene = homes.get("", home)
            assert (whole.rooms, head.version) == (1 + number % 5, 1)
            assert len(scene) > 100
        with database.reading() as connection:
            counted = connection.execute(text("SELECT homes, bytes FROM owners")).one()
            sizes = connection.execute(text("SELECT COUNT(*), SUM(LENGTH(scene)) FROM versions")).one()
        assert tuple(counted) == tuple(sizes) == (len(found), counted[1])


def client_of(place: str) -> TestClient:
    return TestClient(create_app(settings=Settings(allow_host=("*",), store=place)), raise_server_exceptions=False)


def test_a_full_disk_is_said_and_harms_nothing(tmp_path: Path) -> None:
    with client_of(str(tmp_path / "homes.sqlite")) as client:
        store = client.app.store.open()  # type: ignore[attr-defined]
        before = client.post("/homes", json={"scene": SCENE}).json()["id"]
        engine = store._database.engine

        def fill(connection: object) -> None:
            connection.exec_driver_sql("PRAGMA max_page_count=1")  # type: ignore[attr-defined]

        event.listen(engine, "begin", fill)
        notes = "".join(random.Random(1).choice("abcdefgh") for _ in range(9_000))
        refused = client.post("/homes", json={"scene": SCENE, "notes": notes})
        assert entry_of(refused, 507)["field"] == "store"
        assert client.get(f"/homes/{before}").status_code == 200
        event.remove(engine, "begin", fill)
        engine.dispose()
        assert client.get("/homes").json()["total"] == 1
        assert client.post("/homes", json={"scene": SCENE, "notes": notes}).status_code == 201


def test_a_database_that_others_hold_is_said_and_comes_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.store.database.WAIT_S", 1.0)  # others never let go meanwhile, however long one waits
    place = str(tmp_path / "homes.sqlite")
    with client_of(place) as client, closing(Database(place)) as other:
        home = client.post("/homes", json={"scene": SCENE}).json()["id"]
        with other.writing():
            refused = client.patch(f"/homes/{home}", json={"name": "a"}, headers={"If-Match": "*"})
            assert (entry_of(refused, 503)["field"], refused.headers["retry-after"]) == ("store", "2")
            assert client.get(f"/homes/{home}").status_code == 200
        assert client.patch(f"/homes/{home}", json={"name": "a"}, headers={"If-Match": "*"}).status_code == 200


@pytest.fixture(scope="module")
def server() -> Iterator[PostgresqlServer]:
    with postgresql() as server:
        yield server


def test_a_server_that_is_gone_is_said_and_comes_back(server: PostgresqlServer) -> None:
    with client_of(server.url) as client:
        home = client.post("/homes", json={"scene": SCENE}).json()["id"]
        server.stop()
        for method, path in (("GET", "/homes"), ("GET", f"/homes/{home}"), ("DELETE", f"/homes/{home}")):
            assert entry_of(client.request(method, path, headers={"If-Match": "*"}), 503)["field"] == "store"
        assert client.get("/healthz").status_code == 200
        server.start()
        assert client.get(f"/homes/{home}").status_code == 200
        assert client.get("/homes").json()["total"] == 1
