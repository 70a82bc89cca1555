"""What relations speak of: a room, a piece that seeks a place in it, and the pieces that are there before it; and how the core reads it.

The rows are those of room_type.hpp and room.hpp in solver/core/furnish. Lengths in millimetres, room-relative like everything in
`solver.pieces`. The boxes around a piece's parts tell where it can reach under another one (solver/core/furnish/relations/knee_room.cpp);
of kinds without a shape nothing is known.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from struct import Struct
from typing import Final, NamedTuple, get_args

from catalogs import Catalogs
from catalogs.checks import OPENINGS
from catalogs.schema import RelationSpec, RelationWord
from catalogs.shapes import Solid
from solver.body_parts import BodyPart, sized, unit_parts
from solver.geometry import Rect, to_mm
from solver.pieces import Extents, Opened, Stand
from solver.scene import WALL_NUMBERS, Sides

TINY: Final = 1e-6
"""What sums of shares may be off by, mm."""


class PartBox(NamedTuple):
    """The box around a part: its rectangle from the middle of the piece's footprint, from `low` to `high` above its underside, mm."""

    rect: Rect
    low: int
    high: int


def boxes_of(solids: Sequence[Solid], size: tuple[float, float, float]) -> tuple[PartBox, ...]:
    """Returns the boxes around the parts of a piece of some width, depth and height, m; rounded outwards.

    What is hollow counts as whole: nothing reaches under a piece into its drawers.
    """
    return tuple(_box(part) for part in sized(unit_parts(_wholes(solids)), *size)) if solids else ()


def _wholes(solids: Sequence[Solid]) -> list[Solid]:
    """Returns solids, those that are boards of one hollow part as the box around them."""
    found: dict[int | str, list[Solid]] = {}
    for number, solid in enumerate(solids):
        found.setdefault(f"alone {number}" if solid.board is None else solid.board, []).append(solid)
    return [several[0] if len(several) == 1 else _around(several) for several in found.values()]


def _around(solids: Sequence[Solid]) -> Solid:
    ends = {axis: [getattr(solid, axis) for solid in solids] for axis in "xyz"}
    spans = {axis: (min(low for low, _ in several), max(high for _, high in several)) for axis, several in ends.items()}
    return solids[0].model_copy(update=spans)


def _box(part: BodyPart) -> PartBox:
    (low_x, low_y, low_z), (high_x, high_y, high_z) = (
        [1000 * (at + side * length) for at, length in zip(part.at, part.size, strict=True)] for side in (-0.5, 0.5)
    )
    rect = Rect(math.floor(low_x + TINY), math.floor(low_z + TINY), math.ceil(high_x - TINY), math.ceil(high_z - TINY))
    return PartBox(rect, round(low_y), round(high_y))


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
    shape: str = ""
    """The kind in the catalogs whose shape it has."""

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
        need_all = bool(spec.use and spec.use.need == "all")
        return cls(name, millimetres, spec.stands == "wall", use_sides, need_all, levels, parts, shape or name)


def as_its_size_says(kind: Kind) -> Kind:
    """Returns what nobody knows, used as things of its size are: from the front what is tall, from any side what a hand reaches over."""
    if min(kind.size[:2]) < LEAST_USED_MM[0] or kind.size[2] < LEAST_USED_MM[1]:
        return kind
    return replace(kind, use_sides=("front",) if is_tall(kind) else ("front", "back", "left", "right"))


def is_tall(kind: Kind) -> bool:
    """Tells whether a piece is as tall as what stands with its back to a wall: a locker, a vending machine."""
    return kind.size[2] >= TALL_MM and min(kind.size[:2]) <= SHALLOW_MM


RELATION_WORDS: Final[tuple[str, ...]] = get_args(RelationWord)
SIDES: Final = ("left", "right", "front", "back")
"""As the core numbers them."""
WALLS_ASKED: Final = (None, "same", "opposite", "adjacent", "other")
"""How the walls of two pieces should lie, as the core numbers it."""
_ALIGNS: Final = (None, "back", "centre", "front", "any")
_OPENED: Final = Struct("<2i3q")
_OPENING: Final = {name: i for i, name in enumerate((*OPENINGS, "passage"))}
RULE, NAME, LEVEL, PART = "<12i3q2d", "<2i", "<3q", "<6q"
"""How their rows lie."""


def rule_row(spec: RelationSpec, names: tuple[int, int], sides: tuple[int, int], sorts: tuple[int, int]) -> tuple[float, ...]:
    """Returns the row of a relation; the others are which rows of their tables are its own, the first and how many."""
    low, high = map(to_mm, spec.gap or (0.0, 0.0))
    asked = RELATION_WORDS.index(spec.type), spec.required, _ALIGNS.index(spec.align), WALLS_ASKED.index(spec.wall)
    given = spec.distance is not None, spec.gap is not None
    return (*asked, *given, *names, *sides, *sorts, to_mm(spec.distance or 0.0), low, high, spec.cost, spec.weight)


def name_row(word: int, name: str) -> tuple[int, int]:
    """Returns the row of a name of an `of`, which is the core's word of that number."""
    return word, OPENINGS.index(name) if name in OPENINGS else -1


def part_row(part: PartBox) -> tuple[int, ...]:
    """Returns the row of a part's box."""
    return (*part.rect, part.low, part.high)


def level_row(level: SurfaceHeight, name: int) -> tuple[int, ...]:
    """Returns the row of a surface that is called by that number."""
    return level.height_mm, -1 if level.clearance_mm is None else level.clearance_mm, name


def opened_rows(openings: Iterable[Opened]) -> bytes:
    """Returns the rows of a room's openings."""
    return b"".join(
        [_OPENED.pack(_OPENING.get(kind, -1), WALL_NUMBERS[wall], *interval, across) for kind, wall, interval, across in openings]
    )


def side_numbers(sides: Sequence[str]) -> list[int]:
    """Returns sides by their numbers."""
    return [SIDES.index(side) for side in sides]
