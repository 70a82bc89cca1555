"""The wheel as a stranger installs it: one name in site-packages, the tree's homes, every public name with a type that a checker sees."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import compose_homes
from service.cli import main
from tests.architecture.tree import ROOT, files

ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in {"VIRTUAL_ENV", "PYTHONPATH"}}
GENERATE = ("generate", "--seed", "42", "--width", "5", "--depth", "4")
EXPORT = """
from hashlib import sha256
from pathlib import Path
from compose_homes import EXPORT_FORMATS, RequestError, export, load

scene = load(Path("home.yaml"))
for name in EXPORT_FORMATS:
    try:
        files = export(scene, name)
    except RequestError as error:
        print(name, error)
    else:
        held = {file: content if isinstance(content, bytes) else content.encode() for file, content in files.items()}
        print(name, {file: sha256(content).hexdigest() for file, content in held.items()})
"""
COMMANDS = f"""
from compose_homes.service.cli import main

assert main([*{GENERATE}, "--engine", "reference"]) == 2
assert main([*{GENERATE}, "-o", "home.yaml"]) == 0
assert main(["export", "home.yaml", "-o", "home.glb"]) == 0
"""
USER = """
from pathlib import Path
from compose_homes import (
    Furniture, Request, Room, Scene, PieceRequest, dump, fix, generate, load, load_catalogs, place, reroll, validate,
)

made = generate(Request(seed=42, program={"bedrooms": 1}), catalogs=load_catalogs())
house: Scene = made.scene
other = reroll(house, [room.id for room in house.rooms], seed=7).scene
fixed = fix(other, locked=[piece.id for room in other.rooms for piece in room.furniture if piece.name == "bed"])
text: str = dump(fixed.scene, Path("house.yaml"))
wrong = [issue.message for issue in validate(load(text)) if issue.severity == "error"]
answer = place(Room("den", width=4, depth=3), [PieceRequest("sofa", "sofa")])
stands = {piece.id: (piece.x, piece.z) for room in answer.best.scene.rooms for piece in room.furniture}
"""
WRONG = """
import compose_homes
compose_homes.generate(seed=42)
compose_homes.castle
width: str = compose_homes.generate().scene.rooms[0].width
"""
SHOWN = [
    *(f"compose_homes.{name}" for name in compose_homes.__all__),
    *("house", "other", "fixed.moves", "wrong", "answer.best.relations", "stands", "house.rooms[0].furniture[0].x"),
]
TREE_NAMES = {"catalogs", "solver", "service"}


def run(*words: str | Path, cwd: Path, env: dict[str, str] = ENVIRONMENT) -> str:
    done = subprocess.run(words, cwd=cwd, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site-packages of a new environment with the wheel in it, far from the tree."""
    folder = tmp_path_factory.mktemp("installed")
    uv = run(sys.executable, "scripts/find_uv.py", cwd=ROOT).strip()
    run(uv, "build", "--quiet", "--wheel", "--python", sys.executable, "--out-dir", folder, cwd=ROOT)
    run(uv, "venv", "--quiet", "--python", sys.executable, folder / "env", cwd=folder)
    (wheel,) = folder.glob("*.whl")
    run(uv, "pip", "install", "--quiet", "--python", "env", "--constraint", ROOT / "constraints.txt", wheel, cwd=folder)
    return Path(run("env/bin/python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", cwd=folder).strip())


def test_it_takes_one_name(installed: Path) -> None:
    (record,) = installed.glob("compose_homes-*.dist-info/RECORD")
    tops = {line.split("/")[0] for line in record.read_text().splitlines() if not line.startswith("..")}
    assert tops == {"compose_homes", record.parent.name}


def test_it_holds_what_the_tree_holds(installed: Path) -> None:
    ours = [path.relative_to(ROOT) for path in files() if path.relative_to(ROOT).parts[0] in {*TREE_NAMES, "compose_homes"}]
    ours = [path for path in ours if path.suffix not in {".cpp", ".hpp"}]
    expected = {str(path if path.parts[0] in TREE_NAMES else path.relative_to("compose_homes")) for path in ours}
    held = {str(path.relative_to(installed / "compose_homes")) for path in (installed / "compose_homes").rglob("*") if path.is_file()}
    assert expected <= held
    assert {"service/static/index.html", "solver/core/core.wasm"} <= held
    assert not any(name.endswith((".cpp", ".hpp", ".built-from")) for name in held)


