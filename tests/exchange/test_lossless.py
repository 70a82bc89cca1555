"""YAML <-> JSON <-> objects: nothing is lost, whatever is in them, and the schema agrees with the writer."""

from __future__ import annotations

import json
import math
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
import yaml
from hypothesis import given
from jsonschema import Draft202012Validator

from catalogs.misfits import reader_of
from solver.errors import FieldError, SceneError, SyntaxFault
from solver.exchange import (
    FORMATS,
    dump_scene,
    dump_text,
    load_text,
    read_request,
    read_scene,
    scene_schema,
    write_request,
    write_scene,
)
from solver.request import Request
from solver.scene import Flooring, Furniture, Room, Scene
from tests.exchange.documents import PLAIN, SCENES, piece, room, scene
from tests.sweeps import examples

SCHEMA = Draft202012Validator(scene_schema())


@given(SCENES)
def test_a_scene_survives_every_format(drawn: Scene) -> None:
    document = write_scene(drawn)
    assert read_scene(document) == drawn
    for name in FORMATS:
        text = dump_text(document, name)
        assert load_text(text, name) == document
        assert load_text(text.decode(), name) == document
        assert read_scene(load_text(text, name)) == drawn
        assert dump_text(write_scene(read_scene(load_text(text, name))), name) == text
        assert dump_scene(drawn, name) == text


@given(SCENES)
def test_the_schema_accepts_what_the_writer_writes(drawn: Scene) -> None:
    assert [error.message for error in SCHEMA.iter_errors(write_scene(drawn))] == []


@examples(80)
@given(PLAIN)
def test_any_document_survives_every_format(document: Any) -> None:
    for name in FORMATS:
        text = dump_text(document, name)
        assert same(load_text(text, name), document)
        assert dump_text(load_text(text, name), name) == text


@examples(80)
@given(PLAIN)
def test_readers_of_others_understand_our_texts(document: Any) -> None:
    """The standard library's JSON, and PyYAML, which reads YAML 1.1 with its `yes`, `on` and dates."""
    assert same(json.loads(dump_text(document, "json")), document)
    assert same(yaml.safe_load(dump_text(document, "yaml")), document)


def test_what_is_flat_is_on_one_line() -> None:
    """The writing to the letter: equal documents give equal bytes in every version."""
    document = {
        "seed": 3,
        "note": "it's 3: \u00fc\t\x85\U0001f600",
        "pair": [1.0, -1e-07],
        "sizes": [[1, 2], []],
        "rooms": [{"id": "den_1", "on": True, "inner": {"no": None}}, {"lines": [[1, [[2]]], "x y"]}],
        "k" * 1001: {"a": {}},
    }
    assert dump_text(document, "yaml").decode() == "\n".join(
        [
            "seed: 3",
            'note: "it\'s 3: \u00fc\\t\\x85\\U0001F600"',
            "pair: [1.0, -1.0e-07]",
            "sizes: [[1, 2], []]",
            "rooms:",
            "- id: den_1",
            '  "on": true',
            '  inner: {"no": null}',
            "- lines:",
            "  - - 1",
            "    - [[2]]",
            "  - x y",
            "? " + "k" * 1001,
            ":",
            "  a: {}",
            "",
        ]
    )
    assert load_text(dump_text(document, "yaml"), "yaml") == yaml.safe_load(dump_text(document, "yaml")) == document


def same(one: Any, other: Any) -> bool:
    """Equality that tells 1 from 1.0 and from True, and keys in order."""
    if isinstance(one, dict):
        return isinstance(other, dict) and list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, list):
        return isinstance(other, list) and len(one) == len(other) and all(map(same, one, other))
    return type(one) is type(other) and bool(one == other)


def test_schemas_are_schemas() -> None:
    for schema in (scene_schema(), reader_of(Request).json_schema()):
        Draft202012Validator.check_schema(schema)
    assert scene_schema()["$schema"].endswith("2020-12/schema")


def test_the_schema_tells_what_every_key_is_about() -> None:
    schema = scene_schema()
    told = {"Scene": schema, **schema["$defs"]}
    silent = [f"{name}.{key}" for name, one in told.items() for key, node in one["properties"].items() if not node.get("description")]
    assert len(told) == 11 and silent == []
    assert told["Furniture"]["properties"]["x"]["description"] == "centre of its footprint in the room, m"
    assert [name for name, one in told.items() if "Args" in one["description"] or not one["description"]] == []


