"""Calls run beside the service: a bounded number at once, each in bounded time and memory."""

from __future__ import annotations

import math
import os
import socket
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import anyio
import pytest
from starlette.requests import ClientDisconnect
from starlette.responses import Response
from starlette.testclient import TestClient
from starlette.types import Message

from catalogs import load_catalogs
from service import calls, workers
from service.app import ComposeApp
from service.packed_catalogs import mark_of, packed
from service.problems import Busy, TooLong
from service.server import listening
from service.service_settings import Settings
from service.work import Failure, Job, do
from service.workers import Workers, unless_left
from tests.service import apart, heavy
from tests.service.problems import entry_of, problem_of

SETTINGS = Settings(waiting=1, request_seconds=heavy.PATIENCE_S)
RUNNING = SETTINGS.running()
LIGHT = SETTINGS.light_processes


class Limit:
    """Stands in for the workers' limit of time: it passes when a test says so, whatever the clock says."""

    def __init__(self) -> None:
        self.scopes: list[anyio.CancelScope] = []

    @contextmanager
    def after(self, seconds: float) -> Iterator[None]:
        assert seconds == SETTINGS.request_seconds
        with anyio.fail_after(math.inf) as scope:
            self.scopes.append(scope)
            yield

    def passes(self) -> None:
        for scope in self.scopes:
            scope.deadline = -math.inf


@pytest.fixture
def limit(monkeypatch: pytest.MonkeyPatch) -> Limit:
    """The limit of calls that run from now on."""
    limit = Limit()
    monkeypatch.setattr(workers, "fail_after", limit.after)
    return limit


def app_of(client: TestClient) -> ComposeApp:
    assert isinstance(client.app, ComposeApp)
    return client.app


async def until(condition: Callable[[], bool]) -> None:
    with anyio.fail_after(heavy.PATIENCE_S):
        while not condition():
            await anyio.sleep(0.01)


def is_alive(process: int) -> bool:
    return Path(f"/proc/{process}").exists() if Path("/proc/self").exists() else not _is_gone(process)


