"""Texts that are no documents, or not ours: refused quickly, in words, and never by another error."""

from __future__ import annotations

import math
import time
from enum import Enum
from typing import Any

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from catalogs import yaml_reading
from compose_homes import Furniture, Room, Scene, fix
from solver.core import CoreFailed
from solver.errors import SceneError, SyntaxFault
from solver.exchange import FORMATS, dump_text, load_text, read_scene
from tests.every import every
from tests.sweeps import examples

PATIENCE_S = 60.0
"""What a refusal may take of the processor: they take less than a second; what they guard against would take hours."""


def refused(text: bytes | str, name: str) -> str:
    with pytest.raises(SyntaxFault) as caught:
        load_text(text, name)
    return str(caught.value)


@every(
    ("text", "name"),
    [
        ("", "json"),
        ("{", "json"),
        ("{} {}", "json"),
        ("{'a': 1}", "json"),
        ("[1,]", "json"),
        ("nul", "json"),
        (b"\xff\xfe{}", "json"),
        (b"\x80", "yaml"),
        ('{"a": "\\ud800"}', "json"),
        ('{"\\uDC00": 1}', "json"),
        ("{} \ud800", "json"),
        ("1" * 5000, "json"),
        ("", "yaml"),
        ("# nothing", "yaml"),
        ("a: [", "yaml"),
        ("a: b: c", "yaml"),
        ("a: 1\n--- \nb: 2", "yaml"),
        ("\ta: 1", "yaml"),
        ("a: \x07", "yaml"),
        ("1" * 5000, "yaml"),
        ("? [a, b]\n: 1", "yaml"),
        ("? {a: b}\n: 1", "yaml"),
        ("a: 0x" + "f" * 5000, "yaml"),
        ("a: 0o" + "7" * 9000, "yaml"),
        ("a: !!int 0x" + "f" * 5000, "yaml"),
        ("a: !!float 1" + "0" * 310, "yaml"),
        ("a: !!float 0x" + "f" * 300, "yaml"),
        ("a: 1." + "0" * 5000, "yaml"),
        ("a: *nobody", "yaml"),
        ("a: &a [*a]", "yaml"),
        ("a: !!python/object/apply:os.system [ls]", "yaml"),
        ("a: !!python/name:os.system ''", "yaml"),
        ("a: !mine 3", "yaml"),
        ("a: !!int x", "yaml"),
        ("a: !!set {b, c}", "yaml"),
        ("a: !!timestamp 2024-01-01", "yaml"),
    ],
)
def test_texts_that_are_no_documents(text: bytes | str, name: str) -> None:
    assert refused(text, name)


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("levels", [65, 5000, 200_000])
@pytest.mark.parametrize(("opening", "closing"), [("[", "]"), ('{"a":', "}")])
def test_deep_nesting_is_refused(name: str, levels: int, opening: str, closing: str) -> None:
    start = time.process_time()
    assert "nested too deeply" in refused(opening * levels + "1" + closing * levels, name)
    assert refused(opening * levels, name)
    assert time.process_time() - start < PATIENCE_S
    assert load_text(opening * 64 + "1" + closing * 64, name)


def test_deep_blocks_are_refused() -> None:
    deep = "\n".join(" " * level + "a:" for level in range(2000))
    assert "nested too deeply" in refused(deep, "yaml")
    assert "nested too deeply" in refused("- " * 2000 + "1", "yaml")


@pytest.mark.parametrize("name", FORMATS)
def test_keys_given_twice_are_refused(name: str) -> None:
    assert "'a'" in refused('{"a": 1, "b": {"c": 2}, "a": 3}', name)
    assert "'c'" in refused('{"b": [{"c": 2, "c": 2}]}', name)
    assert load_text('{"a": {"c": 1}, "b": {"c": 2}}', name) == {"a": {"c": 1}, "b": {"c": 2}}


@pytest.mark.parametrize("name", ["json", "yaml"])
def test_long_numbers_and_names_are_refused_in_few_words_of_ours(name: str) -> None:
    with pytest.raises(SyntaxFault, match="number of more than") as told:
        load_text(f'{{"seed": {"9" * 5000}}}', name)
    assert "set_int" not in str(told.value)
    assert len(str(told.value)) < 100
    room = Room("den", width=4.0, depth=3.0, furniture=(Furniture("n" * 100_000, "sofa", x=2, z=1, width=2, depth=1, height=1),))
    with pytest.raises(SceneError) as refused:
        fix(Scene(rooms=(room,)), moved=["m" * 100_000])
    assert len(str(refused.value)) < 10_000
    assert len(refused.value.problem) + len(refused.value.allowed) < 10_000


def test_where_yaml_is_wrong_is_told() -> None:
    assert "line 2" in refused("a: 1\na: 2", "yaml")
    assert "line 2" in refused("a: 1\nb: [", "yaml") or "line 3" in refused("a: 1\nb: [", "yaml")


@pytest.mark.parametrize(("text", "name"), [('{"x": NaN}', "json"), ('{"x": -Infinity}', "json"), ('{"x": 1e999}', "json")])
def test_numbers_that_are_none_are_the_fields_fault(text: str, name: str) -> None:
    with pytest.raises(SceneError) as caught:
        read_scene(load_text(text, name))
    assert caught.value.field == "x"


@pytest.mark.parametrize("value", [".nan", ".NaN", ".inf", "-.inf", "+.INF", "1e999"])
def test_numbers_that_are_none_in_yaml(value: str) -> None:
    document = load_text(f"rooms: [{{width: {value}, depth: 3}}]", "yaml")
    with pytest.raises(SceneError) as caught:
        read_scene(document)
    assert caught.value.field == "rooms[0].width"


