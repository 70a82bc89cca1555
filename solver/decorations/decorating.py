"""decorated_rooms(): the rooms of a house. The work is the core's, which reads and answers rows: solver/core/decorate/room.hpp.

What the catalogs say of decorations, in one style, and of what is decorated, in any, is sent as rows of numbers, one table after the other;
names are indices. They are those of solver/core/decorate/decorating.hpp, in the same order.
"""

import math
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from struct import Struct, pack
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.decoration_types import ALL, INDOOR, SURFACE, Decorating, DecoratingRow, DecorationKind, Hangs, Holds, Lies, Stands
from catalogs.entries import Comfort, Side, Surface
from catalogs.fronts import floor_before
from catalogs.insides import InsideSurface, insides_of
from catalogs.kind_book import UPRIGHT, KindBook
from catalogs.shapes import Solid
from catalogs.styles import Leaning, Style
from solver.body_rows import SIZE, BodyTurn, DecorationRows, Look, LooksBySize, count_furniture, furniture_turns, key_of, looks_in, told
from solver.core import borrowed
from solver.core.core_tables import CoreTables, TableRange
from solver.demanded import demand
from solver.free_floor import sides_seen
from solver.free_places import RECT, furniture_as_told
from solver.geometry import Rect, to_mm, wall_faced
from solver.pieces import DOORWAY, Space
from solver.records import MadeOnce
from solver.scene import WALL_NUMBERS, Opening, Room
from solver.streams import Stream

SCALE_STEP: Final = 0.1
"""By which share things are made smaller where they do not fit. Our choice."""
FAVOURED: Final = 1.5
"""How much more often a style has what it is fond of. Our choice."""
OFF_MM: Final = 10
"""So far what lies inside a piece stays off its boards and what is above, mm. Our choice."""
SEAT: Final = "seat"
"""What a surface to sit on is called."""
_WHERE: Final = ("middle", "corner", "beside", "wall", "free", "under")
"""As the core numbers them."""
_ITSELF, _NO_LIMIT = -1, -1
_ROW: Final = "d10i"
_TABLES: Final = {
    name: Struct(layout)
    for name, layout in {
        "entry": "<10i", "lies": f"<{_ROW}10i2dq", "hangs": f"<{_ROW}2i2q", "stands": f"<{_ROW}4i4d4q", "choice": "<4i", "size": "<3q",
        "kind": "<3q6i", "surface": "<7q", "word": "<i", "place": "<2d", "share": "<d", "turn": "<2d",
    }.items()
}  # fmt: skip
_HEADER: Final = Struct("<14i")
_MOST_KEPT: Final = 64
_MOST_LOOKS: Final = 20_000
_MANNER: Final = Struct("<12i64s")
_BESIDE: Final = Struct("<4i")

SizeMm = tuple[int, int, int]
"""Width, depth and height, mm."""


@dataclass(frozen=True)
class DecorationSettings:
    """What the rooms of a storey are decorated with, in which style, m from floor to ceiling, and by room what is `kept` free.

    That is floor on which nothing is to come to stand, beside that at the sides of furniture, mm in the room.
    """

    catalogs: Catalogs
    style: Style | None = None
    style_name: str = ""
    height: float = 2.8
    kept: Mapping[str, Sequence[Rect]] = field(default_factory=dict)


def millimetres(size: tuple[float, float, float]) -> SizeMm:
    """Converts extents in metres."""
    return to_mm(size[0]), to_mm(size[1]), to_mm(size[2])


class _SurfaceTables(CoreTables):
    """The tables of what decorates, of which those of surfaces are written."""

    layouts, header = _TABLES, _HEADER

    def surfaces(self, surfaces: Sequence[Surface]) -> TableRange:
        """Adds surfaces."""

        def numbers(one: Surface) -> tuple[int, ...]:
            clearance = _NO_LIMIT if one.clearance is None else to_mm(one.clearance)
            return to_mm(one.height), *[to_mm(one.inset)] * 4, clearance, self._word(one.name)

        return self._added("surface", surfaces, numbers)

    def insides(self, solids: Sequence[Solid], size: tuple[float, float, float]) -> TableRange:
        """Adds what carries things inside a shape of that size: up to whole mm, so that nothing begins in a board."""
        half_width, half_depth = size[0] / 2, size[1] / 2

        def numbers(one: InsideSurface) -> tuple[int, ...]:
            insets = one.x[0] + half_width, half_width - one.x[1], one.z[0] + half_depth, half_depth - one.z[1]
            free = one.clearance - (0.0 if one.drawer else OFF_MM / 1000)
            level = math.ceil(one.height * 1000 - 1e-6)
            return level, *(math.ceil(inset * 1000 - 1e-6) + OFF_MM for inset in insets), math.floor(free * 1000) - 1, self._word(one.sort)

        return self._added("surface", insides_of(solids, size), numbers)


