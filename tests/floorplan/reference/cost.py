"""What a drawn home costs: one number, lower is better; a person's reasons, weighted by our choice.

Comes in: a `Sheet`. Goes out: `HomeVerdict`. May import: the ground floor. Rooms are bits of a number here: a home is judged
dozens of times.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from solver.floorplan.programme.home_search import HomeVerdict
from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.floorplan.tiling import touching
from solver.geometry import OPPOSITE, Rect, gaps_between
from solver.scene import WALLS
from tests.floorplan.reference.asked import door_wall
from tests.floorplan.reference.drafts import Sheet

SHORT: Final = 20.0
"""A room outside its limits of area, width or aspect; a hallway less than two thirds longer than it is wide."""
UNREACHED: Final = 30.0
"""A room that can only be entered through one that should not be walked through; an own bathroom away from its bedroom."""
STREETLESS: Final = 30.0
"""A garage or an entry away from the street."""
DARK: Final = 8.0
"""A habitable room without an outside wall."""
AT_ENTRANCE: Final = 6.0
"""A bedroom that can only be entered from the entrance room."""
OFF_ENTRY: Final = 0.7
"""Another room than a bedroom or a bathroom that only the entrance room leads to."""
OFF_LIVING: Final = 4.0
"""A bathroom that only rooms one lives in lead to."""
BATHROOM_AFAR: Final = 4.0
"""A bedroom, of several, from which one walks through a room one lives in to every bathroom."""
PAST_LIVING: Final = 2.0
"""A bedroom, of several, from which one walks through such a room to the entrance."""
DRY: Final = 4.0
"""A wet room without a wet neighbour."""
KITCHEN_APART: Final = 2.5
"""A kitchen beside neither dining nor living room; a dining room away from the kitchen."""
LIVING_APART: Final = 1.5
"""A living room away from the entry, a dining room away from the living room."""
KITCHEN_BETWEEN: Final = 3.0
"""A room one lives in, or a hallway, that only the kitchen leads to: each more door leaves a kitchen less wall for its worktop."""
PAST_KITCHEN: Final = 5.0
"""A bedroom or a bathroom that only the kitchen leads to."""
SMALL_SUITE: Final = 4.0
"""The largest bedroom has no bathroom of its own, and another has."""
OUTLINE: Final = (0.75, 1.9)
"""Width over depth of an outline that costs nothing; beyond, OUTLINE_COST for every unit."""
BENT_OUTLINE: Final = (0.6, 2.4)
"""The same of the rectangle around an outline that is none."""
LIT_MM: Final = 1800
"""Least outside wall that lights a habitable room: a window of 1.2 m and 0.3 m of wall at each end."""
OUTLINE_COST: Final = 5.0
HALLWAY_SHARE: Final = 0.08
"""Hallway over floor that costs nothing; beyond, HALLWAY_COST for all of the floor."""
HALLWAY_COST: Final = 32.0
AREA_COST: Final = 1.5
"""Of the squared deviation of a room's area from what is typical, over what is typical."""


SharedWall = tuple[int, int, str, int, int]
"""A stretch of wall that two rooms share, as `touching` finds it."""
Covered = dict[int, dict[str, list[tuple[int, int]]]]
"""By room and wall, the stretches at which other rooms lie."""


