"""How well types suit the rooms of a plan: one number, lower is better, of one room, and of two that a door joins.

Comes in: what can be told of the rooms, the room types. Goes out: `Suiting`. Areas, sides and what one may walk through are the
catalog's; the weights are our choice.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log
from typing import Final

from catalogs import Catalogs
from catalogs.schema import RoomType
from solver.guessing.room_marks import RoomMarks

NEVER: Final = 1000.0
"""A cost that no preference reaches."""
REQUIRED, LISTED, STRANGE = 0.8, 0.1, 0.005
"""How likely a piece stands in a room of a type that requires it, lists it, does not know it;"""
ALIKE: Final = 0.2
"""and, of the categories that stand in one sort of room alone, of a type that requires another of the category,"""
ELSEWHERE: Final = 0.0001
"""and of one that does not."""
TELLING: Final = frozenset({"bed", "bathroom", "vehicle"})
BESIDE_PIECES: Final = 0.5
"""How much a room's form tells where something stands in it."""
HALL_WIDTH: Final = 2.0
"""From this width on, m, a room one only walks through is ever less likely one."""
LONG_HALL: Final = 2.5
"""How many times as long as it is wide a hallway mostly is."""
PAIRS: Final = {
    ("laundry", "kitchen"): -0.8, ("laundry", "garage"): -0.8, ("laundry", "garage_2car"): -0.8, ("laundry", "garage_3car"): -0.8,
    ("laundry", "bedroom_master"): 1.0, ("laundry", "bedroom"): 1.0, ("bathroom", "kitchen"): 0.6, ("bathroom", "dining_room"): 0.6,
    ("dining_room", "kitchen"): -0.4, ("dining_room", "living_room"): -0.2, ("bedroom_master", "bathroom"): -0.4,
}  # fmt: skip
"""Cost of a door between rooms that are seldom, or often, joined."""
SHUT_OFF: Final = 1.5
"""Cost of a living or dining room behind its only door: those one walks through, or they stand open."""
TOO_LARGE, TOO_NARROW = 3.0, 4.0
"""Cost of a floor beyond the catalog's limits by a factor of e, and of a side below its least. The limits are those of homes drawn here;
in plans of others a kitchen of 5 m2 is no rarity, so they weigh as a preference and not as a law."""


class Suiting:
    """Costs of types in the rooms of one plan.

    Args:
        marks: what can be told of the rooms.
        catalogs: the room types.
    """

    def __init__(self, marks: Sequence[RoomMarks], catalogs: Catalogs) -> None:
        self.marks, self.kinds = marks, catalogs.rooms
        self._has_windows = any(one.large + one.small for one in marks)
        self._pieces = {name: _pieces_of(kind, catalogs) for name, kind in self.kinds.items()}

    def alone(self, room: int, name: str) -> float:
        """Returns the cost of a type in a room by its floor, windows, doors to the outside and pieces."""
        marks, kind = self.marks[room], self.kinds[name]
        if (marks.garage_door and not kind.plan.garage_door) or marks.outdoor != kind.outdoor:
            return NEVER
        indoors = sum(not self.marks[there].outdoor for there, _ in marks.ways)
        cost = _size(marks, kind) + _front(marks, kind, indoors)
        cost += _light(marks, kind) if self._has_windows else 0.0
        return (BESIDE_PIECES if marks.pieces else 1.0) * cost + self._standing(marks, name)

    def _standing(self, marks: RoomMarks, name: str) -> float:
        """Returns the cost of what stands in a room, by how likely each piece is in a room of the type."""
        likely = self._pieces[name]
        return sum(-log(likely.get(piece, STRANGE)) for piece in sorted(marks.pieces))

    def joined(self, one: str, other: str, is_open: bool) -> float:
        """Returns the cost of two types with a door, or an opening without a leaf, between them."""
        return self._led(one, other, is_open) + PAIRS.get((one, other), 0.0) + PAIRS.get((other, one), 0.0)

    def _led(self, one: str, other: str, is_open: bool) -> float:
        """Returns the cost of leading from one type to another."""
        a, b = self.kinds[one], self.kinds[other]
        if a.outdoor or b.outdoor:
            return 0.0
        if is_open:
            return -0.8 if a.plan.passage and b.plan.passage else 6.0
        leaf = 0.5 if a.plan.passage and b.plan.passage else 0.0
        through = a.plan.way_through or b.plan.way_through
        if not through:
            return leaf + (0.0 if one in b.plan.behind or other in a.plan.behind else 4.0)
        if any(kind.plan.way_through and not kind.plan.habitable for kind in (a, b)):
            return leaf - 0.4
        shown = sum(kind.plan.habitable or kind.plan.wet for kind in (a, b) if not kind.plan.way_through)
        return leaf + 0.75 * shown