def _is_gone(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    return False


def test_as_many_run_as_may_the_next_waits_and_one_more_is_turned_away(tmp_path: Path) -> None:
    processes: list[int] = []

    async def scene() -> None:
        bench = Workers(SETTINGS)

        async def call() -> None:
            processes.append(await bench.run(heavy.process, str(tmp_path)))

        async with anyio.create_task_group() as group:
            for _ in range(RUNNING + 1):
                group.start_soon(call)
            await until(lambda: len(list(tmp_path.glob("inside-*"))) == RUNNING)
            with pytest.raises(Busy):
                await bench.run(heavy.process, str(tmp_path))
            (tmp_path / "gate").touch()

    apart.run(scene)
    assert len(processes) == RUNNING + 1
    assert len(set(processes)) == RUNNING
    assert os.getpid() not in processes


def test_what_takes_too_long_is_ended_and_the_next_call_runs(tmp_path: Path, limit: Limit) -> None:
    note = tmp_path / "process"

    async def end_it_once_it_runs() -> None:
        await until(lambda: note.exists() and bool(note.read_text()))
        limit.passes()

    async def scene() -> None:
        bench = Workers(SETTINGS)
        (tmp_path / "gate").touch()
        first = await bench.run(heavy.process, str(tmp_path))
        async with anyio.create_task_group() as group:
            group.start_soon(end_it_once_it_runs)
            with pytest.raises(TooLong, match=f"longer than {SETTINGS.request_seconds:g} s"):
                await bench.run(heavy.endless, str(note))
        assert await bench.run(heavy.process, str(tmp_path)) != first == int(note.read_text())

    apart.run(scene)
    assert not is_alive(int(note.read_text()))


def test_large_bodies_and_answers_arrive_whole_while_the_loop_goes_on() -> None:
    async def scene() -> None:
        bench, content = Workers(SETTINGS), bytes(range(256)) * 40_000
        async with anyio.create_task_group() as group:

            async def ask() -> None:
                assert await bench.run(heavy.doubled, content) == 2 * content

            for _ in range(RUNNING):
                group.start_soon(ask)
        assert await bench.run(heavy.doubled, b"") == b""

    apart.run(scene)


def test_who_leaves_while_a_process_is_started_leaves_the_next_his_process(tmp_path: Path) -> None:
    async def scene() -> None:
        bench, caller = Workers(SETTINGS), Caller()
        caller.left.set()
        with pytest.raises(ClientDisconnect):
            await unless_left(caller.receive, bench.run(heavy.endless, str(tmp_path / "note")))
        (tmp_path / "gate").touch()
        processes = {await bench.run(heavy.process, str(tmp_path)) for _ in range(3)}
        assert len(processes) == 1 and not bench.heavy.coming and len(bench.heavy.idle) == 1

    apart.run(scene)
    assert not (tmp_path / "note").exists()


def test_memory_is_bounded() -> None:
    async def scene() -> str:
        return await Workers(SETTINGS).run(heavy.hungry)

    assert apart.run(scene) == "200 refused"


def test_the_service_answers_while_all_workers_are_busy(client: TestClient, limit: Limit, tmp_path: Path) -> None:
    assert client.portal
    with ThreadPoolExecutor(RUNNING) as callers, pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.app.do_alone", heavy.held)
        running = [callers.submit(client.post, "/generate", content=str(tmp_path)) for _ in range(RUNNING)]
        apart.run(until, lambda: len(list(tmp_path.glob("inside-*"))) == RUNNING)
        assert client.get("/healthz").status_code == 200
        assert client.get("/docs").status_code == 200
        assert not any(call.done() for call in running)
        client.portal.call(limit.passes)
        for call in running:
            assert f"{SETTINGS.request_seconds:g} s" in entry_of(call.result(), 504)["problem"]
    assert client.post("/view", json={"scene": {"rooms": []}}).status_code == 200


def test_a_busy_service_says_when_to_come_back(client: TestClient, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    bench = app_of(client).workers
    monkeypatch.setattr(bench, "light", bench.light._replace(waiting=0))
    monkeypatch.setattr("service.app.do_alone", heavy.held)
    with ThreadPoolExecutor(LIGHT) as callers:
        running = [callers.submit(client.post, "/view", content=str(tmp_path)) for _ in range(LIGHT)]
        apart.run(until, lambda: len(list(tmp_path.glob("inside-*"))) == LIGHT)
        refused = client.post("/view", content=str(tmp_path))
        (tmp_path / "gate").touch()
        assert [call.result().status_code for call in running] == [400] * LIGHT
    assert entry_of(refused, 503)["field"] == "service"
    assert int(refused.headers["retry-after"]) >= 1


def test_what_is_quickly_done_does_not_wait_behind_what_is_not(client: TestClient, tmp_path: Path) -> None:
    both = RUNNING + 2
    with ThreadPoolExecutor(both) as callers, pytest.MonkeyPatch.context() as patch:
        patch.setattr("service.app.do_alone", heavy.held)
        running = [callers.submit(client.post, "/generate", content=str(tmp_path)) for _ in range(both)]
        apart.run(until, lambda: app_of(client).workers.heavy.slots.statistics().tasks_waiting == 2)
        patch.undo()
        assert client.post("/view", json={"scene": {"rooms": []}}).status_code == 200
        assert not any(call.done() for call in running)
        (tmp_path / "gate").touch()
        for call in running:
            call.result()


def test_a_large_scene_waits_with_what_is_not_quickly_done(client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    lanes: list[bool] = []

    async def noted(bench: Workers, done: Any, job: Job, is_light: bool) -> Response:
        lanes.append(is_light)
        return Response()

    monkeypatch.setattr(Workers, "run", noted)
    limit = app_of(client).settings.light_bytes
    for size in (limit, limit + 1):
        client.post("/view", content=b" " * size)
    client.post("/fix", content=b"")
    assert lanes == [True, False, False]


class Caller:
    """A caller of whom it is told when he leaves."""

    def __init__(self) -> None:
        self.left = anyio.Event()

    async def receive(self) -> Message:
        await self.left.wait()
        return {"type": "http.disconnect"}


def test_who_leaves_ends_his_call_while_it_runs(tmp_path: Path) -> None:
    note = tmp_path / "process"

    async def scene() -> None:
        bench, caller = Workers(SETTINGS), Caller()

        async def leave_once_it_runs() -> None:
            await until(lambda: note.exists() and bool(note.read_text()))
            caller.left.set()

        async with anyio.create_task_group() as group:
            group.start_soon(leave_once_it_runs)
            with pytest.raises(ClientDisconnect):
                await unless_left(caller.receive, bench.run(heavy.endless, str(note)))
        assert bench.heavy.slots.statistics().borrowed_tokens == 0

    apart.run(scene)
    assert not is_alive(int(note.read_text()))


def test_a_call_that_is_abandoned_costs_only_its_own_process_which_is_replaced_at_once(tmp_path: Path) -> None:
    note = tmp_path / "process"

    async def scene() -> None:
        bench, caller = Workers(SETTINGS), Caller()
        await bench.start()
        light, nice = await bench.run(heavy.niceness, is_light=True)
        assert nice == os.nice(0)

        async def leave_once_it_runs() -> None:
            await until(lambda: note.exists() and bool(note.read_text()))
            assert len(bench.heavy.idle) == RUNNING - 1
            caller.left.set()

        async with anyio.create_task_group() as group:
            group.start_soon(leave_once_it_runs)
            with pytest.raises(ClientDisconnect):
                await unless_left(caller.receive, bench.run(heavy.endless, str(note)))
        await until(lambda: len(bench.heavy.idle) == RUNNING)
        process, nice = await bench.run(heavy.niceness)
        assert (process != int(note.read_text()), nice) == (True, min(19, os.nice(0) + workers.GIVES_WAY))
        assert len(bench.light.idle) == LIGHT and (await bench.run(heavy.niceness, is_light=True))[0] == light
        assert bench.restarts == 0

    apart.run(scene)


def test_who_leaves_while_he_waits_leaves_the_line(tmp_path: Path) -> None:
    async def scene() -> None:
        bench, caller = Workers(SETTINGS), Caller()
        async with anyio.create_task_group() as group:
            for _ in range(RUNNING):
                group.start_soon(bench.run, heavy.process, str(tmp_path))
            await until(lambda: len(list(tmp_path.glob("inside-*"))) == RUNNING)

            async def leave_once_it_waits() -> None:
                await until(lambda: bench.heavy.slots.statistics().tasks_waiting == 1)
                caller.left.set()

            group.start_soon(leave_once_it_waits)
            with pytest.raises(ClientDisconnect):
                await unless_left(caller.receive, bench.run(heavy.process, str(tmp_path)))
            assert bench.heavy.slots.statistics().tasks_waiting == 0
            (tmp_path / "gate").touch()

    apart.run(scene)


def test_a_refusal_reaches_who_stays() -> None:
    async def refused() -> None:
        raise Busy("service", "is busy", "later")

    async def scene() -> None:
        with pytest.raises(Busy):
            await unless_left(Caller().receive, refused())

    apart.run(scene)


def test_a_failure_says_nothing_of_its_insides(
    client: TestClient, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr("service.app.do_alone", heavy.fails)
    answer = client.post("/generate", json={})
    assert answer.status_code == 500
    assert problem_of(answer)["errors"] == []
    assert "secret" not in answer.text
    assert "content-security-policy" in answer.headers
    logged = [record for record in caplog.records if record.exc_info and "POST /generate failed" in record.getMessage()]
    assert ["secret insides" in str(record.exc_info) for record in logged] == [True]


def job(body: bytes) -> Job:
    return Job("view", body, "json", "json", mark_of(packed(load_catalogs())))


def test_what_is_written_is_sent_at_once() -> None:
    with listening("127.0.0.1", 0) as listener, socket.create_connection(listener.getsockname()):
        accepted, _ = listener.accept()
        with accepted:
            assert accepted.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) != 0


def test_a_fault_of_ours_is_told_from_a_fault_of_the_request(monkeypatch: pytest.MonkeyPatch) -> None:
    def breaks(*_: object) -> dict[str, object]:
        raise ZeroDivisionError("ours")

    def swells(*_: object) -> dict[str, object]:
        raise MemoryError

    refused = do(job(b"[]"))
    assert isinstance(refused, Response)
    assert refused.status_code == 422
    monkeypatch.setattr(calls, "CALLS", {"view": breaks})
    failed = do(job(b"{}"))
    assert isinstance(failed, Failure)
    assert "ZeroDivisionError: ours" in failed.trace
    monkeypatch.setattr(calls, "CALLS", {"view": swells})
    refused = do(job(b"{}"))
    assert isinstance(refused, Response)
    assert refused.status_code == 422
    assert b"2 GB" in bytes(refused.body)
