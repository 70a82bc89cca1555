"""Room types as the core reads them: rows of numbers, one table after the other; names are indices. Of kinds the floor about them, too.

The rows are those of solver/core/furnish/room_type.hpp, in the same order. Floor about a kind that is better kept free is what its catalog
says, and what its fronts open over.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, floor, inf
from struct import Struct
from typing import Final, NamedTuple

from catalogs.access_profiles import AccessProfile, AccessRule
from catalogs.entries import Comfort, Run, Side
from catalogs.fronts import FrontFloor, floor_before
from catalogs.schema import Catalogs, FurnitureSpec, PieceSpec, RelationSpec, RoomType, Variant
from catalogs.shapes import Solid
from solver.body_rows import Look, furniture_look
from solver.core.core_tables import CoreTables, TableRange
from solver.geometry import to_mm
from solver.pieces import NamedKinds
from solver.relations.subject import (
    LEVEL,
    NAME,
    PART,
    RULE,
    SIDES,
    Kind,
    SurfaceHeight,
    level_row,
    name_row,
    part_row,
    rule_row,
    side_numbers,
)

WEIGHED: Final = 1.0
"""Floor that is worth so much is weighed together with the piece's place."""
HALF_OPEN: Final = 1.0
"""What it costs a piece that its fronts open no more than half of their way."""


class FloorAbout(NamedTuple):
    """Floor at a side of a kind, as `Comfort` of solver/core/furnish/room_type.hpp: lengths in mm.

    Where fronts `open` over it, they open wholly where it is as deep as `depth`, half of their way where it is `half`; it reaches from
    `left` to `right` of the kind's middle, and from `above` its underside on; `along_side` tells that the edge of a door goes along one of
    the kind's sides. What a standard asks for is numbered by `asked`; at the `other` side it will do as well; it begins `off` the side.
    """

    side: Side
    opens: bool
    depth: int
    behind: int
    cost: float
    half: int = 0
    left: int = 0
    right: int = 0
    above: int = 0
    asked: int = 0
    other: Side | None = None
    off: int = 0
    along_side: bool = False


def floors_about(spec: FurnitureSpec, solids: Sequence[Solid]) -> tuple[FloorAbout, ...]:
    """Returns the floor that is better kept free about a kind with this shape, what its fronts open over last.

    Floor at its front that is worth much and as deep as its fronts need takes their place.
    """
    width, own = (to_mm(length) for length in spec.size[:2])
    wished = [_wished(side, one, width if side in _LONG else own) for side, one in spec.comfort.items()]
    fronts = floor_before(solids, spec.size)
    if fronts is None:
        return tuple(wished)
    depth, half = (_beside(own, ceil(length * 1000)) for length in (fronts.depth, fronts.half))
    for one in wished:
        if one.side == "front" and not one.off and one.cost >= WEIGHED and one.depth >= depth:
            aside = width // 2
            wished.remove(one)
            return (*wished, FloorAbout("front", True, one.depth, 0, one.cost, half, -aside, aside, along_side=fronts.along_side))
    left, right = _aside(fronts)
    over = FloorAbout("front", True, depth, 0, HALF_OPEN, half, left, right, floor(fronts.above * 1000), along_side=fronts.along_side)
    return (*wished, over)


def opened_about(kind: Kind, catalogs: Catalogs) -> tuple[FloorAbout, ...]:
    """Returns the floor that the fronts of a kind in its size open over."""
    spec, solids = catalogs.furniture.get(kind.name), catalogs.shapes.get(kind.shape, ())
    if spec is None or not solids:
        return ()
    width, depth, height = (length / 1000 for length in kind.size)
    return tuple(one for one in floors_about(spec.model_copy(update={"size": (width, depth, height)}), solids) if one.opens)


def _wished(side: Side, wish: Comfort, own: int) -> FloorAbout:
    """Returns the floor that a kind, so long across that side, wishes for there."""
    depth, behind = _beside(own, to_mm(wish.depth)), to_mm(wish.behind)
    return FloorAbout(side, False, depth, behind, wish.cost) if side in _LONG else FloorAbout(side, False, depth, 0, wish.cost, off=behind)


def _beside(own: int, depth: int) -> int:
    """Returns a depth with which floor that touches a piece so long has its middle on a whole millimetre, and not within the piece."""
    return depth + (own + depth) % 2


def _aside(fronts: FrontFloor) -> tuple[int, int]:
    """Returns from where to where fronts open over the floor before them; its middle is a whole millimetre."""
    left, right = floor(fronts.left * 1000), ceil(fronts.right * 1000)
    odd = (right - left) % 2
    return (left, right + odd) if right < -left else (left - odd, right)


