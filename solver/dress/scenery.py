"""What is in a room while it is being dressed: solids, carriers, the things so far.

Comes in: a Room. Goes out: rectangles in integer millimetres. May import: the ground floor, catalogs.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.dressing import DecorationKind, Row
from catalogs.entries import Surface
from catalogs.schema import Furniture as Kind
from catalogs.schema import Use
from catalogs.styles import Leaning, Style
from solver.free_places import footprint
from solver.geometry import Rect, half_m, to_m, to_mm, turned
from solver.scene import Decoration, Furniture, Room
from solver.streams import Stream
from solver.wanted import Space

BODY_MM: Final = 20
"""A floor decoration higher than this is a body (contract, Rules)."""
JITTER: Final = 15
"""How far askew a thing may lie, degrees (predecessor, 7.2)."""
SCALE_STEP: Final = 0.1
"""By which share things are made smaller where they do not fit. Our choice."""
FAVOURED: Final = 1.5
"""How much more often a style has what it is fond of. Our choice."""

Size = tuple[int, int, int]
"""Width, depth and height, mm."""


class Solid(NamedTuple):
    """What takes up space: a rectangle from `low` to `high`, mm, and whose it is."""

    id: str
    rect: Rect
    low: int
    high: int


@dataclass(frozen=True)
class Carrier:
    """What may carry things: where it is, how it is turned, its surfaces, and all that it stands in or on."""

    id: str
    name: str
    rect: Rect
    low: int
    high: int
    rotation: int
    surfaces: tuple[Surface, ...]
    root: str
    wall: str | None = None
    within: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Terms:
    """On what terms every room of a house is dressed: with what, in which style, m from floor to ceiling."""

    catalogs: Catalogs
    style: Style | None = None
    style_name: str = ""
    height: float = 2.8
    kinds: Mapping[tuple[str, Size], tuple[Surface, ...]] = field(init=False)
    uses: Mapping[str, Use] = field(init=False)
    faced: frozenset[str] = field(init=False)
    favoured: frozenset[str] = field(init=False)
    avoided: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        kinds: dict[tuple[str, Size], tuple[Surface, ...]] = {}
        for kind, entry in self.catalogs.furniture.items():
            kinds.setdefault((entry.name or kind, millimetres(entry.size)), entry.surfaces)
        named = self.catalogs.kinds_by_name()
        leaning = self.style.decorations if self.style else Leaning()
        object.__setattr__(self, "favoured", self._meant(leaning.favoured))
        object.__setattr__(self, "avoided", self._meant(leaning.avoided))
        object.__setattr__(self, "kinds", kinds)
        object.__setattr__(self, "uses", {name: entry.use for name, entry in named.items() if entry.use})
        object.__setattr__(self, "faced", frozenset(name for name, entry in named.items() if _is_faced(entry)))

    def _meant(self, words: Container[str]) -> frozenset[str]:
        """Returns the kinds of decorations that some words name, by themselves or by their group."""
        return frozenset(name for name, kind in self.catalogs.decorations.items() if name in words or kind.group in words)


def _is_faced(entry: Kind) -> bool:
    """Tells whether one comes to a kind of furniture from its front alone: to use it, or because its back is at a wall."""
    return entry.stands == "wall" if entry.use is None else entry.use.sides == ("front",)


def millimetres(size: tuple[float, float, float]) -> Size:
    """Converts extents in metres."""
    return to_mm(size[0]), to_mm(size[1]), to_mm(size[2])


def extents(width: int, depth: int, rotation: float) -> tuple[int, int]:
    """Returns the extents of a rotated footprint's bounding rectangle, mm, rounded up."""
    if rotation % 90 == 0:
        return turned(width, depth, round(rotation))
    angle = math.radians(rotation % 180)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    return math.ceil(width * c + depth * s - 1e-6), math.ceil(width * s + depth * c - 1e-6)


