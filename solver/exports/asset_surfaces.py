"""An own asset's file, read whole and checked: how it comes into a body's box, whom to name, its triangles for formats that take no glTF.

Points stand around the middle of the footprint at the underside, in the scene's frame and the file's own units, the front turned to +z. A
surface has all triangles of one material.
"""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catalogs.assets.asset_entry import FRONT_TURNS, Asset
from catalogs.assets.glb_file import GlbBook, GlbFault, PlacedMesh, bounds_of, read_glb
from solver.errors import RequestError
from solver.exports.model import Paint, Point

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


MeshNumbers = NDArray[Any]
_KINDS: Final = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_ENDINGS: Final = {"image/png": "png", "image/jpeg": "jpg"}
WHITE: Final = [1.0, 1.0, 1.0, 1.0]
SLACK: Final = 0.001
"""Points may lie outside what their file says of them by this share of the whole."""


class Picture(NamedTuple):
    """A picture that is laid over a surface: its content and the ending of its name."""

    content: bytes
    ending: str


class AssetSurface(NamedTuple):
    """Triangles of one material.

    Vertices and outward normals (both n x 3), places on the picture (n x 2, v upwards), and three numbers of vertices each (m x 3).
    """

    points: MeshNumbers
    normals: MeshNumbers
    places: MeshNumbers | None
    triangles: MeshNumbers
    paint: Paint
    picture: Picture | None


def surfaces_of(name: str, asset: Asset) -> list[AssetSurface]:
    """Reads an asset's triangles.

    Raises:
        RequestError: its file is not what was measured, or its points are not where it says.
    """
    file = asset_file(name, asset)
    try:
        found: dict[int, list[AssetSurface]] = {}
        for placed in file.book.meshes():
            for material, surface in _of_mesh(file, placed):
                found.setdefault(material, []).append(surface)
        turned = [_turned(_joined(parts), asset) for _, parts in sorted(found.items())]
        _check(turned, asset)
    except (GlbFault, TypeError, AttributeError, KeyError, ValueError, IndexError) as fault:
        raise changed(name, str(fault)) from None
    return turned


def _check(surfaces: list[AssetSurface], asset: Asset) -> None:
    slack = SLACK * max(high - low for low, high in zip(asset.low, asset.high, strict=True))
    stretch = fit_of(asset, (1.0, 1.0, 1.0)).stretch
    width, depth, height = 1 / stretch[0], 1 / stretch[2], 1 / stretch[1]
    for surface in surfaces:
        low, high = surface.points.min(axis=0), surface.points.max(axis=0)
        inside = (low >= (-width / 2 - slack, -slack, -depth / 2 - slack)).all() and (
            high <= (width / 2 + slack, height + slack, depth / 2 + slack)
        ).all()
        if not (np.isfinite(surface.points).all() and inside):
            raise GlbFault("has points that are not where it says")


def _of_mesh(file: AssetFile, placed: PlacedMesh) -> list[tuple[int, AssetSurface]]:
    matrix = np.array(placed.place, dtype=float).reshape(3, 4)
    found = []
    for primitive in file.book.item("meshes", placed.mesh)["primitives"]:
        mode = primitive.get("mode", 4)
        if mode < 4:
            continue
        attributes = primitive["attributes"]
        points = _numbers(file, attributes["POSITION"])
        count = len(points)
        corners = _numbers(file, primitive["indices"], False).reshape(-1).astype(np.int64) if "indices" in primitive else np.arange(count)
        if len(corners) and corners.max() >= count:
            raise GlbFault("has triangles of points that are not there")
        triangles = _triangles(corners, mode)
        if np.linalg.det(matrix[:, :3]) < 0:
            triangles = triangles[:, ::-1]
        normals = _numbers(file, attributes["NORMAL"]) if "NORMAL" in attributes else _normals(points, triangles)
        paint, picture = _look(file, primitive.get("material"))
        places = _numbers(file, attributes["TEXCOORD_0"]) * (1, -1) + (0, 1) if picture and "TEXCOORD_0" in attributes else None
        across = np.linalg.pinv(matrix[:, :3])  # normals go by the inverse, transposed
        moved = points @ matrix[:, :3].T + matrix[:, 3]
        surface = AssetSurface(moved, normals @ across, places, triangles, paint, picture if places is not None else None)
        found.append((primitive.get("material", -1), surface))
    return found


