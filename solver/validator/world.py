"""A scene as the rules see it: rooms with their floor, walls, openings and bodies, all in exact numbers.

Comes in: a scene. Goes out: a `World`. May import: scene.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Final

from solver.scene import Decoration, Dynamic, Furniture, Opening, Room, Scene, robot_width_of
from solver.validator.lattice import ExactBox, Outline, WallEdge, exact, outline_of

SIDES: Final = ("south", "east", "north", "west")
"""Where a front looks after 0, 1, 2, 3 quarter turns."""
OPPOSITE: Final = {"north": "south", "south": "north", "east": "west", "west": "east"}
FLAT: Final = exact(0.02)
"""Rugs and mats: what is no higher is not a body (docs/scene.md)."""
DOOR_KINDS: Final = ("door", "passage")
"""Openings whose square is kept free."""
WAYS: Final = ("door", "passage", "garage_door")
"""Openings one can walk through."""


@dataclass(frozen=True)
class PlacedBody:
    """Something that takes up space: its footprint in its room, from `low` to `high`, and how many quarter turns it has made."""

    id: str
    name: str
    box: ExactBox
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
    edge: WallEdge
    start: int
    end: int
    sill: int
    top: int


@dataclass(frozen=True)
class PlacedRoom:
    """A room: what the document says, its floor, holes and bodies (room-relative), and where it lies in the house."""

    room: Room
    x: int
    z: int
    outline: Outline
    holes: tuple[Hole, ...]
    bodies: tuple[PlacedBody, ...]

    @property
    def edges(self) -> Iterator[WallEdge]:
        """The pieces of its wall line."""
        return (edge for edge in self.outline.edges if edge is not None)


@dataclass(frozen=True)
class World:
    """A whole scene. `half_wall` is half a wall's thickness, `robot` the side of the square that walks."""

    scene: Scene
    half_wall: int
    robot: int
    places: tuple[PlacedRoom, ...]

    @cached_property
    def by_id(self) -> Mapping[str, PlacedRoom]:
        """The rooms by id."""
        return {place.room.id: place for place in self.places}

    @cached_property
    def leading_to(self) -> Mapping[str, Sequence[tuple[PlacedRoom, Hole]]]:
        """Every opening, with the room that lists it, by the id of what it connects to."""
        found: dict[str, list[tuple[PlacedRoom, Hole]]] = {}
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
    return World(scene, exact(scene.wall_thickness) // 2, exact(robot_width_of(scene)), places)


def home_of(scene: Scene, person: Dynamic) -> str | None:
    """Returns the id of the room that a person or pet says it is in; the only room's where it does not say."""
    return scene.rooms[0].id if person.room is None and len(scene.rooms) == 1 else person.room


def _place(room: Room, people: Sequence[Dynamic]) -> PlacedRoom:
    corners = room.outline or ((0.0, 0.0), (room.width, 0.0), (room.width, room.depth), (0.0, room.depth))
    outline = outline_of([(exact(x), exact(z)) for x, z in corners])
    holes = tuple(hole for opening in room.openings if (hole := _hole(opening, outline)) is not None)
    floor = [item for item in room.decorations if item.parent is None and item.mounted_on_wall is None and item.y == 0]
    items: list[Furniture | Decoration | Dynamic] = [*room.furniture, *floor, *people]
    bodies = [_body(item) for item in items]
    return PlacedRoom(room, exact(room.x), exact(room.z), outline, holes, tuple(body for body in bodies if body.high - body.low > FLAT))


def _body(item: Furniture | Decoration | Dynamic) -> PlacedBody:
    return PlacedBody(
        id=item.id,
        name=item.kind if isinstance(item, Dynamic) else item.name,
        box=box_of(item),
        low=exact(item.y),
        high=exact(item.y) + exact(item.height),
        turns=round(item.rotation % 360 / 90) % 4,
        depth=exact(item.depth),
        is_furniture=isinstance(item, Furniture),
        wall=item.wall if isinstance(item, Furniture) else None,
        under=item.under if isinstance(item, Furniture) else None,
        on=None if isinstance(item, Decoration) else item.on,
    )


def box_of(item: Furniture | Decoration | Dynamic) -> ExactBox:
    """Returns a body's footprint in its room."""
    x, z = exact(item.x), exact(item.z)
    across, along = _extents(exact(item.width), exact(item.depth), item.rotation)
    return ExactBox(x - across // 2, z - along // 2, x + across // 2, z + along // 2)


def _extents(width: int, depth: int, rotation: float) -> tuple[int, int]:
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


def _edge_at(outline: Outline, wall: str | None, position: int) -> WallEdge | None:
    """Returns the outermost piece of a wall at a position, or else the bounds' own line."""
    if wall is None:
        return None
    bounds = outline.bounds
    lines = {"north": bounds.z0, "south": bounds.z1, "west": bounds.x0, "east": bounds.x1}
    here = [edge for edge in outline.edges if edge and edge.side == wall and edge.start <= position <= edge.end]
    if not here:
        spans = (bounds.x0, bounds.x1) if wall in ("north", "south") else (bounds.z0, bounds.z1)
        return WallEdge(wall, lines[wall], *spans)
    return min(here, key=lambda edge: abs(edge.line - lines[wall]))
