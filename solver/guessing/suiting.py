"""How well types suit the rooms of a plan: one number, lower is better, of one room, and of two that a door joins.

Areas, sides and what one may walk through are those of the room types; what each mark costs is said in guessing.yaml.
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from math import log
from typing import Final

import numpy as np
from numpy.typing import NDArray

from catalogs import Catalogs
from catalogs.entries import Evidence, Mark, OfType
from catalogs.schema import RoomType
from solver.guessing.doors_between import WAYS, doors_between
from solver.scene import EXTERIOR, Opening, Room

SMALL_WINDOW: Final = (1.2, 0.6)
"""A window with so high a sill, m, or of no more area, m2, is one of a bathroom."""
LEAST_M: Final = 0.001
"""As how long a side of a room counts that is shorter, m: there is a logarithm for every area."""


@dataclass(frozen=True)
class RoomMarks:
    """What can be told of a room without its type.

    Args:
        area: of its floor between wall lines, m2.
        short, long: sides of its bounding rectangle, m; `short` is that of its floor spread over the long side, where it has an outline.
        ways: the rooms it leads to, by their place in the list, and whether an opening without a leaf leads there.
        front: how its doors lead outside: "main", "door", or "" where none does.
        large, small: numbers of windows.
        pieces: what stands there, by the catalogs' names.
        behind: the one room through which one comes here from outside, by its place in the list; None where it is not one.
    """

    area: float
    short: float
    long: float
    ways: tuple[tuple[int, bool], ...]
    front: str
    large: int
    small: int
    garage_door: bool
    outdoor: bool
    pieces: frozenset[str]
    behind: int | None = None


def marks_of(rooms: Sequence[Room]) -> list[RoomMarks]:
    """Returns what can be told of each room; its furniture is under the catalogs' names."""
    joints = list(doors_between(rooms))
    ways, inner = _ways(joints, len(rooms)), {opening.id for _, _, opening in joints}
    found = [_marks(room, ways[k], inner) for k, room in enumerate(rooms)]
    return [replace(one, behind=behind) for one, behind in zip(found, _behind(found), strict=True)]


def _behind(marks: Sequence[RoomMarks]) -> list[int | None]:
    """Returns of each room the only one of its neighbours that is nearer to the main entrance, else to a door that leads outside."""
    fronts = [{k for k, one in enumerate(marks) if one.front == front} for front in ("main", "door")]
    steps: dict[int, int] = {}
    here = fronts[0] or fronts[1]
    while here:
        steps |= dict.fromkeys(here, len({*steps.values()}))
        here = {there for k in here for there, _ in marks[k].ways} - steps.keys()
    nearer = [[there for there, _ in one.ways if steps.get(there, k) < steps[k]] if k in steps else [] for k, one in enumerate(marks)]
    return [those[0] if len(those) == 1 else None for those in nearer]


def _ways(joints: Iterable[tuple[int, int, Opening]], count: int) -> list[dict[int, bool]]:
    """Returns where each room leads to: doors that one of two rooms lists lead both ways."""
    found: list[dict[int, bool]] = [{} for _ in range(count)]
    for here, there, opening in joints:
        is_open = opening.kind == "passage"
        for a, b in ((here, there), (there, here)):
            found[a][b] = found[a].get(b, False) or is_open
    return found


def _marks(room: Room, ways: dict[int, bool], inner: Set[str]) -> RoomMarks:
    """Returns what can be told of a room; a door between two rooms leads to the other, even where it says outside."""
    area = max(room.floor_m2, LEAST_M * LEAST_M)
    long = max(room.width, room.depth, LEAST_M)
    windows = Counter(_is_small(opening) for opening in room.openings if opening.kind == "window")
    outside = [opening for opening in room.openings if opening.connects_to == EXTERIOR and opening.id not in inner]
    doors = [opening for opening in outside if opening.kind in WAYS]
    front = "main" if any(opening.main_entrance for opening in doors) else "door" if doors else ""
    short = max(min(room.width, room.depth, area / long), LEAST_M)
    return RoomMarks(
        area, short, long, tuple(sorted(ways.items())), front, windows[False], windows[True],
        any(opening.kind == "garage_door" for opening in room.openings), room.outdoor, frozenset(piece.name for piece in room.furniture),
    )  # fmt: skip