def bomb(levels: int) -> str:
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{level}: &a{level} [{', '.join([f'*a{level - 1}'] * 9)}]" for level in range(1, levels)]
    return "\n".join(lines)


def test_a_bomb_of_aliases_does_not_go_off() -> None:
    start = time.process_time()
    assert "aliases" in refused(bomb(10), "yaml")
    assert "aliases" in refused(bomb(10).replace("[", "{b: [").replace("]", "]}"), "yaml")
    assert time.process_time() - start < PATIENCE_S


def test_aliases_of_long_texts_and_keys_do_not_go_off() -> None:
    for long, times in (("x" * 100_000, 60), ("{" + "k" * 1000 + ": 1}", 6000)):
        assert "aliases" in refused(f"a: &a {long}\nb: [{', '.join(['*a'] * times)}]", "yaml")


def test_aliases_are_read_in_reason() -> None:
    assert load_text("a: &size {width: 3}\nb: *size\nc: [&x k, *x]\n*x : 1", "yaml") == {
        "a": {"width": 3},
        "b": {"width": 3},
        "c": ["k", "k"],
        "k": 1,
    }
    assert load_text(bomb(4), "yaml")


def test_yaml_is_read_by_its_core_schema() -> None:
    text = """
    on: yes
    off: No
    2024-01-01: 2024-01-01
    true: True
    null: ~
    0: 0x1F
    1.5: 0o17
    clock: 12:30:00
    grouped: 1_000
    zeros: 007
    small: 1e-5
    point: .5
    plus: +3
    tagged: !!str 5
    float: !!float 5
    plain: ! 5
    "quoted": "5"
    empty:
    """
    assert load_text(text, "yaml") == {
        "on": "yes",
        "off": "No",
        "2024-01-01": "2024-01-01",
        "true": True,
        "null": None,
        "0": 31,
        "1.5": 15,
        "clock": "12:30:00",
        "grouped": "1_000",
        "zeros": 7,
        "small": 1e-5,
        "point": 0.5,
        "plus": 3,
        "tagged": "5",
        "float": 5.0,
        "plain": "5",
        "quoted": "5",
        "empty": None,
    }


def test_a_byte_order_mark_is_no_part_of_the_text() -> None:
    for name in FORMATS:
        assert load_text(b"\xef\xbb\xbf" + b'{"a": 1}', name) == {"a": 1}
        assert load_text('\ufeff{"a": 1}', name) == {"a": 1}


def test_surrogate_pairs_are_characters() -> None:
    assert load_text('{"a": "\\ud83d\\ude00"}', "json") == {"a": "\U0001f600"}


@pytest.mark.parametrize("loader", [yaml.SafeLoader, yaml.CSafeLoader])
def test_yaml_is_the_same_with_and_without_the_c_library(loader: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(yaml_reading, "LOADER", loader)
    assert load_text("rooms:\n  - {id: a, on: null, x: 1.0}\n  - b\n", "yaml") == {"rooms": [{"id": "a", "on": None, "x": 1.0}, "b"]}
    assert refused("a: [" * 3000, "yaml")


@examples(120)
@given(st.sampled_from(sorted(FORMATS)), st.text() | st.binary() | st.text("{}[]:,\"'- \n&*!|>%#?a1.~", max_size=40))
def test_any_text_is_a_document_or_refused(name: str, text: bytes | str) -> None:
    try:
        load_text(text, name)
    except SyntaxFault as fault:
        assert str(fault)


def test_not_a_number_stays_one_until_it_is_refused_by_name() -> None:
    document = load_text("x: .nan", "yaml")
    assert isinstance(document, dict)
    assert math.isnan(document["x"])


class _Word(str, Enum):  # noqa: UP042 - not StrEnum, whose str() is the text
    """A text that is none of Python's own."""

    YES = "yes"


class _Length(float):
    """A number that is none of Python's own."""


@pytest.mark.parametrize("name", sorted(FORMATS))
def test_texts_and_numbers_of_other_types_are_written_as_pythons_own(name: str) -> None:
    given = {_Word.YES: [_Word.YES, _Length(1.5), (_Word.YES,)], "b": {"c": {"d": _Length(2.0)}}}
    own = {"yes": ["yes", 1.5, ["yes"]], "b": {"c": {"d": 2.0}}}
    assert dump_text(given, name) == dump_text(own, name)
    assert load_text(dump_text(given, name), name) == own


def test_what_is_no_json_is_not_written_as_yaml() -> None:
    """The core ends the call: it neither reads on behind the text nor writes a part of it."""
    whole = dump_text({"a": [1.5, "\u00e9\n\U0001f600", {"b": [[], {}]}], "c": {"d": None}}, "json").strip()
    wrong = [whole[:end] for end in range(len(whole))]
    wrong += [whole + b"]", b'{"a":1 2}', b'{"a" 1}', b"[1,]", b'"\\ud800"', b'"\\udc00"', b'"\\x"', b'"\\u12g4"']
    wrong += [b"[" * 3000 + b"]" * 3000]
    for text in wrong:
        with pytest.raises(CoreFailed):
            FORMATS["yaml"].of_json(text)
    for letter, meant in (('"\\ud83d\\ude00"', '"\\U0001F600"'), ('"\\/"', '"/"'), ('"\\b"', '"\\x08"'), ('"\\u0041"', "A")):
        assert FORMATS["yaml"].of_json(letter.encode()) == f"{meant}\n".encode()
