"""Who may import whom: catalogs <- solver <- service; the solver's stages never meet but in its pipeline."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.architecture.tree import PACKAGES, ROOT, Import, imports, module_name, sources

MAY_IMPORT = {
    "catalogs": {"catalogs"},
    "solver": {"catalogs", "solver"},
    "service": {"catalogs", "solver", "service"},
    "compose_homes": {"catalogs", "solver", "service", "compose_homes"},
}
GROUND_FLOOR = {
    "core",
    "scene",
    "scene_bodies",
    "body_rows",
    "understanding",
    "named_assets",
    "export_formats",
    "foreign_plans",
    "demanded",
    "body_parts",
    "answers",
    "fields",
    "records",
    "plain",
    "geometry",
    "streams",
    "errors",
    "interrupts",
    "pieces",
    "free_places",
    "free_floor",
    "free_names",
    "wall_fittings",
    "certificate",
    "version",
    "relations",
    "request",
    "requested",
}
JOINER = "pipeline"
# By package: what else it has no business with.
FOREIGN = {
    "catalogs": {"numpy", "scipy", "osqp", "daqp", "cvxpy", "wasmtime", "pyscipopt", "fastapi", "starlette", "uvicorn"},
    "solver": {"pyscipopt", "daqp", "fastapi", "starlette", "uvicorn", "argparse"},
    "service": {"numpy", "scipy", "osqp", "daqp", "cvxpy", "wasmtime", "pyscipopt"},
    "compose_homes": {"numpy", "scipy", "osqp", "daqp", "cvxpy", "wasmtime", "pyscipopt", "fastapi", "starlette", "uvicorn"},
}
# What differs from run to run stays out of results: one module times them, one draws the seed of a request without one.
UNREPEATABLE = {"random", "secrets", "uuid", "time", "datetime"}
EXCEPTED = {("solver.pipeline.timing", "time"), ("solver.pipeline.generate", "secrets")}
REFERENCE = "solver.placement.reference"


def part(module: str) -> str:
    """The part of the solver a module belongs to: a stage, a ground floor module, the pipeline, the doors, or "" for the front door."""
    names = module.split(".")
    return names[1] if len(names) > 1 else ""


def places(found: list[Import]) -> list[str]:
    return [f"{one.place} imports {one.module}" for one in found]


def test_the_walk_finds_the_sources() -> None:
    assert len(sources(*PACKAGES)) > 20
    assert all(sources(package) for package in PACKAGES)
    assert len([one for one in imports("solver") if one.top == "solver"]) > 20
    assert len([one for one in imports("service") if one.top == "solver"]) > 3


@pytest.mark.parametrize("package", PACKAGES)
def test_dependencies_run_one_way(package: str) -> None:
    ours = {*PACKAGES, "tests", "scripts"}
    assert places([one for one in imports(package) if one.top in ours - MAY_IMPORT[package]]) == []


@pytest.mark.parametrize("package", PACKAGES)
def test_each_package_keeps_to_its_own_libraries(package: str) -> None:
    assert places([one for one in imports(package) if one.top in FOREIGN[package]]) == []


def test_the_ground_floor_stands_on_itself() -> None:
    inside = [one for one in imports("solver") if part(one.importer) in GROUND_FLOOR and one.top == "solver"]
    assert places([one for one in inside if part(one.module) not in GROUND_FLOOR]) == []


def test_stages_meet_only_in_the_pipeline() -> None:
    within = [one for one in imports("solver") if one.top == "solver" and part(one.importer) not in {JOINER, "doors", ""}]
    allowed = [one for one in within if part(one.module) in {*GROUND_FLOOR, part(one.importer)}]
    assert places([one for one in within if one not in allowed]) == []
    stages = {part(module_name(path)) for path in sources("solver")} - GROUND_FLOOR - {JOINER, "doors", ""}
    assert {"floorplan", "furnish", "placement", "exchange", "validator"} <= stages


def test_pydantic_is_imported_by_the_exchange_alone() -> None:
    """What declares keys (`solver.fields`) asks for it when something is read: the types alone cost nothing."""
    found = [one for one in imports("solver") if one.top in {"pydantic", "pydantic_core"}]
    assert {part(one.importer) for one in found} == {"exchange"}
    code = "import sys; import solver.fields; print('pydantic' in sys.modules)"
    here = [
        "-c",
        f"import sys, types; sys.modules['solver'] = types.ModuleType('solver'); sys.modules['solver'].__path__ = ['solver']; {code}",
    ]
    assert subprocess.run([sys.executable, *here], cwd=ROOT, capture_output=True, text=True, check=True).stdout == "False\n"


def test_cvxpy_is_imported_by_the_reference_alone_and_late() -> None:
    found = [one for one in imports(*PACKAGES) if one.top == "cvxpy"]
    assert {one.importer for one in found} == {REFERENCE}
    asking = [one for one in imports(*PACKAGES) if one.module == REFERENCE]
    assert asking
    assert places([one for one in asking if not one.lazy]) == []


def test_the_engines_stay_inside_the_placement() -> None:
    assert places([one for one in imports("solver") if one.top == "osqp"]) == []
    assert {one.module for one in imports("solver") if one.top == "scipy"} == {"scipy.ndimage"}  # pictures of cells, no engine
    found = [path for path in (ROOT / "solver").rglob("*.py") if "ext_builtin" in path.read_text()]
    assert [path.stem for path in found] == ["osqp_binary"]


def test_the_core_is_run_in_one_place_and_loaded_only_where_it_is_asked_for() -> None:
    found = [one for one in imports(*PACKAGES) if one.top == "wasmtime"]
    assert {one.importer for one in found} == {"solver.core.host"}
    typed = [one for one in found if not one.lazy]
    assert len(typed) == 1  # under TYPE_CHECKING
    own = [one for one in imports("solver") if one.importer.startswith("solver.core") and one.top == "solver"]
    assert places([one for one in own if part(one.module) != "core"]) == []


def test_no_engine_is_loaded_before_a_placement_is_asked_for() -> None:
    program = "import sys, solver; print([name for name in ('scipy', 'osqp', 'cvxpy', 'wasmtime') if name in sys.modules])"
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (run.stdout.strip(), run.returncode) == ("[]", 0), run.stderr


def test_nothing_unrepeatable_reaches_a_result() -> None:
    found = [one for one in imports("catalogs", "solver") if one.top in UNREPEATABLE or one.module.startswith("numpy.random")]
    assert places([one for one in found if (one.importer, one.top) not in EXCEPTED]) == []


def test_the_default_path_never_loads_cvxpy() -> None:
    program = (
        "import sys\n"
        "from solver import Request, generate\n"
        "made = generate(Request(seed=1, width=8, depth=6))\n"
        "assert any(room.furniture for room in made.scene.rooms)\n"
        "assert 'osqp.ext_builtin' in sys.modules\n"
        "print('cvxpy' in sys.modules)\n"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (run.stdout.strip(), run.returncode) == ("False", 0), run.stderr
