"""What stands and lies on a room's floor: rugs, plants, toys, entry things.

Comes in: a DecoratedRoom. Goes out: nothing; the room has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from catalogs.dressing import INDOOR, DecorationKind, Stands
from solver.decorations.decorated_room import Carrier, DecoratedRoom, NewThing, bounds_of, millimetres, sizes
from solver.free_floor import FreeFloor
from solver.free_places import FLAT_MM, Block, nearest_place
from solver.geometry import ALONG_X, FACING, ROTATION_AT_WALL, WALL_BEHIND, Rect, strip, to_mm
from solver.scene import WALLS

OFF_WALL_MM: Final = 30
"""What stands at a wall stands this far from its face, as furniture does."""
FRONT_MM: Final = 300
"""How much floor before a cupboard's doors things that do not lie about leave free. Our choice."""
TRIES: Final = 3
"""Places tried for a thing that stands anywhere. Our choice."""


class FloorSpot(NamedTuple):
    """A place wished for: inside an area, near a point (mm), turned so."""

    area: Rect
    wish: tuple[int, int]
    rotation: int


def stand(decorated: DecoratedRoom) -> None:
    """Puts the rows of the room's type, and those for every indoor room, on its floor."""
    dressing, room = decorated.catalogs.dressing, decorated.room
    own = dressing.get(room.type)
    rows: list[Stands] = []
    if not room.outdoor and (own is None or own.indoor) and INDOOR in dressing:
        rows += dressing[INDOOR].stands
    rows += own.stands if own else ()
    floor = FreeFloor.of_room(room, decorated.space, decorated.catalogs.use_sides())
    for row in rows:
        names = decorated.wanted(row)
        if not names or min(room.width, room.depth) < row.min_side:
            continue
        if row.where == "middle":
            _spread(decorated, row, names[0])
        else:
            _scatter(decorated, floor, row, names)


