"""What the catalogs say of a name in a scene.

Comes in: the catalogs. Goes out: use sides and requirements. May import: catalogs.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from catalogs import Catalogs
from catalogs.dressing import DecorationKind
from catalogs.schema import Furniture, RoomType, Use

Size = tuple[float, float, float]
Level = tuple[float, float]
"""A surface: its height above the body's underside, and how far in from the edges it starts, m."""


class Kinds:
    """Looks up names of furniture and room types; those the catalogs do not know ask for nothing."""

    def __init__(self, catalogs: Catalogs) -> None:
        self.rooms: Mapping[str, RoomType] = catalogs.rooms
        self._catalogs = catalogs
        self._named: dict[str, Furniture] = {}
        for kind, entry in catalogs.furniture.items():
            self._named.setdefault(entry.name or kind, entry)
        self._named |= {kind: entry for kind, entry in catalogs.furniture.items() if entry.name in (None, kind)}

    @cached_property
    def _carriers(self) -> list[tuple[str, Size, tuple[Level, ...]]]:
        """Names, sizes and surfaces of all that carries something."""
        found: list[tuple[str, Furniture | DecorationKind]] = [
            (entry.name or kind, entry) for kind, entry in self._catalogs.furniture.items()
        ]
        found += self._catalogs.decorations.items()
        return [(name, entry.size, tuple((surface.height, surface.inset) for surface in entry.surfaces)) for name, entry in found]

    @cached_property
    def _surfaces(self) -> dict[tuple[str, Size], tuple[Level, ...]]:
        return {(name, size): levels for name, size, levels in reversed(self._carriers)}

    @cached_property
    def _heights(self) -> dict[str, tuple[Level, ...]]:
        found: dict[str, tuple[Level, ...]] = {}
        for name, _, levels in self._carriers:
            found[name] = (*found.get(name, ()), *((height, 0.0) for height, _ in levels))
        return found

    def use(self, name: str) -> Use | None:
        """Returns which sides of a piece are used; None where none is, or the piece is unknown."""
        entry = self._named.get(name)
        return entry.use if entry else None

    def surfaces(self, name: str, size: Size) -> tuple[Level, ...]:
        """Returns what a piece or decoration carries things on: heights above its underside, and how far in from its edges, m.

        Where its size is not that of a kind of its name: its top, and every height known for the name, on all of it.
        """
        levels = self._surfaces.get((name, size))
        top = ((size[2], 0.0),)
        return levels or top if levels is not None else (*top, *self._heights.get(name, ()))

    def requires(self, room_type: str) -> tuple[dict[str, int], ...]:
        """Returns what a room type requires: each line is met by any of its names in that number."""
        entry = self.rooms.get(room_type)
        return entry.requires if entry else ()

    def pieces_for(self, room_type: str, names: Mapping[str, int]) -> frozenset[str]:
        """Returns under which labels of the room type a requirement may have been left out."""
        found = set(names)
        entry = self.rooms.get(room_type)
        for piece in entry.pieces if entry else ():
            variants = {variant.kind for variant in piece.variants}
            if variants & names.keys() or piece.piece in names:
                found.add(piece.piece)
        return frozenset(found)
