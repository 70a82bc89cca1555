"""Which kind a body of a scene is: the one it names, else of those that scenes call like it the one nearest in size.

And what it carries things on: its tops, the boards of its carcass and the bottoms of its drawers; for judging and repairing alike.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from catalogs.decoration_types import DecorationKind
from catalogs.insides import insides_of
from catalogs.schema import Catalogs, FurnitureSpec
from catalogs.shapes import Solid
from catalogs.synonyms import KindSize, synonyms_of

UPRIGHT: Final = "_upright"
"""Ends the key of a thing that is tipped onto its lower edge and looks different so."""
SEATED: Final = "_seated"
"""Ends the name of the shape of somebody who sits."""
_MANY: Final = 4096
"""Names with sizes whose kinds are kept."""


class KindBook:
    """The kinds of catalogs, found by what scenes call them."""

    def __init__(self, catalogs: Catalogs) -> None:
        self._catalogs = catalogs
        furniture = {key: kind.name or key for key, kind in catalogs.furniture.items()}
        self._by_name = {
            "furniture": self._index(catalogs.furniture, furniture),
            "decoration": self._index(catalogs.decorations, {key: key for key in catalogs.decorations}),
        }
        self._nearest = lru_cache(maxsize=_MANY)(self._nearest_of)

    def _index(
        self, kinds: Mapping[str, FurnitureSpec] | Mapping[str, DecorationKind], names: Mapping[str, str]
    ) -> dict[str, dict[str, KindSize]]:
        index: dict[str, dict[str, KindSize]] = {}
        for key, kind in kinds.items():
            width, depth, height = kind.size
            sized = index.setdefault(names[key], {})
            sized[key] = kind.size
            if key + UPRIGHT in self._catalogs.shapes:
                sized[key + UPRIGHT] = width, height, depth
        return index

    def kind_of(self, sort: str, name: str, size: KindSize, said: str | None = None) -> str | None:
        """Returns the key of a body's kind, with `_upright` behind it where the thing is tipped; None where the catalogs know none.

        The kind that the scene names (`said`) counts where scenes call that kind by this name. `size` is width, depth and height, m.
        """
        sized = self._by_name[sort].get(name)
        if not sized:
            return self._understood(sort, name, size, said)
        return said if said in sized else self._nearest(sort, name, size)

    def _nearest_of(self, sort: str, name: str, size: KindSize) -> str:
        """Returns which of the kinds of a name is nearest in size; a home asks it of the same things again and again."""
        sized = self._by_name[sort][name]
        return min(sized, key=lambda key: _difference(sized[key], size))

    def _understood(self, sort: str, name: str, size: KindSize, said: str | None) -> str | None:
        """Returns the key of what others call so."""
        synonyms = synonyms_of(self._catalogs)
        meaning = synonyms.said(said) or synonyms.meaning(name, size)
        return meaning.key if meaning and meaning.sort == sort else None

    def spec(self, sort: str, key: str) -> FurnitureSpec | DecorationKind:
        """Returns what the catalogs say of a kind, by a key that `kind_of` returned."""
        if sort == "furniture":
            return self._catalogs.furniture[key]
        return self._catalogs.decorations[key if key in self._catalogs.decorations else key.removesuffix(UPRIGHT)]

    def dweller(self, kind: str) -> FurnitureSpec | None:
        """Returns what the catalogs say of a kind of person or pet; None where they do not know it."""
        return self._catalogs.furniture.get(kind)

    def solids(self, key: str | None) -> tuple[Solid, ...]:
        """Returns the shape of a kind; nothing where there is none."""
        return self._catalogs.shapes.get(key or "", ())

    def living(self, kind: str, seated: bool) -> str | None:
        """Returns the key of the shape of a person or a pet; None where there is none."""
        key = kind + SEATED if seated else kind
        return key if key in self._catalogs.shapes else None


def _difference(one: KindSize, other: KindSize) -> float:
    """Returns how much two sizes differ: the sum over width, depth and height, m."""
    return sum(abs(a - b) for a, b in zip(one, other, strict=True))


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
        """Returns the tops; where the size is not that of a kind of that name all of its top, and every height known for the name.

        That counts as the kind has it, and as much higher as the piece is than the kind.
        """
        known, top = self._tops.get(name, {}), CarryingSurface(size[2])
        if size in known:
            return known[size] or [top]
        heights = ((one.height, one.height * size[2] / own[2]) for own, found in known.items() for one in found)
        return [top, *(CarryingSurface(height, is_top=False) for both in heights for height in both)]

    def _insides_of(self, kind: str | None, sort: str, size: KindSize) -> list[CarryingSurface]:
        """Returns the boards and drawers inside a piece, as its kind's shape has them at that size."""
        if sort != "furniture" or kind not in self._furniture:
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
