"""What does not fit a type, in words: which key, what is wrong with it, what is allowed there.

That is what the JSON Schema says of the key: for refusals of documents, too, as catalogs import nothing of ours.
"""

import re
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any, Final

from pydantic import TypeAdapter, ValidationError

from catalogs.faults import Fault
from catalogs.references import near

UNKNOWN: Final = ("extra_forbidden", "unexpected_keyword_argument")
"""What pydantic calls an unknown key."""
NO_KEYS: Final = ("[key]", "tuple[", "literal[")
"""How the steps of pydantic's ways begin that are no keys of the file: a mapping's key itself, and which of several forms was tried."""
QUOTED: Final = re.compile("'([^']*)'")


@cache
def reader_of(of: Any) -> TypeAdapter[Any]:
    """Returns what reads a type, made when it is first asked for."""
    return TypeAdapter(of)


@cache
def schema_of(of: Any) -> Mapping[str, Any]:
    """Returns the JSON Schema of a type, made when something is first refused by it: it takes as long as to read fifty scenes."""
    return reader_of(of).json_schema()


def misfit(error: ValidationError, schema: Mapping[str, Any]) -> Fault:
    """Returns the first fault of a file by its schema; unknown keys come first, as one that is missing may be one that is misspelled."""
    return told(min(error.errors(include_url=False), key=lambda one: one["type"] not in UNKNOWN), schema)


def told(wrong: Mapping[str, Any], schema: Mapping[str, Any]) -> Fault:
    """Returns one of pydantic's errors in words, with what is allowed by the schema; of no file."""
    kind, context, value = wrong["type"], wrong.get("ctx", {}), wrong["input"]
    at = tuple(step for step in wrong["loc"] if not (isinstance(step, str) and step.startswith(NO_KEYS)))
    is_key = wrong["loc"][-1:] == NO_KEYS[:1]
    if kind == "refused":
        return Fault("", at, context["problem"], context["allowed"])
    if kind == "value_error":
        return Fault("", at, str(context["error"]), allowed(schema, schema_at(schema, at)))
    if kind in UNKNOWN:
        known = [key for option in options_of(schema, schema_at(schema, at[:-1])) for key in option.get("properties", ())]
        return Fault("", at, f"is not known{near(str(at[-1]), known)}", ", ".join(known))
    if kind == "literal_error":
        words = QUOTED.findall(str(context["expected"]))
        may_be = ", ".join(words) if is_key else allowed(schema, schema_at(schema, at))
        return Fault("", at, f"is {called(value)}{near(str(value), words)}", may_be)
    if is_key:
        return Fault("", at, "is a key that is not allowed", "a text" if isinstance(value, int) else "0, 1, 2, ...")
    return Fault("", at, _problem(wrong), allowed(schema, schema_at(schema, at)))


def _problem(wrong: Mapping[str, Any]) -> str:
    """Returns what is wrong with a value: that it is not there, its length, or else the value."""
    if wrong["type"] == "missing":
        return "is missing"
    if "actual_length" in wrong.get("ctx", {}):
        return f"has {wrong['ctx']['actual_length']} entries"
    if wrong["type"] == "string_too_long":
        return f"is a text of {len(wrong['input'])} characters"
    return f"is {called(wrong['input'])}"


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
    elif "properties" in node and not says:
        words = f"an object with {', '.join(node['properties'])}"
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
