"""An own asset's file, read whole; how its shapes come into a body's box; who is to be named for all assets that are used."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final, NamedTuple

from catalogs.assets.asset_entry import FRONT_TURNS, Asset
from catalogs.assets.glb_file import GlbBook, GlbFault, bounds_of, read_glb
from solver.errors import RequestError
from solver.exports.model import Point

CREDITS: Final = "CREDITS.txt"


class AssetFile(NamedTuple):
    """A file's JSON, its binary part, and both as a book."""

    document: dict[str, Any]
    content: bytes
    book: GlbBook


class AssetFit(NamedTuple):
    """How an asset's shapes come into a body's box: turned about +y (degrees), shifted, then stretched along x, y, z."""

    turn: int
    shift: Point
    stretch: Point

    @property
    def quaternion(self) -> tuple[float, float, float, float]:
        """The turn, x y z w."""
        half = math.radians(self.turn) / 2
        return 0.0, math.sin(half), 0.0, math.cos(half)


def asset_file(name: str, asset: Asset) -> AssetFile:
    """Reads an asset's file.

    Raises:
        RequestError: it is no longer the file that was measured.
    """
    try:
        file = read_glb(asset.path)
        bounds = bounds_of(file)
        with Path(asset.path).open("rb") as opened:
            opened.seek(file.start)
            content = opened.read(file.length)
    except (GlbFault, OSError) as fault:
        raise changed(name, str(fault)) from None
    if (bounds.low, bounds.high, len(content)) != (asset.low, asset.high, file.length):
        raise changed(name, "is not what it was when its folder was read")
    return AssetFile(file.document, content, GlbBook(file))


def changed(name: str, problem: str) -> RequestError:
    """Returns the refusal of an asset that cannot be used."""
    return RequestError("assets", f"{name} {problem}", "the files as `compose assets check` found them")


def fit_of(asset: Asset, size: Point) -> AssetFit:
    """Returns how an asset comes into a box of this width, depth and height, m, around the middle of its footprint at its underside."""
    (x0, y0, z0), (x1, y1, z1) = asset.low, asset.high
    turn, x, z = FRONT_TURNS[asset.front], (x0 + x1) / 2, (z0 + z1) / 2
    along, up, across = (x1 - x0, y1 - y0, z1 - z0) if turn % 180 == 0 else (z1 - z0, y1 - y0, x1 - x0)
    cos, sin = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}[turn]
    width, depth, height = size
    return AssetFit(turn, (-x * cos - z * sin, -y0, x * sin - z * cos), (width / along, height / up, depth / across))


def credits_of(assets: Mapping[str, Asset]) -> bytes:
    """Returns whom to name for the assets that a house is shown with: name, author, licence and source of each."""
    lines = ["Assets in these files that others made, with their licences:", ""]
    for name, asset in sorted(assets.items()):
        by = f" by {asset.author}" if asset.author else ""
        lines.append(f"{name}{by}: {asset.license}{f', {asset.source}' if asset.source else ''}")
    return "\n".join(lines).encode() + b"\n"