class Scenery:
    """A room while it is being dressed."""

    def __init__(self, room: Room, space: Space, terms: Terms, stream: Stream) -> None:
        self.room, self.space, self.terms, self.stream = room, space, terms, stream
        self.ceiling = to_mm(terms.height)
        self.things: list[Decoration] = []
        self.solids: list[Solid] = []
        self.carried: dict[str, list[Carrier]] = {}
        self.made: list[Carrier] = []
        self._counts = dict(Counter(piece.name for piece in room.furniture))
        self._colours: dict[str, str] = {}
        self.pieces = tuple(self._piece(piece) for piece in room.furniture)
        self.solids += [Solid(piece.id, piece.rect, piece.low, piece.high) for piece in self.pieces]
        self.tucked = {table: frozenset(p.id for p in room.furniture if p.under == table) for table in {p.under for p in room.furniture}}

    def _piece(self, piece: Furniture) -> Carrier:
        low, size = to_mm(piece.y), millimetres((piece.width, piece.depth, piece.height))
        surfaces = self.terms.kinds.get((piece.name, size), ())
        rotation = round(piece.rotation) % 360 if piece.rotation % 90 == 0 else 0
        return Carrier(
            piece.id, piece.name, footprint(piece), low, low + size[2], rotation, surfaces, piece.id, piece.wall, frozenset({piece.id})
        )

    def wanted(self, row: Row) -> tuple[str, ...]:
        """Draws which kinds of a row there are to be: none where its chance, its style or its room says no."""
        names = tuple(name for name in row.put if name not in self.terms.avoided)
        fond = any(name in self.terms.favoured for name in names)
        drawn = row.chance >= 1 or self.stream.chance(row.chance * (FAVOURED if fond else 1.0))
        in_style = not row.styles or self.terms.style_name in row.styles
        in_room = self.room.type not in row.not_in and (not row.rooms or self.room.type in row.rooms)
        return names if drawn and in_style and in_room else ()

    def jitter(self, kind: DecorationKind) -> int:
        """Draws how far askew a thing lies, degrees."""
        return self.stream.below(2 * JITTER + 1) - JITTER if kind.jitter else 0

    def colour(self, name: str, row: Row, parent: str) -> str:
        """Draws a thing's colour: one for all of its kind on one parent, unless the kind is mixed."""
        kind = self.terms.catalogs.decorations[name]
        if row.accent and self.room.accent:
            return self.room.accent
        key = f"{parent}/{name}"
        if kind.mixed or key not in self._colours:
            palette = self.terms.style.colours(name, kind.group) if self.terms.style else ()
            self._colours[key] = self.stream.pick(palette or (kind.color, *kind.variants))
        return self._colours[key]

    def near(self, rect: Rect, low: int, high: int, ignored: frozenset[str]) -> list[Rect]:
        """Returns the solids that share space with a box, ignored ones left out."""
        return [s.rect for s in self.solids if low < s.high and s.low < high and s.rect.overlaps(rect) and s.id not in ignored]

    def add(self, new: New, row: Row, parent: Carrier | None = None, wall: str | None = None) -> Carrier:
        """Puts a thing into the room; returns it as what may carry others."""
        kind = self.terms.catalogs.decorations[new.name]
        self._counts[new.name] = self._counts.get(new.name, 0) + 1
        label = f"{self.room.id}/{new.name}_{self._counts[new.name]}"
        rect, (width, depth, height) = new.rect, new.size
        self.things.append(
            Decoration(
                label, new.name, parent.id if parent else None, wall, half_m(rect.x0 + rect.x1), to_m(new.low), half_m(rect.z0 + rect.z1),
                new.rotation % 360, to_m(width), to_m(depth), to_m(height), self.colour(new.name, row, parent.id if parent else ""),
            )
        )  # fmt: skip
        if parent or wall or height > BODY_MM:
            self.solids.append(Solid(label, rect, new.low, new.low + height))
        within = (parent.within if parent else frozenset()) | {label}
        root = parent.root if parent else label
        made = Carrier(label, new.name, rect, new.low, new.low + height, new.rotation % 360, kind.surfaces, root, wall, within)
        self.made.append(made)
        if parent:
            self.carried.setdefault(parent.id, []).append(made)
        return made


class New(NamedTuple):
    """A thing with its place: its kind, bounding rectangle, underside, unrotated extents (mm) and rotation."""

    name: str
    rect: Rect
    low: int
    size: Size
    rotation: int


def sizes(kind: DecorationKind, row: Row, upright: bool = False) -> list[Size]:
    """Returns the extents a thing may have, mm, largest first; made smaller, whole centimetres."""
    width, depth, height = millimetres(kind.size)
    steps = max(0, round((1 - row.least) / SCALE_STEP + 1e-9))
    found: list[Size] = []
    for step in range(steps + 1):
        share = max(1 - step * SCALE_STEP, row.least)
        size = (width, depth) if step == 0 else (max(10, int(width * share) // 10 * 10), max(10, int(depth * share) // 10 * 10))
        found.append((size[0], height, size[1]) if upright else (*size, height))
    return found


def nearest(area: Rect, wish: tuple[int, int], extent: tuple[int, int], blocks: Sequence[Rect], reach: int | None) -> Rect | None:
    """Returns the free place nearest to a wish, inside an area and outside of blocks, or None.

    Args:
        area: where it must lie, mm.
        wish: the wished min corner.
        extent: along x and z.
        blocks: what it must not meet.
        reach: how far from the wish it may be, mm; None: anywhere.
    """
    wide, deep = extent
    last_x, last_z = area.x1 - wide, area.z1 - deep
    if last_x < area.x0 or last_z < area.z0:
        return None
    x, z = min(max(wish[0], area.x0), last_x), min(max(wish[1], area.z0), last_z)
    taken = [(b.x0 - wide, b.x1, b.z0 - deep, b.z1) for b in blocks]
    if not any(west < x < east and low < z < high for west, east, low, high in taken):
        return Rect(x, z, x + wide, z + deep)
    best: tuple[int, int] | None = None
    limit = 1 << 60 if reach is None else reach * reach + 1
    for tried in _steps(x, (area.x0, last_x), taken):
        aside = (tried - x) ** 2
        if aside >= limit:
            break
        free = _nearest_free(z, (area.z0, last_z), [(low, high) for west, east, low, high in taken if west < tried < east])
        if free is not None and aside + (free - z) ** 2 < limit:
            best, limit = (tried, free), aside + (free - z) ** 2
    return Rect(best[0], best[1], best[0] + wide, best[1] + deep) if best else None


def _steps(wish: int, bounds: tuple[int, int], taken: Sequence[tuple[int, int, int, int]]) -> Sequence[int]:
    """Returns the coordinates worth trying along x, nearest first."""
    ends = {wish, *bounds, *(block[0] for block in taken), *(block[1] for block in taken)}
    return sorted((v for v in ends if bounds[0] <= v <= bounds[1]), key=lambda v: (abs(v - wish), v))


def _nearest_free(wish: int, bounds: tuple[int, int], taken: Sequence[tuple[int, int]]) -> int | None:
    """Returns the coordinate within bounds nearest to a wish that lies inside none of the open intervals."""
    if not any(low < wish < high for low, high in taken):
        return wish
    up = down = wish
    for low, high in sorted(taken):
        if low < up < high:
            up = high
    for low, high in sorted(taken, key=lambda interval: -interval[1]):
        if low < down < high:
            down = low
    found = [v for v in (down, up) if bounds[0] <= v <= bounds[1]]
    return min(found, key=lambda v: (abs(v - wish), v), default=None)
