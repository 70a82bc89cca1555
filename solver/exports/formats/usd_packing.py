"""A stage's text as the files that USD's programs read.

Comes in: text. Goes out: files. May import: the writers; usd-core where it is asked for.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from solver.exports.writers import Files


def packed_stage(text: str, name: str, format: str) -> Files:
    """Returns a stage as `<name>.usda`; for "usdc" and "usdz" as binary, by usd-core."""
    if format not in ("usdc", "usdz"):
        return {f"{name}.usda": text.encode()}
    from pxr import Sdf, UsdUtils  # noqa: PLC0415

    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.ImportFromString(text)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"{name}.usdc")
        layer.Export(str(path))
        if format == "usdz":
            packed = path.with_suffix(".usdz")
            UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(path)), str(packed))
            path = packed
        return {path.name: path.read_bytes()}