def asked_about(profile: AccessProfile, room: str, name: str) -> tuple[FloorAbout, ...]:
    """Returns the strips of floor that a profile asks for about a piece of a name in a room of a type, numbered from 1."""
    rules = [rule for rule in profile.rules if name in rule.pieces and rule.is_about(room)]
    strips = [strip for rule in rules for strip in _STRIPS[rule.what](rule)]
    return tuple(strip._replace(asked=number) for number, strip in enumerate(strips, start=1))


def _along(rule: AccessRule) -> tuple[FloorAbout, ...]:
    least, other = to_mm(rule.min), to_mm(rule.other or 0.0)
    each = [FloorAbout(side, False, other, 0, 0.0) for side in _LONG]
    wide = [FloorAbout(_LONG[0], False, least, 0, 0.0, other=_LONG[1])] if least > other else []
    if not rule.beside:
        return (*each, *wide)
    behind, off = (to_mm(length) for length in BESIDE)
    return tuple(part for one in (*each, *wide) for part in (one._replace(behind=behind), one._replace(off=min(off, one.depth))))


def _before(rule: AccessRule) -> tuple[FloorAbout, ...]:
    half = to_mm(rule.min) // 2 + to_mm(rule.min) % 2
    return (FloorAbout("front", False, to_mm(rule.deep or 0.0), 0, 0.0, left=-half, right=half),)


def _deep(rule: AccessRule) -> tuple[FloorAbout, ...]:
    return (FloorAbout("front", False, to_mm(rule.min), 0, 0.0),)


_LONG: Final[tuple[Side, Side]] = ("left", "right")
BESIDE: Final = (0.6, 0.55)
"""What may stand beside a piece takes so much of the strips along it: from the piece's back on, and from its side, m."""
_STRIPS: Final[Mapping[str, Callable[[AccessRule], tuple[FloorAbout, ...]]]] = {
    "along": _along,
    "before": _before,
    "deep": _deep,
}


_CORNERS: Final = (None, "left", "right")
_SORTS: Final = ("door", "window", "exterior", "plain", "short", "long", "across")
_ROW: Final = {
    name: Struct(layout)
    for name, layout in {
        "kind": "<3q14i", "level": LEVEL, "part": PART, "piece": "<12i4d", "variant": "<2i3d", "rule": RULE, "name": NAME,
        "sort": "<2id", "side": "<i", "comfort": "<2i2qd4q2iq", "order": "<2i", "word": "<i", "worktop": "<i", "landing": "<i",
        "end": "<i", "triangle": "<i", "leaving": "<2iqd",
    }.items()
}  # fmt: skip
_HEADER: Final = Struct("<20i")
_MOST_KEPT: Final = 128
"""Room types of the homes made last: a home changes those that must hold what it has no room for."""
_MOST_CATALOGS: Final = 16


@dataclass(frozen=True, eq=False)
class CompiledType:
    """A room type for the core: its bytes, and the pieces and kinds that its rows speak of.

    `looks` is how furniture of each kind looks, `made_from` the room type and what it was compiled with.
    """

    data: bytes
    specs: tuple[PieceSpec, ...]
    kinds: tuple[Kind, ...]
    looks: Sequence[Look]
    made_from: tuple[object, ...]

    @cached_property
    def named(self) -> NamedKinds:
        """Names and sizes of the kinds."""
        return tuple((kind.name, kind.size) for kind in self.kinds)


_kept: dict[tuple[int, ...], CompiledType] = {}
_known_kinds: dict[tuple[int, ...], tuple[tuple[object, ...], dict[str, Kind]]] = {}
"""By the catalogs' kinds and shapes: these, and their kinds as relations see them; homes share them where their room types differ."""


def compiled_type(room_type: RoomType | None, catalogs: Catalogs, name: str = "") -> CompiledType:
    """Returns a room type of the catalogs for the core, the same object for the same one and catalogs; None wants nothing.

    `name` is what the catalogs call it, for what their profile asks for in such rooms.
    """
    made_from = (room_type, catalogs.furniture, catalogs.shapes, catalogs.profile)
    key = tuple(map(id, made_from))
    found = _kept.get(key)
    if found is None:
        if len(_kept) >= _MOST_KEPT:
            _kept.pop(next(iter(_kept)), None)
        tables = _Tables(catalogs, name if room_type and not room_type.outdoor else None)
        specs = tuple(spec for spec in (room_type.pieces if room_type else ()) if not spec.without)
        data, kinds = tables.compiled(room_type.run if room_type else None, specs), tuple(tables.kinds.values())
        looks = [furniture_look(kind.name, kind.size, catalogs) for kind in kinds]
        found = _kept[key] = CompiledType(data, specs, kinds, looks, made_from)
    return found


def _kinds_of(catalogs: Catalogs) -> dict[str, Kind]:
    """Returns the kinds of the catalogs that were asked for before, to be added to."""
    made_from = (catalogs.furniture, catalogs.shapes)
    key = tuple(map(id, made_from))
    if key not in _known_kinds:
        if len(_known_kinds) >= _MOST_CATALOGS:
            _known_kinds.clear()
        _known_kinds[key] = made_from, {}
    return _known_kinds[key][1]


