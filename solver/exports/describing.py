"""A scene described for export: each body, wall, opening, leaf and floor once, in house coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from catalogs import Catalogs
from solver.export_formats import Freedom
from solver.exports.described_bodies import BodyMaker
from solver.exports.door_leaves import leaves_of
from solver.exports.kind_facts import classes_of
from solver.exports.model import FloorPlate, HouseModel, Paint
from solver.exports.paints import PLAIN_FLOOR, paints_of
from solver.exports.wall_bands import WallBands, thick
from solver.exports.wall_edges import on_lattice
from solver.exports.wall_lines import RoomFinder, openings_of, runs_of
from solver.exports.wall_panels import Storey, WallPlan, boxes_of, fittings_of, panels_of
from solver.geometry import doubled_area
from solver.scene import Flooring, Room, Scene
from solver.scene_bodies import storey_height

ROUNDING_ERROR: Final = 1e-6
"""What is left of a wall between two ends that are one but for rounding is no wall, m."""


def describe(scene: Scene, catalogs: Catalogs, free: Freedom = "light", warnings: Sequence[str] = ()) -> HouseModel:
    """Describes a scene, with `warnings`, in words, to stand in the files; `free` is what a simulator may move.

    What it leaves unsaid is described as it is drawn: floors at 0 m, walls as high as `size` says, else 2.8 m.
    """
    listed = {level.index: Storey(level.elevation, level.height) for level in scene.levels}
    storeys = {level: Storey(height=storey_height(scene, level)) for level in {room.level for room in scene.rooms}} | listed
    paints = paints_of(catalogs, style_of(scene))
    rooms = scene.rooms
    finder, bands = RoomFinder(rooms), WallBands(rooms, scene.wall_thickness)
    plan = WallPlan(runs_of(bands), openings_of(rooms, bands, finder), storeys, rooms)
    panels = panels_of(plan)
    maker = BodyMaker(catalogs, paints, {level: storey.elevation for level, storey in storeys.items()}, free)
    bodies = tuple(maker.bodies(scene))
    kinds, categories = classes_of(catalogs)
    return HouseModel(
        scene=scene,
        name="house" if scene.seed is None else f"house_{scene.seed}",
        bodies=bodies,
        panels=tuple(panels),
        walls=tuple(wall for panel in panels for wall in boxes_of(panel, finder) if min(wall.box.size) > ROUNDING_ERROR),
        fittings=tuple(fittings_of(plan)),
        openings=tuple(plan.openings),
        leaves=tuple(leaves_of(plan, paints)),
        rooms=tuple(_floor(room, plan, bands.own(room), _flooring(room, catalogs)) for room in rooms),
        thickness=thick(scene.wall_thickness),
        shapes=maker.unit_shapes,
        warnings=tuple(warnings),
        kinds=kinds,
        categories=categories,
        assets={name: maker.assets[name] for name in sorted(maker.assets)},
    )


def style_of(scene: Scene) -> str | None:
    """Returns the name of the style that a scene was furnished in; None where it does not say."""
    said = scene.extra.get("style") or (scene.request or {}).get("style")
    return said if isinstance(said, str) else None


def _flooring(room: Room, catalogs: Catalogs) -> Flooring | None:
    """Returns the floor that a room is drawn with: its own, else the plain one of its type; None for a type that is not known."""
    known = catalogs.rooms.get(room.type)
    if room.flooring is not None or known is None:
        return room.flooring
    return Flooring(known.flooring, catalogs.floorings[known.flooring].color)


def _floor(room: Room, plan: WallPlan, outer: tuple[float | None, ...], flooring: Flooring | None) -> FloorPlate:
    """Returns a room's floor, its corners clockwise whichever way the room lists them."""
    area = doubled_area(room.corners) / 2
    storey = plan.storey(room.level)
    placed = tuple((on_lattice(room.x + x), on_lattice(room.z + z)) for x, z in room.corners)
    return FloorPlate(
        id=room.id,
        type=room.type,
        level=room.level,
        outdoor=room.outdoor,
        corners=placed if area >= 0 else (placed[0], *placed[:0:-1]),
        elevation=storey.elevation,
        ceiling=storey.elevation + storey.height,
        paint=Paint(flooring.color, 0.9, texture=flooring.type) if flooring else PLAIN_FLOOR,
        area=round(abs(area), 6),
        outer=outer if area >= 0 else outer[::-1],
    )
