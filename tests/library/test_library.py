"""The public library: its examples run, scenes go through files, what is wrong is said."""

from __future__ import annotations

import doctest
import json
import pickle
import re
from inspect import isclass, isfunction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import compose_homes
from catalogs import add_assets, load_catalogs
from compose_homes import (
    ComposeError,
    PieceRequest,
    RelationSpec,
    Request,
    RequestError,
    Room,
    Scene,
    SceneError,
    SyntaxFault,
    dump,
    fix,
    generate,
    load,
    place,
    validate,
)
from solver import validator

PUBLIC = {name: getattr(compose_homes, name) for name in compose_homes.__all__}
FUNCTIONS = [member for member in PUBLIC.values() if isfunction(member) and member not in (add_assets, load_catalogs)]


@pytest.fixture(scope="module")
def house() -> Scene:
    return generate(Request(seed=42, width=7, depth=5)).scene


def test_every_function_is_told_with_an_example_that_runs() -> None:
    assert {function.__name__ for function in FUNCTIONS} == {
        "dump",
        "explain",
        "export",
        "fix",
        "fix_frame",
        "furnish",
        "import_plan",
        "generate",
        "load",
        "place",
        "reroll",
        "restyle",
        "validate",
    }
    for function in FUNCTIONS:
        (found,) = doctest.DocTestFinder().find(function, function.__name__)
        assert len(found.examples) > 1, function.__name__
        assert doctest.DocTestRunner().run(found).failed == 0


def test_every_public_name_is_there_and_documented() -> None:
    assert [name for name, member in PUBLIC.items() if isclass(member) and not member.__doc__] == []
    with pytest.raises(AttributeError, match="castle"):
        getattr(compose_homes, "castle")  # noqa: B009 - no checker shall see it


@pytest.mark.parametrize("name", ["house.json", "house.yaml", "house.YML", "house.txt"])
def test_a_scene_goes_through_a_file(house: Scene, tmp_path: Path, name: str) -> None:
    text = dump(house, tmp_path / name)
    assert (tmp_path / name).read_text() == text == dump(house, str(tmp_path / name))
    assert text.startswith("{") == name.endswith("json")
    for source in (tmp_path / name, str(tmp_path / name), text, text.encode()):
        assert load(source) == house


def test_a_format_wins_over_the_name(house: Scene, tmp_path: Path) -> None:
    dump(house, tmp_path / "house.json", format="yaml")
    assert (tmp_path / "house.json").read_text().startswith("format: compose-scene/1")
    assert load(tmp_path / "house.json", format="yaml") == house
    with pytest.raises(SyntaxFault, match="not JSON"):
        load(tmp_path / "house.json")


@pytest.mark.parametrize(("name", "format"), [("house.glb", None), ("house.USD", None), ("house.yaml", "glb"), (None, "svg")])
def test_what_export_writes_is_refused_with_its_name(house: Scene, tmp_path: Path, name: str | None, format: str | None) -> None:
    with pytest.raises(RequestError, match=r"export\(scene, '(glb|usd|svg)'\) does"):
        dump(house, tmp_path / name if name else None, format=format)
    assert not any(tmp_path.iterdir())
    assert dump(house, tmp_path / "told.glb", format="yaml") == dump(house)


def test_of_an_answer_the_scene_is_read(house: Scene) -> None:
    answer = {"scene": json.loads(dump(house, format="json")), "issues": []}
    assert load(json.dumps(answer)) == load(answer) == load(answer["scene"]) == house


