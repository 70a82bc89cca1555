"""What the keys of documents mean, for whoever reads a schema: the docstrings of the types that declare them say it; and slips of the pen.

Those are keys of a scene that it keeps without knowing them, and that are nearly ones that it knows: they are told, and kept. Not here:
what refusals say too (`Says`).
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields
from difflib import get_close_matches
from inspect import cleandoc
from itertools import islice
from typing import Any, Final

from solver.fields import EXTRA, Record, camel
from solver.plain import path
from solver.scene import Scene

ARGUMENTS: Final = "\n\nArgs:\n"
KEYS: Final = re.compile(r"^ {4}([a-z_]+(?:, [a-z_]+)*): (.*(?:\n {5,}.*)*)", re.MULTILINE)


def tell_keys(schemas: Mapping[str, dict[str, Any]], *bases: type[Any]) -> None:
    """Adds to schemas what their types' docstrings say of each key that tells nothing yet; of the type itself the rest of it is left.

    Args:
        schemas: by the type's name, with -Input or -Output behind it where both are told.
        bases: of the types that are told of.
    """
    declared = {one.__name__: one for base in bases for one in _declared(base)}
    for name, schema in schemas.items():
        declaring = declared.get(name.partition("-")[0])
        if declaring is not None:
            schema["description"], _, arguments = cleandoc(declaring.__doc__ or "").partition(ARGUMENTS)
            for keys, words in KEYS.findall(arguments):
                for key in keys.split(", "):
                    _tell(schema["properties"], key, " ".join(words.split()).rstrip("."))


def _tell(properties: dict[str, Any], key: str, words: str) -> None:
    for spelled in {key, camel(key)} & properties.keys():
        properties[spelled].setdefault("description", words)


def _declared(base: type[Any]) -> Iterator[type[Any]]:
    for one in base.__subclasses__():
        yield one
        yield from _declared(one)


NEARLY: Final = 0.8
"""Keys at least so alike are taken for one."""
MOST_LOOKED_AT: Final = 1_000
"""Unknown keys that are looked at."""
MOST_TOLD: Final = 20


def misspelt(scene: Scene) -> dict[str, str]:
    """Returns, by the place of each unknown key that is nearly a known one, the likeliest of those, of the first MOST_TOLD."""
    seen: dict[tuple[type[Record], str], str | None] = {}
    found = {}
    for record, way in islice(_unknown(scene, ()), MOST_LOOKED_AT):
        key = str(way[-1])
        if (type(record), key) not in seen:
            known = [part.name for part in fields(record) if part.name != EXTRA]  # type: ignore[arg-type]
            small = key[:60].lower().replace("-", "_")
            seen[type(record), key] = next((one for one in get_close_matches(small, known, 1, NEARLY) if one != key), None)
        if meant := seen[type(record), key]:
            found[path(way)] = meant
    return dict(islice(found.items(), MOST_TOLD))


def _unknown(record: Record, way: tuple[str | int, ...]) -> Iterator[tuple[Record, tuple[str | int, ...]]]:
    """Yields the unknown keys in a record and those in it, each with what has it and the way there."""
    for key in getattr(record, EXTRA, None) or ():
        yield record, (*way, key)
    for part in fields(record):  # type: ignore[arg-type]
        value = getattr(record, part.name)
        if isinstance(value, Record):
            yield from _unknown(value, (*way, part.name))
        elif isinstance(value, tuple):
            for at, one in enumerate(value):
                if isinstance(one, Record):
                    yield from _unknown(one, (*way, part.name, at))
