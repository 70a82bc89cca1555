"""What the keys of documents mean, for whoever reads a schema: the docstrings of the types that declare them say it.

Not here: what refusals say too (`Says`).
"""

import re
from collections.abc import Iterator, Mapping
from inspect import cleandoc
from typing import Any, Final

from solver.fields import camel

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