def test_the_schema_asks_for_what_the_reader_asks_for() -> None:
    definitions = scene_schema()["$defs"]
    assert definitions["Room"]["required"] == ["width", "depth"]
    assert definitions["Furniture"]["required"] == ["name", "x", "z", "width", "depth", "height"]
    assert definitions["Decoration"]["required"] == ["name", "x", "z", "width", "depth", "height"]
    for wrong in (
        scene({"width": 4.0}),
        scene(room(piece(height=0))),
        scene(room(piece(wall="up"))),
        scene(room(piece(x="1"))),
        scene(room(outline=[[0, 0], [1, 0], [1, 1]])),
        scene(format="compose-scene/2"),
        scene(wall_thickness=2.0),
        scene(adjacency=[[1, 2, 3]]),
    ):
        assert not SCHEMA.is_valid(wrong)
        with pytest.raises(SceneError):
            read_scene(wrong)
    assert SCHEMA.is_valid(scene(room(piece(brand="x"), light=3), by="me"))
    assert not Draft202012Validator(reader_of(Request).json_schema()).is_valid({"sed": 1})


def test_the_writer_keeps_the_order_of_the_types() -> None:
    document = write_scene(read_scene(scene(room(piece(brand="x"), openings=[{}], decorations=[piece()]), dynamic=[{}], by="me")))
    assert list(document) == [
        *("format", "seed", "request", "generator", "size", "wall_thickness", "levels", "rooms", "corridors", "adjacency"),
        *("dynamic", "certificate", "by"),
    ]
    (written,) = document["rooms"]
    assert list(written) == [
        *("id", "index", "type", "level", "x", "z", "width", "depth", "outline", "outdoor", "flooring", "accent"),
        *("exterior_walls", "wall_flags", "openings", "furniture", "decorations"),
    ]
    assert list(written["openings"][0]) == [
        *("id", "kind", "wall", "position", "width", "height", "sill", "connects_to", "hinge", "swing", "main_entrance", "render_panel"),
    ]
    assert list(written["furniture"][0]) == [
        *("id", "name", "category", "x", "y", "z", "rotation", "width", "depth", "height", "color", "wall", "under", "on", "locked"),
        "brand",
    ]
    assert list(written["decorations"][0]) == [
        *("id", "name", "parent", "mounted_on_wall", "x", "y", "z", "rotation", "width", "depth", "height", "color"),
    ]
    assert list(document["dynamic"][0]) == ["id", "kind", "room", "x", "y", "z", "rotation", "width", "depth", "height"]


def test_numbers_are_written_shortest_and_right_angles_whole() -> None:
    bodies = [piece(id="a", x=0.1 + 0.2, rotation=90.0), piece(id="b", x=-0.0, rotation=9.014), piece(id="c", x=2, rotation=-90)]
    written = write_scene(read_scene(scene(room(*bodies))))["rooms"][0]["furniture"]
    assert json.dumps([(body["x"], body["rotation"]) for body in written]) == "[[0.30000000000000004, 90], [0.0, 9.014], [2.0, -90]]"
    assert dump_text({"a": 1e-7, "b": 1e22, "c": 20.0, "d": 3}, "yaml") == b"{a: 1.0e-07, b: 1.0e+22, c: 20.0, d: 3}\n"
    assert dump_text({"a": 1e-7, "b": "\u00e9"}, "json") == '{"a":1e-07,"b":"\u00e9"}\n'.encode()


def test_yaml_reads_well() -> None:
    document = write_scene(read_scene(scene(room(piece(color="#2e8b57"), id="den"), adjacency=[[0, 1]])))
    lines = dump_text(document, "yaml").decode().splitlines()
    assert (lines[0], lines[-1]) == ("format: compose-scene/1 # the last line is ...", "...")
    assert "adjacency: [[0, 1]]" in lines
    assert "- id: den" in lines
    start = "  - {id: den/sofa_1, name: sofa, category: null, x: 1.0, y: 0.0, z: 1.0, rotation: 0, width: 1.0, depth: 1.0, "
    assert start + 'height: 1.0, color: "#2e8b57", wall: null, under: null, "on": null, locked: false}' in lines


def test_a_scene_that_was_cut_off_is_refused_wherever_it_was_cut() -> None:
    document = write_scene(read_scene(scene(room(piece(id="a"), piece(id="b"), id="den"), room(id="hall"))))
    for format in FORMATS:
        whole = dump_text(document, format)
        assert load_text(whole, format) == load_text(whole.rstrip(), format) == document
        for end in range(len(whole.rstrip())):
            with pytest.raises((SyntaxFault, SceneError, FieldError)):
                read_scene(load_text(whole[:end], format))


