"""The example of a catalog of one's own: the documented commands run, the new things are in the house, mistakes are named."""

from __future__ import annotations

import io
import json
import re
import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import yaml
from starlette.testclient import TestClient

import catalogs
from catalogs import CatalogError, load_catalogs
from service.app import create_app
from service.cli import main

FOLDER = Path(catalogs.__file__).parent
EXAMPLE = FOLDER / "example"
ROOT = FOLDER.parent
SECTION = (ROOT / "docs" / "catalog.md").read_text().split("## A catalog of your own")[1].split("\n## ")[0]
COMMANDS = [line.split("#")[0].split() for line in SECTION.splitlines() if line.startswith("compose ")]
Captured = pytest.CaptureFixture[bytes]


def documented(name: str) -> list[str]:
    """The words of the documents' command of that name."""
    (words,) = [words[1:] for words in COMMANDS if words[1] == name]
    return shlex.split(" ".join(words))


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What the documented command writes."""
    words = documented("generate")
    path = tmp_path_factory.mktemp("example") / words[words.index("--output") + 1]
    words[words.index("--output") + 1] = str(path)
    words[words.index("--catalog") + 1] = str(ROOT / words[words.index("--catalog") + 1])
    assert main(words) == 0
    return dict(yaml.load(path.read_text(), yaml.CSafeLoader))


def test_what_the_example_adds_is_in_the_house(house: dict[str, Any]) -> None:
    (room,) = [room for room in house["rooms"] if room["type"] == "music_room"]
    (cabinet,) = [piece for piece in room["furniture"] if piece["name"] == "record_cabinet"]
    lying = [thing for thing in room["decorations"] if thing["parent"] == cabinet["id"]]
    assert {thing["name"] for thing in lying} >= {"record_player", "records"}
    known = load_catalogs(EXAMPLE)
    assert house["request"] == {**house["request"], "program": "musician", "style": "coastal"}
    assert house["generator"]["catalog"] == known.fingerprint != load_catalogs().fingerprint
    assert cabinet["color"] in known.styles["coastal"].palette["storage"]
    assert room["flooring"]["color"] == known.styles["coastal"].floors["wood"][0].color


def test_the_example_adds_one_of_each_and_changes_nothing() -> None:
    ours, known = load_catalogs(), load_catalogs(EXAMPLE)
    sections = ("furniture", "decorations", "decorating", "rooms", "styles", "presets", "people")
    added = {section: set(getattr(known, section)) - set(getattr(ours, section)) for section in sections}
    assert all(added.values())
    for section in sections:
        assert {name: getattr(known, section)[name] for name in getattr(ours, section)} == getattr(ours, section)
    assert all(f"`{name}`" in SECTION for name in added["presets"])


def test_every_file_of_the_example_is_a_catalog_s_and_named_in_the_documents() -> None:
    names = sorted(str(path.relative_to(EXAMPLE)) for path in EXAMPLE.rglob("*") if path.is_file())
    assert len(names) == 7
    assert [name for name in names if f"`{name}`" not in SECTION] == []


def test_the_other_documented_commands_run(
    house: dict[str, Any], tmp_path: Path, capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert {words[1] for words in COMMANDS} == {"generate", "export", "stats", "catalog"}
    (tmp_path / "musician.yaml").write_text(json.dumps(house))  # JSON is YAML, too
    monkeypatch.chdir(tmp_path)
    assert main([str(EXAMPLE) if word == "catalogs/example" else word for word in documented("export")]) == 0
    assert list((tmp_path / "musician").glob("*.png"))
    monkeypatch.chdir(ROOT)
    assert main([*documented("stats"), "--workers", "1"]) == 0
    table = capfdbinary.readouterr().out.decode()
    assert re.search(r"^\| music_room +\|", table, re.MULTILINE)
    assert main(documented("catalog")) == 0
    listed = yaml.load(capfdbinary.readouterr().out, yaml.CSafeLoader)
    assert ("record_cabinet" in listed["furniture"], "coastal" in listed["styles"]) == (True, True)


def test_the_service_shows_and_uses_it() -> None:
    client = TestClient(create_app(load_catalogs(EXAMPLE)))  # one that is not entered starts a process for a call, not all beforehand
    shown = client.get("/catalog").json()
    made = client.post("/generate", json={"seed": 1, "program": "musician", "style": "coastal"}).json()
    assert ("record_player" in shown["decorations"], "musician" in shown["presets"], "music_room" in shown["rooms"]) == (True,) * 3
    assert "music_room" in {room["type"] for room in made["scene"]["rooms"]}


def test_its_rooms_are_judged_placed_and_repaired_by_it(
    house: dict[str, Any], tmp_path: Path, capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    bare = {**house, "rooms": [{**room, "furniture": [], "decorations": []} for room in house["rooms"] if room["type"] == "music_room"]}
    (tmp_path / "bare.json").write_text(json.dumps({**bare, "dynamic": [], "certificate": None}))
    lacking = []
    for more in ([], ["--catalog", str(EXAMPLE)]):
        main(["validate", str(tmp_path / "bare.json"), "--format", "json", *more])
        issues = json.loads(capfdbinary.readouterr().out)["issues"]
        lacking.append([issue["message"] for issue in issues if issue["rule"] == "missing_required"])
    assert not lacking[0]
    assert "piano" in lacking[1][0]
    asked = "room: {width: 4, depth: 3, id: a}\npieces: [{id: c, name: record_cabinet}]\n"
    for more, status in (([], 2), (["--catalog", str(EXAMPLE)], 0)):
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(asked.encode())))
        assert main(["place", *more]) == status
    (tmp_path / "house.json").write_text(json.dumps(house))
    assert main(["fix", str(tmp_path / "house.json"), "--catalog", str(EXAMPLE), "-o", str(tmp_path / "fixed.json")]) == 0
    assert json.loads((tmp_path / "fixed.json").read_text())["rooms"] == house["rooms"]


@dataclass(frozen=True)
class Mistake:
    """A slip in one of the example's files; the key that must be named, and a word of what is said."""

    file: str
    old: str
    new: str
    key: str
    says: str

    def __str__(self) -> str:
        return f"{self.file} {self.new}"


