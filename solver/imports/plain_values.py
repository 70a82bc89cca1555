"""Values of foreign documents, asked for one by one: what is wrong is said with its place."""

from collections.abc import Mapping, Sequence
from math import isnan
from typing import Any, Final, TypeAlias, TypeVar, overload
from xml.etree.ElementTree import Element

from solver.errors import FieldError
from solver.plain import is_text

FARTHEST: Final = 1e9
"""No coordinate is farther away, in any unit."""
LONGEST: Final = 200
"""Letters of a text that are kept."""
Default = TypeVar("Default", float, None)
Written: TypeAlias = Mapping[str, str] | Element
"""What says texts by their names."""


def an_object(value: object, where: str) -> Mapping[str, Any]:
    """Returns a value that is an object.

    Raises:
        FieldError: it is none.
    """
    if not isinstance(value, Mapping):
        raise FieldError(where, f"is {_called(value)}", "an object")
    return value


def a_list(value: object, where: str) -> Sequence[Any]:
    """Returns a value that is a list.

    Raises:
        FieldError: it is none.
    """
    if not isinstance(value, list):
        raise FieldError(where, f"is {_called(value)}", "a list")
    return value


@overload
def a_number(said: Mapping[str, Any], key: str, where: str) -> float: ...
@overload
def a_number(said: Mapping[str, Any], key: str, where: str, default: Default) -> float | Default: ...
def a_number(said: Mapping[str, Any], key: str, where: str, default: float | str | None = "required") -> float | None:
    """Returns a number; the default where the key is missing or null.

    Raises:
        FieldError: it is no number, not finite, or farther than any house; or it is missing and there is no default.
    """
    value = said.get(key)
    if value is None and not isinstance(default, str):
        return default
    place = f"{where}.{key}" if key else where
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise FieldError(place, f"is {_called(value)}", "a number")
    if not -FARTHEST <= value <= FARTHEST:
        raise FieldError(
            place, "is not a number" if isinstance(value, float) and isnan(value) else "is too large", f"a number up to {FARTHEST:g}"
        )
    return float(value)


@overload
def number_in(said: Written, key: str, where: str, /) -> float: ...
@overload
def number_in(said: Written, key: str, where: str, default: Default, /) -> float | Default: ...
def number_in(said: Written, key: str, where: str, /, *default: float | None) -> float | None:
    """Returns a number that is written as text, as `a_number` does."""
    text = said.get(key)
    try:
        value: object = None if text is None else float(text)
    except ValueError:
        value = text
    return a_number({key: value}, key, where, *default)


def a_text(said: Mapping[str, Any], key: str, where: str) -> str:
    """Returns a text, empty where the key is missing or null.

    Raises:
        FieldError: it is no text.
    """
    value = said.get(key)
    if value is None:
        return ""
    if not is_text(value):
        raise FieldError(f"{where}.{key}", f"is {_called(value)}", "a text")
    return str(value)[:LONGEST]


def one_of(said: Mapping[str, Any], key: str, words: Sequence[str], where: str, required: bool = False) -> str:
    """Returns one of some words, the first where the key is missing.

    Raises:
        FieldError: it is none of them; or it is missing and required.
    """
    value = said.get(key, None if required else words[0])
    if not isinstance(value, str) or value not in words:
        raise FieldError(f"{where}.{key}", f"is {_called(value)}", ", ".join(filter(None, words)))
    return value


def _called(value: object) -> str:
    if value is None:
        return "missing"
    if isinstance(value, str):
        return f"{value!r:.40}"
    if isinstance(value, Mapping):
        return "an object"
    return "a list" if isinstance(value, list) else f"{value!r:.40}"
