"""The answer of an import: the scene of a foreign plan, and everything about it that is not as the file says."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Final

from solver.answers import Issue
from solver.fields import Like, Record
from solver.scene import Scene

UNITS: Final = {"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
"""Units of files by name, m."""
ALLOWED_UNITS: Final = f"{', '.join(UNITS)}, or a number of metres"


@dataclass(frozen=True)
class ImportSettings(Record):
    """What the caller says: the level to take (None: the lowest with rooms), the unit, whether furniture comes along."""

    level: int | None = None
    unit: str | None = None
    furniture: bool = True


@dataclass(frozen=True)
class ImportChange(Record):
    """Something that is not as it was drawn: in which step, of what (a room's or opening's id, or `plan`), by how much, m."""

    step: str
    of: str
    amount: float
    message: str


@dataclass(frozen=True)
class ImportGuess(Record):
    """Something that the file does not say: of what (an id, or `plan`), which key, what was taken."""

    of: str
    what: str
    taken: str
    message: str


@dataclass(frozen=True)
class Unread(Record):
    """Something that was left out: its place in the file, and why."""

    place: str
    reason: str


@dataclass(frozen=True)
class PlanImport(Record):
    """A foreign plan as a scene; `format` is what the file was read as.

    `changes`, `guesses` and `unread` say what is not as in the file; `understood_as`, by id, what foreign names were taken for.
    """

    scene: Scene
    format: str
    changes: tuple[Annotated[Mapping[str, object], Like(ImportChange)], ...]
    guesses: tuple[Annotated[Mapping[str, str], Like(ImportGuess)], ...]
    unread: tuple[Annotated[Mapping[str, str], Like(Unread)], ...]
    issues: tuple[Issue, ...]
    understood_as: Mapping[str, str] = field(default_factory=dict)
