"""Plain values -> YAML that reads well: what is flat on one line, what is not as a block.

Comes in: plain values. Goes out: a string that YAML 1.1 and 1.2 readers understand alike. May import: nothing of ours.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, Final

_PLAIN: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_./|@+-]*( [A-Za-z0-9_./|@+-]+)*")
_RESERVED: Final = frozenset({"null", "true", "false", "yes", "no", "on", "off"})
"""Words that YAML 1.1 or 1.2 takes for something else than a text."""
_UNPRINTABLE: Final = re.compile('[^ -~\u00a1-\u1fff\u2030-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]|["\\\\]')
_SHORT: Final = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}


def dump(document: Any) -> str:
    """Writes plain values as a YAML document."""
    if _is_flat(document):
        return _flow(document) + "\n"
    return "\n".join(_block(document, "")) + "\n"


def _is_scalar(value: Any) -> bool:
    return not isinstance(value, (dict, list))


def _is_flat(value: Any) -> bool:
    """Tells whether a value reads well on one line: scalars, or lists of scalars, in one mapping or list."""
    if _is_scalar(value):
        return True
    inner = value.values() if isinstance(value, dict) else value
    return all(_is_scalar(item) or (isinstance(item, list) and all(map(_is_scalar, item))) for item in inner)


def _flow(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_text(key)}: {_flow(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_flow, value)) + "]"
    return _scalar(value)


def _scalar(value: Any) -> str:
    if isinstance(value, str):
        return _text(value)
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        written = repr(value)
        return written if "." in written or "e" not in written else written.replace("e", ".0e")
    return str(value)


def _text(value: str) -> str:
    if _PLAIN.fullmatch(value) and value.lower() not in _RESERVED:
        return value
    return '"' + _UNPRINTABLE.sub(_escaped, value) + '"'


def _escaped(match: re.Match[str]) -> str:
    letter = match.group()
    if letter in _SHORT:
        return _SHORT[letter]
    code = ord(letter)
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def _block(value: Any, indent: str) -> Iterator[str]:
    """Yields the lines of a mapping or list that is not flat."""
    if isinstance(value, dict):
        for key, item in value.items():
            if _is_flat(item):
                yield f"{indent}{_text(key)}: {_flow(item)}"
            else:
                yield f"{indent}{_text(key)}:"
                yield from _block(item, indent + "  ")
    else:
        for item in value:
            if _is_flat(item):
                yield f"{indent}- {_flow(item)}"
            else:
                first, *rest = _block(item, indent + "  ")
                yield f"{indent}- {first[len(indent) + 2 :]}"
                yield from rest
