"""Rooms' edges in the house, where the walls along them stand, stretch by stretch, and the openings on them.

What lies between two rooms' faces is one wall, an outer wall has its own thickness. A room's face lies half the scene's thickness
inside its line. Two rooms whose lines lie apart have a wall that is thicker by as much. A room's wall may be shared piece by piece with
several rooms, so the walls are the union of all rooms' edges on a line; `wall_flags` only takes away what no room beside wants drawn.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, Literal, NamedTuple

from solver.demanded import demand
from solver.exports.model import PlacedOpening
from solver.geometry import ALONG_X, bounds_of_points, encloses, walls_round
from solver.scene import Opening, Room

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


_BEFORE = 0.2
"""How far before a wall the room is looked for that an opening leads to, m."""


class WallRun(NamedTuple):
    """A stretch of wall or railing on one line, m; `shift` is how far its line lies from those of its rooms."""

    line: Line
    start: float
    end: float
    kind: Literal["wall", "railing"]
    thickness: float
    shift: float


def runs_of(bands: WallBands) -> list[WallRun]:
    """Returns all stretches of wall and railing of a house, each once, longest possible."""
    lines: dict[tuple[Line, float], list[OutlineEdge]] = defaultdict(list)
    for edge in bands.edges:
        for piece in bands.pieces(edge):
            lines[piece.line, piece.thickness].append(piece)
    bridges = bands.bridges()
    return [run for edges in lines.values() for run in _runs_on_line(edges, bands.thickness, bridges)]


def _runs_on_line(edges: Sequence[OutlineEdge], usual: float, bridges: set[tuple[int, PlanAxis, float, float]]) -> list[WallRun]:
    cuts = sorted({end for edge in edges for end in (edge.start, edge.end)})
    demand(EDGE_WORK * len(cuts) * len(edges))
    runs: list[WallRun] = []
    for start, end in pairwise(cuts):
        covering = [edge for edge in edges if edge.start <= start and end <= edge.end]
        kind = _kind(covering)
        if kind is None:
            continue
        (level, axis, _), thickness = covering[0].line, covering[0].thickness
        if runs and runs[-1].kind == kind and (runs[-1].end == start or (level, axis, runs[-1].end, start) in bridges):
            runs[-1] = runs[-1]._replace(end=end)
        else:
            runs.append(WallRun(covering[0].line, start, end, kind, thick(thickness), abs(thickness - usual) / 2))
    return runs


def _kind(covering: Sequence[OutlineEdge]) -> Literal["wall", "railing"] | None:
    """Returns what stands on a stretch of a line, given the edges that cover it."""
    if not any(edge.room.wall_flags is None or getattr(edge.room.wall_flags, edge.side) for edge in covering):
        return None
    return "railing" if all(edge.room.outdoor for edge in covering) else "wall"


def openings_of(rooms: Sequence[Room], bands: WallBands, finder: "RoomFinder") -> list[PlacedOpening]:
    """Returns every opening of a house once; of the entries under one id the one that draws the leaf, whose hinge and swing count."""
    kept: dict[str, tuple[OutlineEdge, float, Opening]] = {}
    for room, edges in zip(rooms, bands.by_room, strict=True):
        sides = edges_of(_as_rectangle(room)) if room.outline else edges
        for opening in room.openings:
            spot = _spot(edges, sides, opening)
            if spot and (opening.id not in kept or (opening.render_panel and not kept[opening.id][2].render_panel)):
                kept[opening.id] = (*spot, opening)
    return [_placed(*found, bands, finder) for found in kept.values()]


def _spot(edges: Sequence[OutlineEdge], sides: Sequence[OutlineEdge], opening: Opening) -> tuple[OutlineEdge, float] | None:
    """Returns the edge an opening lies on, and from where on its line positions are counted; None where the scene does not say.

    `edges` are the room's, `sides` those of the rectangle round it.
    """
    if opening.edge is not None:
        return (edges[opening.edge], edges[opening.edge].start) if opening.edge < len(edges) else None
    if not opening.wall:
        return None
    rectangle = next(edge for edge in sides if edge.side == opening.wall)
    at = rectangle.start + opening.position
    here = [e for e in edges if e.side == opening.wall and e.start <= at + NEGLIGIBLE and at <= e.end + NEGLIGIBLE]
    outermost = min(here, key=lambda edge: abs(edge.line[2] - rectangle.line[2]), default=rectangle)
    return outermost, rectangle.start


def _as_rectangle(room: Room) -> Room:
    return Room(room.id, x=room.x, z=room.z, width=room.width, depth=room.depth, level=room.level)


def _placed(edge: OutlineEdge, origin: float, opening: Opening, bands: WallBands, finder: "RoomFinder") -> PlacedOpening:
    centre, sill = origin + opening.position, opening.sill if opening.kind == "window" else 0.0
    start, end = on_lattice(centre - opening.width / 2), on_lattice(centre + opening.width / 2)
    outward: Literal[1, -1] = -1 if edge.inward == 1 else 1
    wall = bands.at(edge, (start + end) / 2)
    greater, smaller = finder.beside(wall.line, (start + end) / 2, _BEFORE + abs(wall.line[2] - edge.line[2]))
    return PlacedOpening(
        id=opening.id,
        kind=opening.kind,
        level=edge.line[0],
        axis=edge.line[1],
        line=wall.line[2],
        thickness=thick(wall.thickness),
        start=start,
        end=end,
        sill=sill,
        head=sill + opening.height,
        hinge="end" if opening.hinge == "end" else "start",
        towards=outward if opening.swing == "out" else edge.inward,
        is_main_entrance=opening.main_entrance,
        open=opening.open or 0.0,
        rooms=(greater.id if greater else None, smaller.id if smaller else None),
    )


class RoomFinder:
    """Finds the room of a level that holds a point of the plan: the first one of the house's."""

    def __init__(self, rooms: Sequence[Room]) -> None:
        self._levels: dict[int, list[tuple[Room, float, float, float, float]]] = defaultdict(list)
        for room in rooms:
            west, north, east, south = bounds_of_points(room.corners)
            self._levels[room.level].append((room, room.x + west, room.z + north, room.x + east, room.z + south))

    def at(self, level: int, x: float, z: float) -> Room | None:
        """Returns the room that holds a point, m; None outside."""
        for room, x0, z0, x1, z1 in self._levels.get(level, ()):
            if x0 <= x <= x1 and z0 <= z <= z1 and (not room.outline or _encloses(room, x - room.x, z - room.z)):
                return room
        return None

    def beside(self, line: Line, along: float, away: float) -> tuple[Room | None, Room | None]:
        """Returns the rooms on both sides of a line, towards greater and towards smaller coordinates, `away` from it, m."""
        level, axis, across = line
        if axis == "x":
            return self.at(level, along, across + away), self.at(level, along, across - away)
        return self.at(level, across + away, along), self.at(level, across - away, along)


def _encloses(room: Room, x: float, z: float) -> bool:
    """Tells whether a point relative to a room's corner is within its outline."""
    demand(EDGE_WORK * len(room.corners))
    return encloses(room.corners, x, z)
