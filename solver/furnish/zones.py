"""From a room of the scene to the space its furniture may stand in, and the zones kept free (docs/scene.md), in integer millimetres."""

import math
from collections.abc import Sequence
from typing import Final

from catalogs.access_profiles import AccessProfile
from solver.geometry import ALONG_X, INWARDS, OPPOSITE, Rect, edges_round, strip_at, tiles_between, to_mm, walls_round
from solver.pieces import Doorway, Opened, Space, Zone
from solver.records import changed
from solver.relations.subject import Scope
from solver.scene import WALLS, Opening, Room, Sides
from solver.wall_fittings import WIDEST_LEAF

DOOR_SQUARE_MM = 900
"""A door's square is as deep as the door is wide, but at most this (docs/scene.md, blocks_door)."""
WINDOW_DEPTH_MM, WINDOW_SIDE_MM = 500, 100
"""Before a window and to each side of it nothing taller than its sill may stand (docs/scene.md, blocks_window)."""

_SPACE: Final = Space("", Rect(0, 0, 0, 0), (), ())
WallLine = tuple[str, int, int, int]
"""A stretch of wall line: the wall it is part of, its coordinate across, and its ends along, mm."""


def space_of(room: Room, wall_thickness: float, robot_width: float = 0.6, others: Sequence[Room] = (), cover_mm2: int = 0) -> Space:
    """Returns where a room's furniture may stand.

    Args:
        room: with its openings; an outline, if there is one, must be rectilinear.
        wall_thickness: of inner walls, m; half of it lies inside the room.
        robot_width: side, m, of the square that must be able to walk everywhere.
        others: rooms whose doors into this one keep their squares here too, should this one not list them.
        cover_mm2: how much floor the furniture shall cover at least; 0: whatever it covers.
    """
    lines, edges, half = bounds_of(room), outline_edges(room), (to_mm(wall_thickness) + 1) // 2
    between = int(_is_between_millimetres(room))
    inner = half + between
    zones = [Zone(rect, -1, "outline") for rect in missing_parts(room, inner)]
    doorways: list[Doorway] = []
    openings: list[Opened] = []
    for opening in room.openings:
        line = _line_among(lines, edges, opening)
        if line is None:
            continue
        openings.append(_opened(opening, line))
        zone = opening_zone(opening, line, lines)
        if zone is None:
            continue
        if opening.kind != "garage_door":
            zones.append(zone._replace(rect=zone.rect.shrunk(-between)) if between else zone)
        if opening.kind != "window":
            swings_in = opening.kind == "door" and opening.swing == "in"
            doorways.append(Doorway(opening.id, line[0], zone.rect, opening.connects_to or "", swings_in=swings_in))
    beyond = doorways_of_others(room, others)
    zones += [Zone(doorway.square.shrunk(-between), -1, doorway.id) for doorway in beyond]
    entered = (_from_face(one, lines, inner) for one in (*doorways, *beyond))
    found = {"zones": tuple(zones), "doorways": tuple(entered), "openings": tuple(openings), "cover_mm2": cover_mm2}
    return changed(_SPACE, room=room.id, clear=lines.shrunk(half), robot_mm=to_mm(robot_width), **found)


def _opened(opening: Opening, line: WallLine) -> Opened:
    """Returns an opening as the relations see it, in a stretch of wall line."""
    centre, half = line[2] + to_mm(opening.position), to_mm(opening.width) // 2
    kind = "front_door" if opening.main_entrance else opening.kind
    return Opened(kind, line[0], (centre - half, centre + half), line[1])


def _from_face(doorway: Doorway, lines: Rect, inner: int) -> Doorway:
    """Returns a doorway with its square from the wall's face on, so far `inner`, where the wall is not the room's outermost."""
    square, wall = doorway.square, doorway.wall
    if square.line(wall) == lines.line(wall):
        return doorway
    start, end = square.along(wall)
    deep = square.depth if wall in ALONG_X else square.width
    return doorway._replace(square=strip_at(wall, square.line(wall) + INWARDS[wall] * inner, (start, end), deep - inner))


def scope_of(room: Room, space: Space) -> Scope:
    """Returns a room as the relations see it; `space` is its own."""
    return Scope(space.clear, space.openings, space.gap_mm, room.exterior_walls or Sides())


def bounds_of(room: Room) -> Rect:
    """Returns the rectangle of a room's wall lines, mm, rounded inwards by less than a millimetre."""
    if not room.outline:
        return Rect(0, 0, _down(room.width * 1000), _down(room.depth * 1000))
    xs, zs = [x * 1000 for x, _ in room.outline], [z * 1000 for _, z in room.outline]
    return Rect(_up(min(xs)), _up(min(zs)), _down(max(xs)), _down(max(zs)))


def _up(mm: float) -> int:
    return math.ceil(mm - 1e-4)


def _down(mm: float) -> int:
    return math.floor(mm + 1e-4)


