"""What the documents show runs: commands, requests and programs; and the answers are as they say."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml
from starlette.testclient import TestClient

from catalogs import load_catalogs
from catalogs.schema import RelationSpec
from scripts import debug_room
from service import calls
from service.cli import main, parser
from solver.exchange import read_scene
from tests.assets.makers import folder, shape
from tests.docs.markdown import ROOT, Block, blocks, documents, following, rows, section

SHELLS = blocks("sh")
RUN = [block for block in blocks("sh", "run") if "--catalog catalogs/example" not in block.text]
"""What is to run; the commands with the example of a catalog tests/catalogs/test_example.py runs, and looks at what they write."""
CATALOG_FILES = ("furniture", "presets", "decorating", "shapes", "styles", "people")


def name_of(block: Block) -> str:
    return f"{block.place} {block.says}"


def commands(block: Block) -> list[list[str]]:
    """The words of each line of a block, its comments left out."""
    return [found for line in block.text.splitlines() if (found := shlex.split(line, comments=True))]


def here(word: str) -> str:
    """A word, made absolute where it names something of the project."""
    return str(ROOT / word) if "/" in word and (ROOT / word).exists() else word


@pytest.mark.parametrize("block", RUN, ids=name_of)
def test_a_block_that_is_to_run_runs(block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for program, *words in commands(block):
        if program.endswith("compose"):
            assert main([here(word) for word in words]) == 0, words
        else:
            assert words[:2] == ["-m", "scripts.debug_room"], "only compose and scripts.debug_room are run"
            assert debug_room.main(words[2:]) == 0


@pytest.mark.parametrize("block", SHELLS, ids=name_of)
def test_every_command_is_one(block: Block) -> None:
    targets = (ROOT / "Makefile").read_text()
    for program, *words in commands(block):
        if program.endswith("compose"):
            parser().parse_args([word for word in words if word != "..."])
        elif program == "make":
            assert all(f"\n{word}:" in targets or "=" in word for word in words), words
        elif program.endswith("python"):
            tests = [word for word in words if word.startswith("tests/")]
            assert words[0] == "-m" and all((ROOT / word).exists() for word in tests), words
        else:
            assert program in ("curl", "git", "pip", "cd"), program


@pytest.mark.parametrize("block", [block for block in SHELLS if "curl" in block.text], ids=name_of)
def test_every_request_is_answered_as_it_says(block: Block, client: TestClient) -> None:
    files = {found.says.removeprefix("file "): found.text for found in blocks("json", "file ")}
    for words in commands(block):
        if words[0] != "curl":
            continue
        options = dict(zip(words[1:-1:2], words[2:-1:2], strict=True))
        path, body = words[-1].removeprefix("http://127.0.0.1:8000"), options.get("-d", options.get("--data-binary"))
        if body is None:
            answer = client.get(path)
        else:
            text = (files.get(body[1:]) or (ROOT / body[1:]).read_text()) if body.startswith("@") else body
            headers = dict([options["-H"].split(": ")]) if "-H" in options else {}
            answer = client.post(path, content=text.encode(), headers={"Content-Type": "application/x-www-form-urlencoded", **headers})
        shown = following(block)
        told = shown if shown is not None and shown.says.startswith("answer") else None
        assert answer.status_code == int((told and told.says.removeprefix("answer")) or 200), answer.text[:500]
        if told is not None:
            holds(json.loads(told.text), answer.json())


@pytest.mark.parametrize("block", blocks("json", "POST /"), ids=name_of)
def test_every_body_is_answered_as_it_says(block: Block) -> None:
    answer = calls.CALLS[block.says.removeprefix("POST /")](json.loads(block.text), load_catalogs())
    told = following(block)
    assert told is not None
    assert told.says == "answer"
    holds(json.loads(told.text), json.loads(json.dumps(answer)))


def holds(shown: Any, real: Any, at: str = "answer") -> None:
    """Asserts that what is shown is in the answer: keys may be left out, entries of lists that have an id too."""
    if isinstance(shown, Mapping):
        for key, value in shown.items():
            assert key in real, f"{at}.{key}"
            holds(value, real[key], f"{at}.{key}")
    elif _by_id(shown):
        known = {entry["id"]: entry for entry in real}
        for entry in shown:
            assert entry["id"] in known, f"{at}: {entry['id']}, there are {', '.join(known)}"
            holds(entry, known[entry["id"]], f"{at}[{entry['id']}]")
    elif isinstance(shown, list):
        assert len(shown) == len(real), f"{at}: {real}"
        for index, (one, other) in enumerate(zip(shown, real, strict=True)):
            holds(one, other, f"{at}[{index}]")
    else:
        assert shown == real, at


def _by_id(entries: Any) -> bool:
    """Tells whether what is shown is a list of things that their ids tell apart."""
    ids = [entry.get("id") if isinstance(entry, Mapping) else None for entry in entries] if isinstance(entries, list) else []
    return bool(ids) and None not in ids and len(set(ids)) == len(ids)


@pytest.mark.parametrize("block", blocks("json", "scene"), ids=name_of)
def test_every_scene_is_one_and_clean(block: Block) -> None:
    document = json.loads(block.text)
    assert read_scene(document).rooms
    assert calls.CALLS["validate"]({"scene": document}, load_catalogs())["issues"] == []


@pytest.mark.parametrize("block", blocks("yaml", "scene of"), ids=name_of)
def test_a_part_of_a_scene_is_of_the_scene_that_the_command_prints(block: Block, capsysbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(block.says.removeprefix("scene of ").split()) == 0
    holds(yaml.load(block.text, yaml.CSafeLoader), yaml.load(capsysbinary.readouterr().out, yaml.CSafeLoader), "scene")


@pytest.mark.parametrize("block", blocks("python"), ids=name_of)
def test_every_program_runs(block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    folder(tmp_path / "furniture", {"oak.glb": shape("sofa")}, {"oak": {"file": "oak.glb", "kinds": ["sofa"], "license": "MIT"}})
    exec(compile(block.text, block.place, "exec"), {"__name__": "example"})


def test_every_example_of_the_catalog_is_taken(tmp_path: Path) -> None:
    for name in CATALOG_FILES:
        (block,) = blocks("yaml", name)
        folder = tmp_path / "shapes" if name == "shapes" else tmp_path
        folder.mkdir(exist_ok=True)
        (folder / f"{name}.yaml").write_text(block.text)
    stool = "milking_stool: {category: seating, size: [0.4, 0.4, 0.4], color: '#8a6a45', mass: 3, stands: free,\n"
    stool += "  surfaces: [{name: seat, height: 0.4}]}\n"
    example, furniture = ROOT / "catalogs" / "example", tmp_path / "furniture.yaml"
    furniture.write_text(furniture.read_text() + stool + (example / "furniture.yaml").read_text())
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "music_room.yaml").write_text((example / "rooms" / "music_room.yaml").read_text())
    taken = load_catalogs(tmp_path)
    assert len(taken.shapes["milking_stool"]) == 5
    assert taken.presets["couple"].rooms["bedrooms"] == 2
    assert "musicians" in taken.people


def test_every_command_of_pytest_chooses_tests() -> None:
    chosen = [re.findall(r"pytest (tests/\S+\.py) -k (\w+)", block.text) for block in blocks("sh")]
    named = [found for one in chosen for found in one]
    assert named
    for path, word in named:
        assert re.search(rf"^def test_\w*{word}", (ROOT / path).read_text(), re.MULTILINE), (path, word)


def test_every_example_of_a_relation_is_one() -> None:
    (block,) = blocks("yaml", "relations")
    told = [*yaml.load(block.text, yaml.CSafeLoader)]
    for cells in rows(section("relations.md", "The relations")):
        rule = RelationSpec.model_validate(yaml.load(cells[-1].strip("`").replace("type: on,", 'type: "on",'), yaml.CSafeLoader))
        assert f"`{rule.type}`" == cells[0]
    assert all(RelationSpec.model_validate(entry) for entry in told)


def test_every_block_says_what_it_is() -> None:
    known = {"sh", "json", "yaml", "python", ""}
    for name in documents():
        text = documents()[name]
        assert {line[3:].split(" ")[0] for line in text.splitlines() if line.startswith("```")} <= known, name
