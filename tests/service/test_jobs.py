"""Long work: taken on, told of, carried on after the service was killed, ended; each key has its own."""

from __future__ import annotations

import json
import time
import zlib
from contextlib import closing
from pathlib import Path
from typing import Any

import httpx2
import pytest
from sqlalchemy import select, update

from service.app import ComposeApp
from service.kept_contract import LEASE_S, JobResult
from service.store.database import JOBS, RESULTS, Database
from service.store.saved_jobs import MOST_JOBS, SavedJobs
from solver.errors import FieldError
from tests.browser.service_process import running
from tests.service.problems import entry_of
from tests.service.stores import client_of

SMALL: dict[str, Any] = {"width": 4.0, "depth": 4.0}
GUARD_S = 600
FEW = ("--processes", "1", "--light-processes", "1")


def told(text: str) -> list[tuple[str, dict[str, Any]]]:
    """The events of a stream: name and document."""
    events = [dict(line.split(": ", 1) for line in block.splitlines()) for block in text.strip().split("\n\n") if not block.startswith(":")]
    return [(event["event"], json.loads(event["data"])) for event in events]


def test_a_job_is_taken_on_told_of_and_done(app: ComposeApp) -> None:
    ann = client_of(app)
    answer = ann.post("/jobs", json={"call": "generate", "body": SMALL, "seeds": [5, 3, 5, 4]})
    job = answer.json()
    assert (answer.status_code, job["count"], answer.headers["location"]) == (202, 3, f"/jobs/{job['id']}")
    events = told(ann.get(f"/jobs/{job['id']}/events").text)
    assert [name for name, _ in events][-1] == "done" and {name for name, _ in events[:-1]} <= {"progress"}
    assert [one["done"] for _, one in events] == sorted(one["done"] for _, one in events)
    assert (events[-1][1]["done"], events[-1][1]["refused"], events[-1][1]["state"]) == (3, 0, "done")
    for number, seed in enumerate((5, 3, 4)):
        made = ann.get(f"/jobs/{job['id']}/results/{number}")
        alone = ann.post("/generate", json={**SMALL, "seed": seed}).json()
        assert made.headers["x-call-status"] == "200"
        assert {**made.json(), "timing_ms": 0} == {**alone, "timing_ms": 0}
    assert entry_of(ann.get(f"/jobs/{job['id']}/results/3"), 404)["field"] == "result"


def test_what_is_refused_is_told_of_each_call(app: ComposeApp) -> None:
    ann = client_of(app)
    job = ann.post("/jobs", json={"call": "validate", "body": {}}).json()["id"]
    assert told(ann.get(f"/jobs/{job}/events").text)[-1][1]["refused"] == 1
    result = ann.get(f"/jobs/{job}/results/0")
    assert (result.headers["x-call-status"], result.headers["content-type"]) == ("422", "application/problem+json")
    assert result.json()["errors"][0]["field"] == "scene"


@pytest.mark.parametrize(
    "body", [{}, {"call": "catalog"}, {"call": "fix", "seeds": []}, {"call": "fix", "seeds": [-1]}, {"call": "fix", "body": []}]
)
def test_what_is_no_job_is_refused(app: ComposeApp, body: dict[str, Any]) -> None:
    assert entry_of(client_of(app).post("/jobs", json=body), 422)["field"].split("[")[0] in ("call", "seeds", "body")


def test_each_key_has_its_own_jobs_alone(app: ComposeApp) -> None:
    ann, ben = client_of(app), client_of(app, "ben")
    job = ann.post("/jobs", json={"call": "generate", "body": SMALL, "seeds": [1]}).json()["id"]
    told(ann.get(f"/jobs/{job}/events").text)
    routes = [(path, method) for path, methods in app.openapi()["paths"].items() for method in methods if "{job}" in path]
    assert len(routes) >= 4
    for path, method in routes:
        answers = [ben.request(method, path.format(job=id_of, number=0)) for id_of in (job, "x" * len(job))]
        assert [answer.status_code for answer in answers] == [404, 404], (path, method)
        assert answers[0].text.replace(job, "x" * len(job)) == answers[1].text
    assert ben.get("/jobs").json() == {"jobs": []}
    assert job in {one["id"] for one in ann.get("/jobs").json()["jobs"]}
    assert ann.delete(f"/jobs/{job}").status_code == 204
    assert ann.get(f"/jobs/{job}").status_code == 404


def test_a_job_that_is_removed_ends(app: ComposeApp) -> None:
    ann = client_of(app)
    long = ann.post("/jobs", json={"call": "generate", "body": SMALL, "seeds": list(range(900))}).json()["id"]
    assert ann.delete(f"/jobs/{long}").status_code == 204
    short = ann.post("/jobs", json={"call": "generate", "body": SMALL, "seeds": [1]}).json()["id"]
    assert told(ann.get(f"/jobs/{short}/events").text)[-1][0] == "done"


