"""YAML text <-> documents of the service: read by YAML 1.2's core schema, written so that readers of 1.1 and 1.2 agree.

The core writes it: PyYAML's own writer takes a hundred times as long.
"""

from typing import Final

from solver.errors import SyntaxFault
from solver.plain import MAX_NESTING

_FIRST_LINE: Final = b"format: compose-scene/1\n"
_MARKED: Final = b"format: compose-scene/1 # the last line is ...\n"
"""The first line of a scene that is written here. Most pieces of a YAML text are YAML, so the end says that it is the end."""
_END: Final = b"...\n"


def load(text: str) -> object:
    """Reads a YAML document; see `text.load_text`."""
    from catalogs.yaml_reading import YamlFault, read_yaml  # noqa: PLC0415 - PyYAML takes 0.05 s to import

    marked, end = _MARKED.decode(), _END.decode()
    begins_so = text.startswith(marked.rstrip()) or marked.startswith(text.rstrip())
    if begins_so and not f"{text.rstrip()}\n".endswith(f"\n{end}"):
        raise SyntaxFault("the scene is cut off: as its first line says, its last line should be ...")
    try:
        return read_yaml(text, MAX_NESTING)
    except YamlFault as fault:
        raise SyntaxFault(f"not YAML: {fault}") from None


def of_json(text: bytes) -> bytes:
    """Writes a JSON document as YAML that readers of 1.1 and 1.2 understand alike: what is flat on one line, what is not as a block."""
    from solver.core import ask  # noqa: PLC0415 - who only reads needs no core

    written = ask("yaml_text", text)
    return _MARKED + written.removeprefix(_FIRST_LINE) + _END if written.startswith(_FIRST_LINE) else written
