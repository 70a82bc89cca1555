"""The catalogs' README under test: every word is explained, and every example is a rule."""

from __future__ import annotations

import re
from pathlib import Path
from typing import get_args

import pytest
import yaml

import catalogs
from catalogs import load_catalogs
from catalogs.dressing import Dressing, Hangs, Lies, Stands
from catalogs.schema import Category, Plan, Relation, Rule
from catalogs.shapes import Form, Material, Part

README = (Path(catalogs.__file__).parent / "README.md").read_text()
ROWS = {match[1]: match[0] for match in re.finditer(r"^\| `(\w+)` \|.*$", README, re.MULTILINE)}


@pytest.mark.parametrize("relation", get_args(Relation))
def test_every_relation_has_a_row_with_an_example_that_is_one(relation: str) -> None:
    example = ROWS[relation].rsplit("`", 2)[1]
    rule = Rule.model_validate(yaml.safe_load(example.replace("type: on,", 'type: "on",')))
    assert rule.type == relation


def test_no_row_explains_a_relation_that_is_not() -> None:
    assert set(ROWS) == set(get_args(Relation))


@pytest.mark.parametrize("field", sorted(set(Rule.model_fields) - {"type"}))
def test_every_field_of_a_rule_is_explained(field: str) -> None:
    assert f"`{field}`" in README


@pytest.mark.parametrize("word", [*get_args(Category), *load_catalogs().rooms])
def test_every_category_and_room_type_is_named(word: str) -> None:
    assert re.search(rf"\b{word}\b", README)


@pytest.mark.parametrize("flag", sorted(Plan.model_fields))
def test_every_plan_flag_is_explained(flag: str) -> None:
    assert f"`{flag}`" in README


def test_adding_a_room_type_takes_five_lines() -> None:
    section = README.split("## Add a room type")[1].split("##")[0]
    assert len(re.findall(r"^\d\. ", section, re.MULTILINE)) == 5


@pytest.mark.parametrize("field", sorted({*Lies.model_fields, *Hangs.model_fields, *Stands.model_fields, *Dressing.model_fields}))
def test_every_field_of_a_dressing_is_explained(field: str) -> None:
    section = README.split("## Dress something")[1].split("## The")[0]
    assert re.search(rf"\b{field}\b", section)


def test_the_example_of_a_dressing_is_one() -> None:
    known = load_catalogs()
    example = yaml.safe_load(README.split("## Dress something")[1].split("```yaml")[1].split("```")[0])
    assert set(example) <= set(known.furniture) | set(known.rooms)
    rows = [
        row for entry in example.values() for kind in ("lies", "hangs", "stands") for row in getattr(Dressing.model_validate(entry), kind)
    ]
    assert len(rows) == 5
    assert {name for row in rows for name in row.put} <= set(known.decorations)


def test_the_example_of_a_shape_is_one(tmp_path: Path) -> None:
    section = README.split("## Give it a shape")[1].split("## Add a style")[0]
    (tmp_path / "shapes").mkdir()
    (tmp_path / "shapes" / "stools.yaml").write_text(section.split("```yaml")[1].split("```")[0])
    (tmp_path / "furniture.yaml").write_text(
        "milking_stool: {category: seating, size: [0.4, 0.4, 0.4], color: '#8a6a45', mass: 3, stands: free,\n"
        "                surfaces: [{name: seat, height: 0.4}]}\n"
    )
    assert len(load_catalogs(tmp_path).shapes["milking_stool"]) == 5


@pytest.mark.parametrize("word", [*get_args(Form), *Part.model_fields, *Material.model_fields])
def test_every_word_of_a_shape_is_explained(word: str) -> None:
    section = README.split("## Give it a shape")[1].split("## Add a style")[0]
    assert re.search(rf"\b{word}\b", section)
