"""The frame in which a room's list is placed: a room that is turned or mirrored is the same room, so all of them are solved as one.

Of the ways to turn a room the one is taken whose walls, openings and pieces read least. Not here: what is placed.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, TypeVar

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect, to_mm
from solver.pieces import Arrangement, Placed
from solver.relations.subject import Kind
from solver.scene import WALLS, Decoration, Furniture, Opening, Room, Sides

_TURNED: Final = {"north": "east", "east": "south", "south": "west", "west": "north"}
"""Where a wall comes by a quarter turn clockwise, seen from above."""
_MIRRORED: Final = {"north": "north", "south": "south", "east": "west", "west": "east"}
_OTHER_END: Final = {"start": "end", "end": "start", None: None}
_SIZE: Final = re.compile(r"(\d+\.\d\d) x (\d+\.\d\d) m clear")
_WALL: Final = re.compile(r"\b(north|south|east|west)\b")
_LATTICE: Final = 1e-6
"""A room whose sides are off the whole millimetres by more, mm, stays as it is: its turned edges would be others."""
Standing = TypeVar("Standing", Furniture, Decoration)


@dataclass(frozen=True)
class SearchFrame:
    """How a room is turned for the search: mirrored from west to east first, if at all, then by so many quarters clockwise.

    Args:
        mirrored: whether west and east change places.
        quarters: 0 to 3.
        sides: width and depth of the room as it was sent, m.
    """

    mirrored: bool
    quarters: int
    sides: tuple[float, float]

    def room(self, room: Room) -> Room:
        """Returns the room as it is in the frame, its openings in the order of its walls."""
        width, depth = self.sides if self.quarters % 2 == 0 else self.sides[::-1]
        exterior = Sides(**{self._wall(wall): getattr(room.exterior_walls, wall) for wall in WALLS}) if room.exterior_walls else None
        openings = sorted((self._opening(one) for one in room.openings), key=_opening_key)
        return replace(
            room, width=width, depth=depth, exterior_walls=exterior, openings=tuple(openings),
            furniture=tuple(replace(self._body(one), wall=one.wall and self._wall(one.wall)) for one in room.furniture),
            decorations=tuple(
                replace(self._body(one), mounted_on_wall=one.mounted_on_wall and self._wall(one.mounted_on_wall))
                for one in room.decorations
            ),
        )  # fmt: skip

    def back(self, arrangement: Arrangement) -> Arrangement:
        """Returns an arrangement of the frame as it is in the room that was sent."""
        if not self.mirrored and not self.quarters:
            return arrangement
        placed = tuple(self._placed(one) for one in arrangement.placed)
        left_out = tuple((label, self._words(reason)) for label, reason in arrangement.left_out)
        return replace(arrangement, placed=placed, left_out=left_out)

    def _wall(self, wall: str) -> str:
        wall = _MIRRORED[wall] if self.mirrored else wall
        for _ in range(self.quarters):
            wall = _TURNED[wall]
        return wall

    def _opening(self, opening: Opening) -> Opening:
        width, depth = self.sides
        wall, position, hinge = opening.wall or "north", opening.position, opening.hinge
        if self.mirrored:
            if wall in ALONG_X:
                position, hinge = round(width - position, 6), _OTHER_END[hinge]
            wall = _MIRRORED[wall]
        for _ in range(self.quarters):
            if wall not in ALONG_X:
                position, hinge = round(depth - position, 6), _OTHER_END[hinge]
            wall, width, depth = _TURNED[wall], depth, width
        return replace(opening, wall=wall, position=position, hinge=hinge)

    def _body(self, body: Standing) -> Standing:
        (width, depth), x, z, rotation = self.sides, body.x, body.z, body.rotation
        if self.mirrored:
            x, rotation = width - x, -rotation
        for _ in range(self.quarters):
            x, z, width, depth = depth - z, x, depth, width
        return replace(body, x=round(x, 6), z=round(z, 6), rotation=(rotation - 90 * self.quarters) % 360)

    def _placed(self, placed: Placed) -> Placed:
        (x0, z0, x1, z1), rotation = placed.footprint, (placed.rotation + 90 * self.quarters) % 360
        width, depth = map(to_mm, self.sides if self.quarters % 2 == 0 else self.sides[::-1])
        for _ in range(self.quarters):
            x0, z0, x1, z1, width, depth = z0, width - x1, z1, width - x0, depth, width
        if self.mirrored:
            x0, x1, rotation = width - x1, width - x0, -rotation % 360
        return replace(placed, footprint=Rect(x0, z0, x1, z1), rotation=rotation, wall=placed.wall and self._wall_back(placed.wall))

    def _wall_back(self, wall: str) -> str:
        return next(own for own in WALLS if self._wall(own) == wall)

    def _words(self, text: str) -> str:
        """Returns a reason with the room's sides and walls as they were sent."""
        told = _SIZE.sub(r"\2 x \1 m clear", text) if self.quarters % 2 else text
        return _WALL.sub(lambda found: self._wall_back(found[0]), told)


def frame_of(room: Room, kinds: Iterable[Kind], tucked: Iterable[Kind], relations: Iterable[RelationSpec]) -> SearchFrame:
    """Returns the frame in which a room is solved.

    A room with an outline stays as it is. One is mirrored only where nothing says left or right: no relation, no use side and, where
    something reaches under another (`tucked`), no shape.
    """
    sides = (room.width, room.depth)
    lattice = all(abs(side * 1000 - to_mm(side)) < _LATTICE for side in sides)
    plain = room.outline is None and all(one.wall is not None and one.edge is None for one in room.openings)
    if not lattice or not plain:
        return SearchFrame(False, 0, sides)
    handed = any(("left" in kind.use_sides) != ("right" in kind.use_sides) for kind in kinds)
    handed |= any(map(_is_lopsided, tucked)) or any(len({"left", "right"} & set(spec.sides)) == 1 for spec in relations)
    ways = [SearchFrame(mirrored, quarters, sides) for mirrored in ((False,) if handed else (False, True)) for quarters in range(4)]
    return min(ways, key=lambda frame: _room_key(frame.room(room)))


def _is_lopsided(kind: Kind) -> bool:
    """Tells whether a kind's shape is not its own mirror image."""
    parts = {(part.rect, part.low, part.high) for part in kind.parts}
    mirrored = {(Rect(-part.rect.x1, part.rect.z0, -part.rect.x0, part.rect.z1), part.low, part.high) for part in kind.parts}
    return parts != mirrored


def _opening_key(opening: Opening) -> tuple[Any, ...]:
    hung = (opening.hinge or "", opening.swing or "", opening.main_entrance)
    return WALLS.index(opening.wall or "north"), opening.position, opening.kind, opening.width, opening.height, opening.sill, hung


def _room_key(room: Room) -> tuple[Any, ...]:
    """Returns what tells a room from its turned and mirrored selves."""
    bodies: Sequence[Furniture | Decoration] = (*room.furniture, *room.decorations)
    exterior = [getattr(room.exterior_walls, wall) for wall in WALLS] if room.exterior_walls else []
    poses = [(body.x, body.z, body.rotation, body.width, body.depth, body.height) for body in bodies]
    return room.width, room.depth, [_opening_key(one) for one in room.openings], poses, exterior
