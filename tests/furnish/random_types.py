"""Random room types, whatever their relations say together, and random rooms of any type."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from random import Random
from typing import Any

from catalogs.schema import Catalogs, RelationWord, RoomType
from solver.scene import WALLS, Opening, Room, Sides

SIDES = ("left", "right", "front", "back")
WORDS: tuple[str, ...] = RelationWord.__args__  # type: ignore[attr-defined]
COSTS = (0.0, 0.1, 0.3, 1 / 128, 3 / 128, 5 / 64, 0.7, 2.0, 100.0)
"""Some end in a half at the sixth decimal."""


def random_type(rng: Random, catalogs: Catalogs, words: Sequence[str] = WORDS) -> RoomType:
    """Returns a room type of some kinds of the catalogs; its rules may be ones that the catalogs' checks would refuse."""
    kinds = rng.sample(sorted(catalogs.furniture), min(rng.randint(1, 9), len(catalogs.furniture)))
    names = [kind if rng.random() < 0.7 else f"piece_{i}" for i, kind in enumerate(kinds)]
    pieces = [_piece(rng, (name, words), kinds, names) for name in names]
    asked: dict[str, Any] = {"area": {"min": (4, 4), "typical": 12, "max": 60}, "flooring": "wood", "accent": "#808080", "pieces": pieces}
    if rng.random() < 0.3:
        orders = [rng.sample(names, rng.randint(1, len(names))) for _ in range(rng.randint(1, 3))]
        some = {key: rng.sample(names, len(names) // 2) for key in ("worktop", "landing", "ends")}
        asked["run"] = {"orders": orders, **some, "triangle": rng.sample(names, min(3, len(names)))}
        others = [name for name in names if not any(name in order for order in orders)]
        asked["run"]["leaves"] = [{"to": name, "floor": rng.choice((0.0, 0.35, 0.6)), "cost": rng.choice(COSTS)} for name in others[:1]]
    return RoomType.model_validate(asked)


def for_small_rooms(rng: Random, room_type: RoomType) -> RoomType:
    """Returns a room type of whose kinds some are for small rooms alone."""
    pieces = []
    for piece in room_type.pieces:
        kinds = tuple(one.model_copy(update={"max_area": rng.choice((None, 14.0))}) for one in piece.kinds)
        pieces.append(piece.model_copy(update={"kinds": kinds}))
    return room_type.model_copy(update={"pieces": tuple(pieces)})


def _piece(rng: Random, so: tuple[str, Sequence[str]], kinds: list[str], names: list[str]) -> dict[str, Any]:
    name, words = so
    variants = [{"kind": kind, "cost": rng.choice(COSTS), "min_area": rng.choice((0.0, 0.0, 12.0))} for kind in rng.choices(kinds, k=3)]
    piece: dict[str, Any] = {
        "piece": name,
        "kinds": variants[: rng.randint(1, 3)] + (_in_corners(rng, [one["kind"] for one in variants]) if rng.random() < 0.3 else []),
        "required": rng.random() < 0.3,
        "count": rng.randint(1, 4),
    }
    piece["min_area"] = rng.choice((0.0, 0.0, 15.0))
    if not piece["required"]:
        piece |= {"chance": rng.choice((0.4, 1.0)), "per_area": rng.choice((None, 5.0))}
    piece["rules"] = [_rule(rng, names, words) for _ in range(rng.randint(0, 4))]
    more = {"among": rng.choice(("these", "those")), "approach": rng.sample(SIDES, 2), "with_next": True, "without": ("kitchen",)}
    return piece | {key: value for key, value in more.items() if rng.random() < (0.5 if key == "among" else 0.15)}


def _in_corners(rng: Random, kinds: list[Any]) -> list[dict[str, Any]]:
    return [{"kind": rng.choice(kinds), "cost": rng.choice(COSTS), "corner": side} for side in ("left", "right", "left")]


def _rule(rng: Random, names: list[str], words: Sequence[str]) -> dict[str, Any]:
    rule: dict[str, Any] = {"type": rng.choice(words), "cost": rng.choice(COSTS), "required": rng.random() < 0.2}
    of = rng.choices([*names, "door", "garage_door", "window", "nothing"], k=rng.randint(0, 3))
    more = {
        "of": of, "distance": rng.choice((0.0, 0.7, 2.5)), "gap": sorted(rng.choices((-0.3, -0.15, 0.0, 0.015, 0.4), k=2)),
        "sides": rng.sample(SIDES, rng.randint(1, 4)), "align": rng.choice(("back", "centre", "front", "any")),
        "wall": rng.choice(("same", "opposite", "adjacent", "other")), "weight": rng.choice((0.0, 0.02, 1.5, 20.0)),
        "walls": {sort: rng.choice(COSTS) for sort in rng.sample(("door", "window", "exterior", "plain", "short", "long", "across"), 3)},
    }  # fmt: skip
    return rule | {key: value for key, value in more.items() if key == "of" or rng.random() < 0.3}


def random_room(rng: Random, name: str) -> Room:
    """Returns a room of a type, from too small for anything to large, with openings that may overlap; some are no rectangles."""
    width, depth = rng.randint(400, 8000) / 1000, rng.randint(400, 8000) / 1000
    openings = []
    for i in range(rng.randint(0, 5)):
        wall, kind = rng.choice(WALLS), rng.choice(("door", "passage", "window", "window", "garage_door"))
        along = width if wall in ("north", "south") else depth
        at, wide = round(rng.uniform(0, along), 4), rng.choice((0.8, 0.9, 1.25, 2.4))
        one = Opening(f"o{i}", kind, wall, at, wide, 2.1, rng.choice((0.0, 0.4, 0.9)) * (kind == "window"), connects_to="hall")
        openings.append(replace(one, main_entrance=kind == "door" and i == 0))
    x, z = round(width * rng.uniform(0.2, 0.8), 3), round(depth * rng.uniform(0.2, 0.8), 3)
    outline = ((0.0, 0.0), (x, 0.0), (x, z), (width, z), (width, depth), (0.0, depth)) if rng.random() < 0.2 else None
    exterior = Sides(*(rng.random() < 0.5 for _ in WALLS)) if rng.random() < 0.7 else None
    return Room("room_0", 0, name, width=width, depth=depth, outline=outline, openings=tuple(openings), exterior_walls=exterior)
