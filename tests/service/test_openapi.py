"""The OpenAPI document tells the truth: judged by jsonschema against what is really taken and answered."""

from __future__ import annotations

from typing import Any

import pytest
from jsonschema import Draft202012Validator
from starlette.testclient import TestClient

from service.problems import STATUS
from tests.every import every
from tests.service.conftest import SMALL
from tests.service.test_refusals import REQUESTS

FAR_SIGHTED = ("min_room_size", "force_types", "outer_wall_thickness")
"""What only the whole request or the catalog tells: no schema of one field can."""


KEPT = ("/homes", "/jobs")
"""What begins so is about things that are kept: tests/service/test_store_calls.py."""


@pytest.fixture(scope="module")
def document(client: TestClient) -> dict[str, Any]:
    """The document, of the calls that keep nothing: JSON, whatever is accepted."""
    whole = dict(client.get("/openapi.json", headers={"accept": "application/yaml"}).json())
    return {**whole, "paths": {path: verbs for path, verbs in whole["paths"].items() if not path.startswith(KEPT)}}


def validator(document: dict[str, Any], schema: dict[str, Any]) -> Draft202012Validator:
    return Draft202012Validator({**schema, "components": document["components"]})


def faults(document: dict[str, Any], schema: dict[str, Any], value: object) -> list[str]:
    return [f"{fault.json_path}: {fault.message[:200]}" for fault in validator(document, schema).iter_errors(value)]


def body_schema(document: dict[str, Any], path: str) -> dict[str, Any]:
    content = document["paths"][path]["post"]["requestBody"]["content"]
    assert set(content) == {"application/json", "application/yaml"} or path == "/import"
    return dict(content["application/json"]["schema"])


def answer_schema(document: dict[str, Any], path: str, status: int, method: str = "post") -> dict[str, Any]:
    content = document["paths"][path][method]["responses"][str(status)]["content"]
    return dict(next(iter(content.values()))["schema"])


def test_every_schema_and_every_reference_holds(document: dict[str, Any]) -> None:
    assert document["openapi"].startswith("3.1")
    schemas = document["components"]["schemas"]
    assert len(schemas) > 20
    for schema in schemas.values():
        Draft202012Validator.check_schema(schema)
    references = [node["$ref"] for node in nodes(document) if isinstance(node.get("$ref"), str)]
    assert len(references) > 40
    assert {reference.removeprefix("#/components/schemas/") for reference in references} <= schemas.keys()


def nodes(value: Any) -> list[dict[str, Any]]:
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return [value] * isinstance(value, dict) + [node for item in inner for node in nodes(item)]


def test_it_lists_every_call(document: dict[str, Any]) -> None:
    posts = {path for path, verbs in document["paths"].items() if "post" in verbs}
    gets = {path for path, verbs in document["paths"].items() if "get" in verbs}
    assert posts == {
        "/generate",
        "/furnish",
        "/fix",
        "/drag",
        "/place",
        "/validate",
        "/view",
        "/explain",
        "/floor",
        "/import",
        "/export/{format}",
    }
    assert gets == {"/catalog", "/export", "/schema", "/healthz"}
    assert all(call["description"] for verbs in document["paths"].values() for call in verbs.values())
    statuses = {str(status) for status, _ in STATUS.values()} - {"404"} | {"200", "401", "403", "405", "421", "429", "500"}
    found = {path: set(document["paths"][path]["post"]["responses"]) for path in posts}
    assert found == {path: statuses | ({"404"} if "{" in path else set()) for path in posts}
    assert all(set(document["paths"][path]["get"]["responses"]) == {"200", "304", "401", "405", "421", "429", "500"} for path in gets)


def test_answers_are_as_described(client: TestClient, document: dict[str, Any], house: dict[str, Any], scene: dict[str, Any]) -> None:
    crowd = {"name": "bed", "x": 1.0, "z": 1.0, "width": 1.6, "depth": 2.0, "height": 0.5}
    cell = {"rooms": [{"width": 2.0, "depth": 2.1, "furniture": [crowd, crowd]}]}
    assert faults(document, answer_schema(document, "/generate", 200), house) == []
    for path in ("/fix", "/validate", "/view", "/floor"):
        for sent in (scene, cell):
            answer = client.post(path, json={"scene": sent})
            assert (answer.status_code, faults(document, answer_schema(document, path, 200), answer.json())) == (200, [])
    for path in ("/catalog", "/schema", "/healthz"):
        assert faults(document, answer_schema(document, path, 200, "get"), client.get(path).json()) == []


SEEDED = ("/generate", "/furnish", "/fix", "/place")
"""Calls whose answers are placements: examples of them show one that was."""


def test_every_example_is_taken_and_answered_as_it_says(client: TestClient, document: dict[str, Any]) -> None:
    for path, verbs in document["paths"].items():
        for verb, call in verbs.items():
            body = call["requestBody"]["content"]["application/json"]["example"] if verb == "post" else None
            answer = client.request(verb, path.replace("{format}", "json"), json=body)
            schema = answer_schema(document, path, 200, verb)
            shown = call["responses"]["200"]["content"]["application/yaml"]["example"]
            assert (path, answer.status_code) == (path, 200)
            assert [faults(document, schema, found) for found in (answer.json(), shown)] == [[], []]
            if verb == "post":
                assert faults(document, body_schema(document, path), body) == []
            if verb == "post" and path not in SEEDED:
                assert answer.json() == shown


def test_every_limit_is_told(document: dict[str, Any]) -> None:
    """A number or list of a body without bounds is one that was forgotten."""
    schemas = document["components"]["schemas"]
    read = [schema for name, schema in schemas.items() if name.endswith(("Body", "-Input")) or name in ("Request", "Pose", "PieceRequest")]
    numbers = [node for schema in read for node in nodes(schema) if node.get("type") in ("number", "integer")]
    assert len(numbers) > 50
    assert [node for node in numbers if "maximum" not in node or not {"minimum", "exclusiveMinimum"} & node.keys()] == []


