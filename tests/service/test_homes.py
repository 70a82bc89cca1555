"""Homes are kept: the same tests for an SQLite file and a PostgreSQL server."""

from __future__ import annotations

import json
from threading import Barrier, Thread
from typing import Any

import pytest
import yaml
from starlette.testclient import TestClient

from service.app import ComposeApp
from solver.exchange import read_scene, write_scene
from tests.service.problems import entry_of
from tests.service.stores import KEYS, client_of

SCENE: dict[str, Any] = {"rooms": [{"id": "den", "type": "office", "width": 4.0, "depth": 3.0}]}
LARGER: dict[str, Any] = {"rooms": [*SCENE["rooms"], {"id": "hall", "type": "hallway", "x": 4.0, "width": 2.0, "depth": 3.0}]}
PNG = b"\x89PNG\r\n\x1a\n and more"


@pytest.fixture
def ann(app: ComposeApp) -> TestClient:
    client = client_of(app)
    for name in KEYS:
        for home in client_of(app, name).get("/homes?limit=100").json()["homes"]:
            assert client_of(app, name).delete(f"/homes/{home['id']}", headers={"If-Match": "*"}).status_code == 204
    return client


def saved(client: TestClient, **more: Any) -> dict[str, Any]:
    answer = client.post("/homes", json={"scene": SCENE, **more})
    assert answer.status_code == 201, answer.text
    assert answer.headers["location"] == f"/homes/{answer.json()['id']}"
    assert answer.headers["etag"] == '"1"'
    return dict(answer.json())


def test_a_home_is_kept_as_it_was_sent(ann: TestClient) -> None:
    head = saved(ann, name="Häuschen 🏠", notes="by the\nlake", tags=["small", "lake", "small"])
    answer = ann.get(f"/homes/{head['id']}")
    found = answer.json()
    assert {key: value for key, value in found.items() if key != "scene"} == head
    assert (found["name"], found["notes"], found["tags"], found["rooms"]) == ("Häuschen 🏠", "by the\nlake", ["small", "lake"], 1)
    assert found["scene"] == json.loads(json.dumps(write_scene(read_scene(SCENE))))
    assert (found["created"], found["revision"], found["version"], found["link"]) == (found["changed"], 1, 1, f"./?home={head['id']}")
    in_yaml = ann.get(f"/homes/{head['id']}", headers={"Accept": "application/yaml"})
    assert yaml.load(in_yaml.text, yaml.CSafeLoader) == found
    assert {answer.headers["etag"], in_yaml.headers["etag"]} == {'"1"', '"1-yaml"'}


def test_a_home_is_sent_as_yaml_too(ann: TestClient) -> None:
    body = "name: Den\nscene: {rooms: [{width: 3, depth: 3}]}\n"
    answer = ann.post("/homes", content=body, headers={"Content-Type": "application/yaml", "Accept": "application/yaml"})
    assert (answer.status_code, yaml.load(answer.text, yaml.CSafeLoader)["name"], answer.headers["etag"]) == (201, "Den", '"1-yaml"')


def test_two_editors_do_not_overwrite_each_other_unseen(ann: TestClient) -> None:
    path = f"/homes/{saved(ann)['id']}"
    read = ann.get(path).headers["etag"]
    first = ann.patch(path, json={"name": "First"}, headers={"If-Match": read})
    assert (first.status_code, first.headers["etag"]) == (200, '"2"')
    for method, body in (("PATCH", {"name": "Second"}), ("DELETE", None)):
        assert entry_of(ann.request(method, path, json=body, headers={"If-Match": read}), 412)["allowed"] == '"2"'
        assert entry_of(ann.request(method, path, json=body), 428)["field"] == "If-Match"
    assert ann.get(path).json()["name"] == "First"
    for said, name in (('W/"2"', "Third"), ('"3-yaml"', "Fourth"), ("*", "Fifth")):
        assert ann.patch(path, json={"name": name}, headers={"If-Match": said}).json()["name"] == name
    for said, status in (('"99", "5"', 304), ("*", 304), ('W/"5"', 304), ('"4","55"', 200), ('"5-yaml"', 200), ("5*", 200), ("", 200)):
        assert ann.get(path, headers={"If-None-Match": said}).status_code == status, said
    assert ann.get(path, headers=[("If-None-Match", '"99"'), ("If-None-Match", '"5"')]).status_code == 304
    for said in ('"99", "55"', "5", "5*", '"', "", "nonsense"):
        assert entry_of(ann.patch(path, json={"name": "No"}, headers={"If-Match": said}), 412)["allowed"] == '"5"', said
    for tags in (['"99", "5"'], ['"7"', '"6-yaml" , "9"'], ['"0",W/"7"']):
        assert ann.patch(path, json={"name": "Yes"}, headers=[("If-Match", tag) for tag in tags]).status_code == 200, tags