def doorways_of_others(room: Room, others: Sequence[Room]) -> list[Doorway]:
    """Returns the doors into a room that only the room on the other side lists, with their squares inside this one."""
    if not others:
        return []
    own, lines = {opening.id for opening in room.openings}, bounds_of(room)
    found = []
    for other in others:
        for opening in other.openings:
            listed = opening.connects_to != room.id or opening.id in own or other.id == room.id
            line = None if listed or opening.kind not in ("door", "passage") else line_of(other, opening)
            if line is None:
                continue
            dx, dz = to_mm(other.x) - to_mm(room.x), to_mm(other.z) - to_mm(room.z)
            across, along = (dz, dx) if line[0] in ("north", "south") else (dx, dz)
            beyond = (OPPOSITE[line[0]], line[1] + across, line[2] + along, line[3] + along)
            zone = opening_zone(opening, beyond, lines)
            if zone is not None:
                found.append(Doorway(opening.id, beyond[0], zone.rect, other.id))
    return found


def line_of(room: Room, opening: Opening) -> WallLine | None:
    """Returns the stretch of wall line an opening is in, or None where it names no wall or edge of the room."""
    return _line_among(bounds_of(room), outline_edges(room), opening)


def _line_among(lines: Rect, edges: Sequence[WallLine], opening: Opening) -> WallLine | None:
    """Returns the same of a room with those bounds and edges."""
    if opening.edge is not None:
        return edges[opening.edge] if opening.edge < len(edges) else None
    wall = opening.wall or ""
    if wall not in WALLS:
        return None
    across = bound = lines.line(wall)
    if edges:
        at = to_mm(opening.position)
        here = [line for name, line, start, end in edges if name == wall and start <= at <= end and start < end]
        across = min(here, key=lambda line: abs(line - bound), default=bound)
    return (wall, across, 0, lines.along(wall)[1])


def outline_edges(room: Room) -> list[WallLine]:
    """Returns the edges of a room's outline, from its first point on; empty without an outline."""
    return list(walls_round([(to_mm(x), to_mm(z)) for x, z in room.outline])) if room.outline else []


def opening_zone(opening: Opening, line: WallLine, room: Rect) -> Zone | None:
    """Returns the floor before an opening, or None if none; rounded outwards by less than a millimetre.

    It is kept free but for that before a garage door, which one has only to come past.
    """
    start, width = line[2], opening.width * 1000
    if opening.kind in ("door", "passage", "garage_door"):
        depth, side, above = min(_up(width), DOOR_SQUARE_MM), 0, -1
    elif opening.kind == "window":
        depth, side, above = WINDOW_DEPTH_MM, WINDOW_SIDE_MM, _down(opening.sill * 1000)
    else:
        return None
    centre = start + opening.position * 1000
    low, high = _down(centre - width / 2) - side, _up(centre + width / 2) + side
    rect = _clipped(strip_at(line[0], line[1], (low, high), depth), room)
    return None if rect is None else Zone(rect, above, opening.id)


def floor_before_doors(room: Room, clear: Rect, profile: AccessProfile) -> list[Rect]:
    """Returns what of a room's clear floor a profile asks for before the leaves of its doors: so deep, and so far beside their latches."""
    rules = [rule for rule in profile.rules if rule.what == "approach" and rule.is_about(room.type)]
    lines, edges = bounds_of(room), outline_edges(room) if rules else []
    half, found = clear.x0 - lines.x0, list[Rect]()
    for opening in room.openings if rules else ():
        line = _line_among(lines, edges, opening)
        if opening.kind != "door" or line is None:
            continue
        wall, across, (low, high) = line[0], line[1] + INWARDS[line[0]] * half, _opened(opening, line).interval
        for rule in (one for one in rules if one.pull == (opening.swing == "in")):
            beside = to_mm(rule.latch) if opening.hinge and opening.width <= WIDEST_LEAF else 0
            span = (low, high + beside) if opening.hinge == "start" else (low - beside, high)
            if floor := _clipped(strip_at(wall, across, span, to_mm(rule.min)), clear):
                found.append(floor)
    return found


def _clipped(rect: Rect, room: Rect) -> Rect | None:
    cut = rect if room.contains(rect) else rect.common(room)
    return cut if cut.x0 < cut.x1 and cut.z0 < cut.z1 else None


def _is_between_millimetres(room: Room) -> bool:
    """Tells whether a corner of a room's outline is: then the faces of its inner walls are taken to lie one farther in."""
    return any(abs(v * 1000 - to_mm(v)) > 1e-4 for corner in room.outline or () for v in corner)


def missing_parts(room: Room, inner: int) -> list[Rect]:
    """Returns the parts of the bounding rectangle outside the outline, grown to the faces of the walls, as maximal columns."""
    if not room.outline:
        return []
    points = [(to_mm(x), to_mm(z)) for x, z in room.outline]
    lines = bounds_of(room)
    (west, east), (north, south) = ((min(values), max(values)) for values in zip(*points, strict=True))
    across = [(z0, x0, x1) for (x0, z0), (x1, z1) in edges_round(points) if z0 == z1]
    columns = sorted(Rect(x0, z0, x1, z1) for z0, x0, z1, x1 in tiles_between([(north, west, east), *across, (south, west, east)]))
    grown = (_clipped(rect.shrunk(-inner), lines) for rect in columns)
    return [rect for rect in grown if rect]
