"""The table behind reader, writer and schema: what each key of a document holds, from the types of `solver.scene`.

Comes in: a dataclass. Goes out: its `Field`s in the document's order. May import: scene.
"""

from __future__ import annotations

import types
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, fields, is_dataclass
from typing import Any, Final, Union, get_args, get_origin, get_type_hints

from solver.scene import MAX_SEED, Decoration, Furniture, Room

EXTRA: Final = "extra"
"""The attribute that keeps a record's unknown keys."""
ID: Final = "id"
"""A key that a reader makes up where it is absent."""
MAX_MAGNITUDE: Final = 1e6
"""Largest magnitude of a number that has no range of its own, m or degrees; our choice, far beyond any house."""
WHOLE: Final = frozenset({"rotation"})
"""Decimal keys that are written as integers where they are integral."""
_REQUIRED: Final = {Furniture: ("name", "x", "z"), Decoration: ("name", "x", "z")}
"""What the contract requires beyond the metadata: these have defaults only because of the order of their fields."""
_AT_LEAST_ITEMS: Final = {(Room, "outline"): 4}


@dataclass(frozen=True)
class Text:
    """A string, one of `choices` unless that is empty."""

    choices: tuple[str, ...] = ()


@dataclass(frozen=True)
class Number:
    """A finite number in [least, most], above 0 if `positive`, an integer if `whole`."""

    whole: bool
    least: float
    most: float
    positive: bool = False


@dataclass(frozen=True)
class Flag:
    """A yes or no."""


@dataclass(frozen=True)
class Free:
    """A mapping of anything that JSON can say."""


@dataclass(frozen=True)
class Indexed:
    """A mapping from an index to a text."""


@dataclass(frozen=True)
class Counted:
    """A mapping from a word to a whole number in [least, most], or a text that names one."""

    least: int
    most: int


@dataclass(frozen=True)
class Several:
    """A list of `item`s: exactly `length` of them, or any number from `at_least`."""

    item: Shape
    length: int | None = None
    at_least: int = 0


@dataclass(frozen=True)
class Record:
    """A mapping with the keys of a dataclass."""

    of: type[Any]


Shape = Text | Number | Flag | Free | Indexed | Counted | Several | Record


@dataclass(frozen=True)
class Field:
    """One key: what it holds, whether it may be null, must be there, or is left out where it is null.

    `says` is what null stands for, for people.
    """

    name: str
    shape: Shape
    nullable: bool
    required: bool
    default: Any
    omit_none: bool
    says: str = ""


def _number(whole: bool, metadata: Mapping[str, Any]) -> Number:
    reach = MAX_SEED if whole else MAX_MAGNITUDE
    positive = bool(metadata.get("positive"))
    least = 0.0 if positive else metadata.get("at_least", -reach)
    return Number(whole, least, metadata.get("at_most", reach), positive)


def _several(hint: Any, metadata: Mapping[str, Any]) -> Several:
    items = get_args(hint)
    if items[-1] is Ellipsis:
        return Several(_shape(items[0], metadata))
    return Several(_shape(items[0], metadata), len(items))


def _shape(hint: Any, metadata: Mapping[str, Any]) -> Shape:
    if hint is str:
        return Text(tuple(metadata.get("choices", ())))
    if hint is bool:
        return Flag()
    if hint in (int, float):
        return _number(hint is int, metadata)
    if is_dataclass(hint) and isinstance(hint, type):
        return Record(hint)
    if hint == Mapping[str, int]:
        return Counted(metadata["at_least"], metadata["at_most"])
    if get_origin(hint) is tuple:
        return _several(hint, metadata)
    if get_origin(hint) is Mapping:
        return Indexed() if get_args(hint)[0] is int else Free()
    raise TypeError(f"no way to read or write {hint!r}")


def _without_none(hint: Any) -> tuple[Any, bool]:
    """Splits `X | None` into X, the first of its kinds, and whether None was among it."""
    if get_origin(hint) not in (Union, types.UnionType):
        return hint, False
    members = [member for member in get_args(hint) if member is not types.NoneType]
    return members[0], len(members) < len(get_args(hint))


_TABLES: dict[type[Any], tuple[Field, ...]] = {}


def table(of: type[Any]) -> tuple[Field, ...]:
    """Returns what the document of a dataclass holds, in its order, without the unknown keys' place."""
    if of not in _TABLES:
        _TABLES[of] = _read_table(of)
    return _TABLES[of]


def _read_table(of: type[Any]) -> tuple[Field, ...]:
    hints = get_type_hints(of)
    rows = []
    for declared in fields(of):
        if declared.name == EXTRA:
            continue
        hint, nullable = _without_none(hints[declared.name])
        shape = _shape(hint, declared.metadata)
        if (of, declared.name) in _AT_LEAST_ITEMS and isinstance(shape, Several):
            shape = Several(shape.item, shape.length, _AT_LEAST_ITEMS[of, declared.name])
        required = _is_required(of, declared)
        default = () if isinstance(shape, Several) and not nullable else declared.default
        omit_none, says = bool(declared.metadata.get("omit_none")), declared.metadata.get("says", "")
        rows.append(Field(declared.name, shape, nullable, required, default, omit_none, says))
    return tuple(rows)


def _is_required(of: type[Any], declared: Any) -> bool:
    if declared.metadata.get("required") or declared.name in _REQUIRED.get(of, ()):
        return True
    return declared.default is MISSING and declared.default_factory is MISSING and declared.name != ID


def keeps_extra(of: type[Any]) -> bool:
    """Tells whether a record keeps unknown keys."""
    return EXTRA in of.__dataclass_fields__


def aliases(of: type[Any]) -> dict[str, str]:
    """Maps the camelCase spelling of each key that has one to the key."""
    return {camel(row.name): row.name for row in table(of) if camel(row.name) != row.name}


def camel(name: str) -> str:
    """Spells snake_case in camelCase."""
    head, *tail = name.split("_")
    return head + "".join(word.capitalize() for word in tail)