def test_a_scene_that_says_nothing_of_its_end_is_read() -> None:
    assert load_text("format: compose-scene/1\nrooms: []\n", "yaml") == {"format": "compose-scene/1", "rooms": []}


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, {1, 2}, b"x", "\ud800", {"a": [{"b": math.nan}]}])
def test_what_no_format_can_say_is_refused_by_place(bad: Any) -> None:
    for name in FORMATS:
        with pytest.raises(FieldError) as caught:
            dump_text({"deep": [0, bad]}, name)
        assert caught.value.field.startswith("deep[1]")
    broken = Scene(rooms=(Room("a", width=4.0, depth=3.0, furniture=(Furniture("b", "c", x=math.nan),)),))
    for writing in (write_scene, lambda scene: dump_scene(scene, "json"), lambda scene: dump_scene(scene, "yaml")):
        with pytest.raises(SceneError) as refused:
            writing(broken)
        assert refused.value.field == "rooms[0].furniture[0].x"


def test_scenes_of_python_s_other_numbers_and_texts_are_written_as_their_documents() -> None:
    class Name(str):
        __slots__ = ()

    odd = [
        Furniture("a", Name("sofa"), x=3, z=-0.0, rotation=90.0, y=np.float64(0.1), width=np.float32(0.25), locked=1),  # type: ignore[arg-type]
        Furniture("b", 7, color=2.5, x=True, wall=True, rotation=np.int64(-450), on="", extra={"x": 1.0, "new": [1e-7]}),  # type: ignore[arg-type]
        Furniture("\u00e9\u2028", '"\\\n\x01', x=1e22, z=1e-7, kind="%s", extra={"deep": {1: None}}),
    ]
    scene = Scene(rooms=(Room("%", outline=((0, 0), (1, 0), (1, 1), (0, 1)), furniture=tuple(odd)),), certificate={"a": -0.0, "b": (1,)})
    assert dump_scene(scene, "json") == dump_text(write_scene(scene), "json")
    with pytest.raises(SceneError) as refused:
        dump_scene(Scene(rooms=(Room("a", furniture=(Furniture("b", "\ud800"),)),)), "json")
    assert refused.value.field == "rooms[0].furniture[0].name"


def deep(levels: int) -> Any:
    """Returns lists within lists."""
    return [] if levels == 1 else [deep(levels - 1)]


def test_what_a_sender_adds_to_a_floor_is_written_as_it_is_now() -> None:
    own: dict[str, list[int]] = {"own": [1]}
    told = Scene(rooms=(Room("den", width=3.0, depth=3.0, flooring=Flooring(extra=own)),))
    assert json.loads(dump_scene(told, "json"))["rooms"][0]["flooring"]["own"] == [1]
    own["own"].append(2)
    assert json.loads(dump_scene(told, "json"))["rooms"][0]["flooring"]["own"] == [1, 2]


@pytest.mark.parametrize(
    "value",
    [
        {"a": [-0.0, 0.0, 1e-7, (1, (-0.0,))]}, {1: {"b": 2}, "c": None}, {"a": {1: [True]}}, {"": "\u00e9\u2028\x00"}, [[], {}, ()],
        {"a": np.float64(0.1), "b": [np.float64(-0.0)]}, MappingProxyType({"a": 1}), {"a": MappingProxyType({2: (3,)})}, deep(61), -0.0,
    ],
)  # fmt: skip
def test_a_certificate_is_written_as_in_its_document(value: Any) -> None:
    scene = Scene(certificate={"said": value})
    assert dump_scene(scene, "json") == dump_text(write_scene(scene), "json")


@pytest.mark.parametrize("bad", [{None: 1}, {True: 1}, {1.5: 1}, {"\ud800": 1}, ["\ud800"], [math.nan], [-math.inf], [{1, 2}], deep(64)])
def test_what_no_certificate_can_say_is_refused_by_place(bad: Any) -> None:
    with pytest.raises(SceneError) as refused:
        dump_scene(Scene(certificate={"said": {"deep": bad}}), "json")
    assert refused.value.field.startswith("certificate.said.deep")


def test_a_request_survives() -> None:
    request = Request(
        seed=7, width=12.5, use_spine=False, force_types={3: "office", 0: "kitchen"}, program={"office": 1, "bedrooms": 2}, area=80.0
    )
    document = write_request(request)
    assert document["force_types"] == {"0": "kitchen", "3": "office"}
    for name in FORMATS:
        assert read_request(load_text(dump_text(document, name), name)) == request
