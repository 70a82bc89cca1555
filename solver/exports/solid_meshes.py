"""The surfaces of parts as triangles, for formats that know no cylinders.

Soft edges and round ends keep their size in metres, whatever box they are written for; facets of a round form are 22.5 degrees.
"""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import product
from operator import ne
from typing import Any, Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catalogs.shapes import Axis, Form
from solver.body_parts import BodyPart
from solver.exports.model import Point

AROUND: Final = 16
"""How many facets go round a cylinder."""
ROUNDING: Final = 0.035
"""The radius of a soft edge, m; never more than ROUNDING_SHARE of its block's thinnest side."""
ROUNDING_SHARE: Final = 0.42
Points = NDArray[Any]
BoxFace = tuple[Axis, Literal[1, -1]]
"""A face of a box: the axis it lies across, and towards which end."""
_TURNED: Final[dict[Axis, tuple[int, int, int]]] = {"x": (1, 0, 2), "y": (0, 1, 2), "z": (0, 2, 1)}
"""Which coordinate of a form that stands along y becomes x, y and z when it lies along an axis."""


class SolidSurface(NamedTuple):
    """Triangles: vertices, their outward normals (both n x 3) and three of their numbers each, counter-clockwise seen from outside."""

    points: Points
    normals: Points
    triangles: NDArray[Any]


def surface_of(part: BodyPart) -> SolidSurface:
    """Returns the surface of a part, m, in its body's frame."""
    width, height, depth = part.size
    lying = _TURNED[part.axis]
    size = np.array(part.size)[list(lying)]
    if part.form == "rounded":
        made = _block(size, min(ROUNDING, ROUNDING_SHARE * min(width, height, depth)))
    elif part.form == "capsule":
        made = _capsule(size)
    else:
        made = _stretched(_unit(part.form, part.taper), size)
    if part.axis != "y":  # two coordinates change places: a mirror image, whose triangles run the other way round
        made = SolidSurface(made.points[:, lying], made.normals[:, lying], made.triangles[:, ::-1])
    return SolidSurface(made.points + part.at, made.normals, made.triangles)


def joined(surfaces: Iterable[SolidSurface]) -> SolidSurface:
    """Returns several surfaces as one."""
    parts = list(surfaces)
    starts = np.cumsum([0, *(len(part.points) for part in parts)])
    triangles = [part.triangles + start for part, start in zip(parts, starts, strict=False)]
    points, normals = ([part[i] for part in parts] for i in (0, 1))
    return SolidSurface(np.concatenate(points), np.concatenate(normals), np.concatenate(triangles))


