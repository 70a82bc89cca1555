"""How decorations look, by the number of their kind and their size.

Not here: colours (compiled_decorating).
"""

from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from catalogs.kind_book import UPRIGHT, KindBook
from solver.body_rows import Look

_MOST_LOOKS: Final = 20_000


class LooksByKind(dict[tuple[int, int, int, int], Look]):
    """How things look, by the number of their kind and their size, mm."""

    def __init__(self, catalogs: Catalogs) -> None:
        super().__init__()
        self._kinds, self._book = tuple(catalogs.decorations), KindBook(catalogs)
        self._tipped = frozenset(name for name in catalogs.decorations if name + UPRIGHT in catalogs.shapes)

    def __missing__(self, key: tuple[int, int, int, int]) -> Look:
        number, width, depth, height = key
        name, size = self._kinds[number], (width / 1000, depth / 1000, height / 1000)
        kind = self._book.kind_of("decoration", name, size) if name in self._tipped else name
        if len(self) >= _MOST_LOOKS:
            self.clear()
        look = self[key] = Look("decoration", name, kind, size)
        return look


@lru_cache(maxsize=4)
def looks_by_kind(catalogs: Catalogs) -> LooksByKind:
    """Returns how the things of some catalogs look."""
    return LooksByKind(catalogs)
