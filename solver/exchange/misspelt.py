"""Keys of a scene that it keeps without knowing them, and are nearly ones that it knows: slips of the pen. They are told, and kept."""

from collections.abc import Iterator
from dataclasses import fields
from difflib import get_close_matches
from itertools import islice
from typing import Final

from solver.fields import EXTRA, Record
from solver.plain import path
from solver.scene import Scene

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