MISTAKES = [
    Mistake("furniture.yaml", "height: 0.8}", "height: 0.9}", "record_cabinet.surfaces.1.height", "above the piece"),
    Mistake("decorations.yaml", "mixed: true", "mixt: true", "records.mixt", "is not known"),
    Mistake("decorating.yaml", "record_cabinet:", "record_closet:", "record_closet", "unknown parent"),
    Mistake("decorating.yaml", "put: record_player", "put: rug", "record_cabinet.lies.0.put", "larger than its surface"),
    Mistake("decorating.yaml", "surface: shelf", "surface: cellar", "record_cabinet.lies.1.surface", "unknown surface"),
    Mistake("styles.yaml", "floors: {wood:", "floors: {moss:", "coastal.floors.moss", "moss"),
    Mistake("styles.yaml", '"#7fa3b8"', '"sea"', "coastal.palette.seating.0", "#rrggbb"),
    Mistake("presets.yaml", "music_room: 1", "ballroom: 1", "musician.rooms.ballroom", "music_room"),
    Mistake("people.yaml", "rooms: music_room", "rooms: ballroom", "musicians.rooms", "unknown room type"),
    Mistake("rooms/music_room.yaml", "of: piano", "of: violin", "pieces.1.rules.0.of", "violin"),
    Mistake("rooms/music_room.yaml", "cover: [0.2, 0.32]", "cover: [0.4, 0.32]", "cover", "[least, most]"),
]


@pytest.mark.parametrize("slip", MISTAKES, ids=str)
def test_a_mistake_is_refused_by_file_key_and_line(tmp_path: Path, capfdbinary: Captured, slip: Mistake) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "mine")
    path = tmp_path / "mine" / slip.file
    text = path.read_text()
    assert slip.old in text
    path.write_text(text.replace(slip.old, slip.new, 1))
    line = next(number for number, words in enumerate(path.read_text().splitlines(), 1) if slip.new in words)
    with pytest.raises(CatalogError) as caught:
        load_catalogs(tmp_path / "mine")
    assert (caught.value.file, caught.value.key, caught.value.line) == (str(path), slip.key, line)
    assert main(["generate", "--catalog", str(tmp_path / "mine")]) == 2
    said = capfdbinary.readouterr()
    assert said.out == b""
    assert said.err.decode().startswith(f"compose: {path}:{line}: {slip.key}: ")
    assert slip.says in said.err.decode()