class KindTables(CoreTables):
    """Tables of kinds and relations while they are written."""

    layouts, header = _ROW, _HEADER

    def __init__(self) -> None:
        super().__init__()
        self._surfaces: dict[str, int] = {}

    def _add_kind(self, kind: Kind, about: Sequence[FloorAbout], name: int) -> None:
        """Adds a kind with floor about it; `name` is the same for kinds of one name."""
        comforts = self._added("comfort", about, self._comfort)
        self._added("kind", [kind], lambda _: self._kind_row(kind, comforts, name))

    def _comfort(self, floor: FloorAbout) -> tuple[float, ...]:
        other = -1 if floor.other is None else SIDES.index(floor.other)
        return (SIDES.index(floor.side), floor.opens + floor.along_side, *floor[2:-3], other, floor.off)

    def _kind_row(self, kind: Kind, comforts: TableRange, name: int) -> tuple[float, ...]:
        sides = sum({1 << SIDES.index(side) for side in kind.use_sides})
        levels = self._added("level", kind.levels, self._level)
        parts = self._added("part", kind.parts, part_row)
        use = self._sides(kind.use_sides)
        return (*kind.size, kind.at_walls, len(kind.use_sides), sides, kind.need_all, *levels, *parts, *use, *comforts, name, 0)

    def _sides(self, sides: Sequence[str]) -> TableRange:
        return self._added("side", side_numbers(sides), lambda side: (side,))

    def _level(self, one: SurfaceHeight) -> tuple[int, ...]:
        name = self._surfaces.setdefault(one.name, len(self._surfaces))
        return level_row(one, name)

    def _rule(self, rule: RelationSpec) -> tuple[float, ...]:
        names = self._added("name", rule.of, lambda name: name_row(self._word(name), name))
        sides = self._sides(rule.sides)
        sorts = self._added("sort", rule.walls.items(), lambda sort: (_SORTS.index(sort[0]), 0, sort[1]))
        return rule_row(rule, names, sides, sorts)


class _Tables(KindTables):
    """The tables of a room type while they are written."""

    def __init__(self, catalogs: Catalogs, indoors: str | None) -> None:
        super().__init__()
        self._profile = catalogs.profile if indoors else None
        self._room = indoors or ""
        self.kinds: dict[str, Kind] = {}
        self._catalogs, self._known = catalogs, _kinds_of(catalogs)
        self._names: dict[str, int] = {}
        self._among: dict[str, int] = {}

    def compiled(self, run: Run | None, specs: Sequence[PieceSpec]) -> bytes:
        """Returns the bytes of a room type with its run and those of its pieces that are wanted."""
        for spec in specs:
            self._add_piece(spec)
        if run is not None:
            self._added("order", run.orders, lambda order: self._added("word", order, lambda name: (self._word(name),)))
            for table, names in (("worktop", run.worktop), ("landing", run.landing), ("end", run.ends), ("triangle", run.triangle)):
                self._added(table, names, lambda name: (self._word(name),))
            self._added("leaving", run.leaves, lambda one: (self._word(one.to), 0, to_mm(one.floor), one.cost))
        for kind in self.kinds.values():
            self._add_known(kind)
        turning = to_mm(self._profile.turning(self._room)) if self._profile else 0
        return self._packed(len(self._words), run is not None, turning)

    def _kind(self, name: str) -> int:
        if name not in self.kinds:
            if name not in self._known:
                self._known[name] = Kind.of(name, self._catalogs)
            self.kinds[name] = self._known[name]
        return [*self.kinds].index(name)

    def _add_known(self, kind: Kind) -> None:
        spec = self._catalogs.furniture.get(kind.name)
        about = floors_about(spec, self._catalogs.shapes.get(kind.name, ())) if spec else ()
        about += asked_about(self._profile, self._room, self._catalogs.name_of(kind.name)) if self._profile else ()
        self._add_kind(kind, about, self._names.setdefault(self._catalogs.name_of(kind.name), len(self._names)))

    def _add_piece(self, spec: PieceSpec) -> None:
        variants = self._added("variant", spec.variants, self._variant)
        rules = self._added("rule", spec.rules, self._rule)
        among = -1 if spec.among is None else self._among.setdefault(spec.among, len(self._among))
        counted = (self._word(spec.piece), spec.required, spec.count, among, spec.per_area is not None, spec.with_next)
        shares = spec.per_area or 0.0, spec.min_area, spec.chance, spec.skip_cost
        approach = self._sides(spec.approach)
        self._added("piece", [spec], lambda _: (*counted, *variants, *rules, *approach, *shares))

    def _variant(self, one: Variant) -> tuple[float, ...]:
        return self._kind(one.kind), _CORNERS.index(one.corner) - 1, one.cost, one.min_area, inf if one.max_area is None else one.max_area
