"""What exists is written down: every key, rule, relation, room type, call and command, with the code's own defaults."""

from __future__ import annotations

import re
from argparse import _SubParsersAction
from dataclasses import MISSING, fields
from typing import Any, get_args

import pytest

from catalogs import load_catalogs
from catalogs.decoration_types import Decorating, DecorationKind, Group, Hangs, Lies, Stands
from catalogs.entries import Category, Dweller, Home, Leaving, Plan, Preset, Run
from catalogs.schema import FurnitureSpec, PieceSpec, RelationSpec, RelationWord, RoomType
from catalogs.shapes import Form, Material, ShapePart
from catalogs.styles import Style
from service.app import create_app
from service.cli import parser
from solver import scene
from solver.request import Request
from solver.validator import RULES
from tests.docs.markdown import rows, section, text_of, words
from tests.every import every

OURS = load_catalogs()
RECORDS: dict[str, type[Any]] = {
    "scene": scene.Scene,
    "size": scene.Size,
    "level": scene.Level,
    "room": scene.Room,
    "opening": scene.Opening,
    "furniture": scene.Furniture,
    "decoration": scene.Decoration,
    "dynamic": scene.Dynamic,
}
SAID = {
    "null": (None,),
    "left out": (None,),
    "required": (MISSING, 0.0),
    "made up": (MISSING,),
    "[]": ((),),
    "false": (False,),
    "true": (True,),
}
"""The defaults that the tables say in words, and what they are in code."""


@pytest.mark.parametrize("record", RECORDS)
def test_every_key_of_a_scene_is_explained_with_its_default(record: str) -> None:
    declared = {field.name: field.default for field in fields(RECORDS[record]) if field.name != "extra"}
    told: list[str] = []
    for key, _, default, *_ in rows(section("scene.md", record)):
        for name in words(key):
            told.append(name)
            text = default.strip("`")
            assert (text, declared[name]) == (text, declared[name]) and _is(text, declared[name]), f"{record}.{name}: {default}"
    assert sorted(told) == sorted(declared)


def _is(text: str, default: object) -> bool:
    if text in SAID:
        return default in SAID[text]
    return str(default) == text or (isinstance(default, float | int) and _number(text) == default) or text.startswith("its place")


def _number(text: str) -> float | None:
    return float(text) if re.fullmatch(r"-?[\d.]+", text) else None


def test_every_rule_is_explained_with_its_severity() -> None:
    told = {words(cells[0])[0]: cells[1] for cells in rows(section("scene.md", "The rules")) if words(cells[0])}
    assert told == RULES


def test_what_rooms_require_is_what_the_catalogs_say() -> None:
    told = {name.strip(): cells[1] for cells in rows(section("scene.md", "The rules")) if len(cells) == 2 for name in cells[0].split(",")}
    ours = OURS.rooms
    assert set(told) == {name for name, kind in ours.items() if kind.requires}
    for name, text in told.items():
        assert all(any(kind in text for kind in line) for line in ours[name].requires), name


def test_every_relation_has_a_row_and_no_other_has() -> None:
    told = [words(cells[0])[0] for cells in rows(section("relations.md", "The relations"))]
    assert sorted(told) == sorted(get_args(RelationWord))


def test_every_key_of_a_relation_is_explained() -> None:
    told = [name for cells in rows(section("relations.md", "Keys")) for name in words(cells[0])]
    assert sorted(told) == sorted(RelationSpec.model_fields)


@pytest.mark.parametrize(
    ("heading", "described"),
    [
        ("Furniture", (FurnitureSpec,)),
        ("Room types", (RoomType, Run, Leaving, Plan, Home, PieceSpec)),
        ("Programmes and presets", (Preset,)),
        ("Decorations", (DecorationKind, Decorating, Lies, Hangs, Stands)),
        ("People and pets", (Dweller,)),
        ("Styles", (Style,)),
        ("Shapes and materials", (ShapePart, Material)),
    ],
)
def test_every_key_of_the_catalog_is_explained(heading: str, described: tuple[type[Any], ...]) -> None:
    text = section("catalog.md", heading)
    keys = [field.alias or key for of in described for key, field in of.model_fields.items()]
    assert [key for key in keys if not re.search(rf"`(\w+: )?{key}\b|\b{key}:", text)] == []


@every(
    "word",
    [*get_args(Category), *get_args(Group), *get_args(Form), *load_catalogs().rooms, *load_catalogs().styles, *load_catalogs().presets],
)
def test_every_category_group_form_type_style_and_preset_is_named(word: str) -> None:
    assert re.search(rf"\b{word}\b", text_of("catalog.md"))


def test_every_call_is_explained() -> None:
    calls = {f"{method.upper()} {path}" for path, item in create_app().openapi()["paths"].items() for method in item}
    headings = set(re.findall(r"^## ((?:GET|POST|PATCH|PUT|DELETE) .+)$", text_of("api.md") + text_of("saved-homes.md"), re.MULTILINE))
    assert headings == calls


def test_every_key_of_a_request_is_explained_with_its_default() -> None:
    told = {name: cells for cells in rows(section("api.md", "POST /generate")) for name in words(cells[0])}
    declared = {field.name: field for field in fields(Request)}
    assert set(told) - {"scene", "reroll", "effort"} == set(declared)


def test_every_command_and_option_is_explained() -> None:
    (commands,) = [action for action in parser()._actions if isinstance(action, _SubParsersAction)]
    headings = set(re.findall(r"^## `(\w+)`$", text_of("cli.md"), re.MULTILINE))
    assert headings == set(commands.choices)
    shared = section("cli.md", "Options of several commands")
    for name, command in commands.choices.items():
        told = section("cli.md", f"`{name}`") + shared
        options = [option for action in command._actions for option in action.option_strings if option.startswith("--")]
        options = [option for option in options if option != "--help" and not option.startswith("--no-")]
        assert [option for option in options if f"`{option}" not in told] == [], name


def test_every_shared_option_is_said_to_be_of_the_commands_that_take_it() -> None:
    (commands,) = [action for action in parser()._actions if isinstance(action, _SubParsersAction)]
    takes = {name: {word for one in command._actions for word in one.option_strings} for name, command in commands.choices.items()}
    told: dict[str, set[str]] = {}
    for option, of, *_ in rows(section("cli.md", "Options of several commands")):
        named, word = set(words(of)), words(option)[0].split()[0]
        like = next((one for one in named if one.startswith("--")), None)
        told[word] = told[like] - named if like else set(takes) - named if of.startswith("all but") else named
    assert {"--catalog", "--assets", "--license", "--engine", "--output", "--format"} <= set(told)
    assert told == {word: {name for name, options in takes.items() if word in options} for word in told}


def test_the_words_of_the_glossary_are_in_order_and_few() -> None:
    told = [cells[0] for cells in rows(text_of("glossary.md"))]
    assert told == sorted(told, key=str.lower)
    assert len(set(told)) == len(told) <= 45
