"""Which bodies of a scene cross as shapes: floats, and no code of the solver's or the validator's.

Every form of the catalogs is convex, so how deep two parts are in each other is the least overlap of their extents over all
directions. It is looked for among the parts' own axes and many directions, then around the best of them: what is found is
never less than the true depth.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from catalogs import Catalogs
from catalogs.shapes import Solid
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene

Array = NDArray[np.float64]
DEPTH = 0.002
"""Shapes that are no deeper in each other than this only touch, m."""
RUG = 0.02
"""What lies on the floor and is no higher is stood on, m."""


def _sphere(count: int) -> Array:
    """Returns directions spread evenly over the sphere, unit vectors (count, 3)."""
    at = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * at / count), np.pi * (1 + 5**0.5) * at
    return np.stack([np.cos(turn) * np.sin(polar), np.cos(polar), np.sin(turn) * np.sin(polar)], axis=1)


def _flat(count: int) -> Array:
    """Returns horizontal directions, unit vectors (count, 3)."""
    turn = np.arange(count) * 2 * np.pi / count
    return np.stack([np.cos(turn), np.zeros(count), np.sin(turn)], axis=1)


DIRECTIONS = np.concatenate([np.eye(3), -np.eye(3), _flat(72), _sphere(400)])


@dataclass(frozen=True)
class Convex:
    """A part at its place: its centre (3,), half its extents (3,), m, its form, and the body's axes as rows of `frame`."""

    form: str
    axis: int
    taper: float
    centre: Array
    half: Array
    frame: Array

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Its lowest and highest corner."""
        reach = np.abs(self.frame.T) @ self.half
        return self.centre - reach, self.centre + reach

    def reach(self, directions: Array) -> Array:
        """Returns how far it reaches in each direction (n, 3) from the origin, m."""
        local = (directions @ self.frame.T) * self.half
        middle = directions @ self.centre
        if self.form in ("box", "rounded"):
            return middle + np.abs(local).sum(axis=1)
        if self.form == "ball":
            return middle + np.linalg.norm(local, axis=1)
        along = local[:, self.axis]
        round_ = np.delete(local, self.axis, axis=1)
        if self.form == "capsule":
            others = np.delete(self.half, self.axis)
            radius = min(float(others.max()), float(self.half[self.axis]))
            cap = radius / self.half[self.axis]
            ends = np.abs(along) * (1 - cap)
            return middle + ends + np.sqrt((along * cap) ** 2 + (round_**2).sum(axis=1))
        wide = np.linalg.norm(round_, axis=1)
        near, far = (1 / self.taper, 1.0) if self.taper > 1 else (1.0, self.taper)
        return middle + np.maximum(wide * near - along, wide * far + along)


def depth(one: Convex, other: Convex) -> float:
    """Returns how deep two parts are in each other, m; not above 0 where they are apart."""
    tried = np.concatenate([DIRECTIONS, one.frame, -one.frame, other.frame, -other.frame, _towards(one, other)])
    least, spread = np.inf, 0.2
    for _ in range(6):
        found = one.reach(tried) + other.reach(-tried)
        best = tried[int(np.argmin(found))]
        least = min(least, float(found.min()))
        if least <= DEPTH:
            return least
        tried = best + spread * DIRECTIONS
        tried /= np.linalg.norm(tried, axis=1, keepdims=True)
        spread /= 3
    return least


def _towards(one: Convex, other: Convex) -> Array:
    way = other.centre - one.centre
    length = float(np.linalg.norm(way))
    return (np.stack([way, -way]) / length) if length > 1e-9 else np.eye(3)[:1]


Body = Furniture | Decoration | Dynamic


def kind_of(body: Body, catalogs: Catalogs) -> str | None:
    """Returns the shape that a body has: that of the kind of its name which is nearest in size; None: it is its box."""
    if isinstance(body, Dynamic):
        name = f"{body.kind}_seated" if body.on is not None else body.kind
        return name if name in catalogs.shapes else None
    entries = catalogs.furniture if isinstance(body, Furniture) else catalogs.decorations
    near: list[tuple[float, str]] = []
    for kind, entry in entries.items():
        if catalogs.name_of(kind) != body.name or kind not in catalogs.shapes:
            continue
        sizes = {kind: entry.size, f"{kind}_upright": (entry.size[0], entry.size[2], entry.size[1])}
        own = (body.width, body.depth, body.height)
        near += [(sum(abs(a - b) for a, b in zip(own, size, strict=True)), key) for key, size in sizes.items() if key in catalogs.shapes]
    return min(near, key=lambda found: found[0])[1] if near else None


def parts_of(body: Body, catalogs: Catalogs) -> list[Convex]:
    """Returns the parts of a body in its room."""
    kind = kind_of(body, catalogs)
    whole = Solid(form="box", x=(0, 1), y=(0, 1), z=(0, 1), axis="y", taper=1, material="body")
    turn = np.radians(body.rotation)
    frame = np.array([[np.cos(turn), 0, -np.sin(turn)], [0, 1, 0], [np.sin(turn), 0, np.cos(turn)]])
    size = np.array([body.width, body.height, body.depth])
    foot = np.array([body.x, body.y, body.z])
    found = []
    for solid in catalogs.shapes[kind] if kind else (whole,):
        low, high = (np.array([getattr(solid, axis)[end] for axis in "xyz"]) for end in (0, 1))
        middle = (low + high) / 2 - np.array([0.5, 0, 0.5])
        found.append(
            Convex(solid.form, "xyz".index(solid.axis), solid.taper, foot + (middle * size) @ frame, (high - low) / 2 * size, frame)
        )
    return found


def crossings(scene: Scene, catalogs: Catalogs) -> Iterator[tuple[str, str, float]]:
    """Yields the pairs of bodies of one room whose shapes cross, and how deep, m."""
    for room in scene.rooms:
        inside = [one for one in scene.dynamic if one.room == room.id]
        yield from _in_room(room, inside, catalogs)


def _in_room(room: Room, people: list[Dynamic], catalogs: Catalogs) -> Iterator[tuple[str, str, float]]:
    bodies: list[Body] = [*room.furniture, *room.decorations, *people]
    kept = [body for body in bodies if body.y > 0 or body.height > RUG]
    solid = [parts_of(body, catalogs) for body in kept]
    corners = [[part.bounds for part in parts] for parts in solid]
    low = np.array([np.min([one[0] for one in found], axis=0) for found in corners])
    high = np.array([np.max([one[1] for one in found], axis=0) for found in corners])
    for a, b in combinations(range(len(kept)), 2):
        if (np.minimum(high[a], high[b]) - np.maximum(low[a], low[b])).min() <= DEPTH:
            continue
        deepest = 0.0
        for i, one in enumerate(solid[a]):
            for j, other in enumerate(solid[b]):
                shared = np.minimum(corners[a][i][1], corners[b][j][1]) - np.maximum(corners[a][i][0], corners[b][j][0])
                if shared.min() > DEPTH:
                    deepest = max(deepest, depth(one, other))
        if deepest > DEPTH:
            yield kept[a].id, kept[b].id, deepest
