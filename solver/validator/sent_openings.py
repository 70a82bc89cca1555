"""The openings on a room's walls as the core reads them, and what is fitted to them; doors closed (solver/core/validate/room.hpp)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from struct import Struct
from typing import Final, NamedTuple

from solver.scene import EXTERIOR, Opening
from solver.validator.lattice import WALL_NUMBERS, WallEdge, metres
from solver.validator.world import Hole, PlacedRoom, World
from solver.wall_fittings import Span, door_bars, leaf_bars, leaf_offset, window_bars

_OPENING: Final = Struct("<6q2d4i")
_BOX: Final = Struct("<6d")
_KINDS: Final = {"window": 0, "door": 1, "passage": 2, "garage_door": 3}
_NO_SUCH_KIND: Final = 4
_ANYWHERE, _OUTSIDE, _NOWHERE = -1, -2, -3
"""Where an opening leads, where not to a room of its storey."""
_KEEPS_FREE, _SAYS_HEIGHT = 1, 2


class SentOpenings(NamedTuple):
    """The openings on a room's walls: how many it lists, how many only others list, how many boxes are fitted to these; their rows."""

    own: int
    beyond: int
    fitted: int
    rows: bytes


class _OnWall(NamedTuple):
    """An opening on a room's wall: the entry of it that says how its leaf turns, where it is in the room's frame, where it leads, flags."""

    hole: Hole
    leaf: Hole
    edge: WallEdge
    to: int
    flags: int


def openings_on(world: World, place: PlacedRoom) -> list[Opening]:
    """Returns the openings on a room's walls, as the core numbers them: its own, and then those that only others list."""
    return [hole.opening for hole in (*place.holes, *(hole for _, hole in _beyond(world, place)))]


def sent_openings(world: World, place: PlacedRoom) -> SentOpenings:
    """Returns the openings on a room's walls."""
    thickness = 2 * metres(world.half_wall)
    own, beyond = list(_own(world, place)), list(_of_others(world, place))
    rows, fitted, count = list[bytes](), list[bytes](), 0
    for hole, leaf, edge, to, flags in (*own, *beyond):
        kind = hole.opening.kind
        low = metres(hole.sill) if kind == "window" else 0.0
        high = low + hole.opening.height
        inwards = 1 if leaf.edge.side in ("north", "west") else -1
        turns = leaf.opening.hinge, -inwards if leaf.opening.swing == "out" else inwards
        boxes, bars = _fitted(leaf.opening.kind, metres(edge.end - edge.start), (low, high), turns, thickness)
        side, *line = edge
        number = _KINDS.get(kind, _NO_SUCH_KIND)
        rows.append(_OPENING.pack(WALL_NUMBERS[side], *line, hole.sill, hole.top, low, high, number, to, boxes, flags))
        fitted.append(bars)
        count += boxes
    return SentOpenings(len(own), len(beyond), count, b"".join([*rows, *fitted]))


def _own(world: World, place: PlacedRoom) -> Iterator[_OnWall]:
    leading = {hole.opening.id: hole for _, hole in reversed(world.leading_to.get(place.room.id, ()))}
    for hole in place.holes:
        leaf = hole
        if not hole.opening.render_panel:  # of two entries that draws the leaf which says so
            other = leading.get(hole.opening.id)
            leaf = other if other and other.opening.render_panel else hole
        flags = _KEEPS_FREE if hole.opening.height == Opening.height else _KEEPS_FREE | _SAYS_HEIGHT
        yield _OnWall(hole, leaf, hole.edge, _leads_to(world, place, hole.opening.connects_to), flags)


def _of_others(world: World, place: PlacedRoom) -> Iterator[_OnWall]:
    listed = {opening.id for opening in place.room.openings}
    for room, hole in _beyond(world, place):
        edge, flags = hole.edge.moved(room.x - place.x, room.z - place.z), 0 if hole.opening.id in listed else _KEEPS_FREE
        yield _OnWall(hole, hole, edge, _ANYWHERE, flags)


def _beyond(world: World, place: PlacedRoom) -> list[tuple[PlacedRoom, Hole]]:
    """Returns the openings on a room's walls that only other rooms list."""
    own = {hole.opening.id for hole in place.holes}
    leading = world.leading_to.get(place.room.id, ())
    return [(room, hole) for room, hole in leading if room is not place and hole.opening.id not in own]


def _leads_to(world: World, place: PlacedRoom, to: str | None) -> int:
    """Returns where an opening says that it leads to. A room that was sent alone may speak of rooms that were not."""
    if to is None or len(world.places) == 1:
        return _ANYWHERE
    if to == EXTERIOR:
        return _OUTSIDE
    level, number = world.numbers.get(to, (place.room.level, _NOWHERE))
    return number if level == place.room.level else _ANYWHERE


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