def test_nothing_in_it_asks_for_a_name_of_the_tree(installed: Path) -> None:
    asked: set[str] = set()
    for path in (installed / "compose_homes").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ImportFrom) and not node.level:
                asked.add((node.module or "").split(".")[0])
            elif isinstance(node, ast.Import):
                asked |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                (top, *names) = node.value.rstrip(".").split(".")
                asked |= {top} if top in TREE_NAMES and names and any(ROOT.glob("/".join((top, *names)) + "*")) else set()
    assert "compose_homes" in asked
    assert asked & TREE_NAMES == set()


@pytest.fixture(scope="module")
def used(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str], str]:
    """A folder with what one process made there by commands, what it said of its exports, and of an engine that it lacks."""
    folder = tmp_path_factory.mktemp("used")
    python = installed.parents[2] / "bin" / "python"
    done = subprocess.run([python, "-c", COMMANDS + EXPORT], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder, done.stdout.splitlines(), done.stderr


def test_it_has_a_command_and_is_one(installed: Path, tmp_path: Path) -> None:
    python = installed.parents[2] / "bin" / "python"
    assert run(python.with_name("compose"), "export", "--help", cwd=tmp_path).startswith("usage: compose export")
    assert run(python, "-m", "compose_homes", "schema", cwd=tmp_path).startswith('"$schema"')


def test_it_makes_the_homes_that_the_tree_makes(used: tuple[Path, list[str], str], tmp_path: Path) -> None:
    folder, _, _ = used
    assert main([*GENERATE, "-o", str(tmp_path / "ours.yaml")]) == 0
    assert "rooms:" in (made := (folder / "home.yaml").read_text())
    assert made == (tmp_path / "ours.yaml").read_text()
    assert (folder / "home.glb").read_bytes()[:4] == b"glTF"


def test_it_exports_what_the_tree_exports(
    used: tuple[Path, list[str], str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, said, _ = used
    monkeypatch.chdir(folder)
    written = [line for line in said if "{" in line]
    exec(EXPORT.replace(" in EXPORT_FORMATS", f" in {[line.split()[0] for line in written]}"), {})
    assert capsys.readouterr().out.splitlines() == written
    assert {line.split()[0] for line in said if "{" not in line} == {"usdc", "usdz", "dxf", "ifc"}  # their libraries are extras


def test_what_an_engine_lacks_is_told(used: tuple[Path, list[str], str]) -> None:
    *_, told = used
    assert "needs cvxpy" in told and "compose-homes[reference]" in told


@pytest.fixture(scope="module")
def told(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> str:
    """What mypy says in strict mode of both programs of a user's: at once, as most of its work is what they import."""
    folder = tmp_path_factory.mktemp("programs")
    (folder / "user.py").write_text(USER + "import compose_homes\n" + "".join(f"reveal_type({name})\n" for name in SHOWN))
    (folder / "wrong.py").write_text(WRONG)
    python = str(installed.parents[2] / "bin" / "python")
    words = ["--strict", "--python-executable", python, "--cache-dir", os.devnull, "user.py", "wrong.py"]
    done = subprocess.run([sys.executable, "-m", "mypy", *words], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (1, "")
    return done.stdout


def test_a_users_program_checks_and_nothing_is_any(told: str) -> None:
    types = re.findall(r'user.py:\d+: note: Revealed type is "(.*)"', told)
    assert len(types) == len(SHOWN)
    assert [kind for kind in types if re.search(r"\bAny\b", kind)] == []
    assert "compose_homes.solver.scene.Scene" in types[-7]
    assert types[-1] == "float"


def test_a_users_mistakes_are_seen_and_nothing_else(told: str) -> None:
    assert re.findall(r"(\w+\.py:\d+): error", told) == ["wrong.py:3", "wrong.py:4", "wrong.py:5"]
