"""YAML text <-> documents of the service: read by YAML 1.2's core schema, written so that readers of 1.1 and 1.2 agree.

PyYAML's own writer takes ten times as long as this one.
"""

import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any, Final

from solver.errors import SyntaxFault
from solver.plain import MAX_NESTING

_PLAIN: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_./|@+-]*( [A-Za-z0-9_./|@+-]+)*")
_RESERVED: Final = frozenset({"null", "true", "false", "yes", "no", "on", "off"})
"""Words that YAML 1.1 or 1.2 takes for something else than a text."""
_ESCAPED: Final = re.compile('[\x00-\x1f"\\\\\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff\U00010000-\U0010ffff]')
"""Letters that do not stand for themselves between quotes."""
_SHORT: Final = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t"}
_LONG_KEY: Final = 1000
"""A longer key is marked by a question mark: without it YAML ends keys after 1,024 letters."""


_FIRST_LINE: Final = "format: compose-scene/1\n"
_MARKED: Final = "format: compose-scene/1 # the last line is ...\n"
"""The first line of a scene that is written here. Most pieces of a YAML text are YAML, so the end says that it is the end."""
_END: Final = "...\n"


def load(text: str) -> object:
    """Reads a YAML document; see `text.load_text`."""
    from catalogs.yaml_reading import YamlFault, read_yaml  # noqa: PLC0415 - PyYAML takes 0.05 s to import

    begins_so = text.startswith(_MARKED.rstrip()) or _MARKED.startswith(text.rstrip())
    if begins_so and not f"{text.rstrip()}\n".endswith(f"\n{_END}"):
        raise SyntaxFault("the scene is cut off: as its first line says, its last line should be ...")
    try:
        return read_yaml(text, MAX_NESTING)
    except YamlFault as fault:
        raise SyntaxFault(f"not YAML: {fault}") from None


def dump(document: Any) -> str:
    """Writes plain values as YAML that readers of 1.1 and 1.2 understand alike: what is flat on one line, what is not as a block."""
    text = _written(document, "") + "\n"
    return _MARKED + text.removeprefix(_FIRST_LINE) + _END if text.startswith(_FIRST_LINE) else text


def _written(value: Any, indent: str) -> str:
    """Writes a value whose further lines are indented so."""
    if _is_flat(value):
        return _flow(value)
    line = "\n" + indent
    if isinstance(value, list):
        return line.join(["- " + _written(item, indent + "  ") for item in value])
    return line.join([_key(key, line) + ":" + _under_key(item, indent) for key, item in value.items()])


def _under_key(value: Any, indent: str) -> str:
    if _is_flat(value):
        return " " + _flow(value)
    inner = indent if isinstance(value, list) else indent + "  "
    return f"\n{inner}{_written(value, inner)}"


def _is_flat(value: Any) -> bool:
    """Tells whether a value reads well on one line: a scalar, or a mapping or list of scalars and lists of scalars."""
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    for item in items:  # noqa: SIM110 - a generator takes twice as long
        if isinstance(item, dict) or (isinstance(item, list) and not _NESTING.isdisjoint(map(type, item))):
            return False
    return True


def _flow(value: Any) -> str:
    """Writes a value on one line."""
    return _FLOW[type(value)](value)


def _number(value: float) -> str:
    written = repr(value)
    return written if "." in written else written.replace("e", ".0e")


def _list(value: list[Any]) -> str:
    return f"[{', '.join([_FLOW[type(item)](item) for item in value])}]"


def _mapping(value: dict[str, Any]) -> str:
    return "{" + ", ".join([f"{_flow_key(key)}: {_FLOW[type(item)](item)}" for key, item in value.items()]) + "}"


def _key(key: str, line: str) -> str:
    return _text(key) if len(key) <= _LONG_KEY else f"? {_text(key)}{line}"


@lru_cache(maxsize=4096)
def _flow_key(key: str) -> str:
    return _key(key, " ")


@lru_cache(maxsize=4096)
def _text(text: str) -> str:
    """Writes a text, in quotes where it is not made of plain words."""
    if _PLAIN.fullmatch(text) and text.lower() not in _RESERVED:
        return text
    return f'"{_ESCAPED.sub(_escaped, text)}"'


def _escaped(letter: re.Match[str]) -> str:
    code = ord(letter.group())
    return _SHORT.get(letter.group()) or (f"\\x{code:02X}" if code < 0x100 else f"\\u{code:04X}" if code < 0x10000 else f"\\U{code:08X}")


_NESTING: Final = frozenset({dict, list})
_FLOW: Final[Mapping[type, Callable[[Any], str]]] = {
    str: _text, float: _number, int: str, bool: {False: "false", True: "true"}.__getitem__, type(None): lambda _: "null",
    list: _list, dict: _mapping,
}  # fmt: skip
"""What writes a value on one line, by its type; documents hold no others."""
