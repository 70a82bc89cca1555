"""What every step of the floor plan speaks of: room rectangles, the walls they share, the sides that lie outside."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field
from functools import cache, cached_property, partial
from typing import Any, Final, NamedTuple

from solver.geometry import EDGES, OPPOSITE, Rect, gaps_between
from solver.scene import WALLS

LATTICE_MM: Final = 50
"""Lines are drawn on multiples of this."""
WALL_MM: Final = 100
"""Thickness of inner walls for which rooms' sizes between their lines are meant."""
CLEAR_HALLWAY_MM: Final = 1200
"""Clear width of a hallway."""
LEAF_MM: Final = 900
"""Width of a door."""
JAMB_MM: Final = 100
"""Least wall between an opening and the end of its stretch of wall."""
LEAST_JAMB_MM: Final = 50
"""Least jamb of an opening as wide as its wall allows: half a wall, or it would cut into the wall at the corner."""


class HouseWalls(NamedTuple):
    """How thick inner and outer walls are, how wide doors and hallways, mm; what that asks of a plan that is drawn by walls' lines."""

    thickness: int = WALL_MM
    outer: int = WALL_MM
    leaf: int = LEAF_MM
    clear_hallway: int = CLEAR_HALLWAY_MM
    latch: int = 0
    """Wall from a door's latch to the next wall's line, 0 where none is asked for."""

    @property
    def more(self) -> int:
        """By how much a room has to be longer between their lines than between walls of WALL_MM, mm."""
        return max(0, self.thickness - WALL_MM)

    @property
    def half(self) -> int:
        """What of a wall lies on one side of its line, mm."""
        return (self.thickness + 1) // 2

    @property
    def hallway(self) -> int:
        """Width of a hallway between wall lines, mm."""
        return -(-(max(self.clear_hallway, self.leaf + 2 * JAMB_MM) + self.thickness) // LATTICE_MM) * LATTICE_MM

    @property
    def jamb(self) -> int:
        """Least wall between an opening and the end of its stretch of wall, mm."""
        return max(JAMB_MM, self.half)

    @property
    def least_jamb(self) -> int:
        """The same of an opening as wide as its wall allows, mm."""
        return max(LEAST_JAMB_MM, self.half)

    @property
    def door_wall(self) -> int:
        """Shortest shared wall that takes a door, mm."""
        return max(LEAF_MM + 2 * self.jamb, self.leaf + self.least_jamb + max(self.least_jamb, self.latch))


USUAL_WALLS: Final = HouseWalls()


class Joint(NamedTuple):
    """A stretch of wall that two rooms share, long enough for a door.

    `a` < `b` are room indices, `wall` is the wall of `a`, `low` and `high` its ends along x (north, south) or z, mm.
    """

    a: int
    b: int
    wall: str
    low: int
    high: int

    @property
    def length(self) -> int:
        """Length of the shared wall, mm."""
        return self.high - self.low

    def other(self, room: int) -> int:
        """Returns the room on the other side."""
        return self.b if room == self.a else self.a


Stretches = tuple[tuple[int, int], ...]
"""Parts of a wall, as intervals along it, mm in the house."""


@dataclass(frozen=True)
class Layout:
    """Rectangles that make up the house: the first `hallways` of `rooms` are hallways.

    `outline` is the least rectangle around the house; where that is no rectangle itself, `exposed` tells what lies outside.
    `behind` names, for a room off every hallway, the room it was planned to lie behind.
    """

    outline: Rect
    rooms: tuple[Rect, ...]
    hallways: int = 0
    behind: Mapping[int, int] = field(default_factory=dict)
    corridors: tuple[Mapping[str, Any], ...] = ()
    notes: tuple[str, ...] = ()
    walls: HouseWalls = USUAL_WALLS

    @cached_property
    def met(self) -> list[tuple[int, int, str, int, int]]:
        """Every stretch of wall that two rooms share, as `touching` finds it."""
        return touching(self.rooms)

    @cached_property
    def exposed(self) -> tuple[Mapping[str, Stretches], ...]:
        """What of its walls lies outside, by room: walls in the order of WALLS, those without such a stretch left out."""
        return exposures(self)

    @cached_property
    def openable(self) -> tuple[Mapping[str, Stretches], ...]:
        """What of `exposed` openings may stand in: outer walls that are thicker than inner ones cover what they come forward beside."""
        by = self.walls.outer - self.walls.thickness
        if by <= 0:
            return self.exposed
        ahead, found = cache(partial(_ends_ahead, self.rooms)), []
        for rect, exposed in zip(self.rooms, self.exposed, strict=True):
            free = {wall: tuple(_beside_corners(stretches, ahead(rect.line(wall), wall), by)) for wall, stretches in exposed.items()}
            found.append({wall: stretches for wall, stretches in free.items() if stretches})
        return tuple(found)

    @property
    def spine(self) -> bool:
        """Tells whether the house has a hallway spine."""
        return self.hallways > 0


def exterior_sides(rect: Rect, outline: Rect) -> tuple[str, ...]:
    """Returns the walls of a part of a rectangular house that lie on its outline, in the order of WALLS."""
    return tuple([wall for wall, edge in EDGES.items() if rect[edge] == outline[edge]])


def exposures(layout: Layout) -> tuple[Mapping[str, Stretches], ...]:
    """Returns what of each room's walls no other room lies at, by room and wall, in the order of WALLS."""
    covered: list[dict[str, list[tuple[int, int]]]] = [{wall: [] for wall in WALLS} for _ in layout.rooms]
    for a, b, wall, low, high in layout.met:
        covered[a][wall].append((low, high))
        covered[b][OPPOSITE[wall]].append((low, high))
    found = []
    for rect, lain_at in zip(layout.rooms, covered, strict=True):
        free = {wall: tuple(gaps_between(rect.along(wall), blocked)) for wall, blocked in lain_at.items()}
        found.append({wall: stretches for wall, stretches in free.items() if stretches})
    return tuple(found)


def _beside_corners(stretches: Stretches, ahead: tuple[Set[int], Set[int]], by: int) -> Iterator[tuple[int, int]]:
    """Yields stretches of a wall, each so much shorter at an end where another room comes forward, beyond the wall's line."""
    starts, ends = ahead
    for low, high in stretches:
        first, last = low + by * (low in ends), high - by * (high in starts)
        if first < last:
            yield first, last


def _ends_ahead(rooms: Sequence[Rect], line: int, wall: str) -> tuple[Set[int], Set[int]]:
    """Returns where along a line the rooms that come forward there start, and where they end."""
    ahead = [room.along(wall) for room in rooms if _comes_forward(room, line, wall)]
    return {start for start, _ in ahead}, {end for _, end in ahead}


def _comes_forward(room: Rect, line: int, wall: str) -> bool:
    """Tells whether a room lies at a line and reaches beyond it, outwards as seen from a wall on it."""
    far, near = room.line(wall), room.line(OPPOSITE[wall])
    return far < line <= near if wall in ("north", "west") else near <= line < far


def touching(rooms: Sequence[Rect]) -> list[tuple[int, int, str, int, int]]:
    """Returns every stretch of wall two rooms share as (a, b, wall of a, low, high), a < b, sorted."""
    found: list[tuple[int, int, str, int, int]] = []
    norths: dict[int, list[tuple[int, int, int]]] = defaultdict(list)
    wests: dict[int, list[tuple[int, int, int]]] = defaultdict(list)
    for i, (x0, z0, x1, z1) in enumerate(rooms):
        norths[z0].append((i, x0, x1))
        wests[x0].append((i, z0, z1))
    for i, (x0, z0, x1, z1) in enumerate(rooms):
        for wall, opposite, start, end, others in (("south", "north", x0, x1, norths.get(z1)), ("east", "west", z0, z1, wests.get(x1))):
            for j, first, last in others or ():
                low, high = start if start > first else first, end if end < last else last  # no min, max: homes are judged by thousands
                if low < high:
                    found.append((i, j, wall, low, high) if i < j else (j, i, opposite, low, high))
    return sorted(found)


def joints(layout: Layout) -> tuple[Joint, ...]:
    """Returns the shared walls that are long enough for a door, sorted."""
    least = layout.walls.door_wall
    return tuple([Joint(*stretch) for stretch in layout.met if stretch[4] - stretch[3] >= least])


def set_apart(layout: Layout, outdoor: Sequence[bool]) -> tuple[Rect, ...]:
    """Returns the rooms as they are written: those outdoors begin where the outer wall of the house ends that they lie at.

    A wall grows outwards from its room's face: the lines of rooms on its two sides are apart by what it is thicker than inner walls.
    """
    more = layout.walls.outer - layout.walls.thickness
    if not more or not any(outdoor):
        return layout.rooms
    met = [stretch for stretch in layout.met if stretch[4] - stretch[3] > more]  # less is but the corner of another wall
    walls = {(a, wall) for a, b, wall, _, _ in met if outdoor[a] and not outdoor[b]}
    walls |= {(b, OPPOSITE[wall]) for a, b, wall, _, _ in met if outdoor[b] and not outdoor[a]}
    by = [{wall: more * ((room, wall) in walls) for wall in WALLS} for room in range(len(outdoor))]
    return tuple(
        Rect(rect.x0 + own["west"], rect.z0 + own["north"], rect.x1 - own["east"], rect.z1 - own["south"])
        for rect, own in zip(layout.rooms, by, strict=True)
    )


def trimmed(shared: Sequence[Joint], rects: Sequence[Rect], least: int) -> tuple[Joint, ...]:
    """Returns shared walls as far as both rooms, as they are written, lie along them; those that are long enough for a door."""
    found = []
    for joint in shared:
        low, high = (pick(rects[room].along(joint.wall)[end] for room in (joint.a, joint.b)) for end, pick in ((0, max), (1, min)))
        if high - low >= least:
            found.append(Joint(joint.a, joint.b, joint.wall, low, high))
    return tuple(found)


def neighbours(count: int, shared: tuple[Joint, ...]) -> list[list[Joint]]:
    """Returns each room's joints, by room index."""
    by_room: list[list[Joint]] = [[] for _ in range(count)]
    for joint in shared:
        by_room[joint.a].append(joint)
        by_room[joint.b].append(joint)
    return by_room
