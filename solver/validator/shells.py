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
_WHOLE_HEIGHT: Final = (0.0, HEIGHT)
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


_Box = tuple[Span, Span, Span]
"""A box in or at a wall: along the wall, up from the floor, across from the wall's middle line, m."""


def _holes(world: World, place: PlacedRoom, thickness: float) -> Iterator[_HoleHere]:
    own = {hole.opening.id for hole in place.holes}
    leading = world.leading_to.get(place.room.id, ())
    for hole in place.holes:
        leaf = hole
        if not hole.opening.render_panel:  # of two entries that draws the leaf which says so
            other = next((one for _, one in leading if one.opening.id == hole.opening.id), None)
            leaf = other if other and other.opening.render_panel else hole
        yield _here(hole, leaf, (0, 0), thickness)
    for room, hole in leading:
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


def _wall(edge: WallEdge, thickness: float, holes: Sequence[_HoleHere]) -> list[_Box]:
    """Returns a wall's solid boxes: it goes on by half its thickness beyond its ends."""
    half = thickness / 2
    start, end, across = metres(edge.start) - half, metres(edge.end) + half, (-half, half)
    if not holes:
        return [((start, end), _WHOLE_HEIGHT, across)]
    boxes: list[_Box] = []
    for along, gaps in cut_at_holes((start, end), [(one.along, one.up) for one in holes]):
        if not gaps:
            boxes.append((along, _WHOLE_HEIGHT, across))
            continue
        demand(GAP_WORK * len(gaps))
        boxes += [(along, up, across) for up in between(0.0, HEIGHT, gaps)]
    return boxes


@lru_cache(maxsize=256)
def _fitted(one: _Fitting) -> tuple[_Box, ...]:
    """Returns what is fitted to an opening that begins at 0, its leaf closed. A house has few sorts of them."""
    along, head = (0.0, one.width), one.up[1]
    if one.kind == "window":
        return _boxes(window_bars(along, one.up, one.thickness))
    if one.kind == "passage":
        return ()
    turns = one.kind == "door"
    middle = one.towards * leaf_offset(one.thickness) if turns else 0.0
    hinge = ("end" if one.hinge == "end" else "start") if turns else None
    return _boxes([*door_bars(along, head, one.thickness), *leaf_bars(along, head, middle, hinge)])


def _boxes(bars: Iterable[Bar]) -> tuple[_Box, ...]:
    return tuple([bar[:3] for bar in bars])


def _place(boxes: list[float], edge: WallEdge, at: float, found: Iterable[_Box]) -> None:
    """Adds boxes, from a place along a wall on."""
    line = metres(edge.line)
    if edge.runs_east:
        for (start, end), (low, high), (near, far) in found:
            boxes += at + start, low, line + near, at + end, high, line + far
    else:
        for (start, end), (low, high), (near, far) in found:
            boxes += line + near, low, at + start, line + far, high, at + end
