"""Measures of a scene: counts, how much of the floor is covered, how much can be walked.

Comes in: a scene. Goes out: plain values. May import: scene, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from catalogs import Catalogs
from solver.scene import Scene
from solver.scene_bodies import counted
from solver.validator.kinds import Kinds
from solver.validator.lattice import PER_METRE, ExactBox
from solver.validator.reaching import LEAST_FLOOR, missed_sides
from solver.validator.tiled_floor import Grid, boxes_of
from solver.validator.walk import HEADROOM, Walk, walks
from solver.validator.world import PlacedRoom, World, world_of


def metrics(scene: Scene, catalogs: Catalogs | None = None) -> dict[str, Any]:
    """Measures a scene.

    Returns:
        `counts` (rooms, doors, windows, furniture, decorations, dynamic); `area` between wall lines, m2; `cover`, the share
        of the clear floor under bodies; `furnished`, the share of the area under furniture that stands on the floor, no spot
        counted twice; `walkable`, the share of the clear floor that the centre of the robot's square can
        come to; the same for each room under `rooms`, with `reached`. With catalogs also `use_sides`: how many pieces are
        used from a side, and how many of them can be.
    """
    world = world_of(scene)
    walked = walks(world)
    measured = {place.room.id: _room(world, walk, place) for walk in walked for place in walk.places}
    rooms = {room.id: measured[room.id] for room in scene.rooms}
    totals = {key: sum(room[key] for room in rooms.values()) for key in ("area", "clear", "covered", "under_furniture", "walked")}
    answer = {"counts": counted(scene.rooms, scene.dynamic), "area": round(totals["area"], 4), **_shares(totals)}
    answer["reached"] = sum(room["reached"] for room in rooms.values())
    answer["rooms"] = {name: _published(room) for name, room in rooms.items()}
    if catalogs is not None:
        answer["use_sides"] = _use_sides(walked, Kinds(catalogs))
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


def _room(world: World, walk: Walk, place: PlacedRoom) -> dict[str, Any]:
    """Measures a room: areas in m2."""
    walls = [edge.strip(edge.start - world.half_wall, edge.end + world.half_wall, *[world.half_wall] * 2) for edge in place.edges]
    bodies = [body.box for body in place.bodies if body.low < HEADROOM]
    furniture = [body.box for body in place.bodies if body.is_furniture and body.low <= 0]
    area, clear = _free_area(place, []), _free_area(place, walls)
    return {
        "area": area,
        "clear": clear,
        "covered": clear - _free_area(place, [*walls, *bodies]),
        "under_furniture": area - _free_area(place, furniture),
        "walked": walk.floor(place) / PER_METRE**2,
        "reached": walk.floor(place) >= LEAST_FLOOR,
    }


def _free_area(place: PlacedRoom, obstacles: list[ExactBox]) -> float:
    grid = Grid(boxes_of(list(place.outline.inside)), boxes_of(obstacles))
    return grid.area(grid.free, (slice(None), slice(None))) / PER_METRE**2


def _use_sides(walked: tuple[Walk, ...], kinds: Kinds) -> dict[str, int]:
    met = list(_met(walked, kinds))
    return {"wanted": len(met), "reached": sum(met)}


def _met(walked: tuple[Walk, ...], kinds: Kinds) -> Iterator[bool]:
    """Tells for each piece that is used from a side whether it can be."""
    for walk in walked:
        for place in walk.places:
            entered = walk.floor(place) >= LEAST_FLOOR
            for body in place.bodies:
                use = kinds.use(body.name) if body.is_furniture else None
                if use is not None:
                    yield entered and not missed_sides(walk, place, body, use)
