"""Walls without rooms -> the rooms between them, in the drawing's own unit."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from statistics import median
from typing import Final, NamedTuple

import numpy as np

from solver.answers import Unread
from solver.geometry import bounds_of_points, edges_round, encloses
from solver.imports.drawn import DrawnOpening, DrawnPlan, DrawnRoom, DrawnWall, Spot
from solver.imports.rectilinear import FloorCorners
from solver.imports.shape_openings import between, sides_of, to_lines
from solver.imports.steps_inside import STEP
from solver.imports.straighten import turn_of, turned_by
from solver.imports.units import told_by_doors
from solver.imports.wall_faces import STRAIGHT, ClosetSigns, faces_between, free_ends, line_between, thickness_about
from solver.imports.wall_gaps import BESIDE, PASSAGES, Fitted, WallGap, fitted, gaps_of

NO_UNIT: Final = "no rooms are drawn, and neither a unit nor doors tell how thick walls are: `unit` says it"
"""Why walls are left out where nothing tells how long they are."""
GAPS: Final = "enclose no room: gaps in which no door, window or opening is drawn leave them open"
"""Why there are no rooms where each end of a wall meets another wall."""
SLANTED: Final = "{} slanted or curved lines: rooms are looked for between straight ones"
GAPS_TAKEN: Final = "gaps in which nothing is drawn are taken as passages: {}"
GAP: Final = "a gap in walls"
"""The place of a passage in which nothing is drawn."""
UP_TO_WALLS: Final = 1000
"""A gap up to a wall across the way is a passage, mm, where nothing is named, if it is no wider: hallways are."""
INSIDE: Final = 0.05
"""So far from a side, m, a spot is within an outline; nearer it is on it."""
THICKEST: Final = 1.0
"""Of a wall that is an area or at an opening, m."""
LEAST_HOME: Final = 20.0
"""m2: what is smaller and lies within a room is a part of the home, such as its bathroom."""


class Between(NamedTuple):
    """What walls enclose: rooms, how thick walls are (None where they are drawn as single lines), what could not be read.

    `passages` are gaps in which nothing is drawn.
    """

    rooms: list[DrawnRoom]
    thickness: float | None
    told: list[Unread]
    passages: list[DrawnOpening]


class WallOutlines(NamedTuple):
    """The lines of walls, closed ones with their first point repeated; and which of them are areas."""

    lines: Sequence[tuple[Spot, ...]]
    areas: Sequence[Sequence[Spot]] = ()


class NamedSpot(NamedTuple):
    """A point that is in a room of a name."""

    x: float
    z: float
    name: str


def with_rooms_between(plan: DrawnPlan, metres: float | None) -> DrawnPlan:
    """Returns a plan with thick walls with the rooms that these enclose and it does not draw, on each level, at any angle.

    Where it draws some, on any level, others are those into which a door leads, between walls that are not low. `metres` is the length of
    its unit, where the caller says it.
    """
    walls = [one for one in plan.walls if math.dist(one.start, one.end) > 0 and not (plan.rooms and (one.low or not one.thickness))]
    if not walls:
        return plan
    unit = metres or told_by_doors(plan.openings, plan.metres).metres
    rooms = list(plan.rooms)
    unread, openings, thick = list(plan.unread), list(plan.openings), [one.thickness for one in walls if one.thickness > 0]
    turn = turn_of([_outline(one) for one in walls])

    def back(one: DrawnRoom, level: int) -> DrawnRoom:
        points, *holes = (tuple(turned_by(spot, -turn) for spot in spots) for spots in (one.points, *one.holes))
        return replace(one, level=level, where=f"{one.where} of level {level}", points=points, holes=tuple(holes), found=True)

    for level in sorted({one.level for one in walls}):
        outlines = [tuple(turned_by(spot, turn) for spot in _outline(one)) for one in walls if one.level == level]
        beside = _beside_doors(plan, level, unit) if unit else []
        if plan.rooms and not beside:
            continue
        drawn = [_turned(one, turn) for one in plan.openings if one.level == level]
        fit = fitted(drawn, gaps_of(outlines, unit), unit)
        found = rooms_between(WallOutlines(outlines), fit._replace(left=[]) if plan.rooms else fit, unit)
        made = [back(one, level) for one in found.rooms]
        rooms += [one for one in made if not plan.rooms or (unit and _is_undrawn(one, plan, unit, beside))]
        openings += (_turned(replace(one, level=level), -turn) for one in found.passages)
        unread += (replace(one, place=f"walls of level {level}") for one in found.told if not plan.rooms)
        thick = thick or ([found.thickness] if found.thickness else [])
    if plan.rooms:
        return replace(plan, rooms=tuple(rooms))
    return replace(
        plan, rooms=tuple(rooms), openings=tuple(openings), drawn="inner", wall_thickness=median(thick) if thick else None,
        unread=tuple(unread),
    )  # fmt: skip


def _beside_doors(plan: DrawnPlan, level: int, metres: float) -> list[Spot]:
    """Returns the spots before and behind a level's doors in none of its rooms, as far as its walls reach."""
    doors = [one for one in plan.openings if one.level == level and one.kind != "window" and one.start != one.end]
    x0, z0, x1, z1 = bounds_of_points([spot for one in plan.walls if one.level == level for spot in (one.start, one.end)])
    spots = (spot for one in doors for spot in sides_of(one.start, one.end, (THICKEST / 2 + INSIDE) / metres))
    within = [(x, z) for x, z in spots if x0 < x < x1 and z0 < z < z1]
    return [spot for spot in within if not any(room.holds(*spot) for room in plan.rooms if room.level == level)]


