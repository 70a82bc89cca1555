"""A room while it is being decorated: what takes up space in it, what may carry things, the things so far.

Comes in: a Room. Goes out: rectangles in integer millimetres. May import: the ground floor, catalogs.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Container, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.dressing import DecorationKind, DressingRow
from catalogs.entries import Surface
from catalogs.styles import Leaning, Style
from solver.free_places import FLAT_MM, Block, footprint
from solver.geometry import Rect, extents, half_m, to_m, to_mm
from solver.pieces import Space
from solver.scene import Decoration, Furniture, Room
from solver.streams import Stream

JITTER: Final = 15
"""How far askew a thing may lie, degrees."""
SCALE_STEP: Final = 0.1
"""By which share things are made smaller where they do not fit. Our choice."""
FAVOURED: Final = 1.5
"""How much more often a style has what it is fond of. Our choice."""

SizeMm = tuple[int, int, int]
"""Width, depth and height, mm."""


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
    within: frozenset[str] = frozenset()


class NewThing(NamedTuple):
    """A thing with its place: its kind, bounding rectangle, underside, unrotated extents (mm) and rotation."""

    name: str
    rect: Rect
    low: int
    size: SizeMm
    rotation: int


@dataclass(frozen=True)
class DecorationSettings:
    """What all rooms of a house are decorated with, in which style, and m from floor to ceiling."""

    catalogs: Catalogs
    style: Style | None = None
    style_name: str = ""
    height: float = 2.8

    @cached_property
    def surfaces(self) -> Mapping[tuple[str, SizeMm], tuple[Surface, ...]]:
        """The surfaces of furniture, by name and size."""
        kinds = reversed(self.catalogs.furniture.items())
        return {(entry.name or kind, millimetres(entry.size)): entry.surfaces for kind, entry in kinds}

    @cached_property
    def faced(self) -> frozenset[str]:
        """Names of what one comes to from its front alone: to use it, or because its back is at a wall."""
        named = self.catalogs.kinds_by_name().items()
        return frozenset(name for name, kind in named if (kind.use.sides == ("front",) if kind.use else kind.stands == "wall"))

    @cached_property
    def favoured(self) -> frozenset[str]:
        """Kinds of decorations that the style is fond of."""
        return self._meant(self._leaning.favoured)

    @cached_property
    def avoided(self) -> frozenset[str]:
        """Kinds of decorations that the style does without."""
        return self._meant(self._leaning.avoided)

    @property
    def _leaning(self) -> Leaning:
        return self.style.decorations if self.style else Leaning()

    def _meant(self, words: Container[str]) -> frozenset[str]:
        """Returns the kinds of decorations that some words name, by themselves or by their group."""
        return frozenset(name for name, kind in self.catalogs.decorations.items() if name in words or kind.group in words)


class DecoratedRoom:
    """A room while it is being decorated."""

    def __init__(self, room: Room, space: Space, settings: DecorationSettings, stream: Stream) -> None:
        self.room, self.space, self.settings, self.stream = room, space, settings, stream
        self.catalogs, self.ceiling = settings.catalogs, to_mm(settings.height)
        self.things: list[Decoration] = []
        self.carried: dict[str, list[Carrier]] = {}
        self.made: list[Carrier] = []
        self._counts = Counter(piece.name for piece in room.furniture)
        self._colours: dict[str, str] = {}
        self.pieces = tuple(self._piece(piece) for piece in room.furniture)
        self.blocks = [Block(piece.rect, piece.low, piece.high, piece.id) for piece in self.pieces]
        self.tucked = {table: frozenset(p.id for p in room.furniture if p.under == table) for table in {p.under for p in room.furniture}}

    def _piece(self, piece: Furniture) -> Carrier:
        low, size = to_mm(piece.y), millimetres((piece.width, piece.depth, piece.height))
        surfaces = self.settings.surfaces.get((piece.name, size), ())
        rotation = round(piece.rotation) % 360 if piece.rotation % 90 == 0 else 0
        return Carrier(piece.id, piece.name, footprint(piece), low, low + size[2], rotation, surfaces, piece.id, frozenset({piece.id}))

    def wanted(self, row: DressingRow) -> tuple[str, ...]:
        """Draws which kinds of a row there are to be, in the order in which they take turns: none where chance, style or room say no."""
        names = tuple(name for name in row.put if name not in self.settings.avoided)
        fond = any(name in self.settings.favoured for name in names)
        drawn = row.chance >= 1 or self.stream.chance(row.chance * (FAVOURED if fond else 1.0))
        in_style = not row.styles or self.settings.style_name in row.styles
        in_room = self.room.type not in row.not_in and (not row.rooms or self.room.type in row.rooms)
        if not (names and drawn and in_style and in_room):
            return ()
        first = self.stream.below(len(names)) if len(names) > 1 else 0
        return names[first:] + names[:first]

    def jitter(self, kind: DecorationKind) -> int:
        """Draws how far askew a thing lies, degrees."""
        return self.stream.below(2 * JITTER + 1) - JITTER if kind.jitter else 0

    def colour(self, name: str, row: DressingRow, parent: str) -> str:
        """Draws a thing's colour: one for all of its kind on one parent, unless the kind is mixed."""
        kind = self.catalogs.decorations[name]
        if row.accent and self.room.accent:
            return self.room.accent
        key = f"{parent}/{name}"
        if kind.mixed or key not in self._colours:
            palette = self.settings.style.colours(name, kind.group) if self.settings.style else ()
            self._colours[key] = self.stream.pick(palette or (kind.color, *kind.variants))
        return self._colours[key]

    def near(self, rect: Rect, low: int, high: int, ignored: frozenset[str]) -> list[Rect]:
        """Returns what shares space with a box, ignored ids left out."""
        return [b.rect for b in self.blocks if b.between(low, high) and b.rect.overlaps(rect) and b.id not in ignored]

    def add(self, new: NewThing, row: DressingRow, parent: Carrier | None = None, wall: str | None = None) -> None:
        """Puts a thing into the room, where it may carry others."""
        self._counts[new.name] += 1
        label = f"{self.room.id}/{new.name}_{self._counts[new.name]}"
        rect, (width, depth, height), rotation = new.rect, new.size, new.rotation % 360
        below = parent.id if parent else None
        self.things.append(
            Decoration(
                label, new.name, below, wall, half_m(rect.x0 + rect.x1), to_m(new.low), half_m(rect.z0 + rect.z1),
                rotation, to_m(width), to_m(depth), to_m(height), self.colour(new.name, row, below or ""),
            )
        )  # fmt: skip
        if parent or wall or height > FLAT_MM:
            self.blocks.append(Block(rect, new.low, new.low + height, label))
        within = (parent.within if parent else frozenset()) | {label}
        surfaces, root = self.catalogs.decorations[new.name].surfaces, parent.root if parent else label
        self.made.append(Carrier(label, new.name, rect, new.low, new.low + height, rotation, surfaces, root, within))
        if parent:
            self.carried.setdefault(parent.id, []).append(self.made[-1])


def millimetres(size: tuple[float, float, float]) -> SizeMm:
    """Converts extents in metres."""
    return to_mm(size[0]), to_mm(size[1]), to_mm(size[2])


def bounds_of(size: SizeMm, rotation: float) -> tuple[int, int]:
    """Returns the extents along x and z of a rotated footprint's bounding rectangle, mm, rounded up."""
    width, depth = extents(size[0], size[1], rotation)
    return math.ceil(width - 1e-6), math.ceil(depth - 1e-6)


def sizes(kind: DecorationKind, row: DressingRow, upright: bool = False) -> list[SizeMm]:
    """Returns the extents a thing may have, mm, largest first; made smaller, whole centimetres."""
    width, depth, height = millimetres(kind.size)
    steps = max(0, round((1 - row.least) / SCALE_STEP + 1e-9))
    shares = [max(1 - step * SCALE_STEP, row.least) for step in range(1, steps + 1)]
    bases = [(width, depth), *((centimetres(width * share), centimetres(depth * share)) for share in shares)]
    return [(across, height, along) if upright else (across, along, height) for across, along in bases]


def centimetres(length: float) -> int:
    """Rounds a length in mm down to whole centimetres, at least one."""
    return max(10, int(length) // 10 * 10)
