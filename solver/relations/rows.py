"""Relations, and what they speak of, as rows of the core: those of room_type.hpp and room.hpp in solver/core/furnish."""

from collections.abc import Iterable, Sequence
from struct import Struct
from typing import Final, get_args

from catalogs.relation_keys import OPENINGS
from catalogs.schema import RelationSpec, RelationWord
from solver.geometry import to_mm
from solver.pieces import Opened
from solver.relations.knee_room import PartBox
from solver.relations.subject import SurfaceHeight
from solver.scene import WALL_NUMBERS

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
