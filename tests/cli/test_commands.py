"""Each command in this process: options, formats, refusals."""

from __future__ import annotations

import io
import json
import sys
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
import yaml
from starlette.testclient import TestClient

from service import generating
from service.cli import main, parser
from solver.request import Request
from tests.cli.programs import SMALL
from tests.docs.markdown import ROOT

Captured = pytest.CaptureFixture[bytes]


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A house in a file."""
    path = tmp_path_factory.mktemp("house") / "house.json"
    assert main(["generate", *SMALL, "-o", str(path)]) == 0
    return path


def refused(capture: Captured, *arguments: str) -> str:
    """Runs a command that must be refused; returns what it says."""
    assert main(arguments) == 2
    out, words = capture.readouterr()
    assert out == b""
    assert words.startswith(b"compose: ")
    assert words.count(b"\n") == 1
    return words.decode()


def test_every_field_of_a_request_has_an_option() -> None:
    for command in ("generate", "stats"):
        assert {field.name for field in fields(Request)} <= vars(parser().parse_args([command])).keys()


def test_options_make_the_request(tmp_path: Path, capfdbinary: Captured) -> None:
    numbers = ["--seed", "3", "--width", "8", "--depth", "6", "--min-room-size", "2.4", "--max-depth", "2", "--robot-width", "0.5"]
    others = ["--no-use-spine", "--outdoor", "--decorate", "--force-type", "0=living_room", "--style", "scandi"]
    main(["generate", *numbers, *others, "--format", "json"])
    request = json.loads(capfdbinary.readouterr().out)["request"]
    assert request == {
        "seed": 3, "width": 8.0, "depth": 6.0, "min_room_size": 2.4, "max_depth": 2, "robot_width": 0.5,
        "use_spine": False, "outdoor": True, "decorate": True, "force_types": {"0": "living_room"},
        "program": None, "area": None, "style": "scandi", "outline": None, "access": None,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("name", "form"), [("a.json", "json"), ("a.yaml", "yaml"), ("a.yml", "yaml"), ("a.txt", "yaml"), ("a.JSON", "json")]
)
def test_the_name_of_a_file_tells_its_format(house: Path, tmp_path: Path, name: str, form: str) -> None:
    assert main(["fix", str(house), "-o", str(tmp_path / name)]) == 0
    text = (tmp_path / name).read_text()
    assert (json.loads(text) if form == "json" else yaml.load(text, yaml.CSafeLoader)) == json.loads(house.read_text())
    assert text.startswith("{") == (form == "json")
    assert main(["view", str(tmp_path / name), "-o", str(tmp_path / "view")]) == 0


def test_format_wins_over_the_name(house: Path, tmp_path: Path) -> None:
    assert main(["fix", str(house), "-o", str(tmp_path / "a.json"), "--format", "yaml"]) == 0
    assert (tmp_path / "a.json").read_text().startswith("format: compose-scene/1")


def test_an_answer_of_the_service_is_taken_for_its_scene(house: Path, tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "answer.json").write_text(json.dumps({"scene": json.loads(house.read_text()), "issues": [], "timing_ms": {}}))
    main(["view", str(house)])
    main(["view", str(tmp_path / "answer.json")])
    text = capfdbinary.readouterr().out
    assert text[: len(text) // 2] == text[len(text) // 2 :]


def test_a_seed_is_drawn_where_there_is_none(capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(generating, "draw_seed", lambda: 77)
    main(["generate", "--width", "5", "--depth", "4"])
    assert yaml.load(capfdbinary.readouterr().out, yaml.CSafeLoader)["seed"] == 77


def test_many_houses_go_into_a_folder(tmp_path: Path, capfdbinary: Captured) -> None:
    small = ["--width", "6", "--depth", "5"]
    assert main(["generate", *small, "--seed", str(2**53 - 2), "-n", "3", "-o", str(tmp_path / "set")]) in (0, 1)
    assert sorted(path.name for path in (tmp_path / "set").iterdir()) == sorted(
        ["9007199254740990.yaml", "9007199254740991.yaml", "0.yaml", "made_from.json"]
    )
    assert capfdbinary.readouterr().out == b""
    main(["generate", *small, "--seed", "0"])
    assert (tmp_path / "set" / "0.yaml").read_bytes() == capfdbinary.readouterr().out
    assert "a folder" in refused(capfdbinary, "generate", *small, "-n", "2")


def test_a_set_without_a_seed_goes_on_where_it_was_ended(tmp_path: Path) -> None:
    """A seed that is drawn would lay a second set beside the first."""
    for count in ("1", "2"):
        assert main(["generate", "--width", "5", "--depth", "4", "-n", count, "--workers", "1", "-o", str(tmp_path)]) in (0, 1)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["0.yaml", "1.yaml", "made_from.json"]


def test_locked_and_moved_reach_the_solver(house: Path, capfdbinary: Captured) -> None:
    piece = next(body["id"] for room in json.loads(house.read_text())["rooms"] for body in room["furniture"])
    assert main(["fix", str(house), "--lock", piece, "--moved", piece, "--on-conflict", "remove"]) == 0
    capfdbinary.readouterr()
    assert f"{house}: locked[0]" in refused(capfdbinary, "fix", str(house), "--lock", "throne")
    assert "moved[1]" in refused(capfdbinary, "fix", str(house), "--moved", piece, "--moved", "throne")


def test_conflicts_and_removals_are_told(tmp_path: Path, capfdbinary: Captured) -> None:
    bed = {"name": "bed", "x": 1.0, "z": 1.0, "width": 1.6, "depth": 2.0, "height": 0.5}
    path = tmp_path / "cell.yaml"
    path.write_text(yaml.safe_dump({"rooms": [{"width": 2.0, "depth": 2.1, "furniture": [bed, bed]}]}))
    assert main(["fix", str(path)]) == 1
    assert b"conflict " in capfdbinary.readouterr().err
    main(["fix", str(path), "--on-conflict", "remove"])
    assert b"removed " in capfdbinary.readouterr().err


@pytest.mark.parametrize("form", ["json", "yaml"])
def test_export_writes_the_file_that_the_service_gives(client: TestClient, house: Path, tmp_path: Path, form: str) -> None:
    sent = {"rooms": [{"id": "den", "width": 3, "depth": 2, "by": "hand"}]}
    (tmp_path / "sent.yaml").write_text(yaml.safe_dump(sent))
    for name in (tmp_path / "sent.yaml", house):
        path = tmp_path / f"out.{form}"
        assert main(["export", str(name), "-o", str(path)]) == 0
        assert path.read_bytes() == client.post(f"/export/{form}", content=name.read_bytes(), headers=media_type(name)).content
    assert yaml.load(path.read_text(), yaml.CSafeLoader) == json.loads(house.read_text())


def test_export_refuses_what_is_no_scene(tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "bad.json").write_text('{"rooms": [{"width": -3, "depth": 2}]}')
    assert "scene.rooms[0].width" in refused(capfdbinary, "export", str(tmp_path / "bad.json"))


def media_type(path: Path) -> dict[str, str]:
    """The header that says what a file's body is."""
    return {"content-type": f"application/{path.suffix[1:]}"}