def _is_undrawn(room: DrawnRoom, plan: DrawnPlan, metres: float, beside: Sequence[Spot]) -> bool:
    """Tells whether a door leads into what walls enclose, to one of some spots beside them, and none of a plan's rooms lies in it."""
    return any(room.holds(*spot) for spot in beside) and not any(
        overlap(room.points, other.points, INSIDE / metres) for other in plan.rooms if other.level == room.level
    )


def _turned(one: DrawnOpening, degrees: float) -> DrawnOpening:
    """Returns an opening whose ends are turned back by an angle about the origin."""
    return replace(one, start=turned_by(one.start, degrees), end=turned_by(one.end, degrees))


def _outline(wall: DrawnWall) -> tuple[Spot, ...]:
    """Returns the corners of a wall's footprint, the first one again at the end."""
    (x0, z0), (x1, z1) = wall.start, wall.end
    by = wall.thickness / 2 / math.dist(wall.start, wall.end)
    x, z = (z1 - z0) * by, (x0 - x1) * by
    return (x0 + x, z0 + z), (x1 + x, z1 + z), (x1 - x, z1 - z), (x0 - x, z0 - z), (x0 + x, z0 + z)


def rooms_between(walls: WallOutlines, fit: Fitted, metres: float | None, names: Sequence[NamedSpot] = ()) -> Between:
    """Returns what walls enclose.

    Openings close the gaps that they fill. `metres` is the length of the drawing's unit, None where nothing tells it. One in which nothing
    is drawn is a passage where without it nothing encloses what is named there, or rooms of two names are one; or where there would be no
    room.
    """
    openings = fit.openings
    found = _enclosed(walls, openings, metres, fit.filled, names)
    if metres:
        found = found._replace(rooms=[one for one in found.rooms if not _is_ground(one, found.rooms, names, openings, metres)])
    wide = _empty(fit.left, openings, metres)
    kept = [room for room in found.rooms if len(names_in(room, names)) <= 1]
    inside = {spot for room in kept for spot in names if room.holds(spot.x, spot.z)}
    if metres is None or not wide or (kept and len(kept) == len(found.rooms) and len(inside) == len(names)):
        return found
    within = INSIDE / metres
    parted = [room for room in found.rooms if room not in kept]
    if names:
        rooms = _enclosed(walls, [*openings, *map(_passage, wide)], metres, [*fit.filled, *wide], names).rooms
        wide = [gap for gap in wide if gap.in_line or _parts([names_in(room, names) for room in _beside(gap, rooms, within)])]
    else:
        wide = [gap for gap in wide if gap.in_line or gap.width * metres * 1000 <= UP_TO_WALLS]
    added = [
        room for room in (_enclosed(walls, [*openings, *map(_passage, wide)], metres, [*fit.filled, *wide], names) if wide else found).rooms
        if not any(overlap(room.points, other.points, within) for other in kept)
        and (not found.rooms or names_in(room, names) or any(overlap(room.points, other.points, within) for other in parted))
    ]  # fmt: skip
    passages = [_passage(gap) for gap in wide if _beside(gap, added, within)]
    told = [Unread("walls", GAPS_TAKEN.format(len(passages)))] if passages else []
    return Between([*kept, *added], found.thickness, [*(() if added and not kept else found.told), *told], passages)


