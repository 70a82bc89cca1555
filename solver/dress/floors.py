"""What stands and lies on a room's floor: rugs, plants, toys, entry things.

Comes in: a Scenery and a Walking. Goes out: nothing; the scenery has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from catalogs.dressing import INDOOR, DecorationKind, Stands
from solver.dress.scenery import BODY_MM, Carrier, New, Scenery, extents, millimetres, nearest, sizes
from solver.dress.walking import Walking
from solver.geometry import FACING, ROTATION_AT_WALL, WALL_BEHIND, Rect, strip, to_mm
from solver.scene import WALLS

OFF_WALL_MM: Final = 30
"""What stands at a wall stands this far from its face, as furniture does (contract)."""
FRONT_MM: Final = 300
"""How much floor before a cupboard's doors things that do not lie about leave free. Our choice."""
TRIES: Final = 3
"""Places tried for a thing that stands anywhere. Our choice."""


class Spot(NamedTuple):
    """A place wished for: inside an area, near a point (mm), turned so."""

    area: Rect
    wish: tuple[int, int]
    rotation: int


def stand(scenery: Scenery, walking: Walking) -> None:
    """Puts the rows of the room's type, and those for every indoor room, on its floor."""
    dressing = scenery.terms.catalogs.dressing
    own = dressing.get(scenery.room.type)
    rows: list[Stands] = []
    if not scenery.room.outdoor and (own is None or own.indoor) and INDOOR in dressing:
        rows += dressing[INDOOR].stands
    rows += own.stands if own else ()
    for row in rows:
        names = scenery.wanted(row)
        if not names or min(scenery.room.width, scenery.room.depth) < row.min_side:
            continue
        if row.where == "middle":
            _spread(scenery, row, names[0])
        else:
            _scatter(scenery, walking, row, names)


def _spread(scenery: Scenery, row: Stands, name: str) -> None:
    """Lays a rug in the middle of the room, along its longer side."""
    lines = to_mm(scenery.room.width), to_mm(scenery.room.depth)
    clear, size = scenery.space.clear, millimetres(scenery.terms.catalogs.decorations[name].size)
    wide = lines[0] >= lines[1]
    if row.fill is not None:
        most = to_mm(row.widest) if row.widest else max(lines)
        longer, lesser = int(max(lines) * row.fill), min(int(min(lines) * row.fill), most)
        size = longer // 10 * 10, lesser // 10 * 10, size[2]
    across, along = (size[0], size[1]) if wide else (size[1], size[0])
    x0, z0 = (lines[0] - across) // 2, (lines[1] - along) // 2
    place = Rect(x0, z0, x0 + across, z0 + along)
    outline = [zone.rect for zone in scenery.space.zones if zone.cause == "outline"]
    if clear.contains(place) and not any(place.overlaps(rect) for rect in outline):
        scenery.add(New(name, place, 0, size, 0 if wide else 90), row)


def _scatter(scenery: Scenery, walking: Walking, row: Stands, names: Sequence[str]) -> None:
    """Stands a row's things one after the other, each at the first spot that has a place."""
    area = scenery.room.width * scenery.room.depth
    count = row.count if row.per_area is None else max(1, min(row.count, int(area / row.per_area)))
    first = scenery.stream.below(len(names)) if len(names) > 1 else 0
    spots = list(_spots(scenery, row))
    for k in range(count):
        name = names[(first + k) % len(names)]
        taken = next((spot for spot in spots if _stood(scenery, walking, row, name, spot)), None)
        if taken is not None and row.where == "corner":
            corner = spots.index(taken) // 2 * 2
            del spots[corner : corner + 2]


