"""Storeys that one drawing draws beside one another: groups of rooms that lie apart are levels, in the order of their titles.

Comes in: a drawn plan, texts. Goes out: a drawn plan. May import: drawn, shape_openings.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from solver.answers import Unread
from solver.geometry import bounds_of_points
from solver.imports.drawn import DrawnLevel, DrawnOpening, DrawnPlan, DrawnRoom, Spot
from solver.imports.shape_openings import DrawnBox

APART: Final = 1.0
"""Groups of rooms of different storeys lie farther from one another, m."""
LEAST_ROOMS: Final = 3
"""A group of fewer rooms is none: a shed belongs to the nearest."""

VIEWS: Final = "enclose rooms apart from the others in which nothing is named and no door opens, as in elevations and sections: {}"


class StoreyTitle(NamedTuple):
    """Which storey a text tells, from the lowest on, its words, and where it stands."""

    rank: int
    words: str
    x: float
    z: float


class DrawnGroup(NamedTuple):
    """Rooms that lie together, by their places in the plan, and the box around them."""

    box: DrawnBox
    rooms: frozenset[int]


class SidesOfWalls:
    """The lines that walls are drawn as, how thick walls with two faces are, None: there are none, and the length of the unit."""

    def __init__(self, lines: Sequence[Sequence[Spot]], thickness: float | None, metres: float) -> None:
        self._sides = np.array([(a, b) for points in lines for a, b in pairwise(points)]).reshape(-1, 2, 2)
        self._thickness = thickness
        self.metres = metres

    def are_around(self, box: DrawnBox) -> bool:
        """Tells whether beyond each side of a box, over half of it, there is a line as the other face of a wall is."""
        if self._thickness is None:
            return False
        for across in (0, 1):
            (ats, ends), along = np.moveaxis(self._sides[:, :, across], 1, 0), self._sides[:, :, 1 - across]
            low, high = box[1 - across], box[3 - across]
            common = np.clip(np.minimum(along.max(axis=1), high) - np.maximum(along.min(axis=1), low), 0.0, None)
            for beyond in (box[across] - ats, ats - box[across + 2]):
                is_face = (np.abs(beyond / self._thickness - 1) <= 0.5) & (np.abs(ats - ends) <= self._thickness / 10)
                if common[is_face].sum() < (high - low) / 2:
                    return False
        return True


def without_views(
    rooms: Sequence[DrawnRoom], doors: Sequence[DrawnOpening], names: Sequence[Spot], walls: SidesOfWalls
) -> tuple[list[DrawnRoom], list[Unread]]:
    """Returns rooms but for those apart, among which nothing is named and there is no door, where others have either; and says so.

    Elevations and sections stand beside plans, drawn with the same lines; of walls with two faces there are none around them.
    """
    apart = APART / walls.metres
    groups = _groups([DrawnGroup(bounds_of_points(room.points), frozenset((at,))) for at, room in enumerate(rooms)], apart)

    def is_told(group: DrawnGroup) -> bool:
        has_door = any(away(group.box, (*one.start, *one.start)) <= apart for one in doors)
        return has_door or any(rooms[at].holds(*spot) for at in group.rooms for spot in names) or walls.are_around(group.box)

    views = {at for group in groups if not is_told(group) for at in group.rooms}
    if not 0 < len(views) < len(rooms):
        return list(rooms), []
    return [room for at, room in enumerate(rooms) if at not in views], [Unread("walls", VIEWS.format(len(views)))]


def with_storeys_apart(plan: DrawnPlan, texts: Sequence[StoreyTitle], metres: float | None) -> DrawnPlan:
    """Returns a plan of one level whose rooms lie in several groups with each on a level of its own; any other as it is.

    `metres` is the length of the unit.
    """
    groups = _groups(
        [DrawnGroup(bounds_of_points(room.points), frozenset((at,))) for at, room in enumerate(plan.rooms)], APART / (metres or 1.0)
    )
    storeys = groups if _titles(groups, texts)[1] else [group for group in groups if len(group.rooms) >= LEAST_ROOMS]
    if len(storeys) < 2:
        return plan
    titles, is_titled = _titles(storeys, texts)
    order = sorted(range(len(storeys)), key=lambda at: titles[at] if is_titled else (storeys[at].box[0], -storeys[at].box[3]))
    boxes = [storeys[at].box for at in order]
    names = [titles[at][1] for at in order]

    def level(spot: Spot) -> int:
        return min(range(len(boxes)), key=lambda at: away(boxes[at], (*spot, *spot)))

    told = Unread("rooms", f"lie in {len(storeys)} groups apart from one another, or on layers of their own, which are taken as storeys")
    return replace(
        plan,
        rooms=tuple(replace(one, level=level(_middle(one.points))) for one in plan.rooms),
        openings=tuple(replace(one, level=level(one.start)) for one in plan.openings),
        walls=tuple(replace(one, level=level(one.start)) for one in plan.walls),
        pieces=tuple(replace(one, level=level((one.x, one.z))) for one in plan.pieces),
        levels=tuple(DrawnLevel(number, name) for number, name in enumerate(names)),
        unread=(*plan.unread, told),
    )


def _groups(groups: Sequence[DrawnGroup], apart: float) -> list[DrawnGroup]:
    """Returns groups, those one whose boxes lie no farther apart."""
    found: list[DrawnGroup] = []
    for box, rooms in groups:
        near = [one for one in found if away(one.box, box) <= apart]
        corners = [spot for x0, z0, x1, z1 in (box, *(one.box for one in near)) for spot in ((x0, z0), (x1, z1))]
        found = [
            *(one for one in found if one not in near),
            DrawnGroup(bounds_of_points(corners), rooms.union(*(one.rooms for one in near))),
        ]
    return found if len(found) == len(groups) else _groups(found, apart)


def _titles(storeys: Sequence[DrawnGroup], texts: Sequence[StoreyTitle]) -> tuple[list[tuple[int, str]], bool]:
    """Returns the title of each group, and whether all are told to be different storeys."""
    titles = [_title(storey, storeys, texts) for storey in storeys]
    return titles, len({rank for rank, words in titles if words}) == len(storeys)


def _title(storey: DrawnGroup, storeys: Sequence[DrawnGroup], texts: Sequence[StoreyTitle]) -> tuple[int, str]:
    """Returns which storey the nearest title tells that is nearest to a group, and its words; none: no words."""

    def from_group(one: StoreyTitle, group: DrawnGroup) -> float:
        return away(group.box, (one.x, one.z, one.x, one.z))

    near = [(from_group(one, storey), one) for one in texts if min(storeys, key=lambda group: from_group(one, group)) is storey]
    return next(((one.rank, one.words) for _, one in sorted(near)), (0, ""))


def away(a: DrawnBox, b: DrawnBox) -> float:
    """Returns how far two boxes are from one another along x or z, whichever is more."""
    return max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3], 0.0)


def _middle(points: Sequence[Spot]) -> Spot:
    x0, z0, x1, z1 = bounds_of_points(points)
    return (x0 + x1) / 2, (z0 + z1) / 2