def _is_ground(
    room: DrawnRoom, rooms: Sequence[DrawnRoom], names: Sequence[NamedSpot], openings: Sequence[DrawnOpening], metres: float
) -> bool:
    """Tells whether what is enclosed lies around a home, in one, and nothing names it or opens its outline: the ground, in a frame."""
    others = [other for other in rooms if other is not room]
    is_around = any(all(encloses(hole, *other.points[0]) for other in others) for hole in room.holes)
    if len(others) < 2 or not is_around or names_in(room, names) or sum(other.area for other in others) * metres**2 < LEAST_HOME:
        return False
    sides = np.array([(*a, *b) for a, b in edges_round(room.points)])
    return all(to_lines(between(one.start, one.end), sides) * metres * 1000 > BESIDE for one in openings)


def _is_wall(room: DrawnRoom, openings: Sequence[DrawnOpening], areas: Sequence[Sequence[Spot]], metres: float) -> bool:
    """Tells whether what lines enclose is in a wall: in the area of one, or between the two faces of one at an opening."""
    x0, z0, x1, z1 = bounds_of_points(room.points)
    if min(x1 - x0, z1 - z0) * metres > THICKEST:
        return False
    sides = (sides_of(one.start, one.end, INSIDE / metres) for one in openings if one.start != one.end)
    at_opening = any(room.holds(*before) and room.holds(*behind) for before, behind in sides)
    return at_opening or all(any(encloses(area, *spot) for area in areas) for spot in _inside(room.points, INSIDE / metres))


def _empty(gaps: Sequence[WallGap], openings: Sequence[DrawnOpening], metres: float | None) -> list[WallGap]:
    """Returns the gaps of a passage's width in which nothing is drawn."""
    spots = [between(one.start, one.end) for one in openings]
    wide = [gap for gap in gaps if metres and PASSAGES[0] <= gap.width * metres * 1000 <= PASSAGES[1]]
    return [gap for gap in wide if all(math.dist(between(gap.start, gap.end), spot) > (gap.width + gap.thickness) / 2 for spot in spots)]


def _passage(gap: WallGap) -> DrawnOpening:
    return DrawnOpening("passage", gap.start, gap.end, GAP, unsaid=True)


def _beside(gap: WallGap, rooms: Sequence[DrawnRoom], within: float) -> list[DrawnRoom]:
    """Returns the rooms before and behind a gap."""
    return [room for spot in gap.sides(within) for room in rooms if room.holds(*spot)]


def _parts(names: Sequence[set[str]]) -> bool:
    """Tells whether there are rooms on both sides, that are called otherwise."""
    return len(names) == 2 and all(names) and names[0] != names[1]


def names_in(room: DrawnRoom, names: Sequence[NamedSpot]) -> set[str]:
    """Returns what is named in a room."""
    x0, z0, x1, z1 = bounds_of_points(room.points)
    return {one.name for one in names if x0 <= one.x <= x1 and z0 <= one.z <= z1 and room.holds(one.x, one.z)}


