"""A coloured picture of a storey from above: floors with their joints, things in their paints, soft light from the north-west.

Shapes are flat, cut below the lintels, and drawn twice, larger than the picture: their colours, and their heights. Light is calculated from
the heights.
"""

import io
import math
from collections.abc import Iterator, Sequence
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw
from scipy.ndimage import uniform_filter

from solver.body_parts import BodyPart
from solver.exports.model import Cuboid, DoorLeaf, FloorPlate, HouseModel, Paint
from solver.exports.paints import channels, shade

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
_STRIP: Final = 64
"""How many rows or columns are lit at once: few enough that the processor's cache holds them."""
Heights = npt.NDArray[np.float32]


class _Canvas(NamedTuple):
    """A picture of colours and one of heights, both of `scale` pixels a metre, over the plan from `x`, `z`."""

    colors: Image.Image
    heights: Image.Image
    scale: float
    x: float
    z: float

    def pixels(self, corners: "Corners") -> list[tuple[float, float]]:
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
    colors *= _light(heights, scale)[:, :, None]
    content = io.BytesIO()
    Image.fromarray(np.clip(colors, 0, 255, out=colors).astype(np.uint8)).save(content, "PNG")
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
    """Returns each pixel's colour. Rows that are alike, those of a board or a tile, are painted once."""
    texture = room.paint.texture or ""
    rows, columns = np.arange(shape[0])[:, None] / scale, np.arange(shape[1])[None, :] / scale
    across, along = _JOINTS.get(texture, (None, None))
    grain, joint = (along, 0.012) if along else (across, 0.008) if across else (0.02, 0.0)
    counted = np.column_stack((np.floor(rows / grain), rows % grain < joint))
    first = np.flatnonzero(np.any(np.diff(counted, axis=0, prepend=-1.0), axis=1))
    often, rows = np.diff(first, append=shape[0]), rows[first]
    light = np.ones((len(rows), shape[1]), dtype=np.float32)
    if across and along:
        tile = np.floor(rows / along) * 7919 + np.floor(columns / across) * 104729
        light += 0.035 * (_noise(tile) - 0.5)
        light[((rows % along) < joint) | ((columns % across) < joint)] *= 0.9
    elif across:
        board = np.floor(rows / across)
        shifted = columns + 1.3 * _noise(board * 31.0)
        length = np.floor(shifted / 1.6)
        light += 0.11 * (_noise(board * 7919.0 + length * 104729.0) - 0.5)
        light[((rows % across) < joint) | ((shifted % 1.6) < joint)] *= 0.86
    else:
        strength = 0.16 if texture == "grass" else 0.04
        light += strength * (_noise(np.floor(rows / grain) * 7919.0 + np.floor(columns / grain) * 104729.0) - 0.5)
    color = np.array(channels(shade(room.paint.color, 0.12)), dtype=np.float32)
    painted: npt.NDArray[np.uint8] = np.clip(color * light[:, :, None], 0, 255).astype(np.uint8)
    return np.repeat(painted, often, axis=0)


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


def _light(heights: Heights, scale: float) -> Heights:
    """Returns each pixel's share of light: less where higher things are around it or stand in the sun."""
    open_sky = np.ones_like(heights)
    for reach, weight in ((0.05, 0.3), (0.15, 0.3), (0.45, 0.25)):
        above = _blurred(heights, reach * scale)
        above -= heights
        above /= reach * 2.5
        open_sky -= np.multiply(np.clip(above, 0.0, 1.0, out=above), weight, out=above)
    shade_left = _blurred(_shadow(heights, scale).astype(np.float32), 0.02 * scale)
    shade_left *= _SHADOW
    light = np.maximum(open_sky, _OPEN, out=open_sky)
    light *= np.subtract(1.0, shade_left, out=shade_left)
    light *= 1.04
    return light


def _shadow(heights: Heights, scale: float) -> npt.NDArray[np.bool_]:
    """Returns which pixels something to their north-west hides from the sun."""
    east, south, longest = _SUN
    rows, columns = heights.shape
    shadow = np.zeros(heights.shape, dtype=np.bool_)
    steps = max(1, round(longest * scale / 3))
    reached = [longest * step / steps for step in range(1, steps + 1)]
    falls = [(height, round(east * height * scale), round(south * height * scale)) for height in reached]
    for top in range(0, rows, _STRIP):
        end = min(top + _STRIP, rows)
        for height, right, down in falls:
            start = max(top, down)
            if (right or down) and right < columns and start < end:
                cast = heights[start - down : end - down, : columns - right] - heights[start:end, right:]
                shadow[start:end, right:] |= cast > height
    return shadow


def _blurred(values: Heights, radius: float) -> Heights:
    """Returns values, each the mean of those around it: two box blurs, edges repeated."""
    width = 2 * max(1, round(radius)) + 1
    for _ in range(2):
        values = uniform_filter(values, width, mode="nearest")
    return values


CUT: Final = 2.05
"""What begins higher above the floor is taken away: the walls over doors and windows, ceiling lamps, m."""
WALL_TOP: Final = "#5b5650"
"""The colour of cut walls."""
_AROUND: Final = 20
_DOME: Final = ((1.0, -0.22), (0.86, -0.1), (0.68, 0.0), (0.46, 0.08), (0.24, 0.14))
"""Rings of what is round above: share of its extents, and how much lighter or darker they are."""
_BEVEL: Final = 0.03
Corners = tuple[tuple[float, float], ...]


