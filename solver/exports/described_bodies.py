"""The bodies of a scene in house coordinates, with what they are made of, what they weigh and how they are used.

Comes in: a scene, catalogs. Goes out: `ModelBody`s. May import: the ground floor, the model, catalogs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.dressing import DecorationKind
from catalogs.entries import Side
from catalogs.kind_book import KindBook
from catalogs.schema import FurnitureSpec
from solver.body_parts import BodyPart, sized, unit_parts
from solver.export_formats import Freedom
from solver.exports.model import ModelBody, Paint, Sort
from solver.exports.paints import UNSAID, Paints
from solver.scene import Decoration, Dynamic, Furniture, Room, Scene

FREE_BELOW: Final = 15.0
"""What weighs less, kg, and neither hangs nor lies flat on a floor is free to move, unless its kind says otherwise. Our choice."""
FLAT: Final = 0.03
"""What is lower than this on a floor is walked on: a rug, a mat, m."""
USE_DISTANCE: Final = 0.45
"""How far before a side of use somebody stands, m: half of the 0.9 m that a side view of a person at work takes up."""
UNKNOWN_DENSITY: Final = 120.0
"""What a thing weighs by its box that the catalogs do not know, kg/m3: the middle of our furniture."""
LEAST_MASS: Final = 0.01
LIVING: Final = "dynamic"
"""The category of people and pets."""
FRICTION: Final = {"low": 0.3, "medium": 0.6, "high": 0.9}
"""Coefficients of dry friction: polished or on castors; wood, plastic; rubber, cloth."""
_TURN_OF: Final[Mapping[Side, float]] = {"front": 0.0, "right": 90.0, "back": 180.0, "left": 270.0}


class _Kind(NamedTuple):
    """What is known of a body's kind: its key, what the catalogs say, under which key its shape is, and its category."""

    key: str | None
    spec: FurnitureSpec | DecorationKind | None
    shape: str
    category: str


