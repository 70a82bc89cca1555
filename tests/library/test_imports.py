"""Imports cost what they use: counted by the modules that are loaded, not by the clock."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.architecture.tree import ROOT

FINAL_SOLVE = {"osqp", "osqp.ext_builtin", "daqp", "scipy", "cvxpy"}
KERNEL = FINAL_SOLVE | {"wasmtime"}
SERVER = {"fastapi", "starlette", "uvicorn", "anyio"}
CATALOGS = {"catalogs.reading", "catalogs.schema", "numpy"}
SCENE = "from compose_homes import Room, Scene\nscene = Scene(rooms=(Room('den', width=4.0, depth=3.0),))\n"
FLOWS = {"solver.pipeline.generate", "solver.pipeline.fix", "solver.pipeline.import_plan", "solver.placement", "solver.floorplan", "numpy"}
ALL_CALLS = """
import sys
from importlib import import_module
from catalogs import load_catalogs
from service.workers import PRELOADED
for name in PRELOADED:
    import_module(name)
from service.calls import CALLS
from service.openapi import examples
from service.packed_catalogs import packed, warm
warm(packed(load_catalogs()))
before = set(sys.modules)
for name, call in CALLS.items():
    call(examples()["/export/{format}" if name == "export" else f"/{name}"]["body"], load_catalogs())
later = sorted(name for name in set(sys.modules) - before if name.startswith(("catalogs", "service", "solver")))
assert not later, later
"""
MARK = "print('\\nLOADED', *sys.modules)"
GENERATE = "from compose_homes import Request, generate\ngenerate(Request(seed=1, width=4, depth=4))"


CHAINS: list[list[tuple[str, set[str]]]] = [
    [
        ("import compose_homes", KERNEL | SERVER | CATALOGS),
        ("from solver.scene import Scene", KERNEL | SERVER | CATALOGS),
        ("from compose_homes import load\nload('rooms:\\n- {id: den, width: 4, depth: 3}')", KERNEL | SERVER | CATALOGS),
        ("from compose_homes import PieceRequest, load_catalogs; load_catalogs()", KERNEL | SERVER),
        ("from solver import fix, generate, place, validate", KERNEL | SERVER),
        ("from compose_homes import Scene, fix, generate, place, reroll, validate", KERNEL | SERVER),
    ],
    [
        ("import service.calls", KERNEL | SERVER | FLOWS | {"sqlalchemy"}),
        ("import service.app", KERNEL | {"sqlalchemy", "fastapi"} | (FLOWS - {"numpy"})),
    ],
    [
        (SCENE + "from compose_homes import dump, load\nassert load(dump(scene)) == scene", FINAL_SOLVE | SERVER | CATALOGS),
        ("from service.cli import main; main(['schema'])", FINAL_SOLVE | SERVER | CATALOGS),
        ("main(['catalog'])", FINAL_SOLVE | SERVER | {"numpy"}),
        ("from compose_homes import validate\nvalidate(scene)", FINAL_SOLVE | SERVER),
        (GENERATE, {"cvxpy", "osqp", "scipy", "jinja2"} | SERVER),
    ],
]
"""Programs that a process does one after another, each with what none of those up to it loads: less and less."""


def loaded(program: str) -> list[set[str]]:
    """The modules that a program, in a process of its own, has loaded at each mark and at its end."""
    words = f"import sys\n{program}\n{MARK}"
    run = subprocess.run([sys.executable, "-c", words], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [set(line.split()[1:]) for line in run.stdout.splitlines() if line.startswith("LOADED ")]


@pytest.mark.parametrize("chain", CHAINS)
def test_what_is_not_used_is_not_loaded(chain: list[tuple[str, set[str]]]) -> None:
    found = loaded(f"\n{MARK}\n".join(program for program, _ in chain))
    assert len(found) == len(chain)
    assert {program: there & without for (program, without), there in zip(chain, found, strict=True) if there & without} == {}


def test_a_call_loads_what_it_needs() -> None:
    assert loaded(GENERATE)[-1] > {"wasmtime", "osqp.ext_builtin"}


def test_what_calls_load_is_loaded_before_processes_are_forked() -> None:
    assert loaded(ALL_CALLS)[-1] > FLOWS
