"""Measures of a scene: counts, how much of the floor is covered, how much can be walked; and the floor itself as the rules see it."""

from collections.abc import Collection, Iterator
from itertools import islice
from struct import Struct
from typing import Any, Final

from catalogs import Catalogs, load_catalogs
from solver.core import ask
from solver.scene import Scene
from solver.scene_bodies import counted
from solver.understanding import understood
from solver.validator.accessibility import turning_squares
from solver.validator.kinds import Kinds, kinds_of
from solver.validator.lattice import PER_METRE, metres
from solver.validator.room_rules import LEAST_FLOOR
from solver.validator.walk import Walk, walks
from solver.validator.world import PlacedRoom, World, world_of

_AREAS: Final = Struct("<8Q")


def metrics(scene: Scene, catalogs: Catalogs | None = None) -> dict[str, Any]:
    """Measures a scene.

    Returns:
        `counts` (rooms, doors, windows, furniture, decorations, dynamic); `area` between wall lines, m2; `cover`, the share
        of the clear floor under bodies; `furnished`, the share of the area under furniture that stands on the floor, no spot
        counted twice; `walkable`, the share of the clear floor that the centre of the robot's square can
        come to; the same for each room under `rooms`, with `reached`. With catalogs also `use_sides`: how many pieces are
        used from a side, and how many of them can be.
    """
    world = world_of(scene if catalogs is None else understood(scene, catalogs).scene)
    kinds = None if catalogs is None else kinds_of(catalogs)
    walked = walks(world, kinds)
    measured = {name: room for walk in walked for name, room in _measured(walk)}
    rooms = {room.id: measured[room.id] for room in scene.rooms}
    totals = {key: sum(room[key] for room in rooms.values()) for key in ("area", "clear", "covered", "under_furniture", "walked")}
    answer = {"counts": counted(scene.rooms, scene.dynamic), "area": round(totals["area"], 4), **_shares(totals)}
    answer["reached"] = sum(room["reached"] for room in rooms.values())
    answer["rooms"] = {
        name: {"area": round(room["area"], 4), "clear_area": round(room["clear"], 4), **_shares(room), "reached": room["reached"]}
        for name, room in rooms.items()
    }
    if kinds is not None:
        answer["use_sides"] = _use_sides(walked, kinds)
    return answer


def _shares(areas: dict[str, Any]) -> dict[str, float]:
    clear, area = areas["clear"] or 1.0, areas["area"] or 1.0
    return {
        "cover": round(areas["covered"] / clear, 4),
        "furnished": round(areas["under_furniture"] / area, 4),
        "walkable": round(areas["walked"] / clear, 4),
    }


def _measured(walk: Walk) -> Iterator[tuple[str, dict[str, Any]]]:
    """Measures the rooms of a storey: areas in m2."""
    for place, row in zip(walk.places, _AREAS.iter_unpack(ask("measure_storey", walk.rows)), strict=True):
        steps = [high << 64 | low for high, low in zip(row[::2], row[1::2], strict=True)]
        area, clear, uncovered, unfurnished = (one / PER_METRE**2 for one in steps)
        measured = {"area": area, "clear": clear, "covered": clear - uncovered, "under_furniture": area - unfurnished}
        walked = walk.floor(place)
        yield place.room.id, {**measured, "walked": walked / PER_METRE**2, "reached": walked >= LEAST_FLOOR}


def _use_sides(walked: tuple[Walk, ...], kinds: Kinds) -> dict[str, int]:
    wanted = reached = 0
    for walk in walked:
        for place in walk.places:
            used = sum(kinds.uses[key] is not None for key in place.keys)
            wanted += used
            if walk.floor(place) >= LEAST_FLOOR:
                reached += used - sum(map(bool, walk.missed[place.room.id]))
    return {"wanted": wanted, "reached": reached}


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
