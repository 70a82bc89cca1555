"""What does not fit a type, in words: which key, what is wrong with it, what is allowed there."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, Final

from pydantic import ValidationError

from catalogs.faults import Fault
from catalogs.references import near
from catalogs.schema_words import allowed, called, options_of, schema_at

UNKNOWN: Final = "extra_forbidden"
"""What pydantic calls an unknown key."""
OTHER_FORMS: Final = ("_type", "_parsing")
"""How pydantic's names end for a value of another type, a number in place of a list, say."""
LENGTHS: Final = {"too_long": ("max_length", "at most"), "too_short": ("min_length", "at least")}
"""What pydantic calls a list of another length, and where it says the bound."""
NO_KEYS: Final = ("[key]", "tuple[", "literal[")
"""How the steps of pydantic's ways begin that are no keys of the file: a mapping's key itself, and which of several forms was tried."""
QUOTED: Final = re.compile("'([^']*)'")


def misfit(error: ValidationError, schema: Mapping[str, Any]) -> Fault:
    """Returns the first fault of a file by its schema; unknown keys come first, as one that is missing may be one that is misspelled."""
    first = min(error.errors(include_url=False), key=lambda one: one["type"] != UNKNOWN)
    at = tuple(step for step in first["loc"] if not (isinstance(step, str) and step.startswith(NO_KEYS)))
    if first["type"] == UNKNOWN:
        known = _keys(schema, at[:-1])
        return Fault("", at, f"unknown key{near(str(at[-1]), known)}", ", ".join(known))
    if first["type"] == "literal_error":
        expected = str(first["ctx"]["expected"])
        word = at[-1] if first["loc"][-1] == "[key]" else first["input"]
        return Fault("", at, f"is {word!r:.60}{near(str(word), QUOTED.findall(expected))}", expected)
    if first["type"] == "missing":
        return Fault("", at, "is missing", _allowed(schema, at))
    if first["type"] in LENGTHS:
        bound, words = LENGTHS[first["type"]]
        return Fault("", at, f"has {first['ctx']['actual_length']} entries", f"{words} {first['ctx'][bound]}")
    if first["type"].endswith((*OTHER_FORMS, "_pattern_mismatch")):
        return Fault("", at, f"is {called(first['input'])}", _allowed(schema, at))
    return Fault("", at, first["msg"].removeprefix("Value error, ").replace("Input should", "should"))


def _keys(schema: Mapping[str, Any], way: Sequence[str | int]) -> list[str]:
    """Returns the keys that a schema knows that way inside a document."""
    return [key for option in options_of(schema, schema_at(schema, way)) for key in option.get("properties", ())]


def _allowed(schema: Mapping[str, Any], way: Sequence[str | int]) -> str:
    known = _keys(schema, way)
    return f"an object with {', '.join(known)}" if known else allowed(schema, schema_at(schema, way))
