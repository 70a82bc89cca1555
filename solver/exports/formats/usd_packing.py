"""A stage's text as the files that USD's programs read."""

from __future__ import annotations

import io
import struct
import tempfile
import zipfile
from pathlib import Path
from typing import Final

from solver.exports.writers import Files

_LOCAL_HEADER: Final = 30
_EXTRA_HEADER: Final = struct.Struct("<HH")
_PADDING: Final = 0x1986
"""What USD calls a field of padding in an archive's header."""
_ALIGNED: Final = 64


def packed_stage(text: str, name: str, format: str, beside: Files) -> Files:
    """Returns a stage as `<name>.usda` with the files beside it; for "usdc" and "usdz" as binary, by usd-core; a .usdz holds all."""
    if format not in ("usdc", "usdz"):
        return {f"{name}.usda": text.encode(), **beside}
    from pxr import Sdf  # noqa: PLC0415

    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.ImportFromString(text)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{name}.usdc")
        layer.Export(str(path))
        content = path.read_bytes()
    whole = {path.name: content, **beside}
    return whole if format == "usdc" else {f"{name}.usdz": _zipped(whole)}


def _zipped(files: Files) -> bytes:
    """Returns a .usdz: a ZIP archive whose files are not compressed and begin at multiples of 64 bytes; they bear no date."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as packed:
        for name, content in files.items():
            info = zipfile.ZipInfo(name)
            padding = -(archive.tell() + _LOCAL_HEADER + len(name.encode()) + _EXTRA_HEADER.size) % _ALIGNED
            info.extra = _EXTRA_HEADER.pack(_PADDING, padding) + bytes(padding)
            packed.writestr(info, content)
    return archive.getvalue()
