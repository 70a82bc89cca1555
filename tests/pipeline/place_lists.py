# ruff: noqa: E501 - a table is read by its columns
"""Thirty lists of pieces without any relation, as somebody would type them: homes, offices, restaurants, waiting rooms.

4 to 20 pieces on 8 to 80 m2. Names are ours, of others, or of nothing we know.
"""

from __future__ import annotations

from random import Random
from typing import Final

from catalogs import load_catalogs
from solver.requested import PieceRequest
from solver.scene import Opening, Room

Wish = tuple[str, int] | tuple[str, int, tuple[float, float, float]]
"""A name, how many, and a size where one is given."""


def _room(width: float, depth: float, door: tuple[str, float], windows: tuple[tuple[str, float], ...] = ()) -> Room:
    openings = [Opening("door", "door", wall=door[0], position=door[1], connects_to="EXTERIOR")]
    openings += [
        Opening(f"window_{n}", "window", wall=wall, position=at, width=1.4, height=1.2, sill=0.9) for n, (wall, at) in enumerate(windows, 1)
    ]
    return Room("room", width=width, depth=depth, openings=tuple(openings))


def _wanted(wishes: tuple[Wish, ...]) -> tuple[PieceRequest, ...]:
    pieces = []
    for number, (name, count, *size) in enumerate(wishes, 1):
        width, depth, height = size[0] if size else (None, None, None)
        pieces.append(PieceRequest(f"{name}_{number}".replace(" ", "_"), name, width, depth, height, count))
    return tuple(pieces)


_TASKS: dict[str, tuple[Room, tuple[Wish, ...]]] = {
    "small bedroom": (_room(3.2, 2.9, ("south", 2.6), (("north", 1.2),)), (("bed", 1), ("nightstand", 1), ("wardrobe", 1), ("plant", 1))),
    "bedroom": (
        _room(4.2, 3.6, ("east", 3.0), (("west", 1.8),)),
        (("double bed", 1), ("nightstand", 2), ("wardrobe", 1), ("dresser", 1), ("floor_lamp", 1), ("armchair", 1)),
    ),
    "two children": (
        _room(4.5, 4.0, ("south", 0.8), (("north", 2.2),)),
        (("single_bed", 2), ("desk", 2), ("office_chair", 2), ("wardrobe", 1), ("bookshelf", 1), ("bean_bag", 1)),
    ),
    "guest room": (_room(3.6, 3.0, ("west", 0.7)), (("sofa bed", 1), ("side_table", 1), ("bookcase", 1), ("desk", 1), ("chair", 1))),
    "dormitory": (_room(8.0, 5.0, ("south", 4.0), (("north", 2.0), ("north", 6.0))), (("bunk_bed", 4), ("locker", 4), ("table", 1), ("chair", 4))),
    "living room": (
        _room(5.2, 4.4, ("south", 0.8), (("east", 2.2),)),
        (("sofa", 1), ("armchair", 2), ("coffee_table", 1), ("tv_stand", 1), ("bookshelf", 1), ("floor_lamp", 1), ("plant", 2)),
    ),
    "large living room": (
        _room(8.5, 6.0, ("west", 3.0), (("south", 2.0), ("south", 6.0))),
        (("sofa", 2), ("armchair", 2), ("coffee table", 1), ("tv unit", 1), ("sideboard", 1), ("piano", 1), ("dining_table", 1), ("dining_chair", 6), ("plant", 3)),
    ),
    "library": (
        _room(6.0, 5.0, ("north", 1.0), (("south", 3.0),)),
        (("bookshelf", 8), ("armchair", 4), ("side_table", 2), ("floor_lamp", 2), ("desk", 1), ("chair", 1)),
    ),
    "dining room": (_room(4.4, 3.6, ("west", 0.8), (("east", 1.8),)), (("dining_table", 1), ("dining_chair", 6), ("sideboard", 1), ("plant", 1))),
    "studio": (
        _room(6.0, 4.5, ("south", 5.2), (("north", 3.0),)),
        (("bed", 1), ("nightstand", 1), ("sofa", 1), ("coffee_table", 1), ("tv_stand", 1), ("table", 1), ("chair", 2), ("wardrobe", 1), ("desk", 1), ("office_chair", 1)),
    ),
    "bistro": (_room(6.5, 5.0, ("south", 1.0), (("west", 2.5),)), (("restaurant table", 4, (0.8, 0.8, 0.75)), ("chair", 12), ("counter", 1), ("plant", 2))),
    "restaurant": (
        _room(10.0, 8.0, ("south", 5.0), (("north", 3.0), ("north", 7.0))),
        (("dining_table", 4), ("dining_chair", 14), ("sideboard", 1), ("coat_rack", 1)),
    ),
    "canteen": (_room(9.0, 7.0, ("east", 3.5), (("west", 2.0), ("west", 5.0))), (("table", 5, (1.6, 0.8, 0.74)), ("chair", 15))),
    "bar": (_room(7.0, 4.5, ("west", 2.2)), (("bar table", 4, (0.7, 0.7, 1.05)), ("bar stool", 10), ("counter", 2), ("fridge", 1))),
    "office": (_room(4.0, 3.2, ("south", 3.2), (("north", 2.0),)), (("desk", 1), ("office_chair", 1), ("bookshelf", 1), ("filing_cabinet", 1), ("plant", 1))),
    "shared office": (
        _room(8.0, 6.0, ("south", 1.2), (("north", 2.0), ("north", 6.0))),
        (("desk", 6), ("office chair", 6), ("filing cabinet", 3), ("printer", 1, (0.6, 0.6, 1.1)), ("plant", 2)),
    ),
    "open office": (
        _room(11.0, 7.2, ("west", 3.6), (("east", 2.0), ("east", 5.0))),
        (("desk", 8), ("task chair", 8), ("bookshelf", 2), ("water dispenser", 1, (0.35, 0.35, 1.2)), ("plant", 1)),
    ),
    "meeting room": (_room(5.5, 4.5, ("south", 0.8), (("north", 2.7),)), (("conference table", 1, (2.4, 1.1, 0.74)), ("chair", 8), ("whiteboard", 1, (1.8, 0.5, 1.9)))),
    "reception": (
        _room(6.0, 4.5, ("south", 3.0)),
        (("reception desk", 1, (1.8, 0.8, 1.1)), ("office_chair", 1), ("sofa", 1), ("coffee_table", 1), ("plant", 2), ("coat_rack", 1)),
    ),
    "waiting room": (_room(5.0, 4.0, ("west", 2.0), (("north", 2.5),)), (("waiting chair", 8), ("coffee_table", 1), ("magazine rack", 1, (0.4, 0.35, 1.2)), ("plant", 2))),
    "large waiting room": (_room(9.0, 8.0, ("south", 4.5)), (("bench", 6), ("side table", 3), ("plant", 4), ("vending machine", 2, (0.9, 0.8, 1.9)))),
    "class room": (_room(9.0, 7.0, ("east", 0.8), (("west", 2.0), ("west", 5.0))), (("school desk", 8, (1.2, 0.6, 0.75)), ("school chair", 8), ("bookshelf", 2), ("desk", 1), ("office_chair", 1))),
    "gallery": (_room(10.0, 7.0, ("south", 5.0)), (("sculpture stand", 5, (0.6, 0.6, 1.1)), ("show case", 3, (1.4, 0.7, 1.0)), ("bench", 2))),
    "shop": (
        _room(8.0, 6.5, ("south", 4.0)),
        (("clothes rail", 4, (1.5, 0.5, 1.6)), ("shelf", 4), ("till", 1, (1.4, 0.7, 1.0)), ("standing_mirror", 1), ("stool", 2)),
    ),
    "gym": (_room(8.0, 6.0, ("west", 1.0), (("north", 4.0),)), (("treadmill", 3), ("weight bench", 2, (1.4, 0.6, 0.5)), ("rowing machine", 1, (2.2, 0.6, 0.9)), ("bench", 1), ("locker", 3))),
    "workshop": (_room(6.0, 5.0, ("south", 1.0), (("east", 2.5),)), (("workbench", 2), ("tool_cabinet", 2), ("storage_shelf", 3), ("table_saw", 1), ("drill_press", 1))),
    "bathroom": (_room(3.2, 2.6, ("south", 2.6)), (("toilet", 1), ("washbasin", 1), ("bathtub", 1), ("laundry basket", 1))),
    "laundry": (_room(3.4, 2.4, ("east", 1.2)), (("washing machine", 1), ("dryer", 1), ("sink", 1), ("shelf", 1), ("drying_rack", 1))),
    "kitchen": (_room(4.2, 3.4, ("south", 0.8), (("north", 2.0),)), (("fridge", 1), ("cooker", 1), ("sink", 1), ("counter", 2), ("table", 1, (1.0, 0.7, 0.75)), ("chair", 2))),
    "storeroom": (_room(7.0, 10.0, ("south", 3.5)), (("pallet", 10, (1.2, 0.8, 1.4)), ("storage_shelf", 6), ("ladder", 1, (0.6, 1.2, 0.3)))),
}  # fmt: skip
TASKS: Final = {name: (room, _wanted(wishes)) for name, (room, wishes) in _TASKS.items()}
"""By name: an empty room, and what is to stand in it."""

