"""The words of refusals: which field, what is wrong with it, what is allowed. The schema that is published says the last.

Comes in: what pydantic found. Goes out: words. May import: plain.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from itertools import islice
from typing import Any, Final

from pydantic import ValidationError

from solver.plain import path

MOST_TOLD: Final = 20
"""Wrong fields that are told of: enough for a form. Our choice."""
MOST_FOUND: Final = 100
"""Faults that those are chosen from: a field may have several."""
KEY: Final = "[key]"
"""What pydantic calls a mapping's key that is wrong itself."""


def refusals(error: ValidationError, schema: Mapping[str, Any], document: object) -> list[tuple[str, str, str]]:
    """Returns the field, what is wrong with it, and what is allowed, of the first MOST_TOLD fields that are wrong.

    Args:
        error: what was found.
        schema: the JSON Schema of what is read.
        document: what was to be read.
    """
    told: dict[str, tuple[str, str, str]] = {}
    for one in islice(error.errors(include_url=False), MOST_FOUND):
        entry = _refusal(one, schema, document)
        told.setdefault(entry[0], entry)
    return list(told.values())[:MOST_TOLD]


def _refusal(first: Mapping[str, Any], schema: Mapping[str, Any], document: object) -> tuple[str, str, str]:
    way = [step for step in first["loc"] if step != KEY]
    if first["type"] == "refused":
        return path(way), first["ctx"]["problem"], first["ctx"]["allowed"]
    if first["type"] in ("unexpected_keyword_argument", "extra_forbidden"):
        known = [key for option in _options(schema, _node(schema, way[:-1])) for key in option.get("properties", ())]
        near = get_close_matches(str(way[-1]), known, 1)
        return path(way), "is not known" + (f"; {near[0]}?" if near else ""), ", ".join(known)
    if first["type"] == "value_error":
        return path(way), f"is {called(first['input'])}", str(first["ctx"]["error"])
    if first["loc"][-1:] == (KEY,):
        return path(way), "is a key that is not allowed", "a text" if isinstance(first["input"], int) else "0, 1, 2, ..."
    missing = "is null" if _is_null(document, way) else "is missing"
    return path(way), missing if first["type"] == "missing" else f"is {called(first['input'])}", allowed(schema, _node(schema, way))


def called(value: object) -> str:
    """Names a wrong value: a text or number itself, of others the type in the words of JSON."""
    if isinstance(value, str) or (isinstance(value, int | float) and not isinstance(value, bool)):
        return f"{value!r:.60}"
    names = {type(None): "null", bool: "a yes or no", list: "a list", tuple: "a list", dict: "an object"}
    return names.get(type(value), f"a {type(value).__name__}")


def allowed(schema: Mapping[str, Any], node: Mapping[str, Any]) -> str:
    """Says what a key may hold."""
    says = node.get("description", "") if "properties" not in node else ""
    node = {**_referred(schema, node), **node}
    options = [option for option in node.get("anyOf", ()) if option.get("type") != "null"]
    kind = node.get("type", "")
    if options:
        words = " or ".join(allowed(schema, option) for option in options)
    elif "enum" in node or "const" in node:
        words = ", ".join(map(str, node.get("enum", [node.get("const")])))
    elif kind in ("number", "integer"):
        words = _range("a whole number" if kind == "integer" else "a number", node)
    elif kind == "array":
        words = _list(schema, node)
    else:
        words = {"boolean": "true, false", "string": "a text", "object": "an object"}.get(kind, "any value")
    return f"{words}: {says}" if says and kind not in ("number", "integer") else words


def _range(kind: str, node: Mapping[str, Any]) -> str:
    most = f"{node.get('maximum', float('inf')):.16g}"
    if "exclusiveMinimum" in node:
        return f"{kind} above {node['exclusiveMinimum']:.16g}, up to {most}"
    return f"{kind} from {node.get('minimum', float('-inf')):.16g} to {most}"


def _list(schema: Mapping[str, Any], node: Mapping[str, Any]) -> str:
    least, most = node.get("minItems"), node.get("maxItems")
    if least is not None and least == most:
        return f"a list of {least} entries"
    bounds = [f"at least {least}"] * (least is not None) + [f"at most {most}"] * (most is not None)
    items = allowed(schema, node["items"]) if isinstance(node.get("items"), dict) else ""
    return "a list" + (f" of {' and '.join(bounds)} entries" if bounds else "") + (f", each {items}" if items == "a text" else "")


def _node(schema: Mapping[str, Any], way: Sequence[str | int]) -> Mapping[str, Any]:
    """Returns the part of a schema that describes what lies that way in a document."""
    node: Mapping[str, Any] = schema
    for step in way:
        node = next((inner for inner in _inner(schema, node, step) if inner is not None), {})
    return _referred(schema, node) if "$ref" in node and "description" not in node else node


def _inner(schema: Mapping[str, Any], node: Mapping[str, Any], step: str | int) -> list[Mapping[str, Any] | None]:
    found: list[Mapping[str, Any] | None] = []
    for option in _options(schema, node):
        if isinstance(step, int):
            listed = option.get("prefixItems", ())
            found.append(listed[step] if step < len(listed) else option.get("items"))
        more = option.get("additionalProperties")
        found.append(option.get("properties", {}).get(step, more if isinstance(more, dict) else None))
    return found


def _options(schema: Mapping[str, Any], node: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Returns a part of a schema, and the parts of which it may be any."""
    return [_referred(schema, node), *(_referred(schema, option) for option in node.get("anyOf", ()))]


def _referred(schema: Mapping[str, Any], node: Mapping[str, Any]) -> Mapping[str, Any]:
    if "$ref" not in node:
        return node
    found: Mapping[str, Any] = schema["$defs"][node["$ref"].rpartition("/")[2]]
    return found


def _is_null(document: object, way: Sequence[str | int]) -> bool:
    for step in way[:-1]:
        document = _inside(document, step)
    return isinstance(document, Mapping) and way[-1] in document


def _inside(document: object, step: str | int) -> object:
    if isinstance(document, Mapping):
        return document.get(step)
    return document[step] if isinstance(document, list | tuple) and isinstance(step, int) and step < len(document) else None
