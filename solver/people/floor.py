"""What a furnished room leaves to people: free floor, ways to keep open, seats, and things to look at.

Comes in: a room, its space, the catalogs. Goes out: a `Floor`. May import: the ground floor, catalogs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final

from catalogs import Catalogs
from catalogs.schema import Furniture as Kind
from solver.free_places import Solid, footprint, nearest_place, solid_of
from solver.geometry import Rect, half_m, wall_faced
from solver.scene import Decoration, Dynamic, Furniture, Room
from solver.wanted import Space
from solver.ways import EVERY_SIDE, HEADROOM, Goal, Ways

BODY: Final = 0.02
"""What is no higher is a rug or a mat, on which one stands, m (contract)."""


@dataclass
class Floor:
    """The floor of one room, and who has come to stand on it.

    Args:
        room: furnished.
        space: its clear rectangle and doorways.
        catalogs: which sides of pieces are used.
    """

    room: Room
    space: Space
    catalogs: Catalogs

    def __post_init__(self) -> None:
        """Collects what nobody can be in, what stands in the way of walking, and what must stay within reach."""
        things: list[Furniture | Decoration] = [*self.room.furniture, *self.room.decorations]
        self.solids = [Solid(zone.rect, -math.inf, math.inf) for zone in self.space.zones if zone.above_mm < 0]
        self.solids += [solid_of(thing) for thing in things if thing.height > BODY]
        loose = [thing for thing in self.room.decorations if thing.parent is None and thing.mounted_on_wall is None and thing.y == 0]
        standing: list[Furniture | Decoration] = [piece for piece in self.room.furniture if piece.y < HEADROOM]
        in_the_way = [footprint(thing) for thing in (*standing, *loose) if thing.height > BODY]
        named = self.catalogs.kinds_by_name()
        goals = [goal for piece in self.room.furniture if (goal := _use(piece, named.get(piece.name)))]
        self.ways = Ways(self.space, in_the_way, goals)
        self.people: list[Dynamic] = []

    def add(self, person: Dynamic) -> None:
        """Notes that somebody is there."""
        self.people.append(person)
        self.solids.append(solid_of(person))

    def near(self, person: Dynamic, gap_mm: int) -> Dynamic | None:
        """Returns somebody at the free place nearest to the pose, with a gap all around, or None where there is none."""
        own = solid_of(person)
        blocks = [solid.rect for solid in self.solids if not solid.beside(own)]
        found = nearest_place(own.rect.shrunk(-gap_mm), self.space.clear, blocks)
        return replace(person, x=half_m(found.x0 + found.x1), z=half_m(found.z0 + found.z1)) if found else None

    def leaves_all_reachable(self, person: Dynamic) -> bool:
        """Tells whether everything stays within reach with somebody there on the floor, and so are all who stand."""
        standing = [footprint(other) for other in (*self.people, person) if other.on is None]
        return self.ways.open(standing, [Goal(rect, EVERY_SIDE) for rect in standing])

    def front_reachable(self, piece: Furniture) -> bool:
        """Tells whether one can come to a piece's front, those who stand there being in the way."""
        standing = [footprint(other) for other in self.people if other.on is None]
        return self.ways.open(standing, [Goal(footprint(piece), (side_of(piece, "front"),))])

    def is_free(self, solid: Solid, but: frozenset[str]) -> bool:
        """Tells whether a space is empty, some bodies of the room aside (ids)."""
        bodies: list[Furniture | Decoration | Dynamic] = [*self.room.furniture, *self.room.decorations, *self.people]
        taken = [solid_of(body) for body in bodies if body.height > BODY and body.id not in but]
        return not any(solid.rect.overlaps(other.rect) and not solid.beside(other) for other in taken)


def side_of(piece: Furniture, side: str) -> str:
    """Returns the wall that a side of a piece looks to."""
    return wall_faced(side, piece.rotation)


def rect_between(a: tuple[int, int], b: tuple[int, int]) -> Rect:
    """Returns the rectangle with two opposite corners."""
    return Rect(min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]))


def _use(piece: Furniture, kind: Kind | None) -> Goal | None:
    if kind is None or kind.use is None:
        return None
    return Goal(footprint(piece), tuple(side_of(piece, side) for side in kind.use.sides), kind.use.need == "all")
