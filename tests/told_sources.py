"""The sentences that sources say to a person, read from them: every text that can come to a place, with samples in its holes.

A text is followed from where it is handed over: through names, choices, sums and the functions that return it. What comes from
outside the program, or is counted, is a hole: a sample stands there.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache, cached_property
from itertools import islice, product
from pathlib import Path
from typing import TypeVar

Node = TypeVar("Node", bound=ast.AST)
NUMBER, NAME, QUOTED = "7", "Xyz", "'Xyz'"
"""What stands in a hole: for a number, for a word, for what somebody wrote."""
DEEPEST, MOST = 6, 64
"""How far a text is followed, and how many ways to say one are taken."""


@dataclass(frozen=True)
class Place:
    """Where a text is handed over: the function or class that takes it, by name, and the arguments that are told, by number."""

    name: str
    told: tuple[int, ...]
    of: type[ast.expr] = ast.Name
    """How it is called: `leave(...)`, or `notes.leave(...)`."""


@dataclass(frozen=True)
class Source:
    """A module."""

    path: Path
    modules: dict[str, Source] = field(repr=False, compare=False)

    @cached_property
    def tree(self) -> ast.Module:
        """Its syntax."""
        return ast.parse(self.path.read_text("utf-8"))

    @cached_property
    def functions(self) -> dict[str, ast.FunctionDef]:
        """Its functions and methods, by name."""
        return {node.name: node for node in ast.walk(self.tree) if isinstance(node, ast.FunctionDef)}

    @cached_property
    def imported(self) -> dict[str, str]:
        """Which module a name comes from."""
        found = (node for node in ast.walk(self.tree) if isinstance(node, ast.ImportFrom) and node.module)
        return {name.asname or name.name: str(node.module) for node in found for name in node.names}

    @cached_property
    def calls(self) -> list[tuple[ast.Call, list[ast.AST]]]:
        """Its calls, and what encloses each, from the module on."""
        return list(_nodes(ast.Call, self.tree, [self.tree]))

    def texts(self, node: ast.expr, within: list[ast.AST], depth: int = 0) -> list[str] | None:
        """Returns what an expression can be as a text; None where that is not told here."""
        if depth > DEEPEST:
            return None
        if inner := _ways(node):
            return _both(*(self.texts(one, within, depth) for one in inner))
        if isinstance(node, ast.Constant):
            return [node.value] if isinstance(node.value, str) else None
        if isinstance(node, ast.JoinedStr):
            parts = [self._part(part, within, depth) for part in node.values]
            return ["".join(one) for one in islice(product(*parts), MOST)]
        return self._sum(node, within, depth) if isinstance(node, ast.BinOp) else self._looked_up(node, within, depth + 1)

    def _sum(self, node: ast.BinOp, within: list[ast.AST], depth: int) -> list[str] | None:
        left = self.texts(node.left, within, depth)
        if isinstance(node.op, ast.Mult):
            return left and ["", *left]
        right = self.texts(node.right, within, depth) if isinstance(node.op, ast.Add) else None
        return None if left is None and right is None else [a + b for a in left or [NAME] for b in right or [NAME]][:MOST]

    def _looked_up(self, node: ast.expr, within: list[ast.AST], depth: int) -> list[str] | None:
        if isinstance(node, ast.Name):
            return self._named(node.id, within, depth)
        if isinstance(node, ast.Attribute):
            return self._of_class(node, depth)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            return self._returned(node.func.id, depth)
        return None

    def _part(self, part: ast.expr, within: list[ast.AST], depth: int) -> list[str]:
        if not isinstance(part, ast.FormattedValue):
            return self.texts(part, within, depth) or [NAME]
        if part.conversion == ord("r"):
            return [QUOTED]
        form = "".join(str(one.value) for one in getattr(part.format_spec, "values", ()) if isinstance(one, ast.Constant))
        if form.endswith(("f", "g", ",", "d")):
            return [NUMBER]
        return self.texts(part.value, within, depth) or [NUMBER, NAME]

    def _named(self, name: str, within: list[ast.AST], depth: int) -> list[str] | None:
        for scope in reversed(within):
            if isinstance(scope, ast.FunctionDef) and name in (taken := [one.arg for one in scope.args.args]):
                given = [(call.args[taken.index(name)], around) for call, around in self._calls_of(scope.name, taken.index(name))]
                return _both(*(self.texts(one, around, depth) for one, around in given))
            if isinstance(scope, ast.FunctionDef | ast.Module) and (found := _given_within(scope).get(name)):
                return _both(*(self.texts(one, within, depth) for one in found))
        other = self.modules.get(self.imported.get(name, ""))
        return other._named(name, [other.tree], depth) if other and other is not self else None

    def _calls_of(self, name: str, at: int) -> Iterator[tuple[ast.Call, list[ast.AST]]]:
        for call, around in self.calls:
            if (
                isinstance(call.func, ast.Name)
                and call.func.id == name
                and len(call.args) > at
                and not isinstance(call.args[at], ast.Starred)
            ):
                yield call, around

    def _of_class(self, node: ast.Attribute, depth: int) -> list[str] | None:
        if not isinstance(node.value, ast.Name):
            return None
        other = self.modules.get(self.imported.get(node.value.id, ""), self)
        for one in ast.walk(other.tree):
            if isinstance(one, ast.ClassDef) and one.name == node.value.id:
                found = [value for line in one.body for name, value in _given(line) if name == node.attr]
                return _both(*(other.texts(value, [other.tree, one], depth) for value in found)) if found else None
        return None

    def _returned(self, name: str, depth: int) -> list[str] | None:
        if name not in self.functions:
            other = self.modules.get(self.imported.get(name, ""))
            return other._returned(name, depth) if other and other is not self else None
        function = self.functions[name]
        if not isinstance(function.returns, ast.Name | ast.BinOp) or "str" not in ast.unparse(function.returns):
            return None
        values = [node.value for node in ast.walk(function) if isinstance(node, ast.Return) and node.value]
        return _both(*(self.texts(one, [self.tree, function], depth) for one in values))


def sources(root: Path, folders: Iterable[str]) -> dict[str, Source]:
    """Returns the modules of folders, by their dotted names."""
    found: dict[str, Source] = {}
    for folder in folders:
        for path in sorted((root / folder).rglob("*.py")):
            found[".".join(path.relative_to(root).with_suffix("").parts)] = Source(path, found)
    return found


def told_at(modules: Iterable[Source], places: Iterable[Place]) -> Iterator[tuple[str, list[str] | None]]:
    """Yields where a text is handed over, and all that it can be; None where that cannot be read."""
    by_name = {(place.of, place.name): place for place in places}
    for module in modules:
        for call, within in module.calls:
            name = getattr(call.func, "id", getattr(call.func, "attr", ""))
            place = by_name.get((type(call.func), name))
            for at in place.told if place else ():
                if at < len(call.args):
                    yield f"{module.path.name}:{call.lineno} {name}", module.texts(call.args[at], within)


def told_under(modules: Iterable[Source], keys: Iterable[str]) -> Iterator[tuple[str, list[str] | None]]:
    """Yields where a text is put under one of these keys of a mapping, and all that it can be; None where that cannot be read."""
    wanted = set(keys)
    for module in modules:
        for made, within in _nodes(ast.Dict, module.tree, [module.tree]):
            for key, value in zip(made.keys, made.values, strict=True):
                if isinstance(key, ast.Constant) and key.value in wanted:
                    yield f"{module.path.name}:{made.lineno} {key.value}", module.texts(value, within)


def _nodes(of: type[Node], node: ast.AST, within: list[ast.AST]) -> Iterator[tuple[Node, list[ast.AST]]]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, of):
            yield child, within
        yield from _nodes(of, child, [*within, child] if isinstance(child, ast.FunctionDef | ast.ClassDef) else within)


def _ways(node: ast.expr) -> list[ast.expr]:
    """Returns the expressions that one chooses between; none where it is no choice."""
    if isinstance(node, ast.IfExp):
        return [node.body, node.orelse]
    if isinstance(node, ast.BoolOp):
        return node.values
    return node.value.values if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Dict) else []


@cache
def _given_within(scope: ast.AST) -> dict[str, list[ast.expr]]:
    """Returns what is given to each name anywhere in a scope."""
    found: dict[str, list[ast.expr]] = {}
    for node in ast.walk(scope):
        for name, value in _given(node):
            found.setdefault(name, []).append(value)
    return found


def _given(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """Yields the names that a statement gives something, and what it gives them."""
    targets: list[ast.expr] = []
    if isinstance(node, ast.Assign):
        targets, value = node.targets, node.value
    elif isinstance(node, ast.AnnAssign | ast.NamedExpr | ast.AugAssign) and node.value:
        targets, value = [node.target], node.value
    for target in targets:
        if isinstance(target, ast.Name):
            yield target.id, value
        for at, one in enumerate(target.elts) if isinstance(target, ast.Tuple) else ():
            ways = [value.body, value.orelse] if isinstance(value, ast.IfExp) else [value]
            if isinstance(one, ast.Name):
                yield from ((one.id, way.elts[at]) for way in ways if isinstance(way, ast.Tuple))


def _both(*ways: list[str] | None) -> list[str] | None:
    told = [one for way in ways if way is not None for one in way]
    return list(dict.fromkeys(told))[:MOST] if told else None
