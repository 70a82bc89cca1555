"""Text <-> documents: one module a format behind one dict.

A .glb that was exported is read too, not its shapes but the scene inside; it is not written here.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import Any, Final

from solver.errors import FieldError, SyntaxFault
from solver.exchange import json_text, yaml_text
from solver.plain import Wrong, path, plain


@dataclass(frozen=True)
class TextFormat:
    """A way to write documents: how to read it, how to write it from its JSON, its media type and file endings."""

    load: Callable[[str], object]
    of_json: Callable[[bytes], bytes]
    media_type: str
    endings: tuple[str, ...]


FORMATS: Final = {
    "json": TextFormat(json_text.load, bytes, "application/json", (".json",)),
    "yaml": TextFormat(yaml_text.load, yaml_text.of_json, "application/yaml", (".yaml", ".yml")),
}
GLB: Final = "glb"
"""What is read beside texts: a .glb with a scene inside."""
MAGIC: Final = b"glTF"
"""How a .glb begins."""
_HEADER: Final = 20
_JSON_CHUNK: Final = b"JSON"
ENDINGS: Final = {ending: name for name, format in FORMATS.items() for ending in format.endings}


def format_of_name(name: str) -> str | None:
    """Tells the format in which a file is to be written by its name, None where the name does not say."""
    return ENDINGS.get(PurePath(name).suffix.lower())


def format_of_file(name: str, content: bytes) -> str:
    """Tells the format in which a file is to be read: by its name, else by its first character, a bracket in JSON objects and lists."""
    is_glb = PurePath(name).suffix.lower() == f".{GLB}" or content.startswith(MAGIC)
    as_text = "json" if content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] in (b"{", b"[") else "yaml"
    return GLB if is_glb else format_of_name(name) or as_text


def load_text(text: bytes | str, format: str) -> object:
    """Reads a document from text, or from a .glb.

    Args:
        text: UTF-8, with or without a byte order mark; or the bytes of a .glb.
        format: one of FORMATS, or GLB.

    Returns:
        Mappings with text keys, lists, texts, numbers (also ones that are not finite: the reader names their field),
        flags and None.

    Raises:
        SyntaxFault: not a document of that format, a key given twice, or nested deeper than MAX_NESTING.
    """
    if not text.strip():
        raise SyntaxFault("the text is empty; {} asks for all defaults where there are any")
    if format == GLB:
        return _scene_in_glb(text if isinstance(text, bytes) else text.encode("utf-8", "replace"))
    return FORMATS[format].load(_decoded(text))


def dump_text(document: object, format: str) -> bytes:
    """Writes a document canonically: equal documents with equal key order give equal bytes.

    Raises:
        FieldError: it holds something that the format cannot say, such as NaN; names the place.
    """
    try:
        checked = plain(document)
    except Wrong as wrong:
        raise FieldError(path(wrong.way) or "document", wrong.problem, wrong.allowed) from None
    return dump_plain(checked, format)


def dump_plain(document: object, format: str) -> bytes:
    """Writes a document of plain values, as `write` returns them, in the same way; nothing is looked at again."""
    return FORMATS[format].of_json(json_text.dump(document).encode())


def _decoded(text: bytes | str) -> str:
    try:
        if isinstance(text, bytes):
            return text.decode("utf-8-sig")
        text.encode()
    except UnicodeError as error:
        raise SyntaxFault(f"the text is not UTF-8: {error}") from None
    return text.removeprefix("\ufeff")


def _scene_in_glb(content: bytes) -> object:
    """Reads the scene inside a .glb (glTF 2.0, binary) that Compose wrote; a SyntaxFault where it is none."""
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
