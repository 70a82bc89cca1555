"""What hangs on walls: at the wall's face, over a piece or where a wall is free.

Comes in: a Scenery and a piece. Goes out: nothing; the scenery has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, NamedTuple

from catalogs.dressing import Hangs
from solver.dress.scenery import Carrier, New, Scenery, nearest, sizes
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


class Spot(NamedTuple):
    """A place wished for: over an interval of a wall (room coordinates, mm), at a share of it, the underside's height."""

    wall: str
    span: tuple[int, int]
    share: float
    underside: int
    over: Carrier | None = None


def hang(scenery: Scenery, piece: Carrier) -> None:
    """Hangs the rows of a piece on the wall behind it."""
    entry = scenery.terms.catalogs.dressing.get(piece.name)
    wall = _wall_behind(scenery, piece) if entry and entry.hangs else None
    if entry is None or wall is None:
        return
    fx, fz = FACING[piece.rotation]
    for row in entry.hangs:
        underside = max(to_mm(row.height), piece.high + to_mm(row.gap))
        for name, share in _each(scenery, row):
            along = share if fz - fx > 0 else 1 - share
            _hang_at(scenery, Spot(wall, piece.rect.along(wall), along, underside, piece), row, name)


def hang_free(scenery: Scenery) -> None:
    """Hangs the rows of a room's type on its walls, on the longest that has a place first."""
    entry = scenery.terms.catalogs.dressing.get(scenery.room.type)
    if entry is None or scenery.room.outdoor or scenery.room.outline:
        return
    clear = scenery.space.clear
    walls = sorted(WALLS, key=lambda wall: clear.along(wall)[0] - clear.along(wall)[1])
    for row in entry.hangs:
        for name, share in _each(scenery, row):
            spots = (Spot(wall, clear.along(wall), share, to_mm(row.height)) for wall in walls)
            any(_hang_at(scenery, spot, row, name) for spot in spots)


def _each(scenery: Scenery, row: Hangs) -> Iterator[tuple[str, float]]:
    """Yields a kind for each place of a row."""
    names = scenery.wanted(row)
    first = scenery.stream.below(len(names)) if len(names) > 1 else 0
    for k, share in enumerate(row.at if names else ()):
        yield names[(first + k) % len(names)], share


def _wall_behind(scenery: Scenery, piece: Carrier) -> str | None:
    """Returns the wall at whose face a piece has its back; outdoors, and in rooms that are no rectangles, none."""
    if scenery.room.outdoor or scenery.room.outline:
        return None
    wall, clear, rect = WALL_BEHIND[piece.rotation], scenery.space.clear, piece.rect
    away = {"north": rect.z0 - clear.z0, "south": clear.z1 - rect.z1, "west": rect.x0 - clear.x0, "east": clear.x1 - rect.x1}
    return wall if away[wall] <= BEHIND_MM else None


def _hang_at(scenery: Scenery, spot: Spot, row: Hangs, name: str) -> bool:
    """Hangs a thing at a spot or as near as it can with its middle over the span; tells whether it found a place."""
    clear, wall = scenery.space.clear, spot.wall
    ends = clear.along(wall)[0] + CORNER_MM, clear.along(wall)[1] - CORNER_MM
    for width, depth, height in sizes(scenery.terms.catalogs.decorations[name], row):
        if spot.underside + height > scenery.ceiling - CEILING_MM:
            continue
        low, high = max(spot.span[0] - width // 2, ends[0]), min(spot.span[1] + width // 2, ends[1])
        start = round(spot.span[0] + (spot.span[1] - spot.span[0] - width) * spot.share)
        area, wish = strip(clear, wall, (low, high), depth), strip(clear, wall, (start, start + width), depth)
        blocks = _blocks(scenery, wall, depth, (spot.underside, spot.underside + height))
        place = nearest(area, (wish.x0, wish.z0), (wish.width, wish.depth), blocks, None)
        if place is not None:
            new = New(name, place, spot.underside, (width, depth, height), ROTATION_AT_WALL[wall])
            scenery.add(new, row, spot.over, wall)
            return True
    return False


def _blocks(scenery: Scenery, wall: str, depth: int, span: tuple[int, int]) -> list[Rect]:
    """Returns what is in the way along a wall between two heights: openings, what hangs there, what would hide it."""
    clear = scenery.space.clear
    found = [
        strip(clear, wall, _interval(opening), depth)
        for opening in scenery.room.openings
        if opening.wall == wall
        and span[0] < to_mm(opening.sill + opening.height) + OPENING_MM
        and to_mm(opening.sill) - OPENING_MM < span[1]
    ]
    view = strip(clear, wall, clear.along(wall), max(depth, VIEW_MM))
    for solid in scenery.solids:
        if solid.low < span[1] and span[0] < solid.high and solid.rect.overlaps(view):
            low, high = solid.rect.along(wall)
            found.append(strip(clear, wall, (low - APART_MM, high + APART_MM), depth))
    return found


def _interval(opening: Opening) -> tuple[int, int]:
    return to_mm(opening.position - opening.width / 2) - OPENING_MM, to_mm(opening.position + opening.width / 2) + OPENING_MM