def _pieces_of(kind: RoomType, catalogs: Catalogs) -> dict[str, float]:
    """Returns how likely each piece stands in a room of a type, by its name; such as a bunk bed where a bed is required."""
    book = catalogs.kinds_by_name()
    pieces = [piece for piece in kind.pieces if not piece.without]
    listed = {catalogs.name_of(variant.kind): LISTED for piece in pieces for variant in piece.variants}
    required = {name: REQUIRED for line in kind.requires for name in line}
    categories = TELLING & {book[name].category for name in required if name in book}
    alike = {name: ALIKE if entry.category in categories else ELSEWHERE for name, entry in book.items() if entry.category in TELLING}
    return alike | listed | required


def _entry(marks: RoomMarks, kind: RoomType) -> float:
    """Returns the cost of a foyer that one does not come in by, or of a hallway that is no more than a foyer."""
    if kind.home is not None:
        return 0.0 if marks.front else 2.0
    return 1.0 if marks.long / marks.short < LONG_HALL else 0.0


def _size(marks: RoomMarks, kind: RoomType) -> float:
    least, typical, most = kind.area.min[0], kind.area.typical, kind.area.max
    if kind.home:
        least, typical, most = min(least, kind.home.area[0]), kind.home.area[1], max(most, kind.home.area[2])
    far = max(0.0, log(least / marks.area), log(marks.area / most))
    width = min(kind.home.width, kind.short_side) if kind.home else kind.short_side
    thin = max(0.0, log(width / marks.short))
    long = max(0.0, marks.long / marks.short - max(kind.aspect, kind.home.aspect if kind.home else 0.0))
    return 1.2 * abs(log(marks.area / typical)) + TOO_LARGE * far + TOO_NARROW * thin + 0.5 * min(long, 4.0)


def _light(marks: RoomMarks, kind: RoomType) -> float:
    if marks.outdoor:
        return 0.0
    if kind.plan.habitable:
        return 0.0 if marks.large else 2.5 if marks.small else 4.0
    if kind.plan.wet:
        return 0.8 if marks.large else -0.8 if marks.small else 0.0
    return (0.6 if kind.plan.way_through else 0.2) * marks.large


def _front(marks: RoomMarks, kind: RoomType, indoors: int) -> float:
    """Returns the cost of the doors to the outside, and of the number of rooms that a room leads to, so many of them indoors."""
    leads = indoors + bool(marks.front)
    cost = 0.0
    if marks.front and not marks.outdoor:
        outside = 3.0 if kind.plan.entrance is None else 0.4 * kind.plan.entrance
        cost += outside if marks.front == "main" else 0.4 * outside
    if kind.plan.garage_door and not marks.garage_door:
        cost += 5.0
    if kind.plan.way_through and not kind.plan.habitable:
        wide = 5.0 * max(0.0, log(marks.short / HALL_WIDTH))
        return cost + wide + (3.0 if leads < 2 else 0.0) - 0.5 * min(max(leads - 2, 0), 4) + _entry(marks, kind)
    if kind.plan.way_through:
        return cost + (0.0 if kind.plan.wet or any(is_open for _, is_open in marks.ways) or leads > 1 else SHUT_OFF)
    return cost + 1.5 * max(0, indoors - 1 - bool(kind.plan.habitable))