def test_catalog_and_schema_are_documents(capfdbinary: Captured) -> None:
    documents: list[Any] = []
    for arguments in (["catalog"], ["schema"], ["catalog", "--format", "json"], ["schema", "--format", "json"]):
        assert main(arguments) == 0
        text = capfdbinary.readouterr().out
        documents.append(json.loads(text) if "json" in arguments else yaml.load(text, yaml.CSafeLoader))
    assert documents[:2] == documents[2:]
    assert "bed" in documents[0]["furniture"]
    assert "rooms" in documents[1]["properties"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["generate", "--width", "1e9"], "width: is 1000000000.0 (allowed: a number from 2 to 1000"),
        (["generate", "--width", "nan"], "width: is nan"),
        (["generate", "--max-depth", "60000"], "max_depth: is 60000"),
        (["generate", "--force-type", "0=throne_room"], "force_types"),
        (["generate", "no-such-request.yaml"], "compose: no such file: no-such-request.yaml\n"),
        (["validate", "no-such-scene.yaml"], "compose: no such file: no-such-scene.yaml\n"),
        (["view", "."], "compose: .: is a folder, not a file\n"),
        (["schema", "-o", "/"], "compose: /: is a folder, not a file\n"),
        (["schema", "-o", "/proc/none/schema.json"], "compose: no such folder: /proc/none\n"),
        (["schema", "-o", "/dev/full"], "compose: the disk is full\n"),
        (["generate", "--catalog", "no-such-folder"], "no-such-folder"),
    ],
)
def test_bad_use_is_told_in_one_line(capfdbinary: Captured, arguments: list[str], words: str) -> None:
    assert words in refused(capfdbinary, *arguments)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.yaml", b"rooms: [\n  {width: 3\n", "a.yaml: not YAML"),
        ("a.json", b'{"rooms": [}', "a.json: not JSON"),
        ("a.yaml", b"", "a.yaml: the text is empty"),
        ("a.txt", b"\xff\xfe\x00", "a.txt: "),
        ("a.yaml", b"rooms: [{width: 3, depth: -1}]", "a.yaml: scene.rooms[0].depth: is -1"),
        ("a.yaml", b"[]", "a.yaml: scene"),
    ],
)
def test_a_bad_file_is_told_by_its_name(tmp_path: Path, capfdbinary: Captured, name: str, content: bytes, words: str) -> None:
    (tmp_path / name).write_bytes(content)
    for command in ("validate", "fix", "view"):
        assert words in refused(capfdbinary, command, str(tmp_path / name))


