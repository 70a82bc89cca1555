"""What a relation is asked with, and what it may answer; plain frozen types."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from catalogs.schema import Catalogs, Furniture, Piece
from solver.furnish.walls import WallOccupancy
from solver.geometry import to_mm
from solver.scene import Sides
from solver.wanted import Alternative, Link, Space

Size = tuple[int, int, int]
"""Unrotated width, depth and height, mm."""


@dataclass(frozen=True)
class Opened:
    """An opening of the room: its kind, wall, and the ends of its stretch along that wall, mm."""

    kind: str
    wall: str
    interval: tuple[int, int]
    across: int

    @property
    def centre(self) -> tuple[int, int]:
        """Its middle on the wall's line (x, z), mm."""
        along = sum(self.interval) // 2
        return (along, self.across) if self.wall in ("north", "south") else (self.across, along)


@dataclass(frozen=True)
class Scope:
    """The room as the relations see it; the same for all its pieces."""

    space: Space
    walls: WallOccupancy
    catalogs: Catalogs
    openings: tuple[Opened, ...]
    exterior: Sides
    area: float

    def entry(self, kind: str) -> Furniture:
        """Returns the catalog's entry of a kind."""
        return self.catalogs.furniture[kind]

    def size(self, kind: str) -> Size:
        """Returns a kind's unrotated extents, mm."""
        width, depth, height = self.entry(kind).size
        return to_mm(width), to_mm(depth), to_mm(height)

    def opened(self, kind: str) -> list[Opened]:
        """Returns the room's openings of a kind; passages are doors here."""
        return [opening for opening in self.openings if opening.kind == kind or (kind == "door" and opening.kind == "passage")]


@dataclass(frozen=True)
class Ask:
    """One copy of a piece that wants its alternatives; `earlier` are the labels of the pieces before it, by piece name."""

    scope: Scope
    piece: Piece
    number: int
    earlier: Mapping[str, tuple[str, ...]]
    kinds: Mapping[str, tuple[str, ...]]
    """The size variants of every piece before it, by label."""

    def parents(self, names: tuple[str, ...]) -> list[tuple[str, str]]:
        """Returns (label, kind) of every earlier piece of those names, in each of its variants."""
        return [(label, kind) for name in names for label in self.earlier.get(name, ()) for kind in self.kinds[label]]

    def labels(self, names: tuple[str, ...]) -> list[str]:
        """Returns the labels of the earlier pieces of those names."""
        return [label for name in names for label in self.earlier.get(name, ())]

    def faces(self, names: tuple[str, ...]) -> bool:
        """Tells whether a rule turns this piece towards one of those."""
        return any(rule.type == "facing" and set(rule.of) & set(names) for rule in self.piece.rules)


Judge = Callable[[Alternative], float]
"""Returns what an alternative costs by one rule; infinity forbids it."""


@dataclass(frozen=True)
class Effect:
    """What a rule does to a piece's alternatives.

    Args:
        slots: ways to stand at another piece.
        links: conditions and terms against earlier pieces.
        judge: cost of an alternative that is no slot.
        positions: further centres along a wall to try (wall, kind, mm), beside the ends and middles of its clear stretches.
        spots: further free anchors to try (kind, (x, z) mm).
        corners: free pieces are tried in the room's corners.
        backs: free pieces are tried with their back at each wall.
        weight: pull towards the anchor, m^-2, where the rule wants a firm one.
    """

    slots: tuple[Alternative, ...] = ()
    links: tuple[Link, ...] = ()
    judge: Judge | None = None
    positions: tuple[tuple[str, str, int], ...] = ()
    spots: tuple[tuple[str, tuple[int, int]], ...] = ()
    corners: bool = False
    backs: bool = False
    weight: float = 0.0


NOTHING = Effect()
