"""Second step, second half: one level of a drawn plan in mm, near the origin, turned so that its walls run along x and z."""

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Final

from solver.errors import FieldError
from solver.imports.drawn import DrawnLevel, DrawnOpening, DrawnPiece, DrawnPlan, DrawnWall, PlanNotes, Spot
from solver.imports.straighten import turn_of, turned_by
from solver.plain import quoted

LEAST_CORNERS: Final = 3
SMALLEST: Final = 500
WIDEST: Final = 1_000_000
"""Between these, mm, is the larger side of a house."""
MOST_NAMED: Final = 8
"""Layers that are named, those with most on them."""
OF_A_LEVEL: Final = ("rooms", "openings", "walls", "solid", "pieces")
"""What of a plan is on one of its levels."""
Turn = Callable[[Spot], Spot]


def of_one_level(plan: DrawnPlan, asked: int | None, notes: PlanNotes) -> DrawnPlan:
    """Returns the plan of one level: the one asked for, else the lowest with rooms that are drawn, if any is.

    Raises:
        FieldError: there are no rooms, or none on that level.
    """
    for room in plan.rooms:
        if len(room.points) < LEAST_CORNERS:
            notes.leave(room.where, f"room {quoted(room.label)}: its outline has {len(room.points)} corners")
    plan = replace(plan, rooms=tuple(room for room in plan.rooms if len(room.points) >= LEAST_CORNERS))
    counts = Counter(room.level for room in plan.rooms)
    names = {level.number: level.name for level in plan.levels}
    if not counts:
        raise _without_rooms(plan)
    chosen = min((room.found, room.level) for room in plan.rooms)[1] if asked is None else asked
    if chosen not in counts:
        raise FieldError("level", f"{chosen} has no rooms", ", ".join(map(str, sorted(counts))))
    for number in sorted(counts.keys() - {chosen}):
        name, rooms = f" ({names[number]})" if names.get(number) else "", "1 room" if counts[number] == 1 else f"{counts[number]} rooms"
        notes.leave(f"level {number}{name}", f"{rooms} left out: only level {chosen} was read; ask for level {number} to read this one")
    own: dict[str, Any] = {name: tuple(one for one in getattr(plan, name) if one.level == chosen) for name in OF_A_LEVEL}
    return replace(plan, **own, levels=tuple(one for one in plan.levels if one.number == chosen) or (DrawnLevel(chosen),))


def _without_rooms(plan: DrawnPlan) -> FieldError:
    """Returns why a plan has no rooms: what is wrong with its walls; else what its layers are called, so that one knows what to rename."""
    layers, of_walls = plan.layers, [one.reason for one in plan.unread if one.place.startswith("walls")]
    if of_walls:
        return FieldError("rooms", f"are none in this file; its walls: {of_walls[0]}", "walls that enclose rooms, or rooms with outlines")
    if not layers:
        left_out = f"; left out: {'; '.join(one.reason for one in plan.unread[:MOST_NAMED])}" if plan.unread else ""
        return FieldError("rooms", f"are none in this file{left_out}", "at least one room with an outline")
    names = ", ".join(f"{name!r:.40}" for name in layers[:MOST_NAMED]) + (", ..." if len(layers) > MOST_NAMED else "")
    return FieldError(
        "rooms", f"are none in this file, whose layers are {names}", "lines on a layer called as rooms or walls are, such as ROOMS"
    )


def in_millimetres(plan: DrawnPlan, metres: float, notes: PlanNotes) -> DrawnPlan:
    """Returns a plan in mm; heights, elevations and the sizes of pieces in m.

    `metres` is the length of its unit. Where the plan was turned that is noted.

    Raises:
        FieldError: it is larger or smaller than any house.
    """
    spots, scale = [spot for room in plan.rooms for spot in room.points], metres * 1000
    west, north = min(x for x, _ in spots), min(z for _, z in spots)
    largest = max(max(x for x, _ in spots) - west, max(z for _, z in spots) - north) * scale
    if not SMALLEST <= largest <= WIDEST:
        raise FieldError("rooms", f"are {largest / 1000:g} m wide in all", "0.5 to 1000 m: `unit` says how long the file's unit is")
    turn = turn_of([[((x - west) * scale, (z - north) * scale) for x, z in room.points] for room in plan.rooms])
    if turn + plan.turned:
        way = "counter-clockwise" if turn + plan.turned > 0 else "clockwise"
        words = f"the whole plan is turned by {abs(turn + plan.turned):.2f} degrees {way}, so that its walls run along x and z"
        notes.change("straighten", "plan", 0.0, words)

    def at(spot: Spot) -> Spot:
        return turned_by(((spot[0] - west) * scale, (spot[1] - north) * scale), turn)

    return replace(
        plan,
        rooms=tuple(
            replace(
                room,
                points=tuple(map(at, room.points)),
                holes=tuple(tuple(map(at, hole)) for hole in room.holes),
                outer=tuple(one and one * scale for one in room.outer),
            )
            for room in plan.rooms
        ),
        openings=tuple(_opening(one, at, metres) for one in plan.openings),
        walls=tuple(_wall(one, at, scale) for one in plan.walls),
        solid=tuple(_wall(one, at, scale) for one in plan.solid),
        faces=tuple((at(a), at(b)) for a, b in plan.faces),
        pieces=tuple(_piece(one, at, metres, turn) for one in plan.pieces),
        levels=tuple(
            DrawnLevel(one.number, one.name, one.elevation and one.elevation * metres, one.height and one.height * metres)
            for one in plan.levels
        ),
        wall_thickness=None if plan.wall_thickness is None else plan.wall_thickness * scale,
        metres=metres,
    )


def _wall(one: DrawnWall, at: Turn, scale: float) -> DrawnWall:
    return replace(one, start=at(one.start), end=at(one.end), thickness=one.thickness * scale)


def _opening(one: DrawnOpening, at: Turn, metres: float) -> DrawnOpening:
    height, sill = (None if length is None else length * metres for length in (one.height, one.sill))
    return replace(one, start=at(one.start), end=at(one.end), towards=one.towards and at(one.towards), height=height, sill=sill)


def _piece(one: DrawnPiece, at: Turn, metres: float, turn: float) -> DrawnPiece:
    x, z = at((one.x, one.z))
    size = one.size and (one.size[0] * metres, one.size[1] * metres, one.size[2] * metres)
    return replace(
        one, x=x, z=z, y=one.y * metres, rotation=one.rotation + turn, size=size, height=one.height and one.height * metres,
        middle=one.middle and one.middle * metres,
    )  # fmt: skip