def test_a_folder_where_a_task_belongs_and_one_that_is_not_there_are_told(tmp_path: Path, capfdbinary: Captured) -> None:
    for command, tasks in (("assets", "check"), ("dataset", "make or check")):
        with pytest.raises(SystemExit):
            main([command, str(tmp_path)])
        assert f"{str(tmp_path)!r} is no task: {tasks}, then a folder" in capfdbinary.readouterr().err.decode()
    assert "none: is no folder (allowed: a folder of .glb files)" in refused(capfdbinary, "assets", "check", str(tmp_path / "none"))


def test_a_file_in_no_known_format_is_first_said_to_be_one(tmp_path: Path, capfdbinary: Captured) -> None:
    for name, words in (
        ("readme.md", "file: is in none of the formats that are read here; read as a scene: not YAML: "),
        ("plan", "file: is in none of the formats that are read here; read as a scene: not YAML: "),
        ("plan.yaml", "file: not YAML: "),
        ("empty", "file: the text is empty"),
    ):
        (tmp_path / name).write_text("" if name == "empty" else "# Plan\n\nA home: of\n  - two rooms\nand: [a bath\n")
        assert f"{name}: {words}" in refused(capfdbinary, "import", str(tmp_path / name))


@pytest.mark.parametrize("content", [b"\x7fELF\x02\x01\x01\0\0", b"\xe0\x9f\xff plan", b"\1\2\0"])
def test_a_file_that_is_no_text_is_told_to_be_in_no_known_format(tmp_path: Path, capfdbinary: Captured, content: bytes) -> None:
    for name in ("plan", "plan.bin", "plan.dxf", "plan.ifc", "plan.sh3d"):
        (tmp_path / name).write_bytes(content)
        words = refused(capfdbinary, "import", str(tmp_path / name))
        assert f"{name}: file: is in none of the formats that are read here, and no text in UTF-8 (allowed: a file of" in words
        assert "codec" not in words and "control characters" not in words


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("plan.geojson", (ROOT / "docs" / "plan.geojson").read_bytes()),
        ("plan.dxf", b"  0\nSECTION\n  2\nHEADER\n  0\nENDSEC\n  0\nEOF\n"),
        ("plan.svg", b'<svg xmlns="http://www.w3.org/2000/svg"><rect width="4" height="3"/></svg>'),
        ("plan.ifc", b"ISO-10303-21;\nHEADER;\nENDSEC;\nEND-ISO-10303-21;\n"),
        ("plan.procthor", b'{"rooms": [{"id": "room|1", "roomType": "Kitchen", "floorPolygon": [{"x": 0, "y": 0, "z": 0}]}], "walls": []}'),
        ("plan.rplan", b'{"room_type": [0], "boxes": [[0, 0, 1, 1]], "edges": [], "ed_rm": []}'),
    ],
)
def test_a_floor_plan_where_a_scene_belongs_is_told_to_be_one(tmp_path: Path, capfdbinary: Captured, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    for command in ("validate", "fix"):
        words = refused(capfdbinary, command, str(tmp_path / name))
        assert (
            f"scene: is a floor plan of the format {name[5:]} (allowed: a scene; `compose import` and POST /import make one of a plan)"
            in words
        )


@pytest.mark.parametrize(
    ("start", "words"),
    [
        (b"%PDF-1.7\n%", "PDF is not read here: save the drawing as SVG or DXF"),
        (b"AC1032\0\0", "DWG is not read here: save the drawing as DXF"),
        (b"\x89PNG\r\n", "pictures are not read here: trace them as SVG or DXF"),
        (b"\xff\xd8\xff\xe0", "pictures are not read here"),
        (b"<?xml version='1.0'?>\n<doc:iso_10303_28 version='2.0'>", "ifcXML is not read here: save it as IFC"),
        (b'<ifcXML xmlns="https://standards.buildingsmart.org/IFC">', "ifcXML is not read here: save it as IFC"),
    ],
)
def test_a_file_in_which_people_have_plans_and_which_is_not_read_says_what_helps(
    tmp_path: Path, capfdbinary: Captured, start: bytes, words: str
) -> None:
    (tmp_path / "plan").write_bytes(start)
    assert f"plan: file: {words}" in refused(capfdbinary, "import", str(tmp_path / "plan"))
    for command in ("furnish", "validate", "export"):
        assert f"plan: {words}" in refused(capfdbinary, command, str(tmp_path / "plan"))


@pytest.mark.parametrize(
    ("command", "seed", "decorated"),
    [
        ("generate", "0 ... 2^53-1 (drawn; with --count the first one's, 0)", "off"),
        ("stats", "of the first house, 0 ... 2^53-1 (0)", "on"),
        ("dataset", "of make: the home's", "on"),
    ],
)
def test_help_says_what_a_command_takes_where_nothing_is_said(capfdbinary: Captured, command: str, seed: str, decorated: str) -> None:
    with pytest.raises(SystemExit):
        main([command, "--help"])
    told = " ".join(capfdbinary.readouterr().out.decode().split())
    assert f"--seed N {seed} " in told
    assert f"--no-decorate decorate surfaces, walls and floors ({decorated})" in told


def test_broken_yaml_names_its_line(tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "request.yaml").write_text("width: 12\ndepth: 9\nseed: [1\noutdoor: true\n")
    words = refused(capfdbinary, "generate", str(tmp_path / "request.yaml"))
    assert "request.yaml" in words
    assert "line 4" in words


def test_standard_input_is_named_and_its_format_found(monkeypatch: pytest.MonkeyPatch, capfdbinary: Captured) -> None:
    for content, words in ((b'{"rooms": 3}', "scene.rooms"), (b"rooms: 3", "scene.rooms"), (b"[1, 2", "not JSON"), (b"a: [", "not YAML")):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content)))
        assert f"standard input: {words}" in refused(capfdbinary, "validate")


