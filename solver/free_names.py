"""Names that nothing has yet: as they are wished, else with the next free number behind them."""

import re
from collections.abc import Callable


class FreeNames:
    """Gives names within one file or scene: none twice, `_` for each match of a pattern that is forbidden, cut where they are long."""

    def __init__(self, forbidden: str | None = None, cut: Callable[[str], str] = str) -> None:
        self._cut = cut
        self._forbidden = re.compile(forbidden) if forbidden else None
        self.given: set[str] = set()
        self._last: dict[str, int] = {}

    def take(self, wished: str) -> str:
        """Returns a wished name, made safe; with `_2`, `_3` ... behind it where it was given before."""
        short = self._cut(wished)
        safe = (self._forbidden.sub("_", short) if self._forbidden else short) or "_"
        if safe in self.given:
            return self._numbered(safe, 2)
        self.given.add(safe)
        return safe

    def count(self, stem: str) -> str:
        """Returns a name with the next free number from 1 behind its stem."""
        return self._numbered(stem, 1)

    def _numbered(self, stem: str, first: int) -> str:
        number = self._last.get(stem, first - 1) + 1
        while (name := f"{stem.rstrip('_')}_{number}") in self.given:
            number += 1
        self._last[stem] = number
        self.given.add(name)
        return name
