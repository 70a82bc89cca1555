"""A .glb on disk -> its JSON, and where its binary part lies: nothing else of the file is read.

Time and memory are bounded whatever the file says of itself.
"""

from __future__ import annotations

import json
import os
import stat
import struct
from pathlib import Path
from typing import Any, Final, NamedTuple, NoReturn

MOST_BYTES: Final = 256 << 20
"""Largest file, bytes. Our choice: it is copied into exports and sent to pages."""
MOST_JSON: Final = 4 << 20
"""Longest JSON, bytes: parsed, the worst of it takes 0.1 GB. That of an asset of 30 MB is some ten thousand. Our choice."""
_MAGIC: Final = b"glTF"
_HEADER: Final = struct.Struct("<4sIIII")
_CHUNK: Final = struct.Struct("<II")
_JSON, _BINARY = 0x4E4F534A, 0x004E4942


class GlbFault(Exception):
    """A file is no asset that is read here; says why."""


class GlbFile(NamedTuple):
    """A file's JSON; where its binary part begins, and how long that is, bytes (0: there is none)."""

    document: dict[str, Any]
    start: int
    length: int


def read_glb(path: Path | str) -> GlbFile:
    """Reads what a .glb says of itself.

    Raises:
        GlbFault: it is no whole .glb, or larger than it may be.
    """
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            raise GlbFault("is no file")
        with open(path, "rb", buffering=0) as opened:
            return _read(opened.fileno())
    except (OSError, ValueError) as error:
        raise GlbFault(f"cannot be read: {getattr(error, 'strerror', None) or error}") from None


def _read(number: int) -> GlbFile:
    """Reads the opened file of a number."""
    size = os.fstat(number).st_size
    if size > MOST_BYTES:
        raise GlbFault(f"is {size >> 20} MB; the most is {MOST_BYTES >> 20} MB")
    head = os.read(number, _HEADER.size)
    if len(head) < _HEADER.size or not head.startswith(_MAGIC):
        raise GlbFault("does not begin as a .glb does")
    _, version, total, length, kind = _HEADER.unpack(head)
    if version != 2 or kind != _JSON:
        raise GlbFault(f"is glTF of version {version}, or its JSON is not its first part")
    if total != size:
        raise GlbFault(f"is not whole: {size} bytes, where its header says {total}")
    if _HEADER.size + length > size or length > MOST_JSON:
        raise GlbFault(f"says that its JSON has {length} bytes; the file has {size}, and the most is {MOST_JSON >> 20} MB")
    text = os.pread(number, length, _HEADER.size)
    start = _HEADER.size + length
    return GlbFile(_parsed(text), start + _CHUNK.size, _binary(os.pread(number, _CHUNK.size, start), size - start))


def _binary(head: bytes, rest: int) -> int:
    """Returns the length of the binary part, of whose chunk this is the head and `rest` all bytes that are left."""
    if rest == 0:
        return 0
    if len(head) < _CHUNK.size:
        raise GlbFault("ends within the head of a part")
    length, kind = _CHUNK.unpack(head)
    if kind != _BINARY:
        return 0
    if length > rest - _CHUNK.size:
        raise GlbFault(f"says that its binary part has {length} bytes; {rest - _CHUNK.size} are left")
    return int(length)


def _parsed(text: bytes) -> dict[str, Any]:
    try:
        document = json.loads(text, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise GlbFault(f"has JSON that cannot be read: {error!s:.120}") from None
    if not isinstance(document, dict):
        raise GlbFault("has JSON that is no object")
    return document


def _no_number(word: str) -> NoReturn:
    raise ValueError(f"{word} is no number")