class FurnitureManners(_SurfaceTables):
    """What is said of furniture, `rows` of what it is and its turn, and the tables of its surfaces."""

    def __init__(self, catalogs: Catalogs) -> None:
        kinds, shapes = catalogs.furniture, catalogs.shapes
        super().__init__(dict.fromkeys([*catalogs.decorating, *(one.name or kind for kind, one in kinds.items())]))
        self.rows = MadeOnce(self._row, _MOST_LOOKS)
        carrying = {(one.name or kind, millimetres(one.size)): one.surfaces for kind, one in reversed(kinds.items())}
        self._surfaces = {key: self.surfaces(surfaces) for key, surfaces in carrying.items()}
        self._insides = {(kind, millimetres(one.size)): self.insides(shapes.get(kind, ()), one.size) for kind, one in kinds.items()}
        self._fronts = {kind: before for kind, one in kinds.items() if (before := floor_before(shapes.get(kind, ()), one.size))}
        named = catalogs.kinds_by_name().items()
        self._faced = {name for name, kind in named if (kind.use.sides == ("front",) if kind.use else kind.stands == "wall")}
        self._uses, self._book, self._kinds = catalogs.use_sides(), KindBook(catalogs), kinds

    def _row(self, key: BodyTurn) -> bytes:
        (_, name, width, depth, height, said), rotation = key_of(key[0]), key[1]
        size, is_right = millimetres((width, depth, height)), rotation % 90 == 0
        kind = said or self._book.kind_of("furniture", name, (width, depth, height)) or name
        sides, need_all = self._uses.get(name, ((), False))
        before = self._fronts.get(kind) if is_right else None
        opens = (0, 0) if before is None else (to_mm(before.depth), to_mm(before.above))
        turn = round(rotation) % 360 if is_right else 0
        surfaces, insides = self._surfaces.get((name, size), (0, 0)), self._insides.get((kind, size), (0, 0)) if is_right else (0, 0)
        wishing = self._kinds.get(said or name) if is_right else None
        beside = [*_kept_beside(wishing.comfort, turn)] if wishing else []
        used = name in self._faced, sides_seen(wall_faced(side, rotation) for side in sides), need_all
        return _MANNER.pack(turn, self._words.get(name, -1), *surfaces, *insides, *used, *opens, len(beside), b"".join(beside))


def _kept_beside(comforts: Mapping[Side, Comfort], turn: int) -> Iterator[bytes]:
    """Yields the floor at the sides of a piece that is better kept free."""
    at_low = wall_faced("back", turn) in ("north", "west")
    for side, wish in comforts.items():
        behind = to_mm(wish.behind) if side in ("left", "right") else 0
        ends = (behind, 0) if at_low else (0, behind)
        yield _BESIDE.pack(WALL_NUMBERS[wall_faced(side, turn)], *ends, to_mm(wish.depth))


_manners_of: Final = lru_cache(maxsize=4)(FurnitureManners)


@dataclass(frozen=True, eq=False)
class CompiledDecorating:
    """What decorates in some style, for the core.

    Args:
        data: its bytes.
        looks: how the kinds of decorations look, as its rows count them.
        colours: what each is drawn from.
        styled: whether those are the style's.
        words: the numbers of names.
        manners: what is said of furniture, in any style.
        made_from: what it was compiled from.
    """

    data: bytes
    looks: LooksBySize
    colours: Sequence[Sequence[str]]
    styled: Sequence[bool]
    words: Mapping[str, int]
    manners: FurnitureManners
    made_from: tuple[object, ...]


_kept: dict[tuple[object, ...], CompiledDecorating] = {}


def compiled_decorating(settings: DecorationSettings) -> CompiledDecorating:
    """Returns what decorates by some settings, for the core; the same object for the same catalogs and style."""
    known = settings.catalogs
    made_from = (known.furniture, known.decorations, known.decorating, known.shapes, settings.style)
    key = (*map(id, made_from), settings.style_name)
    found = _kept.get(key)
    if found is None:
        if len(_kept) >= _MOST_KEPT:
            _kept.pop(next(iter(_kept)), None)
        found = _kept[key] = _DecoratingTables(settings).compiled(made_from)
    return found


@lru_cache(maxsize=4)
def looks_by_kind(catalogs: Catalogs) -> LooksBySize:
    """Returns how the things of some catalogs look, by the number of their kind and their size, mm."""
    kinds, book = tuple(catalogs.decorations), KindBook(catalogs)
    tipped = frozenset(name for name in kinds if name + UPRIGHT in catalogs.shapes)

    def look(key: tuple[int, bytes]) -> Look:
        width, depth, height = SIZE.unpack(key[1])
        name, size = kinds[key[0]], (width / 1000, depth / 1000, height / 1000)
        return Look("decoration", name, book.kind_of("decoration", name, size) if name in tipped else name, size)

    return MadeOnce(look, _MOST_LOOKS)


