"""What was guessed of somebody's own plan: the types of its rooms, its main entrance. Declares documents."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Final

from solver.answers import Issue, Limited
from solver.fields import OMITTED, OneOf, Record, Says
from solver.scene import Scene

GUESSED_BY: Final = ("name", "pieces", "form")
"""What a room's type was told from: what it is called, what stands in it, its floor, doors, windows and neighbours."""
KEEPS: Final = ("all", "locked", "none")
"""What stays in rooms that are furnished."""


@dataclass(frozen=True)
class RoomGuess(Record):
    """The type that a room was given: what it was called, what told the type, and the type that would suit it next, if any."""

    room: str
    type: str
    by: Annotated[str, OneOf(*GUESSED_BY)]
    sent: str
    instead: Annotated[str | None, Says("the room type that suits next best, where the room's form told the type")]
    message: str


@dataclass(frozen=True)
class ChosenEntrance(Record):
    """The door that was chosen as the main entrance of a home that had none, and its room."""

    id: str
    room: str
    message: str


@dataclass(frozen=True)
class FurnishedPlan(Record):
    """The answer of furnish: the scene, what was guessed, which rooms could not be furnished and why, issues, and stage times in ms."""

    scene: Scene
    guesses: tuple[RoomGuess, ...]
    entrance: ChosenEntrance | None
    left: Annotated[Mapping[str, str], Says("by room id, why a room that was asked for was left as it was")]
    issues: tuple[Issue, ...]
    timing_ms: Mapping[str, float]
    limited: Limited | None = field(default=None, metadata={OMITTED: True})
