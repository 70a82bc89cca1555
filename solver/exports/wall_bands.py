"""Rooms' edges in the house, and where the walls along them stand.

What lies between two rooms' faces is one wall, an outer wall has its own thickness. A room's face lies half the scene's thickness
inside its line. Two rooms whose lines lie apart have a wall that is thicker by as much.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, Literal, NamedTuple

from solver.demanded import demand
from solver.geometry import ALONG_X, walls_round
from solver.scene import Room

PlanAxis = Literal["x", "z"]
Line = tuple[int, PlanAxis, float]
"""A level, an axis and the coordinate across it."""


class OutlineEdge(NamedTuple):
    """One edge of a room's outline in the house, m; `inward` is 1 where the room lies towards greater coordinates.

    `number` counts the room's edges; `thickness` is that of its wall, once it is known.
    """

    line: Line
    start: float
    end: float
    inward: Literal[1, -1]
    side: str
    room: Room
    number: int = 0
    thickness: float = 0.0


def on_lattice(metres: float) -> float:
    """Rounds to whole millimetres, which undoes what adding metres in binary does."""
    return round(metres * 1000) / 1000


def edges_of(room: Room) -> list[OutlineEdge]:
    """Returns a room's edges in the order of its outline's points: north, east, south, west for a rectangle."""
    made = []
    for number, (side, across, low, high) in enumerate(walls_round(room.corners)):
        along_x = side in ALONG_X
        along, aside = (room.x, room.z) if along_x else (room.z, room.x)
        line: Line = (room.level, "x" if along_x else "z", on_lattice(aside + across))
        inward: Literal[1, -1] = 1 if side in ("north", "west") else -1
        made.append(OutlineEdge(line, on_lattice(along + low), on_lattice(along + high), inward, side, room, number))
    return made


THICKEST: Final = 0.6
"""How far apart the lines of two rooms may be that have a wall in common, m."""
NEGLIGIBLE: Final = 1e-6
THINNEST: Final = 0.02
"""Scenes that say no thickness have walls of none; a wall must still be seen."""
EDGE_WORK: Final = 0.2
"""What looking at an edge counts; measured."""
FACING_WORK: Final = 1.0
"""What finding out whether an edge faces another counts; measured."""
_Stretch = tuple[float, float, float | None]
"""From, to, and how far the line of the room on the other side is away; None where there is none, m."""


class WallBands:
    """The walls along the edges of a house's rooms; `thickness` is the scene's, m."""

    def __init__(self, rooms: Sequence[Room], thickness: float) -> None:
        self.thickness = thickness
        self.by_room = [edges_of(room) for room in rooms]
        self.edges = [edge for edges in self.by_room for edge in edges]
        self._facing: dict[tuple[int, PlanAxis, int], list[OutlineEdge]] = defaultdict(list)
        for edge in sorted(self.edges, key=_line):
            level, axis, _ = edge.line
            self._facing[level, axis, edge.inward].append(edge)

    def pieces(self, edge: OutlineEdge) -> list[OutlineEdge]:
        """Returns an edge cut where its wall changes, each piece on its wall's middle line with its thickness."""
        (level, axis, line), out = edge.line, -edge.inward
        near, own = self._near(edge), self._own(edge)
        if own == self.thickness and not (near and near[-1][0] > NEGLIGIBLE):
            return [edge._replace(thickness=self.thickness)]
        made = []
        for low, high, apart in _filled(_stretches(edge, near)):
            thickness = own if apart is None else round(self.thickness + apart, 6)
            middle = line if thickness == self.thickness else round(line + out * (thickness - self.thickness) / 2, 6)
            made.append(edge._replace(line=(level, axis, middle), start=low, end=high, thickness=thickness))
        return made

    def _near(self, edge: OutlineEdge) -> list[tuple[float, float, float]]:
        """Returns the edges on the other side of an edge's wall: how far away, from, to, the nearest first."""
        line, out = edge.line[2], -edge.inward
        return sorted(
            (gap, other.start, other.end)
            for other in self._across(edge)
            if other.room is not edge.room
            and -NEGLIGIBLE <= (gap := (other.line[2] - line) * out) <= THICKEST + NEGLIGIBLE
            and min(edge.end, other.end) - max(edge.start, other.start) > NEGLIGIBLE
        )

    def _across(self, edge: OutlineEdge) -> Sequence[OutlineEdge]:
        """Returns the edges that face an edge, and whose lines lie no farther outside of its own than a wall is thick."""
        (level, axis, line), out = edge.line, -edge.inward
        facing, farthest = self._facing[level, axis, out], line + out * THICKEST
        low, high = min(line, farthest) - 2 * NEGLIGIBLE, max(line, farthest) + 2 * NEGLIGIBLE
        found = facing[bisect_left(facing, low, key=_line) : bisect_right(facing, high, key=_line)]
        demand(FACING_WORK * len(found))
        return found

    def at(self, edge: OutlineEdge, along: float) -> OutlineEdge:
        """Returns the piece of an edge at a coordinate along it."""
        pieces = self.pieces(edge)
        return next((one for one in pieces if along <= one.end), pieces[-1])

    def own(self, room: Room) -> tuple[float | None, ...]:
        """Returns how thick a room's outer walls are, m, by edge: None where it does not say and between rooms, none at all if always."""
        said = room.wall_thickness or ()
        found = tuple(said[edge.number] if edge.number < len(said) and self._is_outer(edge) else None for edge in edges_of(room))
        return found if any(one is not None for one in found) else ()

    def _is_outer(self, edge: OutlineEdge) -> bool:
        near = self._near(edge)
        return any(gap is None for _, _, gap in _filled(_stretches(edge, near)))

    def bridges(self) -> set[tuple[int, PlanAxis, float, float]]:
        """Returns what the walls between rooms take of the lines that end at them: level, axis, from, to."""
        found: set[tuple[int, PlanAxis, float, float]] = set()
        for edge in self.edges:
            level, axis, line = edge.line
            for other in self._across(edge) if edge.inward == -1 else ():
                overlap = min(edge.end, other.end) - max(edge.start, other.start)
                if NEGLIGIBLE < other.line[2] - line <= THICKEST + NEGLIGIBLE and overlap > NEGLIGIBLE:
                    found.add((level, "z" if axis == "x" else "x", line, other.line[2]))
        return found

    def _own(self, edge: OutlineEdge) -> float:
        """Returns how thick a room says that its wall is where it is an outer one."""
        said = edge.room.wall_thickness or ()
        own = said[edge.number] if edge.number < len(said) else None
        return self.thickness if own is None else own


