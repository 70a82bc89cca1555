"""A .glb that Compose wrote -> the document of the scene inside it; its shapes are not looked at."""

from __future__ import annotations

from typing import Any, Final

from solver.errors import SyntaxFault
from solver.exchange import json_text

MAGIC: Final = b"glTF"
"""How a .glb begins."""
_HEADER: Final = 20
_JSON_CHUNK: Final = b"JSON"


def load(content: bytes) -> object:
    """Reads the scene inside a .glb.

    Raises:
        SyntaxFault: it is no .glb (glTF 2.0, binary), or none that Compose wrote.
    """
    if not content.startswith(MAGIC) or len(content) < _HEADER:
        raise SyntaxFault("not a .glb: it does not begin as a binary glTF file does")
    version, total, length = (int.from_bytes(content[at : at + 4], "little") for at in (4, 8, 12))
    if version != 2 or content[16:_HEADER] != _JSON_CHUNK:
        raise SyntaxFault(f"not a .glb that is read here: glTF version {version}, or its JSON is not its first part")
    if total != len(content) or _HEADER + length > total:
        raise SyntaxFault(f"not a whole .glb: {len(content)} bytes, where its header says {total}")
    try:
        text = content[_HEADER : _HEADER + length].decode()
    except UnicodeError as error:
        raise SyntaxFault(f"not a .glb: its JSON is not UTF-8: {error}") from None
    scene = _inside(json_text.parsed(text))
    json_text.check(scene, text)
    return scene


def _inside(document: Any) -> object:
    """Returns the scene's document in the extras of a glTF document's first scene."""
    try:
        scene = document["scenes"][0]["extras"]["scene"]
    except (KeyError, IndexError, TypeError):
        scene = None
    if not isinstance(scene, dict) or "rooms" not in scene:
        raise SyntaxFault("a .glb without a scene inside: only one that Compose exported can be read; other programs' shapes are not")
    return scene
