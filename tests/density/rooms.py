"""Seeded rooms of a type and size as homes have them, and one and the same room furnished by many seeds."""

from __future__ import annotations

from dataclasses import dataclass

from catalogs import Catalogs
from solver import reroll
from solver.answers import Generated
from solver.scene import EXTERIOR, Opening, Room, Scene
from tests.dense.rooms import Kind, drawn_room

KINDS = {
    "bedroom": Kind("bedroom", (9.0, 16.0), (9.0, 16.0), 9.0, 2.6, (0.3, 0.4)),
    "bedroom_master": Kind("bedroom_master", (12.0, 16.0), (12.0, 16.0), 12.0, 2.8, (0.3, 0.4)),
    "kids_bedroom": Kind("kids_bedroom", (9.0, 16.0), (9.0, 16.0), 9.0, 2.6, (0.3, 0.4)),
    "bathroom": Kind("bathroom", (4.0, 8.0), (4.0, 8.0), 7.0, 1.8, (0.3, 0.5), door=800, windows=(500, 900), sill=1.3),
    "kitchen": Kind("kitchen", (8.0, 16.0), (8.0, 16.0), 9.0, 2.4, (0.3, 0.4), windows=(800, 1400), sill=1.0),
    "living_room": Kind("living_room", (15.0, 32.0), (15.0, 32.0), 9.0, 3.2, (0.2, 0.3)),
    "dining_room": Kind("dining_room", (9.0, 18.0), (9.0, 18.0), 9.0, 2.8, (0.2, 0.3)),
    "office": Kind("office", (7.0, 14.0), (7.0, 14.0), 9.0, 2.4, (0.2, 0.3)),
    "laundry": Kind("laundry", (3.6, 9.0), (3.6, 9.0), 7.0, 1.8, (0.2, 0.3), door=800, windows=(500, 900), sill=1.3),
}


@dataclass(frozen=True)
class Equal:
    """One room that many seeds furnish: its type, width and depth, m, the walls of its doors and of its windows."""

    room_type: str
    width: float
    depth: float
    doors: tuple[str, ...]
    windows: tuple[str, ...]


EQUAL = (
    Equal("bedroom", 3.0, 4.0, ("south",), ("north",)),
    Equal("bedroom", 4.0, 3.0, ("south",), ("east",)),
    Equal("bedroom", 3.4, 3.53, ("west",), ("north",)),
    Equal("living_room", 4.0, 6.0, ("south",), ("north",)),
    Equal("living_room", 6.0, 4.0, ("south", "west"), ("north",)),
    Equal("living_room", 4.8, 5.0, ("east",), ("west", "north")),
    Equal("kitchen", 2.75, 4.0, ("south",), ("north",)),
    Equal("kitchen", 4.0, 2.75, ("south",), ("north",)),
    Equal("kitchen", 3.3, 3.34, ("west", "south"), ("north",)),
)


def drawn(name: str, seed: int, catalogs: Catalogs | None = None) -> Room:
    """Returns the furnished room of a type and seed."""
    return _furnished(drawn_room(KINDS[name], f"density/{name}", seed), seed, catalogs)


def equal(of: Equal, seed: int, catalogs: Catalogs | None = None) -> Room:
    """Returns one and the same room as a seed furnishes it."""
    openings = [
        Opening(f"door_{k}", "door", wall, _third(of, wall), 0.9, connects_to=EXTERIOR, main_entrance=k == 0)
        for k, wall in enumerate(of.doors)
    ]
    openings += [
        Opening(f"window_{k}", "window", wall, _third(of, wall) + 0.3, 1.2, 1.2, 0.9, EXTERIOR) for k, wall in enumerate(of.windows)
    ]
    return _furnished(Room("room_0", 0, of.room_type, width=of.width, depth=of.depth, openings=tuple(openings)), seed, catalogs)


def _third(of: Equal, wall: str) -> float:
    return round((of.width if wall in ("north", "south") else of.depth) * 0.4, 2)


def _furnished(room: Room, seed: int, catalogs: Catalogs | None) -> Room:
    done: Generated = reroll(Scene(seed=0, wall_thickness=0.1, rooms=(room,)), [room.id], seed=seed, catalogs=catalogs)
    return done.scene.rooms[0]
