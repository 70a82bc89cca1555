"""What stands around a room for what opens in it: walls with their holes, and what is fitted to those; doors closed.

Comes in: a `World` and one of its places. Goes out: boxes. May import: scene, wall_fittings.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from solver.demanded import demand
from solver.validator.lattice import WallEdge, metres
from solver.validator.world import Hole, PlacedRoom, World
from solver.wall_fittings import Bar, Span, between, cut_at_holes, door_bars, leaf_bars, leaf_offset, window_bars

HEIGHT: Final = 3.0
"""How high walls are taken to be, m."""
GAP_WORK: Final = 0.3
"""What a hole costs for each stretch of wall that it is over [see demanded.py]. Measured."""


class _Fitting(NamedTuple):
    """All that what is fitted to an opening depends on: its width and heights, m; where its leaf hangs and turns to, +1 or -1 across."""

    kind: str
    width: float
    up: Span
    hinge: str | None
    towards: int
    thickness: float


class _HoleHere(NamedTuple):
    """An opening on a room's walls, whichever room lists it: where it is in this room, m, and what is fitted to it."""

    edge: WallEdge
    along: Span
    up: Span
    fitting: _Fitting


def shell_of(world: World, place: PlacedRoom) -> list[float]:
    """Returns the boxes around a room, in its own frame, m: x, y and z of where one begins, then of where it ends, and so on."""
    thickness = 2 * metres(world.half_wall)
    holes = list(_holes(world, place, thickness))
    by_line: dict[tuple[bool, int], list[_HoleHere]] = {}
    for one in holes:
        by_line.setdefault((one.edge.runs_east, one.edge.line), []).append(one)
    boxes: list[float] = []
    for edge in place.edges:
        _place(boxes, edge, 0.0, _wall(edge, thickness, by_line.get((edge.runs_east, edge.line), ())))
    for one in holes:
        _place(boxes, one.edge, one.along[0], _fitted(one.fitting))
    return boxes


def _holes(world: World, place: PlacedRoom, thickness: float) -> Iterator[_HoleHere]:
    own = {hole.opening.id for hole in place.holes}
    for hole in place.holes:
        other = next((pair for pair in world.leading_to.get(place.room.id, ()) if pair[1].opening.id == hole.opening.id), None)
        leaf = other[1] if other and other[1].opening.render_panel and not hole.opening.render_panel else hole
        yield _here(hole, leaf, (0, 0), thickness)
    for room, hole in world.leading_to.get(place.room.id, ()):
        if room is not place and hole.opening.id not in own:
            yield _here(hole, hole, (room.x - place.x, room.z - place.z), thickness)


def _here(hole: Hole, leaf: Hole, moved: tuple[int, int], thickness: float) -> _HoleHere:
    """Returns an opening moved by lattice steps; `leaf` is the entry that says how its leaf turns."""
    by, edge, opening = moved[0 if hole.edge.runs_east else 1], hole.edge.moved(*moved), leaf.opening
    sill = metres(hole.sill) if hole.opening.kind == "window" else 0.0
    inwards = 1 if leaf.edge.side in ("north", "west") else -1
    towards = -inwards if opening.swing == "out" else inwards
    along, up = (metres(hole.start + by), metres(hole.end + by)), (sill, sill + hole.opening.height)
    fitting = _Fitting(opening.kind, metres(hole.end - hole.start), up, opening.hinge, towards, thickness)
    return _HoleHere(edge, along, up, fitting)


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


@lru_cache(maxsize=256)
def _fitted(one: _Fitting) -> tuple[Bar, ...]:
    """Returns what is fitted to an opening that begins at 0, its leaf closed. A house has few sorts of them."""
    along, head = (0.0, one.width), one.up[1]
    if one.kind == "window":
        return tuple(window_bars(along, one.up, one.thickness))
    if one.kind == "passage":
        return ()
    turns = one.kind == "door"
    middle = one.towards * leaf_offset(one.thickness) if turns else 0.0
    hinge = ("end" if one.hinge == "end" else "start") if turns else None
    return (*door_bars(along, head, one.thickness), *leaf_bars(along, head, middle, hinge))


def _place(boxes: list[float], edge: WallEdge, at: float, bars: Iterable[Bar]) -> None:
    """Adds bars, from a place along a wall on."""
    line = metres(edge.line)
    if edge.runs_east:
        for (start, end), (low, high), (near, far), _ in bars:
            boxes += at + start, low, line + near, at + end, high, line + far
    else:
        for (start, end), (low, high), (near, far), _ in bars:
            boxes += line + near, low, at + start, line + far, high, at + end
