"""The calls about things that are kept, in the OpenAPI document: every one has its refusals and an example, which is done as it says."""

from __future__ import annotations

import re
from typing import Any

import pytest
from starlette.testclient import TestClient

from tests.service.test_openapi import KEPT, faults

ALWAYS = {"401", "403", "405", "421", "422", "429", "500", "503", "504", "507"}
WITHOUT_EXAMPLE = {
    "PUT /homes/{home}/picture",
    "GET /homes/{home}/picture",
    "GET /jobs/{job}/events",
    "GET /jobs/{job}/results/{number}",
}
READING = {"400", "408", "409", "413", "415"}


@pytest.fixture(scope="module")
def document(client: TestClient) -> dict[str, Any]:
    return dict(client.get("/openapi.json").json())


def calls(document: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {
        f"{verb.upper()} {path}": call for path, verbs in document["paths"].items() for verb, call in verbs.items() if path.startswith(KEPT)
    }


def test_every_call_says_what_it_may_refuse(document: dict[str, Any]) -> None:
    found = calls(document)
    assert len(found) >= 9
    for name, call in found.items():
        refusals = {status for status in call["responses"] if status >= "400"}
        takes = READING if "requestBody" in call else set()
        named = {"404"} if "{" in name else set()
        revised = {"412", "428"} if any(part["name"] == "If-Match" for part in call.get("parameters", ())) else set()
        assert (name, refusals) == (name, ALWAYS | takes | named | revised)
        assert call["description"]


def test_every_example_is_taken_and_answered_as_it_says(client: TestClient, document: dict[str, Any]) -> None:
    """In the order of the document: what is kept first is what the others speak of."""
    ids: dict[str, str] = {}
    found = calls(document)
    removing = [name for name in found if name.startswith("DELETE")]
    for name in [*(name for name in found if name not in removing), *removing]:
        call, (verb, path) = found[name], name.split(" ")
        if not any(
            "example" in media
            for part in (call.get("requestBody", {}), *call["responses"].values())
            for media in part.get("content", {}).values()
        ):
            assert name in {*WITHOUT_EXAMPLE, *removing}, name
            continue
        body = call.get("requestBody", {}).get("content", {}).get("application/json", {}).get("example")
        filled = re.sub(r"\{(\w+)\}", lambda part: ids.get(part.group(1), "1"), path)
        answer = client.request(verb, filled, json=body, headers={"If-Match": "*"})
        status = next(status for status in call["responses"] if status.startswith("2"))
        assert (name, answer.status_code) == (name, int(status)), answer.text
        content = call["responses"][status]["content"]["application/json"]
        assert [faults(document, content["schema"], shown) for shown in (answer.json(), content["example"])] == [[], []], name
        assert answer.json().keys() == content["example"].keys(), name
        if body is not None:
            assert faults(document, call["requestBody"]["content"]["application/json"]["schema"], body) == []
        if status in ("201", "202"):
            ids["home" if status == "201" else "job"] = answer.json()["id"]
