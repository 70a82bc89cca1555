"""Bad input gets a problem document that names the field and what is allowed; never a 500, never a long wait."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest
from starlette.testclient import TestClient

from service.wire import BODY_LIMIT, DRAIN_LIMIT
from solver.export_formats import EXPORTERS
from tests.every import every
from tests.service.problems import entry_of, problem_of

YAML = {"content-type": "application/yaml"}
EXPORTS = ["/export/json", "/export/yaml"]
OF_SCENES = ["/fix", "/validate", "/view", "/floor", *EXPORTS]
POSTS = ["/generate", "/place", *OF_SCENES]

REQUESTS = [
    ({"width": "wide"}, "width", "2 to 1000"),
    ({"width": None, "depth": True}, "depth", "2 to 1000"),
    ({"width": [20]}, "width", "2 to 1000"),
    ({"width": 1e9}, "width", "2 to 1000"),
    ({"width": -3}, "width", "2 to 1000"),
    ({"depth": 0}, "depth", "2 to 1000"),
    ({"max_depth": 60000}, "max_depth", "0 to 16"),
    ({"max_depth": 2.5}, "max_depth", "0 to 16"),
    ({"min_room_size": 1.0}, "min_room_size", "1.5 to 50"),
    ({"minRoomSize": 1000}, "min_room_size", "1.5 to 50"),
    ({"min_room_size": 16, "width": 20, "depth": 15}, "min_room_size", "1.5 to 15"),
    ({"seed": -1}, "seed", "0 to 9007199254740991"),
    ({"seed": 2**53}, "seed", "0 to 9007199254740991"),
    ({"seed": "42"}, "seed", "0 to 9007199254740991"),
    ({"use_spine": "yes"}, "use_spine", "true, false"),
    ({"outdoor": 1}, "outdoor", "true, false"),
    ({"robot_width": 0}, "robot_width", "0.1 to 2"),
    ({"wall_thickness": 0.3}, "wall_thickness", "0.05 to 0.24"),
    ({"outer_wall_thickness": 0.7}, "outer_wall_thickness", "0.05 to 0.6"),
    ({"outer_wall_thickness": 0.09}, "outer_wall_thickness", "at least 0.1"),
    ({"wall_thickness": 0.2, "outerWallThickness": 0.15}, "outer_wall_thickness", "at least 0.2"),
    ({"bedrooms": 3}, "bedrooms", "force_types"),
    ({"useOllama": True}, "useOllama", "use_spine"),
    ({"minRoomSize": 3, "min_room_size": 3}, "min_room_size", "one of the two"),
    ({"force_types": ["kitchen"]}, "force_types", "index"),
    ({"force_types": {"first": "kitchen"}}, "force_types", "0, 1, 2"),
    ({"force_types": {"0": 7}}, "force_types[0]", "text"),
    ({"seed": 1, "force_types": {"0": "throne_room"}}, "force_types", "kitchen"),
    ({"seed": 1, "force_types": {"4000": "kitchen"}}, "force_types", "0"),
    ({"program": 3}, "program", "preset"),
    ({"program": {"bedrooms": "3"}}, "program.bedrooms", "0 to 12"),
    ({"program": {"bedrooms": 13}}, "program.bedrooms", "0 to 12"),
    ({"program": {"bedrooms": 1.5}}, "program.bedrooms", "0 to 12"),
    ({"area": 3}, "area", "15 to 1000"),
    ({"style": 7}, "style", "text"),
    ({"reroll": ["kitchen_1"]}, "scene", "a scene"),
]


@every(("body", "field", "allowed"), REQUESTS)
def test_a_wrong_request_names_its_field(client: TestClient, body: dict[str, Any], field: str, allowed: str) -> None:
    entry = entry_of(client.post("/generate", json=body), 422)
    assert entry["field"].startswith(field)
    assert allowed in entry["allowed"]


def test_every_wrong_field_is_named_at_once(client: TestClient) -> None:
    body = {"width": "wide", "depth": 1, "robot_width": 9, "program": {"bedrooms": 99, "offices": -1}, "style": 3, "sauna": 1}
    named = [entry["field"] for entry in client.post("/generate", json=body).json()["errors"]]
    assert sorted(named) == ["depth", "program.bedrooms", "program.offices", "robot_width", "sauna", "style", "width"]
    rooms = [{"width": -1, "depth": 2} for _ in range(500)]
    assert len(client.post("/validate", json={"scene": {"rooms": rooms}}).json()["errors"]) == 20


UNFINITE = [b"NaN", b"Infinity", b"-Infinity", b"1e400", b"-1e400", b"1" + b"0" * 400]


@every("number", UNFINITE)
@every("key", ["seed", "width", "min_room_size", "max_depth", "robot_width"])
def test_numbers_beyond_all_bounds_name_their_field(client: TestClient, key: str, number: bytes) -> None:
    entry = entry_of(client.post("/generate", content=b'{"%s": %s}' % (key.encode(), number)), 422)
    assert entry["field"] == key
    assert " to " in entry["allowed"]


@pytest.mark.parametrize("word", [".nan", ".inf", "-.inf", "1e400"])
def test_yaml_numbers_beyond_all_bounds_name_their_field(client: TestClient, word: str) -> None:
    assert entry_of(client.post("/generate", content=f"width: {word}\n", headers=YAML), 422)["field"] == "width"


UNREADABLE = {
    "empty": b"",
    "blank": b" \n\t ",
    "not json": b"hello there",
    "cut off": b'{"seed": 4',
    "single quotes": b"{'seed': 42}",
    "two documents": b'{"seed": 1} {"seed": 2}',
    "key twice": b'{"seed": 1, "seed": 2}',
    "deep lists": b"[" * 5000 + b"]" * 5000,
    "deep objects": b'{"scene":' * 5000 + b"1" + b"}" * 5000,
    "open lists": b"[" * 5000,
    "ten thousand digits": b'{"seed": 1' + b"0" * 10_000 + b"}",
    "not utf-8": b'{"seed": "\xff\xfe"}',
    "utf-16": '{"seed": 42}'.encode("utf-16"),
    "half a surrogate": b'{"scene": {"rooms": [{"id": "\\ud800", "width": 3, "depth": 3}]}}',
    "zero bytes": b"\x00" * 100,
}


@every("call", POSTS)
@every("kind", UNREADABLE)
def test_what_is_no_json_document_is_refused(client: TestClient, call: str, kind: str) -> None:
    if call == "/generate" and kind in ("empty", "blank"):
        return  # asks for all defaults
    entry = entry_of(client.post(call, content=UNREADABLE[kind], headers={"content-type": "application/json"}), 400)
    assert entry["field"] == "body"
    assert "JSON" in entry["allowed"]


BOMB = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{new}: &{new} [{', '.join([f'*{old}'] * 10)}]\n" for old, new in zip("abcdefghijkl", "bcdefghijklm", strict=True)
)
UNREADABLE_YAML = {
    "broken": "width: [20\ndepth: 15",
    "tab": "width:\n\t- 3",
    "key twice": "seed: 1\nseed: 2\n",
    "deep": "[" * 5000,
    "deep blocks": "".join(f"{' ' * depth}a:\n" for depth in range(300)),
    "aliases": BOMB,
    "endless": "a: &a [*a]",
    "unknown alias": "width: *nothing",
    "python tag": "width: !!python/object/apply:os.system ['true']",
    "list as a key": "? [1, 2]\n: 3",
    "two documents": "seed: 1\n---\nseed: 2\n",
    "only a comment": "# nothing",
    "control characters": "width: \x07",
}


@every("call", POSTS)
@every("kind", UNREADABLE_YAML)
def test_what_is_no_yaml_document_is_refused(client: TestClient, call: str, kind: str) -> None:
    entry = entry_of(client.post(call, content=UNREADABLE_YAML[kind], headers=YAML), 400)
    assert entry["field"] == "body"


def test_yaml_that_does_not_say_so_is_told_how(client: TestClient) -> None:
    for headers in ({"content-type": "application/json"}, {"content-type": "application/x-www-form-urlencoded"}):
        entry = entry_of(client.post("/generate", content="width: wide", headers=headers), 400)
        assert (entry["field"], "application/yaml" in entry["allowed"]) == ("body", True)
    assert entry_of(client.post("/generate", content="width: wide", headers=YAML), 422)["field"] == "width"


@every("call", POSTS)
@every("body", [[], [{}], 3, "house", True, None, 1.5])
def test_a_body_that_is_no_object_is_refused(client: TestClient, call: str, body: object) -> None:
    entry = entry_of(client.post(call, content=json.dumps(body)), 422)
    assert entry["field"] == "body"
    assert entry["allowed"].startswith("an object with ")


@pytest.mark.parametrize("call", OF_SCENES)
def test_a_body_without_a_scene_or_with_more_is_refused(client: TestClient, scene: dict[str, Any], call: str) -> None:
    assert entry_of(client.post(call, json={}), 422)["field"] == "scene"
    entry = entry_of(client.post(call, json={"scene": scene, "sceen": 1}), 422)
    assert entry["field"] == "sceen"
    assert "scene" in entry["allowed"]
    if call not in EXPORTS:
        entry = entry_of(client.post(call, json=scene), 422)
        assert entry["field"] == "scene"
        assert "a scene" in entry["allowed"]


def test_unknown_ids_are_named(client: TestClient, scene: dict[str, Any]) -> None:
    piece = next(body["id"] for room in scene["rooms"] for body in room["furniture"])
    for key in ("locked", "moved"):
        entry = entry_of(client.post("/fix", json={"scene": scene, key: [piece, "throne_1"]}), 422)
        assert entry["field"] == f"{key}[1]"
        assert "throne_1" in entry["problem"]
        assert piece in entry["allowed"]
    entry = entry_of(client.post("/generate", json={"scene": scene, "reroll": ["attic"]}), 422)
    assert entry["field"] == "reroll[0]"
    assert "attic" in entry["problem"]
    assert scene["rooms"][0]["id"] in entry["allowed"]


@pytest.mark.parametrize("given", ["sofa", 3, {"a": 1}, [3], [None], [["a"]], True])
@pytest.mark.parametrize("key", ["locked", "moved"])
def test_ids_are_a_list_of_texts(client: TestClient, scene: dict[str, Any], key: str, given: object) -> None:
    assert entry_of(client.post("/fix", json={"scene": scene, key: given}), 422)["field"].startswith(key)


@pytest.mark.parametrize("given", ["delete", 3, ["report"], {}])
def test_on_conflict_is_one_of_two_words(client: TestClient, scene: dict[str, Any], given: object) -> None:
    entry = entry_of(client.post("/fix", json={"scene": scene, "on_conflict": given}), 422)
    assert (entry["field"], entry["allowed"]) == ("on_conflict", "report, remove")


def test_reroll_takes_a_scene_rooms_and_a_seed(client: TestClient, scene: dict[str, Any]) -> None:
    room = scene["rooms"][0]["id"]
    refused = [
        ({"scene": scene}, "reroll"),
        ({"scene": scene, "reroll": []}, "reroll"),
        ({"scene": scene, "reroll": room}, "reroll"),
        ({"scene": scene, "reroll": [room], "width": 3}, "width"),
        ({"scene": scene, "reroll": [room], "seed": -1}, "seed"),
        ({"scene": scene, "reroll": [room], "seed": "7"}, "seed"),
        ({"scene": [], "reroll": [room]}, "scene"),
    ]
    for body, field in refused:
        assert entry_of(client.post("/generate", json=body), 422)["field"] == field


def test_a_room_that_cannot_be_furnished_around_what_is_locked_is_refused(client: TestClient) -> None:
    wall = {"id": "block", "name": "wall", "x": 2.0, "z": 2.0, "width": 4.0, "depth": 3.0, "height": 2.0, "locked": True}
    scene = {"rooms": [{"id": "r", "type": "bedroom", "width": 4.0, "depth": 4.0, "furniture": [wall]}]}
    entry = entry_of(client.post("/generate", json={"scene": scene, "reroll": ["r"]}), 422)
    assert entry["field"] == "reroll[0]"
    assert "block" in entry["problem"] and "unlock" in entry["allowed"]


BODY = {"id": "sofa_1", "name": "sofa", "x": 1.0, "z": 1.0, "width": 2.0, "depth": 0.9, "height": 0.8}
ROOM = {"id": "salon", "width": 4.0, "depth": 4.0, "furniture": [BODY]}
WRONG_SCENES: list[tuple[Any, str]] = [
    ([], "scene"),
    ("house", "scene"),
    (None, "scene"),
    ({"rooms": {}}, "scene.rooms"),
    ({"rooms": [7]}, "scene.rooms[0]"),
    ({"rooms": [{"id": "salon"}]}, "scene.rooms[0].width"),
    ({"format": "other/9", "rooms": []}, "scene.format"),
    ({"rooms": [{**ROOM, "width": 0}]}, "scene.rooms[0].width"),
    ({"rooms": [{**ROOM, "width": 1e9}]}, "scene.rooms[0].width"),
    ({"rooms": [{**ROOM, "furniture": [BODY, BODY]}]}, "scene.rooms[0].furniture[1]"),
    ({"rooms": [{**ROOM, "furniture": [{**BODY, "width": -1}]}]}, "scene.rooms[0].furniture[0].width"),
    ({"rooms": [{**ROOM, "furniture": [{**BODY, "height": "tall"}]}]}, "scene.rooms[0].furniture[0].height"),
    ({"rooms": [{**ROOM, "furniture": [{"name": "sofa"}]}]}, "scene.rooms[0].furniture[0].x"),
    ({"rooms": [{**ROOM, "furniture": "sofa"}]}, "scene.rooms[0].furniture"),
    ({"rooms": [{**ROOM, "openings": [{"id": "d", "wall": "up"}]}]}, "scene.rooms[0].openings[0].wall"),
    ({"wall_thickness": -1, "rooms": []}, "scene.wall_thickness"),
]


@every("call", OF_SCENES)
@every(("scene", "field"), WRONG_SCENES)
def test_a_wrong_scene_names_the_place(client: TestClient, call: str, scene: object, field: str) -> None:
    entry = entry_of(client.post(call, json={"scene": scene}), 422)
    assert entry["field"].startswith(field)
    assert entry["allowed"]


@every("call", OF_SCENES)
@every("number", [b"NaN", b"Infinity", b"1e400", b"1" + b"0" * 400])
def test_numbers_beyond_all_bounds_in_a_scene_name_the_place(client: TestClient, call: str, number: bytes) -> None:
    scene = copy.deepcopy(ROOM)
    scene["furniture"] = [{**BODY, "x": "HERE"}]
    body = json.dumps({"scene": {"rooms": [scene]}}).encode().replace(b'"HERE"', number)
    assert entry_of(client.post(call, content=body), 422)["field"] == "scene.rooms[0].furniture[0].x"


@pytest.mark.parametrize("call", POSTS)
def test_a_large_body_is_refused_with_the_limit(client: TestClient, call: str) -> None:
    entry = entry_of(client.post(call, content=b" " * (25 << 20)), 413)
    assert str(BODY_LIMIT) in entry["allowed"]


def test_a_large_stream_is_refused_without_its_length_said(client: TestClient) -> None:
    pieces = (b" " * (1 << 20) for _ in range(25))
    entry = entry_of(client.post("/validate", content=pieces), 413)
    assert "8 MB" in entry["allowed"]


def test_an_endless_stream_is_not_read_to_its_end(client: TestClient) -> None:
    """What is dropped is bounded too."""
    assert DRAIN_LIMIT < 100 << 20
    answer = client.post("/generate", content=b"{}", headers={"content-length": str(10**30)})
    assert answer.status_code == 413
    problem_of(answer)


def test_the_largest_body_is_read(client: TestClient) -> None:
    body = b'{"bedrooms": "' + b"x" * (BODY_LIMIT - 16) + b'"}'
    assert len(body) == BODY_LIMIT
    assert entry_of(client.post("/generate", content=body), 422)["field"] == "bedrooms"


@pytest.mark.parametrize(
    "sent", ["text/plain", "image/png", "multipart/form-data; boundary=x", "application/xml", "application/jsonx", "nonsense"]
)
def test_other_content_types_are_refused(client: TestClient, sent: str) -> None:
    for call in POSTS:
        entry = entry_of(client.post(call, content=b"{}", headers={"content-type": sent}), 415)
        assert entry["field"] == "Content-Type"
        assert entry["allowed"] == "application/json, application/yaml; model/gltf-binary for a .glb that was exported"


@pytest.mark.parametrize("sent", ["image/png", "application/pdf"])
def test_a_file_of_another_type_is_told_which_types_files_have(client: TestClient, sent: str) -> None:
    entry = entry_of(client.post("/import", content=b"%PDF-1.4", headers={"content-type": sent}), 415)
    taken, _, files = entry["allowed"].partition("exported; ")
    assert taken.startswith("application/json, application/yaml; ")
    assert files.endswith(" for a file as it is")
    kinds = files.removesuffix(" for a file as it is").split(", ")
    assert {"application/octet-stream", "image/svg+xml"} <= set(kinds)
    for kind in kinds:
        assert client.post("/import", content=b"hello", headers={"content-type": kind}).status_code == 422


def test_packed_bodies_are_refused(client: TestClient) -> None:
    assert entry_of(client.post("/generate", content=b"{}", headers={"content-encoding": "gzip"}), 415)["field"] == "Content-Encoding"


@pytest.mark.parametrize(
    "path", ["/nothing", "/generate/", "/api/generate", "/assets/none.js", "/assets/%2e%2e/index.html", "/%2e%2e/README.md"]
)
def test_an_unknown_path_is_not_found(client: TestClient, path: str) -> None:
    assert entry_of(client.get(path), 404)["field"] == "path"


def test_an_unknown_format_is_not_found(client: TestClient) -> None:
    entry = entry_of(client.post("/export/papyrus", json={"rooms": []}), 404)
    assert entry["field"] == "format"
    assert {"json", "yaml", *EXPORTERS} <= set(entry["allowed"].split(", "))


@pytest.mark.parametrize(
    ("method", "path", "allowed"), [("GET", "/generate", "POST"), ("DELETE", "/fix", "POST"), ("POST", "/catalog", "GET, HEAD")]
)
def test_another_method_is_not_allowed(client: TestClient, method: str, path: str, allowed: str) -> None:
    answer = client.request(method, path)
    assert entry_of(answer, 405)["allowed"] == allowed
    assert answer.headers["allow"] == allowed


def test_every_id_that_is_not_there_is_named_at_once(client: TestClient) -> None:
    scene = {"rooms": [{"id": "den", "width": 4, "depth": 3}]}
    body = {"scene": scene, "locked": ["a", "b"], "moved": ["c"]}
    for dragging in (False, True):
        errors = client.post("/fix", json={**body, "dragging": dragging}).json()["errors"]
        assert [(one["field"], one["problem"].rsplit(" ", 1)[1]) for one in errors] == [
            ("locked[0]", "'a'"), ("locked[1]", "'b'"), ("moved[0]", "'c'"),
        ]  # fmt: skip


def test_every_piece_of_an_unknown_name_is_named_at_once(client: TestClient) -> None:
    room = {"id": "den", "width": 4, "depth": 3}
    pieces = [{"name": "zzqx"}, {"name": "bed"}, {"name": "qqzx", "width": 1, "height": 1}]
    errors = client.post("/place", json={"room": room, "pieces": pieces}).json()["errors"]
    assert [one["field"] for one in errors] == ["pieces[0].width", "pieces[0].depth", "pieces[0].height", "pieces[2].depth"]
