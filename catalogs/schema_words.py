"""What a JSON Schema says of a key, in words: for refusals of documents and of catalogs.

It stands here because catalogs import nothing of ours.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any


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
        text = f"a text of at most {node['maxLength']} characters" if "maxLength" in node else "a text"
        words = {"boolean": "true, false", "string": text, "object": "an object"}.get(kind, "any value")
    return f"{words}: {says}" if says and kind not in ("number", "integer") else words


def _range(kind: str, node: Mapping[str, Any]) -> str:
    above, least, most = (node.get(key) for key in ("exclusiveMinimum", "minimum", "maximum"))
    if above is not None:
        return f"{kind} above {above:.16g}" + (f", up to {most:.16g}" if most is not None else "")
    return kind + (f" from {least:.16g}" if least is not None else "") + (f" to {most:.16g}" if most is not None else "")


def _list(schema: Mapping[str, Any], node: Mapping[str, Any]) -> str:
    least, most = node.get("minItems"), node.get("maxItems")
    if least is not None and least == most:
        return f"a list of {least} entries"
    bounds = [f"at least {least}"] * (least is not None) + [f"at most {most}"] * (most is not None)
    items = allowed(schema, node["items"]) if isinstance(node.get("items"), dict) else ""
    return "a list" + (f" of {' and '.join(bounds)} entries" if bounds else "") + (f", each {items}" if items.startswith("a text") else "")


def schema_at(schema: Mapping[str, Any], way: Sequence[str | int]) -> Mapping[str, Any]:
    """Returns the part of a schema that describes what lies that way in a document."""
    node: Mapping[str, Any] = schema
    for step in way:
        node = next((inner for inner in _inner(schema, node, step) if inner is not None), {})
    return _referred(schema, node) if "$ref" in node and "description" not in node else node


def _inner(schema: Mapping[str, Any], node: Mapping[str, Any], step: str | int) -> list[Mapping[str, Any] | None]:
    found: list[Mapping[str, Any] | None] = []
    for option in options_of(schema, node):
        if isinstance(step, int):
            listed = option.get("prefixItems", ())
            found.append(listed[step] if step < len(listed) else option.get("items"))
        more = option.get("additionalProperties")
        found.append(option.get("properties", {}).get(step, more if isinstance(more, dict) else None))
    return found


def options_of(schema: Mapping[str, Any], node: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Returns a part of a schema, and the parts of which it may be any."""
    return [_referred(schema, node), *(_referred(schema, option) for option in node.get("anyOf", ()))]


def _referred(schema: Mapping[str, Any], node: Mapping[str, Any]) -> Mapping[str, Any]:
    if "$ref" not in node:
        return node
    found: Mapping[str, Any] = schema["$defs"][node["$ref"].rpartition("/")[2]]
    return found