class HomeJudge:
    """Judges the drawings of one programme; it has looked up what each room is once."""

    def __init__(self, planned: Sequence[PlannedRoom], outline: tuple[float, float] = OUTLINE, dark: float = DARK) -> None:
        self.planned, self.outline, self.dark = planned, outline, dark
        self.sizes = [one.size for one in planned]
        every = range(len(planned))

        def bits(rooms: Sequence[bool]) -> int:
            return sum(1 << i for i in every if rooms[i])

        self.ways = bits([one.kind.plan.way_through for one in planned])
        self.wet = bits([one.kind.plan.wet for one in planned])
        self.entry = bits([one.entry for one in planned])
        self.kitchen = bits([one.public and one.kind.plan.wet for one in planned])
        self.dining = bits([one.public and any("dining_table" in line for line in one.kind.requires) for one in planned])
        self.living = self.ways & ~self.entry & ~self.kitchen & ~self.dining
        self.wet_rooms = [i for i in every if planned[i].kind.plan.wet]
        self.habitable = [i for i in every if planned[i].kind.plan.habitable]
        self.street = [i for i in every if planned[i].garage or planned[i].entry]
        self.leaves = [i for i in every if not planned[i].kind.plan.way_through and planned[i].owner is None]
        self.owned = [(i, one.owner) for i, one in enumerate(planned) if one.owner is not None]
        self.bedrooms = frozenset(i for i in every if any("bed" in line for line in planned[i].kind.requires))
        self.bathrooms = frozenset(i for i in every if any("toilet" in line for line in planned[i].kind.requires))
        self.through = [bits([other.type in one.kind.plan.behind and not other.kind.plan.way_through for other in planned])
                        if one.garage else 0 for one in planned]  # fmt: skip

    def verdict(self, sheet: Sheet) -> HomeVerdict:
        """Judges a drawing."""
        sizes, short = self._sizes(sheet.boxes)
        stubs = sum(3 * max(box.width, box.depth) < 5 * min(box.width, box.depth) for box in sheet.hallways)
        for _ in range(stubs):
            sizes += SHORT
        short += stubs
        met = touching([*sheet.boxes, *sheet.hallways])
        beside = _beside(sheet, met)
        unreached, at_entrance, others, off_living, past_kitchen, between = self._access(beside, sheet)
        covered = _covered(met)
        streetless = sum("south" in covered.get(i, {}) for i in self.street)
        ways = UNREACHED * unreached + AT_ENTRANCE * at_entrance + OFF_ENTRY * others + OFF_LIVING * off_living
        bathless, past_living = self._past_living(beside, sheet)
        ways = ways + BATHROOM_AFAR * bathless + PAST_LIVING * past_living + STREETLESS * streetless
        ways = ways + KITCHEN_BETWEEN * between + PAST_KITCHEN * past_kitchen
        dark = sum(not _lit(sheet.boxes[i], covered.get(i, {})) for i in self.habitable)
        cost = sizes + (self._outline(sheet) + self.dark * dark) + self._company(beside) + SMALL_SUITE * self._is_small(sheet.boxes) + ways
        return HomeVerdict(cost, short, unreached, streetless, dark)

    def _sizes(self, boxes: Sequence[Rect]) -> tuple[float, int]:
        cost, short = 0.0, 0
        for (x0, z0, x1, z1), size in zip(boxes, self.sizes, strict=True):
            width, depth = x1 - x0, z1 - z0
            area = width * depth
            stray = area / size.typical - 1.0
            cost += AREA_COST * stray * stray
            low, high = (width, depth) if width < depth else (depth, width)
            if area < size.least or area > size.most or low < size.width or high > size.aspect * low:
                short += 1
                cost += SHORT * (1.0 + max(size.least / max(area, 1), area / size.most, size.width / max(low, 1)) - 1.0)
        return cost, short

    def _outline(self, sheet: Sheet) -> float:
        ratio, (low, high) = sheet.width / sheet.depth, self.outline
        cost = OUTLINE_COST * max(low - ratio, ratio - high, 0.0)
        walked = sum([(x1 - x0) * (z1 - z0) for x0, z0, x1, z1 in sheet.hallways])
        if walked:
            floor = walked + sum([(x1 - x0) * (z1 - z0) for x0, z0, x1, z1 in sheet.boxes])
            cost += HALLWAY_COST * max(walked / floor - HALLWAY_SHARE, 0.0)
        return cost

    def _company(self, beside: Sequence[int]) -> float:
        cost = 0.0
        for i in self.wet_rooms:
            if not beside[i] & self.wet:
                cost += DRY
        for i in range(len(self.planned)):
            bit = 1 << i
            if bit & self.kitchen and not beside[i] & (self.dining or self.living):
                cost += KITCHEN_APART
            elif bit & self.dining and self.kitchen | self.living:
                cost += LIVING_APART * (not beside[i] & self.living)
            elif bit & self.living and self.entry:
                cost += LIVING_APART * (not beside[i] & (self.entry | self.living))
        return cost

    def _is_small(self, boxes: Sequence[Rect]) -> bool:
        """Tells of a bedroom with a bathroom of its own that is smaller than another bedroom."""
        owners = {owner for _, owner in self.owned}
        floors = {i: boxes[i].width * boxes[i].depth for i in self.bedrooms}
        suites = [floor for i, floor in floors.items() if i in owners]
        return bool(suites) and max(floors.values()) > max(suites)

    def _access(self, beside: Sequence[int], sheet: Sheet) -> tuple[int, int, int, int, int, bool]:
        """Counts rooms that no way leads to, bedrooms and others that only the entrance leads to.

        And bathrooms that only rooms one lives in lead to, private ones that only the kitchen does; and tells of a kitchen between.
        """
        first = len(self.planned)
        hall = (1 << first + len(sheet.hallways)) - (1 << first)
        ways = self.ways | hall
        start = self.entry & -self.entry or self.living & -self.living or hall & -hall or 1
        reached = _reached(beside, ways, start)
        past = reached & ~self.kitchen
        around = _reached(beside, past, start) if self.kitchen else reached
        unreached, at_entrance, others, off_living, past_kitchen = (ways & ~reached).bit_count(), 0, 0, 0, 0
        for bath, owner in self.owned:
            unreached += not beside[bath] >> owner & 1
        for i in self.leaves:
            doors = beside[i] & reached
            if not doors:
                unreached += not self._behind(i, beside, reached)
            elif doors == start and i not in self.bathrooms:
                at_entrance += i in self.bedrooms
                others += i not in self.bedrooms
            elif i in self.bathrooms | self.bedrooms:
                past_kitchen += not doors & around
                off_living += i in self.bathrooms and not doors & (self.entry | hall)
        return unreached, at_entrance, others, off_living, past_kitchen, bool(past & ~around)

    def _past_living(self, beside: Sequence[int], sheet: Sheet) -> tuple[int, int]:
        """Counts bedrooms, of several, that rooms one lives in lie between and every bathroom; and the entrance."""
        first = len(self.planned)
        hall = (1 << first + len(sheet.hallways)) - (1 << first)
        passages = self.entry | hall
        start = self.entry & -self.entry or self.living & -self.living or hall & -hall or 1
        met = _reached(beside, passages, start)
        at_baths = 0
        for bath in self.leaves:
            at_baths |= beside[bath] & passages if bath in self.bathrooms else 0
        washed = _reached(beside, passages, at_baths)
        reached = _reached(beside, self.ways | hall, start)
        doors = {i: beside[i] & reached for i in self.leaves if i in self.bedrooms and len(self.bedrooms) > 1}
        suites = {owner for _, owner in self.owned}
        return sum(i not in suites and not at & washed for i, at in doors.items()), sum(not at & met for at in doors.values())

    def _behind(self, room: int, beside: Sequence[int], reached: int) -> bool:
        """Tells whether a garage can be entered through a laundry that is reached itself."""
        through = self.through[room] & beside[room]
        return any(through >> i & 1 and beside[i] & reached for i in self.leaves)


