"""YAML text <-> documents: YAML 1.2's core schema, so that `on` and `no` are texts and dates stay as written.

Comes in: a string. Goes out: plain values, and back. May import: the ground floor.

Read from the parser's events, not its nodes: depth, repeated keys and aliases are settled as they come, without recursion.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
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
_NUMBER_START: Final = frozenset("+-.0123456789")


def load(text: str) -> object:
    """Reads a YAML document; see `text.load_text`."""
    builder = _Builder()
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            builder.take(event)
    except yaml.YAMLError as error:
        raise SyntaxFault(f"not YAML: {_worded(error)}") from None
    except (RecursionError, ValueError) as error:
        raise SyntaxFault(f"not YAML: {error}") from None
    return builder.document()


def dump(document: Any) -> str:
    """Writes plain values as YAML that reads well: what is flat on one line, what is not as a block."""
    text: str = yaml.dump(document, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=2**31 - 1)
    return text.removesuffix("...\n")


class _Dumper(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
    """Writes what readers of YAML 1.1 and 1.2 understand alike."""

    def ignore_aliases(self, data: Any) -> bool:
        """Writes everything out."""
        return True

    def represent_mapping(self, tag: str, mapping: Any, flow_style: bool | None = None) -> Any:
        """Writes a mapping."""
        return super().represent_mapping(tag, mapping, _is_flat(mapping.values()))

    def represent_sequence(self, tag: str, sequence: Any, flow_style: bool | None = None) -> Any:
        """Writes a list."""
        return super().represent_sequence(tag, sequence, _is_flat(sequence))


def _quoted(dumper: _Dumper, text: str) -> Any:
    """Writes a text in quotes where it is not made of plain words."""
    style = None if _PLAIN.fullmatch(text) and text.lower() not in _RESERVED else '"'
    return dumper.represent_scalar(_TAG + "str", text, style=style)


_Dumper.add_representer(str, _quoted)


def _is_flat(items: Iterable[Any]) -> bool:
    """Tells whether items read well on one line: scalars, or lists of scalars."""
    return all(
        not isinstance(item, dict | list) or (isinstance(item, list) and not any(isinstance(one, dict | list) for one in item))
        for item in items
    )


def _worded(error: yaml.YAMLError) -> str:
    return re.sub(r"\s+", " ", str(error)).replace('in "<unicode string>", ', "at ")[:300]


class _Open:
    """A mapping or list whose end has not come yet."""

    def __init__(self, into: dict[str, Any] | list[Any], anchor: str | None) -> None:
        self.into, self.anchor = into, anchor
        self.key: str | None = None
        self.count = 1


class _Builder:
    """Puts a document together from the parser's events."""

    def __init__(self) -> None:
        self._open: list[_Open] = []
        self._anchored: dict[str, tuple[Any, int]] = {}
        self._roots: list[Any] = []
        self._aliased = 0

    def document(self) -> object:
        """Returns the one document of the text."""
        if len(self._roots) != 1:
            raise SyntaxFault(f"not a YAML document: {len(self._roots)} documents in one text" if self._roots else "the text is empty")
        return self._roots[0]

    def take(self, event: Any) -> None:
        """Takes the next event."""
        match event:
            case yaml.ScalarEvent():
                self._scalar(event)
            case yaml.MappingStartEvent() | yaml.SequenceStartEvent():
                self._start(event)
            case yaml.MappingEndEvent() | yaml.SequenceEndEvent():
                done = self._open.pop()
                self._remember(done.anchor, done.into, done.count)
                self._add(done.into, done.count, event)
            case yaml.AliasEvent():
                self._alias(event)

    def _start(self, event: Any) -> None:
        into: dict[str, Any] | list[Any] = {} if isinstance(event, yaml.MappingStartEvent) else []
        expected = _TAG + ("map" if isinstance(into, dict) else "seq")
        if event.tag not in (None, "!", expected):
            raise SyntaxFault(f"not YAML of ours: the tag {event.tag!r:.80} {_where(event)}")
        if self._open and isinstance(self._open[-1].into, dict) and self._open[-1].key is None:
            raise SyntaxFault(f"not YAML of ours: a key that is no text {_where(event)}")
        if len(self._open) == MAX_NESTING:
            raise SyntaxFault(f"nested too deeply: more than {MAX_NESTING} levels {_where(event)}")
        self._open.append(_Open(into, event.anchor))

    def _scalar(self, event: Any) -> None:
        if self._open and isinstance(self._open[-1].into, dict) and self._open[-1].key is None:
            self._key(event.value, event)
            return
        value = _value(event)
        self._remember(event.anchor, value, 1)
        self._add(value, 1, event)

    def _alias(self, event: Any) -> None:
        if event.anchor not in self._anchored:
            raise SyntaxFault(f"not YAML of ours: the alias {event.anchor!r:.80} stands for nothing finished {_where(event)}")
        value, count = self._anchored[event.anchor]
        self._aliased += count
        if self._aliased > MAX_ALIASED:
            raise SyntaxFault(f"aliases repeat more than {MAX_ALIASED} values {_where(event)}")
        if self._open and isinstance(self._open[-1].into, dict) and self._open[-1].key is None:
            self._key(value, event)
        else:
            self._add(value, count, event)

    def _key(self, key: object, event: Any) -> None:
        opened = self._open[-1]
        if not isinstance(key, str):
            raise SyntaxFault(f"not YAML of ours: a key that is no text {_where(event)}")
        if key in opened.into:
            raise SyntaxFault(f"the key {key!r:.80} is given twice {_where(event)}")
        opened.key = key

    def _add(self, value: Any, count: int, event: Any) -> None:
        if not self._open:
            self._roots.append(value)
            return
        opened = self._open[-1]
        opened.count += count
        if isinstance(opened.into, list):
            opened.into.append(value)
        elif opened.key is None:
            raise SyntaxFault(f"not YAML of ours: a key that is no text {_where(event)}")
        else:
            opened.into[opened.key] = value
            opened.key = None

    def _remember(self, anchor: str | None, value: Any, count: int) -> None:
        if anchor is not None:
            self._anchored[anchor] = (value, count)


def _where(event: Any) -> str:
    return f"(line {event.start_mark.line + 1}, column {event.start_mark.column + 1})"


def _value(event: Any) -> Any:
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