@pytest.mark.parametrize(
    ("text", "error", "words"),
    [
        ('{"rooms": [{"width": -3, "depth": 2}]}', SceneError, r"rooms\[0\].width"),
        ("{", SyntaxFault, "not JSON"),
        ("rooms: [\n", SyntaxFault, "not YAML"),
        (b"", SyntaxFault, "empty"),
        ("no-such-file.yaml", FileNotFoundError, "no-such-file.yaml"),
    ],
)
def test_what_cannot_be_read_is_told(text: str | bytes, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        load(text)


def test_an_engine_that_is_none_is_refused() -> None:
    with pytest.raises(RequestError, match="engine: is 'magic'"):
        generate(Request(seed=1, width=4, depth=4), engine="magic")


@pytest.mark.parametrize(
    ("wrong", "field"),
    [
        ({"width": "wide"}, "width"),
        ({"program": {"bedrooms": "two"}}, "program.bedrooms"),
        ({"force_types": {"3": "offfice"}}, "force_types[3]"),
        ({"seed": -3}, "seed"),
        ({"seed": "3"}, "seed"),
        ({"robot_width": -1}, "robot_width"),
        ({"use_spine": 1}, "use_spine"),
    ],
)
def test_a_request_made_in_python_is_checked(wrong: dict[str, Any], field: str) -> None:
    with pytest.raises(RequestError) as told:
        generate(Request(**{"seed": 3, **wrong}))
    assert told.value.field == field


def test_what_is_no_request_is_refused() -> None:
    with pytest.raises(RequestError, match="request: is an object"):
        generate({"seed": 3})  # type: ignore[arg-type]


def test_a_piece_is_called_by_what_is_said_of_it() -> None:
    assert PieceRequest("desk") == PieceRequest(name="desk") == PieceRequest("desk", "desk")
    assert {piece.id for piece in place(Room("den", width=4, depth=3), [PieceRequest("desk")]).best.scene.rooms[0].furniture} == {"desk"}
    with pytest.raises(RequestError, match=r"pieces\[1\].id: is missing, and so is the name"):
        place(Room("den", width=4, depth=3), [PieceRequest("desk"), PieceRequest(width=1.0)])


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"type": "besides"}, "type: is 'besides'; beside? (allowed: against_wall, "),
        ({"type": "near", "off": "desk"}, "off: is not known; of? (allowed: type, of, "),
        ({"of": "desk"}, "type: is missing (allowed: against_wall, "),
        ({"type": "near", "cost": -1}, "cost: is -1 (allowed: a number from 0"),
        ({"type": "against_wall", "walls": {"doors": 1}}, "walls.doors: is 'doors'; door? (allowed: door, "),
        ({"type": "beside", "gap": (3, 1)}, "gap: must be [least, most]"),
    ],
)
def test_a_wrong_relation_is_refused_in_the_words_of_the_catalogs(wrong: dict[str, Any], told: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(told)}") as refused:
        RelationSpec(**wrong)
    assert type(refused.value) is ValueError


def test_numbers_of_an_array_make_the_same_house(house: Scene) -> None:
    numbers: dict[str, Any] = {"seed": np.int64(42), "width": np.float32(7), "depth": np.int32(5)}
    assert generate(Request(**numbers)).scene == house


def test_what_fix_does_not_do_on_a_conflict_is_refused(house: Scene) -> None:
    with pytest.raises(RequestError, match="on_conflict: is 'banana'"):
        fix(house, on_conflict="banana")


@pytest.mark.parametrize("of", [str, Path])
def test_catalogs_are_read_from_a_path_or_its_text(tmp_path: Path, of: type[str] | type[Path]) -> None:
    (tmp_path / "floorings.yaml").write_text('lava: {color: "#ff4400"}\n')
    assert load_catalogs(of(tmp_path)).floorings["lava"].color == "#ff4400"


def test_every_error_is_a_compose_error(tmp_path: Path) -> None:
    errors = [member for member in PUBLIC.values() if isclass(member) and issubclass(member, Exception)]
    assert len(errors) == 6 and all(issubclass(error, ComposeError) for error in errors)
    with pytest.raises(ComposeError, match="holds no catalog") as told:
        load_catalogs(tmp_path)
    assert str(pickle.loads(pickle.dumps(told.value))) == str(told.value)
    assert str(told.value).startswith(f"{tmp_path}: holds no catalog (")
    with pytest.raises(ComposeError, match="gone: is no folder"):
        load_catalogs(tmp_path / "gone")


def test_a_scene_is_validated_with_our_catalogs_where_none_are_given() -> None:
    scene = Scene(rooms=(Room("kitchen", type="kitchen", width=4.0, depth=3.0),))
    found = validate(scene)
    assert found == validate(scene, load_catalogs()) == validator.validate(scene, load_catalogs())
    assert {issue.rule for issue in found} >= {"missing_required"}
