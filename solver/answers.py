"""The words and keys of what /fix is asked, offers and tells: repairs of a conflict, what was taken out, what ended the search.

Comes in: nothing. Goes out: types that declare documents. May import: fields.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from solver.fields import Record

ON_CONFLICT: Final = ("report", "remove")
"""What becomes of what cannot stand in a repaired scene."""


@dataclass(frozen=True)
class Freed(Record):
    """A repair: `wall` becomes null, for the body need not stand at one; /fix then moves it by dx, dz, m, to that rotation."""

    action: Literal["move"]
    id: str
    wall: None
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Unlocked(Record):
    """A repair: the body is unlocked; /fix then moves it by dx, dz, m, to that rotation."""

    action: Literal["unlock"]
    id: str
    dx: float
    dz: float
    rotation: float


@dataclass(frozen=True)
class Turned(Record):
    """A repair: another rotation, degrees."""

    action: Literal["turn"]
    id: str
    rotation: float


@dataclass(frozen=True)
class Shrunk(Record):
    """A repair: another size, m."""

    action: Literal["shrink"]
    id: str
    width: float
    depth: float


@dataclass(frozen=True)
class LeftOut(Record):
    """A repair: the scene without the body."""

    action: Literal["leave_out"]
    id: str


@dataclass(frozen=True)
class Removal(Record):
    """A body that was taken out, and why."""

    id: str
    reason: str


@dataclass(frozen=True)
class Limited(Record):
    """The limit of the call's work ended a search: what stands is sound, but more may be found with more work.

    `work` is the limit that its `effort` has: a count, the same on every machine.
    """

    effort: str
    work: int
    message: str


OfferedRepair = Freed | Unlocked | Turned | Shrunk | LeftOut
"""A change of the scene with which the rest can stand; README.md says what to do with each."""