def box_faces(size: Point, at: Point, faces: Iterable[BoxFace]) -> SolidSurface:
    """Returns some faces of a box around a point, m."""
    points, normals = _faces(np.array(size), 0.0)
    first = [4 * (2 * "xyz".index(axis) + (towards > 0)) for axis, towards in faces]
    rows = np.add.outer(first, range(4)).reshape(-1)
    triangles = np.concatenate([_SHARP[start // 2 : start // 2 + 2] - start + 4 * number for number, start in enumerate(first)])
    return SolidSurface(points[rows] + at, normals[rows], triangles)


def scaled(surface: SolidSurface, by: Sequence[float]) -> SolidSurface:
    """Returns a surface stretched along x, y and z, its normals upright on it again."""
    return _stretched(surface, np.array(by))


def _stretched(surface: SolidSurface, by: Points) -> SolidSurface:
    normals = surface.normals / by
    return SolidSurface(surface.points * by, normals / np.linalg.norm(normals, axis=1, keepdims=True), surface.triangles)


@lru_cache(maxsize=256)
def _unit(form: Form, taper: float) -> SolidSurface:
    """Returns a form of size 1 around the origin, along y."""
    if form == "ball":
        return _ball()
    if form in ("cylinder", "cone"):
        return _tube(0.0 if form == "cone" else taper)
    return _block(np.ones(3), 0.0)


def _block(size: Points, rounding: float) -> SolidSurface:
    """Returns a box; its edges are flat bevels with the normals of a round edge, so that four vertices a face will do."""
    points, normals = _faces(size, rounding)
    return SolidSurface(points, normals, _BEVELLED if rounding else _SHARP)


def _faces(size: Points, rounding: float) -> tuple[Points, Points]:
    """Returns the vertices of a box's faces, and their normals."""
    corners = np.array([(u, v) for v in (-0.5, 0.5) for u in (-0.5, 0.5)])
    points, normals = np.zeros((3, 2, 4, 3)), np.zeros((3, 2, 4, 3))
    for axis in range(3):
        across = [(axis + 1) % 3, (axis + 2) % 3]
        for side, towards in enumerate((-0.5, 0.5)):
            points[axis, side][:, across] = corners * (size[across] - 2 * rounding)
            points[axis, side, :, axis] = towards * size[axis]
            normals[axis, side, :, axis] = 2 * towards
    return points.reshape(-1, 3), normals.reshape(-1, 3)


def _number(axis: int, signs: Sequence[int]) -> int:
    """Returns the number of the vertex of a block's face across an axis, at the corner with these signs (0 or 1 along x, y, z)."""
    return axis * 8 + signs[axis] * 4 + signs[(axis + 2) % 3] * 2 + signs[(axis + 1) % 3]


def _block_triangles(bevelled: bool) -> NDArray[Any]:
    """Returns the triangles of a block: two a face; with bevels two an edge and one a corner more."""
    corners = list(product((0, 1), repeat=3))
    faces = [range(start, start + 4) for start in range(0, 24, 4)]
    found = [triangle for a, b, c, d in faces for triangle in ((a, b, c), (b, d, c))]
    if bevelled:
        edges = [(one, other) for one in corners for other in corners if sum(other) == sum(one) + 1 and sum(map(ne, one, other)) == 1]
        for ends in edges:
            along = [a != b for a, b in zip(*ends, strict=True)].index(True)
            a, b, c, d = (_number((along + turn) % 3, end) for turn in (1, 2) for end in ends)
            found += [(a, b, c), (b, d, c)]
        found += [(_number(0, corner), _number(1, corner), _number(2, corner)) for corner in corners]
    points = (_faces(np.ones(3), 0.1)[0])[np.array(found)]
    outward = np.einsum("ij,ij->i", np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), points.sum(axis=1)) > 0
    return np.array([triangle if right else triangle[::-1] for triangle, right in zip(found, outward, strict=True)])


_SHARP: Final = _block_triangles(False)
_BEVELLED: Final = _block_triangles(True)


def _ring(around: int) -> Points:
    """Returns points on the unit circle around y, counter-clockwise seen from above."""
    turns = np.arange(around) * (2 * np.pi / around)
    return np.stack([np.sin(turns), np.zeros(around), np.cos(turns)], axis=1)


def _between(lower: int, upper: int, around: int) -> list[tuple[int, int, int]]:
    """Returns the triangles between two rings of vertices, by their first numbers."""
    found = []
    for i in range(around):
        j = (i + 1) % around
        found += [(lower + i, lower + j, upper + j), (lower + i, upper + j, upper + i)]
    return found


def _tube(taper: float) -> SolidSurface:
    """Returns a cylinder whose radius changes from its lower to its upper end, and its caps."""
    low, high = (1.0, taper) if taper <= 1 else (1 / taper, 1.0)
    ring = _ring(AROUND)
    lower, upper = ring * (low / 2) - (0, 0.5, 0), ring * (high / 2) + (0, 0.5, 0)
    slope = ring + np.array((0, (low - high) / 2, 0))
    slope /= np.linalg.norm(slope, axis=1, keepdims=True)
    points, normals, triangles = [lower, upper], [slope, slope], _between(0, AROUND, AROUND)
    if not high:
        triangles = triangles[::2]
    for rim, towards, radius in ((lower, -1, low), (upper, 1, high)):
        if radius:
            start = sum(map(len, points))
            points.append(rim)
            normals.append(np.tile((0.0, towards, 0.0), (AROUND, 1)))
            fan = [(start, start + i, start + i + 1) for i in range(1, AROUND - 1)]
            triangles += fan if towards > 0 else [(a, c, b) for a, b, c in fan]
    return SolidSurface(np.concatenate(points), np.concatenate(normals), np.array(triangles))


def _dome(rows: Sequence[float], around: int) -> tuple[Points, list[tuple[int, int, int]]]:
    """Returns unit normals at these heights (shares of a right angle from -1 to 1, poles at both ends), and triangles between them."""
    ring = _ring(around)
    inner = [ring * np.cos(rise * np.pi / 2) + (0, np.sin(rise * np.pi / 2), 0) for rise in rows[1:-1]]
    found = np.concatenate([[(0, -1, 0)], *inner, [(0, 1, 0)]])
    top = len(found) - 1
    triangles = [(0, 1 + (i + 1) % around, 1 + i) for i in range(around)]
    for row in range(len(inner) - 1):
        triangles += _between(1 + row * around, 1 + (row + 1) * around, around)
    last = top - around
    triangles += [(top, last + i, last + (i + 1) % around) for i in range(around)]
    return found, triangles


@lru_cache(maxsize=1)
def _ball() -> SolidSurface:
    normals, triangles = _dome([i / 4 - 1 for i in range(9)], AROUND)
    return SolidSurface(normals / 2, normals, np.array(triangles))


_CAPSULE: Final = _dome([-1, -2 / 3, -1 / 3, 0, 0, 1 / 3, 2 / 3, 1], AROUND)


def _capsule(size: Points) -> SolidSurface:
    """Returns a cylinder along y with round ends, elliptical where its width is not its depth."""
    normals, triangles = _CAPSULE
    radius = size.min() / 2
    towards = np.repeat([-1, 1], len(normals) // 2)
    radii = np.array([size[0] / 2, radius, size[2] / 2])
    points = normals * radii
    points[:, 1] += towards * (size[1] / 2 - radius)
    bent = normals / radii
    return SolidSurface(points, bent / np.linalg.norm(bent, axis=1, keepdims=True), np.array(triangles))