def overlap(a: Sequence[Spot], b: Sequence[Spot], within: float) -> bool:
    """Tells whether the middle of a side of one of two outlines, moved inwards a little, lies in the other."""
    (x0, z0, x1, z1), (u0, w0, u1, w1) = bounds_of_points(a), bounds_of_points(b)
    if min(x1, u1) <= max(x0, u0) or min(z1, w1) <= max(z0, w0):
        return False
    return any(encloses(other, *spot) for one, other in ((a, b), (b, a)) for spot in _inside(one, within))


def _inside(points: Sequence[Spot], within: float) -> Iterator[Spot]:
    """Yields the spots so far inside the middles of an outline's sides."""
    for start, end in edges_round(points):
        (x, z), length = between(start, end), math.dist(start, end) or 1.0
        across = (end[1] - start[1]) * within / length, (start[0] - end[0]) * within / length
        yield from (spot for spot in ((x + across[0], z + across[1]), (x - across[0], z - across[1])) if encloses(points, *spot))


def _behind_doors(openings: Sequence[DrawnOpening], filled: Sequence[WallGap], metres: float) -> Iterator[Spot]:
    """Yields the spots before and behind gaps that doors and passages fill."""
    doors = np.array([between(one.start, one.end) for one in openings if one.kind != "window"]).reshape(-1, 2)
    for gap in filled:
        if (np.hypot(*(doors - between(gap.start, gap.end)).T) <= gap.width / 2).any():
            yield from gap.sides(INSIDE / metres)


def _enclosed(
    walls: WallOutlines, openings: Sequence[DrawnOpening], metres: float | None, filled: Sequence[WallGap], names: Sequence[NamedSpot]
) -> Between:
    """Returns what walls and the gaps that openings fill enclose, but for what is in walls."""
    if metres is None:
        return Between([], None, [Unread("walls", NO_UNIT)], [])
    scale, (west, north) = metres * 1000, walls.lines[0][0]

    def there(spot: Spot) -> Spot:
        return (spot[0] - west) * scale, (spot[1] - north) * scale

    def back(corners: FloorCorners) -> tuple[Spot, ...]:
        return tuple((x / scale + west, z / scale + north) for x, z in corners)

    pairs = [(there(a), there(b)) for points in walls.lines for a, b in pairwise(points)]
    lines = [line for a, b in pairs if (line := line_between(a, b))]
    across = [(there(one.start), there(one.end)) for one in openings]
    doors = _behind_doors(openings, filled, metres) if names else ()
    signs = ClosetSigns([there((one.x, one.z)) for one in names], list(map(there, doors)))
    closing = [(there(a), there(b)) for gap in filled for a, b in gap.faces]
    closed = [*lines, *(line for a, b in closing if (line := line_between(a, b)))]
    slants = [(a, b) for a, b in (*pairs, *across) if min(abs(a[0] - b[0]), abs(a[1] - b[1])) > STRAIGHT]
    found = next((faces for step in (STEP, 4 * STEP) if (faces := faces_between(closed, signs, slants, step)) is not None), None)
    unread = [Unread("walls", SLANTED.format(len(slants)))] if slants and found is None else []
    if found is None and slants:
        found = faces_between(closed, signs)
    if found is None:
        return Between([], None, [*unread, Unread("walls", f"{len(lines):,} lines: too many to look for rooms between them")], [])
    rooms = [
        DrawnRoom(back(one.corners), "", f"between walls, room {at}", holes=tuple(map(back, one.holes))) for at, one in enumerate(found)
    ]
    rooms = [room for room in rooms if not _is_wall(room, openings, walls.areas, metres)]
    if not rooms:
        free = free_ends(closed)
        words = f"enclose no room: {free} of their ends meet neither another wall nor an opening"
        unread.append(Unread("walls", words if free else GAPS))
    thickness = thickness_about([one.corners for one in found], lines)
    return Between(rooms, thickness and thickness / scale, unread, [])
