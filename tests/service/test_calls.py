"""Every call does what docs/api.md says of it, in JSON and in YAML."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest
import yaml
from starlette.testclient import TestClient

from service.generating import check_size
from solver.errors import FieldError
from solver.floorplan.bsp import MAX_ROOMS
from solver.scene import Room, Scene
from tests.service.conftest import SMALL

YAML = {"content-type": "application/yaml", "accept": "application/yaml"}


def scene_bytes(answer: Any) -> str:
    """The scene of an answer as it stands in the answer's bytes."""
    text: str = answer.text
    start = text.index('"scene":')
    return text[start : text.index(',"issues":', start)]


def test_generate_answers_a_furnished_house(house: dict[str, Any]) -> None:
    assert set(house) == {"scene", "issues", "timing_ms"}
    scene = house["scene"]
    assert scene["format"] == "compose-scene/1"
    assert scene["seed"] == 42
    assert (scene["size"]["width"], scene["size"]["depth"]) == (8.0, 6.0)
    assert sum(len(room["furniture"]) for room in scene["rooms"]) >= 5
    assert [issue for issue in house["issues"] if issue["severity"] == "error"] == []
    assert house["timing_ms"]["total"] > 0
    assert all(isinstance(value, (int, float)) for value in house["timing_ms"].values())


def test_the_same_request_gives_the_same_scene_bytes(client: TestClient) -> None:
    first = client.post("/generate", json=SMALL)
    client.post("/generate", json={**SMALL, "seed": 7})
    again = client.post("/generate", json=SMALL)
    assert scene_bytes(first) == scene_bytes(again)
    assert len(scene_bytes(first)) > 2000


def test_the_request_in_a_scene_makes_it_again(client: TestClient, scene: dict[str, Any]) -> None:
    again = client.post("/generate", json=scene["request"])
    assert again.json()["scene"] == scene


def test_what_curl_sends_is_read_as_json(client: TestClient, scene: dict[str, Any]) -> None:
    answer = client.post("/generate", content=json.dumps(SMALL), headers={"content-type": "application/x-www-form-urlencoded"})
    assert answer.json()["scene"] == scene


def test_a_body_without_a_content_type_is_json(client: TestClient, scene: dict[str, Any]) -> None:
    request = client.build_request("POST", "/generate", content=json.dumps(SMALL))
    assert "content-type" not in request.headers
    assert client.send(request).json()["scene"] == scene


def test_a_byte_order_mark_is_let_be(client: TestClient, scene: dict[str, Any]) -> None:
    answer = client.post("/generate", content=b"\xef\xbb\xbf" + json.dumps(SMALL).encode())
    assert answer.json()["scene"] == scene


def test_a_house_needs_no_body(client: TestClient) -> None:
    scene = client.post("/generate").json()["scene"]
    assert (scene["size"]["width"], scene["size"]["depth"]) == (20.0, 15.0)
    assert scene["request"] == {**scene["request"], "seed": scene["seed"], "program": None, "use_spine": True}


def test_camel_case_keys_mean_the_same(client: TestClient) -> None:
    snake = client.post("/generate", json={**SMALL, "min_room_size": 2.4, "use_spine": False})
    camel = client.post("/generate", json={**SMALL, "minRoomSize": 2.4, "useSpine": False})
    assert snake.status_code == 200
    assert snake.json()["scene"] == camel.json()["scene"]


def test_yaml_in_and_out_says_the_same(client: TestClient, scene: dict[str, Any]) -> None:
    answer = client.post("/generate", content="seed: 42\nwidth: 8.0\ndepth: 6.0\n", headers=YAML)
    assert answer.headers["content-type"].startswith("application/yaml")
    assert yaml.load(answer.text, yaml.CSafeLoader)["scene"] == scene


@pytest.mark.parametrize("call", ["fix", "validate", "view"])
def test_yaml_of_a_scene_is_taken_by_every_call(client: TestClient, scene: dict[str, Any], call: str) -> None:
    sent = client.post(f"/{call}", json={"scene": scene})
    as_yaml = client.post(f"/{call}", content=yaml.safe_dump({"scene": scene}), headers=YAML)
    ours, theirs = sent.json(), yaml.load(as_yaml.text, yaml.CSafeLoader)
    ours.pop("timing_ms", None)
    theirs.pop("timing_ms", None)
    assert (sent.status_code, as_yaml.status_code) == (200, 200)
    assert ours == theirs


