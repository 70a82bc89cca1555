"""A garden for a planned home: a strip beside the house, or behind an axial one, where no room loses its only window.

Comes in: a planned home. Goes out: the same with a backyard and, where there is a way to it, a patio.
May import: the ground floor, catalogs, the floor plan's layout.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from catalogs.schema import Catalogs
from solver.floorplan.access import AccessPlan
from solver.floorplan.programme.home_access import HomeAccess
from solver.floorplan.programme.home_search import Frame
from solver.floorplan.tiling import Joint, Layout, exterior_sides
from solver.geometry import Rect, strip

YARD_MM: Final = 5000
"""How deep the strip of garden is. Our choice: a patio of 14 m2 is then nearly as long as wide, with space for a tree."""
HOUSE_MM: Final = 6500
"""A plot that would leave the house less than this gets no garden."""
PATIO_MM: Final = (3400, 2800)
"""Lengths tried for a patio: 17 and 14 m2."""
BACKYARD_MM: Final = 4400
"""Least length of a backyard: 22 m2, the least in which its type holds two doors."""
BACKYARD: Final = "backyard"
PATIO: Final = "patio"


@dataclass(frozen=True)
class PlannedHome:
    """A home: its layout (own bathrooms `behind` their bedrooms), types, entry (None: wherever a plain house has it), kind."""

    layout: Layout
    types: tuple[str, ...]
    entry: int | None
    kind: str
    notes: tuple[str, ...]

    def access(self, shared: tuple[Joint, ...], catalogs: Catalogs, entrance: int) -> HomeAccess:
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
    """Adds a garden.

    Args:
        home: as planned for `house_frame`.
        frame: outer extents of the plot, mm; 0 where they were chosen.
        catalogs: which rooms are ways through.
    """
    along = frame.depth if home.kind == "axial" else frame.width
    if along and along < YARD_MM + HOUSE_MM:
        return replace(home, notes=(*home.notes, f"no backyard: the house takes the whole plot of {along / 1000:g} m"))
    sides = ("north",) if home.kind == "axial" else ("east", "west")
    offers = [offer for side in sides for offer in _offers(home, side, catalogs)]
    if not offers:
        return replace(home, notes=(*home.notes, "no backyard: no living space or hallway lies at that side of the house"))
    side, names, spans = max(offers, key=lambda offer: len(offer[1]))
    missing = () if PATIO in names else ("no patio: beside the backyard no living space or hallway leads to one",)
    return _beside(replace(home, notes=(*home.notes, *missing)), side, names, spans)


Offer = tuple[str, tuple[str, ...], tuple[tuple[int, int], ...]]


def _offers(home: PlannedHome, side: str, catalogs: Catalogs) -> Iterator[Offer]:
    """Yields gardens along a side that can be entered: their types and where they start and end along it."""
    (low, high), least = home.layout.outline.along(side), home.layout.walls.door_wall
    ways = [
        rect.along(side)
        for rect, name in zip(home.layout.rooms, home.types, strict=True)
        if catalogs.rooms[name].plan.way_through and side in exterior_sides(rect, home.layout.outline)
    ]
    for patio in PATIO_MM:
        if high - low - patio >= BACKYARD_MM:
            for cut, names in ((low + patio, (PATIO, BACKYARD)), (high - patio, (BACKYARD, PATIO))):
                if _entered((low, cut), ways, least) and _entered((cut, high), ways, least):
                    yield side, names, ((low, cut), (cut, high))
    if _entered((low, high), ways, least):
        yield side, (BACKYARD,), ((low, high),)


def _entered(span: tuple[int, int], ways: Sequence[tuple[int, int]], least: int) -> bool:
    return any(min(span[1], high) - max(span[0], low) >= least for low, high in ways)


def _beside(home: PlannedHome, side: str, names: tuple[str, ...], spans: tuple[tuple[int, int], ...]) -> PlannedHome:
    """Makes the plot longer on one side and lays the gardens there."""
    outline = home.layout.outline
    x, z = (YARD_MM if side == "west" else 0), (YARD_MM if side == "north" else 0)
    whole = Rect(0, 0, outline.x1 + (side != "north") * YARD_MM, outline.z1 + z)
    rooms = [*(rect.moved(x, z) for rect in home.layout.rooms), *(strip(whole, side, span, YARD_MM) for span in spans)]
    layout = replace(home.layout, outline=whole, rooms=tuple(rooms))
    return replace(home, layout=layout, types=(*home.types, *names))
