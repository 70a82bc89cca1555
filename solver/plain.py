"""Plain values: what JSON can say, and what was wrong with one that it cannot."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final, TypeAlias

Document: TypeAlias = dict[str, Any]
"""A mapping of plain values."""
MAX_NESTING: Final = 64
"""How deep a document may be; ours need 8. Our choice."""


class Wrong(Exception):
    """A value is wrong; collects the way to it while the readers unwind."""

    def __init__(self, problem: str, allowed: str = "") -> None:
        self.problem, self.allowed = problem, allowed
        self._way: list[str | int] = []
        super().__init__(problem)

    def inside(self, step: str | int) -> "Wrong":
        """Notes that the value lies under this key or index of what encloses it."""
        self._way.append(step)
        return self

    @property
    def way(self) -> tuple[str | int, ...]:
        """The keys and indices from the document's root."""
        return tuple(reversed(self._way))


def path(way: Sequence[str | int]) -> str:
    """Writes a way through a document, such as `rooms[2].furniture[0].width`."""
    text = ""
    for step in way:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text


def quoted(text: str, most: int = 60) -> str:
    """Returns what somebody wrote, in quotes, and cut where it is longer than that."""
    whole = repr(text)
    return whole if len(whole) <= most else f"{whole[: most - 2]}…{whole[-1]}"


def is_text(value: object) -> bool:
    """Tells whether a value is a string that UTF-8 can carry (no lone surrogates)."""
    if not isinstance(value, str):
        return False
    return value.isascii() or not any("\ud800" <= letter <= "\udfff" for letter in value)


_ATOMS: Final = frozenset({type(None), bool, int})
"""Classes whose values stay as they are."""


def plain(value: Any, depth: int = 0) -> Any:
    """Copies a value that JSON can say, of Python's own types; tuples become lists.

    Raises:
        Wrong: it holds something else, or a number that is not finite, or is nested too deeply.
    """
    kind = value.__class__
    if kind in _ATOMS or (kind is str and value.isascii()):
        return value
    if kind is not dict and kind is not list:  # which nearly all others are
        if isinstance(value, float):
            return _finite(value)
        if is_text(value):
            return str.__str__(value)
        if isinstance(value, int):
            return int(value)
    if depth == MAX_NESTING:
        raise Wrong("is nested too deeply", f"{MAX_NESTING} levels")
    if kind is dict or isinstance(value, Mapping):
        mapping: Document = {}
        for key, item in value.items():
            of, name = item.__class__, key if key.__class__ is str and key.isascii() else _key(key)
            try:
                mapping[name] = item if of in _ATOMS or (of is str and item.isascii()) else plain(item, depth + 1)
            except Wrong as wrong:
                raise wrong.inside(key) from None
        return mapping
    if isinstance(value, (list, tuple)):
        items: list[Any] = []
        try:
            for item in value:
                items.append(item if item.__class__ in _ATOMS else plain(item, depth + 1))
        except Wrong as wrong:
            raise wrong.inside(len(items)) from None
        return items
    raise Wrong(f"is a {type(value).__name__}", "a mapping, list, text, finite number, true, false or null")


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise Wrong(f"is {float(value)}", "a finite number")
    return float(value) + 0.0


def _key(key: object) -> str:
    if key.__class__ is str and key.isascii():
        return key
    if isinstance(key, str) and is_text(key):
        return str.__str__(key)
    if isinstance(key, int) and not isinstance(key, bool):
        return str(key)
    raise Wrong(f"has the key {key!r}", "keys that are texts")
