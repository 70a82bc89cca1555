"""The documents under test: what exists is written down, and what is written down runs."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from catalogs import load_catalogs
from service.app import create_app
from solver.validate import RULES

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
ARCHITECTURE = (ROOT / "ARCHITECTURE.md").read_text()
VOCABULARY = (ROOT / "catalogs" / "README.md").read_text()


@pytest.mark.parametrize("rule", RULES)
def test_every_rule_is_documented(rule: str) -> None:
    assert f"`{rule}`" in README


def test_every_endpoint_is_documented() -> None:
    paths = create_app().openapi()["paths"]
    assert len(paths) >= 7
    for path in paths:
        assert f"`{path}`" in README or f" {path}`" in README, path


@pytest.mark.parametrize("name", sorted(load_catalogs().rooms))
def test_every_room_type_is_documented(name: str) -> None:
    assert name in VOCABULARY


def test_every_module_of_the_solver_is_in_the_map() -> None:
    names = {path.stem if path.is_file() else path.name for path in (ROOT / "solver").iterdir()}
    names -= {"__init__", "__pycache__"}
    assert len(names) > 12
    assert [name for name in sorted(names) if not re.search(rf"\b{name}\b", ARCHITECTURE)] == []


def test_the_commands_of_the_readme_run() -> None:
    lines = [line.split("#")[0].strip() for line in README.splitlines() if line.startswith(".venv/bin/compose generate")]
    assert lines
    for line in lines:
        words = shlex.split(line)[1:]
        at = words.index("--output")
        command = [sys.executable, "-m", "service", *words[:at], *words[at + 2 :]]
        run = subprocess.run(command, capture_output=True, check=True, cwd=ROOT)
        assert yaml.safe_load(run.stdout)["rooms"]
