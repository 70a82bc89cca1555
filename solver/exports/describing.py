"""A scene described for export: each body, wall, opening, leaf and floor once, in house coordinates."""

import math
from collections.abc import Iterator, Mapping, Sequence
from math import prod
from typing import Final

from catalogs import Catalogs
from catalogs.assets.asset_entry import Asset
from catalogs.entries import Side
from solver.export_formats import Freedom
from solver.exports.door_leaves import leaves_of
from solver.exports.kind_facts import (
    KindFacts,
    book_of,
    classes_of,
    decoration_facts,
    fronts_of_shape,
    furniture_facts,
    living_facts,
    paints_of_shape,
    parts_of_shape,
)
from solver.exports.model import FloorPlate, HouseModel, ModelBody, Paint, Sort
from solver.exports.paints import PLAIN_FLOOR, Paints, paints_of
from solver.exports.wall_bands import RoomFinder, WallBands, on_lattice, openings_of, runs_of, thick
from solver.exports.wall_panels import WallPlan, boxes_of, fittings_of, panels_of
from solver.geometry import doubled_area
from solver.scene import Decoration, Dynamic, Flooring, Furniture, Room, Scene
from solver.scene_bodies import storey_levels

ROUNDING_ERROR: Final = 1e-6
"""What is left of a wall between two ends that are one but for rounding is no wall, m."""


def describe(scene: Scene, catalogs: Catalogs, free: Freedom = "light", warnings: Sequence[str] = ()) -> HouseModel:
    """Describes a scene, with `warnings`, in words, to stand in the files; `free` is what a simulator may move.

    What it leaves unsaid is described as it is drawn: storeys one on another from 0 m, walls as high as `size` says, else 2.8 m.
    """
    storeys = storey_levels(scene)
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
        name=room.name,
    )


FREE_BELOW: Final = 15.0
"""What weighs less, kg, and neither hangs nor lies flat on a floor is free to move, unless its kind says otherwise. Our choice."""
FLAT: Final = 0.03
"""What is lower than this on a floor is walked on: a rug, a mat, m."""
USE_DISTANCE: Final = 0.45
"""How far before a side of use somebody stands, m: half of the 0.9 m that a side view of a person at work takes up."""
LEAST_MASS: Final = 0.01
_TURN_OF: Final[Mapping[Side, float]] = {"front": 0.0, "right": 90.0, "back": 180.0, "left": 270.0}
BodyOfScene = Furniture | Decoration | Dynamic


class BodyMaker:
    """Describes the bodies of one scene; `elevations` are those of its levels' floors, m, `free` is what a simulator may move."""

    def __init__(self, catalogs: Catalogs, paints: Paints, elevations: Mapping[int, float], free: Freedom = "light") -> None:
        self._book = book_of(catalogs)
        self._paints, self._elevations, self._free = paints, elevations, free
        self._alike: dict[tuple[Paint, ...], tuple[Paint, ...]] = {}
        """Each paints that were met as one object, so that equal ones are told by who they are."""
        self._known_assets = catalogs.assets
        self.assets: dict[str, Asset] = {}
        """The own assets that were met."""

    def bodies(self, scene: Scene) -> Iterator[ModelBody]:
        """Yields furniture and decorations room by room, then the people and pets that are in a room."""
        book = self._book
        for room in scene.rooms:
            for piece in room.furniture:
                key = book.kind_of("furniture", piece.name, (piece.width, piece.depth, piece.height), piece.kind)
                yield self._made(piece, "furniture", room, furniture_facts(book, piece.name, key, piece.category))
            hung = {item.id for item in room.decorations if item.mounted_on_wall}
            for item in room.decorations:
                key = book.kind_of("decoration", item.name, (item.width, item.depth, item.height), item.kind)
                yield self._made(item, "decoration", room, decoration_facts(book, item.name, key), item.id in hung)
        rooms = {room.id: room for room in scene.rooms}
        for person in scene.dynamic:
            if person.room in rooms:
                yield self._made(person, "dynamic", rooms[person.room], living_facts(book, person.kind, person.on is not None))

    def _made(self, body: BodyOfScene, sort: Sort, room: Room, facts: KindFacts, hung: bool = False) -> ModelBody:
        carrier = body.parent if isinstance(body, Decoration) else body.on
        width, depth, height = size = float(body.width), float(body.depth), float(body.height)
        sits = sort == "dynamic" and carrier is not None and facts.key
        asset = None if isinstance(body, Dynamic) else self._known_assets.get(body.asset or "")
        weighs, volume = (asset.mass, prod(asset.size)) if asset and asset.mass else (facts.mass, facts.volume)
        mass = max(LEAST_MASS, round(weighs * (1.0 if sits else width * depth * height / volume), 4))
        flat = sort == "decoration" and not carrier and not hung and body.y + height <= FLAT
        x, z = round(room.x + body.x, 6), round(room.z + body.z, 6)
        paints = paints_of_shape(self._book, facts.shape, self._paints, (body.color or facts.color, room.accent))
        return ModelBody(
            id=body.id,
            sort=sort,
            name=body.kind if isinstance(body, Dynamic) else body.name,
            kind=facts.key,
            category=facts.category,
            room=room.id,
            x=x,
            y=round(self._elevations.get(room.level, 0.0) + body.y, 6),
            z=z,
            turn=float(body.rotation),
            width=width,
            depth=depth,
            height=height,
            mass=mass,
            friction=facts.friction,
            parent=carrier,
            hung=hung,
            fixed=hung or flat or sort == "dynamic" or self._is_fixed(facts, mass),
            flat=flat,
            shape=facts.shape,
            parts=parts_of_shape(self._book, facts.shape, size),
            paints=self._alike.setdefault(paints, paints),
            labels=facts.labels,
            uses=_uses(facts, body, x, z) if facts.sides and sort == "furniture" else (),
            fronts=fronts_of_shape(self._book, facts.shape, size) if sort == "furniture" else (),
            asset=self._shown_as(body, asset),
        )

    def _shown_as(self, body: BodyOfScene, asset: Asset | None) -> str | None:
        """Returns the name of the asset that a body is shown as, and keeps the asset."""
        if asset is None or isinstance(body, Dynamic) or body.asset is None:
            return None
        self.assets[body.asset] = asset
        return body.asset

    def _is_fixed(self, facts: KindFacts, mass: float) -> bool:
        if self._free == "none" or facts.moves == "fixed":
            return True
        return self._free == "light" and mass >= FREE_BELOW and facts.moves != "free"


def _uses(facts: KindFacts, piece: BodyOfScene, x: float, z: float) -> tuple[tuple[float, float, float], ...]:
    """Returns from where a piece is used: (x, z) in the house, m, and the turn of somebody who faces it there."""
    found = []
    for side in facts.sides:
        turn = math.radians(piece.rotation + _TURN_OF[side])
        away = (piece.depth if side in ("front", "back") else piece.width) / 2 + USE_DISTANCE
        at = round(x + math.sin(turn) * away, 6), round(z + math.cos(turn) * away, 6)
        found.append((*at, (piece.rotation + _TURN_OF[side] + 180.0) % 360.0))
    return tuple(found)
