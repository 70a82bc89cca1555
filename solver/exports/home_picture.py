"""A coloured picture of a storey from above: floors with their joints, things in their paints, soft light from the north-west.

Shapes are drawn twice, larger than the picture: their colours, and their heights. Light is calculated from the heights.
"""

from __future__ import annotations

import io
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw

from solver.exports.model import FloorPlate, HouseModel
from solver.exports.paints import channels, shade
from solver.exports.seen_from_above import Corners, shapes_from_above

LONG_SIDE: Final = 1600
"""Pixels of a picture's longer side."""
SAMPLES: Final = 2
"""How many times larger shapes are drawn, so that edges are soft."""
MARGIN: Final = 1.0
"""How far a picture goes beyond the rooms, m."""
PAPER: Final = "#f4f1ec"
_OPEN: Final = 0.45
"""Share of light where the sky is hidden all round."""
_SHADOW: Final = 0.24
"""Share of light that a full shadow takes away."""
_SUN: Final = (0.55, 0.65, 0.75)
"""How far a shadow falls east and south for each metre that something is high, and the height, m, that casts the longest."""
_TALL: Final = 1.2
"""What is higher gives no more shade than this, m: walls would darken their rooms."""
_JOINTS: Final = {"wood": (0.16, None), "deck": (0.14, None), "tile": (0.4, 0.4), "stone": (0.6, 0.6)}
"""How far apart the joints of a flooring are, across and along its boards, m."""
Heights = npt.NDArray[np.float32]


class _Canvas(NamedTuple):
    """A picture of colours and one of heights, both of `scale` pixels a metre, over the plan from `x`, `z`."""

    colors: Image.Image
    heights: Image.Image
    scale: float
    x: float
    z: float

    def pixels(self, corners: Corners) -> list[tuple[float, float]]:
        """Returns corners of the plan as the canvas counts them."""
        return [((x - self.x) * self.scale - 0.5, (z - self.z) * self.scale - 0.5) for x, z in corners]


def picture_of(model: HouseModel, level: int) -> bytes:
    """Returns a level's picture, north at the top."""
    rooms = [room for room in model.rooms if room.level == level]
    corners = [corner for room in rooms for corner in room.corners] or [(0.0, 0.0)]
    (west, east), (north, south) = ((min(at) - MARGIN, max(at) + MARGIN) for at in zip(*corners, strict=True))
    scale = LONG_SIDE / max(east - west, south - north)
    size = max(1, round((east - west) * scale)), max(1, round((south - north) * scale))
    large = size[0] * SAMPLES, size[1] * SAMPLES
    canvas = _Canvas(Image.new("RGB", large, PAPER), Image.new("F", large, 0.0), scale * SAMPLES, west, north)
    for room in rooms:
        _draw_floor(canvas, room)
    _draw_shapes(canvas, model, level)
    colors = np.asarray(canvas.colors.reduce(SAMPLES), dtype=np.float32)
    # The lowest of a pixel's samples: else a high edge's pixel would keep the light and the colour of what lies beside it.
    samples = np.asarray(canvas.heights, dtype=np.float32)
    heights = np.full((size[1], size[0]), _TALL, dtype=np.float32)
    for row, column in np.ndindex(SAMPLES, SAMPLES):
        np.minimum(heights, samples[row::SAMPLES, column::SAMPLES], out=heights)
    lit = np.clip(colors * _light(heights, scale)[:, :, None], 0, 255).astype(np.uint8)
    content = io.BytesIO()
    Image.fromarray(lit).save(content, "PNG")
    return content.getvalue()


def _draw_floor(canvas: _Canvas, room: FloorPlate) -> None:
    """Draws a room's floor: boards staggered, tiles in a grid, grass and stone uneven."""
    outline = canvas.pixels(room.corners)
    left, top = (int(min(at)) for at in zip(*outline, strict=True))
    right, bottom = (int(max(at)) + 2 for at in zip(*outline, strict=True))
    inside = Image.new("L", (right - left, bottom - top), 0)
    ImageDraw.Draw(inside).polygon([(x - left, y - top) for x, y in outline], fill=255)
    canvas.colors.paste(Image.fromarray(_floor_colors(room, (bottom - top, right - left), canvas.scale)), (left, top), inside)


