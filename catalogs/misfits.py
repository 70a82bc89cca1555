"""What does not fit a type, in words: which key, what is wrong with it, what is allowed there."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import ValidationError

from catalogs.faults import Fault
from catalogs.references import near

UNKNOWN = "extra_forbidden"
"""What pydantic calls an unknown key."""
QUOTED = re.compile("'([^']*)'")


def misfit(error: ValidationError, schema: Mapping[str, Any]) -> Fault:
    """Returns the first fault of a file; unknown keys come first, for one that is missing may be one that is misspelled.

    Args:
        error: what pydantic found.
        schema: the JSON Schema of what was read.
    """
    first = min(error.errors(include_url=False), key=lambda one: one["type"] != UNKNOWN)
    at = tuple(step for step in first["loc"] if step != "[key]")
    if first["type"] == UNKNOWN:
        known = _keys(schema, at[:-1])
        return Fault("", at, f"unknown key{near(str(at[-1]), known)}", ", ".join(known))
    if first["type"] == "literal_error":
        expected = str(first["ctx"]["expected"])
        word = at[-1] if first["loc"][-1] == "[key]" else first["input"]
        return Fault("", at, f"is {word!r:.60}{near(str(word), QUOTED.findall(expected))}", expected)
    return Fault("", at, first["msg"].removeprefix("Value error, "))


def _keys(schema: Mapping[str, Any], way: Sequence[str | int]) -> list[str]:
    """Returns the keys that a schema knows that way inside a document."""
    nodes = _options(schema, schema)
    for step in way:
        inner = [node.get("items") if isinstance(step, int) else _under(node, step) for node in nodes]
        nodes = [option for found in inner if isinstance(found, Mapping) for option in _options(schema, found)]
    return [key for node in nodes for key in node.get("properties", ())]


def _under(node: Mapping[str, Any], key: str) -> Any:
    return node.get("properties", {}).get(key, node.get("additionalProperties"))


def _options(schema: Mapping[str, Any], node: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Returns what a part of a schema may be, without references."""
    if "$ref" in node:
        node = schema["$defs"][node["$ref"].rpartition("/")[2]]
    return [one for option in node.get("anyOf", ()) for one in _options(schema, option)] or [node]