def test_a_silent_runners_job_is_carried_on_and_no_other(place: str) -> None:
    now = [1_000_000_000_000]
    with closing(Database(place)) as database:
        jobs = SavedJobs(database, lease_s=20, clock=lambda: now[0])
        job = jobs.add("zoe", "generate", zlib.compress(b"[{}, {}]"), 2).id
        taken = jobs.take("first")
        assert taken is not None and taken[0].id == job
        assert jobs.put("first", job, 0, JobResult(200, "application/json", b"one"))
        now[0] += 19 * 10**9
        assert jobs.take("second") is None and jobs.beat("first", job)
        now[0] += 21 * 10**9
        carried = jobs.take("second")
        assert carried is not None and (carried[0].id, carried[0].done) == (job, 1)
        assert not jobs.put("first", job, 1, JobResult(200, "application/json", b"late")) and not jobs.beat("first", job)
        assert jobs.put("second", job, 1, JobResult(422, "application/json", b"two"))
        jobs.finish("second", job)
        found = jobs.get("zoe", job)
        assert (found.state, found.done, found.refused) == ("done", 2, 1)
        assert [jobs.result("zoe", job, number).content for number in range(2)] == [b"one", b"two"]
        for _ in range(MOST_JOBS - 1):
            jobs.add("zoe", "generate", b"", 1)
        with pytest.raises(FieldError, match="as many as may be kept"):
            jobs.add("zoe", "generate", b"", 1)
        for one in jobs.list("zoe"):
            jobs.remove("zoe", one.id)


def test_a_job_goes_with_its_results_and_no_others(place: str) -> None:
    with closing(Database(place)) as database:
        jobs = SavedJobs(database)
        made = [jobs.add("xia", "generate", zlib.compress(b"[{}]"), 1).id for _ in range(2)]
        for job in made:
            taken = jobs.take("runner")
            assert taken is not None and taken[0].id == job
            assert jobs.put("runner", job, 0, JobResult(200, "application/json", job.encode()))
        jobs.remove("xia", made[0])
        with database.reading() as connection:
            assert connection.execute(select(RESULTS.c.job, RESULTS.c.number).where(RESULTS.c.job.in_(made))).all() == [(made[1], 0)]
        assert jobs.result("xia", made[1], 0).content == made[1].encode()
        jobs.remove("xia", made[1])


@pytest.mark.parametrize("jump_s", [-86_400 * 365, -3600, 3600, 86_400 * 365])
def test_a_clock_that_jumps_leaves_no_job_behind_and_gives_none_two_runners(place: str, jump_s: int) -> None:
    now = [1_700_000_000 * 10**9]
    with closing(Database(place)) as database:
        jobs = SavedJobs(database, lease_s=20, clock=lambda: now[0])
        job = jobs.add("yan", "generate", zlib.compress(b"[{}]"), 1).id
        assert jobs.take("first") is not None
        now[0] += jump_s * 10**9
        assert jobs.beat("first", job) and jobs.take("second") is None, "it said a word by the new clock"
        now[0] -= jump_s * 10**9
        carried = jobs.take("second")
        assert carried is not None and carried[0].id == job, "nobody has said a word by this clock"
        assert not jobs.beat("first", job) and not jobs.put("first", job, 0, JobResult(200, "application/json", b"late"))
        assert jobs.put("second", job, 0, JobResult(200, "application/json", b"once"))
        jobs.finish("second", job)
        assert (jobs.get("yan", job).state, jobs.result("yan", job, 0).content) == ("done", b"once")
        jobs.remove("yan", job)


def begun(address: str, seeds: range) -> dict[str, Any]:
    """A job as it is once two homes of it are made."""
    with httpx2.Client(base_url=address, timeout=GUARD_S) as client:
        job = client.post("/jobs", json={"call": "generate", "body": {"program": "studio"}, "seeds": [*seeds]}).json()
        while job["done"] < 2:
            time.sleep(0.05)
            job = client.get(f"/jobs/{job['id']}").json()
        return dict(job)


def test_a_job_outlives_the_service_that_took_it_on(tmp_path: Path) -> None:
    words, seeds = (0, *FEW, "--store", str(tmp_path / "homes.sqlite")), range(10)
    with running(*words) as service:
        while (before := begun(service.address, seeds))["state"] == "done":  # before anybody looked again
            seeds = range(2 * len(seeds))
        service.process.kill()
        service.process.wait()
    job = before["id"]
    with closing(Database(str(tmp_path / "homes.sqlite"))) as database:
        kept = SavedJobs(database).get("", job).done
        with database.writing() as connection:  # as if its runner had been silent for long
            connection.execute(update(JOBS).values(beat=JOBS.c.beat - round(1e6 * LEASE_S)))
    with running(*words) as service, httpx2.Client(base_url=service.address, timeout=GUARD_S) as client:
        assert kept >= 2 and told(client.get(f"/jobs/{job}/events").text)[-1][1]["done"] == len(seeds)
        made = [client.get(f"/jobs/{job}/results/{number}").json()["scene"]["seed"] for number in seeds]
    assert made == list(seeds)
