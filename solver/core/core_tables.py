"""Tables as the core reads them: rows of numbers, one table after the other; names are indices."""

from collections.abc import Callable, Iterable, Mapping
from struct import Struct
from typing import ClassVar, TypeVar

Item = TypeVar("Item")
TableRange = tuple[int, int]
"""Rows of a table of the core: the first, and how many."""


class CoreTables:
    """Tables while they are written; `words` are names that are numbered before others."""

    layouts: ClassVar[Mapping[str, Struct]]
    """How a row of each is packed, in the order of the tables."""
    header: ClassVar[Struct]
    """How many rows each has, and what else is said first."""

    def __init__(self, words: Iterable[str] = ()) -> None:
        self._rows: dict[str, list[bytes]] = {name: [] for name in self.layouts}
        self._words = {name: number for number, name in enumerate(words)}

    def _packed(self, *more: int) -> bytes:
        """Returns the header, which `more` ends, and the tables, each from a multiple of 8 on."""
        tables = [b"".join(rows) for rows in self._rows.values()]
        header = self.header.pack(*map(len, self._rows.values()), *more)
        return b"".join([header, *(table + bytes(-len(table) % 8) for table in tables)])

    def _added(self, table: str, items: Iterable[Item], row: Callable[[Item], Iterable[float]]) -> TableRange:
        """Adds rows to a table; returns the first and how many."""
        rows, pack = self._rows[table], self.layouts[table].pack
        made = [pack(*row(item)) for item in items]
        rows += made
        return len(rows) - len(made), len(made)

    def _word(self, name: str) -> int:
        return self._words.setdefault(name, len(self._words))
