"""The openings on a room's walls as the core reads them, and what is fitted to them; doors closed (solver/core/validate/room.hpp)."""

from functools import lru_cache
from struct import Struct
from typing import Final, NamedTuple

from solver.scene import EXTERIOR, WALL_NUMBERS, Opening
from solver.validator.lattice import PER_METRE, WallEdge, metres
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


def openings_on(world: World, place: PlacedRoom) -> list[Opening]:
    """Returns the openings on a room's walls, as the core numbers them: its own, and then those that only others list."""
    return [hole.opening for hole in (*place.holes, *(hole for _, hole in _beyond(world, place)))]


def sent_openings(world: World, place: PlacedRoom) -> SentOpenings:
    """Returns the openings on a room's walls."""
    told = list[tuple[bytes, bytes]]()
    thickness, said = 2 * metres(world.half_wall), Opening.height
    leading = {hole.opening.id: hole for _, hole in reversed(world.leading_to.get(place.room.id, ()))}
    for hole in place.holes:
        opening, leaf = hole.opening, hole
        if not opening.render_panel:  # of two entries that draws the leaf which says so
            other = leading.get(opening.id)
            leaf = other if other and other.opening.render_panel else hole
        flags = _KEEPS_FREE if opening.height == said else _KEEPS_FREE | _SAYS_HEIGHT
        told.append(_rows(hole, hole.edge, (_leads_to(world, place, opening.connects_to), flags), leaf, thickness))
    others = _beyond(world, place)
    listed = {opening.id for opening in place.room.openings} if others else ()
    for room, hole in others:
        flags = 0 if hole.opening.id in listed else _KEEPS_FREE
        told.append(_rows(hole, hole.edge.moved(room.x - place.x, room.z - place.z), (_ANYWHERE, flags), hole, thickness))
    fitted = b"".join([bars for _, bars in told])
    return SentOpenings(len(place.holes), len(others), len(fitted) // _BOX.size, b"".join([*(row for row, _ in told), fitted]))


def _rows(hole: Hole, edge: WallEdge, leads: tuple[int, int], leaf: Hole, thickness: float) -> tuple[bytes, bytes]:
    """Returns an opening's row, and those of what is fitted to it.

    Args:
        hole: the opening.
        edge: where it is in the room's frame.
        leads: where to, and its flags.
        leaf: the entry of it that says how its leaf turns.
        thickness: of walls, m.
    """
    (side, line, start, end), (to, flags), said, turning = edge, leads, hole.opening, leaf.opening
    low = hole.sill / PER_METRE if said.kind == "window" else 0.0
    inwards = 1 if leaf.edge.side in ("north", "west") else -1
    turns = turning.hinge, -inwards if turning.swing == "out" else inwards
    bars = _fitted(turning.kind, (end - start) / PER_METRE, (low, low + said.height), turns, thickness)
    place = WALL_NUMBERS[side], line, start, end, hole.sill, hole.top, low, low + said.height
    return _OPENING.pack(*place, _KINDS.get(said.kind, _NO_SUCH_KIND), to, len(bars) // _BOX.size, flags), bars


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
def _fitted(kind: str, width: float, up: Span, turns: tuple[str | None, int], thickness: float) -> bytes:
    """Returns what is fitted to an opening that begins at 0, m, its leaf closed, as the core reads it.

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
    return b"".join([_BOX.pack(*bar.along, *bar.up, *bar.across) for bar in bars])
