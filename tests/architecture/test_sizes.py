"""Nothing grows long: files, functions; nothing is named for what it is not, or lies where it does not belong."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from tests.architecture.tree import PACKAGES, ROOT, files, sources, syntax

FILE_LINES = 400
FUNCTION_LINES = 50
CORE_FUNCTION_LINES = 60
CORE_LINE = 140
CORE_INDENT = 2
WRITTEN_BY_OTHERS = frozenset({"CHANGELOG.md", "served.ts"})
"""Files that grow with each release, or that a script writes."""
COUNTED = (".py", ".ts", ".css", ".html", ".md", ".cpp", ".hpp")
CORE_FUNCTION = re.compile(r" *(?!(?:if|for|while|switch|else|do|struct|class|enum|union)\b)[\w~:].*\) ?(?:const |override |noexcept )*\{")
TOP_LEVEL = {
    *(".ci", ".gitignore", ".pre-commit-config.yaml", "Makefile", "hatch_build.py", "pyproject.toml", "constraints.txt"),
    *("catalogs", "compose_homes", "docs", "scripts", "service", "solver", "tests", "web"),
    *("ARCHITECTURE.md", "BENCHMARKS.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "README.md", "SECURITY.md"),
}
EMPTY_NAMES = {"util", "utils", "helper", "helpers", "manager", "handler", "handlers", "data", "info", "misc", "common"}

Function = ast.FunctionDef | ast.AsyncFunctionDef


def functions() -> list[tuple[str, int]]:
    """Every Python function of the project: where it is, and its lines without its docstring."""
    found = [(path, node) for path in files(".py") for node in ast.walk(syntax(path)) if isinstance(node, Function)]
    return [(f"{path.relative_to(ROOT)}:{node.lineno} {node.name}", length(node)) for path, node in found]


def core_functions(path: Path) -> dict[str, int]:
    """The functions of a C++ file, each ended by a brace as far in as its first line begins: where each is, and its lines."""
    lines, found = path.read_text(encoding="utf-8").splitlines(), {}
    for opened, line in enumerate(lines):
        if CORE_FUNCTION.fullmatch(line):
            first = next(at for at in range(opened, -1, -1) if len(lines[at]) - len(lines[at].lstrip()) <= CORE_INDENT)
            end = lines[first][: -len(lines[first].lstrip())] + "}"
            last = next(at for at in range(opened + 1, len(lines)) if lines[at].startswith(end))
            found[f"{path.name}:{first + 1} {lines[first].strip()}"] = last - first + 1
    return found


def length(node: Function) -> int:
    """A function's lines, from its def on, without its docstring."""
    first = node.body[0]
    documented = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant) and isinstance(first.value.value, str)
    docstring = (first.end_lineno or 0) - first.lineno + 1 if documented else 0
    return (node.end_lineno or 0) - node.lineno + 1 - docstring


def test_nothing_else_lies_at_the_top() -> None:
    """As what a command of the documents once left there did."""
    assert {path.relative_to(ROOT).parts[0] for path in files()} == TOP_LEVEL


def test_no_file_is_long() -> None:
    counted = [path for path in files(*COUNTED) if path.name not in WRITTEN_BY_OTHERS]
    assert len(counted) > 20
    lengths = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8").count("\n") for path in counted}
    assert {name: lines for name, lines in lengths.items() if lines > FILE_LINES} == {}


def test_no_function_is_long() -> None:
    found = functions()
    assert len(found) > 100
    assert [(place, lines) for place, lines in found if lines > FUNCTION_LINES] == []


def test_nothing_in_the_core_is_long() -> None:
    sources = [path for path in files(".cpp", ".hpp") if path.relative_to(ROOT).parts[0] == "solver"]
    found = {place: lines for path in sources for place, lines in core_functions(path).items()}
    assert len(found) > 50
    assert {place: lines for place, lines in found.items() if lines > CORE_FUNCTION_LINES} == {}
    wide = [f"{path.name}:{i}" for path in sources for i, line in enumerate(path.read_text().splitlines(), 1) if len(line) > CORE_LINE]
    assert wide == []


def test_a_function_is_measured_without_its_docstring() -> None:
    (node,) = ast.parse('def f():\n    """One.\n\n    Two.\n    """\n    x = 1\n    return x\n').body
    assert isinstance(node, ast.FunctionDef)
    assert length(node) == 3


def test_no_module_has_an_empty_name() -> None:
    assert [str(path) for path in sources(*PACKAGES) if set(path.stem.split("_")) & EMPTY_NAMES] == []
