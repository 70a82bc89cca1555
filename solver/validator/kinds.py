"""What the catalogs say of a name in a scene; those they do not know ask for nothing.

Comes in: the catalogs. Goes out: use sides, surfaces, room types, what bodies are made of. May import: catalogs.
"""

from __future__ import annotations

from collections.abc import Sequence

from catalogs import Catalogs
from catalogs.dressing import DecorationKind
from catalogs.kind_book import KindBook
from catalogs.schema import FurnitureSpec, Use

UnitBox = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]
"""The box around a part, shares of its body's box: low and high end along x, y and z."""


class Kinds:
    """Looks up names of furniture, decorations and room types."""

    def __init__(self, catalogs: Catalogs) -> None:
        self.rooms = catalogs.rooms
        self._book = KindBook(catalogs)
        self._boxes: dict[str | None, Sequence[UnitBox]] = {}
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

    def made_of(self, sort: str, name: str, size: tuple[float, float, float], said: str | None) -> Sequence[UnitBox]:
        """Returns the boxes around the parts of furniture or a decoration; nothing where its kind has no shape.

        Args:
            sort: "furniture" or "decoration".
            name: what the scene calls it.
            size: its width, depth and height, m.
            said: the kind that the scene names.
        """
        return self._boxes_of(self._book.kind_of(sort, name, size, said))

    def living(self, kind: str, seated: bool) -> Sequence[UnitBox]:
        """Returns the boxes around the parts of a person or a pet; nothing where there is no shape."""
        return self._boxes_of(self._book.living(kind, seated))

    def _boxes_of(self, key: str | None) -> Sequence[UnitBox]:
        if key not in self._boxes:
            self._boxes[key] = tuple((solid.x, solid.y, solid.z) for solid in self._book.solids(key))
        return self._boxes[key]