def _is_small(window: Opening) -> bool:
    return window.sill >= SMALL_WINDOW[0] or window.width * window.height <= SMALL_WINDOW[1]


NEVER: Final = 1000.0
"""A cost that no preference reaches."""
REQUIRED, LISTED, STRANGE = 0.8, 0.1, 0.005
"""How likely a piece stands in a room of a type that requires it, lists it, does not know it;"""
ALIKE: Final = 0.2
"""and, of the categories that stand in one sort of room alone, of a type that requires another of the category,"""
ELSEWHERE: Final = 0.0001
"""and of one that does not."""
TELLING: Final = frozenset({"bed", "bathroom", "vehicle"})
HALL_WIDTH: Final = 2.0
"""From this width on, m, a room one only walks through is ever less likely one."""
LONG_HALL: Final = 2.5
"""How many times as long as it is wide a hallway mostly is."""
WINDOWED, MOST_DRAWN = 0.7, 0.95
"""What share of rooms indoors have a window in a home that is drawn with all; how likely one that is there is drawn, at most."""
UNSAID: Final = Evidence()
Amounts = dict[Mark, float]
"""How much of each mark there is."""


class Suiting:
    """Costs of types in the rooms of one plan, by what can be told of them."""

    def __init__(self, marks: Sequence[RoomMarks], catalogs: Catalogs) -> None:
        self.marks, self.catalogs, self.kinds = marks, catalogs, catalogs.rooms
        indoors = [one for one in marks if not one.outdoor]
        seen = sum(one.large + one.small > 0 for one in indoors) / max(len(indoors), 1)
        self._drawn = min(seen / WINDOWED, MOST_DRAWN)
        """How likely the plan draws a window where there is one."""
        self._has_fronts = any(one.front for one in indoors)
        self._pieces = {name: _pieces_of(kind, catalogs) for name, kind in self.kinds.items()}

    def _mark(self, mark: Mark) -> Evidence:
        return self.catalogs.guessing.get(mark, UNSAID)

    def _cost(self, amounts: Amounts) -> float:
        return sum(self._mark(mark).cost * amount for mark, amount in amounts.items())

    def alone(self, room: int, name: str) -> float:
        """Returns the cost of a type in a room by its floor, windows, doors to the outside and pieces."""
        marks, kind = self.marks[room], self.kinds[name]
        if (marks.garage_door and not kind.plan.garage_door) or marks.outdoor != kind.outdoor:
            return NEVER
        leads_out = marks.front != "" or any(self.marks[there].outdoor for there, _ in marks.ways)
        cost = self._cost(self.amounts(room, name)) + (self._mark("outside").types.get(name, 0.0) if leads_out else 0.0)
        return (self._mark("beside_pieces").cost if marks.pieces else 1.0) * cost + self._standing(marks, name)

    def amounts(self, room: int, name: str) -> Amounts:
        """Returns how much of each mark there is, were a room of a type."""
        marks, kind = self.marks[room], self.kinds[name]
        indoors = sum(not self.marks[there].outdoor for there, _ in marks.ways)
        found = self._size(marks, name) | _front(marks, kind) | self._leads(marks, kind, indoors)
        return found | (_light(marks, kind, self._drawn) if self._drawn and not marks.outdoor else {})

    def _leads(self, marks: RoomMarks, kind: RoomType, indoors: int) -> Amounts:
        """Returns the marks of the rooms a room leads to, so many of them indoors; where a plan draws no door to the outside any has it."""
        leads = indoors + bool(marks.front or not self._has_fronts)
        if _is_hall(kind):
            found: Amounts = {"dead_end": float(leads < 2), "hall_ways": float(min(max(leads - 2, 0), 4))}
            if kind.home is not None:
                return found | {"no_front": float(self._has_fronts and not marks.front)}
            wide, is_short = max(0.0, log(marks.short / HALL_WIDTH)), marks.long / marks.short < LONG_HALL
            return found | {"hall_width": wide, "short_hall": float(is_short)}
        if kind.plan.way_through:
            is_shut = not kind.plan.wet and leads < 2 and not any(is_open for _, is_open in marks.ways)
            return {"shut_off": float(is_shut)}
        return {"ways": float(max(0, indoors - 1 - bool(kind.plan.habitable)))}

    def _size(self, marks: RoomMarks, name: str) -> Amounts:
        kind = self.kinds[name]
        least, typical, most, width, aspect = kind.area.min[0], kind.area.typical, kind.area.max, kind.short_side, kind.aspect
        if kind.home:
            least, typical, most = min(least, kind.home.area[0]), kind.home.area[1], max(most, kind.home.area[2])
            width, aspect = min(kind.home.width, width), max(kind.home.aspect, aspect)
        width = self._mark("width").types.get(name, width)
        return {
            "typical": abs(log(marks.area / typical)),
            "beyond": max(0.0, log(least / marks.area), log(marks.area / most)),
            "width": max(0.0, log(width / marks.short)),
            "long": min(max(0.0, marks.long / marks.short - aspect), 4.0),
        }

    def _standing(self, marks: RoomMarks, name: str) -> float:
        """Returns the cost of what stands in a room, by how likely each piece is in a room of the type."""
        likely = self._pieces[name]
        return sum(-log(likely.get(piece, STRANGE)) for piece in sorted(marks.pieces))

    def joined(self, one: str, other: str, is_open: bool) -> float:
        """Returns the cost of two types with a door, or an opening without a leaf, between them."""
        pairs = self._mark("joined").pairs
        a, b = self.kinds[one], self.kinds[other]
        cost = self._cost(_led((a, b), one in b.plan.behind or other in a.plan.behind, is_open))
        return cost + pairs.get(one, {}).get(other, 0.0) + pairs.get(other, {}).get(one, 0.0)

    def past(self, one: str, other: str) -> float:
        """Returns what it costs besides where one comes from the entrance to a room of type `other` through one of type `one` alone."""
        a, b = self.kinds[one], self.kinds[other]
        return self._cost({"past": float(b.plan.way_through and not a.plan.way_through and not b.outdoor)})