class SeenShape(NamedTuple):
    """A polygon in the house (x, z), m; its height above the storey's floor, m; an sRGB colour; how much hides what is below, 0 to 1."""

    corners: Corners
    height: float
    color: str
    opacity: float = 1.0


class _Pose(NamedTuple):
    """Where a thing's own origin is in the house, and its turn about +y, degrees."""

    x: float
    y: float
    z: float
    turn: float


def shapes_from_above(model: HouseModel, level: int) -> list[SeenShape]:
    """Returns what stands on a level's floors, doors open, garage doors shut; the floors themselves are left out."""
    floor = next((room.elevation for room in model.rooms if room.level == level), 0.0)
    levels = {room.id: room.level for room in model.rooms}
    found: list[SeenShape] = []
    for wall in model.walls:
        found += _box(wall.box, Paint(WALL_TOP), floor)
    for fitting in model.fittings:
        found += _box(fitting.box, fitting.paint, floor)
    for leaf in model.leaves:
        found += _leaf(leaf, floor)
    for body in model.bodies:
        if levels.get(body.room or "") == level:
            pose = _Pose(body.x, body.y - floor, body.z, body.turn)
            found += _parts(body.parts, body.paints, pose)
    return sorted((one for one in found if one.height > 0.0), key=lambda one: one.height)


def _box(box: Cuboid, paint: Paint, floor: float) -> Iterator[SeenShape]:
    if box.y0 - floor + 0.05 >= 0.0 and box.y0 - floor < CUT:
        corners = ((box.x0, box.z0), (box.x1, box.z0), (box.x1, box.z1), (box.x0, box.z1))
        yield SeenShape(corners, min(box.y1 - floor, CUT), paint.color, paint.opacity)


def _leaf(leaf: DoorLeaf, floor: float) -> Iterator[SeenShape]:
    """Yields the parts of a leaf, turned open about its hinge."""
    above = leaf.hinge[1] - floor
    if 0.0 <= above < CUT:
        x, z = leaf.middle(leaf.wide_open)
        yield from _parts(leaf.parts, leaf.paints, _Pose(x, above, z, leaf.wide_open))


def _parts(parts: Sequence[BodyPart], paints: Sequence[Paint], pose: _Pose) -> Iterator[SeenShape]:
    for part, paint in zip(parts, paints, strict=True):
        low, high = pose.y + part.at[1] - part.size[1] / 2, pose.y + part.at[1] + part.size[1] / 2
        if low < CUT:
            yield from _part(part, paint, pose, min(high, CUT))


def _part(part: BodyPart, paint: Paint, pose: _Pose, top: float) -> Iterator[SeenShape]:
    """Yields a part's outline; what is round or soft above as rings, each a little lighter than the one around it."""
    width, height, depth = part.size
    at = part.at[0], part.at[2]

    def shape(corners: Corners, lighter: float = 0.0, below: float = 0.0) -> SeenShape:
        color = shade(paint.color, lighter) if lighter else paint.color
        return SeenShape(_turned(corners, at, pose), top - below, color, paint.opacity)

    if part.form in ("ball", "capsule") or (part.form == "cone" and part.axis == "y"):
        for share, lighter in _DOME:
            below = height * share if part.form == "cone" else height / 2 * (1.0 - math.sqrt(1.0 - share**2))
            yield shape(_oval(width * share / 2, depth * share / 2), lighter, below)
    elif part.form in ("cylinder", "cone") and part.axis == "y":
        yield shape(_oval(width / 2, depth / 2))
    elif part.form == "cylinder":
        yield from (shape(_lying(part, share), lighter, height / 2 * (1.0 - math.sqrt(1.0 - share**2))) for share, lighter in _DOME)
    elif part.form == "rounded":
        inset = min(_BEVEL, 0.25 * width, 0.25 * depth)
        yield shape(_rectangle(width / 2, depth / 2), -0.12, min(inset, height) / 2)
        yield shape(_rectangle(width / 2 - inset / 2, depth / 2 - inset / 2), -0.05, min(inset, height) / 6)
        yield shape(_rectangle(width / 2 - inset, depth / 2 - inset))
    else:
        yield shape(_rectangle(width / 2, depth / 2))


def _rectangle(x: float, z: float) -> Corners:
    return (-x, -z), (x, -z), (x, z), (-x, z)


def _oval(x: float, z: float) -> Corners:
    return tuple((x * math.cos(turn), z * math.sin(turn)) for turn in (2 * math.pi * n / _AROUND for n in range(_AROUND)))


def _lying(part: BodyPart, share: float) -> Corners:
    """Returns a share of a lying cylinder's outline: as long, but less across."""
    x, z = part.size[0] / 2, part.size[2] / 2
    return _rectangle(x, z * share) if part.axis == "x" else _rectangle(x * share, z)


def _turned(corners: Corners, at: tuple[float, float], pose: _Pose) -> Corners:
    """Returns corners, moved by `at` in the thing's own frame, in the house."""
    turn = math.radians(pose.turn)
    sine, cosine = math.sin(turn), math.cos(turn)
    moved = [(x + at[0], z + at[1]) for x, z in corners]
    return tuple((pose.x + cosine * x + sine * z, pose.z - sine * x + cosine * z) for x, z in moved)
