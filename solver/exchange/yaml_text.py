"""YAML text <-> documents: YAML 1.2's core schema, so that `on` and `no` are texts and dates stay as written.

Comes in: a string. Goes out: plain values, and back. May import: the ground floor.

PyYAML parses; what its events mean is settled here as they come: depth, repeated keys, aliases. Its nodes take three times as long to
read, and its writer ten times as long as this one.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache
from itertools import takewhile
from typing import Any, Final

import yaml

from solver.errors import SyntaxFault
from solver.plain import MAX_NESTING

MAX_ALIASED: Final = 1_000_000
"""How many values a document may say by aliases; what is said outright is limited by its length. Our choice."""
_LOADER: Final = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_TAG: Final = "tag:yaml.org,2002:"
_CONSTANTS: Final[dict[str, Any]] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), math.nan),
    **{sign + word: math.inf for sign in ("", "+") for word in (".inf", ".Inf", ".INF")},
    **{"-" + word: -math.inf for word in (".inf", ".Inf", ".INF")},
}
_WHOLE: Final = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
_DECIMAL: Final = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_PLAIN: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_./|@+-]*( [A-Za-z0-9_./|@+-]+)*")
_RESERVED: Final = frozenset({"null", "true", "false", "yes", "no", "on", "off"})
"""Words that YAML 1.1 or 1.2 takes for something else than a text."""
_ESCAPED: Final = re.compile('[\x00-\x1f"\\\\\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff\U00010000-\U0010ffff]')
"""Letters that do not stand for themselves between quotes."""
_SHORT: Final = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}
_LONG_KEY: Final = 1000
"""A longer key is marked by a question mark: without it YAML ends keys after 1,024 letters."""
_NUMBER_START: Final = frozenset("+-.0123456789")


def load(text: str) -> object:
    """Reads a YAML document; see `text.load_text`."""
    try:
        return _Reader(text).document()
    except yaml.YAMLError as error:
        raise SyntaxFault(f"not YAML: {_worded(error)}") from None
    except (RecursionError, ValueError) as error:
        raise SyntaxFault(f"not YAML: {error}") from None


def dump(document: Any) -> str:
    """Writes plain values as YAML that readers of 1.1 and 1.2 understand alike: what is flat on one line, what is not as a block."""
    return _written(document, "") + "\n"


def _written(value: Any, indent: str) -> str:
    """Writes a value whose further lines are indented so."""
    if _is_flat(value):
        return _flow(value)
    line = "\n" + indent
    if isinstance(value, list):
        return line.join("- " + _written(item, indent + "  ") for item in value)
    return line.join(_key(key, line) + ":" + _under_key(item, indent) for key, item in value.items())


def _under_key(value: Any, indent: str) -> str:
    if _is_flat(value):
        return " " + _flow(value)
    inner = indent if isinstance(value, list) else indent + "  "
    return f"\n{inner}{_written(value, inner)}"


def _is_flat(value: Any) -> bool:
    """Tells whether a value reads well on one line: a scalar, or a mapping or list of scalars and lists of scalars."""
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return not any(
        isinstance(item, dict) or (isinstance(item, list) and any(isinstance(one, dict | list) for one in item)) for item in items
    )


def _flow(value: Any) -> str:
    """Writes a value on one line."""
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, float):
        written = repr(value)
        return written if "." in written else written.replace("e", ".0e")
    if isinstance(value, list):
        return f"[{', '.join(map(_flow, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_key(key, ' ')}: {_flow(item)}" for key, item in value.items()) + "}"
    return "null" if value is None else str(value).lower()


def _key(key: str, line: str) -> str:
    return _text(key) if len(key) <= _LONG_KEY else f"? {_text(key)}{line}"


@lru_cache(maxsize=4096)
def _text(text: str) -> str:
    """Writes a text, in quotes where it is not made of plain words."""
    if _PLAIN.fullmatch(text) and text.lower() not in _RESERVED:
        return text
    return f'"{_ESCAPED.sub(_escaped, text)}"'


def _escaped(letter: re.Match[str]) -> str:
    code = ord(letter.group())
    return _SHORT.get(letter.group()) or (f"\\x{code:02X}" if code < 0x100 else f"\\u{code:04X}" if code < 0x10000 else f"\\U{code:08X}")


def _worded(error: yaml.YAMLError) -> str:
    return re.sub(r"\s+", " ", str(error)).replace('in "<unicode string>", ', "at ")[:300]


class _Reader:
    """Puts a document together from the parser's events."""

    def __init__(self, text: str) -> None:
        self._events = yaml.parse(text, Loader=_LOADER)
        self._anchored: dict[str, tuple[Any, int]] = {}
        self._said, self._aliased = 0, 0

    def document(self) -> object:
        """Returns the one document of the text."""
        found = [self._value(event, 0) for event in self._events if isinstance(event, yaml.NodeEvent)]
        if len(found) != 1:
            raise SyntaxFault(f"not a YAML document: {len(found)} documents in one text" if found else "the text is empty")
        return found[0]

    def _value(self, event: Any, depth: int) -> Any:
        """Returns the value that an event begins, `depth` levels inside the document."""
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event)
        before = self._said
        self._said += 1
        value = _scalar(event) if isinstance(event, yaml.ScalarEvent) else self._collection(event, depth)
        if event.anchor is not None:
            self._anchored[event.anchor] = (value, self._said - before)
        return value

    def _collection(self, event: Any, depth: int) -> Any:
        is_list = isinstance(event, yaml.SequenceStartEvent)
        if event.tag not in (None, "!", _TAG + ("seq" if is_list else "map")):
            raise SyntaxFault(f"not YAML of ours: the tag {event.tag!r:.80} {_where(event)}")
        if depth == MAX_NESTING:
            raise SyntaxFault(f"nested too deeply: more than {MAX_NESTING} levels {_where(event)}")
        inside = takewhile(_goes_on, self._events)
        if is_list:
            return [self._value(item, depth + 1) for item in inside]
        found: dict[str, Any] = {}
        for key in inside:
            name = self._key(key)
            if name in found:
                raise SyntaxFault(f"the key {name!r:.80} is given twice {_where(key)}")
            found[name] = self._value(next(self._events), depth + 1)
        return found

    def _key(self, event: Any) -> str:
        """Returns a key as it is written, whatever it would be as a value."""
        key = event.value if isinstance(event, yaml.ScalarEvent) else self._alias(event) if isinstance(event, yaml.AliasEvent) else None
        if not isinstance(key, str):
            raise SyntaxFault(f"not YAML of ours: a key that is no text {_where(event)}")
        return key

    def _alias(self, event: Any) -> Any:
        if event.anchor not in self._anchored:
            raise SyntaxFault(f"not YAML of ours: the alias {event.anchor!r:.80} stands for nothing finished {_where(event)}")
        value, count = self._anchored[event.anchor]
        self._said += count
        self._aliased += count
        if self._aliased > MAX_ALIASED:
            raise SyntaxFault(f"aliases repeat more than {MAX_ALIASED} values {_where(event)}")
        return value


def _goes_on(event: Any) -> bool:
    return not isinstance(event, yaml.CollectionEndEvent)


def _where(event: Any) -> str:
    return f"(line {event.start_mark.line + 1}, column {event.start_mark.column + 1})"


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
    raise SyntaxFault(f"not YAML of ours: the tag {event.tag!r:.80} {_where(event)}")


def _named(value: object) -> str:
    return {type(None): "null", bool: "bool", int: "int", float: "float"}.get(type(value), "str")


def _resolved(text: str) -> Any:
    if text in _CONSTANTS:
        return _CONSTANTS[text]
    if text[0] not in _NUMBER_START:
        return text
    if _WHOLE.fullmatch(text):
        return int(text, 0) if text[:2] in ("0o", "0x") else int(text)
    return float(text) if _DECIMAL.fullmatch(text) else text
