"""Processes that are killed, as for want of memory: replaced, or their callers told to come back; nobody waits for ever new ones."""

from __future__ import annotations

import asyncio
import os
import signal
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from service import workers
from service.app import ComposeApp
from service.problems import Busy, ProcessLost
from service.service_settings import Settings
from service.workers import Workers
from tests.service import apart, heavy
from tests.service.problems import entry_of
from tests.service.stores import client_of
from tests.service.test_jobs import told
from tests.service.test_workers import LIGHT, RUNNING, SETTINGS, is_alive, until


def test_a_process_that_dies_is_replaced_once(tmp_path: Path) -> None:
    async def scene() -> None:
        bench = Workers(SETTINGS)
        assert await bench.run(heavy.dies, str(tmp_path), 1) == 2
        assert bench.restarts == 1
        with pytest.raises(ProcessLost):
            await bench.run(heavy.dies, str(tmp_path), 9)
        assert bench.restarts == 1 + workers.TRIES

    apart.run(scene)


def test_a_process_that_has_grown_makes_way_for_another_and_no_other_does() -> None:
    """A library that never gives back all memory would have it end in refusals of calls that take little."""

    async def scene() -> None:
        bench = Workers(Settings(processes=1))
        first = await bench.run(heavy.grows, 1 << 20)
        assert await bench.run(heavy.grows, workers.GROWN) == first
        assert bench.restarts == 1, "known with its answer: no call is lost to a process that is about to end"
        assert await bench.run(os.getpid) != first
        assert bench.restarts == 1

    apart.run(scene)


def test_processes_that_die_or_cannot_be_had_while_they_are_started_are_not_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One that would live comes after more than a call is to wait for."""
    most = RUNNING + LIGHT + 3 * workers.TRIES

    async def scene() -> None:
        bench = Workers(SETTINGS, heavy.dies, str(tmp_path), most)
        await bench.start()
        with pytest.raises(ProcessLost):
            await bench.run(os.getpid)
        assert len(list(tmp_path.iterdir())) < most

        def refuse(_: int) -> None:
            raise BlockingIOError

        other = Workers(SETTINGS)
        monkeypatch.setattr(workers, "WorkerProcess", refuse)
        with pytest.raises(ProcessLost):
            await other.run(os.getpid)
        monkeypatch.undo()
        assert await other.run(os.getpid) != os.getpid()

    apart.run(scene)


def test_who_has_no_processes_is_not_ready_and_begins_to_start_some(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: int) -> None:
        raise BlockingIOError

    async def scene() -> None:
        bench = Workers(SETTINGS)
        monkeypatch.setattr(workers, "WorkerProcess", refuse)
        await bench.start()
        with pytest.raises(Busy):
            bench.check()
        await asyncio.gather(*bench.heavy.coming)
        monkeypatch.undo()
        for lane in (bench.heavy, bench.light):
            with pytest.raises(Busy):
                bench.check()
            await asyncio.gather(*lane.coming)
        bench.check()

    apart.run(scene)


@pytest.mark.parametrize(("path", "work"), [("/generate", "service.app.do_alone"), ("/homes", "service.homes.read_sent_home")])
def test_who_lost_processes_is_told_to_come_back(path: str, work: str, client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(work, heavy.killed)
    refused = client.post(path, json={})
    assert (entry_of(refused, 503)["field"], int(refused.headers["retry-after"]) >= 1) == ("service", True)
    monkeypatch.undo()
    assert client.post("/view", json={"scene": {"rooms": []}}).status_code == 200


def test_processes_that_died_while_they_were_idle_are_replaced_before_they_are_asked() -> None:
    async def scene() -> None:
        bench = Workers(SETTINGS)
        await bench.start()
        told = [await process.ask(os.getpid, ()) for process in bench.light.idle]
        idle = [one for one in told if isinstance(one, int)]
        assert len(idle) == LIGHT > 1
        for process in idle:
            os.kill(process, signal.SIGKILL)
        await until(lambda: not any(map(is_alive, idle)))
        assert await bench.run(os.getpid, is_light=True) not in idle
        assert bench.restarts == LIGHT

    apart.run(scene)


def test_a_call_that_loses_its_processes_is_told_of_and_the_next_made(app: ComposeApp, monkeypatch: pytest.MonkeyPatch) -> None:
    ann = client_of(app)
    monkeypatch.setattr("service.app.do_alone", heavy.killed)
    job = ann.post("/jobs", json={"call": "generate", "body": {}, "seeds": [1, 2]}).json()["id"]
    last = told(ann.get(f"/jobs/{job}/events").text)[-1]
    assert (last[0], last[1]["done"], last[1]["refused"]) == ("done", 2, 2)
    assert ann.get(f"/jobs/{job}/results/1").headers["x-call-status"] == "503"