class _DecoratingTables(_SurfaceTables):
    """The tables of what decorates while they are written: they go on from those of furniture."""

    def __init__(self, settings: DecorationSettings) -> None:
        self._manners = _manners_of(settings.catalogs)
        super().__init__(self._manners._words)
        self._rows["surface"] += self._manners._rows["surface"]
        self._settings, self._catalogs = settings, settings.catalogs
        self._kinds = {name: k for k, name in enumerate(self._catalogs.decorations)}
        leaning = settings.style.decorations if settings.style else Leaning()
        self._favoured, self._avoided = self._meant(leaning.favoured), self._meant(leaning.avoided)

    def _meant(self, names: Container[str]) -> frozenset[str]:
        """Returns the kinds of decorations that some words name, by themselves or by their group."""
        return frozenset(name for name, kind in self._catalogs.decorations.items() if name in names or kind.group in names)

    def compiled(self, made_from: tuple[object, ...]) -> CompiledDecorating:
        """Returns all tables."""
        known = self._catalogs
        for entry in known.decorating.values():
            self._add_entry(entry)
        colours = tuple(self._colours(name, kind) for name, kind in known.decorations.items())
        for (name, kind), palette in zip(known.decorations.items(), colours, strict=True):
            self._add_kind(name, kind, len(palette))
        self._added("turn", map(math.radians, range(180)), lambda angle: (abs(math.cos(angle)), abs(math.sin(angle))))
        styled = [bool(self._palette(name)) for name in known.decorations]
        return CompiledDecorating(self._data(), looks_by_kind(known), colours, styled, self._words, self._manners, made_from)

    def _add_entry(self, entry: Decorating) -> None:
        lies, hangs = self._added("lies", entry.lies, self._lies), self._added("hangs", entry.hangs, self._hangs)
        stands, holds = self._added("stands", entry.stands, self._stands), self._added("lies", entry.holds, self._holds)
        numbers = *lies, *hangs, *stands, *holds, entry.together, entry.indoor
        self._added("entry", [numbers], lambda row: row)

    def _add_kind(self, name: str, kind: DecorationKind, colours: int) -> None:
        numbers = *self.surfaces(kind.surfaces), self._word(name), colours, kind.jitter, kind.mixed
        self._added("kind", [numbers], lambda row: (*millimetres(kind.size), *row))

    def _data(self) -> bytes:
        indoor = [*self._catalogs.decorating].index(INDOOR) if INDOOR in self._catalogs.decorating else -1
        return self._packed(indoor, self._word(SEAT))

    def _names(self, names: Iterable[str], itself: str | None = None) -> TableRange:
        """Adds words; one of them may stand for something else."""
        return self._added("word", names, lambda name: (_ITSELF if name == itself else self._word(name),))

    def _colours(self, name: str, kind: DecorationKind) -> tuple[str, ...]:
        return self._palette(name) or (kind.color, *kind.variants)

    def _palette(self, name: str) -> tuple[str, ...]:
        """Returns the style's own colours of a kind."""
        return self._settings.style.colours(name, self._catalogs.decorations[name].group) if self._settings.style else ()

    def _row(self, row: DecoratingRow, upright: bool = False, most: int = 0) -> tuple[float, ...]:
        names = [name for name in row.put if name not in self._avoided]
        fond = any(name in self._favoured for name in names)
        sized = [(name, self._added("size", sizes(self._catalogs.decorations[name], row, upright), lambda size: size)) for name in names]
        choices = self._added("choice", sized, lambda one: (self._kinds[one[0]], 0, *one[1]))
        in_style = not row.styles or self._settings.style_name in row.styles
        in_style = in_style and row.styled in (None, bool(self._settings.style_name))
        places = *self._names(row.rooms), *self._names(row.not_in)
        return row.chance * (FAVOURED if fond else 1.0), *choices, *places, row.chance >= 1, in_style, row.accent, most

    def _holds(self, row: Holds) -> tuple[float, ...]:
        return self._lies(row, row.most)

    def _lies(self, row: Lies, most: int = 0) -> tuple[float, ...]:
        at = self._added("place", () if row.at == "seats" else row.at, lambda place: place)
        words = *self._names(row.surface, ALL), *self._names(row.on or (SURFACE,), SURFACE)
        flags = row.at == "seats", row.turn, row.upright, row.fill is not None
        reach = _NO_LIMIT if row.reach is None else to_mm(row.reach)
        return *self._row(row, row.upright, most), *at, *words, *flags, *(row.fill or (0.0, 0.0)), reach

    def _hangs(self, row: Hangs) -> tuple[float, ...]:
        return *self._row(row), *self._added("share", row.at, lambda share: (share,)), to_mm(row.height), to_mm(row.gap)

    def _stands(self, row: Stands) -> tuple[float, ...]:
        asked = *self._names(row.of), _WHERE.index(row.where), row.fill is not None
        shares = row.per_area or 0.0, row.min_side, row.fill or 0.0, row.bare
        return *self._row(row), *asked, *shares, row.count, to_mm(row.widest or 0.0), to_mm(row.longest or 0.0), to_mm(row.reach)


