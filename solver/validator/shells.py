"""The openings on a room's walls, and what is fitted to them; doors closed. Walls are around them (solver/core/validate/shell.cpp)."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from functools import lru_cache
from struct import Struct
from typing import Final, NamedTuple

from solver.demanded import demand
from solver.validator.lattice import WallEdge, metres
from solver.validator.sent_rooms import edge_row
from solver.validator.world import Hole, PlacedRoom, World
from solver.wall_fittings import Span, door_bars, leaf_bars, leaf_offset, window_bars

GAP_WORK: Final = 0.3
"""What a hole costs for each stretch of wall that it is over [see demanded.py]. Measured."""
_FEW: Final = 16
"""So many holes in a room cost nothing to speak of."""
_HOLE: Final = Struct("<32s2dq")
_BOX: Final = Struct("<6d")


class ShellRows(NamedTuple):
    """What stands around a room: how many holes its walls have, how many boxes are fitted to these, the rows of both."""

    holes: int
    fitted: int
    rows: bytes


def shell_of(world: World, place: PlacedRoom) -> ShellRows:
    """Returns what stands around a room.

    Raises:
        TooMuch: the call may not have so much work.
    """
    thickness = 2 * metres(world.half_wall)
    holes, fitted, edges, count = list[bytes](), list[bytes](), list[WallEdge](), 0
    for hole, leaf, edge in _holes(world, place):
        opening = leaf.opening
        low = metres(hole.sill) if hole.opening.kind == "window" else 0.0
        high = low + hole.opening.height
        inwards = 1 if leaf.edge.side in ("north", "west") else -1
        turns = opening.hinge, -inwards if opening.swing == "out" else inwards
        boxes, rows = _fitted(opening.kind, metres(edge.end - edge.start), (low, high), turns, thickness)
        holes.append(_HOLE.pack(edge_row(edge), low, high, boxes))
        fitted.append(rows)
        edges.append(edge)
        count += boxes
    if len(edges) > _FEW:
        _demand_cuts(edges)
    return ShellRows(len(holes), count, b"".join([*holes, *fitted]))


def _holes(world: World, place: PlacedRoom) -> Iterator[tuple[Hole, Hole, WallEdge]]:
    """Yields the openings on a room's walls, the entry of each that says how its leaf turns, and where it is in the room's frame."""
    own = {hole.opening.id for hole in place.holes}
    leading = world.leading_to.get(place.room.id, ())
    for hole in place.holes:
        leaf = hole
        if not hole.opening.render_panel:  # of two entries that draws the leaf which says so
            other = next((one for _, one in leading if one.opening.id == hole.opening.id), None)
            leaf = other if other and other.opening.render_panel else hole
        yield hole, leaf, hole.edge
    for room, hole in leading:
        if room is not place and hole.opening.id not in own:
            yield hole, hole, hole.edge.moved(room.x - place.x, room.z - place.z)


def _demand_cuts(holes: Sequence[WallEdge]) -> None:
    """Counts the stretches that walls are cut into at the sides of holes, each as often as there are holes over it."""
    stops: dict[tuple[bool, int], list[int]] = {}
    for hole in holes:
        stops.setdefault((hole.runs_east, hole.line), []).extend((hole.start, hole.end))
    for ends in stops.values():
        ends.sort()
    for hole in holes:
        ends = stops[hole.runs_east, hole.line]
        demand(GAP_WORK * (bisect_left(ends, hole.end) - bisect_left(ends, hole.start)))


@lru_cache(maxsize=256)
def _fitted(kind: str, width: float, up: Span, turns: tuple[str | None, int], thickness: float) -> tuple[int, bytes]:
    """Returns what is fitted to an opening that begins at 0, m, its leaf closed, as the core reads it: how many boxes, and their rows.

    `turns` says at which end its leaf hangs, and whether it turns across the wall to where x or z grow, +1, or -1.
    """
    along, head = (0.0, width), up[1]
    if kind == "window":
        bars = window_bars(along, up, thickness)
    elif kind == "passage":
        bars = []
    else:
        hinge = ("end" if turns[0] == "end" else "start") if kind == "door" else None
        middle = turns[1] * leaf_offset(thickness) if kind == "door" else 0.0
        bars = [*door_bars(along, head, thickness), *leaf_bars(along, head, middle, hinge)]
    return len(bars), b"".join([_BOX.pack(*bar.along, *bar.up, *bar.across) for bar in bars])
