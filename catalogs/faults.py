"""A fault of a catalog: what cannot be, and where it is said."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    """Something that cannot be: in which file (its path without `.yaml`), at which key, what, what is allowed."""

    file: str
    at: tuple[str | int, ...]
    problem: str
    allowed: str = ""

    @property
    def entry(self) -> tuple[str, str]:
        """The section it is in and the name of the entry."""
        section, _, name = self.file.partition("/")
        return section, name or str(self.at[0])