class BodyMaker:
    """Describes the bodies of one scene.

    Args:
        catalogs: the kinds, shapes and materials.
        paints: those of the house's style.
        elevations: the height of each level's floor, m.
        free: what a simulator may move: nothing, light things that stand, or all that stands.
    """

    def __init__(self, catalogs: Catalogs, paints: Paints, elevations: Mapping[int, float], free: Freedom = "light") -> None:
        self._catalogs, self._paints, self._elevations, self._free = catalogs, paints, elevations, free
        self._book = KindBook(catalogs)
        self._parts: dict[tuple[str, float, float, float], tuple[BodyPart, ...]] = {}
        self._painted: dict[tuple[str, str | None, str | None], tuple[Paint, ...]] = {}
        self._alike: dict[tuple[Paint, ...], tuple[Paint, ...]] = {}
        """Each paints that were met as one object, so that equal ones are told by who they are."""
        self.unit_shapes: dict[str, tuple[BodyPart, ...]] = {}
        """The parts of each shape that was met, as shares of a body's box."""

    def bodies(self, scene: Scene) -> Iterator[ModelBody]:
        """Yields furniture and decorations room by room, then the people and pets that are in a room."""
        for room in scene.rooms:
            hung = _hung(room)
            for piece in room.furniture:
                yield self._made(piece, "furniture", room, self._kind(piece, "furniture"))
            for item in room.decorations:
                yield self._made(item, "decoration", room, self._kind(item, "decoration"), item.id in hung)
        rooms = {room.id: room for room in scene.rooms}
        for person in scene.dynamic:
            if person.room in rooms:
                yield self._made(person, "dynamic", rooms[person.room], self._living(person))

    def _kind(self, body: Furniture | Decoration, sort: Sort) -> _Kind:
        key = self._book.kind_of(sort, body.name, (body.width, body.depth, body.height), body.kind)
        spec = self._book.spec(sort, key) if key else None
        if isinstance(body, Furniture):
            category = body.category or (spec.category if isinstance(spec, FurnitureSpec) else "misc")
        else:
            category = spec.group if isinstance(spec, DecorationKind) else "decor"
        return _Kind(key, spec, key or "", category)

    def _living(self, person: Dynamic) -> _Kind:
        spec = self._catalogs.furniture.get(person.kind)
        shape = self._book.living(person.kind, person.on is not None)
        return _Kind(person.kind if spec else None, spec, shape or "", LIVING)

    def _made(self, body: Furniture | Decoration | Dynamic, sort: Sort, room: Room, kind: _Kind, hung: bool = False) -> ModelBody:
        carrier = body.parent if isinstance(body, Decoration) else body.on
        mass = self._mass(body, kind.spec, sits=isinstance(body, Dynamic) and carrier is not None)
        flat = sort == "decoration" and not carrier and not hung and body.y + body.height <= FLAT
        x, z = round(room.x + body.x, 6), round(room.z + body.z, 6)
        return ModelBody(
            id=body.id,
            sort=sort,
            name=body.kind if isinstance(body, Dynamic) else body.name,
            kind=kind.key,
            category=kind.category,
            room=room.id,
            x=x,
            y=round(self._elevations.get(room.level, 0.0) + body.y, 6),
            z=z,
            turn=body.rotation,
            width=body.width,
            depth=body.depth,
            height=body.height,
            mass=mass,
            friction=FRICTION[kind.spec.friction if kind.spec else "medium"],
            parent=carrier,
            hung=hung,
            fixed=self._is_fixed(kind.spec, mass, hung or flat or sort == "dynamic"),
            flat=flat,
            shape=kind.shape,
            parts=self._parts_of(kind.shape, body.width, body.depth, body.height),
            paints=self._paints_of(kind.shape, body.color, room.accent),
            labels=self._labels(body, kind),
            uses=_uses(kind.spec, body, x, z) if isinstance(body, Furniture) else (),
        )

    def _mass(self, body: Furniture | Decoration | Dynamic, spec: FurnitureSpec | DecorationKind | None, sits: bool) -> float:
        """Returns a body's mass, kg: its kind's by the ratio of their boxes; somebody who sits weighs what they weigh."""
        volume = body.width * body.depth * body.height
        if spec is None:
            return max(LEAST_MASS, round(UNKNOWN_DENSITY * volume, 4))
        return max(LEAST_MASS, round(spec.mass * (1.0 if sits else volume / math.prod(spec.size)), 4))

    def _is_fixed(self, spec: FurnitureSpec | DecorationKind | None, mass: float, stays: bool) -> bool:
        if stays or self._free == "none" or (spec and spec.moves == "fixed"):
            return True
        return self._free == "light" and mass >= FREE_BELOW and not (spec and spec.moves == "free")

    def _parts_of(self, shape: str, width: float, depth: float, height: float) -> tuple[BodyPart, ...]:
        key = shape, width, depth, height
        made = self._parts.get(key)
        if made is None:
            if shape not in self.unit_shapes:
                self.unit_shapes[shape] = unit_parts(self._book.solids(shape))
            made = self._parts[key] = sized(self.unit_shapes[shape], width, depth, height)
        return made

    def _paints_of(self, shape: str, color: str | None, accent: str | None) -> tuple[Paint, ...]:
        key = shape, color, accent
        if key not in self._painted:
            parts = self.unit_shapes[shape]
            made = tuple(self._paints.of(part.material, color or UNSAID, accent) for part in parts)
            self._painted[key] = self._alike.setdefault(made, made)
        return self._painted[key]

    @staticmethod
    def _labels(body: Furniture | Decoration | Dynamic, kind: _Kind) -> tuple[str, ...]:
        """Returns the semantic labels of a body, the most particular first: kind, name, category, and what its kind adds."""
        name = body.kind if isinstance(body, Dynamic) else body.name
        return tuple(dict.fromkeys((*((kind.key,) if kind.key else ()), name, kind.category, *(kind.spec.labels if kind.spec else ()))))


def _hung(room: Room) -> set[str]:
    """Returns the ids of the decorations that hang on a wall."""
    return {item.id for item in room.decorations if item.mounted_on_wall}


def _uses(spec: FurnitureSpec | DecorationKind | None, piece: Furniture, x: float, z: float) -> tuple[tuple[float, float, float], ...]:
    """Returns from where a piece is used: (x, z) in the house, m, and the turn of somebody who faces it there."""
    if not isinstance(spec, FurnitureSpec) or spec.use is None:
        return ()
    found = []
    for side in spec.use.sides:
        turn = math.radians(piece.rotation + _TURN_OF[side])
        away = (piece.depth if side in ("front", "back") else piece.width) / 2 + USE_DISTANCE
        at = round(x + math.sin(turn) * away, 6), round(z + math.cos(turn) * away, 6)
        found.append((*at, (piece.rotation + _TURN_OF[side] + 180.0) % 360.0))
    return tuple(found)
