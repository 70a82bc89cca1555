"""What lies on things: rows dealt over a carrier's surfaces.

Comes in: a Scenery and a carrier. Goes out: nothing; the scenery has more things. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from catalogs.dressing import ALL, SURFACE, Lies
from catalogs.entries import Surface
from solver.dress.scenery import Carrier, New, Scenery, Size, extents, nearest, sizes
from solver.geometry import FACING, Rect, to_mm

GAP_MM: Final = 5
"""Between two things on a surface. Our choice."""
SEAT_MM: Final = 300
"""How far from a table a chair may stand to count as a seat at it. Our choice."""
LONGEST_SEAT_MM: Final = 1000
"""What is longer from front to back is to lie on. Our choice."""


class Spot(NamedTuple):
    """A place wished for: on which carrier's surface, where on it (share of the room's x and z), how turned.

    `middle` says where its middle is wished along x and z instead, mm, where it is not None.
    """

    carrier: Carrier
    surface: Surface
    share: tuple[float, float]
    rotation: int
    middle: tuple[int | None, int | None] = (None, None)


def lay(scenery: Scenery, carriers: Sequence[Carrier]) -> None:
    """Lays the rows of their kind on carriers of one name; what stands on several, once on the first that takes it."""
    entry = scenery.terms.catalogs.dressing.get(carriers[0].name)
    for row in entry.lies if entry else ():
        names = scenery.wanted(row)
        if names:
            _deal(scenery, carriers, row, names)


def _deal(scenery: Scenery, carriers: Sequence[Carrier], row: Lies, names: Sequence[str]) -> None:
    """Puts a row's things at its spots; where they find no place on one carrier, on the next."""
    first = scenery.stream.below(len(names)) if len(names) > 1 else 0
    every = [list(spots(scenery, carrier, row)) for carrier in carriers]
    for k in range(max(map(len, every))):
        for found in every:
            if k < len(found) and put(scenery, found[k], row, names[(first + k) % len(names)]):
                break


def spots(scenery: Scenery, carrier: Carrier, row: Lies) -> Iterator[Spot]:
    """Yields the places of a row on a carrier, and on what is already on it."""
    for below in _below(scenery, carrier, row):
        for surface in _surfaces(below, row, own=below is carrier):
            if row.at == "seats":
                yield from _seats(scenery, below, surface)
                continue
            for across, along in row.at:
                dx, dz = _turned(across - 0.5, along - 0.5, below.rotation)
                yield Spot(below, surface, (0.5 + dx, 0.5 + dz), (below.rotation + row.turn) % 360)


def _turned(across: float, along: float, rotation: int) -> tuple[float, float]:
    fx, fz = FACING[rotation // 90 * 90 % 360]
    return across * fz + along * fx, along * fz - across * fx


def _below(scenery: Scenery, carrier: Carrier, row: Lies) -> list[Carrier]:
    """Returns what a row's things lie on: things on the carrier, of the first kind that is there, or the carrier."""
    for name in row.upon or (SURFACE,):
        if name == SURFACE:
            return [carrier]
        found = [thing for thing in scenery.carried.get(carrier.id, ()) if thing.name == name and thing.surfaces]
        if found:
            return found
    return []


def _surfaces(below: Carrier, row: Lies, own: bool) -> Sequence[Surface]:
    if not own or not row.surface:
        return below.surfaces[-1:]
    return [surface for surface in below.surfaces if ALL in row.surface or surface.name in row.surface]


def _seats(scenery: Scenery, table: Carrier, surface: Surface) -> Iterator[Spot]:
    """Yields a place at the edge before every chair that faces the table."""
    for chair in scenery.pieces:
        if chair.id not in scenery.tucked.get(table.id, ()) and not _sits_at(chair, table):
            continue
        fx, fz = FACING[chair.rotation]
        middle = (chair.rect.x0 + chair.rect.x1) // 2, (chair.rect.z0 + chair.rect.z1) // 2
        along = (None, middle[1]) if fx else (middle[0], None)
        yield Spot(table, surface, (0.5 - fx / 2, 0.5 - fz / 2), (chair.rotation + 180) % 360, along)


def _sits_at(chair: Carrier, table: Carrier) -> bool:
    """Tells whether a chair stands before a table's edge, facing it."""
    fx, fz = FACING[chair.rotation]
    rect = chair.rect
    length = rect.width if fx else rect.depth
    if length > LONGEST_SEAT_MM or not any(surface.name == "seat" for surface in chair.surfaces):
        return False
    x, z = (rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2
    before = Rect(x - 1, z - 1, x + 1, z + 1), length // 2 + SEAT_MM
    ahead = Rect(
        before[0].x0 + min(0, fx * before[1]), before[0].z0 + min(0, fz * before[1]),
        before[0].x1 + max(0, fx * before[1]), before[0].z1 + max(0, fz * before[1]),
    )  # fmt: skip
    return ahead.overlaps(table.rect)


def _area(carrier: Carrier, surface: Surface) -> Rect:
    return carrier.rect.shrunk(to_mm(surface.inset))


def put(scenery: Scenery, spot: Spot, row: Lies, name: str) -> bool:
    """Puts a thing at a spot or as near as it can; tells whether it found a place."""
    kind = scenery.terms.catalogs.decorations[name]
    area, low = _area(spot.carrier, spot.surface), spot.carrier.low + to_mm(spot.surface.height)
    askew = 0 if row.upright else scenery.jitter(kind)
    ways = [_filled(area, spot, row, sizes(kind, row, row.upright)[0])] if row.fill else sizes(kind, row, row.upright)
    height = ways[0][2]
    room = scenery.ceiling - low if spot.surface.clearance is None else to_mm(spot.surface.clearance)
    if height > room:
        return False
    ignored = spot.carrier.within | scenery.tucked.get(spot.carrier.root, frozenset())
    blocks = [rect.shrunk(-GAP_MM) for rect in scenery.near(area, low, low + height, ignored)]
    reach = None if row.reach is None else to_mm(row.reach)
    for size in ways:
        for angle in (askew, 0) if askew else (0,):
            rotation = spot.rotation + angle
            across, along = extents(size[0], size[1], rotation)
            place = nearest(area, _wish(area, spot, (across, along)), (across, along), blocks, reach)
            if place is not None:
                scenery.add(New(name, place, low, size, rotation), row, spot.carrier)
                return True
    return False


def _wish(area: Rect, spot: Spot, extent: tuple[int, int]) -> tuple[int, int]:
    """Returns the wished min corner of a thing, mm."""
    x, z = spot.middle
    return (
        area.x0 + round((area.width - extent[0]) * spot.share[0]) if x is None else x - extent[0] // 2,
        area.z0 + round((area.depth - extent[1]) * spot.share[1]) if z is None else z - extent[1] // 2,
    )


def _filled(area: Rect, spot: Spot, row: Lies, own: Size) -> Size:
    """Returns the extents that fill the wished share of a surface, whole centimetres; a thing's own where the share is 0."""
    wide, deep = (area.width, area.depth) if spot.rotation % 180 == 0 else (area.depth, area.width)
    across, along = row.fill or (0.0, 0.0)
    width = max(10, int(wide * across) // 10 * 10) if across else own[0]
    depth = max(10, int(deep * along) // 10 * 10) if along else own[1]
    return width, depth, own[2]
