"""What a relation is: one class a word of the vocabulary, which says where the relation holds and whether it does.

A relation answers two questions here. `regions` and `boxes`: where does it hold, in the room or in another piece's frame?
`holds_in_room` and `holds_with`: does it hold in a finished room? What a room type that wishes for it, by degree, makes of a piece's
candidates, its class in solver/core/furnish/relations says. docs/relations.md tells what each word means to those who write it.
"""

import math
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from catalogs.relation_keys import OPENINGS
from catalogs.schema import RelationSpec
from solver.geometry import OPPOSITE, Rect, rotate, to_mm, turned
from solver.pieces import Link
from solver.relations.subject import Footing, Scope

LeastMost = tuple[float, float]
"""The least and the greatest of a coordinate, mm."""
Box = tuple[LeastMost, LeastMost]
"""Where a centre may lie in another piece's frame, from that one's centre: across (right +x) and along (front +z)."""
ANYWHERE: LeastMost = (-100_000, 100_000)
NEAR_PULL, ALIGN_PULL = 0.2, 0.5
"""Weights, m^-2, of the pulls towards a piece that a relation asked for names."""


class Tolerance(NamedTuple):
    """How exactly a relation is meant.

    Still there is what is `nearly_mm` from a corner or a middle, `flush_mm` out of line with another's back or front, `inside_mm` inside
    any other bound; two pieces side by side share at least this part of the shorter one's length (`shared`).
    """

    nearly_mm: int
    flush_mm: int
    inside_mm: int
    shared: float


EXACT = Tolerance(0, 0, 0, 1.0)
"""What looks best: the places of room types."""
SOUGHT = Tolerance(80, 0, 6, 0.5)
"""Where a piece is sent so that it surely holds: a little inside what holds."""
HELD = Tolerance(100, 100, 0, 0.5)
"""What holds in a finished room."""
GAP_MM = 20
"""How far a free space between two pieces may be from the one that is asked for."""
AT_WALL_MM = 50
"""A piece whose back is at most this far from a wall's face stands at that wall."""


class Fit(NamedTuple):
    """A relation between two pieces: the other's width and depth, the own extents and rotation in the other's frame, mm.

    In `blocked` the own centre must not be: there parts of the two would cross.
    """

    spec: RelationSpec
    parent: tuple[int, int]
    own: tuple[int, int]
    turn: int
    tolerance: Tolerance = SOUGHT
    blocked: tuple[Rect, ...] = ()

    @property
    def reach(self) -> tuple[float, float]:
        """How far apart the centres are where the pieces touch, across and along."""
        return (self.parent[0] + self.own[0]) / 2, (self.parent[1] + self.own[1]) / 2

    @property
    def spare(self) -> int:
        """What is added to a least distance that is sought: halves of odd extents are rounded."""
        return min(1, self.tolerance.inside_mm)


@dataclass(frozen=True)
class Standing:
    """A body as it stands in a finished room: its footprint, mm, rotation, underside, the wall at its back, what carries it.

    `levels` are the heights of its surfaces above the floor, mm.
    """

    id: str
    rect: Rect
    rotation: int
    bottom: int = 0
    wall: str | None = None
    on: str | None = None
    levels: tuple[int, ...] = ()

    @property
    def double_centre(self) -> tuple[int, int]:
        """Twice its centre (x, z), mm: exact."""
        return self.rect.x0 + self.rect.x1, self.rect.z0 + self.rect.z1

    def offset_from(self, other: "Standing") -> tuple[int, int]:
        """Returns twice the way from the other's centre to its own, across and along in the other's frame, mm."""
        (x, z), (other_x, other_z) = self.double_centre, other.double_centre
        return rotate(x - other_x, z - other_z, -other.rotation)


class Relation:
    """One word of the vocabulary; this one says nothing and never holds, the others override what they mean."""

    gives_place: ClassVar[bool] = False
    """It places a piece at another one; who is there has what it needs from it."""
    by_degree: ClassVar[bool] = False
    """It may well hold for a piece that is placed without thinking of it."""
    turns: ClassVar[bool] = False
    """Which way round the piece stands decides whether it holds."""
    with_all: ClassVar[bool] = False
    """To several, it holds only with all of them."""
    among_copies: ClassVar[bool] = False
    """It may hold between the copies of one piece."""
    at_walls: ClassVar[bool] = False
    """It makes a piece stand with its back at a wall that would not do so by itself."""

    into_line: ClassVar[bool] = False
    """It draws the middle of the piece into line with that of the other, not near it."""
    about: ClassVar[tuple[str, ...]] = ()
    """The kinds of openings it is about, where it does not name them."""

    def openings(self, spec: RelationSpec) -> tuple[str, ...]:
        """Returns the kinds of openings it is about."""
        return self.about or tuple(name for name in spec.of if name in OPENINGS)

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """Returns the rectangles in any of which a footprint holds the relation to the room; none where it cannot hold so."""
        return []

    def boxes(self, fit: Fit) -> list[Box]:
        """Returns the boxes in any of which a centre holds the relation to another piece, in that one's frame; best first."""
        return []

    def suits(self, spec: RelationSpec, mine: str | None, theirs: str | None) -> bool:
        """Tells whether the walls at the backs of two pieces lie as the relation wants them."""
        if spec.wall is None:
            return True
        if mine is None or theirs is None:
            return False
        found = "same" if mine == theirs else "opposite" if OPPOSITE[mine] == theirs else "adjacent"
        return found == spec.wall or (spec.wall == "other" and found != "same")

    def holds_in_room(self, scope: Scope, spec: RelationSpec, own: Standing) -> bool:
        """Tells whether the relation to the room, or to any opening of the scope, holds."""
        footing = Footing(own.rotation, own.wall, (own.rect.width, own.rect.depth), own.rect)
        return any(rect.contains(own.rect) for rect in self.regions(scope, spec, footing, HELD))

    def holds_with(self, spec: RelationSpec, own: Standing, other: Standing) -> bool:
        """Tells whether the relation to another piece holds, its `wall` left aside."""
        extent = own.rect.width, own.rect.depth
        parent = turned(other.rect.width, other.rect.depth, other.rotation)
        fit = Fit(spec, parent, turned(*extent, other.rotation), (own.rotation - other.rotation) % 360, HELD)
        across, along = own.offset_from(other)
        return any(2 * x0 <= across <= 2 * x1 and 2 * z0 <= along <= 2 * z1 for (x0, x1), (z0, z1) in self.boxes(fit))

    def pulls(self, spec: RelationSpec, labels: list[str]) -> list[Link]:
        """Returns weak pulls towards the pieces named, for a piece that is not placed at one of them."""
        near, align = (0.0, ALIGN_PULL) if self.into_line else (NEAR_PULL, 0.0)
        return [Link(spec.type, labels[0], near=near, align=align)]


def missed(spec: RelationSpec) -> float:
    """Returns what doing without a relation costs: everything, where it is hard."""
    return math.inf if spec.required else spec.cost


def distance_mm(spec: RelationSpec, default: int) -> int:
    """Returns the distance a relation wishes, mm."""
    return default if spec.distance is None else to_mm(spec.distance)