def sizes(kind: DecorationKind, row: DecoratingRow, upright: bool = False) -> list[SizeMm]:
    """Returns the extents a thing may have, mm, largest first; made smaller, whole centimetres."""
    width, depth, height = millimetres(kind.size)
    steps = max(0, round((1 - row.min_scale) / SCALE_STEP + 1e-9))
    shares = [max(1 - step * SCALE_STEP, row.min_scale) for step in range(1, steps + 1)]
    bases = [(width, depth), *((_centimetres(width * share), _centimetres(depth * share)) for share in shares)]
    return [(across, height, along) if upright else (across, along, height) for across, along in bases]


def _centimetres(length: float) -> int:
    """Rounds a length in mm down to whole centimetres, at least one."""
    return max(10, int(length) // 10 * 10)


PAIR_WORK: Final = 0.4
"""What two pieces of a room cost, at worst: things keep clear of every piece [see demanded.py]. Measured."""


class BareRoom(NamedTuple):
    """A room to be decorated: furnished at right angles; what decorated it before goes.

    `space` is its clear rectangle, and what its doors and windows keep free; `stream` is the room's own.
    """

    room: Room
    space: Space
    stream: Stream


def decorated_rooms(bare: Iterable[BareRoom], settings: DecorationSettings) -> list[Room]:
    """Returns furnished rooms with what decorates them, naming its kinds; their furniture stays as it is.

    Raises:
        TooMuch: the call may not have so much work.
        CoreFailed: an error within the core.
    """
    known, wanted = compiled_decorating(settings), list(bare)
    demand(PAIR_WORK * sum(count_furniture(one.room) ** 2 for one in wanted))
    rows = [decorated_rows(room, space, known, settings, stream.state) for room, space, stream in wanted]
    with borrowed() as core:
        sent = core.send(rows)
        core.call("decorate", core.write(known.data), len(known.data), sent, len(rows))
        answers = [answer for _, answer in core.told(sent, len(rows))]
    for one, answer in zip(wanted, answers, strict=True):
        one.stream.state = int(_ANSWER.unpack_from(answer)[0])
    return [told(one.room, rows_told(answer, one.room, known)) for one, answer in zip(wanted, answers, strict=True)]


OPENING_MM: Final = 80
"""What hangs keeps this far from windows and doors, for their frames. Our choice."""
_ROOM: Final = Struct("<Q4q2d4q10i")
_OPENING: Final = Struct("<2i4q")
_ANSWER: Final = Struct("<Qq")


def decorated_rows(room: Room, space: Space, known: CompiledDecorating, settings: DecorationSettings, state: int) -> bytes:
    """Returns a room that is furnished at right angles as bytes; `state` is its stream's."""
    manners: dict[BodyTurn, int] = {}
    numbers = [manners.setdefault(one, len(manners)) for one in furniture_turns(room)]
    openings = [_opening(opening) for opening in room.openings if opening.wall is not None]
    kept = settings.kept.get(room.id, ())
    counts = len(numbers), len(openings), len(space.zones), len(space.rows[1]) // DOORWAY.size, len(kept), len(manners)
    flags = known.words.get(room.type, -1), room.outdoor, not room.outline, bool(room.accent)
    lines = to_mm(room.width), to_mm(room.depth)
    rows = [_ROOM.pack(state, *space.clear, room.width, room.depth, *lines, to_mm(settings.height), space.robot_mm, *flags, *counts)]
    rows += [furniture_as_told(room), pack(f"<{len(numbers)}q", *numbers), *map(known.manners.rows.__getitem__, manners)]
    return b"".join([*rows, *openings, *space.rows, *(RECT.pack(*rect) for rect in kept)])


def _opening(opening: Opening) -> bytes:
    """Returns where nothing hangs at an opening."""
    half, top = opening.width / 2, opening.sill + opening.height
    along = to_mm(opening.position - half) - OPENING_MM, to_mm(opening.position + half) + OPENING_MM
    return _OPENING.pack(WALL_NUMBERS[opening.wall or ""], 0, *along, to_mm(opening.sill) - OPENING_MM, to_mm(top) + OPENING_MM)


def rows_told(answer: bytes, room: Room, known: CompiledDecorating) -> DecorationRows:
    """Returns the things of an answer."""
    content = answer[_ANSWER.size :]
    return DecorationRows(content, room, looks_in(content, known.looks), known.colours, known.styled)
