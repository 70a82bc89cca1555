"""Whatever JSON or bytes come: an answer below 500, and problem documents that are well-formed."""

from __future__ import annotations

import json
from base64 import b64encode
from typing import Any, get_args

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from starlette.testclient import TestClient

from catalogs.schema import RelationWord
from solver.request import Request
from solver.scene import Furniture, Opening, Room
from tests.service.problems import problem_of
from tests.sweeps import times

POSTS = [
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
    "/export/json",
    "/export/yaml",
]
BOUNDED = settings(max_examples=times(200, 20), suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
TAKEN = 200
RELATED = get_args(RelationWord)

SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.integers(-3, 12),
    st.floats(),
    st.floats(-5, 30),
    st.text(max_size=8),
    st.sampled_from(["north", "kitchen", "door", "EXTERIOR", "a", "sofa", "bed", "compose-scene/1", "0", "report"]),
    st.sampled_from([10**30, 2**53, -0.0, 1e-9, 1e308]),
)
VALUES = st.recursive(
    SCALARS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=6), inner, max_size=3), max_leaves=6
)
SIZES = st.floats(0.1, 6.0) | st.sampled_from([0.001, 2.0, 0.5])
PLACES = st.floats(-1.0, 7.0) | VALUES


def keys(of: type[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Documents with some of a record's keys, holding anything."""
    names = sorted({*of.__dataclass_fields__} - {"extra"})
    return st.dictionaries(st.sampled_from(names), VALUES, max_size=4)


def pieces(of: type[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Bodies that can be read more often than not, with some keys spoilt now and then."""
    sizes = st.fixed_dictionaries({"name": st.sampled_from(["bed", "sofa", "x"]), "width": SIZES, "depth": SIZES, "height": SIZES})
    poses = st.fixed_dictionaries({"x": st.floats(0, 5), "z": st.floats(0, 5), "rotation": st.sampled_from([0, 90, 45.5, -720])})
    return st.builds(lambda size, pose, more: {**size, **pose, **more}, sizes, poses, st.just({}) | st.just({}) | keys(of))


OPENINGS = st.builds(
    lambda wall, position, more: {"wall": wall, "position": position, **more},
    st.sampled_from(["north", "south", "east", "west"]),
    PLACES,
    st.just({}) | keys(Opening),
)
ROOMS = st.builds(
    lambda width, depth, furniture, openings, more: {"width": width, "depth": depth, "furniture": furniture, "openings": openings, **more},
    SIZES,
    SIZES,
    st.lists(pieces(Furniture), max_size=3),
    st.lists(OPENINGS, max_size=2),
    st.just({}) | keys(Room),
)
SCENES = st.fixed_dictionaries({"rooms": st.lists(ROOMS, max_size=2) | VALUES}) | VALUES
RELATIONS = st.lists(
    st.fixed_dictionaries(
        {"type": st.sampled_from([*RELATED, "beyond"])},
        optional={
            "of": st.sampled_from(["a", "b", "door", "window", "x"]) | VALUES,
            "distance": st.floats(-1, 4),
            "required": st.booleans(),
        },
    ),
    max_size=2,
)
ASKED = st.fixed_dictionaries(
    {"id": st.sampled_from(["a", "b", "c"]), "name": st.sampled_from(["bed", "sofa", "x"])},
    optional={"width": SIZES, "depth": SIZES, "height": SIZES | VALUES, "count": st.integers(-1, 3), "relations": RELATIONS | VALUES},
)
IDS = st.lists(st.text(max_size=4), max_size=2) | VALUES
BODIES: dict[str, st.SearchStrategy[Any]] = {
    "/generate": keys(Request) | st.fixed_dictionaries({"scene": SCENES, "reroll": IDS}),
    "/furnish": st.fixed_dictionaries(
        {"scene": SCENES},
        optional={"rooms": IDS, "keep": st.sampled_from(["all", "locked", "none"]) | VALUES, "program": VALUES, "types": VALUES},
    ),
    "/fix": st.fixed_dictionaries(
        {"scene": SCENES}, optional={"locked": IDS, "moved": IDS, "on_conflict": VALUES, "dragging": st.booleans()}
    ),
    "/drag": st.fixed_dictionaries({"scene": SCENES, "id": st.sampled_from(["bed", "sofa", "bed_1"]) | VALUES}, optional={"locked": IDS}),
    "/place": st.fixed_dictionaries(
        {"room": ROOMS | VALUES, "pieces": st.lists(ASKED | VALUES, max_size=3) | VALUES},
        optional={"alternatives": st.integers(-1, 3) | VALUES, "wall_thickness": st.floats(-0.1, 0.3) | VALUES, "robot_width": SIZES},
    ),
    "/validate": st.fixed_dictionaries({"scene": SCENES}),
    "/view": st.fixed_dictionaries({"scene": SCENES}),
    "/explain": st.fixed_dictionaries({"scene": SCENES, "id": st.text(max_size=4) | VALUES}),
    "/import": st.fixed_dictionaries(
        {"document": VALUES | st.fixed_dictionaries({"type": st.just("FeatureCollection"), "features": VALUES})}
    )
    | st.fixed_dictionaries({"file": st.binary(max_size=40).map(lambda content: b64encode(content).decode()) | VALUES}),
    "/floor": st.fixed_dictionaries({"scene": SCENES}, optional={"rooms": IDS}),
}
BODIES |= dict.fromkeys(["/export/json", "/export/yaml"], st.fixed_dictionaries({"scene": SCENES}) | SCENES)


def judge(answer: Any) -> None:
    assert answer.status_code < 500, answer.text
    if answer.status_code == TAKEN:
        assert answer.json() if answer.headers["content-type"] == "application/json" else yaml.load(answer.text, yaml.CSafeLoader)
    else:
        assert problem_of(answer)["errors"]


@pytest.mark.parametrize("call", POSTS)
@BOUNDED
@given(st.data())
def test_random_documents(client: TestClient, call: str, data: st.DataObject) -> None:
    body = data.draw(BODIES[call] | VALUES)
    if call == "/generate" and isinstance(body, dict) and "scene" not in body:
        body = {**body, "width": body.get("width", 6.0), "depth": body.get("depth", 5.0)}
    judge(client.post(call, content=json.dumps(body)))


@pytest.mark.parametrize("content_type", ["application/json", "application/yaml"])
@pytest.mark.parametrize("call", POSTS)
@BOUNDED
@given(st.binary(max_size=60) | st.text("{}[]:,&*!|>-'\"#%@ \n\tae01.", max_size=40).map(str.encode))
def test_random_bytes(client: TestClient, call: str, content_type: str, body: bytes) -> None:
    judge(client.post(call, content=body, headers={"content-type": content_type}))
