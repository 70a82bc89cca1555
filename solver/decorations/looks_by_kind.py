"""How decorations look, by the number of their kind and their size.

Not here: colours (compiled_decorating).
"""

from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from catalogs.kind_book import UPRIGHT, KindBook
from solver.body_rows import Look, LooksBySize
from solver.records import MadeOnce

_MOST_LOOKS: Final = 20_000


@lru_cache(maxsize=4)
def looks_by_kind(catalogs: Catalogs) -> LooksBySize:
    """Returns how the things of some catalogs look, by the number of their kind and their size, mm."""
    kinds, book = tuple(catalogs.decorations), KindBook(catalogs)
    tipped = frozenset(name for name in kinds if name + UPRIGHT in catalogs.shapes)

    def look(key: tuple[int, int, int, int]) -> Look:
        number, width, depth, height = key
        name, size = kinds[number], (width / 1000, depth / 1000, height / 1000)
        return Look("decoration", name, book.kind_of("decoration", name, size) if name in tipped else name, size)

    return MadeOnce(look, _MOST_LOOKS)
