"""What the catalogs say of a name in a scene; those they do not know ask for nothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from struct import Struct, pack
from typing import Final, NamedTuple, TypeAlias

from catalogs import Catalogs
from catalogs.entries import Use
from catalogs.fronts import BodyFront, fronts_of
from catalogs.kind_book import Carrying, KindBook
from catalogs.shapes import Axis, Solid
from catalogs.synonyms import KindSize
from solver.body_parts import is_round
from solver.body_rows import KindKey, key_of
from solver.records import MadeOnce
from solver.validator.lattice import exact
from solver.validator.world import FLAT, TURNS_TO

SEATED: Final = "seated"
_MOST_KNOWN: Final = 20_000
"""Kinds of which it is kept."""


KindFront: TypeAlias = tuple[str, bool, float, bool]
"""A front's name, whether it slides, its range (degrees, of a drawer m), and whether it must open."""


class KindFronts(NamedTuple):
    """The fronts of a kind.

    `rows` tell the core of them, `parts` of how many parts they have the `numbers`.
    """

    each: tuple[KindFront, ...]
    rows: bytes
    parts: int
    numbers: bytes


_KIND: Final = Struct("<6i")
_FRONT: Final = Struct("<4d4q")
_AXES: Final[dict[Axis, int]] = {"x": 0, "y": 1, "z": 2}
_PART: Final = Struct("<6dq")
_BOX, _BALL = 0, 4
_NO_FRONTS: Final = KindFronts((), b"", 0, b"")
NO_KIND: Final = _KIND.pack(0, 0, 0, 0, 0, 0)
"""A kind of which nothing is said, as the core reads it."""


@lru_cache(maxsize=4)
def kinds_of(catalogs: Catalogs) -> Kinds:
    """Returns the kinds of catalogs."""
    return Kinds(catalogs)


class Kinds:
    """Looks up names of furniture, decorations and room types.

    Of a body's kind `uses` says which sides of a piece are used; None where none is, it is unknown, or as flat as a rug. `fronts` are
    those of a piece, `rows` is the kind as the core reads it (`KindRow` of solver/core/validate/room.hpp), in lattice steps and shares of
    its box.
    """

    def __init__(self, catalogs: Catalogs) -> None:
        self.rooms = catalogs.rooms
        self._book = KindBook(catalogs)
        self.uses: Mapping[KindKey, Use | None] = MadeOnce(self._use_of, _MOST_KNOWN)
        self.fronts: Mapping[KindKey, KindFronts] = MadeOnce(self._fronts_of, _MOST_KNOWN)
        self.rows: Mapping[KindKey, bytes] = MadeOnce(self._row_of, _MOST_KNOWN)
        self._named = catalogs.kinds_by_name()
        self._carrying = Carrying(catalogs, self._book)

    def _use_of(self, key: KindKey) -> Use | None:
        _, name, _, _, height, _ = key_of(key)
        return self._named[name].use if name in self._named and exact(height) > FLAT else None

    def _fronts_of(self, key: KindKey) -> KindFronts:
        sort, name, width, depth, height, said = key_of(key)
        shape = self._book.kind_of(sort, name, (width, depth, height), said)
        return _fronts_as_told(fronts_of(self._book.solids(shape)), depth)

    def _row_of(self, key: KindKey) -> bytes:
        sort, name, width, depth, height, said = key_of(key)
        is_person, size = sort == "person", (width, depth, height)
        shape = self._book.living(name, said == SEATED) if is_person else self._book.kind_of(sort, name, size, said)
        surfaces = [] if is_person else self._carrying.surfaces_of(sort, name, size, said)
        solids = self._book.solids(shape)
        heights = [exact(length) for one in surfaces for length in (one.height, one.left, one.right, one.back, one.front)]
        parts = b"".join([_PART.pack(*solid.x, *solid.y, *solid.z, _filled(solid, size)) for solid in solids])
        fronts, uses = (self.fronts[key], self._sides_of(key)) if sort == "furniture" else (_NO_FRONTS, (0, 0))
        head = _KIND.pack(len(surfaces), len(solids), len(fronts.each), fronts.parts, *uses)
        return b"".join([head, pack(f"<{len(heights)}q", *heights), parts, fronts.rows, fronts.numbers])

    def _sides_of(self, key: KindKey) -> tuple[int, int]:
        """Returns the sides that a kind is used from, as bits by their turns: of which one must be come to, and which all must."""
        use = self.uses[key]
        bits = sum({1 << TURNS_TO[side] for side in use.sides}) if use else 0
        return (0, bits) if use and use.need == "all" else (bits, 0)


def _fronts_as_told(fronts: Sequence[BodyFront], depth: float) -> KindFronts:
    """Returns the fronts of a kind that is so deep, m."""
    each, rows = [], []
    numbers: list[int] = []
    for one in fronts:
        each.append((one.name, one.slides, round(abs(one.end) * (depth if one.slides else 1.0), 6), one.must_open))
        rows.append(_FRONT.pack(*one.hinge, one.end, _AXES[one.axis], one.slides, len(numbers), len(one.parts)))
        numbers += one.parts
    return KindFronts(tuple(each), b"".join(rows), len(numbers), pack(f"<{len(numbers)}q", *numbers))


def _filled(solid: Solid, size: KindSize) -> int:
    """Returns how a solid of a body of some size fills its box, as the core numbers it: as a box, along x, y or z, as a ball."""
    width, depth, height = size
    lengths = (solid.x[1] - solid.x[0]) * width, (solid.y[1] - solid.y[0]) * height, (solid.z[1] - solid.z[0]) * depth
    if solid.form == "ball":
        return _BALL
    return 1 + "xyz".index(solid.axis) if is_round(solid.form, solid.axis, lengths) else _BOX
