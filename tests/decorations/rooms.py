"""Rooms furnished by hand, decorated: a piece with its back to a wall in the middle of it, and what else is named."""

from __future__ import annotations

from collections import Counter
from typing import Any

from catalogs import Catalogs, load_catalogs
from solver.decorations import BareRoom, DecorationSettings, decorated_rooms
from solver.furnish import space_of
from solver.scene import Furniture, Opening, Room
from solver.streams import Stream

WALLS = {"north": 0, "west": 90, "south": 180, "east": 270}
"""The rotation of a piece with its back to a wall."""
SIDE = 6.0
THICKNESS = 0.1
DOOR = Opening("door_1", wall="south", position=0.8, connects_to="EXTERIOR", main_entrance=True)


def piece(kind: str, x: float = SIDE / 2, z: float = SIDE / 2, rotation: int = 0, **more: Any) -> Furniture:
    """A piece of a kind of the catalogs, in the middle of the room."""
    entry = load_catalogs().furniture[kind]
    name = entry.name or kind
    number = more.pop("number", 1)
    width, depth, height = entry.size
    return Furniture(
        f"r/{name}_{number}", name, entry.category, x, more.pop("y", 0.0), z, rotation, width, depth, height, entry.color, **more
    )


def at_wall(kind: str, wall: str = "north", along: float = SIDE / 2, **more: Any) -> Furniture:
    """A piece with its back 3 cm from a wall's face."""
    away = THICKNESS / 2 + 0.03 + load_catalogs().furniture[kind].size[1] / 2
    x, z = {"north": (along, away), "south": (along, SIDE - away), "west": (away, along), "east": (SIDE - away, along)}[wall]
    return piece(kind, round(x, 4), round(z, 4), WALLS[wall], wall=wall, **more)


def room(*furniture: Furniture, **more: Any) -> Room:
    values: dict[str, Any] = {"type": "room", "width": SIDE, "depth": SIDE, "openings": (DOOR,), "accent": "#123456", **more}
    return Room("r", furniture=tuple(furniture), **values)


def decorate(bare: Room, seed: int = 1, catalogs: Catalogs | None = None, **more: Any) -> Room:
    """Decorates a room; returns it with its decorations."""
    terms = DecorationSettings(catalogs or load_catalogs(), **more)
    (made,) = decorated_rooms([BareRoom(bare, space_of(bare, THICKNESS), Stream(seed, "decorations", bare.index))], terms)
    return made


def under(decorated_room: Room, parent: str) -> Counter[str]:
    """Counts the things on and over a piece, and all that lies on those."""
    carriers = {parent}
    for thing in decorated_room.decorations:
        if thing.parent in carriers:
            carriers.add(thing.id)
    return Counter(thing.name for thing in decorated_room.decorations if thing.parent in carriers)


def on_floor(decorated_room: Room) -> Counter[str]:
    """Counts the things without a parent that do not hang."""
    return Counter(thing.name for thing in decorated_room.decorations if thing.parent is None and thing.mounted_on_wall is None)