@pytest.mark.parametrize(
    ("accept", "expected"),
    [
        ("", "application/json"),
        ("*/*", "application/json"),
        ("application/yaml", "application/yaml"),
        ("text/yaml;q=0.9, application/json;q=0.1", "application/yaml"),
        ("application/yaml;q=0.5, */*", "application/json"),
        ("application/yaml;q=0", "application/json"),
        ("application/yaml;q=nonsense", "application/json"),
        ("image/png", "application/json"),
    ],
)
def test_accept_chooses_the_format(client: TestClient, accept: str, expected: str) -> None:
    answer = client.get("/healthz", headers={"accept": accept})
    assert answer.headers["content-type"].partition(";")[0] == expected
    assert "accept" in answer.headers["vary"].lower()


def test_a_seed_is_drawn_and_echoed(client: TestClient) -> None:
    drawn = [client.post("/generate", json={"width": 5.0, "depth": 4.0, **seed}).json()["scene"] for seed in ({}, {"seed": None})]
    assert drawn[0]["seed"] != drawn[1]["seed"]
    for scene in drawn:
        assert isinstance(scene["seed"], int)
        assert 0 <= scene["seed"] < 2**53
        assert scene["request"]["seed"] == scene["seed"]
        assert client.post("/generate", json={"width": 5.0, "depth": 4.0, "seed": scene["seed"]}).json()["scene"] == scene


def furnished_room(scene: dict[str, Any]) -> dict[str, Any]:
    return dict(max(scene["rooms"], key=lambda room: len(room["furniture"])))


def test_reroll_touches_only_the_named_rooms(client: TestClient, scene: dict[str, Any]) -> None:
    named = furnished_room(scene)["id"]
    answer = client.post("/generate", json={"scene": scene, "reroll": [named], "seed": 5})
    assert answer.status_code == 200, answer.text
    after = answer.json()["scene"]
    assert [room for room in after["rooms"] if room["id"] != named] == [room for room in scene["rooms"] if room["id"] != named]
    openings = {room["id"]: room["openings"] for room in scene["rooms"]}
    assert {room["id"]: room["openings"] for room in after["rooms"]} == openings
    assert client.post("/generate", json={"scene": scene, "reroll": [named], "seed": 5}).json()["scene"] == after
    others = [client.post("/generate", json={"scene": scene, "reroll": [named], "seed": seed}).json()["scene"] for seed in range(6)]
    assert any(furnished_room(other) != furnished_room(scene) for other in others)


def test_reroll_keeps_what_is_locked(client: TestClient, scene: dict[str, Any]) -> None:
    room = copy.deepcopy(furnished_room(scene))
    locked = {**room["furniture"][0], "locked": True}
    room["furniture"][0] = locked
    sent = {**scene, "rooms": [room if one["id"] == room["id"] else one for one in scene["rooms"]]}
    for seed in range(4):
        answer = client.post("/generate", json={"scene": sent, "reroll": [room["id"]], "seed": seed}).json()
        after = next(one for one in answer["scene"]["rooms"] if one["id"] == room["id"])
        assert locked in after["furniture"]
        assert [issue for issue in answer["issues"] if issue["severity"] == "error"] == []


def test_furniture_dragged_off_what_carries_it_is_named_and_brought_back(client: TestClient) -> None:
    stand = {"id": "s", "name": "tv_stand", "x": 2.0, "z": 0.23, "width": 1.6, "depth": 0.4, "height": 0.5}
    tv = {"id": "t", "name": "tv", "x": 3.4, "y": 0.5, "z": 2.0, "width": 1.24, "depth": 0.14, "height": 0.74, "on": "s"}
    scene = {"rooms": [{"id": "r", "width": 5.0, "depth": 4.0, "furniture": [stand, tv]}]}
    issues = client.post("/validate", json={"scene": scene}).json()["issues"]
    assert [(issue["rule"], issue["ids"]) for issue in issues] == [("floating", ["t"])]
    fixed = client.post("/fix", json={"scene": scene, "moved": ["t"]}).json()
    assert [(move["id"], move["dx"], move["dz"]) for move in fixed["moves"]] == [("t", -1.22, -1.64)]
    assert (fixed["issues"], fixed["conflicts"]) == ([], [])


