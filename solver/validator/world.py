"""A scene as the rules see it: rooms with their floor, walls, openings and bodies, all in exact numbers."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, NamedTuple, TypeAlias

from solver.body_rows import KindKey, count_decorations, count_furniture, decoration_ids, furniture_ids, furniture_keys
from solver.records import MadeOnce, kept
from solver.scene import Decoration, Dynamic, Furniture, Opening, Room, Scene, robot_width_of
from solver.scene_bodies import home_of, said_height
from solver.validator.lattice import Outline, WallEdge, exact, outline_of

AnyBody: TypeAlias = Furniture | Decoration | Dynamic

SIDES: Final = ("south", "east", "north", "west")
"""Where a front looks after 0, 1, 2, 3 quarter turns."""
TURNS_TO: Final = {"front": 0, "right": 1, "back": 2, "left": 3}
"""How many quarter turns a side is from the front."""
FLAT: Final = exact(0.02)
"""Rugs and mats: what is no higher is not a body (docs/scene.md)."""
DOOR_KINDS: Final = ("door", "passage")
"""Openings whose square is kept free."""
WAYS: Final = ("door", "passage", "garage_door")
"""Openings one can walk through."""
_OPEN_SKY: Final = 1 << 60
"""As high as this is a room outdoors, and one whose height is not said."""
_EXACT: Final = MadeOnce[float, int](exact, 20_000)
"""Lengths of walls and openings, which are often met again."""


class Hole(NamedTuple):
    """An opening at its place: the piece of wall line that it is in, from `sill` to `top`."""

    opening: Opening
    edge: WallEdge
    sill: int
    top: int


@dataclass(frozen=True)
class PlacedRoom:
    """A room: what the document says, its floor, holes (room-relative) and people, where it lies in the house, and how high it is."""

    room: Room
    x: int
    z: int
    ceiling: int
    outline: Outline
    holes: tuple[Hole, ...]
    people: tuple[Dynamic, ...]

    @property
    def edges(self) -> Sequence[WallEdge]:
        """The pieces of its wall line."""
        return [edge for edge in self.outline.edges if edge is not None]

    @kept
    def keys(self) -> Sequence[KindKey]:
        """What the kind of each piece of furniture in it is looked up by."""
        return furniture_keys(self.room)

    @kept
    def bodies(self) -> tuple[AnyBody, ...]:
        """All that is in it: furniture, small things, people."""
        return (*self.room.furniture, *self.room.decorations, *self.people)

    @kept
    def ids(self) -> Sequence[str]:
        """The ids of all that is in it; the core's answers number it so."""
        return [*furniture_ids(self.room), *decoration_ids(self.room), *(one.id for one in self.people)]

    def count_bodies(self) -> int:
        """Returns how many bodies it has."""
        return count_furniture(self.room) + count_decorations(self.room) + len(self.people)


@dataclass(frozen=True)
class World:
    """A whole scene. `half_wall` is half a wall's thickness, `robot` the side of the square that walks."""

    scene: Scene
    half_wall: int
    robot: int
    places: tuple[PlacedRoom, ...]

    @kept
    def numbers(self) -> Mapping[str, tuple[int, int]]:
        """Of each room by id its storey, and its number there."""
        counts: Counter[int] = Counter()
        found = dict[str, tuple[int, int]]()
        for place in self.places:
            level = place.room.level
            found[place.room.id] = level, counts[level]
            counts[level] += 1
        return found

    @kept
    def leading_to(self) -> Mapping[str, Sequence[tuple[PlacedRoom, Hole]]]:
        """Every opening, with the room that lists it, by the id of what it connects to."""
        found: dict[str, list[tuple[PlacedRoom, Hole]]] = {}
        for place in self.places:
            for hole in place.holes:
                if hole.opening.connects_to is not None:
                    found.setdefault(hole.opening.connects_to, []).append((place, hole))
        return found

    @kept
    def walls_along(self) -> Mapping[tuple[int, str, int], Sequence[tuple[PlacedRoom, WallEdge]]]:
        """The walls of rooms, where they lie in the house, by storey, side and line."""
        found: dict[tuple[int, str, int], list[tuple[PlacedRoom, WallEdge]]] = {}
        for place in self.places:
            for edge in (edge.moved(place.x, place.z) for edge in place.edges):
                found.setdefault((place.room.level, edge.side, edge.line), []).append((place, edge))
        return found


