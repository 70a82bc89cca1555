"""The Python client, of both kinds, asks the real service every call; refusals are told, and busy services asked again."""

from __future__ import annotations

import asyncio
import inspect
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx2
import pytest

from compose_homes import Request, generate, validate
from compose_homes.client import AsyncClient, Client, ServiceCall, ServiceRefusal, calls
from solver.exchange import write_scene
from tests.browser.service_process import running
from tests.service import apart

KEY = "the-key-of-the-client"
REQUEST = Request(seed=3, width=6.0, depth=5.0)
PLAN: dict[str, Any] = {"rooms": [{"id": "den", "type": "office", "width": 4.0, "depth": 3.0}]}
HOME = generate(REQUEST)
PIECE = HOME.scene.rooms[0].furniture[0].id

CALLS: dict[str, ServiceCall[Any]] = {
    "generate": calls.generate(REQUEST),
    "reroll": calls.reroll(HOME.scene, [HOME.scene.rooms[0].id], 5),
    "restyle": calls.restyle(HOME.scene, style="rustic"),
    "furnish": calls.furnish(PLAN, seed=2),
    "fix": calls.fix(HOME.scene, locked=[PIECE]),
    "place": calls.place({"width": 3.0, "depth": 3.0}, [{"name": "bookshelf"}], alternatives=2),
    "validate": calls.validate(HOME.scene, report=True),
    "view": calls.view(HOME.scene),
    "explain": calls.explain(HOME.scene, PIECE),
    "floor": calls.floor(HOME.scene),
    "import": calls.import_plan(json.dumps(write_scene(HOME.scene)).encode()),
    "export": calls.export(HOME.scene, "csv"),
    "catalog": calls.catalog(),
}


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """A service that wants a key."""
    with running(0, "--keys", f"ann={KEY}") as service:
        yield service.address


@pytest.fixture(scope="module")
def client(address: str) -> Iterator[Client]:
    with Client(address, KEY) as client:
        yield client


@pytest.mark.parametrize("name", CALLS)
def test_every_call_is_answered_by_its_type(client: Client, name: str) -> None:
    answer = client.ask(CALLS[name])
    assert isinstance(answer, bytes | dict) or type(answer).__dataclass_fields__
    assert answer


def test_an_answer_is_what_the_library_makes(client: Client) -> None:
    assert client.ask(CALLS["generate"]).scene == HOME.scene
    assert client.ask(CALLS["validate"]).issues == validate(HOME.scene)
    assert client.ask(CALLS["import"]).scene.rooms == HOME.scene.rooms


def test_homes_are_kept_changed_and_removed(client: Client) -> None:
    head = client.ask(calls.save_home(HOME.scene, "By the lake", tags=["small"]))
    assert client.ask(calls.home(head.id)).scene == HOME.scene
    changed = client.ask(calls.change_home(head, name="By the sea", scene=PLAN))
    assert (changed.name, changed.version, changed.revision) == ("By the sea", 2, 2)
    assert [one.number for one in client.ask(calls.home_versions(head.id)).versions] == [2, 1]
    with pytest.raises(ServiceRefusal) as refused:
        client.ask(calls.remove_home(head))
    assert (refused.value.status, refused.value.errors[0]["field"]) == (412, "If-Match")
    assert [one.id for one in client.ask(calls.list_homes("SEA", ["small"])).homes] == [head.id]
    client.ask(calls.remove_home(changed))
    assert client.ask(calls.list_homes()).total == 0


def test_a_job_is_followed_to_its_end_and_removed(client: Client) -> None:
    job = client.ask(calls.add_job("generate", {"width": 5.0, "depth": 4.0}, seeds=[4, 5]))
    assert (job.call, job.count) == ("generate", 2)
    told = list(client.follow(job.id))
    assert (told[-1].state, told[-1].done, told[-1].refused) == ("done", 2, 0)
    assert [client.ask(calls.job_result(job.id, number))["scene"]["seed"] for number in range(2)] == [4, 5]
    assert client.ask(calls.job(job.id)) == told[-1]
    assert [one.id for one in client.ask(calls.list_jobs()).jobs] == [job.id]
    client.ask(calls.remove_job(job.id))
    assert client.ask(calls.list_jobs()).jobs == ()
    with pytest.raises(ServiceRefusal) as refused:
        next(client.follow(job.id))
    assert refused.value.status == 404


def test_a_job_is_followed_without_waiting_too(address: str) -> None:
    async def follow() -> list[str]:
        async with AsyncClient(address, KEY) as client:
            job = await client.ask(calls.add_job("fix", {"scene": PLAN}))
            states = [one.state async for one in client.follow(job.id)]
            await client.ask(calls.remove_job(job.id))
            return states

    assert apart.run(follow)[-1] == "done"


def test_calls_are_asked_at_once(address: str) -> None:
    async def ask() -> list[Any]:
        async with AsyncClient(address, KEY) as client:
            return await asyncio.gather(*(client.ask(calls.generate({"seed": seed, "width": 5, "depth": 4})) for seed in range(4)))

    assert [made.scene.seed for made in apart.run(ask)] == [0, 1, 2, 3]


def test_a_refusal_is_told(client: Client, address: str) -> None:
    with pytest.raises(ServiceRefusal, match="seed: is -1") as refused:
        client.ask(calls.generate({"seed": -1}))
    assert (refused.value.status, refused.value.errors[0]["field"]) == (422, "seed")
    with Client(address) as stranger, pytest.raises(ServiceRefusal) as unknown:
        stranger.ask(calls.catalog())
    assert unknown.value.status == 401


def test_a_busy_service_is_asked_again_and_others_are_not() -> None:
    asked: list[int] = []

    def answers(*statuses: int) -> httpx2.MockTransport:
        left = list(statuses)

        def answer(_: httpx2.Request) -> httpx2.Response:
            asked.append(left.pop(0))
            return httpx2.Response(asked[-1], headers={"Retry-After": "0"}, json={} if asked[-1] == 200 else {"title": "t", "detail": "d"})

        return httpx2.MockTransport(answer)

    assert Client("http://a", transport=answers(503, 429, 200)).ask(calls.catalog()) == {}
    for statuses in ((503, 503, 503), (500,), (422,)):
        with pytest.raises(ServiceRefusal):
            Client("http://a", transport=answers(*statuses)).ask(calls.catalog())
    assert asked == [503, 429, 200, 503, 503, 503, 500, 422]


def test_the_typescript_client_has_the_same_functions() -> None:
    text = (Path(__file__).parents[2] / "web" / "client" / "index.ts").read_text()
    theirs = set(re.findall(r"^  (?:async )?\*?(\w+)(?:<\w+>)?\(.*\): (?:Promise|AsyncGenerator)<", text, re.MULTILINE))
    own = [name for name, one in inspect.getmembers(calls, inspect.isfunction) if one.__module__ == calls.__name__ and name[0] != "_"]
    named = {re.sub(r"_(.)", lambda found: found[1].upper(), name) for name in own if name != "job_told"}
    assert theirs == named - {"export"} | {"exportScene", "followJob"}