def _spread(decorated: DecoratedRoom, row: Stands, name: str) -> None:
    """Lays a rug in the middle of the room, along its longer side."""
    lines = to_mm(decorated.room.width), to_mm(decorated.room.depth)
    size = millimetres(decorated.catalogs.decorations[name].size)
    rotation = 0 if lines[0] >= lines[1] else 90
    if row.fill is not None:
        most = to_mm(row.widest) if row.widest else max(lines)
        longer, lesser = int(max(lines) * row.fill), min(int(min(lines) * row.fill), most)
        size = longer // 10 * 10, lesser // 10 * 10, size[2]
    across, along = bounds_of(size, rotation)
    place = Rect(0, 0, across, along).moved((lines[0] - across) // 2, (lines[1] - along) // 2)
    missing = (zone.rect for zone in decorated.space.zones if zone.cause == "outline")
    if decorated.space.clear.contains(place) and not any(map(place.overlaps, missing)):
        decorated.add(NewThing(name, place, 0, size, rotation), row)


def _scatter(decorated: DecoratedRoom, floor: FreeFloor, row: Stands, names: Sequence[str]) -> None:
    """Stands a row's things one after the other, each at the first spot that has a place."""
    area = decorated.room.width * decorated.room.depth
    count = row.count if row.per_area is None else max(1, min(row.count, int(area / row.per_area)))
    spots = list(_spots(decorated, row))
    for k in range(count):
        name = names[k % len(names)]
        taken = next((spot for spot in spots if _stood(decorated, floor, row, name, spot)), None)
        if taken is not None and row.where == "corner":
            corner = spots.index(taken) // 2 * 2
            del spots[corner : corner + 2]


def _spots(decorated: DecoratedRoom, row: Stands) -> Iterator[FloorSpot]:
    clear, stream = decorated.space.clear, decorated.stream
    if row.where == "corner":
        corners = [(x, z) for x in (clear.x0, clear.x1) for z in (clear.z0, clear.z1)]
        stream.shuffle(corners)
        for x, z in corners:
            yield _at_wall(clear, "north" if z == clear.z0 else "south", x)
            yield _at_wall(clear, "west" if x == clear.x0 else "east", z)
    elif row.where == "free":
        inner = clear.shrunk(OFF_WALL_MM)
        for _ in range(TRIES):
            wish = inner.x0 + stream.below(inner.width + 1), inner.z0 + stream.below(inner.depth + 1)
            yield FloorSpot(inner, wish, 90 * stream.below(4))
    else:
        if row.where == "beside":
            yield from _beside(decorated, row)
        walls = list(WALLS)
        stream.shuffle(walls)
        for wall in walls:
            a, b = clear.along(wall)
            yield _at_wall(clear, wall, a + stream.below(b - a + 1))


def _beside(decorated: DecoratedRoom, row: Stands) -> Iterator[FloorSpot]:
    """Yields places at both ends of the pieces named, the first names first, along the wall behind them."""
    for name in row.of:
        for piece in (piece for piece in decorated.pieces if piece.name == name and piece.low == 0):
            wall = WALL_BEHIND[piece.rotation]
            ends = list(piece.rect.along(wall))
            decorated.stream.shuffle(ends)
            yield from (_at_wall(decorated.space.clear, wall, end) for end in ends)


def _at_wall(clear: Rect, wall: str, along: int) -> FloorSpot:
    inner = clear.shrunk(OFF_WALL_MM)
    return FloorSpot(inner, inner.point_at(wall, along, 0), ROTATION_AT_WALL[wall])


def _stood(decorated: DecoratedRoom, floor: FreeFloor, row: Stands, name: str, spot: FloorSpot) -> bool:
    """Stands a thing near a spot; tells whether it found a place. Where nobody could come in before, no body may stand."""
    kind = decorated.catalogs.decorations[name]
    askew = decorated.jitter(kind)
    blocks = _blocks(decorated, row, spot, kind)
    for size in sizes(kind, row):
        for angle in (askew, 0) if askew else (0,):
            rotation = spot.rotation + angle
            place = _free(row, spot, bounds_of(size, rotation), blocks)
            is_body = size[2] > FLAT_MM
            if place is None or (is_body and not (decorated.space.doorways and floor.connects([place]))):
                continue
            decorated.add(NewThing(name, place, 0, size, rotation), row)
            if is_body:
                floor.add(Block(place, 0, size[2]))
            return True
    return False


def _blocks(decorated: DecoratedRoom, row: Stands, spot: FloorSpot, kind: DecorationKind) -> list[Rect]:
    """Returns what a thing must keep out of around a spot."""
    width, depth, height = millimetres(kind.size)
    far = to_mm(row.reach) + 2 * (width + depth)
    blocks = [zone.rect for zone in decorated.space.zones if height > zone.above_mm]
    blocks += [block.rect for block in decorated.blocks if block.low < height]
    if row.where != "free":
        blocks += [_with_front(piece) for piece in decorated.pieces if piece.name in decorated.settings.faced]
    return list(filter(Rect(*spot.wish, *spot.wish).shrunk(-far).overlaps, blocks))


def _with_front(piece: Carrier) -> Rect:
    """Returns a piece's footprint and the floor before it that nothing should be put on."""
    fx, fz = FACING[piece.rotation]
    return piece.rect.swept(fx * FRONT_MM, fz * FRONT_MM)


def _free(row: Stands, spot: FloorSpot, extent: tuple[int, int], blocks: Sequence[Rect]) -> Rect | None:
    """Returns the free place nearest to a spot: along the wall it is at, or anywhere within the row's reach."""
    area = spot.area
    if row.where != "free":
        wall = WALL_BEHIND[spot.rotation]
        area = strip(area, wall, area.along(wall), extent[1] if wall in ALONG_X else extent[0])
    return nearest_place(Rect.around(spot.wish, extent).held_in(area), area, blocks, to_mm(row.reach))
