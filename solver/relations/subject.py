"""What relations speak of: a room, a piece that seeks a place in it, and the pieces that are there before it.

Lengths in millimetres, room-relative like everything in `solver.pieces`.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

from catalogs import Catalogs
from solver.geometry import Rect, to_mm
from solver.pieces import Extents, Opened, Stand
from solver.relations.knee_room import PartBox, boxes_of
from solver.scene import Sides

NO_SIDES = Sides()
TALL_MM, SHALLOW_MM = 1200, 900
"""What is as tall as that, and no deeper, is used from one side and stands at a wall."""
LEAST_USED_MM = (300, 300)
"""Shorter side and height of the smallest thing that a person has to come to."""


@dataclass(frozen=True)
class Scope:
    """A room as relations see it; `gap_mm` is how far from a wall's face the back of a body at that wall stands."""

    clear: Rect
    openings: tuple[Opened, ...]
    gap_mm: int = 30
    exterior: Sides = NO_SIDES


class SurfaceHeight(NamedTuple):
    """A surface of a piece: its name, its height above the piece's underside, and the free height above it (None: any), mm."""

    name: str
    height_mm: int
    clearance_mm: int | None


@dataclass(frozen=True)
class Kind:
    """A kind of furniture in one size: how it stands, is used, and carries things.

    `use_sides` are those a person must get to, all of them where `need_all` is set. `parts` are none where it has no shape.
    """

    name: str
    size: Extents
    at_walls: bool = False
    use_sides: tuple[str, ...] = ()
    need_all: bool = False
    levels: tuple[SurfaceHeight, ...] = ()
    parts: tuple[PartBox, ...] = ()

    @property
    def stands(self) -> tuple[Stand, ...]:
        """Where a person stands to use it."""
        return tuple(Stand(side) for side in self.use_sides)

    def below(self, ceiling_mm: int) -> "Kind":
        """Returns the kind in a room so high: nothing that reaches above stands on it."""
        free = ((one, ceiling_mm - one.height_mm) for one in self.levels)
        levels = (one._replace(clearance_mm=most if one.clearance_mm is None else min(one.clearance_mm, most)) for one, most in free)
        return replace(self, levels=tuple(levels))

    @classmethod
    def of(cls, name: str, catalogs: Catalogs, size: tuple[float, float, float] | None = None, shape: str | None = None) -> "Kind":
        """Returns a kind of the catalogs, or what the user calls by a word of their own.

        Args:
            name: the catalogs' name, or the user's: then it stands free and carries things on top.
            catalogs: what is known of kinds.
            size: width, depth and height, m, where they are not the catalogs'; surfaces are as much higher.
            shape: the kind whose shape it has, where that is not the one of its name.
        """
        spec = catalogs.furniture.get(name)
        width, depth, height = extents = (size or spec.size) if spec else size or (1.0, 1.0, 1.0)
        millimetres = to_mm(width), to_mm(depth), to_mm(height)
        if spec is None:
            return cls(name, millimetres, levels=(SurfaceHeight("top", millimetres[2], None),))
        grown = extents[2] / spec.size[2]
        levels = tuple(
            SurfaceHeight(one.name, to_mm(round(one.height * grown, 3)), None if one.clearance is None else to_mm(one.clearance))
            for one in spec.surfaces
        )
        use_sides = spec.use.sides if spec.use else ()
        parts = boxes_of(catalogs.shapes.get(shape or name, ()), extents)
        return cls(name, millimetres, spec.stands == "wall", use_sides, bool(spec.use and spec.use.need == "all"), levels, parts)


def as_its_size_says(kind: Kind) -> Kind:
    """Returns what nobody knows, used as things of its size are: from the front what is tall, from any side what a hand reaches over."""
    if min(kind.size[:2]) < LEAST_USED_MM[0] or kind.size[2] < LEAST_USED_MM[1]:
        return kind
    return replace(kind, use_sides=("front",) if is_tall(kind) else ("front", "back", "left", "right"))


def is_tall(kind: Kind) -> bool:
    """Tells whether a piece is as tall as what stands with its back to a wall: a locker, a vending machine."""
    return kind.size[2] >= TALL_MM and min(kind.size[:2]) <= SHALLOW_MM