def world_of(scene: Scene, before: World | None = None) -> World:
    """Reads a scene into exact numbers.

    `before` is a scene's that differs in bodies and people alone: its rooms' walls and openings are taken as they are.
    """
    people: dict[str | None, list[Dynamic]] = {}
    for person in scene.dynamic:
        people.setdefault(home_of(scene, person), []).append(person)
    inside = [tuple(people.get(room.id, ())) for room in scene.rooms]
    if before is not None:
        known = zip(before.places, scene.rooms, inside, strict=True)
        placed = tuple(
            was if room is was.room and crowd == was.people else replace(was, room=room, people=crowd) for was, room, crowd in known
        )
        return replace(before, scene=scene, places=placed)
    said = {level: said_height(scene, level) for level in {room.level for room in scene.rooms}}
    heights = {level: _OPEN_SKY if height is None else exact(height) for level, height in said.items()}
    places = tuple(_place(room, crowd, heights[room.level]) for room, crowd in zip(scene.rooms, inside, strict=True))
    return World(scene, exact(scene.wall_thickness) // 2, exact(robot_width_of(scene)), places)


def _place(room: Room, people: tuple[Dynamic, ...], height: int) -> PlacedRoom:
    outline = outline_of([(_EXACT[x], _EXACT[z]) for x, z in room.corners])
    holes = tuple(hole for opening in room.openings if (hole := _hole(opening, outline)) is not None)
    return PlacedRoom(room, exact(room.x), exact(room.z), _OPEN_SKY if room.outdoor else height, outline, holes, people)


def turns_of(rotation: float) -> int:
    """Returns how many quarter turns a rotation is, rounded: 0 to 3."""
    return round(rotation % 360 / 90) % 4


def side_of(rotation: float, name: str) -> str:
    """Returns where a side of the catalog (front, back, left = -x, right = +x, unrotated) of a body looks in the room."""
    return SIDES[(turns_of(rotation) + TURNS_TO[name]) % 4]


def _hole(opening: Opening, outline: Outline) -> Hole | None:
    """Finds an opening's place; None where the document does not say in which wall it is."""
    centre, half, sill = _EXACT[opening.position], _EXACT[opening.width] // 2, _EXACT[opening.sill]
    if opening.edge is not None:
        edge = outline.edges[opening.edge] if opening.edge < len(outline.edges) else None
        centre += edge.start if edge else 0
    else:
        edge = _edge_at(outline, opening.wall, centre)
    if edge is None:
        return None
    return Hole(opening, WallEdge(edge.side, edge.line, centre - half, centre + half), sill, sill + _EXACT[opening.height])


def _edge_at(outline: Outline, wall: str | None, position: int) -> WallEdge | None:
    """Returns the outermost piece of a wall at a position, or else the bounds' own line."""
    if wall is None:
        return None
    here = [edge for edge in outline.edges if edge and edge.side == wall and edge.start <= position <= edge.end]
    if len(here) == 1:
        return here[0]
    bounds = outline.bounds
    lines = {"north": bounds.z0, "south": bounds.z1, "west": bounds.x0, "east": bounds.x1}
    if not here:
        spans = (bounds.x0, bounds.x1) if wall in ("north", "south") else (bounds.z0, bounds.z1)
        return WallEdge(wall, lines[wall], *spans)
    return min(here, key=lambda edge: abs(edge.line - lines[wall]))