def _line(edge: OutlineEdge) -> float:
    """Returns where the line of an edge lies across it, m."""
    return edge.line[2]


def thick(thickness: float) -> float:
    """Returns how thick a wall is drawn, m."""
    return max(thickness, THINNEST)


def _stretches(edge: OutlineEdge, near: Sequence[tuple[float, float, float]]) -> Iterator[_Stretch]:
    """Yields the stretches of an edge that have the same room on the other side; the nearest room counts."""
    ends = {min(max(end, edge.start), edge.end) for _, low, high in near for end in (low, high)}
    last: _Stretch | None = None
    for low, high in pairwise(sorted({edge.start, edge.end, *ends})):
        gap = next((max(gap, 0.0) for gap, start, end in near if start <= low and high <= end), None)
        if last and last[2] == gap:
            last = (last[0], high, gap)
            continue
        if last:
            yield last
        last = (low, high, gap)
    yield last or (edge.start, edge.end, None)


def _filled(stretches: Iterator[_Stretch]) -> list[_Stretch]:
    """Returns stretches with what lies between two rooms, where the wall that parts them ends, as thick as the thinner on either side."""
    found = list(stretches)
    for before, here, after in zip(found, found[1:], found[2:], strict=False):
        if here[2] is None and before[2] is not None and after[2] is not None and here[1] - here[0] <= THICKEST + NEGLIGIBLE:
            found[found.index(here)] = (here[0], here[1], min(before[2], after[2]))
    return found
