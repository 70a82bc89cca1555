"""No module leads back to itself: neither in Python, imports inside functions included, nor in the page."""

from __future__ import annotations

import re
from collections.abc import Mapping
from graphlib import CycleError, TopologicalSorter

import pytest

from tests.architecture.tree import PACKAGES, ROOT, files, imports, module_name, sources

FROM = re.compile(r'^(?:import|export)\b[^"]*?\bfrom "(\.[^"]*)";', re.MULTILINE | re.DOTALL)


def circle(graph: Mapping[str, set[str]]) -> list[str]:
    """A circle of a graph, or nothing."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def test_no_circle_in_python() -> None:
    ours = {module_name(path) for path in sources(*PACKAGES)}
    graph: dict[str, set[str]] = {name: set() for name in ours}
    for one in imports(*PACKAGES):
        if one.module in ours and one.module != one.importer:
            graph[one.importer].add(one.module)
    assert len(graph) > 100
    assert circle(graph) == []


def test_no_circle_in_the_page() -> None:
    modules = [path for path in files(".ts") if path.is_relative_to(ROOT / "web" / "src")]
    graph = {str(path): {str((path.parent / f"{name}.ts").resolve()) for name in FROM.findall(path.read_text())} for path in modules}
    assert sum(map(len, graph.values())) > 100
    assert circle(graph) == []


def test_a_circle_is_found() -> None:
    assert set(circle({"a": {"b"}, "b": {"c"}, "c": {"a"}, "d": {"a"}})) == {"a", "b", "c"}
    assert circle({"a": {"b"}, "b": {"c"}}) == []


@pytest.mark.parametrize("text", ['import type { A } from "./a";', 'import {\n  A,\n  B,\n} from "./a";', 'export { A } from "./a";'])
def test_imports_of_the_page_are_seen(text: str) -> None:
    assert FROM.findall(f'import {{ Vector3 }} from "three";\n{text}\n') == ["./a"]
