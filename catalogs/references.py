"""Words of a catalog that name something of a catalog: a field's type says what, and one walk over all entries checks it.

A `Names` on a field of several words is for each of them.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from types import UnionType
from typing import Annotated, Any, Final, Union, get_args, get_origin

from pydantic import BaseModel

from catalogs.faults import Fault, Key

MOST_LISTED: Final = 40
"""Where more words than this would do, a fault says which they are instead of listing them. Our choice."""


@dataclass(frozen=True)
class Names:
    """Says that a word is one of the words that are `what`; `where` says in which file those are."""

    what: str
    where: str


def near(word: str, words: Iterable[str]) -> str:
    """Returns the word of some that is most like a wrong one, as what a problem ends with; else nothing."""
    found = get_close_matches(word, list(words), 1)
    return f"; {found[0]}?" if found else ""


def unknown_words(entry: BaseModel, file: str, at: Key, known: Mapping[str, Collection[str]]) -> Iterator[Fault]:
    """Yields a fault for every word of an entry, at a key of a file, that names nothing.

    `known` are, by `Names.what`, the words that are that.
    """
    for names, word, place in _named(type(entry), entry, at):
        words = known[names.what]
        if word not in words:
            listed = ", ".join(words) if len(words) <= MOST_LISTED else names.where
            yield Fault(file, place, f"unknown {names.what} {word!r}{near(word, words)}", listed)


def _named(kind: Any, value: Any, at: Key) -> Iterator[tuple[Names, str, Key]]:
    """Yields the words of a value whose type says what they name, and where they stand."""
    origin, inner = get_origin(kind), get_args(kind)
    if value is None or not _has_names(kind):
        return
    if origin is Annotated:
        for names in (mark for mark in inner[1:] if isinstance(mark, Names)):
            yield from ((names, word, at) for word in ((value,) if isinstance(value, str) else value))
        yield from _named(inner[0], value, at)
    elif origin in (Union, UnionType):
        for either in inner:
            yield from _named(either, value, at)
    elif isinstance(value, BaseModel):
        for name, field in _fields(kind).items():
            yield from _named(field, getattr(value, name), (*at, name))
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _named(inner[0], key, (*at, key))
            yield from _named(inner[1], item, (*at, key))
    else:
        for index, item in enumerate(value):
            yield from _named(inner[0], item, (*at, index))


@cache
def _fields(kind: type[BaseModel]) -> dict[str, Any]:
    """Returns the types of a model's fields, as they are written, that say what words in them name."""
    written = {name: Annotated[field.annotation, *field.metadata, None] for name, field in kind.model_fields.items()}
    return {name: field for name, field in written.items() if _has_names(field)}


@cache
def _has_names(kind: Any) -> bool:
    """Tells whether a type, or one within it, says what its words name."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return bool(_fields(kind))
    return isinstance(kind, Names) or any(_has_names(one) for one in get_args(kind))
