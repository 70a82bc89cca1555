"""Bytes to documents: what bodies and files have in common."""

from __future__ import annotations

from pathlib import PurePath
from typing import Any, Final, TypeAlias

from solver.errors import SyntaxFault
from solver.exchange import FORMATS, load_text

Document: TypeAlias = dict[str, Any]

ENDINGS: Final = {ending: name for name, format in FORMATS.items() for ending in format.endings}


def parse(content: bytes, format: str) -> object:
    """Reads bytes as a document.

    Raises:
        SyntaxFault: they are empty, or not a document of that format.
    """
    if not content.strip():
        raise SyntaxFault("the text is empty; {} asks for all defaults where there are any")
    return load_text(content, format)


def format_of_name(name: str) -> str | None:
    """Tells a file's format by its name, None where the name does not say."""
    return ENDINGS.get(PurePath(name).suffix.lower())


def format_of_content(content: bytes) -> str:
    """Tells a document's format by its first character: JSON objects and lists begin with a bracket."""
    return "json" if content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] in (b"{", b"[") else "yaml"
