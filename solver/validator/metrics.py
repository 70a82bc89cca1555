"""Measures of a scene: counts, how much of the floor is covered, how much can be walked."""

from collections.abc import Iterator
from struct import Struct
from typing import Any, Final

from catalogs import Catalogs
from solver.core import ask
from solver.scene import Scene
from solver.scene_bodies import counted
from solver.understanding import understood
from solver.validator.kinds import Kinds, kinds_of
from solver.validator.lattice import PER_METRE
from solver.validator.reaching import LEAST_FLOOR
from solver.validator.walk import Walk, walks
from solver.validator.world import world_of

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
    answer["rooms"] = {name: _published(room) for name, room in rooms.items()}
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


def _published(room: dict[str, Any]) -> dict[str, Any]:
    return {"area": round(room["area"], 4), "clear_area": round(room["clear"], 4), **_shares(room), "reached": room["reached"]}


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
