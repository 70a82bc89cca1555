"""A garden for a planned home: a strip beside the house, or behind an axial one, where no room loses its only window.

Of a house that is no rectangle it lies at the living spaces, in a court or wherever else they have an outer wall. Rooms one lives in are
entered from each other by passages, the others by doors off the hallway.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, NamedTuple

from catalogs.schema import Catalogs
from solver.floorplan.access import HOP, THROUGH_OTHER, THROUGH_PRIVATE, AccessPlan, RoomAccess, is_private, passing_cost
from solver.floorplan.programme.home_search import Frame
from solver.floorplan.tiling import Joint, Layout, Stretches
from solver.geometry import Rect

YARD_MM: Final = 5000
"""How deep the strip of garden is. Our choice: a patio of 14 m2 is then nearly as long as wide, with space for a tree."""
HOUSE_MM: Final = 6500
"""A plot that would leave the house less than this gets no garden."""
PATIO_MM: Final = (3400, 2800)
"""Lengths tried for a patio: 17 and 14 m2."""
BACKYARD_MM: Final = 4400
"""Least length of a backyard: 22 m2, the least in which its type holds two doors."""
LIT_MM: Final = 1800
"""Least outer wall that lights a room: a window of 1.2 m and 0.3 m of wall at each end."""
BEHIND: Final = ("north", "east", "west")
"""Where a garden may lie that not all of a side is free for: not at the street."""
BACKYARD: Final = "backyard"
PATIO: Final = "patio"


@dataclass(frozen=True)
class PlannedHome:
    """A home: its layout (own bathrooms `behind` their bedrooms), types, kind and notes."""

    layout: Layout
    types: tuple[str, ...]
    kind: str
    notes: tuple[str, ...]

    def access(self, shared: tuple[Joint, ...], catalogs: Catalogs, entrance: int) -> "HomeAccess":
        """Returns what the tree of doors is grown over."""
        nothing = AccessPlan((None,) * len(self.types), frozenset())
        return HomeAccess(self.types, shared, nothing, catalogs.rooms, self.layout.behind, entrance)


def house_frame(kind: str, frame: Frame) -> Frame:
    """Returns what a plot with a garden leaves for a house of a kind."""
    if kind == "axial":
        return frame._replace(depth=_less(frame.depth))
    return frame._replace(width=_less(frame.width))


def _less(length: int) -> int:
    return length - YARD_MM if length >= YARD_MM + HOUSE_MM else length


def with_yard(home: PlannedHome, frame: Frame, catalogs: Catalogs) -> PlannedHome:
    """Adds a garden to a home as it was planned for `house_frame`; `frame` is that of the plot, mm, 0 where it was chosen."""
    along = frame.depth if home.kind == "axial" else frame.width
    if along and along < YARD_MM + HOUSE_MM:
        return replace(home, notes=(*home.notes, f"no backyard: the house takes the whole plot of {along / 1000:g} m"))
    bent = sum(rect.width * rect.depth for rect in home.layout.rooms) < home.layout.outline.width * home.layout.outline.depth
    sides = BEHIND if bent else ("north",) if home.kind == "axial" else ("east", "west")
    offers = [offer for side in sides for offer in _offers(home, side, catalogs)]
    if bent:
        offers = [offer for offer in sorted(offers, key=lambda offer: -offer.lived_in) if _suits(home, offer, catalogs)]
    if not offers:
        return replace(home, notes=(*home.notes, "no backyard: no living space or hallway lies at that side of the house"))
    best = max(offers, key=lambda offer: (bent and offer.lived_in == len(offer.names), len(offer.names)))
    missing = () if PATIO in best.names else ("no patio: beside the backyard no living space or hallway leads to one",)
    return _beside(replace(home, notes=(*home.notes, *missing)), best)


class _Offer(NamedTuple):
    """A garden: what its parts are, where they lie in the house's frame, mm, and to how many of them a living space leads."""

    names: tuple[str, ...]
    rects: tuple[Rect, ...]
    lived_in: int


def _offers(home: PlannedHome, side: str, catalogs: Catalogs) -> Iterator[_Offer]:
    """Yields gardens along the outer walls of a side that can be entered."""
    least = home.layout.walls.door_wall
    for line, stretches in _facades(home.layout, side).items():
        for low, high in _merged([over for _, over in stretches]):
            ways = [(room, over) for room, over in stretches if catalogs.rooms[home.types[room]].plan.way_through]
            lived = [over for room, over in ways if catalogs.rooms[home.types[room]].plan.habitable]
            every = [over for _, over in ways]
            for names, spans in _parts(low, high):
                if all(_entered(span, every, least) for span in spans):
                    rects = tuple(_outside(line, side, span) for span in spans)
                    yield _Offer(names, rects, sum(_entered(span, lived, least) for span in spans))


def _parts(low: int, high: int) -> Iterator[tuple[tuple[str, ...], tuple[tuple[int, int], ...]]]:
    """Yields how a garden along a stretch of wall may be shared out."""
    for patio in PATIO_MM:
        if high - low - patio >= BACKYARD_MM:
            for cut, names in ((low + patio, (PATIO, BACKYARD)), (high - patio, (BACKYARD, PATIO))):
                yield names, ((low, cut), (cut, high))
    yield (BACKYARD,), ((low, high),)


