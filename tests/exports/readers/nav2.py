"""Reads a Nav2 map as its map_server and costmap do, with libraries of others: Pillow, PyYAML, SciPy."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import yaml
from PIL import Image
from scipy import ndimage

RADIUS = 0.28
"""Inscribed radius of a robot that must get everywhere, m."""


@dataclass(frozen=True)
class GridMap:
    """A map: which cells are occupied and which are free, row 0 at the bottom (south), as ROS counts."""

    occupied: npt.NDArray[np.bool_]
    free: npt.NDArray[np.bool_]
    resolution: float
    origin: tuple[float, float]

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """The row and column of a point of the map's frame, m."""
        return int((y - self.origin[1]) // self.resolution), int((x - self.origin[0]) // self.resolution)

    def open_floor(self, radius: float = RADIUS) -> npt.NDArray[np.int32]:
        """Free cells that are not inscribed, numbered by the stretch of floor they belong to; 0 elsewhere.

        Nav2 marks a cell as inscribed if its centre is at most the radius from an occupied cell's centre.
        """
        distance = ndimage.distance_transform_edt(~self.occupied) * self.resolution
        return np.asarray(ndimage.label(self.free & (distance > radius + 1e-9))[0], dtype=np.int32)


def read_map(files: Mapping[str, bytes], name: str = "map.yaml") -> GridMap:
    """A map as `trinary` mode reads it."""
    said = yaml.load(files[name], yaml.CSafeLoader)
    assert said["mode"] == "trinary" and said["negate"] == 0
    grey = np.asarray(Image.open(io.BytesIO(files[said["image"]])), dtype=np.float64)[::-1]
    probability = (255 - grey) / 255
    x, y, turn = said["origin"]
    assert turn == 0
    return GridMap(probability > said["occupied_thresh"], probability < said["free_thresh"], said["resolution"], (x, y))


def parted_rooms(files: Mapping[str, bytes], radius: float = RADIUS) -> list[str]:
    """The rooms whose point a robot cannot drive to from the house's largest stretch of open floor."""
    rooms: list[dict[str, Any]] = json.loads(files["rooms.json"])["rooms"]
    grid = read_map(files)
    floor = grid.open_floor(radius)
    largest = int(np.bincount(floor[floor > 0]).argmax())
    return [room["id"] for room in rooms if room["point"] is None or floor[grid.cell(*room["point"])] != largest]
