"""The page's table of what the service says in German, read by other code than the page's."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Final

WORDS: Final = Path(__file__).parents[1] / "web" / "src" / "words"
HOLE: Final = re.compile(r"\{(\w+)\}")
NUMBER, ANY = r"-?[0-9]+(?:,[0-9]{3})*(?:\.[0-9]+)?(?:e[+-]?[0-9]+)?", ".+?"
SENTENCES: Final = {"why", "whys", "effect", "lengths"}
"""What stands in these holes is a sentence in its turn."""
LAST: Final = 1000
"""By how much a form that begins with a hole of words comes after the others."""
DEEPEST: Final = 8
FOREIGN: Final = {"fault", "name", "names", "key", "unit", "units", "formats", "version", "outline"}
"""What stands in these holes is somebody else's words, or a word of the API."""
LISTED: Final = re.compile(r"[\w+-]+(?:, [\w+-]+)+")
"""Words of the API in a row."""
NO_WORDS: Final = re.compile(r"'[^']*'|\"[^\"]*\"|`[^`]*`|\S*[_/\[\].]\S*|\bXyz\b|\b(?:[cm]?m|in|ft|[A-Z]{4,})\b|\de[+-]\d|[^A-Za-z]+")
"""What is the same in every language: what somebody wrote, ids and paths, and numbers; and a hole's sample."""


def _table(name: str) -> dict[str, str]:
    return dict(json.loads((WORDS / name).read_text("utf-8")))


def _order(english: str) -> int:
    begins = HOLE.match(english)
    return len(HOLE.sub("", english)) - (LAST if begins and not re.fullmatch(r"n\d?", begins[1]) else 0)


def _pattern(english: str) -> re.Pattern[str]:
    parts = HOLE.split(english)
    holes = (f"(?P<{name}>{NUMBER if re.fullmatch(r'n[0-9]?', name) else ANY})" for name in parts[1::2])
    return re.compile("".join(part for pair in zip(map(re.escape, parts[::2]), [*holes, ""], strict=True) for part in pair), re.DOTALL)


NAMES: Final = {name.replace("_", " ") for name in _table("names.de.json")} | set(_table("names.de.json")) | set(_table("de.json"))


@cache
def _forms() -> list[re.Pattern[str]]:
    return [_pattern(english) for english in sorted(_table("told.de.json"), key=_order, reverse=True)]


def has_form(said: str) -> bool:
    """Tells whether a sentence is in one of the table's forms, and so is every sentence within it."""
    for form in _forms():
        found = form.fullmatch(said)
        if found and all(has_form(inner) or hole == "whys" for hole, inner in found.groupdict().items() if hole in SENTENCES):
            return True
    return False


def is_told(said: str, depth: int = 0) -> bool:
    """Tells whether no English word is left where a text is said in its first form, and what is in the holes in turn."""
    if said in NAMES or LISTED.fullmatch(said) or NO_WORDS.sub("", said) == "":
        return True
    for form in _forms():
        found = form.fullmatch(said)
        if found:
            return depth < DEEPEST and all(hole in FOREIGN or is_told(inner, depth + 1) for hole, inner in found.groupdict().items())
    parts = re.split(r", | and | \+ ", said)
    return len(parts) > 1 and all(is_told(part, depth + 1) for part in parts)
