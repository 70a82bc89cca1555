"""Names that a format can hold, each given once."""

import re


class SafeNames:
    """Gives names within one file: none twice, and `_` for each match of the pattern that is forbidden, if there is one."""

    def __init__(self, forbidden: str | None = None) -> None:
        self._forbidden = re.compile(forbidden) if forbidden else None
        self._given: set[str] = set()

    def take(self, wished: str) -> str:
        """Returns a wished name, made safe; with `_2`, `_3` ... behind it where it was given before."""
        name = safe = (self._forbidden.sub("_", wished) if self._forbidden else wished) or "_"
        number = 1
        while name in self._given:
            number += 1
            name = f"{safe}_{number}"
        self._given.add(name)
        return name