def test_an_answer_with_more_or_less_would_be_seen(document: dict[str, Any], house: dict[str, Any]) -> None:
    schema = answer_schema(document, "/generate", 200)
    assert faults(document, schema, {**house, "more": 1})
    assert faults(document, schema, {"scene": house["scene"]})
    assert faults(document, schema, {**house, "issues": [{"rule": "overlap"}]})


def test_problems_are_as_described(client: TestClient, document: dict[str, Any]) -> None:
    answers = [client.post("/generate", content=body) for body in (b"{", b"[]", b" " * (9 << 20))]
    answers.append(client.post("/generate", content=b"{}", headers={"content-type": "text/plain"}))
    for answer in answers:
        assert faults(document, answer_schema(document, "/generate", answer.status_code), answer.json()) == []
    assert [answer.status_code for answer in answers] == [400, 422, 413, 415]


@every("body", [body for body, field, _ in REQUESTS if field not in FAR_SIGHTED and body != {"width": None, "depth": True}])
def test_what_is_refused_does_not_fit_the_schema(document: dict[str, Any], body: dict[str, Any]) -> None:
    assert faults(document, body_schema(document, "/generate"), body)


def test_what_is_taken_fits_the_schema(client: TestClient, document: dict[str, Any], scene: dict[str, Any]) -> None:
    schema = body_schema(document, "/generate")
    taken = [
        SMALL,
        {**SMALL, "seed": None},
        {**SMALL, "minRoomSize": 2.4, "useSpine": False, "forceTypes": {"0": "living_room"}},
        {"scene": scene, "reroll": [scene["rooms"][0]["id"]], "seed": 3},
    ]
    for body in taken:
        assert faults(document, schema, body) == []
        assert client.post("/generate", json=body).status_code == 200
    fix = {"scene": scene, "locked": [], "moved": [], "on_conflict": "remove"}
    assert faults(document, body_schema(document, "/fix"), fix) == []
    assert faults(document, body_schema(document, "/fix"), {**fix, "on_conflict": "delete"})
    assert faults(document, body_schema(document, "/fix"), {**fix, "on_conflit": "remove"})


def test_every_default_is_told_and_is_taken(client: TestClient, document: dict[str, Any]) -> None:
    properties = document["components"]["schemas"]["Request"]["properties"]
    defaults = {name: part.get("default") for name, part in properties.items() if not part.get("deprecated")}
    assert (defaults["width"], defaults["min_room_size"]) == (None, 3.0)
    assert properties["width"]["description"].startswith("m, 20 unless")
    said = client.post("/generate", json={**defaults, "seed": 1, "width": 6.0, "depth": 5.0}).json()["scene"]
    unsaid = client.post("/generate", json={"seed": 1, "width": 6.0, "depth": 5.0}).json()["scene"]
    assert said == unsaid


def test_every_default_fits_its_own_schema(document: dict[str, Any]) -> None:
    """What is told as a default may be sent. The id of a wished piece has none: it is called by its name."""
    schemas = document["components"]["schemas"]
    read = {name: schema for name, schema in schemas.items() if name.endswith(("Body", "-Input")) or name in ("Request", "PieceRequest")}
    keys = {f"{name}.{key}": node for name, schema in read.items() for key, node in schema["properties"].items()}
    told = {key: node for key, node in keys.items() if "default" in node}
    assert len(told) > 50
    assert {key: found for key, node in told.items() if (found := faults(document, node, node["default"]))} == {}
    assert not {"PieceRequest.id", "PieceRequest.name"} & told.keys() and {"PieceRequest.id", "PieceRequest.name"} <= keys.keys()


def test_what_every_key_of_a_body_is_about_is_told(document: dict[str, Any]) -> None:
    schemas = document["components"]["schemas"]
    read = {
        name: schema for name, schema in schemas.items() if name.endswith(("Body", "-Input")) or name in ("Request", "PieceRequest", "Pose")
    }
    keys = {f"{name}.{key}": node for name, schema in read.items() for key, node in schema["properties"].items()}
    assert len(keys) > 150 and [key for key, node in keys.items() if not node.get("description") and "$ref" not in node] == []
    assert keys["FixBody.onConflict"]["description"] == keys["FixBody.on_conflict"]["description"] == "what becomes of what cannot stand"


def test_the_body_of_import_is_described_in_every_media_type_that_is_taken(client: TestClient, document: dict[str, Any]) -> None:
    content = document["paths"]["/import"]["post"]["requestBody"]["content"]
    assert {"application/json", "application/yaml", "application/octet-stream", "image/svg+xml", "application/x-step"} <= content.keys()
    plan = b"<svg xmlns='http://www.w3.org/2000/svg'/>"
    taken = [client.post("/import", content=plan, headers={"content-type": kind}).status_code for kind in content]
    assert 415 not in taken
    asked = {one["name"]: one for one in document["paths"]["/import"]["post"]["parameters"]}
    assert set(asked) == {"name", "level", "unit", "furniture"} and not any(one["required"] for one in asked.values())
    assert all("image/svg+xml" not in document["paths"][path]["post"]["requestBody"]["content"] for path in ("/fix", "/validate"))


@pytest.mark.parametrize("name", ["Freed", "Unlocked", "Turned", "Shrunk", "LeftOut", "Removal"])
def test_every_key_of_a_repair_says_what_it_is(document: dict[str, Any], name: str) -> None:
    keys = document["components"]["schemas"][name]["properties"]
    assert keys
    assert [key for key, schema in keys.items() if not schema.get("description")] == []
