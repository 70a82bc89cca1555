"""Seeded rooms to repair: too full or not, with doors, windows, walls, locks; and what applying a repair means."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import reduce
from typing import Any

from catalogs import load_catalogs
from solver import Scene, fix, validate
from solver.answers import Fixed
from solver.scene import Furniture, Opening, Room
from solver.streams import Stream

WALLS = ("north", "west", "south", "east")
BACK_TO = {"north": 0, "west": 90, "south": 180, "east": 270}


def body(name: str, x: float, z: float, size: tuple[float, float, float], **more: object) -> Furniture:
    width, depth, height = size
    return Furniture(f"room_0/{name}", name.rstrip("_0123456789"), None, x, 0.0, z, 0, width, depth, height, **more)  # type: ignore[arg-type]


def room_of(*furniture: Furniture, width: float = 4.0, depth: float = 4.0, **more: object) -> Scene:
    room = Room("room_0", 0, "room", 0, 0.0, 0.0, width, depth, furniture=furniture, **more)  # type: ignore[arg-type]
    return Scene(rooms=(room,))


def errors(scene: Scene) -> list[str]:
    return [issue.message for issue in validate(scene, load_catalogs()) if issue.severity == "error"]


def pieces(scene: Scene) -> dict[str, Furniture]:
    return {piece.id: piece for room in scene.rooms for piece in room.furniture}


def fuzzed(seed: int, count: int = 4, locks: bool = False) -> Scene:
    """A room of 2.0-3.2 m with a door, perhaps a window, and large pieces thrown in, about half of them at walls."""
    stream = Stream(seed, "fuzzed rooms")
    width, depth = 2.0 + stream.below(1200) / 1000, 2.0 + stream.below(1200) / 1000
    openings = [Opening("door", "door", WALLS[stream.below(4)], 1.0, 0.8, connects_to="EXTERIOR", main_entrance=True)]
    if stream.chance(0.5):
        openings.append(Opening("window", "window", WALLS[stream.below(4)], 1.0, 1.0, 1.2, 0.9, "EXTERIOR"))
    furniture = []
    for k in range(count):
        size = (0.5 + stream.below(1500) / 1000, 0.4 + stream.below(700) / 1000, 0.4 + stream.below(1600) / 1000)
        wall = WALLS[stream.below(4)] if stream.chance(0.5) else None
        x, z = round(stream.unit() * width, 3), round(stream.unit() * depth, 3)
        turned = BACK_TO[wall or WALLS[stream.below(4)]]
        locked = locks and stream.chance(0.4)
        furniture.append(replace(body(f"piece_{k}", x, z, size, wall=wall, locked=locked), rotation=turned))
    return room_of(*furniture, width=round(width, 3), depth=round(depth, 3), openings=tuple(openings))


def with_repair(scene: Scene, repair: Mapping[str, Any]) -> Scene:
    """Does what docs/fix.md says a repair means."""
    action, label = repair["action"], repair["id"]
    rooms = []
    for room in scene.rooms:
        furniture = []
        for piece in room.furniture:
            if piece.id != label:
                if action != "leave_out" or piece.on != label:
                    furniture.append(piece)
            elif action == "unlock":
                furniture.append(replace(piece, locked=False))
            elif action == "move":
                furniture.append(replace(piece, wall=repair["wall"]))
            elif action == "turn":
                furniture.append(replace(piece, rotation=repair["rotation"]))
            elif action == "shrink":
                furniture.append(replace(piece, width=repair["width"], depth=repair["depth"]))
            else:
                assert action == "leave_out"
        rooms.append(replace(room, furniture=tuple(furniture)))
    return replace(scene, rooms=tuple(rooms))


def untrue_repairs(scene: Scene, fixed: Fixed) -> list[Mapping[str, Any]]:
    """The repairs offered that do not leave the one room clean, made with the first of each other conflict: as sent, or as answered."""
    told = [conflict.repairs for conflict in fixed.conflicts if conflict.repairs]
    found = []
    for own in told:
        firsts = [repairs[0] for repairs in told if repairs is not own]
        for repair in own:
            made = [reduce(with_repair, (*firsts, repair), base) for base in (scene, fixed.scene)]
            if any(errors(fix(one).scene) for one in made):
                found.append(repair)
    return found