def _reached(beside: Sequence[int], ways: int, start: int) -> int:
    """Returns the rooms that a way through rooms leads to."""
    reached = fresh = start
    while fresh:
        room = fresh.bit_length() - 1
        fresh &= ~(1 << room)
        found = beside[room] & ways & ~reached
        reached |= found
        fresh |= found
    return reached


def _beside(sheet: Sheet, met: Sequence[SharedWall]) -> list[int]:
    """Returns for every room, and the hallways last, which others share a wall with it that takes a door."""
    beside = [0] * (len(sheet.boxes) + len(sheet.hallways))
    for i, j, _, low, high in met:
        if high - low >= door_wall():
            beside[i] |= 1 << j
            beside[j] |= 1 << i
    return beside


def _covered(met: Sequence[SharedWall]) -> Covered:
    """Returns by room and wall at which stretches other rooms lie."""
    covered: Covered = {}
    for i, j, wall, low, high in met:
        covered.setdefault(i, {}).setdefault(wall, []).append((low, high))
        covered.setdefault(j, {}).setdefault(OPPOSITE[wall], []).append((low, high))
    return covered


def _lit(box: Rect, covered: Mapping[str, Sequence[tuple[int, int]]]) -> bool:
    """Tells whether a window fits in a stretch of a room's walls that lies outside."""
    if len(covered) < len(WALLS):
        return True
    return any(high - low >= LIT_MM for wall in WALLS for low, high in gaps_between(box.along(wall), covered[wall]))