def _facades(layout: Layout, side: str) -> dict[int, list[tuple[int, tuple[int, int]]]]:
    """Returns the outer walls of a side, by the line they lie on: rooms and stretches, mm."""
    found: dict[int, list[tuple[int, tuple[int, int]]]] = {}
    for room, exposed in enumerate(layout.exposed):
        for over in exposed.get(side, ()):
            found.setdefault(layout.rooms[room].line(side), []).append((room, over))
    return found


def _merged(stretches: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Returns stretches with those that follow each other as one."""
    merged: list[tuple[int, int]] = []
    for low, high in sorted(stretches):
        if merged and merged[-1][1] == low:
            merged[-1] = merged[-1][0], high
        else:
            merged.append((low, high))
    return merged


def _outside(line: int, side: str, span: tuple[int, int]) -> Rect:
    """Returns the strip of garden outside a stretch of wall."""
    if side == "north":
        return Rect(span[0], line - YARD_MM, span[1], line)
    return Rect(*((line, span[0], line + YARD_MM) if side == "east" else (line - YARD_MM, span[0], line)), span[1])


def _entered(span: tuple[int, int], ways: Sequence[tuple[int, int]], least: int) -> bool:
    return any(min(span[1], high) - max(span[0], low) >= least for low, high in ways)


def _suits(home: PlannedHome, offer: _Offer, catalogs: Catalogs) -> bool:
    """Tells whether a garden lies over no room, is large enough, and takes no room's only light."""
    rooms = home.layout.rooms
    if any(one.overlaps(room) for one in offer.rects for room in rooms):
        return False
    least = BACKYARD_MM * YARD_MM
    if any(rect.width * rect.depth < least for rect, name in zip(offer.rects, offer.names, strict=True) if name == BACKYARD):
        return False
    after = replace(home.layout, rooms=(*rooms, *offer.rects)).openable
    habitable = [i for i, name in enumerate(home.types) if catalogs.rooms[name].plan.habitable]
    return all(_is_lit(after[i]) or not _is_lit(home.layout.openable[i]) for i in habitable)


def _is_lit(exposed: Mapping[str, Stretches]) -> bool:
    return any(high - low >= LIT_MM for stretches in exposed.values() for low, high in stretches)


def _beside(home: PlannedHome, offer: _Offer) -> PlannedHome:
    """Lays the gardens beside the house and makes the plot as large as both."""
    rooms = [*home.layout.rooms, *offer.rects]
    west, north = min(rect.x0 for rect in rooms), min(rect.z0 for rect in rooms)
    moved = tuple(rect.moved(-west, -north) for rect in rooms)
    outline = Rect(0, 0, max(rect.x1 for rect in moved), max(rect.z1 for rect in moved))
    return replace(home, layout=replace(home.layout, outline=outline, rooms=moved), types=(*home.types, *offer.names))


NEVER: Final = 1000.0
"""Cost of the way to an own bathroom from anywhere but its bedroom, and of a way through it."""
OFF_HALLWAY: Final = 0.3
"""Cost of entering a living space from the hallway: from the next living space it is a passage, and costs less."""
BED_FROM_ENTRY: Final = 4.0
"""Cost of a bedroom entered from the entrance room, beside what it costs to walk through that."""
OFF_ENTRY: Final = 0.4
"""Cost of a small room entered from the entrance room: from the hallway beside it, it is out of sight."""
LIVING_TO_PRIVATE: Final = 1.2
"""Cost of a private room entered from a living space."""
SERVICE: Final = 0.1
"""Cost of a small wet room entered from the kitchen, of a garage entered from a laundry; of a private room from the kitchen, beside."""


@dataclass(frozen=True)
class HomeAccess(RoomAccess):
    """A planned home's rooms: `owners` names the bedroom of every own bathroom, `entrance` the entrance room."""

    owners: Mapping[int, int] = field(default_factory=dict)
    entrance: int = 0

    def cost(self, through: int, entered: int) -> float:
        """Returns what it costs to enter one room through another."""
        if through in self.owners:
            return NEVER
        if entered in self.owners:
            return HOP if self.owners[entered] == through else NEVER
        return HOP + self._passing(through, entered)

    def _passing(self, through: int, entered: int) -> float:
        via, to = self.rooms[self.types[through]].plan, self.rooms[self.types[entered]]
        if not via.way_through:
            if self.types[through] in to.plan.behind and not is_private(self.types[through], self.rooms):
                return SERVICE
            return (
                THROUGH_PRIVATE
                if is_private(self.types[through], self.rooms)
                else max(passing_cost(self.types[through], self.types[entered], self.rooms), THROUGH_OTHER)
            )
        private = is_private(self.types[entered], self.rooms)
        if private and not to.plan.wet and through == self.entrance:
            return BED_FROM_ENTRY
        if not via.habitable:
            if to.plan.way_through and to.plan.habitable:
                return OFF_HALLWAY if through != self.entrance else 0.0
            return OFF_ENTRY if through == self.entrance and not to.plan.way_through else 0.0
        if to.plan.way_through:
            return 0.0 if to.plan.habitable else SERVICE
        if via.wet and to.plan.wet and not private:
            return 0.0
        return LIVING_TO_PRIVATE + SERVICE * via.wet