def _led(kinds: tuple[RoomType, RoomType], is_behind: bool, is_open: bool) -> Amounts:
    """Returns the marks of a way from one type to another, of which one may lie behind the other."""
    if any(kind.outdoor for kind in kinds):
        return {}
    standing_open = all(kind.plan.passage for kind in kinds)
    if is_open:
        return {"open": 1.0} if standing_open else {"strange_opening": 1.0}
    found: Amounts = {"leaf": float(standing_open)}
    if not any(kind.plan.way_through for kind in kinds):
        return found | {"behind": float(not is_behind)}
    if any(_is_hall(kind) for kind in kinds):
        return found | {"off_hall": 1.0}
    shown = sum(kind.plan.habitable or kind.plan.wet for kind in kinds if not kind.plan.way_through)
    return found | {"through": float(shown)}


def _is_hall(kind: RoomType) -> bool:
    """Tells whether one only walks through a room of a type."""
    return kind.plan.way_through and not kind.plan.habitable


def _pieces_of(kind: RoomType, catalogs: Catalogs) -> dict[str, float]:
    """Returns how likely each piece stands in a room of a type, by its name; such as a bunk bed where a bed is required."""
    book = catalogs.kinds_by_name()
    pieces = [piece for piece in kind.pieces if not piece.without]
    listed = {catalogs.name_of(variant.kind): LISTED for piece in pieces for variant in piece.variants}
    required = {name: REQUIRED for line in kind.requires for name in line}
    categories = TELLING & {book[name].category for name in required if name in book}
    alike = {name: ALIKE if entry.category in categories else ELSEWHERE for name, entry in book.items() if entry.category in TELLING}
    return alike | listed | required


def _light(marks: RoomMarks, kind: RoomType, drawn: float) -> Amounts:
    """Returns the marks of windows, in a plan that draws so many of them."""
    if kind.plan.habitable:
        return {} if marks.large else {"small_windows": 1.0} if marks.small else {"no_window": log(1 - drawn) / log(1 - MOST_DRAWN)}
    if kind.plan.wet:
        return {"wet_large": 1.0} if marks.large else {"wet_small": 1.0} if marks.small else {}
    return {"way_windows" if kind.plan.way_through else "windows": float(marks.large)}


