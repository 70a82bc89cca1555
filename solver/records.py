"""Records that are like other ones, fields of records that are made when somebody first asks for them, and what is made once a key."""

from collections.abc import Callable
from typing import Any, Final, Generic, TypeVar, cast

Key = TypeVar("Key")
Value = TypeVar("Value")
LATER: Final = "_later"
"""Where a record keeps, by field, what makes the value of one that is made when it is first asked for."""


class _Late:
    """The default of a field that may be made later. It has no `__set__`: a value that is there is found without it."""

    def __init__(self, default: object) -> None:
        self.default = default

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, record: object, owner: type | None = None) -> object:
        if record is None:
            return self.default
        made = record.__dict__[self.name] = record.__dict__[LATER][self.name]()
        return made


def late(default: Value) -> Value:
    """Declares a field that may be made later."""
    declared: Any = _Late(default)
    return cast(Value, declared)


class kept(Generic[Value]):
    """What is worked out of a record when it is first asked for: `functools.cached_property` without the lock that it has before 3.12."""

    def __init__(self, make: Callable[[Any], Value]) -> None:
        self._make, self.__doc__ = make, make.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, record: Any, owner: type | None = None) -> Value:
        made = record.__dict__[self._name] = self._make(record)
        return made


def changed(record: Value, **values: object) -> Value:
    """Returns a record like another one but for some fields.

    Unlike `dataclasses.replace`, which takes eight times as long, it makes nothing that is made later, and calls no `__init__`.
    """
    made: Any = object.__new__(record.__class__)
    own = record.__dict__ | values
    if LATER in own:
        own[LATER] = {name: maker for name, maker in own[LATER].items() if name not in values}
    object.__setattr__(made, "__dict__", own)  # as a whole, which takes half the time of filling it; a frozen record refuses its own
    return cast(Value, made)


def made_later(record: Value, **makers: Callable[[], object]) -> Value:
    """Returns a record like another one, of which some fields are made when somebody first asks for them."""
    made: Any = object.__new__(record.__class__)
    own = record.__dict__.copy()
    own[LATER] = own[LATER] | makers if LATER in own else makers
    for name in makers:
        own.pop(name, None)
    object.__setattr__(made, "__dict__", own)
    return cast(Value, made)


def maker_in(record: object, name: str) -> Any:
    """Returns what makes a field of a record later; None where that was told."""
    return record.__dict__.get(LATER, {}).get(name)


class MadeOnce(dict[Key, Value]):
    """Values by key, each made when it is first asked for; where there are `most` of them all are let go.

    Its `__getitem__` takes half as long as a function that `lru_cache` wraps.
    """

    def __init__(self, make: Callable[[Key], Value], most: int) -> None:
        super().__init__()
        self._make, self._most = make, most

    def __missing__(self, key: Key) -> Value:
        if len(self) >= self._most:
            self.clear()
        made = self[key] = self._make(key)
        return made
