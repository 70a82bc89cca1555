"""YAML text -> plain values: YAML 1.2's core schema, so that `on` and `no` are texts and dates stay as written.

PyYAML parses; what its events mean is settled here as they come: depth, repeated keys, aliases. Its nodes take three times as long.
"""

import math
import re
from itertools import takewhile
from typing import Any, Final

import yaml

LOADER: Final = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
"""PyYAML's parser, in C where there is one."""
MOST_LEVELS: Final = 64
"""How deep a document may be where nothing else is said."""
MAX_ALIASED: Final = 4_000_000
"""How many values, and letters of texts, a document may say by aliases; what is said outright is limited by its length. Our choice."""
MOST_DIGITS: Final = 400
"""How long a number may be, letters: the largest float has 309 digits. Our choice."""
_TAG: Final = "tag:yaml.org,2002:"
_CONSTANTS: Final[dict[str, Any]] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), math.nan),
    **{sign + word: math.inf for sign in ("", "+") for word in (".inf", ".Inf", ".INF")},
    **{"-" + word: -math.inf for word in (".inf", ".Inf", ".INF")},
}
_NUMBER_START: Final = frozenset("+-.0123456789")
_WHOLE: Final = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
_DECIMAL: Final = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")


class YamlFault(Exception):
    """A text is no YAML document that we read; `line` is where, from 1, or 0 for all of it."""

    def __init__(self, problem: str, line: int = 0) -> None:
        self.line = line
        super().__init__(problem)


def read_yaml(text: str | bytes, most_levels: int = MOST_LEVELS) -> object:
    """Reads one YAML document, so many levels deep at most.

    Raises:
        YamlFault: it is none, holds a tag or key of no use here, gives a key twice, or is too deep.
    """
    try:
        return _Reader(text, most_levels).document()
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        raise YamlFault(_worded(error), mark.line + 1 if mark else 0) from None
    except (RecursionError, ValueError, OverflowError) as error:
        raise YamlFault(str(error)) from None


def _worded(error: yaml.YAMLError) -> str:
    return re.sub(r"\s+", " ", str(error)).replace('in "<unicode string>", ', "at ")[:300]


class _Reader:
    """Puts a document together from the parser's events."""

    def __init__(self, text: str | bytes, most_levels: int) -> None:
        self._events, self._most_levels = yaml.parse(text, Loader=LOADER), most_levels
        self._anchored: dict[str, tuple[Any, int]] = {}
        self._said, self._aliased = 0, 0

    def document(self) -> object:
        """Returns the one document of the text."""
        found = [self._value(event, 0) for event in self._events if isinstance(event, yaml.NodeEvent)]
        if len(found) != 1:
            raise YamlFault(f"{len(found)} documents in one text" if found else "the text is empty")
        return found[0]

    def _value(self, event: Any, depth: int) -> Any:
        """Returns the value that an event begins, `depth` levels inside the document."""
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event)
        before = self._said
        self._said += 1 + len(getattr(event, "value", ""))
        value = _scalar(event) if isinstance(event, yaml.ScalarEvent) else self._collection(event, depth)
        if event.anchor is not None:
            self._anchored[event.anchor] = (value, self._said - before)
        return value

    def _collection(self, event: Any, depth: int) -> Any:
        is_list = isinstance(event, yaml.SequenceStartEvent)
        if event.tag not in (None, "!", _TAG + ("seq" if is_list else "map")):
            raise _fault(f"the tag {event.tag!r:.80}", event)
        if depth == self._most_levels:
            raise _fault(f"nested too deeply: more than {self._most_levels} levels", event)
        inside = takewhile(lambda event: not isinstance(event, yaml.CollectionEndEvent), self._events)
        if is_list:
            return [self._value(item, depth + 1) for item in inside]
        found: dict[str, Any] = {}
        for key in inside:
            name = self._key(key)
            self._said += len(name)
            if name in found:
                raise _fault(f"the key {name!r:.80} is given twice", key)
            found[name] = self._value(next(self._events), depth + 1)
        return found

    def _key(self, event: Any) -> str:
        """A key is what is written, whatever it would be as a value."""
        key = event.value if isinstance(event, yaml.ScalarEvent) else self._alias(event) if isinstance(event, yaml.AliasEvent) else None
        if not isinstance(key, str):
            raise _fault("a key that is no text", event)
        return key

    def _alias(self, event: Any) -> Any:
        if event.anchor not in self._anchored:
            raise _fault(f"the alias {event.anchor!r:.80} stands for nothing finished", event)
        value, count = self._anchored[event.anchor]
        self._said += count
        self._aliased += count
        if self._aliased > MAX_ALIASED:
            raise _fault(f"aliases repeat more than {MAX_ALIASED} values and letters", event)
        return value


def _fault(problem: str, event: Any) -> YamlFault:
    line = event.start_mark.line + 1
    return YamlFault(f"{problem} (line {line}, column {event.start_mark.column + 1})", line)


def _scalar(event: Any) -> Any:
    """Resolves a scalar: quoted ones are texts, plain ones what the core schema says, tagged ones what the tag says."""
    text: str = event.value
    if event.tag in (None, "!") and (event.tag == "!" or not event.implicit[0]):
        return text
    if event.tag == _TAG + "str":
        return text
    if event.tag is None or event.tag.startswith(_TAG):
        value = _resolved(text)
        if event.tag is None or _named(value) == event.tag.removeprefix(_TAG):
            return value
        if event.tag == _TAG + "float" and _named(value) == "int":
            return float(value)
    raise _fault(f"the tag {event.tag!r:.80}", event)


def _named(value: object) -> str:
    return {type(None): "null", bool: "bool", int: "int", float: "float"}.get(type(value), "str")


def _resolved(text: str) -> Any:
    if text in _CONSTANTS:
        return _CONSTANTS[text]
    if text[0] not in _NUMBER_START:
        return text
    if len(text) > MOST_DIGITS and (_WHOLE.fullmatch(text) or _DECIMAL.fullmatch(text)):
        raise ValueError(f"a number of more than {MOST_DIGITS} letters: {text:.20}...")
    if _WHOLE.fullmatch(text):
        return int(text, 0) if text[:2] in ("0o", "0x") else int(text)
    return float(text) if _DECIMAL.fullmatch(text) else text