def test_fix_leaves_a_clean_scene_alone(client: TestClient, scene: dict[str, Any]) -> None:
    answer = client.post("/fix", json={"scene": scene}).json()
    assert set(answer) == {"scene", "moves", "removed", "conflicts", "issues", "timing_ms", "understood_as"}
    assert answer["scene"] == scene
    assert (answer["moves"], answer["removed"], answer["conflicts"]) == ([], [], [])


def broken(scene: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """The scene with one piece pushed through a wall, and the piece's id."""
    scene = copy.deepcopy(scene)
    room = max(scene["rooms"], key=lambda room: len(room["furniture"]))
    piece = next(piece for piece in room["furniture"] if piece["under"] is None and piece["on"] is None and piece["wall"])
    piece["x"] = room["width"] + 0.3
    return scene, piece["id"]


def test_validate_finds_what_was_broken_and_fix_repairs_it(client: TestClient, scene: dict[str, Any]) -> None:
    spoiled, piece = broken(scene)
    found = client.post("/validate", json={"scene": spoiled}).json()
    assert set(found) == {"issues", "metrics", "understood_as"}
    out = [issue for issue in found["issues"] if issue["rule"] == "out_of_bounds"]
    assert [piece in issue["ids"] for issue in out] == [True]
    assert set(out[0]) == {"rule", "severity", "room", "ids", "amount", "message"}
    fixed = client.post("/fix", json={"scene": spoiled}).json()
    assert piece in [move["id"] for move in fixed["moves"]]
    assert [issue for issue in fixed["issues"] if issue["severity"] == "error"] == []
    assert client.post("/validate", json={"scene": fixed["scene"]}).json()["issues"] == fixed["issues"]


def test_fix_honours_locked_and_says_what_is_impossible(client: TestClient, scene: dict[str, Any]) -> None:
    spoiled, piece = broken(scene)
    answer = client.post("/fix", json={"scene": spoiled, "locked": [piece]})
    assert answer.status_code == 200
    before = [body for room in spoiled["rooms"] for body in room["furniture"] if body["id"] == piece]
    after = [body for room in answer.json()["scene"]["rooms"] for body in room["furniture"] if body["id"] == piece]
    assert after == before
    assert any(piece in conflict["ids"] for conflict in answer.json()["conflicts"])


def test_fix_removes_only_when_asked(client: TestClient) -> None:
    bed = {"name": "bed", "x": 1.0, "z": 1.0, "width": 1.6, "depth": 2.0, "height": 0.5}
    room = {"id": "cell", "width": 2.6, "depth": 3.0, "furniture": [{**bed, "id": "a"}, {**bed, "id": "b"}]}
    report, remove = (client.post("/fix", json={"scene": {"rooms": [room]}, "on_conflict": word}).json() for word in ("report", "remove"))
    assert report["removed"] == []
    assert report["conflicts"]
    assert len(report["scene"]["rooms"][0]["furniture"]) == 2
    assert len(remove["scene"]["rooms"][0]["furniture"]) == 1
    assert [set(entry) for entry in remove["removed"]] == [{"id", "reason"}]


def test_validate_measures(client: TestClient, scene: dict[str, Any]) -> None:
    metrics = client.post("/validate", json={"scene": scene}).json()["metrics"]
    assert metrics["counts"]["rooms"] == len(scene["rooms"])
    assert metrics["area"] == pytest.approx(48.0)


def test_view_says_which_body_each_line_is(client: TestClient, scene: dict[str, Any]) -> None:
    answer = client.post("/view", json={"scene": scene}).json()
    assert set(answer) == {"text", "lines"}
    shown = answer["text"].splitlines()
    assert len(shown) == len(answer["lines"])
    bodies = {body["id"]: body["name"] for room in scene["rooms"] for body in room["furniture"]}
    bodies |= {body["id"]: body["kind"] for body in scene["dynamic"]}
    named = {name: line for line, name in zip(shown, answer["lines"], strict=True) if name}
    assert bodies.keys() == named.keys()
    assert all(bodies[name] in line for name, line in named.items())


def test_the_catalog_tells_what_there_is(client: TestClient) -> None:
    catalog = client.get("/catalog").json()
    assert {"furniture", "floorings", "rooms", "fingerprint"} <= set(catalog)
    assert "bed" in catalog["furniture"]
    assert "kitchen" in catalog["rooms"]
    assert set(catalog["shapes"]["bed"][0]) == {
        "form", "x", "y", "z", "axis", "taper", "material", "front", "board", "opens", "range", "must_open",
    }  # fmt: skip
    assert {part["material"] for parts in catalog["shapes"].values() for part in parts} <= set(catalog["materials"])
    assert all(set(style["materials"]) <= set(catalog["materials"]) for style in catalog["styles"].values())


@pytest.mark.parametrize("question", ["catalog", "schema", "export"])
def test_what_never_changes_is_sent_once_in_each_format(client: TestClient, question: str) -> None:
    tags = set()
    for wanted in ("application/json", "application/yaml"):
        asked = {"Accept": wanted, "Accept-Encoding": "gzip"}
        first = client.get(f"/{question}", headers=asked)
        tag = first.headers["etag"]
        again = client.get(f"/{question}", headers={**asked, "If-None-Match": tag})
        assert (again.status_code, again.content, again.headers["etag"]) == (304, b"", tag)
        other = client.get(f"/{question}", headers={**asked, "If-None-Match": '"another"'})
        assert (other.status_code, other.content) == (200, first.content)
        tags.add(tag)
    assert len(tags) == 2, "a browser that has the one is not told that it has the other"


def test_the_schema_is_that_of_scenes(client: TestClient, scene: dict[str, Any]) -> None:
    from jsonschema import Draft202012Validator

    schema = client.get("/schema").json()
    Draft202012Validator.check_schema(schema)
    assert list(Draft202012Validator(schema).iter_errors(scene)) == []
    assert list(Draft202012Validator(schema).iter_errors({"rooms": [{"id": "a"}]}))


@pytest.mark.parametrize("call", ["generate", "fix"])
def test_an_answer_that_holds_a_scene_is_exported_as_that_scene(client: TestClient, house: dict[str, Any], call: str) -> None:
    answer = house if call == "generate" else client.post("/fix", json={"scene": house["scene"]}).json()
    assert client.post("/export/json", json=answer).json() == house["scene"]
    assert yaml.load(client.post("/export/yaml", json=answer).text, yaml.CSafeLoader) == house["scene"]


def test_healthz_answers(client: TestClient) -> None:
    answer = client.get("/healthz")
    assert (answer.status_code, answer.json()) == (200, {"status": "ok"})


def test_a_file_sent_as_it_is_is_read_as_the_query_asks(client: TestClient) -> None:
    square = [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]
    floor = {"type": "Polygon", "coordinates": [square]}
    features = [{"properties": {"name": f"Attic {level}", "level": level}, "geometry": floor} for level in (0, -1)]
    plan = {"type": "FeatureCollection", "features": features}

    def sent(**query: str) -> dict[str, Any]:
        headers = {"content-type": "application/octet-stream"}
        answer: dict[str, Any] = client.post("/import", content=json.dumps(plan), headers=headers, params=query).json()
        return answer

    for level in (0, -1):
        wanted = client.post("/import", json={"document": plan, "level": level, "unit": "ft"}).json()
        assert sent(level=str(level), unit="ft") == wanted
        assert [room["name"] for room in wanted["scene"]["rooms"]] == [f"Attic {level}"]
    refused = [sent(**query)["errors"][0]["field"] for query in ({"level": "1.5"}, {"level": "9"}, {"unit": "yards"}, {"storey": "1"})]
    assert refused == ["level", "level", "unit", "storey"]


def test_a_call_takes_as_many_rooms_as_a_house_that_is_made_may_have() -> None:
    rooms = tuple(Room(f"room_{n}", width=4.0, depth=3.0) for n in range(MAX_ROOMS))
    check_size(Scene(rooms=rooms))
    with pytest.raises(FieldError, match=f"at most {MAX_ROOMS} in one call"):
        check_size(Scene(rooms=(*rooms, Room("one_more", width=4.0, depth=3.0))))
