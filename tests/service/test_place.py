"""POST /place: its answer, its documents, and what it refuses."""

from __future__ import annotations

import copy
from typing import Any

import pytest
import yaml
from jsonschema import Draft202012Validator
from starlette.testclient import TestClient

from tests.service.problems import problem_of

BODY: dict[str, Any] = {
    "room": {
        "id": "den_0", "type": "den", "width": 4.2, "depth": 3.8,
        "openings": [
            {"id": "door_1", "kind": "door", "wall": "south", "position": 0.7, "width": 0.9, "connects_to": "EXTERIOR"},
            {"id": "window_1", "kind": "window", "wall": "north", "position": 2.0, "width": 1.4, "sill": 0.9},
        ],
    },
    "pieces": [
        {"id": "chair", "name": "office_chair", "relations": [{"type": "under", "of": "desk"}, {"type": "facing", "of": ["desk"]}]},
        {"id": "desk", "name": "desk", "width": 1.2, "depth": 0.6, "height": 0.75, "relations": [{"type": "at_window"}]},
        {"id": "crate", "name": "crate", "width": 0.5, "depth": 0.5, "height": 0.5, "count": 2, "required": False},
    ],
    "wall_thickness": 0.1,
}  # fmt: skip


def changed(path: str, value: Any) -> dict[str, Any]:
    """BODY with the value at a path such as pieces.0.width; a value of ... takes the key out."""
    body = copy.deepcopy(BODY)
    *way, last = [int(step) if step.isdecimal() else step for step in path.split(".")]
    node: Any = body
    for step in way:
        node = node[step]
    if value is ...:
        del node[last]
    else:
        node[last] = value
    return body


def schema(client: TestClient, name: str) -> Draft202012Validator:
    document = client.get("/openapi.json").json()
    return Draft202012Validator({"$ref": f"#/components/schemas/{name}", "components": document["components"]})


def test_it_answers_a_scene_with_its_relations(client: TestClient) -> None:
    answer = client.post("/place", json={**BODY, "alternatives": 3}).json()
    assert list(answer) == ["scene", "relations", "unplaced", "alternatives", "conflicts", "issues", "timing_ms", "understood_as"]
    assert {piece["id"] for piece in answer["scene"]["rooms"][0]["furniture"]} == {"chair", "desk", "crate_1", "crate_2"}
    assert answer["relations"] == [
        {"piece": "desk", "type": "at_window", "of": None, "held": True},
        {"piece": "chair", "type": "under", "of": "desk", "held": True},
        {"piece": "chair", "type": "facing", "of": "desk", "held": True},
    ]
    assert [set(other) for other in answer["alternatives"]] == [{"scene", "relations", "unplaced", "issues", "cost"}] * 2
    assert (answer["unplaced"], answer["conflicts"], answer["issues"]) == ([], [], [])
    assert client.post("/validate", json={"scene": answer["scene"]}).json()["issues"] == []
    assert list(schema(client, "PlaceAnswer").iter_errors(answer)) == []


def test_a_key_of_a_relation_that_is_null_is_not_given(client: TestClient) -> None:
    keys = ("of", "required", "cost", "weight", "distance", "gap", "sides", "align", "walls", "wall")
    nulls = changed("pieces.1.relations.0", {"type": "at_window", **dict.fromkeys(keys)})
    said, unsaid = (client.post("/place", json=body).json() for body in (nulls, BODY))
    assert (said["scene"], said["relations"]) == (unsaid["scene"], unsaid["relations"])


def test_what_it_takes_fits_its_schema(client: TestClient) -> None:
    body = schema(client, "PlaceBody")
    assert list(body.iter_errors(BODY)) == []
    assert list(body.iter_errors({**BODY, "robotWidth": 0.5})) == []
    assert list(body.iter_errors(changed("pieces.0.colour", "red")))


def test_yaml_says_the_same(client: TestClient) -> None:
    spoken = client.post("/place", content=yaml.safe_dump(BODY), headers={"content-type": "application/yaml", "accept": "application/yaml"})
    assert yaml.load(spoken.text, yaml.CSafeLoader)["scene"] == client.post("/place", json=BODY).json()["scene"]


def test_what_cannot_stand_is_an_answer(client: TestClient) -> None:
    answer = client.post("/place", json=changed("pieces.1.width", 9.0))
    assert answer.status_code == 200
    assert [entry["id"] for entry in answer.json()["unplaced"]] == ["desk"]
    assert [conflict["ids"] for conflict in answer.json()["conflicts"]] == [["desk"]]


@pytest.mark.parametrize(
    ("path", "value", "field"),
    [
        ("room", ..., "room"),
        ("room", 3, "room"),
        ("room.width", -1, "room.width"),
        ("room.openings.0.wall", "up", "room.openings[0].wall"),
        ("pieces", ..., "pieces"),
        ("pieces", {}, "pieces"),
        ("pieces.0.width", "wide", "pieces[0].width"),
        ("pieces.0.width", 0, "pieces[0].width"),
        ("pieces.0.colour", "red", "pieces[0].colour"),
        ("pieces.1.id", "chair", "pieces[1].id"),
        ("pieces.0.relations.0.of", "throne", "pieces[0].relations[0].of"),
        ("pieces.0.relations.0.type", "upon", "pieces[0].relations[0].type"),
        ("pieces.0.relations.0.distance", "far", "pieces[0].relations[0].distance"),
        ("pieces.0.count", 1.5, "pieces[0].count"),
        ("pieces.0.count", 65, "pieces[0].count"),
        ("pieces.2.width", ..., "pieces[2].width"),
        ("pieces.0.relations.0.off", 1, "pieces[0].relations[0].off"),
        ("alternatives", 0, "alternatives"),
        ("alternatives", 17, "alternatives"),
        ("scene", {}, "scene"),
        ("robot_width", 5, "robot_width"),
    ],
)
def test_a_wrong_field_is_named_with_what_is_allowed(client: TestClient, path: str, value: Any, field: str) -> None:
    answer = client.post("/place", json=changed(path, value))
    assert answer.status_code == 422
    (entry,) = problem_of(answer)["errors"]
    assert entry["field"] == field
    assert entry["allowed"]


def test_a_piece_is_called_by_its_name_and_the_other_way_round(client: TestClient) -> None:
    both = {"room": BODY["room"], "pieces": [{"id": "desk", "name": "desk"}, {"id": "sofa", "name": "sofa"}]}
    one = {"room": BODY["room"], "pieces": [{"name": "desk"}, {"id": "sofa", "name": None}]}
    answers = [client.post("/place", json=body).json() for body in (both, one)]
    assert answers[0]["scene"] == answers[1]["scene"]
    assert {piece["id"] for piece in answers[1]["scene"]["rooms"][0]["furniture"]} == {"desk", "sofa"}
    assert [piece["id"] for piece in answers[1]["unplaced"]] == []
    (told,) = problem_of(client.post("/place", json={"room": BODY["room"], "pieces": [{"name": "desk"}, {"width": 1.0}]}))["errors"]
    assert (told["field"], told["problem"]) == ("pieces[1].id", "is missing, and so is the name")
