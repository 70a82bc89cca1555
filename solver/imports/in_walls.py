"""Openings in walls whose lines run on through them: doors by their leaves, windows by what is drawn between the two faces.

Comes in: shapes, doors, rooms. Goes out: openings. May import: drawn, shape_openings, wall_gaps.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np

from solver.imports.drawn import DrawnOpening, DrawnRoom, Spot
from solver.imports.shape_openings import DrawnShape, MeetingLines, Places, between, longer_line, openings_of, sides_of
from solver.imports.wall_faces import THICKEST
from solver.imports.wall_gaps import WIDTHS

SLIM: Final = 0.05
"""So far from its middle, m, a window's own lines lie at most, and its wall's face farther."""
IN_A_WALL: Final = (0.03, 0.3)
"""On both sides of a leaf there is wall for the first, m, at least, and on one of them a room before the second."""
MOST_CORNERS: Final = 5
"""Of what is drawn for a window."""


def doors_in_walls(
    doors: Sequence[DrawnOpening], shapes: Sequence[DrawnShape], rooms: Sequence[DrawnRoom], metres: float
) -> Iterator[DrawnOpening]:
    """Yields doors that hang in walls whose lines run on through them, shut the one way or the other: which, these do not tell."""
    ways = [(one, _shut_the_other_way(one)) for one in doors]
    tips = [one.towards or one.start for both in ways for one in both]
    corners = MeetingLines([line for one in shapes for line in pairwise(one.round())], tips, IN_A_WALL[0] / metres)
    for both in ways:
        yield from [one for one in both if _is_in_a_wall(one, corners, rooms, metres)][:1]


def windows_in_walls(
    openings: Sequence[DrawnOpening],
    untold: Sequence[DrawnShape],
    shapes: Sequence[DrawnShape],
    rooms: Sequence[DrawnRoom],
    metres: float,
) -> list[DrawnOpening]:
    """Returns windows that are drawn between the faces of outer walls, of shapes that nothing calls anything; none beside others."""
    if any(one.kind == "window" for one in openings):
        return []
    taken = Places([(one.start, one.end) for one in openings])
    faces = np.array([(*a, *b) for one in shapes for a, b in pairwise(one.round())]).reshape(-1, 4)
    lines = [(one, *longer_line(one.points)) for one in untold if 1 < len(one.points) <= MOST_CORNERS]
    found = [
        one._replace(sort="window") for one, a, b in lines
        if WIDTHS[0] <= math.dist(a, b) * metres * 1000 <= WIDTHS[1] and not taken.holds(a, b)
        and _is_in_an_outer_wall(a, b, faces, rooms, metres)
    ]  # fmt: skip
    return openings_of(found, [])


def _shut_the_other_way(door: DrawnOpening) -> DrawnOpening:
    hinge, shut = (door.end, door.start) if door.hinge == "end" else (door.start, door.end)
    return replace(door, start=hinge, end=door.towards or shut, hinge="start", towards=shut)


def _is_in_a_wall(door: DrawnOpening, corners: MeetingLines, rooms: Sequence[DrawnRoom], metres: float) -> bool:
    """Tells whether a leaf, shut, lies in no room and beside one, or along a face.

    Along one face alone: open, it stands in the room, and its end at nothing, as none of a corner shower or of a worktop's round end does.
    """
    hinge, tip = door.end if door.hinge == "end" else door.start, door.towards or door.start
    beside, long = IN_A_WALL[0] / metres, math.dist(hinge, tip)
    near, far = ([_room_at(spot, rooms) for spot in sides_of(door.start, door.end, by / metres)] for by in IN_A_WALL)
    if near == [None, None]:
        return far != near
    beyond = tip[0] + (tip[0] - hinge[0]) / long * beside, tip[1] + (tip[1] - hinge[1]) / long * beside
    stands = {_room_at(spot, rooms) for spot in (*sides_of(hinge, tip, beside), beyond)}
    return near[0] != near[1] and len(stands) == 1 and stands <= {*near} and not corners.met(tip, hinge)[0]


def _is_in_an_outer_wall(a: Spot, b: Spot, faces: np.ndarray, rooms: Sequence[DrawnRoom], metres: float) -> bool:
    """Tells whether a line runs between two faces of a wall, before one room all along and a little beyond both ends, and behind none."""
    east, south = (b[0] - a[0]) / math.dist(a, b), (b[1] - a[1]) / math.dist(a, b)
    by, far = (one / metres for one in IN_A_WALL)
    spots = ((a[0] - east * by, a[1] - south * by), between(a, b), (b[0] + east * by, b[1] + south * by))

    def at_side(spot: Spot, away: float) -> Spot:
        return spot[0] - south * away, spot[1] + east * away

    def rooms_at(away: float) -> set[int | None]:
        return {_room_at(at_side(spot, away), rooms) for spot in spots}

    thick = THICKEST / 1000 / metres
    for side in (-1, 1):
        before = rooms_at(side * far)
        if len(before) == 1 and None not in before and rooms_at(-side * thick) == rooms_at(by) == rooms_at(-by) == {None}:
            return _are_crossed(at_side(spots[1], -side * SLIM / metres), at_side(spots[1], -side * thick), faces)
    return False


def _are_crossed(a: Spot, b: Spot, lines: np.ndarray) -> bool:
    """Tells whether the way from one point to another crosses any line."""
    start, way = np.array(a), np.array(b) - a
    sides = [way[0] * (ends[:, 1] - start[1]) - way[1] * (ends[:, 0] - start[0]) for ends in (lines[:, :2], lines[:, 2:])]
    along = lines[:, 2:] - lines[:, :2]
    other = [along[:, 0] * (spot[1] - lines[:, 1]) - along[:, 1] * (spot[0] - lines[:, 0]) for spot in (a, b)]
    return bool(((sides[0] * sides[1] < 0) & (other[0] * other[1] < 0)).any())


def _room_at(spot: Spot, rooms: Sequence[DrawnRoom]) -> int | None:
    return next((at for at, room in enumerate(rooms) if room.holds(*spot)), None)
