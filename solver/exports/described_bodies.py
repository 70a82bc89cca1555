"""The bodies of a scene in house coordinates, with what they are made of, what they weigh and how they are used."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from math import prod
from typing import Final

from catalogs import Catalogs
from catalogs.assets.asset_entry import Asset
from catalogs.entries import Side
from solver.body_parts import BodyPart
from solver.export_formats import Freedom
from solver.exports.kind_facts import (
    KindFacts,
    book_of,
    decoration_facts,
    fronts_of_shape,
    furniture_facts,
    living_facts,
    paints_of_shape,
    parts_of_shape,
    unit_shape,
)
from solver.exports.model import ModelBody, Paint, Sort
from solver.exports.paints import Paints
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene

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
        self._parts: dict[tuple[str, tuple[float, float, float]], tuple[BodyPart, ...]] = {}
        self._painted: dict[tuple[str, str | None, str | None], tuple[Paint, ...]] = {}
        self._alike: dict[tuple[Paint, ...], tuple[Paint, ...]] = {}
        """Each paints that were met as one object, so that equal ones are told by who they are."""
        self._known_assets = catalogs.assets
        self.assets: dict[str, Asset] = {}
        """The own assets that were met."""
        self.unit_shapes: dict[str, tuple[BodyPart, ...]] = {}
        """The parts of each shape that was met, as shares of a body's box."""

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
        width, depth, height = size = body.width, body.depth, body.height
        sits = sort == "dynamic" and carrier is not None and facts.key
        asset = None if isinstance(body, Dynamic) else self._known_assets.get(body.asset or "")
        weighs, volume = (asset.mass, prod(asset.size)) if asset and asset.mass else (facts.mass, facts.volume)
        mass = max(LEAST_MASS, round(weighs * (1.0 if sits else width * depth * height / volume), 4))
        flat = sort == "decoration" and not carrier and not hung and body.y + height <= FLAT
        x, z = round(room.x + body.x, 6), round(room.z + body.z, 6)
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
            turn=body.rotation,
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
            parts=self._parts_of(facts.shape, size),
            paints=self._paints_of(facts.shape, body.color or facts.color, room.accent),
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

    def _parts_of(self, shape: str, size: tuple[float, float, float]) -> tuple[BodyPart, ...]:
        made = self._parts.get((shape, size))
        if made is None:
            if shape not in self.unit_shapes:
                self.unit_shapes[shape] = unit_shape(self._book, shape)
            made = self._parts[shape, size] = parts_of_shape(self._book, shape, size)
        return made

    def _paints_of(self, shape: str, color: str | None, accent: str | None) -> tuple[Paint, ...]:
        key = shape, color, accent
        made = self._painted.get(key)
        if made is None:
            found = paints_of_shape(self._book, shape, self._paints, (color, accent))
            made = self._painted[key] = self._alike.setdefault(found, found)
        return made


def _uses(facts: KindFacts, piece: BodyOfScene, x: float, z: float) -> tuple[tuple[float, float, float], ...]:
    """Returns from where a piece is used: (x, z) in the house, m, and the turn of somebody who faces it there."""
    found = []
    for side in facts.sides:
        turn = math.radians(piece.rotation + _TURN_OF[side])
        away = (piece.depth if side in ("front", "back") else piece.width) / 2 + USE_DISTANCE
        at = round(x + math.sin(turn) * away, 6), round(z + math.cos(turn) * away, 6)
        found.append((*at, (piece.rotation + _TURN_OF[side] + 180.0) % 360.0))
    return tuple(found)
