"""One room of a scene, to be repaired: what was sent, where it may stand, and on what terms."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf

from catalogs import Catalogs
from solver.answers import Issue, Pose
from solver.geometry import INWARDS, Rect, strip_at
from solver.pieces import Space
from solver.scene import Decoration, Furniture, Room


@dataclass(frozen=True)
class RepairSettings:
    """What holds for every room of a scene that is repaired.

    Args:
        catalogs: whose kinds and room types are known.
        locked: ids that stay to the millimetre, besides the pieces that say so themselves.
        moved: ids that are held most strongly.
        walk: whether the ways to use sides are kept free.
        remove: whether what cannot stand is taken out, and not only named.
        previous: poses of the last answer, by id.
        work: what each attempt at a room may cost, in QPs of a small room.
        explaining_work: what saying why not may cost a room, in QPs of a small room; it changes nothing, so broken rooms alone
            share it.
        offering: whether what would help is looked for.
    """

    catalogs: Catalogs
    locked: frozenset[str] = frozenset()
    moved: frozenset[str] = frozenset()
    walk: bool = True
    remove: bool = False
    previous: Mapping[str, Pose] = field(default_factory=dict)
    work: float = 0.0
    explaining_work: float = 0.0
    offering: bool = True

    def is_locked(self, body: Furniture | Decoration) -> bool:
        """Tells whether a body must stay exactly as sent."""
        return body.id in self.locked or (isinstance(body, Furniture) and body.locked)

    @cached_property
    def required_names(self) -> frozenset[str]:
        """Names that some room type requires; they are more important than others."""
        return frozenset(name for room in self.catalogs.rooms.values() for either in room.requires for name in either)

    @cached_property
    def use_sides(self) -> Mapping[str, tuple[Sequence[str], bool]]:
        """From which sides pieces are used and whether all of them must be reached, by name; none where nobody walks."""
        return self.catalogs.use_sides() if self.walk else {}

    @cached_property
    def wall_names(self) -> frozenset[str]:
        """Names of the pieces that stand at walls."""
        return frozenset(name for name, kind in self.catalogs.kinds_by_name().items() if kind.stands == "wall")


Edge = tuple[str, int, int, int]
"""A stretch of wall line: the wall it is part of, its coordinate across, and its ends along, mm."""


@dataclass(frozen=True)
class Walls:
    """The walls of a room, mm: half their thickness, the wall lines, and the rectangle around these, half a wall in (`clear`)."""

    clear: Rect
    half_mm: int
    edges: tuple[Edge, ...]

    @property
    def inner(self) -> list[Edge]:
        """The wall lines of an outline that are not on its bounding rectangle."""
        bounds = self.clear.shrunk(-self.half_mm)
        return [edge for edge in self.edges if edge[1] != bounds.line(edge[0]) and edge[2] < edge[3]]

    def before(self, edge: Edge, deep: int) -> Rect:
        """Returns the rectangle before a stretch of wall, from its face on, `deep` mm into the room."""
        wall, line, start, end = edge
        return strip_at(wall, line + INWARDS[wall] * self.half_mm, (start, end), deep)


@dataclass(frozen=True)
class RoomProblem:
    """A room to be repaired, as sent: where its furniture may stand, at which walls, and what the validator says of it.

    `settings` say what stays, what was moved, where all was in the last answer, and what the repair may cost. `ceiling` is how high it is,
    m; without end where nothing says it, and outdoors.
    """

    room: Room
    space: Space
    walls: Walls
    settings: RepairSettings
    errors: tuple[Issue, ...] = ()
    ceiling: float = inf
