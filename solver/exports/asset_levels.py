"""Where things may lie on an asset: the heights at which much of it looks straight up. Reads its triangles."""

from __future__ import annotations

from typing import Final

import numpy as np

from catalogs.assets.asset_entry import Asset
from solver.exports.asset_surfaces import surfaces_of

UPWARDS: Final = 0.95
"""The least height of a unit normal that looks up: within 18 degrees."""
WIDE: Final = 0.25
"""The least share of the footprint that a level covers, its triangles within LEVEL of each other: as a shape's surface does."""
LEVEL: Final = 0.02
"""Triangles whose middles differ by less are of one level, m."""


def levels_of(name: str, asset: Asset) -> tuple[float, ...]:
    """Returns the heights above an asset's underside, m, at which things may lie, the lowest first.

    Raises:
        RequestError: its file is not what was measured.
    """
    metres = asset.size[2] / (asset.high[1] - asset.low[1])
    heights, areas = [], []
    for surface in surfaces_of(name, asset):
        a, b, c = (surface.points[surface.triangles[:, k]] * metres for k in range(3))
        normals = np.cross(b - a, c - a)
        lengths = np.linalg.norm(normals, axis=1)
        up = normals[:, 1] > UPWARDS * np.maximum(lengths, 1e-12)
        heights.append(((a + b + c) / 3)[up, 1])
        areas.append(lengths[up] / 2)
    height, area = np.concatenate(heights), np.concatenate(areas)
    wanted, found = WIDE * asset.size[0] * asset.size[1], []
    order = np.argsort(-height)
    height, area = height[order], area[order]
    start = 0
    while start < len(height):
        end = int(np.searchsorted(-height, LEVEL - height[start], side="right"))
        if area[start:end].sum() >= wanted:
            found.append(round(float(np.average(height[start:end], weights=area[start:end])), 3))
        start = end
    return tuple(reversed(found))