def _numbers(file: AssetFile, number: int, scaled: bool = True) -> MeshNumbers:
    """Returns the content of an accessor, which was checked; whole numbers that stand for shares as such where `scaled`."""
    count, accessor = file.book.accessor(number), file.book.item("accessors", number)
    view = file.book.item("bufferViews", accessor["bufferView"])
    kind, width = np.dtype(_KINDS[accessor["componentType"]]), _WIDTHS[accessor["type"]]
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    step = view.get("byteStride", 0) or kind.itemsize * width
    values: MeshNumbers = np.ndarray((count, width), kind, file.content, start, (step, kind.itemsize))
    if not scaled:
        return values
    share = np.iinfo(kind).max if kind.kind != "f" and accessor.get("normalized") else 1.0
    return np.maximum(values.astype(float) / share, -1.0) if share != 1.0 else values.astype(float)


def _triangles(corners: MeshNumbers, mode: int) -> MeshNumbers:
    if mode == 4:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    if mode == 6:
        return np.stack([np.full(max(0, len(corners) - 2), corners[0]), corners[1:-1], corners[2:]], axis=1)
    strip = np.stack([corners[:-2], corners[1:-1], corners[2:]], axis=1)
    strip[1::2] = strip[1::2, [1, 0, 2]]
    return strip


def _normals(points: MeshNumbers, triangles: MeshNumbers) -> MeshNumbers:
    """Returns normals of vertices, those of their triangles by area."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, triangles[:, k], np.cross(b - a, c - a))
    return normals


def _look(file: AssetFile, material: int | None) -> tuple[Paint, Picture | None]:
    """Returns the paint of a material, and its picture."""
    entry: Mapping[str, Any] = {} if material is None else file.book.item("materials", material)
    look = entry.get("pbrMetallicRoughness", {})
    red, green, blue, opacity = (min(1.0, max(0.0, float(value))) for value in look.get("baseColorFactor", WHITE))
    color = "#" + "".join(f"{round(255 * _srgb(value)):02x}" for value in (red, green, blue))
    clear = entry.get("alphaMode") == "BLEND"
    shares = (min(1.0, max(0.0, float(look.get(key, 1.0)))) for key in ("roughnessFactor", "metallicFactor"))
    roughness, metalness = shares
    paint = Paint(color, round(roughness, 3), round(metalness, 3), round(max(opacity, 0.01), 3) if clear else 1.0)
    return paint, _picture(file, look["baseColorTexture"]["index"]) if "baseColorTexture" in look else None


def _srgb(value: float) -> float:
    return 12.92 * value if value <= 0.0031308 else 1.055 * math.pow(value, 1 / 2.4) - 0.055


def _picture(file: AssetFile, texture: int) -> Picture | None:
    image = file.book.item("images", file.book.item("textures", texture)["source"])
    view = file.book.item("bufferViews", image["bufferView"])
    ending = _ENDINGS.get(image.get("mimeType", ""))
    start = view.get("byteOffset", 0)
    return Picture(file.content[start : start + view["byteLength"]], ending) if ending else None


def _joined(parts: list[AssetSurface]) -> AssetSurface:
    """Returns surfaces of one material as one; places on a picture only if all have them."""
    starts = np.cumsum([0, *(len(part.points) for part in parts)])
    triangles = np.concatenate([part.triangles + start for part, start in zip(parts, starts, strict=False)])
    placed = [part.places for part in parts if part.places is not None]
    places = np.concatenate(placed) if len(placed) == len(parts) else None
    points, normals = (np.concatenate([part[i] for part in parts]) for i in (0, 1))
    return AssetSurface(points, normals, places, triangles, parts[0].paint, parts[0].picture if places is not None else None)


def _turned(surface: AssetSurface, asset: Asset) -> AssetSurface:
    fit = fit_of(asset, (1.0, 1.0, 1.0))
    cos, sin = round(math.cos(math.radians(fit.turn))), round(math.sin(math.radians(fit.turn)))
    turn = np.array([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]])
    lengths = np.linalg.norm(surface.normals, axis=1, keepdims=True)
    normals = np.where(lengths > 0, surface.normals / np.where(lengths > 0, lengths, 1.0), (0.0, 1.0, 0.0)) @ turn.T
    return surface._replace(points=surface.points @ turn.T + fit.shift, normals=normals)


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
