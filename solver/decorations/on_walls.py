"""What hangs on walls: at the wall's face, over a piece or where a wall is free.

Comes in: a DecoratedRoom and a piece. Goes out: nothing; the room has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from catalogs.dressing import Hangs
from solver.decorations.decorated_room import Carrier, DecoratedRoom, NewThing, sizes
from solver.free_places import nearest_place
from solver.geometry import FACING, ROTATION_AT_WALL, WALL_BEHIND, Rect, strip, to_mm
from solver.scene import WALLS, Opening

BEHIND_MM: Final = 150
"""A piece whose back is no farther from a wall's face than this stands at that wall. Our choice."""
VIEW_MM: Final = 300
"""Furniture that stands this near to the wall, and as high, would hide what hangs there. Our choice."""
OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
CORNER_MM: Final = 50
CEILING_MM: Final = 100
APART_MM: Final = 30
"""From the room's corners, from the ceiling, from one another. Our choice."""


class WallSpot(NamedTuple):
    """A place wished for: over an interval of a wall (room coordinates, mm), at a share of it, the underside's height."""

    wall: str
    span: tuple[int, int]
    share: float
    underside: int
    over: Carrier | None = None


def hang(decorated: DecoratedRoom, piece: Carrier) -> None:
    """Hangs the rows of a piece on the wall behind it; outdoors, and in rooms that are no rectangles, none."""
    entry, wall = decorated.catalogs.dressing.get(piece.name), WALL_BEHIND[piece.rotation]
    plain = not decorated.room.outdoor and not decorated.room.outline
    if entry is None or not plain or piece.rect.wall_distance(wall, decorated.space.clear) > BEHIND_MM:
        return
    fx, fz = FACING[piece.rotation]
    for row in entry.hangs:
        underside = max(to_mm(row.height), piece.high + to_mm(row.gap))
        names = decorated.wanted(row)
        for k, share in enumerate(row.at if names else ()):
            along = share if fz - fx > 0 else 1 - share
            _hang_at(decorated, WallSpot(wall, piece.rect.along(wall), along, underside, piece), row, names[k % len(names)])


def hang_free(decorated: DecoratedRoom) -> None:
    """Hangs the rows of a room's type on its walls, on the longest that has a place first."""
    entry = decorated.catalogs.dressing.get(decorated.room.type)
    if entry is None or decorated.room.outdoor or decorated.room.outline:
        return
    clear = decorated.space.clear
    walls = sorted(WALLS, key=lambda wall: clear.along(wall)[0] - clear.along(wall)[1])
    for row in entry.hangs:
        names = decorated.wanted(row)
        for k, share in enumerate(row.at if names else ()):
            spots = (WallSpot(wall, clear.along(wall), share, to_mm(row.height)) for wall in walls)
            any(_hang_at(decorated, spot, row, names[k % len(names)]) for spot in spots)


def _hang_at(decorated: DecoratedRoom, spot: WallSpot, row: Hangs, name: str) -> bool:
    """Hangs a thing at a spot or as near as it can with its middle over the span; tells whether it found a place."""
    clear, wall = decorated.space.clear, spot.wall
    first, last = clear.along(wall)
    for width, depth, height in sizes(decorated.catalogs.decorations[name], row):
        if spot.underside + height > decorated.ceiling - CEILING_MM:
            continue
        ends = max(spot.span[0] - width // 2, first + CORNER_MM), min(spot.span[1] + width // 2, last - CORNER_MM)
        start = round(spot.span[0] + (spot.span[1] - spot.span[0] - width) * spot.share)
        area, wish = strip(clear, wall, ends, depth), strip(clear, wall, (start, start + width), depth)
        blocks = _blocks(decorated, wall, depth, (spot.underside, spot.underside + height))
        place = nearest_place(wish.held_in(area), area, blocks)
        if place is not None:
            new = NewThing(name, place, spot.underside, (width, depth, height), ROTATION_AT_WALL[wall])
            decorated.add(new, row, spot.over, wall)
            return True
    return False


def _blocks(decorated: DecoratedRoom, wall: str, depth: int, span: tuple[int, int]) -> list[Rect]:
    """Returns what is in the way along a wall between two heights: openings, what hangs there, what would hide it."""
    clear = decorated.space.clear
    found = [
        strip(clear, wall, _interval(opening), depth)
        for opening in decorated.room.openings
        if opening.wall == wall
        and span[0] < to_mm(opening.sill + opening.height) + OPENING_MM
        and to_mm(opening.sill) - OPENING_MM < span[1]
    ]
    view = strip(clear, wall, clear.along(wall), max(depth, VIEW_MM))
    for rect in decorated.near(view, *span, frozenset()):
        low, high = rect.along(wall)
        found.append(strip(clear, wall, (low - APART_MM, high + APART_MM), depth))
    return found


def _interval(opening: Opening) -> tuple[int, int]:
    return to_mm(opening.position - opening.width / 2) - OPENING_MM, to_mm(opening.position + opening.width / 2) + OPENING_MM
