"""Wall lines of a house: from rooms' edges the stretches of wall and railing, each once, and the openings on them.

A room's wall may be shared piece by piece with several rooms, so the walls are the union of all rooms' edges on a line; `wall_flags` only
takes away what no room on either side wants drawn.
"""

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal, NamedTuple

from solver.demanded import demand
from solver.exports.model import PlacedOpening
from solver.exports.wall_bands import EDGE_WORK, NEGLIGIBLE, Line, OutlineEdge, PlanAxis, WallBands, edges_of, on_lattice, thick
from solver.geometry import bounds_of_points, encloses
from solver.scene import Opening, Room

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