def _front(marks: RoomMarks, kind: RoomType) -> Amounts:
    """Returns the marks of doors to the outside."""
    found: Amounts = {"no_garage_door": float(kind.plan.garage_door and not marks.garage_door)}
    if not marks.front or marks.outdoor:
        return found
    place = kind.plan.entrance
    if marks.front == "main":
        return found | ({"front": 1.0} if place is None else {"entrance": float(place)})
    return found | ({"side_door": 1.0} if place is None else {"side_entrance": float(place)})


Costs = NDArray[np.float64]
Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]
ONE_MORE: Final[tuple[Mark, Mark]] = ("again", "first")
SEVERAL: Final = 3
"""A home of so many rooms indoors has what is wanted."""
UNCOUNTED: Final = "hallway"
"""The word of a programme that nobody counts."""


class RoomNumbers:
    """Costs of how many rooms there are of each type, in the catalogs' order, in a home with so many indoors.

    `program` says how many rooms of each word there are, where that is known; the types of a word count as one.
    """

    def __init__(self, catalogs: Catalogs, indoors: int, program: Mapping[str, int] | None) -> None:
        self._is_several = indoors >= SEVERAL
        self._kinds, self._told = catalogs.rooms, catalogs.guessing
        self._names, usual = list(self._kinds), self._of_types("usual")
        self._usual = np.array([1 + (int(indoors // usual[name]) if name in usual else 0) for name in self._names])
        self._one_more, self._rare = (np.array([self._of_types(mark).get(name, 0.0) for name in self._names]) for mark in ONE_MORE)
        homes = [kind.home for kind in self._kinds.values()]
        self._word_of = [(home.word if home else None) or name for name, home in zip(self._names, homes, strict=True)]
        self._first = np.array([bool(home and home.once) for home in homes])
        self._turn = np.array([home.turn if home else 0 for home in homes])
        self._program: Counts | None = None
        if program is not None:
            words = sorted({*self._word_of, *program} - {UNCOUNTED})
            self._program = np.array([program.get(word, 0) for word in words])
            self._words = np.array([[word == own for word in words] for own in self._word_of], dtype=np.int64)

    def _of_types(self, mark: Mark) -> OfType:
        return self._told.get(mark, UNSAID).types

    def _cost(self, mark: Mark) -> float:
        return self._told.get(mark, UNSAID).cost

    def more(self, counts: Counts) -> Costs:
        """Returns the cost of one more room of each type in homes of so many rooms; a row a home."""
        if self._program is None:
            return np.where(counts >= self._usual, self._one_more, 0.0) + np.where(counts == 0, self._rare, 0.0)
        wrong = self._cost("miscounted")
        wants = np.where(counts @ self._words < self._program, -wrong, wrong)
        return np.asarray(wants @ self._words.T, dtype=np.float64)

    def missing(self, counts: Counts) -> Costs:
        """Returns the cost of what whole homes lack, one each."""
        found = np.zeros(len(counts))
        if self._program is not None or not self._is_several:
            return found
        for name, cost in self._of_types("missing").items():
            found += np.where(counts[:, self._alike(self._word_of[self._names.index(name)])].sum(axis=1) == 0, cost, 0.0)
        for word in sorted({word for word, first in zip(self._word_of, self._first, strict=True) if first}):
            found += self._out_of_turn(counts, self._alike(word))
        return found

    def _alike(self, word: str) -> Flags:
        return np.array([one == word for one in self._word_of])

    def _out_of_turn(self, counts: Counts, alike: Flags) -> Costs:
        """Returns the cost of rooms of one word whose first is not the one that comes first, or that are all of the last turn."""
        every = counts[:, alike].sum(axis=1)
        first, last = (counts[:, alike & turn].sum(axis=1) for turn in (self._first, self._turn == self._turn[alike].max()))
        lacking = np.where((every > 1) & (first == 0), self._cost("no_first"), 0.0)
        return lacking + np.where((last > 0) & (last == every), self._cost("later_alone"), 0.0)
