"""Random rectilinear rooms: L, T, U and Z of any size, turned and mirrored, with doors and windows anywhere on their walls."""

from __future__ import annotations

import random
from collections.abc import Iterator

from catalogs import load_catalogs
from solver.scene import Opening, Room

KINDS = ("L", "T", "U", "Z", "wide L")
TYPES = ("bedroom", "bedroom_master", "kids_bedroom", "kitchen", "bathroom", "living_room", "dining_room", "office", "laundry")
LEAST_SIDE = 0.2
"""Of an outline, m."""
Corners = list[tuple[float, float]]


def area_of(corners: Corners) -> float:
    following = corners[1:] + corners[:1]
    return abs(sum(x0 * z1 - z0 * x1 for (x0, z0), (x1, z1) in zip(corners, following, strict=True))) / 2


def _corners(chance: random.Random, kind: str, wide: float, deep: float) -> Corners:
    """The outline of a kind in a rectangle; its arms are 1.6 to 2.4 m wide but for the wide L's."""

    def length(low: float, high: float) -> float:
        return chance.uniform(min(low, high), max(low, high))

    a, b = length(1.6, min(2.4, wide - 1.2)), length(1.6, min(2.4, deep - 1.2))
    if kind == "L":
        return [(0, 0), (wide, 0), (wide, b), (a, b), (a, deep), (0, deep)]
    if kind == "T":
        x = length(0.6, wide - a - 0.6)
        return [(0, 0), (wide, 0), (wide, b), (x + a, b), (x + a, deep), (x, deep), (x, b), (0, b)]
    if kind == "U":
        a = min(a, (wide - 1.0) / 2)
        return [(0, 0), (wide, 0), (wide, deep), (wide - a, deep), (wide - a, b), (a, b), (a, deep), (0, deep)]
    if kind == "Z":
        x = length(0.3, wide - a - 0.3)
        return [(0, 0), (x + a, 0), (x + a, deep - b), (wide, deep - b), (wide, deep), (x, deep), (x, b), (0, b)]
    x, z = length(0.5, wide / 2), length(0.5, deep / 2)
    return [(0, 0), (wide, 0), (wide, deep - z), (wide - x, deep - z), (wide - x, deep), (0, deep)]


def _lengths(corners: Corners) -> list[float]:
    following = corners[1:] + corners[:1]
    return [abs(x0 - x1) + abs(z0 - z1) for (x0, z0), (x1, z1) in zip(corners, following, strict=True)]


def _openings(chance: random.Random, sides: list[float]) -> Iterator[Opening]:
    """A door, perhaps another, and windows, each where a side has room for it beside the others."""
    taken: list[tuple[int, float, float]] = []
    kinds = ["door", *["window"] * chance.randrange(3), *["door"] * (chance.random() < 0.25)]
    for number, kind in enumerate(kinds):
        width = 0.9 if kind == "door" else round(chance.uniform(0.8, 1.6), 1)
        for _ in range(30):
            edge = chance.randrange(len(sides))
            if sides[edge] < width + 0.2:
                continue
            at = round(chance.uniform(width / 2 + 0.1, sides[edge] - width / 2 - 0.1), 2)
            if all(edge != other or abs(at - place) > (width + size) / 2 + 0.2 for other, place, size in taken):
                taken.append((edge, at, width))
                height, sill = (2.1, 0.0) if kind == "door" else (1.2, 0.9)
                yield Opening(f"{kind}_{number}", kind, None, at, width, height, sill, "EXTERIOR", main_entrance=number == 0, edge=edge)
                break


def stepped_room(seed: int) -> Room:
    """A room of a type that is as large as rooms of it are; its first opening is a door."""
    chance, kinds = random.Random(seed), load_catalogs().rooms
    shape, type_name = chance.choice(KINDS), chance.choice(TYPES)
    home = kinds[type_name].home
    assert home is not None
    while True:
        wide, deep = (round(chance.uniform(2.8, 7.5), 2) for _ in range(2))
        corners = [(round(x, 2), round(z, 2)) for x, z in _corners(chance, shape, wide, deep)]
        turns, mirrored = chance.randrange(4), chance.random() < 0.5
        if mirrored:
            corners = [(round(wide - x, 2), z) for x, z in reversed(corners)]
        for _ in range(turns):
            corners = [(round(deep - z, 2), x) for x, z in corners]
            wide, deep = deep, wide
        is_proper = len(set(corners)) == len(corners) and min(_lengths(corners)) >= LEAST_SIDE
        if not is_proper or not home.area[0] <= area_of(corners) <= 1.3 * home.area[2]:
            continue
        openings = tuple(_openings(chance, _lengths(corners)))
        if openings and openings[0].id == "door_0":
            return Room("room", type=type_name, width=wide, depth=deep, outline=tuple(corners), openings=openings)
