"""The command line in processes of its own: streams, files, exit statuses, and how fast it says what it can do."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.cli.programs import PROGRAM, ROOT, SMALL, compose, said

LIBRARIES = ("numpy", "scipy", "osqp", "daqp", "cvxpy", "fastapi", "starlette", "uvicorn", "pydantic", "yaml", "solver", "catalogs")


@pytest.fixture(scope="module")
def house() -> bytes:
    """A house as `compose generate` writes it to standard output."""
    run = compose("generate", *SMALL)
    assert run.returncode == 0, run.stderr.decode()
    return run.stdout


def test_generate_writes_the_scene_and_nothing_else(house: bytes) -> None:
    scene = yaml.safe_load(house)
    assert scene["format"] == "compose-scene/1"
    assert (scene["seed"], scene["size"]["width"], scene["size"]["depth"]) == (42, 7.0, 5.0)


def test_another_process_gives_the_same_bytes(house: bytes, tmp_path: Path) -> None:
    request = tmp_path / "request.json"
    request.write_text(json.dumps({"seed": 42, "width": 7, "depth": 9}))
    assert compose("generate", str(request), "--depth", "5").stdout == house


def test_a_house_goes_through_pipes(house: bytes) -> None:
    viewed = compose("view", given=house)
    validated = compose("validate", "--format", "json", given=house)
    fixed = compose("fix", given=house)
    assert (viewed.returncode, validated.returncode, fixed.returncode) == (0, 0, 0)
    assert viewed.stdout.decode().startswith("# Floor plan")
    assert set(json.loads(validated.stdout)) == {"issues", "metrics"}
    assert fixed.stdout == house
    assert "0 moved" in said(fixed)


def spoiled(house: bytes) -> dict[str, Any]:
    scene: dict[str, Any] = yaml.safe_load(house)
    room = max(scene["rooms"], key=lambda room: len(room["furniture"]))
    room["furniture"][0]["x"] = -3.0
    return scene


def test_errors_in_a_scene_are_exit_status_1(house: bytes, tmp_path: Path) -> None:
    path = tmp_path / "spoiled.json"
    path.write_text(json.dumps(spoiled(house)))
    found = compose("validate", str(path))
    assert found.returncode == 1
    assert "error out_of_bounds" in said(found)
    assert any(issue["rule"] == "out_of_bounds" for issue in yaml.safe_load(found.stdout)["issues"])
    written = compose("fix", str(path), "-o", str(tmp_path / "fixed.yaml"))
    assert (written.returncode, written.stdout) == (0, b"")
    assert compose("validate", str(tmp_path / "fixed.yaml")).returncode == 0


def test_a_broken_catalog_stops_the_start_with_file_key_and_line(tmp_path: Path) -> None:
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
    run = compose("serve", "--port", "0", "--catalog", str(tmp_path))
    assert (run.returncode, run.stdout) == (2, b"")
    words = said(run)
    assert f"{kitchen}:" in words
    where = int(words.partition(f"{kitchen}:")[2].partition(":")[0])
    assert number + 1 <= where <= number + 2
    assert "not YAML" in words
    lines[number] = "area: {min: [5, 6], typical: 12, max: 30, colour: red}"
    kitchen.write_text("\n".join(lines) + "\n")
    words = said(compose("generate", *SMALL, "--catalog", str(tmp_path)))
    assert f"{kitchen}:{number + 1}: area.colour" in words


def test_a_reader_that_leaves_is_no_failure() -> None:
    with subprocess.Popen([*PROGRAM, "schema"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT) as run:
        assert run.stdout
        run.stdout.close()
        assert run.stderr
        words = run.stderr.read().decode()
    assert words == ""


def test_help_loads_nothing_heavy() -> None:
    program = (
        "import sys\n"
        "from service.cli import main\n"
        "try:\n    main(['--help'])\n"
        "except SystemExit as end:\n    print(end.code, sorted(set(sys.argv[1:]) & set(sys.modules)))\n"
    )
    run = subprocess.run([sys.executable, "-c", program, *LIBRARIES], cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout.splitlines()[-1] == "0 []"