UNKNOWN = [
    [], ["paint"], ["tidy"], ["generate", "--bedrooms", "3"], ["generate", "--seed", "x"], ["generate", "-n", "0"],
    ["generate", "--force-type", "kitchen"], ["generate", "--engine", "magic"], ["fix", "--on-conflict", "x"], ["fix", "--effort", "much"],
]  # fmt: skip


@pytest.mark.parametrize("arguments", UNKNOWN)
def test_unknown_words_are_bad_use(capfdbinary: Captured, arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(arguments)
    assert end.value.code == 2
    assert capfdbinary.readouterr().out == b""


def test_the_reference_engine_gives_a_house_too(capfdbinary: Captured) -> None:
    assert main(["generate", "--seed", "1", "--width", "5", "--depth", "4", "--engine", "reference"]) == 0
    assert yaml.load(capfdbinary.readouterr().out, yaml.CSafeLoader)["rooms"]


ASKED = """
room: {id: den_0, width: 4.0, depth: 3.5, openings: [{id: d, kind: door, wall: south, position: 1.0, width: 0.9}]}
pieces:
  - {id: shelf, name: bookshelf, relations: [{type: in_corner}]}
  - {id: crate, name: crate, width: WIDE, depth: 0.5, height: 0.5, relations: [{type: beside, of: shelf}]}
wall_thickness: 0.1
"""


def test_place_writes_the_answer_and_says_what_is_missing(tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "asked.yaml").write_text(ASKED.replace("WIDE", "0.5"))
    assert main(["place", str(tmp_path / "asked.yaml"), "-o", str(tmp_path / "placed.json"), "-n", "3"]) == 0
    answer = json.loads((tmp_path / "placed.json").read_text())
    assert [entry["held"] for entry in answer["relations"]] == [True, True]
    assert len(answer["alternatives"]) == 2
    assert main(["validate", str(tmp_path / "placed.json"), "-o", str(tmp_path / "judged.json")]) == 0
    (tmp_path / "asked.yaml").write_text(ASKED.replace("WIDE", "8.5"))
    assert main(["place", str(tmp_path / "asked.yaml"), "--format", "json"]) == 1
    out, words = capfdbinary.readouterr()
    assert [entry["id"] for entry in json.loads(out)["unplaced"]] == ["crate"]
    assert b"conflict crate: " in words and b"not held: crate beside shelf" in words


def test_place_names_a_wrong_field(tmp_path: Path, capfdbinary: Captured) -> None:
    (tmp_path / "asked.yaml").write_text(ASKED.replace("WIDE", "0"))
    assert "asked.yaml: pieces[1].width: is 0" in refused(capfdbinary, "place", str(tmp_path / "asked.yaml"))


def test_kinds_that_no_catalog_knows_are_told_with_the_option_that_helps(tmp_path: Path, capfdbinary: Captured) -> None:
    ours = {"id": "sofa", "name": "sofa", "kind": "sofa", "x": 2, "z": 1, "width": 2, "depth": 0.9, "height": 0.8}
    rooms = [{"id": "den", "width": 4, "depth": 3, "furniture": [ours, {**ours, "id": "own", "kind": "record_cabinet", "z": 2.4}]}]
    path = tmp_path / "den.json"
    path.write_text(json.dumps({"rooms": rooms}))
    told = b"no catalog here knows record_cabinet: --catalog names a folder of your own\n"
    for command in (["validate", str(path)], ["view", str(path)], ["explain", str(path), "own"], ["export", str(path), "-f", "csv"]):
        main(command)
        assert told in capfdbinary.readouterr().err
        main([*command, "--catalog", str(ROOT / "catalogs" / "example")])
        assert told not in capfdbinary.readouterr().err


def test_what_was_decorated_is_known(house: Path, tmp_path: Path, capfdbinary: Captured) -> None:
    path = tmp_path / "decorated.json"
    assert main(["generate", "--program", "studio", "--seed", "3", "--decorate", "-o", str(path)]) == 0
    assert main(["validate", str(path)]) == 0
    assert b"no catalog here knows" not in capfdbinary.readouterr().err


@pytest.mark.parametrize("name", ["home.glb", "home.gltf", "home.v2.usda"])
def test_a_scene_is_not_written_under_the_name_of_another_format(house: Path, tmp_path: Path, capfdbinary: Captured, name: str) -> None:
    path = tmp_path / name
    commands = [["generate", "--program", "studio", "--seed", "3"], ["validate", str(house)], ["fix", str(house)]]
    for command in (*commands, *([["export", str(house)]] if name != "home.glb" else [])):
        assert f"--output: {path} names no format (allowed: .yaml or .json" in refused(capfdbinary, *command, "-o", str(path))
        assert not path.exists()
    assert main([*commands[0], "-o", str(path), "--format", "json"]) == 0
    assert json.loads(path.read_text())["seed"] == 3


@pytest.mark.parametrize("piped", [False, True])
def test_furnish_takes_a_plan_of_another_program(
    tmp_path: Path, capfdbinary: Captured, monkeypatch: pytest.MonkeyPatch, piped: bool
) -> None:
    drawn, plan, steps, once = ROOT / "docs" / "plan.geojson", *(str(tmp_path / name) for name in ("plan.yaml", "steps.yaml", "once.yaml"))
    assert main(["import", str(drawn), "-o", plan]) == 0
    said = capfdbinary.readouterr().err
    assert main(["furnish", plan, "--seed", "7", "-o", steps]) == 0
    more = capfdbinary.readouterr().err
    if piped:
        monkeypatch.setattr("service.standard_streams.read_standard_input", drawn.read_bytes)
    assert main(["furnish", "-" if piped else str(drawn), "--seed", "7", "-o", once]) == 0
    assert Path(once).read_bytes() == Path(steps).read_bytes()
    assert capfdbinary.readouterr().err == said + more


def test_furnish_says_which_rooms_it_left_because_they_were_not_empty(tmp_path: Path, capfdbinary: Captured) -> None:
    sofa = {"id": "sofa", "name": "sofa", "x": 2, "z": 0.5, "width": 2, "depth": 0.9, "height": 0.8}
    room = {"type": "living_room", "width": 4, "depth": 3.5}
    path = tmp_path / "plan.json"
    path.write_text(json.dumps({"rooms": [{**room, "id": "den", "furniture": [sofa]}, {**room, "id": "hall", "x": 4, "type": "hallway"}]}))
    told = b"as they were, since something stands in them: den; --room den furnishes around it\n"
    main(["furnish", str(path), "--seed", "1"])
    assert told in capfdbinary.readouterr().err
    main(["furnish", str(path), "--seed", "1", "--room", "den"])
    assert told not in capfdbinary.readouterr().err
