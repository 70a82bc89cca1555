"""What a body carries things on: its tops, the boards of its carcass and the bottoms of its drawers; for judging and repairing alike."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from catalogs.decoration_types import DecorationKind
from catalogs.insides import insides_of
from catalogs.kind_book import KindBook
from catalogs.schema import Catalogs, FurnitureSpec
from catalogs.synonyms import KindSize


class CarryingSurface(NamedTuple):
    """A rectangle that carries things.

    `height` is above the body's underside; `left`, `right`, `back` and `front` are how far in it begins from the body's edges,
    `clearance` the free height over it (None: open), all m. `is_top` tells it from what is inside, and from heights that the
    body's name alone tells of.
    """

    height: float
    left: float = 0.0
    right: float = 0.0
    back: float = 0.0
    front: float = 0.0
    clearance: float | None = None
    is_top: bool = True


class Carrying:
    """What bodies carry things on; `book` has the catalogs' kinds by what scenes call them."""

    def __init__(self, catalogs: Catalogs, book: KindBook) -> None:
        self._furniture, self._book = catalogs.furniture, book
        self._tops: dict[str, dict[KindSize, Sequence[CarryingSurface]]] = {}
        furniture: list[tuple[str, FurnitureSpec | DecorationKind]] = [(k.name or kind, k) for kind, k in catalogs.furniture.items()]
        for name, kind in (*furniture, *catalogs.decorations.items()):
            tops = [CarryingSurface(one.height, *(one.inset,) * 4, one.clearance) for one in kind.surfaces]
            self._tops.setdefault(name, {}).setdefault(kind.size, tops)

    def surfaces_of(self, sort: str, name: str, size: KindSize, said: str | None) -> list[CarryingSurface]:
        """Returns what a piece or decoration carries things on: its tops, then what is inside.

        `size` is its width, depth and height, m, `said` the kind that the scene names.
        """
        return [*self._tops_of(name, size), *self._insides_of(self._book.kind_of(sort, name, size, said), sort, size)]

    def _tops_of(self, name: str, size: KindSize) -> Sequence[CarryingSurface]:
        """Returns the tops; where the size is not that of a kind of that name all of its top, and every height known for the name."""
        known, top = self._tops.get(name, {}), CarryingSurface(size[2])
        if size in known:
            return known[size] or [top]
        return [top, *(CarryingSurface(one.height, is_top=False) for found in known.values() for one in found)]

    def _insides_of(self, kind: str | None, sort: str, size: KindSize) -> list[CarryingSurface]:
        """Returns the boards and drawers inside a piece that is as large as its kind."""
        spec = self._furniture.get(kind or "") if sort == "furniture" else None
        if spec is None or size != spec.size:
            return []
        x, z = size[0] / 2, size[1] / 2
        return [
            CarryingSurface(one.height, x + one.x[0], x - one.x[1], z + one.z[0], z - one.z[1], one.clearance, is_top=False)
            for one in insides_of(self._book.solids(kind), size)
        ]


@lru_cache(maxsize=4)
def carrying_in(catalogs: Catalogs) -> Carrying:
    """Returns what bodies of the kinds of catalogs carry things on."""
    return Carrying(catalogs, KindBook(catalogs))
