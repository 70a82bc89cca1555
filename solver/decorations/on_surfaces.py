"""What lies on things: rows dealt over a carrier's surfaces.

Comes in: a DecoratedRoom and a carrier. Goes out: nothing; the room has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from catalogs.dressing import ALL, SURFACE, Lies
from catalogs.entries import Surface
from solver.decorations.decorated_room import Carrier, DecoratedRoom, NewThing, SizeMm, bounds_of, centimetres, sizes
from solver.free_places import nearest_place
from solver.geometry import FACING, Rect, rotate, to_mm

GAP_MM: Final = 5
"""Between two things on a surface. Our choice."""
SEAT_MM: Final = 300
"""How far from a table a chair may stand to count as a seat at it. Our choice."""
LONGEST_SEAT_MM: Final = 1000
"""What is longer from front to back is to lie on. Our choice."""


class SurfaceSpot(NamedTuple):
    """A place wished for: on which carrier's surface, where on it (share of the room's x and z), how turned.

    `middle` says where its middle is wished along x and z instead, mm, where it is not None.
    """

    carrier: Carrier
    surface: Surface
    share: tuple[float, float]
    rotation: int
    middle: tuple[int | None, int | None] = (None, None)


def lay(decorated: DecoratedRoom, carriers: Sequence[Carrier]) -> None:
    """Lays the rows of their kind on carriers of one name; what stands on several, once on the first that takes it."""
    entry = decorated.catalogs.dressing.get(carriers[0].name)
    for row in entry.lies if entry else ():
        names = decorated.wanted(row)
        if names:
            every = [list(_spots(decorated, carrier, row)) for carrier in carriers]
            for k in range(max(map(len, every))):
                name = names[k % len(names)]
                any(_put(decorated, found[k], row, name) for found in every if k < len(found))


def _spots(decorated: DecoratedRoom, carrier: Carrier, row: Lies) -> Iterator[SurfaceSpot]:
    """Yields the places of a row on a carrier, and on what is already on it."""
    for below in _below(decorated, carrier, row):
        for surface in _surfaces(below, row, own=below is carrier):
            if row.at == "seats":
                yield from _seats(decorated, below, surface)
                continue
            for across, along in row.at:
                dx, dz = rotate(across - 0.5, along - 0.5, below.rotation // 90 * 90)
                yield SurfaceSpot(below, surface, (0.5 + dx, 0.5 + dz), (below.rotation + row.turn) % 360)


def _below(decorated: DecoratedRoom, carrier: Carrier, row: Lies) -> list[Carrier]:
    """Returns what a row's things lie on: things on the carrier, of the first kind that is there, or the carrier."""
    for name in row.upon or (SURFACE,):
        if name == SURFACE:
            return [carrier]
        found = [thing for thing in decorated.carried.get(carrier.id, ()) if thing.name == name and thing.surfaces]
        if found:
            return found
    return []


def _surfaces(below: Carrier, row: Lies, own: bool) -> Sequence[Surface]:
    if not own or not row.surface:
        return below.surfaces[-1:]
    return [surface for surface in below.surfaces if ALL in row.surface or surface.name in row.surface]


def _seats(decorated: DecoratedRoom, table: Carrier, surface: Surface) -> Iterator[SurfaceSpot]:
    """Yields a place at the edge before every chair that faces the table."""
    for chair in decorated.pieces:
        if chair.id in decorated.tucked.get(table.id, ()) or _sits_at(chair, table):
            fx, fz = FACING[chair.rotation]
            x, z = chair.rect.centre
            along = (None, z) if fx else (x, None)
            yield SurfaceSpot(table, surface, (0.5 - fx / 2, 0.5 - fz / 2), (chair.rotation + 180) % 360, along)


def _sits_at(chair: Carrier, table: Carrier) -> bool:
    """Tells whether a chair stands before a table's edge, facing it."""
    fx, fz = FACING[chair.rotation]
    length = chair.rect.width if fx else chair.rect.depth
    if length > LONGEST_SEAT_MM or not any(surface.name == "seat" for surface in chair.surfaces):
        return False
    reach = length // 2 + SEAT_MM
    return Rect.around(chair.rect.centre, (2, 2)).swept(fx * reach, fz * reach).overlaps(table.rect)


def _put(decorated: DecoratedRoom, spot: SurfaceSpot, row: Lies, name: str) -> bool:
    """Puts a thing at a spot or as near as it can; tells whether it found a place."""
    kind = decorated.catalogs.decorations[name]
    area, low = spot.carrier.rect.shrunk(to_mm(spot.surface.inset)), spot.carrier.low + to_mm(spot.surface.height)
    askew = 0 if row.upright else decorated.jitter(kind)
    tried = sizes(kind, row, row.upright)
    if row.fill:
        tried = [_filled(area, spot, row.fill, tried[0])]
    height = tried[0][2]
    if height > (decorated.ceiling - low if spot.surface.clearance is None else to_mm(spot.surface.clearance)):
        return False
    ignored = spot.carrier.within | decorated.tucked.get(spot.carrier.root, frozenset())
    blocks = [rect.shrunk(-GAP_MM) for rect in decorated.near(area, low, low + height, ignored)]
    reach = None if row.reach is None else to_mm(row.reach)
    for size in tried:
        for angle in (askew, 0) if askew else (0,):
            rotation = spot.rotation + angle
            place = nearest_place(_wish(area, spot, bounds_of(size, rotation)).held_in(area), area, blocks, reach)
            if place is not None:
                decorated.add(NewThing(name, place, low, size, rotation), row, spot.carrier)
                return True
    return False


def _wish(area: Rect, spot: SurfaceSpot, extent: tuple[int, int]) -> Rect:
    """Returns where a thing is wished."""
    x, z = spot.middle
    x0 = area.x0 + round((area.width - extent[0]) * spot.share[0]) if x is None else x - extent[0] // 2
    z0 = area.z0 + round((area.depth - extent[1]) * spot.share[1]) if z is None else z - extent[1] // 2
    return Rect(x0, z0, x0 + extent[0], z0 + extent[1])


def _filled(area: Rect, spot: SurfaceSpot, fill: tuple[float, float], own: SizeMm) -> SizeMm:
    """Returns the extents that fill the wished share of a surface, whole centimetres; a thing's own where the share is 0."""
    wide, deep = (area.width, area.depth) if spot.rotation % 180 == 0 else (area.depth, area.width)
    return centimetres(wide * fill[0]) if fill[0] else own[0], centimetres(deep * fill[1]) if fill[1] else own[1], own[2]
