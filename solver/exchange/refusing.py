"""The words of refusals: which field, what is wrong with it, what is allowed. The schema that is published says the last."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from itertools import islice
from typing import Any, Final

from pydantic import ValidationError

from catalogs.misfits import LENGTHS, allowed, called, options_of, schema_at
from solver.errors import MOST_TOLD
from solver.plain import path

MOST_FOUND: Final = 100
"""Faults that those are chosen from: a field may have several."""
KEY: Final = "[key]"
"""What pydantic calls a mapping's key that is wrong itself."""


def refusals(error: ValidationError, schema: Mapping[str, Any], document: object) -> list[tuple[str, str, str]]:
    """Returns the field, what is wrong with it, and what is allowed by the schema, of the first MOST_TOLD fields that are wrong."""
    told: dict[str, tuple[str, str, str]] = {}
    for one in islice(error.errors(include_url=False), MOST_FOUND):
        entry = _refusal(one, schema, document)
        told.setdefault(entry[0], entry)
    around = {field for field in told if any(other.startswith((f"{field}[", f"{field}.")) for other in told)}
    return [entry for field, entry in told.items() if field not in around][:MOST_TOLD]


def _refusal(first: Mapping[str, Any], schema: Mapping[str, Any], document: object) -> tuple[str, str, str]:
    way = [step for step in first["loc"] if step != KEY]
    if first["type"] == "refused":
        return path(way), first["ctx"]["problem"], first["ctx"]["allowed"]
    if first["type"] in ("unexpected_keyword_argument", "extra_forbidden"):
        known = [key for option in options_of(schema, schema_at(schema, way[:-1])) for key in option.get("properties", ())]
        near = get_close_matches(str(way[-1]), known, 1)
        return path(way), "is not known" + (f"; {near[0]}?" if near else ""), ", ".join(known)
    if first["type"] == "value_error":
        return path(way), f"is {called(first['input'])}", str(first["ctx"]["error"])
    if first["loc"][-1:] == (KEY,):
        return path(way), "is a key that is not allowed", "a text" if isinstance(first["input"], int) else "0, 1, 2, ..."
    return path(way), _wrong(first, way, document), allowed(schema, schema_at(schema, way))


def _wrong(first: Mapping[str, Any], way: Sequence[str | int], document: object) -> str:
    """Returns what is wrong with a value: that it is not there, its length, or else the value."""
    if first["type"] == "missing":
        return "is null" if _is_null(document, way) else "is missing"
    if first["type"] in LENGTHS:
        return f"has {first['ctx']['actual_length']} entries"
    if first["type"] == "string_too_long":
        return f"is a text of {len(first['input'])} characters"
    return f"is {called(first['input'])}"


def _is_null(document: object, way: Sequence[str | int]) -> bool:
    for step in way[:-1]:
        document = _inside(document, step)
    return isinstance(document, Mapping) and way[-1] in document


def _inside(document: object, step: str | int) -> object:
    if isinstance(document, Mapping):
        return document.get(step)
    return document[step] if isinstance(document, list | tuple) and isinstance(step, int) and step < len(document) else None
