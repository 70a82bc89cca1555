"""The files that git knows or would take, and what the Python ones import."""

from __future__ import annotations

import ast
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("catalogs", "solver", "service", "compose_homes")


@dataclass(frozen=True)
class Import:
    """One imported module: its dotted name, who imports it, where, and whether inside a function."""

    importer: str
    module: str
    place: str
    lazy: bool

    @property
    def top(self) -> str:
        """The first part of the imported module's name."""
        return self.module.split(".")[0]


@cache
def files(*suffixes: str) -> tuple[Path, ...]:
    """The files of the project with one of some suffixes (with any, when none is given), sorted."""
    listing = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(listing, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    paths = [ROOT / name for name in sorted(names) if name]
    return tuple(path for path in paths if path.is_file() and (not suffixes or path.suffix in suffixes))


def sources(*packages: str) -> list[Path]:
    """The Python files of some top-level packages."""
    return [path for path in files(".py") if path.relative_to(ROOT).parts[0] in packages]


def module_name(path: Path) -> str:
    """The dotted name a file is imported by."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def syntax(path: Path) -> ast.Module:
    """A Python file, parsed."""
    return ast.parse(path.read_text(encoding="utf-8"), filename=str(path))


def imports(*packages: str) -> list[Import]:
    """Every import statement's modules in some packages, `from a import b` as a.b where that is a module of ours, else a."""
    return [found for path in sources(*packages) for found in _imports_of(path)]


@cache
def _ours() -> frozenset[str]:
    return frozenset(module_name(path) for path in sources(*PACKAGES))


@cache
def _imports_of(path: Path) -> tuple[Import, ...]:
    return tuple(_found_in(path))


def _found_in(path: Path) -> Iterator[Import]:
    name = module_name(path)
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    tree = syntax(path)
    lazy = {id(node) for function in ast.walk(tree) if isinstance(function, ast.FunctionDef) for node in ast.walk(function)}
    for node in ast.walk(tree):
        for module in _modules_of(node, package, _ours()):
            yield Import(name, module, f"{path.relative_to(ROOT)}:{getattr(node, 'lineno', 0)}", id(node) in lazy)


def _modules_of(node: ast.AST, package: str, ours: frozenset[str]) -> list[str]:
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if not isinstance(node, ast.ImportFrom):
        return []
    above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
    base = ".".join([*above, *([node.module] if node.module else [])])
    return [full if (full := f"{base}.{alias.name}") in ours else base for alias in node.names]
