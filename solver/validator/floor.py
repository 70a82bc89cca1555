"""The floor of rooms as the rules see it: what is clear of walls, what is kept free, and where the robot's square comes."""

from collections.abc import Collection
from itertools import islice
from struct import Struct
from typing import Any, Final

from catalogs import Catalogs, load_catalogs
from solver.core import ask
from solver.scene import Scene
from solver.validator.accessibility import turning_squares
from solver.validator.lattice import metres
from solver.validator.walk import walks
from solver.validator.world import PlacedRoom, World, world_of

_COUNTS: Final = Struct("<3q")
_BOX: Final = Struct("<4q")


def floors(scene: Scene, rooms: Collection[str] = (), catalogs: Catalogs | None = None) -> list[dict[str, Any]]:
    """Says what a person who moves furniture must know of the floor.

    Args:
        scene: any scene that could be read.
        rooms: the ids of the rooms wanted; all where none are given.
        catalogs: where profiles of access are; ours by default.

    Returns:
        For each room, in the scene's order: `clear`, its bounds less the walls; `doors`, the squares kept free; `windows`, the
        strips where nothing taller than the sill stands; `free`, what the robot's square covers of the clear floor while it
        comes from an entrance, in rectangles that do not overlap; where its request names a profile of access, `turning`, the square
        to turn in, and `short`, the largest there is where it is too small and no other room's makes up for it.
    """
    squares_by_room = _turning(scene, catalogs)
    world = world_of(scene)
    found: dict[str, dict[str, Any]] = {}
    for walk in walks(world):
        told = ask("free_floors", walk.rows)
        at = _COUNTS.size * len(walk.places)
        boxes = ([metres(steps) for steps in box] for box in _BOX.iter_unpack(told[at:]))
        for place, counts in zip(walk.places, _COUNTS.iter_unpack(told[:at]), strict=True):
            free, doors, windows = (list(islice(boxes, count)) for count in counts)
            floor = {"room": place.room.id, "clear": _clear(world, place), "doors": doors, "windows": windows, "free": free}
            found[place.room.id] = floor | squares_by_room.get(place.room.id, {"turning": [], "short": []})
    return [found[place.room.id] for place in world.places if not rooms or place.room.id in rooms]


def _turning(scene: Scene, catalogs: Catalogs | None) -> dict[str, dict[str, list[list[float]]]]:
    known, name = catalogs or load_catalogs(), (scene.request or {}).get("access")
    found: dict[str, dict[str, list[list[float]]]] = {}
    for one in turning_squares(scene, name, known) if isinstance(name, str) and name in known.access else ():
        west, north, east, south = one.place or (0.0, 0.0, 0.0, 0.0)
        of_room = found.setdefault(one.room, {"turning": [], "short": []})
        if one.missing and one.place:
            of_room["short"].append([west, north, east, south])
        elif not one.missing:
            of_room["turning"].append([west, north, round(west + one.needs, 4), round(north + one.needs, 4)])
    return found


def _clear(world: World, place: PlacedRoom) -> list[float]:
    """Returns the bounds less half a wall on each side; without extent where the walls take all of it."""
    x0, z0, x1, z1 = place.outline.bounds.grown(-world.half_wall)
    return [metres(steps) for steps in (x0, z0, max(x0, x1), max(z0, z1))]