def _spots(scenery: Scenery, row: Stands) -> Iterator[Spot]:
    clear, stream = scenery.space.clear, scenery.stream
    if row.where == "corner":
        corners = [(x, z) for x in (clear.x0, clear.x1) for z in (clear.z0, clear.z1)]
        stream.shuffle(corners)
        for x, z in corners:
            yield _at_wall(scenery, "north" if z == clear.z0 else "south", x)
            yield _at_wall(scenery, "west" if x == clear.x0 else "east", z)
    elif row.where == "free":
        inner = clear.shrunk(OFF_WALL_MM)
        for _ in range(TRIES):
            yield Spot(inner, (inner.x0 + stream.below(inner.width + 1), inner.z0 + stream.below(inner.depth + 1)), 90 * stream.below(4))
    else:
        if row.where == "beside":
            yield from _beside(scenery, row)
        walls = list(WALLS)
        stream.shuffle(walls)
        for wall in walls:
            a, b = clear.along(wall)
            yield _at_wall(scenery, wall, a + stream.below(b - a + 1))


def _beside(scenery: Scenery, row: Stands) -> Iterator[Spot]:
    """Yields places at both ends of the pieces named, the first names first, along the wall behind them."""
    for name in row.of:
        for piece in (piece for piece in scenery.pieces if piece.name == name and piece.low == 0):
            wall = WALL_BEHIND[piece.rotation]
            ends = list(piece.rect.along(wall))
            scenery.stream.shuffle(ends)
            yield from (_at_wall(scenery, wall, end) for end in ends)


def _at_wall(scenery: Scenery, wall: str, along: int) -> Spot:
    clear = scenery.space.clear.shrunk(OFF_WALL_MM)
    point = strip(clear, wall, (along, along), 0)
    return Spot(clear, (point.x0, point.z0), ROTATION_AT_WALL[wall])


def _stood(scenery: Scenery, walking: Walking, row: Stands, name: str, spot: Spot) -> bool:
    """Stands a thing near a spot; tells whether it found a place."""
    kind = scenery.terms.catalogs.decorations[name]
    askew = scenery.jitter(kind)
    blocks = _blocks(scenery, row, spot, kind)
    for size in sizes(kind, row):
        for angle in (askew, 0) if askew else (0,):
            rotation = spot.rotation + angle
            place = _free(row, spot, extents(size[0], size[1], rotation), blocks)
            if place is None or (size[2] > BODY_MM and not walking.passes(place)):
                continue
            scenery.add(New(name, place, 0, size, rotation), row)
            if size[2] > BODY_MM:
                walking.add(place)
            return True
    return False


def _blocks(scenery: Scenery, row: Stands, spot: Spot, kind: DecorationKind) -> list[Rect]:
    """Returns what a thing must keep out of around a spot."""
    width, depth, height = millimetres(kind.size)
    far = to_mm(row.reach) + 2 * (width + depth)
    around = Rect(spot.wish[0] - far, spot.wish[1] - far, spot.wish[0] + far, spot.wish[1] + far)
    blocks = [zone.rect for zone in scenery.space.zones if height > zone.above_mm]
    blocks += [solid.rect for solid in scenery.solids if solid.low < height]
    if row.where != "free":
        blocks += [_front(piece) for piece in scenery.pieces if piece.name in scenery.terms.faced]
    return [rect for rect in blocks if rect.overlaps(around)]


def _front(piece: Carrier) -> Rect:
    """Returns the floor before a piece that nothing should be put on."""
    fx, fz = FACING[piece.rotation]
    rect = piece.rect
    return Rect(
        rect.x0 + min(0, fx * FRONT_MM), rect.z0 + min(0, fz * FRONT_MM), rect.x1 + max(0, fx * FRONT_MM), rect.z1 + max(0, fz * FRONT_MM)
    )


def _free(row: Stands, spot: Spot, extent: tuple[int, int], blocks: Sequence[Rect]) -> Rect | None:
    """Returns the free place nearest to a spot: along the wall it is at, or anywhere within the row's reach."""
    area, wish = spot.area, (spot.wish[0] - extent[0] // 2, spot.wish[1] - extent[1] // 2)
    if row.where != "free":
        wall = WALL_BEHIND[spot.rotation]
        area = strip(area, wall, area.along(wall), extent[1] if wall in ("north", "south") else extent[0])
    return nearest(area, wish, extent, blocks, to_mm(row.reach))
