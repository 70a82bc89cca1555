"""One word for one thing: a type's name and a module's name each mean one thing in the whole project."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator

from tests.architecture.tree import PACKAGES, sources, syntax


def types(tree: ast.Module) -> Iterator[str]:
    """The names of a module's classes and type aliases."""
    yield from (node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef))
    yield from (name for node in tree.body if (name := _alias(node)))


def _alias(node: ast.stmt) -> str | None:
    """The name that a statement gives to a type: annotated as an alias, or written like a class."""
    if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
        return node.target.id if "TypeAlias" in ast.unparse(node.annotation) else None
    if not (isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name)):
        return None
    name, variable = node.targets[0].id, isinstance(node.value, ast.Call) and "TypeVar" in ast.unparse(node.value)
    return name if name[:1].isupper() and not name.isupper() and not variable else None


def several(homes: dict[str, list[str]]) -> dict[str, list[str]]:
    return {name: places for name, places in sorted(homes.items()) if len(places) > 1}


def types_twice() -> dict[str, list[str]]:
    homes: dict[str, list[str]] = defaultdict(list)
    for path in sources(*PACKAGES):
        for name in types(syntax(path)):
            homes[name].append(str(path))
    return several(homes)


def modules_twice() -> dict[str, list[str]]:
    homes: dict[str, list[str]] = defaultdict(list)
    for path in sources(*PACKAGES):
        if not path.stem.startswith("__"):
            homes[path.stem].append(str(path))
    return several(homes)


def test_the_walk_finds_classes_and_aliases() -> None:
    tree = ast.parse("class A: pass\nB: TypeAlias = int\nCells = list[int]\nT = TypeVar('T')\nLIMIT = 3\nx: int = 2\n")
    assert list(types(tree)) == ["A", "B", "Cells"]
    assert several({"A": ["a"], "B": ["a", "b"]}) == {"B": ["a", "b"]}


def test_no_type_is_defined_twice() -> None:
    assert types_twice() == {}


def test_no_module_name_has_two_meanings() -> None:
    assert modules_twice() == {}