def _floor_colors(room: FloorPlate, shape: tuple[int, int], scale: float) -> npt.NDArray[np.uint8]:
    texture = room.paint.texture or ""
    rows, columns = np.arange(shape[0])[:, None] / scale, np.arange(shape[1])[None, :] / scale
    light = np.ones(shape, dtype=np.float32)
    across, along = _JOINTS.get(texture, (None, None))
    if across and along:
        tile = np.floor(rows / along) * 7919 + np.floor(columns / across) * 104729
        light += 0.035 * (_noise(tile) - 0.5)
        light[((rows % along) < 0.012) | ((columns % across) < 0.012)] *= 0.9
    elif across:
        board = np.floor(rows / across)
        shifted = columns + 1.3 * _noise(board * 31.0)
        length = np.floor(shifted / 1.6)
        light += 0.11 * (_noise(board * 7919.0 + length * 104729.0) - 0.5)
        light[((rows % across) < 0.008) | ((shifted % 1.6) < 0.008)] *= 0.86
    else:
        grain = 0.16 if texture == "grass" else 0.04
        light += grain * (_noise(np.floor(rows / 0.02) * 7919.0 + np.floor(columns / 0.02) * 104729.0) - 0.5)
    color = np.array(channels(shade(room.paint.color, 0.12)), dtype=np.float32)
    painted: npt.NDArray[np.uint8] = np.clip(color * light[:, :, None], 0, 255).astype(np.uint8)
    return painted


def _noise(numbers: npt.NDArray[Any]) -> npt.NDArray[np.float64]:
    """Returns a share from 0 to 1 for each number, the same for the same number."""
    found: npt.NDArray[np.float64] = np.modf(np.abs(np.sin(numbers * 12.9898) * 43758.5453))[0]
    return found


def _draw_shapes(canvas: _Canvas, model: HouseModel, level: int) -> None:
    colors, heights = ImageDraw.Draw(canvas.colors), ImageDraw.Draw(canvas.heights)
    for shape in shapes_from_above(model, level):
        outline = canvas.pixels(shape.corners)
        if shape.opacity >= 1.0:
            colors.polygon(outline, fill=shape.color)
            heights.polygon(outline, fill=shape.height)
            continue
        box = [int(pick(at)) + more for pick, more in ((min, 0), (max, 2)) for at in zip(*outline, strict=True)]
        inside = Image.new("L", (max(1, box[2] - box[0]), max(1, box[3] - box[1])), 0)
        ImageDraw.Draw(inside).polygon([(x - box[0], y - box[1]) for x, y in outline], fill=round(255 * shape.opacity))
        canvas.colors.paste(Image.new("RGB", inside.size, shape.color), (box[0], box[1]), inside)


def _light(heights: Heights, scale: float) -> npt.NDArray[np.float32]:
    """Returns each pixel's share of light: less where higher things are around it or stand in the sun."""
    open_sky = np.ones_like(heights)
    for reach, weight in ((0.05, 0.3), (0.15, 0.3), (0.45, 0.25)):
        above = np.maximum(_blurred(heights, reach * scale) - heights, 0.0)
        open_sky -= weight * np.minimum(above / (reach * 2.5), 1.0)
    east, south, longest = _SUN
    shadow = np.zeros(heights.shape, dtype=np.bool_)
    steps = max(1, round(longest * scale / 3))
    for step in range(1, steps + 1):
        height = longest * step / steps
        right, down = round(east * height * scale), round(south * height * scale)
        if not (right or down) or right >= heights.shape[1] or down >= heights.shape[0]:
            continue
        shadow[down:, right:] |= heights[: heights.shape[0] - down, : heights.shape[1] - right] - heights[down:, right:] > height
    soft = _blurred(shadow.astype(np.float32), 0.02 * scale)
    light: npt.NDArray[np.float32] = np.maximum(open_sky, _OPEN) * (1.0 - _SHADOW * soft) * 1.04
    return light


def _blurred(values: Heights, radius: float) -> Heights:
    """Returns values, each the mean of those around it: two box blurs, edges repeated."""
    width = max(1, round(radius))
    for axis in (0, 1, 0, 1):
        padded = np.pad(values, [(width, width) if axis == at else (0, 0) for at in (0, 1)], mode="edge")
        sums = _summed(padded, 2 * width + 1) if axis == 0 else _summed(padded.T, 2 * width + 1).T
        values = sums / np.float32(2 * width + 1)
    return values


def _summed(rows: Heights, count: int) -> Heights:
    """Returns the sum of each so many rows that follow each other: that of half as many, twice."""
    if count == 1:
        return rows
    half = _summed(rows, count // 2)
    even = half[: len(half) - count // 2] + half[count // 2 :]
    return even if count % 2 == 0 else even[:-1] + rows[count - 1 :]
