"""What stands around a room for what opens in it: walls with their holes, and what is fitted to those; doors closed.

Comes in: a `World` and one of its places. Goes out: boxes. May import: scene, wall_fittings.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Final, NamedTuple

from solver.demanded import demand
from solver.validator.lattice import WallEdge, metres
from solver.validator.world import Hole, PlacedRoom, World
from solver.wall_fittings import Bar, Span, between, cut_at_holes, door_bars, leaf_bars, leaf_offset, window_bars

HEIGHT: Final = 3.0
"""How high walls are taken to be, m."""
GAP_WORK: Final = 0.3
"""What a hole costs for each stretch of wall that it is over [see demanded.py]. Measured."""


class ShellBox(NamedTuple):
    """A box in a room, m: x east, y up from the floor, z south."""

    x0: float
    y0: float
    z0: float
    x1: float
    y1: float
    z1: float


class _HoleHere(NamedTuple):
    """An opening on a room's walls, whichever room lists it: where it is in this room, m; which way its leaf turns, +1 or -1 across."""

    hole: Hole
    edge: WallEdge
    along: Span
    up: Span
    towards: int


def shell_of(world: World, place: PlacedRoom) -> list[ShellBox]:
    """Returns the boxes around a room, in its own frame."""
    thickness = 2 * metres(world.half_wall)
    holes = list(_holes(world, place))
    by_line: dict[tuple[bool, int], list[_HoleHere]] = {}
    for one in holes:
        by_line.setdefault((one.edge.runs_east, one.edge.line), []).append(one)
    boxes: list[ShellBox] = []
    for edge in place.edges:
        boxes += _placed(edge, _wall(edge, thickness, by_line.get((edge.runs_east, edge.line), ())))
    for one in holes:
        boxes += _placed(one.edge, _fitted(one, thickness))
    return boxes


def _holes(world: World, place: PlacedRoom) -> Iterator[_HoleHere]:
    own = {hole.opening.id for hole in place.holes}
    for hole in place.holes:
        other = next((pair for pair in world.leading_to.get(place.room.id, ()) if pair[1].opening.id == hole.opening.id), None)
        leaf = other[1] if other and other[1].opening.render_panel and not hole.opening.render_panel else hole
        yield _here(hole, leaf, 0, 0)
    for room, hole in world.leading_to.get(place.room.id, ()):
        if room is not place and hole.opening.id not in own:
            yield _here(hole, hole, room.x - place.x, room.z - place.z)


def _here(hole: Hole, leaf: Hole, x: int, z: int) -> _HoleHere:
    """Returns an opening moved by lattice steps; `leaf` is the entry that says how its leaf turns."""
    by, edge = (x if hole.edge.runs_east else z), hole.edge.moved(x, z)
    sill = metres(hole.sill) if hole.opening.kind == "window" else 0.0
    inwards = 1 if leaf.edge.side in ("north", "west") else -1
    towards = -inwards if leaf.opening.swing == "out" else inwards
    along = metres(hole.start + by), metres(hole.end + by)
    return _HoleHere(leaf, edge, along, (sill, sill + hole.opening.height), towards)


def _wall(edge: WallEdge, thickness: float, holes: Sequence[_HoleHere]) -> list[Bar]:
    """Returns a wall's solid boxes: it goes on by half its thickness beyond its ends."""
    half = thickness / 2
    start, end = metres(edge.start) - half, metres(edge.end) + half
    if not holes:
        return [Bar((start, end), (0.0, HEIGHT), (-half, half))]
    bars = []
    for along, gaps in cut_at_holes((start, end), [(one.along, one.up) for one in holes]):
        demand(GAP_WORK * len(gaps))
        bars += [Bar(along, up, (-half, half)) for up in between(0.0, HEIGHT, gaps)]
    return bars


def _fitted(one: _HoleHere, thickness: float) -> list[Bar]:
    """Returns what is fitted to an opening, its leaf closed."""
    opening, head = one.hole.opening, one.up[1]
    if opening.kind == "window":
        return window_bars(one.along, one.up, thickness)
    if opening.kind == "passage":
        return []
    turns = opening.kind == "door"
    middle = one.towards * leaf_offset(thickness) if turns else 0.0
    hinge = ("end" if opening.hinge == "end" else "start") if turns else None
    return [*door_bars(one.along, head, thickness), *leaf_bars(one.along, head, middle, hinge)]


def _placed(edge: WallEdge, bars: Iterable[Bar]) -> list[ShellBox]:
    line = metres(edge.line)
    if edge.runs_east:
        return [ShellBox(x0, y0, line + low, x1, y1, line + high) for (x0, x1), (y0, y1), (low, high), _ in bars]
    return [ShellBox(line + low, y0, z0, line + high, y1, z1) for (z0, z1), (y0, y1), (low, high), _ in bars]