_NO_FURNITURE: Final = ("vehicle", "water", "dynamic", "structure", "misc", "electronics")
_KINDS: Final = tuple(
    kind for kind, spec in load_catalogs().furniture.items()
    if spec.category not in _NO_FURNITURE and spec.size[0] * spec.size[1] < 2.6 and kind not in ("microwave", "tree", "flower_bed")
)  # fmt: skip
_UNKNOWN: Final = ("podium", "machine", "exhibit", "thing")


def drawn(seed: int) -> tuple[Room, tuple[PieceRequest, ...]]:
    """Returns a room with a door and a window and a list of at most 20 pieces that cover at most 30 % of it, from a seed."""
    chance = Random(seed)
    width, depth = round(chance.uniform(2.8, 10), 2), round(chance.uniform(2.8, 8), 2)
    door, window = chance.sample(("north", "south", "east", "west"), 2)
    along = {"north": width, "south": width, "east": depth, "west": depth}
    room = _room(
        width,
        depth,
        (door, round(chance.uniform(0.6, along[door] - 0.6), 2)),
        ((window, round(chance.uniform(0.9, along[window] - 0.9), 2)),),
    )
    floor, pieces = chance.uniform(0.08, 0.3) * width * depth, list[PieceRequest]()
    for number in range(12):
        name, count = chance.choice(_KINDS), chance.choice((1, 1, 1, 1, 2, 3, 4, 6))
        size: tuple[float, float, float] = load_catalogs().furniture[name].size
        if chance.random() < 0.2:
            name, size = (
                chance.choice(_UNKNOWN),
                (round(chance.uniform(0.3, 1.6), 2), round(chance.uniform(0.3, 0.9), 2), round(chance.uniform(0.3, 2), 2)),
            )
        floor -= count * size[0] * size[1]
        if floor < 0 or count + sum(piece.count for piece in pieces) > 20:
            break
        if max(size[:2]) <= min(width, depth) - 1.2:
            pieces.append(PieceRequest(f"piece_{number}", name, *size, count=count))
    return room, tuple(pieces)
