"""A scene as the rules see it: rooms with their floor, walls, openings and bodies, all in exact numbers.

Comes in: a scene. Goes out: a `World`. May import: scene.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final

from solver.scene import Decoration, Dynamic, Furniture, Opening, Room, Scene
from solver.validate.lattice import Box, Edge, Outline, exact, outline_of

SIDES: Final = ("south", "east", "north", "west")
"""Where a front looks after 0, 1, 2, 3 quarter turns."""
OPPOSITE: Final = {"north": "south", "south": "north", "east": "west", "west": "east"}
FLAT: Final = exact(0.02)
"""Rugs and mats: what is no higher is not a body (contract)."""
DOOR_KINDS: Final = ("door", "passage")
"""Openings whose square is kept free."""
WAYS: Final = ("door", "passage", "garage_door")
"""Openings one can walk through."""
DEFAULT_ROBOT: Final = 0.6


@dataclass(frozen=True)
class Body:
    """Something that takes up space: its footprint in its room, from `low` to `high`, and how many quarter turns it has made."""

    id: str
    name: str
    box: Box
    low: int
    high: int
    turns: int
    depth: int
    is_furniture: bool = False
    wall: str | None = None
    under: str | None = None
    on: str | None = None

    @property
    def front(self) -> str:
        """The side of the room that its front looks to."""
        return SIDES[self.turns]

    def side(self, name: str) -> str:
        """Returns where a side of the catalog (front, back, left = -x, right = +x, unrotated) looks in the room."""
        return SIDES[(self.turns + {"front": 0, "right": 1, "back": 2, "left": 3}[name]) % 4]


@dataclass(frozen=True)
class Hole:
    """An opening at its place: [start, end] along its edge, from `sill` to `top`."""

    opening: Opening
    edge: Edge
    start: int
    end: int
    sill: int
    top: int


@dataclass(frozen=True)
class Place:
    """A room: what the document says, its floor, holes and bodies (room-relative), and where it lies in the house."""

    room: Room
    x: int
    z: int
    outline: Outline
    holes: tuple[Hole, ...]
    bodies: tuple[Body, ...]

    @property
    def edges(self) -> Iterator[Edge]:
        """The pieces of its wall line."""
        return (edge for edge in self.outline.edges if edge is not None)


@dataclass(frozen=True)
class World:
    """A whole scene. `half_wall` is half a wall's thickness, `robot` the side of the square that walks."""

    scene: Scene
    half_wall: int
    robot: int
    places: tuple[Place, ...]

    @cached_property
    def by_id(self) -> Mapping[str, Place]:
        """The rooms by id."""
        return {place.room.id: place for place in self.places}

    @cached_property
    def leading_to(self) -> Mapping[str, Sequence[tuple[Place, Hole]]]:
        """Every opening, with the room that lists it, by the id of what it connects to."""
        found: dict[str, list[tuple[Place, Hole]]] = {}
        for place in self.places:
            for hole in place.holes:
                if hole.opening.connects_to is not None:
                    found.setdefault(hole.opening.connects_to, []).append((place, hole))
        return found


def world_of(scene: Scene) -> World:
    """Reads a scene into exact numbers."""
    people: dict[str | None, list[Dynamic]] = {}
    for person in scene.dynamic:
        people.setdefault(home_of(scene, person), []).append(person)
    places = tuple(_place(room, people.get(room.id, [])) for room in scene.rooms)
    return World(scene, exact(scene.wall_thickness) // 2, exact(_robot_width(scene)), places)


def home_of(scene: Scene, person: Dynamic) -> str | None:
    """Returns the id of the room that a person or pet says it is in; the only room's where it does not say."""
    return scene.rooms[0].id if person.room is None and len(scene.rooms) == 1 else person.room


def _robot_width(scene: Scene) -> float:
    asked = (scene.request or {}).get("robot_width")
    is_width = isinstance(asked, (int, float)) and not isinstance(asked, bool) and 0.1 <= asked <= 2.0
    return asked if is_width and asked is not None else DEFAULT_ROBOT


def _place(room: Room, people: Sequence[Dynamic]) -> Place:
    corners = room.outline or ((0.0, 0.0), (room.width, 0.0), (room.width, room.depth), (0.0, room.depth))
    outline = outline_of([(exact(x), exact(z)) for x, z in corners])
    holes = tuple(hole for opening in room.openings if (hole := _hole(opening, outline)) is not None)
    floor = [item for item in room.decorations if item.parent is None and item.mounted_on_wall is None and item.y == 0]
    items: list[Furniture | Decoration | Dynamic] = [*room.furniture, *floor, *people]
    bodies = [_body(item) for item in items]
    return Place(room, exact(room.x), exact(room.z), outline, holes, tuple(body for body in bodies if body.high - body.low > FLAT))


def _body(item: Furniture | Decoration | Dynamic) -> Body:
    x, z, width, depth = exact(item.x), exact(item.z), exact(item.width), exact(item.depth)
    across, along = extents(width, depth, item.rotation)
    more: dict[str, Any] = {"name": item.kind if isinstance(item, Dynamic) else item.name}
    if isinstance(item, Dynamic):
        more["on"] = item.on
    if isinstance(item, Furniture):
        more |= {"is_furniture": True, "wall": item.wall, "under": item.under, "on": item.on}
    return Body(
        id=item.id,
        box=Box(x - across // 2, z - along // 2, x + across // 2, z + along // 2),
        low=exact(item.y),
        high=exact(item.y) + exact(item.height),
        turns=round(item.rotation % 360 / 90) % 4,
        depth=depth,
        **more,
    )


def extents(width: int, depth: int, rotation: float) -> tuple[int, int]:
    """Returns a rotated footprint's extents along x and z: exact at right angles, else the bounding rectangle's, to the micrometre."""
    if rotation % 180 == 0:
        return width, depth
    if rotation % 180 == 90:
        return depth, width
    angle = math.radians(rotation % 360)
    cosine, sine = abs(math.cos(angle)), abs(math.sin(angle))
    return 4 * round((width * cosine + depth * sine) / 4), 4 * round((width * sine + depth * cosine) / 4)


def _hole(opening: Opening, outline: Outline) -> Hole | None:
    """Finds an opening's place; None where the document does not say in which wall it is."""
    centre, half, sill = exact(opening.position), exact(opening.width) // 2, exact(opening.sill)
    if opening.edge is not None:
        edge = outline.edges[opening.edge] if opening.edge < len(outline.edges) else None
        centre += edge.start if edge else 0
    else:
        edge = _edge_at(outline, opening.wall, centre)
    if edge is None:
        return None
    return Hole(opening, edge, centre - half, centre + half, sill, sill + exact(opening.height))


def _edge_at(outline: Outline, wall: str | None, position: int) -> Edge | None:
    """Returns the outermost piece of a wall at a position, or else the bounds' own line."""
    if wall is None:
        return None
    bounds = outline.bounds
    lines = {"north": bounds.z0, "south": bounds.z1, "west": bounds.x0, "east": bounds.x1}
    here = [edge for edge in outline.edges if edge and edge.side == wall and edge.start <= position <= edge.end]
    if not here:
        spans = (bounds.x0, bounds.x1) if wall in ("north", "south") else (bounds.z0, bounds.z1)
        return Edge(wall, lines[wall], *spans)
    return min(here, key=lambda edge: abs(edge.line - lines[wall]))