def test_of_many_changes_at_once_each_revision_has_one(app: ComposeApp, ann: TestClient) -> None:
    home, together = saved(ann)["id"], Barrier(6)
    statuses: list[int] = []

    def change(number: int) -> None:
        client = client_of(app)
        together.wait()
        for step in range(4):
            revision = client.get(f"/homes/{home}").headers["etag"]
            statuses.append(client.patch(f"/homes/{home}", json={"name": f"{number}.{step}"}, headers={"If-Match": revision}).status_code)

    threads = [Thread(target=change, args=(number,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(statuses) <= {200, 412} and len(statuses) == 24
    assert ann.get(f"/homes/{home}").json()["revision"] == 1 + statuses.count(200)


def test_scenes_become_versions_and_names_do_not(ann: TestClient) -> None:
    path = f"/homes/{saved(ann)['id']}"
    ann.patch(path, json={"name": "Other"}, headers={"If-Match": "*"})
    changed = ann.patch(path, json={"scene": LARGER, "tags": []}, headers={"If-Match": "*"}).json()
    assert (changed["version"], changed["revision"], changed["rooms"], changed["name"]) == (2, 3, 2, "Other")
    assert [one["number"] for one in ann.get(f"{path}/versions").json()["versions"]] == [2, 1]
    assert len(ann.get(f"{path}/versions/1").json()["scene"]["rooms"]) == 1
    assert ann.get(f"{path}/versions/2").json()["scene"] == ann.get(path).json()["scene"]
    for number in ("3", "0", "-1", "x", "9" * 30):
        assert entry_of(ann.get(f"{path}/versions/{number}"), 404)


def test_homes_are_found_by_words_and_tags(ann: TestClient) -> None:
    for name, notes, tags in (("Blue HOUSE", "", ["a"]), ("Red house", "100% wood_en", ["a", "b%"]), ("Straße", "", ["ab"])):
        saved(ann, name=name, notes=notes, tags=tags)
    found = {
        query: [home["name"] for home in ann.get(f"/homes?{query}").json()["homes"]]
        for query in (
            "search=house",
            "search=HOUSE+blue",
            "search=%25",
            "search=_",
            "search=STRASSE",
            "search=o%25d",
            "search=%5C",
            "tag=a",
            "tag=A",
        )
    } | {"both": [home["name"] for home in ann.get("/homes", params={"tag": ["a", "b%"], "search": "b%"}).json()["homes"]]}
    assert found == {
        "search=house": ["Red house", "Blue HOUSE"],
        "search=HOUSE+blue": ["Blue HOUSE"],
        "search=%25": ["Red house"],
        "search=_": ["Red house"],
        "search=STRASSE": ["Straße"],
        "search=o%25d": [],
        "search=%5C": [],
        "tag=a": ["Red house", "Blue HOUSE"],
        "tag=A": [],
        "both": ["Red house"],
    }


def test_homes_are_found_however_their_letters_were_typed(ann: TestClient) -> None:
    for name in ("İstanbul", "Cafe\u0301", "Küche"):
        saved(ann, name=name)
    sought = ("istanbul", "İSTANBUL", "CAF\u00c9", "cafe\u0301", "ku\u0308che", "I")
    found = {search: [home["name"] for home in ann.get("/homes", params={"search": search}).json()["homes"]] for search in sought}
    assert found == {
        "istanbul": ["İstanbul"],
        "İSTANBUL": ["İstanbul"],
        "CAF\u00c9": ["Cafe\u0301"],
        "cafe\u0301": ["Cafe\u0301"],
        "ku\u0308che": ["Küche"],
        "I": ["İstanbul"],
    }


def test_pages_hold_every_home_once(ann: TestClient) -> None:
    names = [saved(ann, name=f"{number}")["name"] for number in range(7)]
    pages: list[list[str]] = []
    after: str | None = ""
    while after is not None:
        answer = ann.get("/homes", params={"limit": 3, "after": after}).json()
        assert answer["total"] == 7
        pages.append([home["name"] for home in answer["homes"]])
        after = answer["after"]
    assert [name for page in pages for name in page] == names[::-1] and [len(page) for page in pages] == [3, 3, 1]


@pytest.mark.parametrize(
    "query",
    [
        "limit=0",
        "limit=101",
        "limit=x",
        "limit=-1",
        "after=x",
        "after=1-%00",
        "search=%00",
        "tag=",
        "tag=%0a",
        "sort=name",
        f"search={'a' * 201}",
    ],
)
def test_wrong_questions_are_refused(ann: TestClient, query: str) -> None:
    assert entry_of(ann.get(f"/homes?{query}"), 422)["field"].startswith(query.partition("=")[0])


@pytest.mark.parametrize(
    ("body", "field"),
    [
        ({}, "scene"),
        ({"scene": {"rooms": [{"width": -1}]}}, "scene.rooms[0].width"),
        ({"scene": SCENE, "name": ""}, "name"),
        ({"scene": SCENE, "name": " \u00a0"}, "name"),
        ({"scene": SCENE, "name": "a\nb"}, "name"),
        ({"scene": SCENE, "name": "a\x00b"}, "name"),
        ({"scene": SCENE, "name": "a" * 201}, "name"),
        ({"scene": SCENE, "notes": "\x00"}, "notes"),
        ({"scene": SCENE, "notes": "a" * 10_001}, "notes"),
        ({"scene": SCENE, "tags": ["a\nb"]}, "tags[0]"),
        ({"scene": SCENE, "tags": ["a"] * 21}, "tags"),
        ({"scene": SCENE, "owner": "ben"}, "owner"),
    ],
)
def test_what_is_no_home_is_not_kept(ann: TestClient, body: dict[str, Any], field: str) -> None:
    assert entry_of(ann.post("/homes", json=body), 422)["field"] == field
    assert ann.get("/homes").json()["total"] == 0
    path = f"/homes/{saved(ann)['id']}"
    assert entry_of(ann.patch(path, json=body, headers={"If-Match": "*"}), 422)["field"] in (field, "body")
    assert ann.get(path).json()["revision"] == 1


@pytest.mark.parametrize(
    "name", ["<img src=x onerror=alert(1)>", "'; DROP TABLE homes; --", "%s {0} \\ $1", "\u202eevil", "a" * 200, "ﷺ" * 200]
)
def test_hostile_names_stay_texts(ann: TestClient, name: str) -> None:
    home = saved(ann, name=name, tags=[name[:50]], notes=name)
    found = ann.get("/homes", params={"search": name[:20].split(maxsplit=1)[0], "tag": name[:50]}).json()["homes"]
    assert [(one["id"], one["name"], one["tags"], one["notes"]) for one in found] == [(home["id"], name, [name[:50]], name)]


def test_a_picture_is_given_or_drawn(ann: TestClient) -> None:
    path = f"/homes/{saved(ann)['id']}/picture"
    drawn = ann.get(path)
    assert (drawn.status_code, drawn.headers["content-type"]) == (200, "image/svg+xml")
    assert drawn.text.lstrip().startswith("<") and "sandbox" in drawn.headers["content-security-policy"]
    assert ann.put(path, content=PNG, headers={"Content-Type": "image/png"}).status_code == 204
    given = ann.get(path)
    assert (given.content, given.headers["content-type"]) == (PNG, "image/png")
    assert ann.get(path.removesuffix("/picture")).headers["etag"] == '"1"'
    refused = [("image/svg+xml", b"<svg/>"), ("text/html", PNG), ("image/jpeg", PNG), ("image/png", PNG + b"0" * 600_000)]
    assert [ann.put(path, content=body, headers={"Content-Type": kind}).status_code for kind, body in refused] == [415, 415, 422, 413]


def test_each_key_has_its_own_homes_alone(app: ComposeApp, ann: TestClient) -> None:
    """Every route there is, with the id of another's home, answers as it does to an id that there is not."""
    ben, home = client_of(app, "ben"), saved(ann, name="secret", tags=["secret"])["id"]
    before = ann.get(f"/homes/{home}").json()
    routes = [(path, method) for path, methods in app.openapi()["paths"].items() for method in methods if "{home}" in path]
    assert len(routes) >= 7
    for path, method in routes:
        answers = [
            ben.request(method, path.format(home=id_of, number=1), headers={"If-Match": said, **kind}, **body)
            for id_of in (home, "x" * len(home))
            for said in ("*", '"1"')
            for kind, body in (({"Content-Type": "image/png"}, {"content": PNG}), ({}, {"json": {"name": "mine"}}))
            if (method == "put") == bool(kind)
        ]
        assert {answer.status_code for answer in answers} == {404}, (path, method)
        assert len({answer.text.replace(home, "x" * len(home)) for answer in answers}) == 1, (path, method)
    listed = [
        ben.get("/homes", params=params).json() for params in ({}, {"search": "secret"}, {"tag": "secret"}, {"after": f"9{'0' * 15}-a"})
    ]
    assert [(one["homes"], one["total"]) for one in listed] == [([], 0)] * 4
    assert ann.get(f"/homes/{home}").json() == before
