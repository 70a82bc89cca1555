"""Streams, files and exit statuses of the command line: in processes of its own where that is what is tested, else in this one."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from service.cli import main
from tests.cli.programs import PROGRAM, ROOT, SMALL, compose, said

Captured = pytest.CaptureFixture[bytes]
LIBRARIES = (
    "numpy",
    "wasmtime",
    "scipy",
    "osqp",
    "daqp",
    "cvxpy",
    "fastapi",
    "starlette",
    "uvicorn",
    "pydantic",
    "yaml",
    "solver",
    "catalogs",
)


@pytest.fixture(scope="module")
def house() -> bytes:
    """A house as `compose generate` writes it to standard output."""
    run = compose("generate", *SMALL)
    assert run.returncode == 0, run.stderr.decode()
    return run.stdout


def test_generate_writes_the_scene_and_nothing_else(house: bytes) -> None:
    scene = yaml.load(house, yaml.CSafeLoader)
    assert scene["format"] == "compose-scene/1"
    assert (scene["seed"], scene["size"]["width"], scene["size"]["depth"]) == (42, 7.0, 5.0)


def test_another_process_gives_the_same_bytes(house: bytes, tmp_path: Path, capfdbinary: Captured) -> None:
    request = tmp_path / "request.json"
    request.write_text(json.dumps({"seed": 42, "width": 7, "depth": 9}))
    assert main(["generate", str(request), "--depth", "5"]) == 0
    assert capfdbinary.readouterr().out == house


def test_a_house_goes_through_pipes(house: bytes, monkeypatch: pytest.MonkeyPatch, capfdbinary: Captured) -> None:
    def piped(*arguments: str) -> tuple[bytes, bytes]:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(house)))
        assert main(arguments) == 0
        return capfdbinary.readouterr()

    viewed = compose("view", given=house)
    assert (viewed.returncode, viewed.stderr) == (0, b"")
    assert viewed.stdout.decode().startswith("# Floor plan")
    assert piped("view")[0] == viewed.stdout
    assert set(json.loads(piped("validate", "--format", "json")[0])) == {"issues", "metrics", "understood_as"}
    fixed, words = piped("fix")
    assert fixed == house
    assert b"0 moved" in words


def spoiled(house: bytes) -> dict[str, Any]:
    scene: dict[str, Any] = yaml.load(house, yaml.CSafeLoader)
    room = max(scene["rooms"], key=lambda room: len(room["furniture"]))
    room["furniture"][0]["x"] = -3.0
    return scene


def test_errors_in_a_scene_are_exit_status_1(house: bytes, tmp_path: Path, capfdbinary: Captured) -> None:
    path = tmp_path / "spoiled.json"
    path.write_text(json.dumps(spoiled(house)))
    found = compose("validate", str(path))
    assert found.returncode == 1
    assert "error out_of_bounds" in said(found)
    assert any(issue["rule"] == "out_of_bounds" for issue in yaml.load(found.stdout, yaml.CSafeLoader)["issues"])
    assert main(["fix", str(path), "-o", str(tmp_path / "fixed.yaml")]) == 0
    assert capfdbinary.readouterr().out == b""
    assert main(["validate", str(tmp_path / "fixed.yaml")]) == 0


def test_a_broken_catalog_stops_the_start_with_file_key_and_line(tmp_path: Path, capfdbinary: Captured) -> None:
    for name in ("furniture.yaml", "floorings.yaml"):
        (tmp_path / name).write_bytes((ROOT / "catalogs" / name).read_bytes())
    (tmp_path / "rooms").mkdir()
    for path in (ROOT / "catalogs" / "rooms").glob("*.yaml"):
        (tmp_path / "rooms" / path.name).write_bytes(path.read_bytes())
    kitchen = tmp_path / "rooms" / "kitchen.yaml"
    lines = kitchen.read_text().splitlines()
    number = next(index for index, line in enumerate(lines) if line.startswith("area:"))
    lines[number] = "area: {min: [5, 6], typical: 12"
    kitchen.write_text("\n".join(lines) + "\n")
    assert main(["serve", "--port", "0", "--catalog", str(tmp_path)]) == 2
    out, told = capfdbinary.readouterr()
    words = told.decode()
    assert out == b"" and "Traceback" not in words
    assert f"{kitchen}:" in words
    where = int(words.partition(f"{kitchen}:")[2].partition(":")[0])
    assert number + 1 <= where <= number + 2
    assert "not YAML" in words
    lines[number] = "area: {min: [5, 6], typical: 12, max: 30, colour: red}"
    kitchen.write_text("\n".join(lines) + "\n")
    assert main(["generate", *SMALL, "--catalog", str(tmp_path)]) == 2
    assert f"{kitchen}:{number + 1}: area.colour" in capfdbinary.readouterr().err.decode()


def test_a_reader_that_leaves_is_no_failure() -> None:
    with subprocess.Popen([*PROGRAM, "schema"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT) as run:
        assert run.stdout
        run.stdout.close()
        assert run.stderr
        words = run.stderr.read().decode()
    assert words == ""


def test_version_is_the_newest_of_the_changelog(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["--version"])
    newest = re.findall(r"^## .([\d.]+). - ", (ROOT / "CHANGELOG.md").read_text(), re.M)[0]
    assert capsys.readouterr().out == f"compose {newest}\n"


def test_help_loads_nothing_heavy() -> None:
    program = (
        "import sys\n"
        "from service.cli import main\n"
        "try:\n    main(['--help'])\n"
        "except SystemExit as end:\n    print(end.code, sorted(set(sys.argv[1:]) & set(sys.modules)))\n"
    )
    run = subprocess.run([sys.executable, "-c", program, *LIBRARIES], cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "0 []"
