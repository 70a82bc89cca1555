"""What the catalogs say of a name in a scene; those they do not know ask for nothing.

Comes in: the catalogs. Goes out: use sides, surfaces, room types. May import: catalogs.
"""

from __future__ import annotations

from collections.abc import Sequence

from catalogs import Catalogs
from catalogs.dressing import DecorationKind
from catalogs.schema import FurnitureSpec, Use


class Kinds:
    """Looks up names of furniture, decorations and room types."""

    def __init__(self, catalogs: Catalogs) -> None:
        self.rooms = catalogs.rooms
        self._named = catalogs.kinds_by_name()
        furniture: list[tuple[str, FurnitureSpec | DecorationKind]] = [(k.name or kind, k) for kind, k in catalogs.furniture.items()]
        self._surfaces: dict[str, dict[tuple[float, ...], list[tuple[float, float]]]] = {}
        for name, kind in (*furniture, *catalogs.decorations.items()):
            found = [(surface.height, surface.inset) for surface in kind.surfaces]
            self._surfaces.setdefault(name, {}).setdefault(kind.size, found)

    def use(self, name: str) -> Use | None:
        """Returns which sides of a piece are used; None where none is, or the piece is unknown."""
        return self._named[name].use if name in self._named else None

    def surfaces(self, name: str, size: tuple[float, float, float]) -> Sequence[tuple[float, float]]:
        """Returns what a piece or decoration carries things on: heights above its underside, and how far in from its edges, m.

        Where its size is not that of a kind of its name: its top, and every height known for the name, on all of it.
        """
        known, top = self._surfaces.get(name, {}), (size[2], 0.0)
        if size in known:
            return known[size] or [top]
        return [top, *((height, 0.0) for found in known.values() for height, _ in found)]
